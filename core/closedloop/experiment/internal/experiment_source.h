#pragma once
// What the readers of experiments share. Their refusals (base/json_reading.h) end in read_experiment.

#include <Eigen/Geometry>
#include <filesystem>
#include <string>
#include <vector>

#include "base/csv.h"
#include "base/json_reading.h"
#include "closedloop/experiment/experiment.h"

namespace glisson::closedloop {

// The document being read, and where its parts stand in it.
struct Source {
  std::filesystem::path file;
  std::string text;

  // The line, from 1, on which `quoted` first stands in quotes; 1 where it does not.
  [[nodiscard]] std::size_t line_of(const std::string& quoted) const;
  // A file that the document names, beside it. Refused where it is not there.
  [[nodiscard]] std::filesystem::path named_file(const std::string& name) const;
};

// The list under "trials": not empty, of objects with ids that differ.
std::vector<std::string> trial_ids(const Json& json);

// One column of a table: no cell without a number. `file` and `key` are named in refusals.
Eigen::VectorXd column_of(const CsvTable& table, const std::string& column, const std::filesystem::path& file,
                          const std::string& key);
// The same for times, which must not go back.
Eigen::VectorXd times_of(const CsvTable& table, const std::string& column, const std::filesystem::path& file);
CsvTable table_of(const std::filesystem::path& file);

// A modulus that no tissue and no phantom has was given in another unit.
void refuse_unlikely_modulus(double young_kPa, const std::string& where);

Palpation palpation_from(const Json& json, const Source& source, Needs needs);
Material material_from(const Json& json, const Source& source, Needs needs);
Hardware hardware_from(const Json& json, const Source& source, Needs needs);
Guidance guidance_from(const Json& json, const Source& source);
FullField full_field_from(const Json& json, const Source& source, Needs needs);
Elastography elastography_from(const Json& json, const Source& source);

// Of a palpation and of guidance alike: the body, what holds it, and a table of markers. The body has a mesh, moduli,
// Poisson's ratio and density. `to_rest` brings the markers' seen positions into the body's frame.
void read_specimen(const Json& json, const Source& source, Palpation& palpation);
std::vector<mechanics::Support> supports_from(const Json& json);
std::vector<Marker> markers_from(const std::filesystem::path& file, const Eigen::Isometry3d& to_rest,
                                 const geometry::TetMesh& mesh);

}  // namespace glisson::closedloop

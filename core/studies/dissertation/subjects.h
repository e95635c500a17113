#pragma once
// Whose stiffness a cohort's studies look at: maps and cases found in a folder.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "elastography/cell_stiffness.h"
#include "imaging/image.h"
#include "imaging/study.h"
#include "mechanics/scenario/scenario.h"

namespace glisson::studies {

// A stiffness map, as a series of its own or in a case.
struct Subject {
  std::string id;                         // serves as a file name; no other subject of the folder has it
  std::filesystem::path path;             // of the map's first file, or of the case
  std::optional<imaging::Series> series;  // absent: a case
};

// The maps in a folder (what imaging::scan takes for one) and the cases in it (NAME.glisson), by name. Fails where the
// folder cannot be read.
Result<std::vector<Subject>> find_subjects(const std::filesystem::path& folder);

// Of the subject's content; "unreadable" where it cannot be read.
[[nodiscard]] std::string fingerprint_of(const Subject& subject);

struct MeasuredLiver {
  imaging::Volume shear_kPa;  // positive where something is known
  imaging::Mask organ;        // on a grid of its own: the case's labels/liver, or else the voxels that hold a value
  std::optional<imaging::Mask> confident;
  std::vector<mechanics::Landmark> landmarks;  // of the structures of a case

  [[nodiscard]] elastography::Reliability reliability() const { return {confident, organ}; }
  [[nodiscard]] std::vector<double> values_kPa() const;  // those inside the organ
};
Result<MeasuredLiver> read_subject(const Subject& subject);

}  // namespace glisson::studies

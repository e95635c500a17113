// Palpations from JSON, the specimen's mesh and the tables of markers.

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <Eigen/Geometry>
#include <string_view>

#include "base/csv.h"
#include "base/files.h"
#include "base/units.h"
#include "closedloop/experiment/internal/experiment_source.h"
#include "geometry/mesh_file.h"
#include "mechanics/elements/point_location.h"
#include "mechanics/scenario/mesh_moduli.h"
#include "mechanics/scenario/scenario_file.h"

namespace glisson::closedloop {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;

PalpationTrial trial_from(const Json& json, const std::string& id, const Source& source, const Palpation& palpation,
                          Needs needs);

}  // namespace

Palpation palpation_from(const Json& json, const Source& source, Needs needs) {
  only_keys(json, {"format", "kind", "title", "specimen", "supports", "gravity_m_s2", "noise_mm", "trials"},
            "The experiment");
  Palpation palpation;
  read_specimen(required(json, "specimen", "The experiment"), source, palpation);
  palpation.supports = supports_from(required(json, "supports", "The experiment"));
  if (json.contains("gravity_m_s2"))
    palpation.gravity_mm_s2 = vector_in(json["gravity_m_s2"], "gravity_m_s2").unaryExpr(&units::mm_s2_from_m_s2);
  palpation.noise_mm = positive_in(required(json, "noise_mm", "The experiment"), "noise_mm");
  const std::vector<std::string> ids = trial_ids(json);
  for (std::size_t t = 0; t < ids.size(); ++t)
    palpation.trials.push_back(trial_from(json["trials"][t], ids[t], source, palpation, needs));
  return palpation;
}

namespace {

double diagonal_mm(const geometry::TetMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& point : mesh.points_mm) box.extend(point);
  return box.diagonal().norm();
}

}  // namespace

void read_specimen(const Json& json, const Source& source, Palpation& palpation) {
  only_keys(json, {"mesh", "youngs_modulus_kPa", "poisson_ratio", "density_kg_m3"}, "The specimen");
  const std::string where = "specimen, youngs_modulus_kPa";
  const fs::path file = source.named_file(text_in(required(json, "mesh", "The specimen"), "specimen, mesh"));
  palpation.mesh = taken(geometry::read_tetrahedra(file));
  if (auto checked = geometry::check_tetrahedra(palpation.mesh); !checked)
    throw Refusal{std::move(checked.error()).in_file(file)};
  if (const double size_mm = diagonal_mm(palpation.mesh); size_mm < 2 || size_mm > 5000)
    refuse("experiment-unit", GLISSON_TEXT("The specimen in {0} is {1} mm across."),
           {file.filename().string(), std::to_string(size_mm)}, GLISSON_TEXT("Is the mesh in metres or micrometres?"),
           file);

  const Json& modulus = required(json, "youngs_modulus_kPa", "The specimen");
  std::string modulus_name;
  if (modulus.is_string()) {
    const auto name = modulus.get<std::string>();
    const geometry::Field* field = geometry::find_field(palpation.mesh.cell_fields, name);
    if (field == nullptr || field->components != 1)
      refuse("experiment-invalid", GLISSON_TEXT("{0} has no cell array \"{1}\" with one number a cell."),
             {file.filename().string(), name}, {}, file);
    palpation.cell_young_kPa = field->values;
    modulus_name = name;
  } else {
    palpation.cell_young_kPa.assign(palpation.mesh.cells.size(), positive_in(modulus, where));
  }
  for (const double young_kPa : palpation.cell_young_kPa) {
    if (!(young_kPa > 0))
      refuse("experiment-invalid", GLISSON_TEXT("Young's modulus must be above zero in every cell."), {}, {}, file);
    refuse_unlikely_modulus(young_kPa, where);
  }
  if (json.contains("poisson_ratio")) palpation.poisson_ratio = number_in(json["poisson_ratio"], "poisson_ratio");
  if (!(palpation.poisson_ratio > -1 && palpation.poisson_ratio < 0.5))
    refuse("experiment-invalid", GLISSON_TEXT("{0} must lie between -1 and 0.5, both excluded."), {"poisson_ratio"});
  const auto made_by = mechanics::poisson_ratio_of(palpation.mesh);
  if (modulus_name == mechanics::youngs_modulus_field && made_by && *made_by != palpation.poisson_ratio)
    refuse("experiment-invalid",
           GLISSON_TEXT("The moduli in {0} were made of shear moduli by a Poisson's ratio of {1}, not {2}."),
           {file.filename().string(), fmt::format("{:g}", *made_by), fmt::format("{:g}", palpation.poisson_ratio)},
           GLISSON_TEXT("Say \"poisson_ratio\": {1} in the specimen."), file);
  if (json.contains("density_kg_m3"))
    palpation.density_kg_mm3 = units::kg_mm3_from_kg_m3(positive_in(json["density_kg_m3"], "specimen, density_kg_m3"));
}

// Supports are written as in a scenario, and read by its reader.
std::vector<mechanics::Support> supports_from(const Json& json) {
  return taken(mechanics::parse_supports(json, "experiment-invalid"));
}

namespace {

// --- markers

struct MarkerTable {
  std::vector<Marker> markers;
  std::vector<std::size_t> lines;
};

constexpr std::array<std::string_view, 7> marker_columns{"id",   "rest_x_mm", "rest_y_mm", "rest_z_mm",
                                                         "x_mm", "y_mm",      "z_mm"};

std::array<std::size_t, 7> places_of_columns(const std::vector<std::string_view>& names, const fs::path& file) {
  std::array<std::size_t, 7> places{};
  for (std::size_t c = 0; c < marker_columns.size(); ++c) {
    const auto found = std::find(names.begin(), names.end(), marker_columns[c]);
    if (found == names.end())
      refuse("experiment-column-missing", GLISSON_TEXT("Line 1 of {0} names no column \"{1}\"."),
             {file.filename().string(), std::string(marker_columns[c])},
             GLISSON_TEXT("A table of markers has id, rest_x_mm, rest_y_mm, rest_z_mm, x_mm, y_mm, z_mm."), file);
    places[c] = static_cast<std::size_t>(found - names.begin());
  }
  return places;
}

MarkerTable read_markers(const fs::path& file) {
  const std::string text = taken(read_text_file(file, std::uint64_t{256} << 20));
  std::vector<CsvRow> rows = csv_rows(text);
  if (rows.empty()) rows.emplace_back();
  const std::array<std::size_t, 7> places = places_of_columns(rows.front().cells, file);
  rows.erase(rows.begin());
  MarkerTable table;
  for (const CsvRow& row : rows) {
    std::array<double, 6> numbers{};
    for (std::size_t c = 0; c < 6; ++c) {
      numbers[c] = row.number(places[c + 1]);
      if (!std::isfinite(numbers[c]))
        refuse("experiment-invalid", GLISSON_TEXT("Line {0} of {1} has no number under \"{2}\"."),
               {std::to_string(row.line), file.filename().string(), std::string(marker_columns[c + 1])},
               GLISSON_TEXT("Is the table cut off, or written with decimal commas?"), file);
    }
    table.markers.push_back({std::string(row.cells[places[0] < row.cells.size() ? places[0] : 0]),
                             {numbers[0], numbers[1], numbers[2]},
                             {numbers[3], numbers[4], numbers[5]}});
    table.lines.push_back(row.line);
  }
  if (table.markers.empty())
    refuse("experiment-invalid", GLISSON_TEXT("{0} holds no markers."), {file.filename().string()}, {}, file);
  return table;
}

// Markers belong to the specimen: at rest they lie in it or on it, and they move less than it is long.
void refuse_misplaced(const MarkerTable& table, const geometry::TetMesh& mesh, const fs::path& file) {
  const double size_mm = diagonal_mm(mesh);
  std::vector<Vector3d> rest_mm;
  Eigen::AlignedBox3d box;
  for (const Marker& marker : table.markers) {
    rest_mm.push_back(marker.rest_mm);
    box.extend(marker.rest_mm);
  }
  if (table.markers.size() > 1 && box.diagonal().norm() < 0.005 * size_mm)
    refuse("experiment-unit",
           GLISSON_TEXT("All markers of {0} lie within {1} mm (line 2 on), on a specimen of {2} mm."),
           {file.filename().string(), std::to_string(box.diagonal().norm()), std::to_string(size_mm)},
           GLISSON_TEXT("Are they in metres?"), file);
  const auto places = mechanics::locate_points(mesh, rest_mm);
  for (std::size_t m = 0; m < places.size(); ++m) {
    if (places[m].outside_by_mm > 0.05 * size_mm)
      refuse("experiment-markers-outside",
             GLISSON_TEXT("Line {0} of {1}: marker {2} lies {3} mm outside the specimen at rest."),
             {std::to_string(table.lines[m]), file.filename().string(), table.markers[m].id,
              std::to_string(places[m].outside_by_mm)},
             GLISSON_TEXT("Are markers and mesh in one frame (patient coordinates) and both in mm?"), file);
    const double moved_mm = (table.markers[m].position_mm - table.markers[m].rest_mm).norm();
    if (moved_mm > size_mm)
      refuse("experiment-unit",
             GLISSON_TEXT("Line {0} of {1}: marker {2} moved by {3} mm, more than the specimen is long."),
             {std::to_string(table.lines[m]), file.filename().string(), table.markers[m].id, std::to_string(moved_mm)},
             GLISSON_TEXT("Are the positions in another unit or frame than the positions at rest?"), file);
  }
}

}  // namespace

std::vector<Marker> markers_from(const fs::path& file, const Eigen::Isometry3d& to_rest,
                                 const geometry::TetMesh& mesh) {
  MarkerTable table = read_markers(file);
  for (Marker& marker : table.markers) marker.position_mm = to_rest * marker.position_mm;
  refuse_misplaced(table, mesh, file);
  return std::move(table.markers);
}

namespace {

// --- trials

PalpationSample sample_from(const Json& json, const std::string& where, const Source& source,
                            const Palpation& palpation) {
  only_keys(json, {"time_s", "force_N", "markers"}, where);
  PalpationSample sample;
  sample.time_s = number_in(required(json, "time_s", where), where + ", time_s");
  const double force_N = number_in(required(json, "force_N", where), where + ", force_N");
  if (std::abs(force_N) > 500)
    refuse("experiment-unit", GLISSON_TEXT("{0}: a force of {1} N presses no soft specimen."),
           {where, std::to_string(force_N)}, GLISSON_TEXT("Was it given in mN?"));
  sample.force_mN = units::mN_from_N(force_N);
  if (json.contains("markers")) {
    const fs::path file = source.named_file(text_in(json["markers"], where + ", markers"));
    sample.markers = markers_from(file, Eigen::Isometry3d::Identity(), palpation.mesh);
  }
  return sample;
}

PalpationTrial trial_from(const Json& json, const std::string& id, const Source& source, const Palpation& palpation,
                          Needs needs) {
  const std::string where = "trial " + id;
  only_keys(json, {"id", "tool", "samples"}, where);
  const Json& tool = required(json, "tool", where);
  only_keys(tool, {"center_mm", "radius_mm", "direction"}, where + ", tool");
  PalpationTrial trial;
  trial.id = id;
  trial.tool.center_mm = vector_in(required(tool, "center_mm", where + ", tool"), where + ", tool, center_mm");
  trial.tool.radius_mm = positive_in(required(tool, "radius_mm", where + ", tool"), where + ", tool, radius_mm");
  const Vector3d direction = vector_in(required(tool, "direction", where + ", tool"), where + ", tool, direction");
  if (!(direction.norm() > 1e-6))
    refuse("experiment-invalid", GLISSON_TEXT("{0} must not be zero."), {where + ", tool, direction"});
  trial.tool.direction = direction.normalized();

  const Json& samples = required(json, "samples", where);
  const std::string line = std::to_string(source.line_of(id));
  if (!samples.is_array() || samples.empty())
    refuse("experiment-invalid", GLISSON_TEXT("Trial {0} (line {1} of {2}) has no samples."),
           {id, line, source.file.filename().string()}, GLISSON_TEXT("Was the recording interrupted?"));
  for (std::size_t s = 0; s < samples.size(); ++s) {
    trial.samples.push_back(sample_from(samples[s], where + ", sample " + std::to_string(s + 1), source, palpation));
    if (s > 0 && trial.samples[s].time_s < trial.samples[s - 1].time_s)
      refuse("experiment-invalid", GLISSON_TEXT("In trial {0} (line {1} of {2}) time goes back at sample {3}."),
             {id, line, source.file.filename().string(), std::to_string(s + 1)},
             GLISSON_TEXT("Are two recordings in one trial?"));
  }
  const bool measured = std::any_of(trial.samples.begin(), trial.samples.end(),
                                    [](const PalpationSample& sample) { return !sample.markers.empty(); });
  if (needs == Needs::measurements && !measured)
    refuse("experiment-invalid", GLISSON_TEXT("No sample of trial {0} (line {1} of {2}) names markers."),
           {id, line, source.file.filename().string()});
  return trial;
}

}  // namespace
}  // namespace glisson::closedloop

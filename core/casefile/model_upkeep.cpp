#include "casefile/model_upkeep.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <numbers>
#include <numeric>
#include <set>

#include "casefile/structures.h"
#include "geometry/mesh_file.h"

namespace glisson::casefile {
namespace {

using Eigen::Vector3d;

constexpr const char* stage_entries[] = {"meshes/liver", "meshes/model"};

double min_dihedral_deg(const geometry::TetMesh& mesh, const std::array<int, 4>& cell);
geometry::Surface part_with(const geometry::Surface& boundary, const geometry::TetMesh& mesh, const char* point_field);
Result<double> label_ml(const Case& patient);
int target_cells_of(const Case& patient);

}  // namespace

ModelState model_state(const Case& patient) {
  ModelState state;
  state.built = patient.find("meshes/model") != nullptr;
  if (!state.built) return state;
  state.current = true;
  std::set<std::string> changed;
  for (const char* id : stage_entries) {
    const Entry* entry = patient.find(id);
    if (entry == nullptr) continue;
    const Freshness freshness = patient.freshness(id);
    if (freshness == Freshness::current) continue;
    state.current = false;
    if (freshness == Freshness::changed_outside) state.changed_outside = true;
    if (freshness == Freshness::missing) state.missing_file = true;
    for (const auto& [from, sha256] : entry->from_sha256) {
      const Entry* now = patient.find(from);
      if (from != stage_entries[0] && (now == nullptr || now->sha256 != sha256)) changed.insert(from);
    }
  }
  state.changed.assign(changed.begin(), changed.end());
  return state;
}

Result<ModelFacts> model_facts(const Case& patient, const Progress& progress) {
  progress.report(0, GLISSON_TEXT("Reading the model"));
  const auto mesh =
      patient.file_of("meshes/model").and_then([](const auto& file) { return geometry::read_tetrahedra(file); });
  if (!mesh) return failure(mesh.error());
  ModelFacts facts;
  facts.points = mesh->points_mm.size();
  facts.cells = mesh->cells.size();
  facts.mesh_ml = units::ml_from_mm3(geometry::volume_mm3(*mesh));
  for (const auto& cell : mesh->cells) facts.min_dihedral_deg.push_back(min_dihedral_deg(*mesh, cell));
  if (const auto* youngs = geometry::find_field(mesh->cell_fields, mechanics::youngs_modulus_field)) {
    facts.youngs_kPa = youngs->values;
    const auto count = static_cast<double>(std::max<std::size_t>(1, facts.youngs_kPa.size()));
    facts.mean_kPa = std::accumulate(facts.youngs_kPa.begin(), facts.youngs_kPa.end(), 0.0) / count;
    double squares = 0;
    for (const double value : facts.youngs_kPa) squares += (value - facts.mean_kPa) * (value - facts.mean_kPa);
    facts.sd_kPa = std::sqrt(squares / count);
  }
  if (const auto* source = geometry::find_field(mesh->cell_fields, "stiffness_source")) {
    facts.filled_cells = static_cast<std::size_t>(std::count(
        source->values.begin(), source->values.end(), static_cast<double>(elastography::StiffnessSource::filled)));
  }
  facts.surface = geometry::boundary_surface(*mesh);
  if (const auto* behind = geometry::find_field(facts.surface.cell_fields, "mesh_cell");
      behind != nullptr && !facts.youngs_kPa.empty()) {
    geometry::Field youngs{mechanics::youngs_modulus_field, 1, {}};
    for (const double cell : behind->values) youngs.values.push_back(facts.youngs_kPa[static_cast<std::size_t>(cell)]);
    geometry::set_field(facts.surface.cell_fields, std::move(youngs));
  }
  facts.held = part_with(facts.surface, *mesh, "bare_area");
  facts.on_springs = part_with(facts.surface, *mesh, "diaphragm");
  if (progress.cancelled()) return cancelled();
  progress.report(0.5, GLISSON_TEXT("Reading the structures"));
  const auto label = label_ml(patient);
  if (!label) return failure(label.error());
  facts.label_ml = *label;
  facts.target_cells = target_cells_of(patient);
  facts.assumed = assumed_stiffness(patient).has_value();
  for (const char* id : stage_entries) {
    if (const Entry* entry = patient.find(id)) {
      facts.notes.insert(facts.notes.end(), entry->made.notes.begin(), entry->made.notes.end());
    }
  }
  return facts;
}

StiffnessChoice stiffness_choice_of(const Case& patient) {
  const Entry* model = patient.find("meshes/model");
  if (model == nullptr) {
    return patient.find("volumes/stiffness") != nullptr ? StiffnessChoice(FromMre{})
                                                        : StiffnessChoice(FromPopulationMean{});
  }
  return stiffness_choice_in(model->made);
}

StiffnessChoice stiffness_choice_in(const Provenance& made) {
  const auto& options = made.options;
  const auto value_of = [&](const char* key) -> std::optional<double> {
    const auto found = options.find(key);
    if (found == options.end()) return {};
    return std::strtod(found->second.c_str(), nullptr);
  };
  if (const auto uniform = value_of("uniform_kPa")) return Uniform{*uniform};
  if (const auto reference = value_of("atlas_kPa")) {
    const double published_kPa = elastography::reference_youngs_kPa(elastography::PopulationMean::published_cohort);
    return FromPopulationMean{std::abs(*reference - published_kPa) < 0.05
                                  ? elastography::PopulationMean::published_cohort
                                  : elastography::PopulationMean::dissertation_cohort};
  }
  return FromMre{};
}

std::optional<Sentence> assumed_stiffness(const Case& patient) {
  if (patient.find("meshes/model") == nullptr) return {};
  const StiffnessChoice choice = stiffness_choice_of(patient);
  if (const auto* uniform = std::get_if<Uniform>(&choice)) {
    return Sentence{
        GLISSON_TEXT("The stiffness is assumed, {0} kPa for all cells, and not measured: it is not compared "
                     "with the atlas."),
        {fmt::format("{:.3g}", uniform->youngs_kPa)}};
  }
  if (const auto* mean = std::get_if<FromPopulationMean>(&choice)) {
    return Sentence{GLISSON_TEXT("The stiffness is assumed, the atlas's {0} kPa for all cells, and not measured: it is "
                                 "not compared with the atlas."),
                    {fmt::format("{:.3g}", elastography::reference_youngs_kPa(mean->mean))}};
  }
  return {};
}

Result<void> bring_model_up_to_date(Case& patient, const Upkeep& upkeep, const Progress& progress) {
  const bool other_size = upkeep.target_cells && *upkeep.target_cells != target_cells_of(patient);
  const bool mesh_needed =
      patient.find("meshes/liver") == nullptr || other_size || patient.freshness("meshes/liver") != Freshness::current;
  if (mesh_needed) {
    meshing::MeshOptions options;
    options.target_cells = upkeep.target_cells.value_or(target_cells_of(patient));
    if (auto meshed = mesh_liver(patient, options, progress.part(0, 0.8)); !meshed) {
      return failure(std::move(meshed.error()));
    }
  }
  return assign_stiffness(patient, upkeep.stiffness, {}, progress.part(mesh_needed ? 0.8 : 0.0, 1))
      .map([](const auto&) {});
}

namespace {

// Between two faces: the angle of the outward normals is what is left of it to 180 degrees.
double min_dihedral_deg(const geometry::TetMesh& mesh, const std::array<int, 4>& cell) {
  std::array<Vector3d, 4> corner;
  for (std::size_t k = 0; k < 4; ++k) corner[k] = mesh.points_mm[static_cast<std::size_t>(cell[k])];
  const Vector3d middle = 0.25 * (corner[0] + corner[1] + corner[2] + corner[3]);
  std::array<Vector3d, 4> outward;  // of the face across from each corner
  for (std::size_t k = 0; k < 4; ++k) {
    const Vector3d& a = corner[(k + 1) % 4];
    const Vector3d normal = (corner[(k + 2) % 4] - a).cross(corner[(k + 3) % 4] - a).normalized();
    outward[k] = normal.dot(a - middle) > 0 ? normal : Vector3d(-normal);
  }
  double smallest = std::numbers::pi;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = i + 1; k < 4; ++k) {
      smallest = std::min(smallest, std::numbers::pi - std::acos(std::clamp(outward[i].dot(outward[k]), -1.0, 1.0)));
    }
  }
  return smallest * 180 / std::numbers::pi;
}

// The triangles all of whose points the field names.
geometry::Surface part_with(const geometry::Surface& boundary, const geometry::TetMesh& mesh, const char* point_field) {
  geometry::Surface part;
  const auto* named = geometry::find_field(mesh.point_fields, point_field);
  const auto* mesh_point = geometry::find_field(boundary.point_fields, "mesh_point");
  if (named == nullptr || mesh_point == nullptr) return part;
  std::vector<int> number(boundary.points_mm.size(), -1);
  for (const auto& triangle : boundary.triangles) {
    const bool inside = std::all_of(triangle.begin(), triangle.end(), [&](int p) {
      return named->values[static_cast<std::size_t>(mesh_point->values[static_cast<std::size_t>(p)])] != 0;
    });
    if (!inside) continue;
    std::array<int, 3> renumbered{};
    for (std::size_t k = 0; k < 3; ++k) {
      int& of_point = number[static_cast<std::size_t>(triangle[k])];
      if (of_point < 0) {
        of_point = static_cast<int>(part.points_mm.size());
        part.points_mm.push_back(boundary.points_mm[static_cast<std::size_t>(triangle[k])]);
      }
      renumbered[k] = of_point;
    }
    part.triangles.push_back(renumbered);
  }
  return part;
}

Result<double> label_ml(const Case& patient) {
  auto structures = read_structures(patient);
  if (!structures) return failure(structures.error());
  if (structures->empty() || structures->front().name != "liver") return 0.0;
  return segmentation::volume_ml(structures->front().mask);
}

int target_cells_of(const Case& patient) {
  const Entry* mesh = patient.find("meshes/liver");
  if (mesh != nullptr) {
    if (const auto found = mesh->made.options.find("target-cells"); found != mesh->made.options.end()) {
      if (const int cells = std::atoi(found->second.c_str()); cells > 0) return cells;
    }
  }
  return meshing::MeshOptions{}.target_cells;
}

}  // namespace
}  // namespace glisson::casefile

#include "mechanics/scenario/mesh_moduli.h"

#include <fmt/format.h>
#include <algorithm>
#include <utility>

#include "geometry/fields.h"
#include "mechanics/scenario/scenario.h"

namespace glisson::mechanics {
namespace {

// The cell field of that name, if it has one number a cell.
const geometry::Field* cell_numbers(const geometry::TetMesh& mesh, const std::string& name) {
  const geometry::Field* field = geometry::find_field(mesh.cell_fields, name);
  const bool sound = field != nullptr && field->components == 1 && field->values.size() == mesh.cells.size();
  return sound ? field : nullptr;
}

}  // namespace

void set_moduli(geometry::TetMesh& mesh, std::vector<double> youngs_kPa, std::optional<double> poisson_ratio) {
  geometry::set_field(mesh.cell_fields, {youngs_modulus_field, 1, std::move(youngs_kPa)});
  std::erase_if(mesh.cell_fields, [](const geometry::Field& field) { return field.name == poisson_ratio_field; });
  if (poisson_ratio)
    geometry::set_field(mesh.cell_fields,
                        {poisson_ratio_field, 1, std::vector<double>(mesh.cells.size(), *poisson_ratio)});
}

std::optional<double> poisson_ratio_of(const geometry::TetMesh& mesh) {
  const geometry::Field* ratios = cell_numbers(mesh, poisson_ratio_field);
  return ratios == nullptr || ratios->values.empty() ? std::nullopt : std::optional(ratios->values.front());
}

Result<MeshModuli> moduli_of(const geometry::TetMesh& mesh, const std::string& name, double poisson_ratio) {
  const geometry::Field* moduli = cell_numbers(mesh, name);
  if (moduli == nullptr) {
    return failure(Error{"modulus-missing",
                         GLISSON_TEXT("The mesh has no cell array {0} with one value a cell."),
                         {name, geometry::names_of(mesh.cell_fields)},
                         GLISSON_TEXT("Give the scenario \"youngs_modulus_kPa\", a number or the name of a cell array; "
                                      "the mesh's cell arrays are: {1}."),
                         {}});
  }
  MeshModuli found{moduli->values, std::nullopt};
  const geometry::Field* ratios = name == youngs_modulus_field ? cell_numbers(mesh, poisson_ratio_field) : nullptr;
  if (ratios == nullptr) return found;
  for (std::size_t cell = 0; cell < found.youngs_kPa.size(); ++cell) {
    const double made_by = ratios->values[cell];
    if (!(made_by > -1.0 && made_by <= 0.5))
      return failure("poisson-invalid",
                     GLISSON_TEXT("The mesh's Poisson's ratio must lie above -1 and not above 0.5; it is {0}."),
                     {fmt::format("{:g}", made_by)});
    if (made_by == poisson_ratio) continue;
    found.youngs_kPa[cell] *= (1 + poisson_ratio) / (1 + made_by);
    if (!found.note)
      found.note = fmt::format(
          "The mesh's Young's moduli were made of measured shear moduli by a Poisson's ratio of {:g}; for {:g} they "
          "are "
          "{:.4g} times as large, so that the shear moduli stay.",
          made_by, poisson_ratio, (1 + poisson_ratio) / (1 + made_by));
  }
  return found;
}

}  // namespace glisson::mechanics

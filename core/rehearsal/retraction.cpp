#include "rehearsal/retraction.h"

#include <algorithm>

#include "mechanics/elements/point_location.h"
#include "mechanics/elements/strain.h"
#include "mechanics/simulation.h"

namespace glisson::rehearsal {
namespace {

using Eigen::Vector3d;

std::vector<double> volumes_mm3(const geometry::TetMesh& mesh);
mechanics::Validity validity_by_corners(const geometry::TetMesh& rest, const std::vector<Vector3d>& displacement_mm);
Vector3d middle_mm(const std::vector<Vector3d>& points_mm);
void subtract_displacement(std::vector<Vector3d>& points_mm, const geometry::Fields& fields);

}  // namespace

LyingLiver at_rest(const geometry::TetMesh& liver) { return {liver, volumes_mm3(liver)}; }

Result<LyingLiver> displaced(const geometry::TetMesh& rest, const std::vector<Vector3d>& displacement_mm) {
  const bool finite = std::all_of(displacement_mm.begin(), displacement_mm.end(),
                                  [](const Vector3d& moved_mm) { return moved_mm.allFinite(); });
  if (displacement_mm.size() != rest.points_mm.size() || !finite) {
    return failure(
        Error{"retraction-mismatch",
              GLISSON_TEXT("The displacement has {0} points, the liver {1}; or one of them is not a number."),
              {std::to_string(displacement_mm.size()), std::to_string(rest.points_mm.size())},
              GLISSON_TEXT("Simulate it again with the model as it is now."),
              {}});
  }
  LyingLiver lying{rest, volumes_mm3(rest)};
  geometry::Field field{mechanics::displacement_field, 3, {}};
  for (std::size_t p = 0; p < displacement_mm.size(); ++p) {
    lying.mesh.points_mm[p] += displacement_mm[p];
    field.values.insert(field.values.end(), displacement_mm[p].begin(), displacement_mm[p].end());
  }
  geometry::set_field(lying.mesh.point_fields, std::move(field));
  const std::vector<double> now_mm3 = volumes_mm3(lying.mesh);
  const auto inverted = std::count_if(now_mm3.begin(), now_mm3.end(), [](double mm3) { return !(mm3 > 0); });
  if (inverted > 0) {
    return failure(Error{"retraction-inverted",
                         GLISSON_TEXT("Held like this, cells of the liver are turned inside out ({0}): nothing can be "
                                      "measured there."),
                         {std::to_string(inverted)},
                         GLISSON_TEXT("Pull or push with less force."),
                         {}});
  }
  lying.validity = validity_by_corners(rest, displacement_mm);
  return lying;
}

std::vector<NamedStructure> displaced(const geometry::TetMesh& rest, const std::vector<Vector3d>& displacement_mm,
                                      std::vector<NamedStructure> structures) {
  for (NamedStructure& structure : structures) {
    const geometry::Surface at_rest = structure.surface;
    std::vector<Vector3d>& points_mm = structure.surface.points_mm;
    const auto places = mechanics::locate_points(rest, points_mm);
    for (std::size_t p = 0; p < places.size(); ++p) {
      const auto& cell = rest.cells[static_cast<std::size_t>(places[p].cell)];
      for (int k = 0; k < 4; ++k) points_mm[p] += places[p].barycentric[k] * displacement_mm[cell[k]];
    }
    structure.shift_mm = shift_mm(at_rest, structure.surface);
  }
  return structures;
}

double shift_mm(const geometry::Surface& rest, const geometry::Surface& now) {
  return (middle_mm(now.points_mm) - middle_mm(rest.points_mm)).norm();
}

geometry::TetMesh put_to_rest(geometry::TetMesh mesh) {
  subtract_displacement(mesh.points_mm, mesh.point_fields);
  return mesh;
}

geometry::Surface put_to_rest(geometry::Surface surface) {
  subtract_displacement(surface.points_mm, surface.point_fields);
  return surface;
}

namespace {

std::vector<double> volumes_mm3(const geometry::TetMesh& mesh) {
  std::vector<double> volumes(mesh.cells.size());
  for (std::size_t cell = 0; cell < volumes.size(); ++cell) volumes[cell] = geometry::cell_volume_mm3(mesh, cell);
  return volumes;
}

mechanics::Validity validity_by_corners(const geometry::TetMesh& rest, const std::vector<Vector3d>& displacement_mm) {
  const mechanics::NodeLayout corners = mechanics::lay_out_nodes(rest, mechanics::ElementOrder::linear);
  Eigen::VectorXd u_mm(3 * Eigen::Index{corners.nodes()});
  for (std::size_t p = 0; p < displacement_mm.size(); ++p) {
    if (corners.node_of_point[p] >= 0) u_mm.segment<3>(3 * Eigen::Index{corners.node_of_point[p]}) = displacement_mm[p];
  }
  const mechanics::StrainRange strains = mechanics::strain_range(rest, corners, u_mm);
  return {true, strains.largest_strain, strains.inverted_cells};
}

Vector3d middle_mm(const std::vector<Vector3d>& points_mm) {
  Vector3d sum = Vector3d::Zero();
  for (const Vector3d& point : points_mm) sum += point;
  return sum / static_cast<double>(std::max<std::size_t>(1, points_mm.size()));
}

void subtract_displacement(std::vector<Vector3d>& points_mm, const geometry::Fields& fields) {
  const geometry::Field* moved = geometry::find_field(fields, mechanics::displacement_field);
  if (moved == nullptr) return;
  for (std::size_t p = 0; p < points_mm.size(); ++p) points_mm[p] -= Vector3d(&moved->values[3 * p]);
}

}  // namespace
}  // namespace glisson::rehearsal

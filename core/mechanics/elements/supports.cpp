#include "mechanics/elements/supports.h"
#include "geometry/fields.h"

#include <fmt/format.h>
#include <cmath>

namespace glisson::mechanics {
namespace {

using Named = std::vector<std::uint8_t>;  // one a mesh point: 1 where the support names it

Result<Named> named_points(const geometry::TetMesh& mesh, const Region& region, const std::string& which);
Result<void> hold(const geometry::TetMesh& mesh, const NodeLayout& layout, const Named& named, const Fixed& how,
                  std::size_t support, ResolvedSupports& resolved);
Result<std::vector<LigamentSpring>> springs_of(const NodeLayout& layout, const std::vector<BoundaryFace>& boundary,
                                               const Named& named, const Ligament& ligament, const std::string& which);

}  // namespace

Result<ResolvedSupports> resolve_supports(const geometry::TetMesh& mesh, const NodeLayout& layout,
                                          const std::vector<BoundaryFace>& boundary,
                                          const std::vector<Support>& supports) {
  ResolvedSupports resolved;
  resolved.fixed.assign(3 * static_cast<std::size_t>(layout.nodes()), 0);
  resolved.support_of_fixed.assign(resolved.fixed.size(), -1);
  for (std::size_t s = 0; s < supports.size(); ++s) {
    const std::string which = std::to_string(s + 1);
    auto named = named_points(mesh, supports[s].where, which);
    if (!named) return failure(std::move(named.error()));

    bool names_any = false;
    for (std::size_t p = 0; p < named->size(); ++p) names_any |= (*named)[p] && layout.node_of_point[p] >= 0;
    if (!names_any) {
      return failure(Error{"support-empty",
                           GLISSON_TEXT("Support {0} names no point of the mesh."),
                           {which},
                           GLISSON_TEXT("Move or enlarge its region, or name another point array."),
                           {}});
    }

    if (const auto* fixed = std::get_if<Fixed>(&supports[s].how)) {
      if (auto held = hold(mesh, layout, *named, *fixed, s, resolved); !held) return failure(std::move(held.error()));
      continue;
    }
    if (const auto* ligament = std::get_if<Ligament>(&supports[s].how)) {
      auto springs = springs_of(layout, boundary, *named, *ligament, which);
      if (!springs) return failure(std::move(springs.error()));
      resolved.ligaments.insert(resolved.ligaments.end(), springs->begin(), springs->end());
      continue;
    }
    const double stiffness = std::get<Foundation>(supports[s].how).stiffness_kPa_per_mm;
    if (!std::isfinite(stiffness) || stiffness <= 0) {
      return failure("support-invalid",
                     GLISSON_TEXT("The foundation of support {0} needs a stiffness above zero, not {1} kPa/mm."),
                     {which, fmt::format("{}", stiffness)});
    }
    const std::size_t before = resolved.foundations.size();
    for (std::size_t f = 0; f < boundary.size(); ++f) {
      const auto& [a, b, c] = boundary[f].points;
      if ((*named)[a] && (*named)[b] && (*named)[c]) resolved.foundations.push_back({f, stiffness});
    }
    if (resolved.foundations.size() == before) {
      return failure(Error{"support-empty",
                           GLISSON_TEXT("The foundation of support {0} covers no face: no face of the surface has all "
                                        "three points named."),
                           {which},
                           GLISSON_TEXT("Move or enlarge its region."),
                           {}});
    }
  }
  return resolved;
}

namespace {

Result<Named> named_points(const geometry::TetMesh& mesh, const Region& region, const std::string& which) {
  Named named(mesh.points_mm.size(), 0);
  if (const auto* array = std::get_if<NamedPoints>(&region)) {
    const geometry::Field* field = geometry::find_field(mesh.point_fields, array->point_array);
    if (field == nullptr || field->components != 1 || field->items() != named.size()) {
      return failure(Error{"array-unknown",
                           GLISSON_TEXT("Support {0} asks for the point array {1}, which the mesh does not have with "
                                        "one value a point."),
                           {which, array->point_array, geometry::names_of(mesh.point_fields)},
                           GLISSON_TEXT("The mesh's point arrays are: {2}."),
                           {}});
    }
    for (std::size_t p = 0; p < named.size(); ++p) {
      if (!std::isfinite(field->values[p])) {
        return failure("support-invalid", GLISSON_TEXT("The point array {0} is not a number at point {1}."),
                       {array->point_array, std::to_string(p)});
      }
      named[p] = field->values[p] != 0.0;
    }
    return named;
  }
  if (const auto* ball = std::get_if<Ball>(&region)) {
    if (!ball->center_mm.allFinite() || !std::isfinite(ball->radius_mm) || ball->radius_mm <= 0) {
      return failure("support-invalid",
                     GLISSON_TEXT("The sphere of support {0} needs a finite centre and a radius above zero."), {which});
    }
    for (std::size_t p = 0; p < named.size(); ++p) {
      named[p] = (mesh.points_mm[p] - ball->center_mm).norm() <= ball->radius_mm;
    }
    return named;
  }
  const auto& box = std::get<geometry::Box>(region);
  if (!box.min_mm.allFinite() || !box.max_mm.allFinite() || (box.min_mm.array() > box.max_mm.array()).any()) {
    return failure("support-invalid",
                   GLISSON_TEXT("The box of support {0} needs finite corners, the smaller one first."), {which});
  }
  for (std::size_t p = 0; p < named.size(); ++p) {
    const auto point = mesh.points_mm[p].array();
    named[p] = (point >= box.min_mm.array()).all() && (point <= box.max_mm.array()).all();
  }
  return named;
}

Result<void> hold(const geometry::TetMesh& mesh, const NodeLayout& layout, const Named& named, const Fixed& how,
                  std::size_t support, ResolvedSupports& resolved) {
  const std::string which = std::to_string(support + 1);
  if (!how.displacement_mm.allFinite()) {
    return failure("support-invalid", GLISSON_TEXT("The displacement of support {0} is not a finite vector."), {which});
  }
  std::vector<std::uint8_t>& fixed = resolved.fixed;
  Eigen::VectorXd& prescribed_mm = resolved.prescribed_mm;
  const auto at = [&](std::size_t unknown) {
    return prescribed_mm.size() > 0 ? prescribed_mm[static_cast<Eigen::Index>(unknown)] : 0.0;
  };
  bool contradicts = false;
  // A node that earlier supports hold keeps what they prescribe; a node of this one may come up several times.
  const auto hold_node = [&](int node) {
    for (int d = 0; d < 3; ++d) {
      if (!how.directions[d]) continue;
      const std::size_t unknown = 3 * static_cast<std::size_t>(node) + static_cast<std::size_t>(d);
      contradicts |= fixed[unknown] && at(unknown) != how.displacement_mm[d];
      if (!fixed[unknown]) resolved.support_of_fixed[unknown] = static_cast<int>(support);
      fixed[unknown] = 1;
      if (how.displacement_mm[d] == 0) continue;
      if (prescribed_mm.size() == 0) prescribed_mm = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(fixed.size()));
      prescribed_mm[static_cast<Eigen::Index>(unknown)] = how.displacement_mm[d];
    }
  };
  for (std::size_t p = 0; p < named.size(); ++p) {
    if (named[p] && layout.node_of_point[p] >= 0) hold_node(layout.node_of_point[p]);
  }
  constexpr int faces_of_cell[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  for (const auto& cell : mesh.cells) {
    if (layout.order == ElementOrder::linear) break;
    for (const auto& face : faces_of_cell) {
      const int corners[3] = {cell[face[0]], cell[face[1]], cell[face[2]]};
      if (!named[corners[0]] || !named[corners[1]] || !named[corners[2]]) continue;
      for (int i = 0; i < 3; ++i) hold_node(layout.node_of_edge(corners[i], corners[(i + 1) % 3]));
    }
  }
  if (!contradicts) return {};
  return failure(Error{"support-contradicts",
                       GLISSON_TEXT("Support {0} moves points that another support holds or moves elsewhere."),
                       {which},
                       GLISSON_TEXT("Let each point be held by one support, or in other directions."),
                       {}});
}

Result<std::vector<LigamentSpring>> springs_of(const NodeLayout& layout, const std::vector<BoundaryFace>& boundary,
                                               const Named& named, const Ligament& ligament, const std::string& which) {
  if (!ligament.anchor_mm.allFinite() || !std::isfinite(ligament.stiffness_mN_per_mm) ||
      ligament.stiffness_mN_per_mm <= 0 || !std::isfinite(ligament.slack_mm) || ligament.slack_mm < 0) {
    return failure("support-invalid",
                   GLISSON_TEXT("The ligament of support {0} needs a finite anchor, a stiffness above zero and a slack "
                                "not below it."),
                   {which});
  }
  std::vector<double> area_of_point_mm2(named.size(), 0.0);
  double area_mm2 = 0;
  for (const BoundaryFace& face : boundary) {
    for (const int p : face.points) {
      if (!named[p]) continue;
      area_of_point_mm2[p] += face.area_mm2 / 3.0;
      area_mm2 += face.area_mm2 / 3.0;
    }
  }
  if (area_mm2 == 0) {
    return failure(Error{"support-empty",
                         GLISSON_TEXT("The ligament of support {0} names no point of the surface."),
                         {which},
                         GLISSON_TEXT("Move or enlarge its region."),
                         {}});
  }
  std::vector<LigamentSpring> springs;
  for (std::size_t p = 0; p < named.size(); ++p) {
    if (area_of_point_mm2[p] == 0) continue;
    const int node = layout.node_of_point[p];
    springs.push_back({node, ligament.anchor_mm,
                       (ligament.anchor_mm - layout.positions_mm[node]).norm() + ligament.slack_mm,
                       ligament.stiffness_mN_per_mm * area_of_point_mm2[p] / area_mm2});
  }
  return springs;
}

}  // namespace
}  // namespace glisson::mechanics

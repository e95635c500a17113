#include "closedloop/guidance/internal/quadratic_surface.h"

#include <Eigen/Geometry>
#include <map>

#include "geometry/nearest.h"

namespace glisson::closedloop {

using Eigen::Vector3d;

namespace {

// Corners of the four triangles of a face, by its nodes; and where its nodes lie on it.
constexpr std::array<std::array<int, 3>, 4> parts{{{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}}};
const Eigen::Matrix<double, 3, 6> node_places =
    (Eigen::Matrix<double, 3, 6>() << 1, 0, 0, 0.5, 0, 0.5, 0, 1, 0, 0.5, 0.5, 0, 0, 0, 1, 0, 0.5, 0.5).finished();

Eigen::Matrix<double, 6, 1> quadratic_weights(const Vector3d& at) {
  Eigen::Matrix<double, 6, 1> weights;
  for (int corner = 0; corner < 3; ++corner) {
    weights[corner] = at[corner] * (2 * at[corner] - 1);
    weights[3 + corner] = 4 * at[corner] * at[(corner + 1) % 3];
  }
  return weights;
}

}  // namespace

QuadraticSurface::QuadraticSurface(const mechanics::Body& body) {
  std::map<int, int> number;
  for (const mechanics::BoundaryFace& face : body.boundary) {
    auto& nodes = faces_.emplace_back();
    for (std::size_t i = 0; i < 6; ++i) {
      const auto [known, is_new] = number.try_emplace(face.nodes[i], static_cast<int>(rest_mm_.size()));
      if (is_new) rest_mm_.push_back(body.layout.positions_mm[static_cast<std::size_t>(face.nodes[i])]);
      nodes[i] = known->second;
    }
    for (const auto& part : parts) {
      triangles_.push_back({nodes[static_cast<std::size_t>(part[0])], nodes[static_cast<std::size_t>(part[1])],
                            nodes[static_cast<std::size_t>(part[2])]});
    }
  }
}

std::vector<QuadraticSurface::Place> QuadraticSurface::nearest(const std::vector<Vector3d>& positions_mm,
                                                               const std::vector<Vector3d>& points_mm) const {
  geometry::Surface flat;
  flat.points_mm = positions_mm;
  flat.triangles = triangles_;
  const geometry::SurfaceDistance tree(flat);
  std::vector<Place> places(points_mm.size());
  for (std::size_t p = 0; p < points_mm.size(); ++p) {
    const auto found = tree.closest(points_mm[p]);
    const auto triangle = static_cast<std::size_t>(found.triangle);
    const auto corner = [&](std::size_t i) { return positions_mm[static_cast<std::size_t>(triangles_[triangle][i])]; };
    const Vector3d along = corner(1) - corner(0), across = corner(2) - corner(0);
    const Vector3d area = along.cross(across);
    const Vector3d from = found.point_mm - corner(0);
    const double second = from.cross(across).dot(area) / area.squaredNorm();
    const double third = along.cross(from).dot(area) / area.squaredNorm();
    const auto& part = parts[triangle % 4];
    const Vector3d on_face = (1 - second - third) * node_places.col(part[0]) + second * node_places.col(part[1]) +
                             third * node_places.col(part[2]);
    Place& place = places[p];
    place.weights = quadratic_weights(on_face);
    place.normal = area.normalized();
    Vector3d at = Vector3d::Zero();  // on the curved face
    for (std::size_t i = 0; i < 6; ++i) {
      const int node = faces_[triangle / 4][i];
      place.nodes[i] = node;
      at += place.weights[static_cast<Eigen::Index>(i)] * positions_mm[static_cast<std::size_t>(node)];
    }
    place.distance_mm = place.normal.dot(points_mm[p] - at);
  }
  return places;
}

}  // namespace glisson::closedloop

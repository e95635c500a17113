#include "guidance/seen_line.h"

#include <algorithm>
#include <cmath>
#include <Eigen/QR>

#include "vision/draw.h"

namespace glisson::guidance {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr std::size_t neighbours = 12;
constexpr double step_mm = 8;  // in depth: another surface begins

struct Neighbour {
  double distance_px = 0;
  Vector2d offset_px{0, 0};
  Vector3d place_mm{0, 0, 0};
};

std::vector<Neighbour> nearest(const vision::Camera& camera, const std::vector<Vector3d>& cloud_mm,
                               const Vector2d& at_px) {
  std::vector<Neighbour> all;
  const auto seen = vision::project(camera, cloud_mm);
  for (std::size_t p = 0; p < seen.size(); ++p) {
    if (seen[p]) all.push_back({(*seen[p] - at_px).norm(), *seen[p] - at_px, cloud_mm[p]});
  }
  const auto nearer = [](const Neighbour& a, const Neighbour& b) { return a.distance_px < b.distance_px; };
  const auto end = all.begin() + static_cast<std::ptrdiff_t>(std::min(neighbours, all.size()));
  std::partial_sort(all.begin(), end, all.end(), nearer);
  all.erase(end, all.end());
  return all;
}

}  // namespace

std::optional<Vector3d> on_seen_surface(const vision::Camera& camera, const std::vector<Vector3d>& cloud_mm,
                                        const Vector2d& at_px, double within_px) {
  std::vector<Neighbour> around = nearest(camera, cloud_mm, at_px);
  if (around.empty() || around.front().distance_px > within_px) return std::nullopt;
  const double depth_mm = around.front().place_mm.z(), widest_px = around.back().distance_px + 1;
  std::erase_if(around, [&](const Neighbour& each) { return std::abs(each.place_mm.z() - depth_mm) > step_mm; });
  // Each coordinate is a constant and a slope in the picture; a slope that few points tell stays small.
  constexpr double slope_ridge = 1e-3;
  Eigen::MatrixXd terms = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(around.size()) + 2, 3);
  Eigen::MatrixXd places = Eigen::MatrixXd::Zero(terms.rows(), 3);
  for (Eigen::Index n = 0; n + 2 < terms.rows(); ++n) {
    const Neighbour& each = around[static_cast<std::size_t>(n)];
    const double weight = 1 - std::pow(each.distance_px / widest_px, 2);
    terms.row(n) << weight, weight * each.offset_px.x() / widest_px, weight * each.offset_px.y() / widest_px;
    places.row(n) = weight * (each.place_mm - around.front().place_mm);
  }
  terms(terms.rows() - 2, 1) = terms(terms.rows() - 1, 2) = slope_ridge;
  const Eigen::MatrixXd found = terms.colPivHouseholderQr().solve(places);
  return around.front().place_mm + found.row(0).transpose();
}

std::vector<Vector3d> filled_in(const std::vector<Vector3d>& line_mm, double spacing_mm) {
  std::vector<Vector3d> filled;
  for (std::size_t p = 0; p + 1 < line_mm.size(); ++p) {
    const Vector3d way = line_mm[p + 1] - line_mm[p];
    const int pieces = std::max(1, static_cast<int>(std::ceil(way.norm() / spacing_mm)));
    for (int piece = 0; piece < pieces; ++piece) filled.emplace_back(line_mm[p] + way * piece / pieces);
  }
  if (!line_mm.empty()) filled.push_back(line_mm.back());
  return filled;
}

}  // namespace glisson::guidance

#include "registration/nonrigid_icp.h"

#include <algorithm>
#include <cmath>
#include <Eigen/SparseCholesky>
#include <map>
#include <numbers>
#include <set>

#include "base/parallel.h"
#include "geometry/nearest.h"
#include "registration/internal/control_graph.h"

namespace glisson::registration {
namespace {

using Eigen::Vector3d;
using geometry::Surface;
using Sparse = Eigen::SparseMatrix<double>;
using Maps = Eigen::MatrixX3d;  // four rows a point: its affine map, transposed (X of the paper)

constexpr double skew_weight = 1;  // gamma of the paper: what the linear part weighs beside the translation

// A place on the source, within a triangle or at a point, and where it should go.
struct ClosestPair {
  std::array<int, 3> points{};
  Vector3d weights{1, 0, 0};  // add to 1
  Vector3d target_mm{0, 0, 0};
};

struct Pairing {
  std::vector<ClosestPair> pairs;
  double fraction = 0;  // of the points that looked for a partner
  double rms_mm = 0;
};

// Looks for partners on one surface for points of the other.
class Partners {
 public:
  Partners(const Surface& seeking, const Surface& sought, double largest_angle_deg, double farthest_mm);

  struct Partner {
    std::size_t seeker = 0;
    geometry::SurfaceDistance::Closest closest;
  };
  [[nodiscard]] std::vector<Partner> found() const;

 private:
  [[nodiscard]] bool is_on_border(const geometry::SurfaceDistance::Closest& closest) const;

  const Surface& seeking_;
  const Surface& sought_;
  std::set<std::pair<int, int>> border_;  // edges of one triangle
  double minimum_cosine_;
  double farthest_mm_;
};

Pairing pair_up(const Surface& source, const Surface& target, const NonrigidIcpOptions& options, double farthest_mm,
                Overlap overlap);
Vector3d barycentric(const Surface& surface, const std::array<int, 3>& triangle, const Vector3d& point_mm);
Result<void> check_landmarks(const std::vector<Landmark>& landmarks, std::size_t points);

// The sparse system of one source.
class OptimalStep {
 public:
  // `covered`: which share of the source the target covers.
  OptimalStep(const Surface& source, int maximum_controls, double covered);
  // The controls' maps that are best for this pairing.
  [[nodiscard]] Result<Maps> solve(const Pairing& pairing, double stiffness, const std::vector<Landmark>& landmarks,
                                   double landmark_weight);
  [[nodiscard]] Surface moved(const Maps& maps) const;

 private:
  // A point in homogeneous coordinates about the source's centre, in units of its size.
  [[nodiscard]] Eigen::Vector4d place(std::size_t point) const {
    return (Eigen::Vector4d() << (source_.points_mm[point] - center_mm_) / size_mm_, 1).finished();
  }

  const Surface& source_;
  Vector3d center_mm_;
  double size_mm_;
  ControlGraph graph_;
  double covered_;
  Eigen::SimplicialLDLT<Sparse> solver_;
};

}  // namespace

Result<NonrigidIcpResult> nonrigid_icp(const Surface& source, const Surface& target, const NonrigidIcpOptions& options,
                                       const Progress& progress) {
  if (auto good = check_surface(source); !good) return failure(good.error());
  if (auto good = check_surface(target); !good) return failure(good.error());
  if (auto good = check_landmarks(options.landmarks, source.points_mm.size()); !good) return failure(good.error());

  const double farthest_mm = options.farthest_pair_mm > 0 ? options.farthest_pair_mm
                                                          : geometry::bounding_box(source.points_mm).diagonal_mm() / 10;
  const Overlap overlap = resolved(options.overlap, source, target);
  const bool target_is_part = overlap == Overlap::target_is_part;
  const double covered = target_is_part ? geometry::area_mm2(target) / geometry::area_mm2(source) : 1.0;
  OptimalStep step(source, options.maximum_controls, covered);
  NonrigidIcpResult result;
  result.surface = source;
  const auto maximum_iterations =
      static_cast<double>(options.stiffness.size()) * static_cast<double>(options.iterations_each);
  for (const double stiffness : options.stiffness) {
    const double landmark_weight = options.landmark_weight * stiffness / options.stiffness.front();
    for (int iteration = 0; iteration < options.iterations_each; ++iteration) {
      if (progress.cancelled()) {
        result.stopped = IcpStop::cancelled;
        return result;
      }
      const Pairing pairing = pair_up(result.surface, target, options, farthest_mm, overlap);
      result.rms_mm = pairing.rms_mm;
      result.paired_fraction = pairing.fraction;
      if (pairing.fraction == 0 && options.landmarks.empty()) {
        return failure(Error{"registration-no-pairs",
                             GLISSON_TEXT("No point of one surface has a partner on the other."),
                             {},
                             GLISSON_TEXT("Align the surfaces roughly first, or give landmarks."),
                             {}});
      }
      const auto maps = step.solve(pairing, stiffness, options.landmarks, landmark_weight);
      if (!maps) return failure(maps.error());
      Surface next = step.moved(*maps);
      double squared_step_mm2 = 0;
      for (std::size_t i = 0; i < next.points_mm.size(); ++i) {
        squared_step_mm2 += (next.points_mm[i] - result.surface.points_mm[i]).squaredNorm();
      }
      result.surface = std::move(next);
      ++result.iterations;
      progress.report(result.iterations / maximum_iterations, GLISSON_TEXT("non-rigid alignment"));
      if (std::sqrt(squared_step_mm2 / static_cast<double>(source.points_mm.size())) < options.smallest_step_mm) break;
    }
  }
  const Pairing pairing = pair_up(result.surface, target, options, farthest_mm, overlap);
  result.rms_mm = pairing.rms_mm;
  result.paired_fraction = pairing.fraction;
  result.stopped = IcpStop::converged;
  return result;
}

namespace {

Result<void> check_landmarks(const std::vector<Landmark>& landmarks, std::size_t points) {
  for (const Landmark& landmark : landmarks) {
    if (landmark.source_point < 0 || static_cast<std::size_t>(landmark.source_point) >= points ||
        !landmark.target_mm.allFinite()) {
      return failure("landmark-unknown", GLISSON_TEXT("A landmark names point {0}, which cannot be led anywhere."),
                     {std::to_string(landmark.source_point)});
    }
  }
  return {};
}

Pairing pair_up(const Surface& source, const Surface& target, const NonrigidIcpOptions& options, double farthest_mm,
                Overlap overlap) {
  const bool target_seeks = overlap == Overlap::target_is_part;
  const Partners partners = target_seeks ? Partners(target, source, options.largest_angle_deg, farthest_mm)
                                         : Partners(source, target, options.largest_angle_deg, farthest_mm);
  Pairing pairing;
  double sum_mm2 = 0;
  for (const auto& [seeker, closest] : partners.found()) {
    sum_mm2 += closest.distance_mm * closest.distance_mm;
    if (!target_seeks) {
      const int point = static_cast<int>(seeker);
      pairing.pairs.push_back({{point, point, point}, {1, 0, 0}, closest.point_mm});
      continue;
    }
    const auto& triangle = source.triangles[static_cast<std::size_t>(closest.triangle)];
    pairing.pairs.push_back({triangle, barycentric(source, triangle, closest.point_mm), target.points_mm[seeker]});
  }
  const std::size_t seekers = target_seeks ? target.points_mm.size() : source.points_mm.size();
  const auto paired = static_cast<double>(pairing.pairs.size());
  pairing.fraction = paired / static_cast<double>(seekers);
  pairing.rms_mm = pairing.pairs.empty() ? 0 : std::sqrt(sum_mm2 / paired);
  return pairing;
}

// Of a point in the triangle's plane; the first corner of a flat triangle.
Vector3d barycentric(const Surface& surface, const std::array<int, 3>& triangle, const Vector3d& point_mm) {
  const Vector3d& a = surface.points_mm[static_cast<std::size_t>(triangle[0])];
  const Vector3d ab = surface.points_mm[static_cast<std::size_t>(triangle[1])] - a;
  const Vector3d ac = surface.points_mm[static_cast<std::size_t>(triangle[2])] - a;
  const Vector3d normal = ab.cross(ac);
  const double squared_mm4 = normal.squaredNorm();
  if (squared_mm4 <= 0) return {1, 0, 0};
  const double b = (point_mm - a).cross(ac).dot(normal) / squared_mm4;
  const double c = ab.cross(point_mm - a).dot(normal) / squared_mm4;
  return {1 - b - c, b, c};
}

Partners::Partners(const Surface& seeking, const Surface& sought, double largest_angle_deg, double farthest_mm)
    : seeking_(seeking),
      sought_(sought),
      minimum_cosine_(std::cos(largest_angle_deg * std::numbers::pi / 180)),
      farthest_mm_(farthest_mm) {
  std::map<std::pair<int, int>, int> triangles_at;
  for (const auto& [a, b, c] : sought.triangles) {
    for (const std::pair<int, int> edge : {std::minmax(a, b), std::minmax(b, c), std::minmax(c, a)}) {
      ++triangles_at[edge];
    }
  }
  for (const auto& [edge, triangles] : triangles_at) {
    if (triangles == 1) border_.insert(edge);
  }
}

std::vector<Partners::Partner> Partners::found() const {
  const std::size_t points = seeking_.points_mm.size();
  const geometry::SurfaceDistance distance(sought_);
  const std::vector<Vector3d> normals = geometry::point_normals(seeking_);
  std::vector<Partner> partners(points);
  std::vector<char> fits(points, 0);
  parallel_for(points, 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto closest = distance.closest(seeking_.points_mm[i]);
      const auto& [a, b, c] = sought_.triangles[static_cast<std::size_t>(closest.triangle)];
      const Vector3d& corner = sought_.points_mm[static_cast<std::size_t>(a)];
      const Vector3d normal = (sought_.points_mm[static_cast<std::size_t>(b)] - corner)
                                  .cross(sought_.points_mm[static_cast<std::size_t>(c)] - corner)
                                  .normalized();
      partners[i] = {i, closest};
      fits[i] =
          closest.distance_mm <= farthest_mm_ && normals[i].dot(normal) >= minimum_cosine_ && !is_on_border(closest);
    }
  });
  std::vector<Partner> kept;
  for (std::size_t i = 0; i < points; ++i) {
    if (fits[i] != 0) kept.push_back(partners[i]);
  }
  return kept;
}

bool Partners::is_on_border(const geometry::SurfaceDistance::Closest& closest) const {
  if (border_.empty()) return false;
  const auto& triangle = sought_.triangles[static_cast<std::size_t>(closest.triangle)];
  for (std::size_t corner = 0; corner < 3; ++corner) {
    const std::pair<int, int> edge = std::minmax(triangle[corner], triangle[(corner + 1) % 3]);
    if (!border_.contains(edge)) continue;
    const Vector3d& from = sought_.points_mm[static_cast<std::size_t>(edge.first)];
    const Vector3d along = sought_.points_mm[static_cast<std::size_t>(edge.second)] - from;
    const Vector3d to_point = closest.point_mm - from;
    if (to_point.cross(along).norm() <= 1e-6 * along.squaredNorm()) return true;
  }
  return false;
}

OptimalStep::OptimalStep(const Surface& source, int maximum_controls, double covered)
    : source_(source), graph_(control_graph(source, maximum_controls)), covered_(covered) {
  const geometry::Box box = geometry::bounding_box(source.points_mm);
  center_mm_ = box.center_mm();
  size_mm_ = box.diagonal_mm() / 2;
}

// The normal equations of the paper's eq. 11, four by four for each pair of controls.
Result<Maps> OptimalStep::solve(const Pairing& pairing, double stiffness, const std::vector<Landmark>& landmarks,
                                double landmark_weight) {
  using Block = Eigen::Matrix4d;
  const auto unknowns = static_cast<Eigen::Index>(4 * graph_.points.size());
  std::map<std::pair<int, int>, Block> blocks;
  const auto block = [&](int a, int b) -> Block& { return blocks.try_emplace({a, b}, Block::Zero()).first->second; };
  Maps right = Maps::Zero(unknowns, 3);
  const auto lead = [&](const ClosestPair& pair, double weight) {
    std::map<int, Eigen::Vector4d> row;  // the place on the source as a sum over the controls' maps
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const double share_of_corner = pair.weights[static_cast<int>(corner)];
      if (share_of_corner == 0) continue;
      const auto point = static_cast<std::size_t>(pair.points[corner]);
      for (const auto& share : graph_.shares[point]) {
        row.try_emplace(share.control, Eigen::Vector4d::Zero()).first->second +=
            share_of_corner * share.weight * place(point);
      }
    }
    const Eigen::RowVector3d to = ((pair.target_mm - center_mm_) / size_mm_).transpose();
    for (const auto& [control, values] : row) {
      for (const auto& [other, other_values] : row) {
        if (other > control) break;  // the lower triangle is enough
        block(control, other) += weight * values * other_values.transpose();
      }
      right.middleRows<4>(4 * control) += weight * values * to;
    }
  };
  // Pairs together weigh as much as the points of the source that they can be of.
  const auto points = static_cast<double>(source_.points_mm.size());
  const double data_weight = points * pairing.fraction * covered_ / std::max<std::size_t>(pairing.pairs.size(), 1);
  for (const ClosestPair& pair : pairing.pairs) lead(pair, data_weight);
  for (const Landmark& landmark : landmarks) {
    const double weight = landmark_weight * points * covered_ / static_cast<double>(landmarks.size());
    lead({{landmark.source_point, 0, 0}, {1, 0, 0}, landmark.target_mm}, weight);
  }
  // Controls stand for many points: their edges weigh as much as those of the whole surface would.
  const double points_a_control = points / static_cast<double>(graph_.points.size());
  Block smoothness = Block::Identity() * stiffness * stiffness * points_a_control;
  smoothness(3, 3) *= skew_weight * skew_weight;
  for (const auto& [a, b] : graph_.edges) {
    block(a, a) += smoothness;
    block(b, b) += smoothness;
    block(b, a) -= smoothness;
  }
  for (int control = 0; control < static_cast<int>(graph_.points.size()); ++control) {
    block(control, control) += 1e-9 * Block::Identity();  // for a piece that nothing holds
  }

  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(16 * blocks.size());
  for (const auto& [place_of_block, values] : blocks) {
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        entries.emplace_back(4 * place_of_block.first + i, 4 * place_of_block.second + j, values(i, j));
      }
    }
  }
  Sparse system(unknowns, unknowns);
  system.setFromTriplets(entries.begin(), entries.end());
  solver_.compute(system);
  Maps maps = solver_.solve(right);
  if (solver_.info() != Eigen::Success || !maps.allFinite()) {
    return failure("registration-singular", GLISSON_TEXT("The step of the non-rigid alignment has no solution."));
  }
  return maps;
}

Surface OptimalStep::moved(const Maps& maps) const {
  Surface surface = source_;
  for (std::size_t i = 0; i < surface.points_mm.size(); ++i) {
    Eigen::Matrix<double, 4, 3> map = Eigen::Matrix<double, 4, 3>::Zero();
    for (const auto& share : graph_.shares[i]) map += share.weight * maps.middleRows<4>(4 * share.control);
    surface.points_mm[i] = center_mm_ + size_mm_ * (map.transpose() * place(i));
  }
  return surface;
}

}  // namespace
}  // namespace glisson::registration

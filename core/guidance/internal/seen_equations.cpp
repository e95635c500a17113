#include "guidance/internal/seen_equations.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include "base/upper_median.h"

namespace glisson::guidance {

using Eigen::Isometry3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

constexpr double curve_error_mm = 2.0;  // of a ridge or a ligament that was marked, at least
constexpr double beside_mm = 8.0;       // of the surface's rim: farther points belong to something else

double trust_and_share(const SeenRow& row) { return std::sqrt(row.trust * row.share); }

std::vector<Vector3d> thinned(std::vector<Vector3d> points, std::size_t maximum) {
  std::mt19937 random(0);
  std::shuffle(points.begin(), points.end(), random);
  if (points.size() > maximum) points.resize(maximum);
  return points;
}

}  // namespace

SeenEquations::SeenEquations(const ForceModes& modes, const SeenFrame& frame, const RegistrationOptions& options)
    : modes_(modes), frame_(frame), options_(options), cloud_mm_(thinned(frame.points_mm, options.maximum_points)) {
  for (const SeenCurve& curve : frame.curves) {
    curves_.push_back({mechanics::locate_points(modes.mesh(), curve.at_rest_mm), &curve});
  }
  std::vector<Vector3d> at_rest_mm;
  for (const SeenPoint& point : frame.known_points) at_rest_mm.push_back(point.at_rest_mm);
  known_points_ = mechanics::locate_points(modes.mesh(), at_rest_mm);
}

SeenRows SeenEquations::rows(const Isometry3d& pose, const std::vector<Vector3d>& now_mm, const Look& look) const {
  return rows(pose, now_mm, SeenSurface(modes_.surface(), modes_.mesh_point_of(), now_mm), look);
}

SeenRows SeenEquations::rows(const Isometry3d& pose, const std::vector<Vector3d>& now_mm, const SeenSurface& surface,
                             const Look& look) const {
  SeenRows seen;
  add_cloud_rows(pose.inverse(), surface, look, seen);
  add_curve_rows(pose.inverse(), now_mm, look, seen);
  add_point_rows(pose.inverse(), now_mm, look, seen);
  return seen;
}

double SeenEquations::share_of(const std::vector<Vector3d>& points_mm, const Look& look) const {
  if (!look.is_share_told || points_mm.empty()) return 1;
  return static_cast<double>(boxes_of(points_mm, options_.independent_spacing_mm)) /
         static_cast<double>(points_mm.size());
}

void SeenEquations::add_cloud_rows(const Isometry3d& back, const SeenSurface& surface, const Look& look,
                                   SeenRows& seen) const {
  std::vector<SeenSurface::Found> found;
  std::vector<double> off_mm;
  for (const Vector3d& point : cloud_mm_) {
    found.push_back(surface.find(back * point));
    off_mm.push_back(std::abs(found.back().off_mm));
  }
  const double stated_mm = std::hypot(frame_.noise_mm, options_.surface_error_mm);
  seen.noise_mm = std::max(stated_mm, std::min(1.4826 * upper_median(off_mm), look.coarsest_mm));
  const double trusted_mm = std::max(seen.noise_mm, look.widest_mm), share = share_of(cloud_mm_, look);
  double square = 0;
  std::size_t trusted = 0;
  for (SeenSurface::Found& each : found) {
    const bool beside = each.beside_mm > std::max(beside_mm, 2 * trusted_mm);
    each.row.noise_mm = seen.noise_mm;
    each.row.trust = beside ? 0.0 : robust_weight(each.off_mm, trusted_mm);
    each.row.share = share;
    if (!beside && std::abs(each.off_mm) < 3 * seen.noise_mm) {
      square += each.off_mm * each.off_mm;
      ++trusted;
    }
    seen.rows.push_back(each.row);
    seen.off_mm.push_back(std::hypot(each.off_mm, each.beside_mm));
  }
  seen.trusted_share = static_cast<double>(trusted) / static_cast<double>(std::max<std::size_t>(1, found.size()));
  seen.rms_mm = std::sqrt(square / static_cast<double>(std::max<std::size_t>(1, trusted)));
}

// A point of a curve says where the curve runs, not where along it: two rows across its tangent.
void SeenEquations::add_curve_rows(const Isometry3d& back, const std::vector<Vector3d>& now_mm, const Look& look,
                                   SeenRows& seen) const {
  for (const PlacedCurve& curve : curves_) {
    std::vector<Vector3d> line_mm;
    for (const mechanics::PointInMesh& place : curve.at_rest) {
      const auto& cell = modes_.mesh().cells[static_cast<std::size_t>(place.cell)];
      line_mm.push_back(between(now_mm, cell, place.barycentric));
    }
    const geometry::NearestPoint nearest(line_mm);
    const double noise_mm = std::max(curve.seen->noise_mm, curve_error_mm);
    const double trusted_mm = std::max(noise_mm, 0.5 * look.widest_mm), share = share_of(curve.seen->seen_mm, look);
    std::vector<double> off_mm;
    for (const Vector3d& point : curve.seen->seen_mm) {
      const auto on_line = nearest.nearest(back * point);
      off_mm.push_back(std::sqrt(on_line.squared_distance_mm2));
      const auto i = static_cast<std::size_t>(on_line.point);
      const Vector3d tangent = (line_mm[std::min(i + 1, line_mm.size() - 1)] - line_mm[i > 0 ? i - 1 : 0]).normalized();
      if (tangent.isZero()) continue;  // places of an organ that the curve does not belong to fall together
      const Vector3d across = tangent.unitOrthogonal();
      const mechanics::PointInMesh& place = curve.at_rest[i];
      for (const Vector3d& direction : {across, Vector3d(tangent.cross(across))}) {
        seen.rows.push_back({modes_.mesh().cells[static_cast<std::size_t>(place.cell)], place.barycentric, direction,
                             back * point, noise_mm, robust_weight(off_mm.back(), trusted_mm), share});
      }
    }
    seen.curve_off_mm.push_back(off_mm.empty() ? 0 : upper_median(off_mm));
  }
}

// A point whose place on the organ is known: a row in each direction.
void SeenEquations::add_point_rows(const Isometry3d& back, const std::vector<Vector3d>& now_mm, const Look& look,
                                   SeenRows& seen) const {
  if (known_points_.empty()) return;
  std::vector<double> off_mm;
  for (std::size_t p = 0; p < known_points_.size(); ++p) {
    const auto& cell = modes_.mesh().cells[static_cast<std::size_t>(known_points_[p].cell)];
    off_mm.push_back(
        (back * frame_.known_points[p].seen_mm - between(now_mm, cell, known_points_[p].barycentric)).norm());
  }
  // Of a coordinate, from the median of three-dimensional distances (chi with three degrees of freedom: 1.538).
  const double found_mm = upper_median(off_mm) / 1.538;
  const double noise_mm = std::max(frame_.tracking_noise_mm, std::min(found_mm, look.coarsest_mm));
  std::vector<Vector3d> seen_mm;
  for (const SeenPoint& point : frame_.known_points) seen_mm.push_back(point.seen_mm);
  const double share = share_of(seen_mm, look);
  for (std::size_t p = 0; p < known_points_.size(); ++p) {
    const mechanics::PointInMesh& place = known_points_[p];
    const double trust = robust_weight(off_mm[p] / std::sqrt(3.0), noise_mm);
    for (int axis = 0; axis < 3; ++axis) {
      seen.rows.push_back({modes_.mesh().cells[static_cast<std::size_t>(place.cell)], place.barycentric,
                           Vector3d::Unit(axis), back * frame_.known_points[p].seen_mm, noise_mm, trust, share});
    }
  }
}

// How far what is seen lies from where it would be under the known displacement alone, divided by the noise.
VectorXd SeenEquations::residuals(const std::vector<SeenRow>& rows, const VectorXd& known_mm) const {
  VectorXd right(static_cast<Eigen::Index>(rows.size()));
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const SeenRow& row = rows[r];
    Vector3d place = Vector3d::Zero();
    for (int k = 0; k < 4; ++k) {
      if (row.weights[k] == 0) continue;
      place += row.weights[k] * (modes_.mesh().points_mm[static_cast<std::size_t>(row.points[k])] +
                                 known_mm.segment<3>(3 * row.points[k]));
    }
    right[static_cast<Eigen::Index>(r)] = row.direction.dot(row.at_mm - place) * trust_and_share(row) / row.noise_mm;
  }
  return right;
}

MatrixXd SeenEquations::free_columns(const std::vector<SeenRow>& rows, const Further& further, const Isometry3d& off,
                                     double prior_scale, VectorXd& right) const {
  const auto seen = static_cast<Eigen::Index>(rows.size());
  const Eigen::Index others = further.per_unit_mm.cols(), free = 6 + others;
  MatrixXd columns = MatrixXd::Zero(seen + free, free);
  const Vector3d center = modes_.centroid_mm();
  for (Eigen::Index r = 0; r < seen; ++r) {
    const SeenRow& row = rows[static_cast<std::size_t>(r)];
    const double scale = trust_and_share(row) / row.noise_mm;
    columns.block<1, 3>(r, 0) = scale * row.direction.transpose();
    columns.block<1, 3>(r, 3) = scale * (row.at_mm - center).cross(row.direction).transpose();
    for (int k = 0; k < 4 && others > 0; ++k) {
      if (row.weights[k] == 0) continue;
      columns.row(r).tail(others) +=
          scale * row.weights[k] * row.direction.transpose() * further.per_unit_mm.middleRows<3>(3 * row.points[k]);
    }
  }
  const Vector3d shift_mm = off * center - center;
  const Eigen::AngleAxisd turn(off.linear());
  right.conservativeResize(seen + free);
  right.tail(free).setZero();
  const double sd_turn = options_.guess_sd_deg * std::numbers::pi / 180;
  for (int k = 0; k < 3; ++k) {
    columns(seen + k, k) = prior_scale / options_.guess_sd_mm;
    right[seen + k] = -prior_scale * shift_mm[k] / options_.guess_sd_mm;
    columns(seen + 3 + k, 3 + k) = prior_scale / sd_turn;
    right[seen + 3 + k] = -prior_scale * turn.angle() * turn.axis()[k] / sd_turn;
  }
  for (Eigen::Index k = 6; k < free; ++k) columns(seen + k, k) = prior_scale / further.sd;
  return columns;
}

double SeenEquations::squared_off_guess(const Isometry3d& off) const {
  const double shift_mm = (off * modes_.centroid_mm() - modes_.centroid_mm()).norm();
  const double turn_deg = Eigen::AngleAxisd(off.linear()).angle() * 180 / std::numbers::pi;
  return std::pow(shift_mm / options_.guess_sd_mm, 2) + std::pow(turn_deg / options_.guess_sd_deg, 2);
}

MatrixXd SeenEquations::mode_columns(const std::vector<SeenRow>& rows, const RowMatrix& modes_mm, Eigen::Index free) {
  RowMatrix columns = RowMatrix::Zero(static_cast<Eigen::Index>(rows.size()) + free, modes_mm.cols());
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const SeenRow& row = rows[r];
    const double scale = trust_and_share(row) / row.noise_mm;
    if (scale == 0) continue;
    for (int k = 0; k < 4; ++k) {
      if (row.weights[k] == 0) continue;
      for (int axis = 0; axis < 3; ++axis) {
        columns.row(static_cast<Eigen::Index>(r)) +=
            scale * row.weights[k] * row.direction[axis] * modes_mm.row(3 * row.points[k] + axis);
      }
    }
  }
  return columns;
}

std::size_t boxes_of(const std::vector<Vector3d>& points_mm, double spacing_mm) {
  std::set<std::array<long, 3>> boxes;
  for (const Vector3d& point : points_mm) {
    const Vector3d box = point / spacing_mm;
    boxes.insert({std::lround(box[0]), std::lround(box[1]), std::lround(box[2])});
  }
  return boxes.size();
}

Vector3d between(const std::vector<Vector3d>& points_mm, const std::array<int, 4>& points,
                 const Eigen::Vector4d& weights) {
  Vector3d place = Vector3d::Zero();
  for (int k = 0; k < 4; ++k) place += weights[k] * points_mm[static_cast<std::size_t>(points[k])];
  return place;
}

}  // namespace glisson::guidance

// Which of the six rigid motions the supports leave free: those without strain energy that no support resists.

#include <fmt/format.h>
#include <cmath>
#include <Eigen/Geometry>

#include "base/dense.h"
#include "mechanics/elements/quadrature.h"
#include "mechanics/elements/supports.h"

namespace glisson::mechanics {
namespace {

using Matrix6d = Eigen::Matrix<double, 6, 6>;

// A rigid motion moves the point x by t + w x (x - center) / size, with t and w of like magnitude.
struct RigidMotions {
  Eigen::Vector3d center_mm;
  double size_mm;

  [[nodiscard]] Eigen::Matrix<double, 3, 6> displacement_at(const Eigen::Vector3d& x_mm) const {
    const Eigen::Vector3d arm = (x_mm - center_mm) / size_mm;
    Eigen::Matrix<double, 3, 6> motion;
    motion.leftCols<3>().setIdentity();
    motion.rightCols<3>() << 0, arm.z(), -arm.y(), -arm.z(), 0, arm.x(), arm.y(), -arm.x(), 0;
    return motion;
  }
};

Matrix6d resistance(const RigidMotions& rigid, const NodeLayout& layout, const std::vector<BoundaryFace>& boundary,
                    const ResolvedSupports& supports);
std::string describe(const RigidMotions& rigid, const Eigen::MatrixXd& free);
std::string direction_name(const Eigen::Vector3d& direction);
std::string point_name(const Eigen::Vector3d& point_mm);

}  // namespace

std::string free_motion(const NodeLayout& layout, const std::vector<BoundaryFace>& boundary,
                        const ResolvedSupports& supports) {
  const geometry::Box box = geometry::bounding_box(layout.positions_mm);
  const RigidMotions rigid{box.center_mm(), 0.5 * box.diagonal_mm()};
  const SymmetricModes modes = symmetric_modes(resistance(rigid, layout, boundary, supports));
  // The eigenvalues are dimensionless, at most about 2. Supports within 1e-5 of the body's size of a line or a point
  // count as lying on it: their lever is lost in what measured positions round to.
  constexpr double resisted = 1e-10;
  const int free_count = static_cast<int>((modes.values.array() < resisted).count());
  if (free_count == 0) return {};
  return describe(rigid, modes.vectors.leftCols(free_count));
}

namespace {

Matrix6d resistance(const RigidMotions& rigid, const NodeLayout& layout, const std::vector<BoundaryFace>& boundary,
                    const ResolvedSupports& supports) {
  Matrix6d by_fixed = Matrix6d::Zero();
  int fixed_count = 0;
  for (int node = 0; node < layout.nodes(); ++node) {
    const auto motion = rigid.displacement_at(layout.positions_mm[node]);
    for (int d = 0; d < 3; ++d) {
      if (!supports.fixed[3 * static_cast<std::size_t>(node) + d]) continue;
      by_fixed += motion.row(d).transpose() * motion.row(d);
      ++fixed_count;
    }
  }
  Matrix6d by_springs = Matrix6d::Zero();
  double area_mm2 = 0;
  for (const FoundationFace& spring : supports.foundations) {
    const BoundaryFace& face = boundary[spring.face];
    area_mm2 += face.area_mm2;
    for (const TrianglePoint& point : triangle_points_degree_4()) {
      Eigen::Vector3d x_mm = Eigen::Vector3d::Zero();
      for (int i = 0; i < 3; ++i) x_mm += point.barycentric[i] * layout.positions_mm[face.nodes[i]];
      const auto motion = rigid.displacement_at(x_mm);
      by_springs += point.weight * face.area_mm2 * motion.transpose() * motion;
    }
  }
  return by_fixed / std::max(fixed_count, 1) + by_springs / (area_mm2 > 0 ? area_mm2 : 1.0);
}

std::string describe(const RigidMotions& rigid, const Eigen::MatrixXd& free) {
  if (free.cols() == 6) return GLISSON_TEXT("is not held at all");

  // Combinations of the free motions that do not turn are slides; the rest turn.
  const Eigen::MatrixXd turning = free.bottomRows<3>();
  const RightSingular svd = right_singular(turning);
  std::vector<Eigen::VectorXd> slides, turns;
  for (int k = 0; k < free.cols(); ++k) {
    const double turn = k < svd.values.size() ? svd.values[k] : 0.0;
    (turn < 1e-6 ? slides : turns).emplace_back(free * svd.vectors.col(k));
  }

  std::vector<std::string> sentences;
  if (slides.size() == 3) {
    sentences.emplace_back(GLISSON_TEXT("can slide in every direction"));
  } else if (slides.size() == 2) {
    const Eigen::Vector3d across = slides[0].head<3>().cross(slides[1].head<3>());
    sentences.push_back("can slide in the plane across " + direction_name(across));
  } else if (slides.size() == 1) {
    sentences.push_back("can slide along " + direction_name(slides[0].head<3>()));
  }
  if (turns.size() == 3 && slides.empty()) {
    // The point that no turn moves: t + w x (p - center) / size = 0 for all three.
    Eigen::Matrix<double, 9, 3> levers;
    Eigen::Matrix<double, 9, 1> shifts;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d w = turns[k].tail<3>();
      levers.block<3, 3>(3 * k, 0) << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
      shifts.segment<3>(3 * k) = -turns[k].head<3>();
    }
    const Eigen::Vector3d arm = least_squares(levers, shifts);
    sentences.push_back("can turn about the point " + point_name(rigid.center_mm + rigid.size_mm * arm));
  } else {
    for (const Eigen::VectorXd& motion : turns) {
      const Eigen::Vector3d t = motion.head<3>(), w = motion.tail<3>();
      const Eigen::Vector3d on_axis_mm = rigid.center_mm + rigid.size_mm * w.cross(t) / w.squaredNorm();
      sentences.push_back("can turn about the axis through " + point_name(on_axis_mm) + " along " + direction_name(w));
    }
  }
  std::string joined = sentences.front();
  for (std::size_t i = 1; i < sentences.size(); ++i) joined += " and " + sentences[i];
  return joined;
}

std::string direction_name(const Eigen::Vector3d& direction) {
  const Eigen::Vector3d unit = direction.normalized();
  for (int d = 0; d < 3; ++d) {
    if (std::abs(unit[d]) > 0.9999) return std::string(1, "xyz"[d]);
  }
  return fmt::format("({:.2f}, {:.2f}, {:.2f})", unit.x(), unit.y(), unit.z());
}

std::string point_name(const Eigen::Vector3d& point_mm) {
  const auto tidy = [](double value) { return std::abs(value) < 0.05 ? 0.0 : value; };  // no "-0.0"
  return fmt::format("({:.1f}, {:.1f}, {:.1f}) mm", tidy(point_mm.x()), tidy(point_mm.y()), tidy(point_mm.z()));
}

}  // namespace
}  // namespace glisson::mechanics

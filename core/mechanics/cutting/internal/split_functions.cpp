// Functions that reach around the places where they stand (reduced_functions.h), split by a surface. A function whose
// reach the surface crosses acts on its own side alone; on the far side a second one of the same shape takes its place,
// with amplitudes of its own. So nothing reaches across the cut, and on each side all that was there before is there
// still: the visibility criterion (T. Belytschko, Y. Y. Lu, L. Gu, Element-free Galerkin methods, Int. J. Numer. Meth.
// Eng. 37:229, 1994) with the hidden part of each function kept as an unknown (phantom nodes: A. Hansbo, P. Hansbo,
// Comput. Methods Appl. Mech. Eng. 193:3523, 2004; for meshfree functions: T. Rabczuk, G. Zi, Comput. Mech. 39:743,
// 2007). No weight is measured again as the front goes on, which the diffraction method (D. Organ, M. Fleming, T.
// Terry, T. Belytschko, Comput. Mech. 18:225, 1996) would have to do around it.
//
// With q the functions' unknowns, P how nodes follow them and a_n what the function n does more on its far side,
//   u = P q + sum over n of s_n P_n a_n on the far side of n, s_n = 1 where that is above and -1 below,
//   B_n = s_n K_far P_n,   D_nm = P_n^T K_far P_m on one far side and 0 on two,   jump = sum of P_n a_n,
// where K_above + K_below = K are the stiffness of the body's two parts, crossed cells divided. Integrals are exact.

#include <algorithm>
#include <array>
#include <limits>
#include <map>

#include "mechanics/cutting/internal/body_parts.h"
#include "mechanics/cutting/internal/opening_functions.h"

namespace glisson::mechanics {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::SparseMatrix;
using Eigen::Vector3d;
using Eigen::VectorXd;

class SplitFunctions : public OpeningFunctions {
 public:
  SplitFunctions(const Body& body, const Crossing& crossing, const ReducedFunctions& reduced, const Vector3d& begin_mm,
                 const Vector3d& forward);

  [[nodiscard]] MatrixXd stiffness_between(const std::vector<int>& rows,
                                           const std::vector<int>& columns) const override;
  [[nodiscard]] VectorXd load_on(const Loads& loads) const override;
  void take_off(const SeenPart& part, const std::vector<int>& functions, MatrixXd& seen_mm) const override;
  [[nodiscard]] VectorXd of_nodes_mm(int function, const VectorXd& amplitudes_mm) const override;
  [[nodiscard]] bool meets(int function, const OpeningFunctions& others, int other) const override;

 private:
  [[nodiscard]] double sign(int function) const { return far_[static_cast<std::size_t>(function)] == above ? 1 : -1; }
  [[nodiscard]] auto columns_of(int function) const { return all_.middleCols(Index{size} * function, size); }
  // Those that are split, in the order in which the front comes to them.
  std::vector<int> in_order(const ReducedFunctions& reduced, const Vector3d& begin_mm, const Vector3d& forward);
  void find_far_sides();
  void find_jumps();

  const Body& body_;
  const Crossing& crossing_;
  BodyParts parts_;
  std::vector<Side> far_;
  SparseMatrix<double> all_;      // P of these functions
  SparseMatrix<double> between_;  // D
};

// The columns of those functions alone whose far side is that one; the others' are empty.
SparseMatrix<double> acting_on(Side side, const SparseMatrix<double>& all, const std::vector<Side>& far, int size);

}  // namespace

std::unique_ptr<const OpeningFunctions> split_functions(const Body& body, const Crossing& crossing,
                                                        const ReducedFunctions& reduced, const Vector3d& begin_mm,
                                                        const Vector3d& forward) {
  return std::make_unique<SplitFunctions>(body, crossing, reduced, begin_mm, forward);
}

namespace {

SplitFunctions::SplitFunctions(const Body& body, const Crossing& crossing, const ReducedFunctions& reduced,
                               const Vector3d& begin_mm, const Vector3d& forward)
    : body_(body), crossing_(crossing), parts_(body, crossing) {
  size = reduced.unknowns();
  all_ = reduced.columns(in_order(reduced, begin_mm, forward));
  find_far_sides();
  std::vector<std::uint8_t> counts(body.mesh.points_mm.size(), 0);
  std::vector<std::uint8_t> reached(static_cast<std::size_t>(body.layout.nodes()), 0);
  for (Index column = 0; column < all_.cols(); ++column) {
    for (SparseMatrix<double>::InnerIterator entry(all_, column); entry; ++entry) {
      reached[static_cast<std::size_t>(entry.row() / 3)] = 1;
    }
  }
  for (std::size_t p = 0; p < counts.size(); ++p) {
    const int node = body.layout.node_of_point[p];
    counts[p] = node >= 0 ? reached[static_cast<std::size_t>(node)] : 0;
  }
  const SparseMatrix<double> of_above = acting_on(above, all_, far_, size),
                             of_below = acting_on(below, all_, far_, size);
  const SparseMatrix<double> pushed_above = parts_.stiffness(above, counts, reduced.springs_mN_mm()) * of_above;
  const SparseMatrix<double> pushed_below = parts_.stiffness(below, counts, reduced.springs_mN_mm()) * of_below;
  coupling = pushed_above - pushed_below;
  between_ = SparseMatrix<double>(of_above.transpose()) * pushed_above +
             SparseMatrix<double>(of_below.transpose()) * pushed_below;
  find_jumps();
}

std::vector<int> SplitFunctions::in_order(const ReducedFunctions& reduced, const Vector3d& begin_mm,
                                          const Vector3d& forward) {
  std::map<int, std::vector<int>> crossed;
  for (std::size_t p = 0; p < crossing_.cells_of_point.size(); ++p) {
    if (crossing_.cells_of_point[p].empty()) continue;
    for (const int function : reduced.acting_on(static_cast<int>(p))) crossed[function].push_back(static_cast<int>(p));
  }
  std::vector<std::pair<double, int>> order;
  for (const auto& [function, points] : crossed) {
    double first_mm = std::numeric_limits<double>::infinity();
    for (const int p : points) first_mm = std::min(first_mm, (body_.mesh.points_mm[p] - begin_mm).dot(forward));
    order.emplace_back(first_mm, function);
  }
  std::sort(order.begin(), order.end());
  std::vector<int> functions;
  for (const auto& [first_mm, function] : order) {
    functions.push_back(function);
    at_mm.push_back(first_mm);
    points_of.push_back(crossed[function]);
  }
  return functions;
}

// Its own side is where more of it lies.
void SplitFunctions::find_far_sides() {
  far_.clear();
  for (Index first = 0; first < all_.cols(); first += size) {
    double of_above = 0, of_below = 0;
    for (SparseMatrix<double>::InnerIterator entry(all_, first); entry; ++entry) {
      (parts_.height_mm(static_cast<int>(entry.row() / 3)) > 0 ? of_above : of_below) += entry.value() * entry.value();
    }
    far_.push_back(of_above > of_below ? below : above);
  }
}

void SplitFunctions::find_jumps() {
  const std::size_t points = body_.mesh.points_mm.size();
  std::vector<Eigen::Triplet<double>> at_points;
  std::vector<int> point_of_node(static_cast<std::size_t>(body_.layout.nodes()), -1);
  for (std::size_t p = 0; p < points; ++p) {
    if (!crossing_.cells_of_point[p].empty()) point_of_node[body_.layout.node_of_point[p]] = static_cast<int>(p);
  }
  for (Index column = 0; column < all_.cols(); ++column) {
    for (SparseMatrix<double>::InnerIterator entry(all_, column); entry; ++entry) {
      const int point = point_of_node[static_cast<std::size_t>(entry.row() / 3)];
      if (point < 0) continue;
      at_points.emplace_back(3 * point + static_cast<int>(entry.row() % 3), static_cast<int>(column), entry.value());
    }
  }
  jumps.resize(3 * static_cast<Index>(points), all_.cols());
  jumps.setFromTriplets(at_points.begin(), at_points.end());
}

MatrixXd SplitFunctions::stiffness_between(const std::vector<int>& rows, const std::vector<int>& columns) const {
  std::vector<int> row_of(points_of.size(), -1);
  for (std::size_t i = 0; i < rows.size(); ++i) row_of[rows[i]] = static_cast<int>(i);
  MatrixXd stiffness =
      MatrixXd::Zero(Index{size} * static_cast<Index>(rows.size()), Index{size} * static_cast<Index>(columns.size()));
  for (std::size_t j = 0; j < columns.size(); ++j) {
    for (int c = 0; c < size; ++c) {
      for (SparseMatrix<double>::InnerIterator entry(between_, Index{size} * columns[j] + c); entry; ++entry) {
        const int row = row_of[static_cast<std::size_t>(entry.row() / size)];
        if (row < 0) continue;
        stiffness(Index{size} * row + entry.row() % size, Index{size} * static_cast<Index>(j) + c) = entry.value();
      }
    }
  }
  return stiffness;
}

VectorXd SplitFunctions::load_on(const Loads& loads) const {
  const std::array<VectorXd, 2> on_part{parts_.load_mN(below, loads), parts_.load_mN(above, loads)};
  double pressure_kPa = 0;
  for (const Load& load : loads) {
    if (const auto* pressure = std::get_if<PressureLoad>(&load)) pressure_kPa += pressure->pressure_kPa;
  }
  // Gas presses on the walls too.
  VectorXd on_jumps = VectorXd::Zero(jumps.rows());
  for (const CrossedCell& cut : crossing_.cells) {
    for (int i = 0; i < 4 && pressure_kPa != 0; ++i) {
      on_jumps.segment<3>(3 * Index{body_.mesh.cells[cut.cell][i]}) +=
          pressure_kPa * cut.wall_area_mm2 * cut.wall_centroid[i] * cut.wall_normal;
    }
  }
  VectorXd force_mN = jumps.transpose() * on_jumps;
  for (int f = 0; f < static_cast<int>(far_.size()); ++f) {
    force_mN.segment(Index{size} * f, size) += sign(f) * (columns_of(f).transpose() * on_part[far_[f]]);
  }
  return force_mN;
}

void SplitFunctions::take_off(const SeenPart& part, const std::vector<int>& functions, MatrixXd& seen_mm) const {
  std::vector<double> height_mm;  // of three rows each
  for (const int point : part.points) height_mm.push_back(point < 0 ? 0.0 : crossing_.height_mm[point]);
  for (const SeenPart::Place& place : part.places) {
    double& there_mm = height_mm[static_cast<std::size_t>(place.row / 3)];
    for (int i = 0; i < 4; ++i) {
      there_mm += place.at.barycentric[i] * crossing_.height_mm[body_.mesh.cells[place.at.cell][i]];
    }
  }
  for (std::size_t i = 0; i < functions.size(); ++i) {
    const int f = functions[i];
    const MatrixXd everywhere_mm = part.of_nodes(MatrixXd(columns_of(f)));
    for (std::size_t r = 0; r < height_mm.size(); ++r) {
      if ((height_mm[r] > 0 ? above : below) != far_[f]) continue;
      seen_mm.block(3 * static_cast<Index>(r), Index{size} * static_cast<Index>(i), 3, size) -=
          sign(f) * everywhere_mm.middleRows<3>(3 * static_cast<Index>(r));
    }
  }
}

VectorXd SplitFunctions::of_nodes_mm(int function, const VectorXd& amplitudes_mm) const {
  VectorXd moved_mm = sign(function) * (columns_of(function) * amplitudes_mm);
  for (Index node = 0; node < moved_mm.size() / 3; ++node) {
    if ((parts_.height_mm(static_cast<int>(node)) > 0 ? above : below) != far_[function]) {
      moved_mm.segment<3>(3 * node).setZero();
    }
  }
  return moved_mm;
}

bool SplitFunctions::meets(int function, const OpeningFunctions& others, int other) const {
  const auto& of_others = static_cast<const SplitFunctions&>(others).all_;
  SparseMatrix<double>::InnerIterator here(all_, Index{size} * function), there(of_others, Index{size} * other);
  while (here && there) {
    if (here.row() == there.row()) return true;
    if (here.row() < there.row()) {
      ++here;
    } else {
      ++there;
    }
  }
  return false;
}

SparseMatrix<double> acting_on(Side side, const SparseMatrix<double>& all, const std::vector<Side>& far, int size) {
  SparseMatrix<double> part = all;
  part.prune([&](Index, Index column, double) { return far[static_cast<std::size_t>(column / size)] == side; });
  return part;
}

}  // namespace
}  // namespace glisson::mechanics

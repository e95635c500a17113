#include "closedloop/fullfield/internal/plane_elements.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/OrderingMethods>
#include <map>

#include "base/result.h"

namespace glisson::closedloop {
namespace {

// Derivatives of the shape functions by the two area coordinates, a row a point.
Eigen::Matrix<double, Eigen::Dynamic, 2> shape_slopes(ElementOrder order, double r, double t) {
  Eigen::Matrix<double, Eigen::Dynamic, 2> slopes;
  if (order == ElementOrder::linear) {
    slopes.resize(3, 2);
    slopes << -1, -1, 1, 0, 0, 1;
  } else {
    const double l = 1 - r - t;
    slopes.resize(6, 2);
    slopes << 1 - 4 * l, 1 - 4 * l, 4 * r - 1, 0, 0, 4 * t - 1, 4 * (l - r), -4 * r, 4 * t, 4 * r, -4 * t, 4 * (l - t);
  }
  return slopes;
}

}  // namespace

PlaneElements::PlaneElements(const std::vector<Eigen::Vector2d>& points,
                             const std::vector<std::array<int, 3>>& triangles, const std::vector<bool>& fixed,
                             ElementOrder order) {
  std::vector<Eigen::Vector2d> all = points;
  std::vector<bool> is_fixed = fixed;
  std::vector<std::vector<int>> elements;
  std::map<std::array<int, 2>, std::pair<int, int>> middles;  // of a side: its point, and how many triangles share it
  for (const auto& triangle : triangles) {
    std::vector<int> element(triangle.begin(), triangle.end());
    for (int side = 0; order == ElementOrder::quadratic && side < 3; ++side) {
      const int a = triangle[static_cast<std::size_t>(side)], b = triangle[static_cast<std::size_t>((side + 1) % 3)];
      auto& [point, shared] =
          middles.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<int>(all.size()), 0).first->second;
      if (shared++ == 0) {
        all.push_back((points[static_cast<std::size_t>(a)] + points[static_cast<std::size_t>(b)]) / 2);
        ends_.push_back({a, b});
      }
      element.push_back(point);
    }
    elements.push_back(std::move(element));
  }
  is_fixed.resize(2 * all.size(), false);
  for (const auto& [ends, middle] : middles) {
    for (std::size_t d = 0; d < 2 && middle.second == 1; ++d)
      is_fixed[2 * static_cast<std::size_t>(middle.first) + d] =
          fixed[2 * static_cast<std::size_t>(ends[0]) + d] && fixed[2 * static_cast<std::size_t>(ends[1]) + d];
  }

  freedoms_ = 2 * static_cast<Eigen::Index>(all.size());
  per_element_ = order == ElementOrder::linear ? 6 : 12;
  places_per_element_ = order == ElementOrder::linear ? 1 : 3;
  const std::array<Eigen::Vector2d, 3> places{Eigen::Vector2d(1.0 / 6, 1.0 / 6), Eigen::Vector2d(2.0 / 3, 1.0 / 6),
                                              Eigen::Vector2d(1.0 / 6, 2.0 / 3)};
  for (const auto& element : elements) {
    for (const int point : element) {
      element_freedoms_.push_back(2 * point);
      element_freedoms_.push_back(2 * point + 1);
    }
    for (int q = 0; q < places_per_element_; ++q) {
      const auto slopes =
          shape_slopes(order, places[static_cast<std::size_t>(q)].x(), places[static_cast<std::size_t>(q)].y());
      Eigen::Matrix2d map = Eigen::Matrix2d::Zero();
      for (std::size_t a = 0; a < element.size(); ++a)
        map += all[static_cast<std::size_t>(element[a])] * slopes.row(static_cast<Eigen::Index>(a));
      const Eigen::Matrix<double, Eigen::Dynamic, 2> by_place = slopes * map.inverse();
      Gradient gradient = Gradient::Zero(4, per_element_);
      for (Eigen::Index a = 0; a < by_place.rows(); ++a) {
        gradient.block<2, 1>(0, 2 * a) = by_place.row(a).transpose();
        gradient.block<2, 1>(2, 2 * a + 1) = by_place.row(a).transpose();
      }
      gradients_.push_back(std::move(gradient));
      areas_.push_back(map.determinant() / 2 / places_per_element_);
    }
  }
  free_.assign(static_cast<std::size_t>(freedoms_), -1);
  for (std::size_t i = 0; i < free_.size(); ++i) {
    if (is_fixed[i]) continue;
    free_[i] = static_cast<int>(all_free_.size());
    all_free_.push_back(static_cast<int>(i));
  }
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& point : points) box.extend(point);
  size_ = box.diagonal().norm();
  number_to_fill_little();
  find_places();
}

// The lower half.
Eigen::SparseMatrix<double> PlaneElements::pattern_of_free() const {
  const auto n = static_cast<Eigen::Index>(all_free_.size());
  const auto each = static_cast<std::size_t>(per_element_);
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t first = 0; first < element_freedoms_.size(); first += each) {
    for (std::size_t a = first; a < first + each; ++a) {
      for (std::size_t b = first; b < first + each; ++b) {
        const int i = free_[static_cast<std::size_t>(element_freedoms_[a])];
        const int j = free_[static_cast<std::size_t>(element_freedoms_[b])];
        if (i >= j && j >= 0) entries.emplace_back(i, j, 1.0);
      }
    }
  }
  Eigen::SparseMatrix<double> pattern(n, n);
  pattern.setFromTriplets(entries.begin(), entries.end());
  pattern.makeCompressed();
  return pattern;
}

// By approximate minimum degree, once for all factors.
void PlaneElements::number_to_fill_little() {
  const Eigen::SparseMatrix<double> whole = pattern_of_free().selfadjointView<Eigen::Lower>();
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> inverse;
  Eigen::AMDOrdering<int>()(whole, inverse);
  const auto order = inverse.inverse().eval();
  const std::vector<int> before = all_free_;
  for (std::size_t old = 0; old < before.size(); ++old) {
    const int now = order.indices()[static_cast<Eigen::Index>(old)];
    all_free_[static_cast<std::size_t>(now)] = before[old];
    free_[static_cast<std::size_t>(before[old])] = now;
  }
}

void PlaneElements::find_places() {
  pattern_ = pattern_of_free();
  const auto each = static_cast<std::size_t>(per_element_);
  places_in_pattern_.reserve(element_freedoms_.size() * each);
  for (std::size_t first = 0; first < element_freedoms_.size(); first += each) {
    for (std::size_t b = first; b < first + each; ++b) {  // columns, as a matrix of an element stands in memory
      for (std::size_t a = first; a < first + each; ++a) {
        const int i = free_[static_cast<std::size_t>(element_freedoms_[a])];
        const int j = free_[static_cast<std::size_t>(element_freedoms_[b])];
        int place = -1;
        if (i >= j && j >= 0) {
          const int* begin = pattern_.innerIndexPtr() + pattern_.outerIndexPtr()[j];
          const int* end = pattern_.innerIndexPtr() + pattern_.outerIndexPtr()[j + 1];
          place = static_cast<int>(std::lower_bound(begin, end, i) - pattern_.innerIndexPtr());
        }
        places_in_pattern_.push_back(place);
      }
    }
  }
}

Eigen::VectorXd PlaneElements::prolonged(const Eigen::VectorXd& of_mesh) const {
  Eigen::VectorXd all(freedoms_);
  const Eigen::Index first = freedoms_ - 2 * static_cast<Eigen::Index>(ends_.size());
  all.head(first) = of_mesh.head(first);
  for (std::size_t i = 0; i < ends_.size(); ++i)
    all.segment<2>(first + 2 * static_cast<Eigen::Index>(i)) =
        (of_mesh.segment<2>(2 * ends_[i][0]) + of_mesh.segment<2>(2 * ends_[i][1])) / 2;
  return all;
}

template <bool WithTangent, typename Each>
bool PlaneElements::over_elements(const PlaneLaw& law, const Eigen::VectorXd& displacement, Each&& each) const {
  const auto width = static_cast<std::size_t>(per_element_);
  const std::size_t count = element_freedoms_.size() / width;
  const auto places = static_cast<std::size_t>(places_per_element_);
  Local local(per_element_), force(per_element_);
  LocalMatrix stiffness(per_element_, per_element_);
  for (std::size_t e = 0; e < count; ++e) {
    const int* freedoms = element_freedoms_.data() + e * width;
    for (Eigen::Index i = 0; i < per_element_; ++i) local[i] = displacement[freedoms[i]];
    force.setZero();
    if constexpr (WithTangent) stiffness.setZero();
    for (std::size_t q = e * places; q < (e + 1) * places; ++q) {
      const Eigen::Vector4d deformation = Eigen::Vector4d(1, 0, 0, 1) + gradients_[q] * local;
      if (!(deformation[0] * deformation[3] - deformation[1] * deformation[2] > 0)) return false;
      PlaneStress at;
      add_stress(law, deformation, WithTangent, at);
      if (!at.stress.allFinite()) return false;
      force.noalias() += areas_[q] * (gradients_[q].transpose() * at.stress);
      if constexpr (WithTangent) {
        const Gradient through = areas_[q] * (at.tangent * gradients_[q]);
        stiffness.noalias() += gradients_[q].transpose() * through;
      }
    }
    each(e, freedoms, force, stiffness);
  }
  return true;
}

std::optional<Eigen::VectorXd> PlaneElements::forces(const PlaneLaw& law, const Eigen::VectorXd& displacement) const {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(freedoms_);
  const bool fine = over_elements<false>(law, displacement,
                                         [&](std::size_t, const int* freedoms, const Local& force, const LocalMatrix&) {
                                           for (Eigen::Index i = 0; i < per_element_; ++i) sum[freedoms[i]] += force[i];
                                         });
  return fine ? std::optional(std::move(sum)) : std::nullopt;
}

std::optional<PlaneElements::Tangent> PlaneElements::tangent(const PlaneLaw& law, const Eigen::VectorXd& displacement,
                                                             const Eigen::MatrixXd& moves) const {
  Tangent tangent{nullptr, Eigen::MatrixXd::Zero(freedoms_, moves.cols()), Eigen::VectorXd::Zero(freedoms_)};
  Eigen::SparseMatrix<double> matrix = pattern_;
  double* values = matrix.valuePtr();
  std::fill(values, values + matrix.nonZeros(), 0.0);
  const auto square = static_cast<std::size_t>(per_element_ * per_element_);
  const bool fine = over_elements<true>(
      law, displacement, [&](std::size_t e, const int* freedoms, const Local& force, const LocalMatrix& stiffness) {
        const int* places = places_in_pattern_.data() + e * square;
        for (std::size_t i = 0; i < square; ++i) {
          if (places[i] >= 0) values[places[i]] += stiffness.data()[i];
        }
        for (Eigen::Index i = 0; i < per_element_; ++i) {
          tangent.forces[freedoms[i]] += force[i];
          for (Eigen::Index j = 0; j < per_element_; ++j) {
            if (free_[static_cast<std::size_t>(freedoms[j])] < 0)
              tangent.along.row(freedoms[i]) += stiffness(i, j) * moves.row(freedoms[j]);
          }
        }
      });
  if (!fine) return std::nullopt;
  auto factor = std::make_shared<Factor>();
  factor->compute(matrix);
  if (factor->info() != Eigen::Success) return std::nullopt;
  tangent.factor = std::move(factor);
  return tangent;
}

Eigen::VectorXd PlaneElements::solved(const Factor& factor, const Eigen::VectorXd& forces) const {
  const Eigen::VectorXd of_free = factor.solve(Eigen::VectorXd(forces(all_free_)));
  Eigen::VectorXd all = Eigen::VectorXd::Zero(freedoms_);
  all(all_free_) = of_free;
  return all;
}

std::optional<Eigen::VectorXd> PlaneElements::equilibrium(const PlaneLaw& law, const Eigen::VectorXd& start,
                                                          const Eigen::VectorXd& prescribed) const {
  constexpr int maximum_steps = 25;
  constexpr double settled = 1e-9;  // of the body's size: a change that no measurement shows
  Eigen::VectorXd displacement = start;
  Eigen::VectorXd move = Eigen::VectorXd::Zero(freedoms_);
  for (std::size_t i = 0; i < free_.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    if (free_[i] < 0) move[at] = prescribed[at] - start[at];
  }
  for (int step = 0; step < maximum_steps; ++step) {
    const auto here = tangent(law, displacement, move);
    if (!here) return std::nullopt;
    Eigen::VectorXd change = solved(*here->factor, -here->forces - here->along.col(0)) + move;
    if (!change.allFinite()) return std::nullopt;
    // No further than where every triangle keeps its sense.
    double share = 1;
    std::optional<Eigen::VectorXd> ahead;
    while (share > 1e-2 && !(ahead = forces(law, displacement + share * change))) share /= 2;
    if (!ahead) return std::nullopt;
    displacement += share * change;
    move *= 1 - share;
    if (share == 1) {
      move.setZero();
      if (change.lpNorm<Eigen::Infinity>() < settled * size_) return displacement;
    }
  }
  return std::nullopt;
}

std::optional<Eigen::VectorXd> PlaneElements::equilibrium_from_rest(const PlaneLaw& law,
                                                                    const Eigen::VectorXd& prescribed) const {
  constexpr double smallest_step = 1e-3;
  Eigen::VectorXd displacement = Eigen::VectorXd::Zero(freedoms_);
  double reached = 0, step = 0.25;
  while (reached < 1) {
    const double next = std::min(1.0, reached + step);
    auto there = equilibrium(law, displacement, next * prescribed);
    if (there) {
      displacement = *std::move(there);
      reached = next;
      step *= 1.5;
    } else if ((step /= 2) < smallest_step) {
      return std::nullopt;
    }
  }
  return displacement;
}

}  // namespace glisson::closedloop

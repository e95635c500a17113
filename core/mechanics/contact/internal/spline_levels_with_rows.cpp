// The levels with rows beside them: which press, and what is answered then.

#include <algorithm>
#include <Eigen/LU>
#include <map>

#include "mechanics/contact/internal/dense_product.h"
#include "mechanics/contact/internal/spline_levels.h"

namespace glisson::mechanics {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::MatrixXf;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Eigen::VectorXf;

SplineLevels::WithRows::WithRows(const SplineLevels& levels, const std::vector<StiffRow>& rows, int further,
                                 VectorXd alone, const CutLevel* cut)
    : levels_(levels),
      rows_(rows),
      seen_(condensed(rows)),
      cut_(cut),
      further_(further),
      alone_(std::move(alone)),
      presses_(rows.size(), 0) {
  double stiffest = 1;
  for (const StiffRow& row : rows) stiffest = std::max(stiffest, row.stiffness);
  soft_ = 1e-4 * stiffest;
  find_shares();
  to_alone_ = answer_without_rows(alone_);
  seen_alone_mm_ = seen_of(to_alone_, alone_);
  compliance_mm_mN_ = compliance();
  VectorXd gap_mm = seen_.shares * seen_alone_mm_;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    gap_mm[static_cast<Eigen::Index>(r)] += rows[r].gap_mm;
    presses_[r] = rows[r].two_sided || rows[r].gap_mm < 0;
  }
  choose(std::move(gap_mm));
}

// What the functionals see of either lattice.
void SplineLevels::WithRows::find_shares() {
  const SplineLattice& lattice = levels_.lattice_;
  const auto count = static_cast<Eigen::Index>(seen_.functionals.size());
  std::vector<int> narrow_at(static_cast<std::size_t>(lattice.points()), -1);
  std::vector<int> used_at(static_cast<std::size_t>(lattice.wide_points()), -1);
  std::vector<SplineLattice::Shares<Eigen::Vector3f>> wide(seen_.functionals.size());
  narrow_.resize(seen_.functionals.size());
  const auto nodes = static_cast<int>(levels_.inverse_diagonal_.size());
  if (cut_ != nullptr) of_cut_ = MatrixXf::Zero(cut_->values(), count);
  for (std::size_t r = 0; r < seen_.functionals.size(); ++r) {
    for (const auto& [node, direction] : seen_.functionals[r].on) {
      Eigen::Vector3f free = direction.cast<float>();
      const bool is_node = node < nodes;
      for (int d = 0; is_node && d < 3; ++d) {
        if (lattice.is_fixed(node, d)) free[d] = 0;
      }
      if (cut_ != nullptr) {
        for (const auto& [function, weight] : cut_->around(node)) {
          of_cut_.col(static_cast<Eigen::Index>(r)).segment<3>(3 * function) += weight * free;
        }
      }
      if (!is_node) continue;
      for (const auto& [point, weight] : levels_.wide_of_node_[static_cast<std::size_t>(node)]) {
        int& at = used_at[static_cast<std::size_t>(point)];
        if (at < 0) {
          at = static_cast<int>(used_.size());
          used_.push_back(point);
        }
        wide[r].emplace_back(at, weight * free);
      }
      for (const auto& [point, weight] : lattice.around(node)) {
        int& at = narrow_at[static_cast<std::size_t>(point)];
        if (at < 0) {
          at = static_cast<int>(narrow_[r].size());
          narrow_[r].emplace_back(point, Eigen::Vector3f::Zero());
        }
        narrow_[r][static_cast<std::size_t>(at)].second += weight * free;
      }
    }
    for (const auto& share : narrow_[r]) narrow_at[static_cast<std::size_t>(share.first)] = -1;
  }
  wide_ = MatrixXf::Zero(3 * static_cast<Eigen::Index>(used_.size()), count);
  for (std::size_t r = 0; r < wide.size(); ++r) {
    for (const auto& [at, value] : wide[r]) wide_.col(static_cast<Eigen::Index>(r)).segment<3>(3 * at) += value;
  }
}

MatrixXd SplineLevels::WithRows::compliance() const {
  // Of the wide inverse only what is seen.
  MatrixXf between(wide_.rows(), wide_.rows());
  for (std::size_t u = 0; u < used_.size(); ++u) {
    const auto columns = levels_.wide_inverse_.middleCols<3>(3 * used_[u]);
    for (std::size_t v = 0; v < used_.size(); ++v) {
      between.block<3, 3>(3 * static_cast<Eigen::Index>(v), 3 * static_cast<Eigen::Index>(u)) =
          columns.middleRows<3>(3 * used_[v]);
    }
  }
  const MatrixXf answers = between * wide_;
  MatrixXd sum = (wide_.transpose() * answers).cast<double>();
  if (cut_ != nullptr) sum += (of_cut_.transpose() * cut_->inverse() * of_cut_).cast<double>();
  add_own(sum);
  return sum;
}

// What functionals answer to each other by what they share: points of the narrow lattice, nodes, and further unknowns.
void SplineLevels::WithRows::add_own(MatrixXd& sum) const {
  MatrixXd own = MatrixXd::Zero(sum.rows(), sum.cols());  // below the diagonal and on it
  std::vector<std::vector<std::pair<Eigen::Index, Eigen::Vector3f>>> at_point(
      static_cast<std::size_t>(levels_.lattice_.points()));
  std::map<int, std::vector<std::pair<Eigen::Index, Vector3d>>> at_node;
  for (Eigen::Index r = 0; r < sum.rows(); ++r) {
    const auto row = static_cast<std::size_t>(r);
    for (const auto& [point, value] : narrow_[row]) at_point[static_cast<std::size_t>(point)].emplace_back(r, value);
    for (const auto& [node, direction] : seen_.functionals[row].on) at_node[node].emplace_back(r, direction);
    const LinearFunctional& functional = seen_.functionals[row];
    for (Eigen::Index s = 0; functional.further >= 0 && s <= r; ++s) {
      const LinearFunctional& other = seen_.functionals[static_cast<std::size_t>(s)];
      if (other.further == functional.further) own(r, s) += functional.along * other.along / soft_;
    }
  }
  const auto add = [&own](const auto& sharing, const auto& inverse) {
    for (std::size_t i = 0; i < sharing.size(); ++i) {
      const auto answered = (inverse * sharing[i].second).eval();
      for (std::size_t j = 0; j <= i; ++j) {
        own(sharing[i].first, sharing[j].first) += double{answered.dot(sharing[j].second)};
      }
    }
  };
  for (std::size_t p = 0; p < at_point.size(); ++p) add(at_point[p], levels_.narrow_inverse_[p]);
  for (const auto& [node, sharing] : at_node) add(sharing, own_inverse(node));
  sum += own;
  sum += own.triangularView<Eigen::StrictlyLower>().transpose();
}

// Which press: those whose gap would close under the forces of the others. With S the shares of those that press and K
// their stiffness, functionals that see v are answered with -(I + S^T K S C)^-1 S^T K S v, C being their compliance.
void SplineLevels::WithRows::choose(const VectorXd& gap_mm) {
  constexpr int most_changes = 20;
  for (int change = 0;; ++change) {
    const Pressing pressing = those_that_press(gap_mm);
    const Eigen::SparseMatrix<double> held_mN_mm =
        pressing.shares.transpose() * pressing.stiffness.asDiagonal() * pressing.shares;
    const MatrixXd compliance_mm_mN = compliance_mm_mN_(pressing.sees, pressing.sees);
    MatrixXd matrix = held_mN_mm * compliance_mm_mN;
    matrix.diagonal().array() += 1;
    const Eigen::PartialPivLU<MatrixXd> factor(matrix);
    bool changed = false;
    if (change < most_changes) {
      const VectorXd push_mN = pressing.shares.transpose() * (-pressing.stiffness.cwiseProduct(pressing.gap_mm));
      const VectorXd force_mN = factor.solve(push_mN);
      const VectorXd moved_mm = compliance_mm_mN_(Eigen::all, pressing.sees) * force_mN;
      const VectorXd after_mm = gap_mm + seen_.shares * moved_mm;
      for (std::size_t r = 0; r < rows_.size(); ++r) {
        const bool presses = rows_[r].two_sided || after_mm[static_cast<Eigen::Index>(r)] < 0;
        changed = changed || presses != this->presses(r);
        presses_[r] = presses;
      }
    }
    if (changed) continue;
    inverse_ = MatrixXd::Zero(compliance_mm_mN_.rows(), compliance_mm_mN_.cols());
    const MatrixXd answers_mN_mm = factor.solve(MatrixXd(held_mN_mm));
    inverse_(pressing.sees, pressing.sees) = answers_mN_mm;
    return;
  }
}

SplineLevels::WithRows::Pressing SplineLevels::WithRows::those_that_press(const VectorXd& gap_mm) const {
  Pressing pressing;
  std::vector<int> at(seen_.functionals.size(), -1);
  std::vector<Eigen::Triplet<double>> shares;
  std::vector<Eigen::Index> pressing_rows;
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    if (!presses(r)) continue;
    for (SeenShares::InnerIterator share(seen_.shares, static_cast<Eigen::Index>(r)); share; ++share) {
      int& column = at[static_cast<std::size_t>(share.col())];
      if (column < 0) {
        column = static_cast<int>(pressing.sees.size());
        pressing.sees.push_back(share.col());
      }
      shares.emplace_back(static_cast<int>(pressing_rows.size()), column, share.value());
    }
    pressing_rows.push_back(static_cast<Eigen::Index>(r));
  }
  const auto count = static_cast<Eigen::Index>(pressing_rows.size());
  pressing.shares.resize(count, static_cast<Eigen::Index>(pressing.sees.size()));
  pressing.shares.setFromTriplets(shares.begin(), shares.end());
  pressing.gap_mm = gap_mm(pressing_rows);
  pressing.stiffness.resize(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    pressing.stiffness[i] = rows_[static_cast<std::size_t>(pressing_rows[static_cast<std::size_t>(i)])].stiffness;
  }
  return pressing;
}

SplineLevels::WithRows::Answer SplineLevels::WithRows::answer_without_rows(const VectorXd& r) const {
  Answer answer;
  const SplineLattice& lattice = levels_.lattice_;
  lattice.down(r, answer.narrow);
  VectorXf wide;
  lattice.down_to_wide(answer.narrow, wide);
  multiply(levels_.wide_inverse_, wide, answer.wide);
  for (std::size_t p = 0; p < levels_.narrow_inverse_.size(); ++p) {
    answer.narrow[p].head<3>() = (levels_.narrow_inverse_[p] * answer.narrow[p].head<3>()).eval();
  }
  if (cut_ != nullptr) answer.cut = cut_->answer(r);
  return answer;
}

const Matrix3d& SplineLevels::WithRows::own_inverse(int unknown) const {
  const auto nodes = static_cast<int>(levels_.inverse_diagonal_.size());
  return unknown < nodes ? levels_.inverse_diagonal_[static_cast<std::size_t>(unknown)]
                         : cut_->own_inverse(unknown - nodes);
}

VectorXd SplineLevels::WithRows::seen_of(const Answer& answer, const VectorXd& r) const {
  VectorXf wide(wide_.rows());
  for (std::size_t u = 0; u < used_.size(); ++u) {
    wide.segment<3>(3 * static_cast<Eigen::Index>(u)) = answer.wide.segment<3>(3 * used_[u]);
  }
  VectorXd seen = (wide_.transpose() * wide).cast<double>();
  if (cut_ != nullptr) seen += (of_cut_.transpose() * answer.cut).cast<double>();
  const auto after = r.size() - further_;
  for (std::size_t i = 0; i < seen_.functionals.size(); ++i) {
    const LinearFunctional& functional = seen_.functionals[i];
    double& of_it = seen[static_cast<Eigen::Index>(i)];
    for (const auto& [point, value] : narrow_[i]) {
      of_it += double{value.dot(answer.narrow[static_cast<std::size_t>(point)].head<3>())};
    }
    for (const auto& [node, direction] : functional.on) {
      of_it += direction.dot(own_inverse(node) * r.segment<3>(3 * node));
    }
    if (functional.further >= 0) of_it -= functional.along * r[after + functional.further] / soft_;
  }
  return seen;
}

void SplineLevels::WithRows::apply(const VectorXd& r, VectorXd& z) const {
  Answer answer = answer_without_rows(r);
  // The forces with which the rows answer what they would see.
  const VectorXd force_mN = -inverse_ * seen_of(answer, r);
  VectorXd rest = r;
  push(force_mN, rest);
  add_answers(force_mN, answer);
  spread(answer, rest, z);
}

void SplineLevels::WithRows::apply_along_rows(const VectorXd& force_mN, VectorXd& z) const {
  const VectorXd left_mN = left_of(force_mN);
  VectorXd rest = alone_;
  push(left_mN, rest);
  Answer answer = to_alone_;
  add_answers(left_mN, answer);
  spread(answer, rest, z);
}

void SplineLevels::WithRows::rest_of(const VectorXd& force_mN, VectorXd& rest) const {
  rest = alone_;
  push(left_of(force_mN), rest);
}

// On the functionals: so much along each row, and what the rows answer to that and to `alone`.
VectorXd SplineLevels::WithRows::left_of(const VectorXd& force_mN) const {
  const VectorXd pushed_mN = seen_.shares.transpose() * force_mN;
  return pushed_mN - inverse_ * (seen_alone_mm_ + compliance_mm_mN_ * pushed_mN);
}

void SplineLevels::WithRows::push(const VectorXd& force_mN, VectorXd& r) const {
  const auto after = r.size() - further_;
  for (std::size_t i = 0; i < seen_.functionals.size(); ++i) {
    const LinearFunctional& functional = seen_.functionals[i];
    const double force = force_mN[static_cast<Eigen::Index>(i)];
    for (const auto& [node, direction] : functional.on) r.segment<3>(3 * node) += force * direction;
    if (functional.further >= 0) r[after + functional.further] -= functional.along * force;
  }
}

void SplineLevels::WithRows::add_answers(const VectorXd& force_mN, Answer& answer) const {
  const VectorXf wide = wide_ * force_mN.cast<float>();
  for (std::size_t u = 0; u < used_.size(); ++u) {
    answer.wide.noalias() += levels_.wide_inverse_.block(0, 3 * used_[u], answer.wide.size(), 3) *
                             wide.segment<3>(3 * static_cast<Eigen::Index>(u));
  }
  if (cut_ != nullptr) answer.cut += cut_->inverse() * (of_cut_ * force_mN.cast<float>());
  for (std::size_t i = 0; i < narrow_.size(); ++i) {
    const auto force = static_cast<float>(force_mN[static_cast<Eigen::Index>(i)]);
    if (force == 0) continue;
    for (const auto& [point, value] : narrow_[i]) {
      const auto p = static_cast<std::size_t>(point);
      answer.narrow[p].head<3>() += force * (levels_.narrow_inverse_[p] * value);
    }
  }
}

// An answer of the lattices and of the diagonal on the unknowns.
void SplineLevels::WithRows::spread(const Answer& answer, const VectorXd& r, VectorXd& z) const {
  z.resize(r.size());
  for (std::size_t n = 0; n < levels_.inverse_diagonal_.size(); ++n) {
    const auto first = 3 * static_cast<Eigen::Index>(n);
    z.segment<3>(first).noalias() = levels_.inverse_diagonal_[n] * r.segment<3>(first);
  }
  SplineLattice::Values narrow = answer.narrow;
  levels_.lattice_.up_from_wide(answer.wide, narrow);
  levels_.lattice_.up(narrow, z);
  if (cut_ != nullptr) {
    const auto nodes = static_cast<int>(levels_.inverse_diagonal_.size());
    for (int j = 0; j < cut_->jumps(); ++j) {
      z.segment<3>(3 * (nodes + j)) = cut_->own_inverse(j) * r.segment<3>(3 * (nodes + j));
    }
    cut_->spread(answer.cut, z);
  }
  for (auto f = r.size() - further_; f < r.size(); ++f) z[f] = r[f] / soft_;
}

}  // namespace glisson::mechanics

#include "mechanics/contact/internal/spline_levels.h"

#include <algorithm>
#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <map>

#include "mechanics/contact/internal/dense_product.h"
#include "mechanics/solvers/cholesky_factor.h"

namespace glisson::mechanics {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::MatrixXf;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Eigen::VectorXf;

// A's rows of nodes, without what is held.
using Blocks = std::vector<std::vector<std::pair<int, Matrix3d>>>;
Blocks free_blocks(const Eigen::SparseMatrix<double>& lower, const SplineLattice& lattice);

}  // namespace

bool SplineLevels::refresh(const Eigen::SparseMatrix<double>& lower) {
  const Blocks blocks = free_blocks(lower, lattice_);
  const Eigen::Index unknowns = 3 * lattice_.wide_points();
  MatrixXd coarse = MatrixXd::Zero(unknowns, unknowns);
  std::vector<Matrix3d> diagonal(static_cast<std::size_t>(lattice_.points()), Matrix3d::Zero());
  // A node's row times the splines first, then by the splines around the node.
  std::vector<SplineLattice::Shares<float>> narrow;
  for (int node = 0; node < static_cast<int>(blocks.size()); ++node) narrow.push_back(lattice_.around(node));
  const auto rows_times = [&](const std::vector<SplineLattice::Shares<float>>& around, int points, const auto& take) {
    std::vector<Matrix3d> product(static_cast<std::size_t>(points), Matrix3d::Zero());
    std::vector<std::uint8_t> is_touched(product.size(), 0);
    std::vector<int> touched;
    for (std::size_t row = 0; row < blocks.size(); ++row) {
      for (const auto& [column, block] : blocks[row]) {
        for (const auto& [point, weight] : around[static_cast<std::size_t>(column)]) {
          const auto p = static_cast<std::size_t>(point);
          if (!is_touched[p]) touched.push_back(point);
          is_touched[p] = 1;
          product[p] += double{weight} * block;
        }
      }
      take(around[row], touched, product);
      for (const int point : touched) {
        product[static_cast<std::size_t>(point)].setZero();
        is_touched[static_cast<std::size_t>(point)] = 0;
      }
      touched.clear();
    }
  };
  using Shares = SplineLattice::Shares<float>;
  rows_times(wide_of_node_, lattice_.wide_points(),
             [&](const Shares& own, const std::vector<int>& touched, const std::vector<Matrix3d>& product) {
               for (const int column : touched) {
                 for (const auto& [point, weight] : own) {
                   if (point < column) continue;
                   coarse.block<3, 3>(3 * point, 3 * column) +=
                       double{weight} * product[static_cast<std::size_t>(column)];
                 }
               }
             });
  // A point that hardly touches the body, or only what is held, has little to say.
  coarse.diagonal().array() += 1e-6 * coarse.diagonal().mean();
  const MatrixXd lower_part = coarse.triangularView<Eigen::Lower>();
  const auto factor = CholeskyFactor::create(lower_part.sparseView(), std::uint64_t{2} << 30);
  if (!factor) return false;
  wide_inverse_ = padded_rows(factor->solve(MatrixXd::Identity(unknowns, unknowns)).cast<float>());

  rows_times(narrow, lattice_.points(),
             [&](const Shares& own, const std::vector<int>&, const std::vector<Matrix3d>& product) {
               for (const auto& [point, weight] : own) {
                 diagonal[static_cast<std::size_t>(point)] += double{weight} * product[static_cast<std::size_t>(point)];
               }
             });
  // Neighbouring points move largely the same nodes, so that together they answer a residual several times over: w.
  constexpr double damping = 0.3;
  double largest = 0;
  for (const Matrix3d& block : diagonal) largest = std::max(largest, block.trace() / 3);
  narrow_inverse_.clear();
  for (const Matrix3d& block : diagonal) {
    const Matrix3d safe = block + 1e-4 * largest * Matrix3d::Identity();
    narrow_inverse_.emplace_back((damping * safe.inverse()).cast<float>());
  }
  inverse_diagonal_.clear();
  for (int node = 0; node < static_cast<int>(blocks.size()); ++node) {
    Matrix3d own = Matrix3d::Zero();
    for (const auto& [column, block] : blocks[static_cast<std::size_t>(node)]) {
      if (column == node) own = block;
    }
    for (int d = 0; d < 3; ++d) own(d, d) += lattice_.is_fixed(node, d) ? 1.0 : 0.0;
    own = own.inverse().eval();
    for (int d = 0; d < 3; ++d) {
      if (lattice_.is_fixed(node, d)) own(d, d) = 0;
    }
    inverse_diagonal_.push_back(own);
  }
  return true;
}

SplineLevels::WithRows::WithRows(const SplineLevels& levels, const std::vector<StiffRow>& rows, int further,
                                 VectorXd alone, const CutLevel* cut)
    : levels_(levels), rows_(rows), cut_(cut), further_(further), alone_(std::move(alone)), presses_(rows.size(), 0) {
  double stiffest = 1;
  for (const StiffRow& row : rows) stiffest = std::max(stiffest, row.stiffness);
  soft_ = 1e-4 * stiffest;
  find_shares();
  to_alone_ = answer_without_rows(alone_);
  seen_alone_mm_ = seen_of(to_alone_, alone_);
  compliance_mm_mN_ = compliance();
  VectorXd gap_mm = seen_alone_mm_;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    gap_mm[static_cast<Eigen::Index>(r)] += rows[r].gap_mm;
    presses_[r] = rows[r].two_sided || rows[r].gap_mm < 0;
  }
  choose(std::move(gap_mm));
}

// What the rows see of either lattice.
void SplineLevels::WithRows::find_shares() {
  const SplineLattice& lattice = levels_.lattice_;
  std::vector<int> narrow_at(static_cast<std::size_t>(lattice.points()), -1);
  std::vector<int> used_at(static_cast<std::size_t>(lattice.wide_points()), -1);
  std::vector<SplineLattice::Shares<Eigen::Vector3f>> wide(rows_.size());
  narrow_.resize(rows_.size());
  const auto nodes = static_cast<int>(levels_.inverse_diagonal_.size());
  if (cut_ != nullptr) of_cut_ = MatrixXf::Zero(cut_->values(), static_cast<Eigen::Index>(rows_.size()));
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    for (const auto& [node, direction] : rows_[r].on) {
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
  wide_ = MatrixXf::Zero(3 * static_cast<Eigen::Index>(used_.size()), static_cast<Eigen::Index>(rows_.size()));
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    for (const auto& [at, value] : wide[r]) wide_.col(static_cast<Eigen::Index>(r)).segment<3>(3 * at) += value;
  }
}

MatrixXd SplineLevels::WithRows::compliance() const {
  // Of the wide inverse only what the rows see.
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

// What rows answer to each other by what they share: points of the narrow lattice, nodes, and further unknowns.
void SplineLevels::WithRows::add_own(MatrixXd& sum) const {
  MatrixXd own = MatrixXd::Zero(sum.rows(), sum.cols());  // below the diagonal and on it
  std::vector<std::vector<std::pair<Eigen::Index, Eigen::Vector3f>>> at_point(
      static_cast<std::size_t>(levels_.lattice_.points()));
  std::map<int, std::vector<std::pair<Eigen::Index, Vector3d>>> at_node;
  for (Eigen::Index r = 0; r < sum.rows(); ++r) {
    const auto row = static_cast<std::size_t>(r);
    for (const auto& [point, value] : narrow_[row]) at_point[static_cast<std::size_t>(point)].emplace_back(r, value);
    for (const auto& [node, direction] : rows_[row].on) at_node[node].emplace_back(r, direction);
    for (Eigen::Index s = 0; rows_[row].further >= 0 && s <= r; ++s) {
      const StiffRow& other = rows_[static_cast<std::size_t>(s)];
      if (other.further == rows_[row].further) own(r, s) += rows_[row].along * other.along / soft_;
    }
  }
  const auto add = [&own](const auto& sharing, const auto& inverse) {
    for (std::size_t i = 0; i < sharing.size(); ++i) {
      const auto answered = (inverse * sharing[i].second).eval();
      for (std::size_t j = 0; j <= i; ++j) {
        const bool twice = j < i && sharing[j].first == sharing[i].first;  // one row that sees it in two ways
        own(sharing[i].first, sharing[j].first) += (twice ? 2 : 1) * double{answered.dot(sharing[j].second)};
      }
    }
  };
  for (std::size_t p = 0; p < at_point.size(); ++p) add(at_point[p], levels_.narrow_inverse_[p]);
  for (const auto& [node, sharing] : at_node) add(sharing, own_inverse(node));
  sum += own;
  sum += own.triangularView<Eigen::StrictlyLower>().transpose();
}

// Which press: those whose gap would close under the forces of the others.
void SplineLevels::WithRows::choose(VectorXd gap_mm) {
  const auto count = static_cast<Eigen::Index>(rows_.size());
  constexpr int most_changes = 20;
  std::vector<Eigen::Index> pressing;
  MatrixXd of_pressing;
  Eigen::LLT<MatrixXd> factor;
  for (int change = 0;; ++change) {
    pressing.clear();
    for (Eigen::Index r = 0; r < count; ++r) {
      if (presses_[static_cast<std::size_t>(r)]) pressing.push_back(r);
    }
    const auto size = static_cast<Eigen::Index>(pressing.size());
    of_pressing.resize(size, size);
    VectorXd closed_mm(size);
    for (Eigen::Index i = 0; i < size; ++i) {
      const auto row = static_cast<std::size_t>(i);
      for (Eigen::Index j = 0; j < size; ++j) {
        of_pressing(i, j) = compliance_mm_mN_(pressing[row], pressing[static_cast<std::size_t>(j)]);
      }
      of_pressing(i, i) += 1 / rows_[static_cast<std::size_t>(pressing[row])].stiffness;
      closed_mm[i] = -gap_mm[pressing[row]];
    }
    factor.compute(of_pressing);
    if (change == most_changes) break;
    const VectorXd force_mN = factor.solve(closed_mm);
    VectorXd after_mm = gap_mm;
    for (Eigen::Index i = 0; i < size; ++i) {
      after_mm += force_mN[i] * compliance_mm_mN_.col(pressing[static_cast<std::size_t>(i)]);
    }
    bool changed = false;
    for (Eigen::Index r = 0, i = 0; r < count; ++r) {
      const bool pressed = i < size && pressing[static_cast<std::size_t>(i)] == r;
      const double own_mN = pressed ? force_mN[i++] : 0.0;
      if (rows_[static_cast<std::size_t>(r)].two_sided) continue;
      const bool now = pressed ? own_mN > 0 : after_mm[r] < 0;
      changed = changed || now != pressed;
      presses_[static_cast<std::size_t>(r)] = now;
    }
    if (!changed) break;
  }
  of_pressing = factor.solve(MatrixXd::Identity(of_pressing.rows(), of_pressing.rows())).eval();
  inverse_ = MatrixXd::Zero(count, count);
  for (std::size_t i = 0; i < pressing.size(); ++i) {
    for (std::size_t j = 0; j < pressing.size(); ++j) {
      inverse_(pressing[i], pressing[j]) = of_pressing(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
    }
  }
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
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const StiffRow& row = rows_[i];
    double& of_row = seen[static_cast<Eigen::Index>(i)];
    for (const auto& [point, value] : narrow_[i]) {
      of_row += double{value.dot(answer.narrow[static_cast<std::size_t>(point)].head<3>())};
    }
    for (const auto& [node, direction] : row.on) {
      of_row += direction.dot(own_inverse(node) * r.segment<3>(3 * node));
    }
    if (row.further >= 0) of_row -= row.along * r[after + row.further] / soft_;
  }
  return seen;
}

void SplineLevels::WithRows::apply(const VectorXd& r, VectorXd& z) const {
  Answer answer = answer_without_rows(r);
  // The forces with which the rows answer what they would see.
  const VectorXd force_mN = -inverse_ * seen_of(answer, r);
  VectorXd rest = r;
  push_along_rows(force_mN, rest);
  add_answers_of_rows(force_mN, answer);
  spread(answer, rest, z);
}

void SplineLevels::WithRows::apply_along_rows(const VectorXd& force_mN, VectorXd& z) const {
  const VectorXd left_mN = force_mN - inverse_ * (seen_alone_mm_ + compliance_mm_mN_ * force_mN);
  VectorXd rest = alone_;
  push_along_rows(left_mN, rest);
  Answer answer = to_alone_;
  add_answers_of_rows(left_mN, answer);
  spread(answer, rest, z);
}

void SplineLevels::WithRows::rest_of(const VectorXd& force_mN, VectorXd& rest) const {
  rest = alone_;
  push_along_rows(force_mN - inverse_ * (seen_alone_mm_ + compliance_mm_mN_ * force_mN), rest);
}

void SplineLevels::WithRows::push_along_rows(const VectorXd& force_mN, VectorXd& r) const {
  const auto after = r.size() - further_;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const StiffRow& row = rows_[i];
    const double force = force_mN[static_cast<Eigen::Index>(i)];
    for (const auto& [node, direction] : row.on) r.segment<3>(3 * node) += force * direction;
    if (row.further >= 0) r[after + row.further] -= row.along * force;
  }
}

void SplineLevels::WithRows::add_answers_of_rows(const VectorXd& force_mN, Answer& answer) const {
  const VectorXf wide = wide_ * force_mN.cast<float>();
  for (std::size_t u = 0; u < used_.size(); ++u) {
    answer.wide.noalias() += levels_.wide_inverse_.block(0, 3 * used_[u], answer.wide.size(), 3) *
                             wide.segment<3>(3 * static_cast<Eigen::Index>(u));
  }
  if (cut_ != nullptr) answer.cut += cut_->inverse() * (of_cut_ * force_mN.cast<float>());
  for (std::size_t i = 0; i < rows_.size(); ++i) {
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

namespace {

Blocks free_blocks(const Eigen::SparseMatrix<double>& lower, const SplineLattice& lattice) {
  Blocks blocks(static_cast<std::size_t>(lower.cols() / 3));
  for (int column = 0; column < static_cast<int>(blocks.size()); ++column) {
    auto& own = blocks[static_cast<std::size_t>(column)];
    const std::size_t before = own.size();
    for (int c = 0; c < 3; ++c) {
      std::size_t at = before;
      for (Eigen::SparseMatrix<double>::InnerIterator entry(lower, 3 * column + c); entry; ++entry) {
        const int row = static_cast<int>(entry.row() / 3), r = static_cast<int>(entry.row() % 3);
        while (at < own.size() && own[at].first != row) ++at;
        if (at == own.size()) own.emplace_back(row, Matrix3d::Zero());
        if (lattice.is_fixed(row, r) || lattice.is_fixed(column, c)) continue;
        own[at].second(c, r) = entry.value();
        if (row == column) own[at].second(r, c) = entry.value();
      }
    }
    for (std::size_t at = before; at < own.size(); ++at) {
      if (own[at].first != column) {
        blocks[static_cast<std::size_t>(own[at].first)].emplace_back(column, own[at].second.transpose());
      }
    }
  }
  return blocks;
}

}  // namespace
}  // namespace glisson::mechanics

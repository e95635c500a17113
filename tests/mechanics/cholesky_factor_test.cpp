// The factor by itself: what it solves, and that it stays on the thread that asks for it.

#include "mechanics/solvers/cholesky_factor.h"
#include "mechanics/solvers/constrained_system.h"
#include "mechanics/solvers/dense_cholesky.h"

#include <gtest/gtest.h>
#include <cmath>
#include <Eigen/Cholesky>
#include <filesystem>
#include <thread>
#include <vector>

namespace glisson::mechanics {
namespace {

// Lower triangle of the 7-point Laplacian of a grid of n x n x n, its boundary held: positive definite, and with
// supernodes as large as those of a body.
Eigen::SparseMatrix<double> laplacian(int n) {
  std::vector<Eigen::Triplet<double>> entries;
  const auto at = [n](int i, int j, int k) { return (k * n + j) * n + i; };
  for (int k = 0; k < n; ++k) {
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        entries.emplace_back(at(i, j, k), at(i, j, k), 6.0);
        if (i + 1 < n) entries.emplace_back(at(i + 1, j, k), at(i, j, k), -1.0);
        if (j + 1 < n) entries.emplace_back(at(i, j + 1, k), at(i, j, k), -1.0);
        if (k + 1 < n) entries.emplace_back(at(i, j, k + 1), at(i, j, k), -1.0);
      }
    }
  }
  Eigen::SparseMatrix<double> lower(n * n * n, n * n * n);
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

constexpr std::uint64_t a_gigabyte = 1ULL << 30;

TEST(CholeskyFactor, SolvesAndStartsNoThreads) {
  const std::filesystem::path tasks = "/proc/self/task";
  if (!std::filesystem::exists(tasks)) GTEST_SKIP() << "threads are counted in /proc, which is not here";
  const auto threads = [&] {
    return std::distance(std::filesystem::directory_iterator(tasks), std::filesystem::directory_iterator());
  };
  const auto lower = laplacian(24);
  const Eigen::MatrixXd wanted = Eigen::MatrixXd::Random(lower.rows(), 3);
  const Eigen::MatrixXd loads = lower.selfadjointView<Eigen::Lower>() * wanted;

  const auto before = threads();
  const auto factor = CholeskyFactor::create(lower, a_gigabyte);
  ASSERT_TRUE(factor);
  EXPECT_LT((factor->solve(loads) - wanted).norm(), 1e-11 * wanted.norm());
  EXPECT_EQ(threads(), before);
}

// Wide supernodes stand in panels: little more is stored than the factor's own entries. What is solved with them, with
// those that are eliminated last too, is what a dense factor gives.
TEST(CholeskyFactor, StoresFewZerosAndSolvesTheSame) {
  const auto lower = laplacian(32);
  auto factor = CholeskyFactor::create(lower, a_gigabyte);
  ASSERT_TRUE(factor);
  const Eigen::MatrixXd wanted = Eigen::MatrixXd::Random(lower.rows(), 2);
  const Eigen::MatrixXd loads = lower.selfadjointView<Eigen::Lower>() * wanted;
  EXPECT_LT((factor->solve(loads) - wanted).norm(), 1e-11 * wanted.norm());
  const auto with_zeros = static_cast<double>(factor->bytes());
  factor->keep_in_single_precision();  // of half the size, and nearly without them
  EXPECT_LT(with_zeros, 1.15 * 2 * static_cast<double>(factor->bytes()));

  const auto small = laplacian(12);
  std::vector<int> last;
  for (int unknown = 0; unknown < small.rows(); unknown += 2) last.push_back(unknown);  // 864, more than a panel
  const auto with_last = CholeskyFactor::create(small, a_gigabyte, {}, nullptr, last);
  ASSERT_TRUE(with_last);
  const Eigen::MatrixXd triangle(small);
  const Eigen::MatrixXd inverse =
      triangle.selfadjointView<Eigen::Lower>().llt().solve(Eigen::MatrixXd::Identity(small.rows(), small.rows()));
  EXPECT_LT((with_last->inverse_of_last() - inverse(last, last)).norm(), 1e-11 * inverse.norm());
}

TEST(CholeskyFactor, TakesAKnownOrderForItsOwnPatternAloneAndIsTheSameToTheBit) {
  auto lower = laplacian(14);
  const auto first = CholeskyFactor::create(lower, a_gigabyte);
  ASSERT_TRUE(first);
  lower *= 3.0;
  const Eigen::MatrixXd loads = Eigen::MatrixXd::Random(lower.rows(), 2);
  const auto afresh = CholeskyFactor::create(lower, a_gigabyte);
  const auto known = CholeskyFactor::create(lower, a_gigabyte, {}, first->order());
  ASSERT_TRUE(afresh && known);
  EXPECT_EQ(known->order(), first->order());
  EXPECT_EQ(known->solve(loads), afresh->solve(loads));
  EXPECT_EQ(known->bytes(), afresh->bytes());

  // As many unknowns and entries, elsewhere.
  lower.coeffRef(lower.rows() - 1, 0) = -1e-3;
  lower.prune([&](Eigen::Index row, Eigen::Index column, double) { return row != 1 || column != 0; });
  lower.makeCompressed();
  const auto other = CholeskyFactor::create(lower, a_gigabyte, {}, first->order());
  ASSERT_TRUE(other);
  EXPECT_NE(other->order(), first->order());
  EXPECT_LT((lower.selfadjointView<Eigen::Lower>() * other->solve(loads) - loads).norm(), 1e-10 * loads.norm());
}

TEST(CholeskyFactor, RefusesWhatTakesMoreMemoryThanAllowedAndWhatIsNotPositiveDefinite) {
  auto lower = laplacian(12);
  const auto too_large = CholeskyFactor::create(lower, 1000);
  ASSERT_FALSE(too_large);
  EXPECT_EQ(too_large.error().code, "too-large");
  lower.coeffRef(700, 700) = -1;
  const auto indefinite = CholeskyFactor::create(lower, a_gigabyte);
  ASSERT_FALSE(indefinite);
  EXPECT_EQ(indefinite.error().code, "factorisation-failed");
}

TEST(CholeskyFactor, InSinglePrecisionTakesLessThanHalfTheMemoryAndIsRefinedToTheSameSolution) {
  const auto lower = laplacian(20);
  const auto system = [&] { return ConstrainedSystem::create(lower, std::vector<std::uint8_t>(8000, 0), a_gigabyte); };
  auto full = system(), single = system();
  ASSERT_TRUE(full && single);
  single->keep_factor_in_single_precision();
  // Half of each number, and no more of the zeros above the diagonal than a band.
  EXPECT_LT(single->factor()->bytes(), 0.49 * static_cast<double>(full->factor()->bytes()));
  EXPECT_GT(single->factor()->bytes(), full->factor()->bytes() / 4);

  const Eigen::MatrixXd wanted = Eigen::MatrixXd::Random(lower.rows(), 5);
  const Eigen::MatrixXd loads = lower.selfadjointView<Eigen::Lower>() * wanted;
  const Eigen::MatrixXd unrefined = single->factor()->solve(loads);
  EXPECT_GT((unrefined - wanted).norm(), 1e-9 * wanted.norm());  // else it would be no rounding
  EXPECT_LT((unrefined - wanted).norm(), 1e-4 * wanted.norm());
  const auto refined = single->solve(loads, {}, {});
  for (int column = 0; column < 5; ++column) {
    EXPECT_LT(refined[column].relative_residual, 1e-10);
    EXPECT_LT((refined[column].u - wanted.col(column)).norm(), 1e-8 * wanted.col(column).norm());
  }
  EXPECT_LT((single->respond(loads, Digits::all).u - full->respond(loads, Digits::all).u).norm(), 1e-8 * wanted.norm());
  const auto seen = single->respond(loads, Digits::seen);
  EXPECT_TRUE(seen.is_seen_right);
  EXPECT_EQ(seen.u, unrefined);
  EXPECT_LT((seen.u - wanted).norm(), 1e-5 * wanted.norm());
  // Far from one, where single precision alone would overflow or vanish.
  EXPECT_LT((single->respond(1e60 * loads, Digits::all).u - 1e60 * wanted).norm(), 1e-8 * 1e60 * wanted.norm());
}

TEST(DenseCholesky, SolvesAndRefusesWhatIsNotDefinite) {
  const Eigen::MatrixXd half = Eigen::MatrixXd::NullaryExpr(
      40, 40, [](Eigen::Index i, Eigen::Index j) { return std::sin(1.0 + 3.0 * double(i) + 7.0 * double(j * j)); });
  const Eigen::MatrixXd definite = half * half.transpose() + Eigen::MatrixXd::Identity(40, 40);
  const auto factor = DenseCholesky::of(definite);
  ASSERT_TRUE(factor.has_value());
  EXPECT_LT((definite * factor->solve(half.leftCols(3)) - half.leftCols(3)).norm(), 1e-9);
  EXPECT_FALSE(DenseCholesky::of(definite - 1e3 * Eigen::MatrixXd::Identity(40, 40)).has_value());
  EXPECT_EQ(DenseCholesky::of(Eigen::MatrixXd(0, 0))->solve(Eigen::MatrixXd(0, 2)).cols(), 2);
}

}  // namespace
}  // namespace glisson::mechanics

// Whitened residuals have the covariance 1 where the covariance is the declared one: noise, what groups of rows share,
// and directions, some of which say the same.

#include "closedloop/experiment/whitening.h"

#include <gtest/gtest.h>
#include <Eigen/Core>
#include <random>
#include <vector>

namespace glisson::closedloop {
namespace {

constexpr Eigen::Index kRows = 30;

struct Uncertain {
  Eigen::VectorXd noise;
  SystematicUncertainty systematic;
};

// `size`: of what the prediction may be off by, in units of the noise.
Uncertain uncertain(double size, bool in_groups) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  Uncertain made;
  made.noise = Eigen::VectorXd::NullaryExpr(kRows, [&] { return 0.5 + std::abs(normal(random)); });
  made.systematic.directions = Eigen::MatrixXd::NullaryExpr(kRows, 4, [&] { return size * normal(random); });
  made.systematic.directions.col(3) = 2 * made.systematic.directions.col(2);
  if (!in_groups) return made;
  made.systematic.shared = Eigen::VectorXd::NullaryExpr(kRows, [&] { return size * normal(random); });
  for (Eigen::Index i = 0; i < kRows; ++i) made.systematic.group.push_back(static_cast<int>(i % 3));
  return made;
}

Eigen::MatrixXd covariance(const Uncertain& of) {
  Eigen::MatrixXd sum = of.noise.array().square().matrix().asDiagonal();
  sum += of.systematic.directions * of.systematic.directions.transpose();
  for (Eigen::Index i = 0; i < of.systematic.shared.size(); ++i)
    for (Eigen::Index j = 0; j < of.systematic.shared.size(); ++j)
      if (of.systematic.group[static_cast<std::size_t>(i)] == of.systematic.group[static_cast<std::size_t>(j)])
        sum(i, j) += of.systematic.shared[i] * of.systematic.shared[j];
  return sum;
}

TEST(Whitening, LeavesUnitCovariance) {
  std::vector<Eigen::Index> rows;
  for (Eigen::Index i = 0; i < kRows; ++i) rows.push_back(i);
  for (const bool in_groups : {false, true})
    for (const double size : {0.0, 0.1, 3.0, 1e3}) {
      const Uncertain declared = uncertain(size, in_groups);
      const Whitening whitening(declared.noise, declared.systematic, rows);
      const Eigen::MatrixXd white = whitening.whiten(whitening.whiten(covariance(declared)).transpose());
      EXPECT_LT((white - Eigen::MatrixXd::Identity(kRows, kRows)).cwiseAbs().maxCoeff(), 1e-6)
          << "size " << size << (in_groups ? ", in groups" : "");
    }
}

TEST(Whitening, OfSomeRowsIsThatOfTheirCovariance) {
  const std::vector<Eigen::Index> rows{2, 3, 11, 17, 29};
  const Uncertain declared = uncertain(3, false);
  const Whitening whitening(declared.noise, declared.systematic, rows);
  const Eigen::MatrixXd once = whitening.whiten(covariance(declared));
  const Eigen::MatrixXd white = whitening.whiten(once.transpose());
  EXPECT_LT((white - Eigen::MatrixXd::Identity(5, 5)).cwiseAbs().maxCoeff(), 1e-9);
}

}  // namespace
}  // namespace glisson::closedloop

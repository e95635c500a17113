// The evidence decides how large the modes may be, and its fit is that of least squares with that prior.

#include "guidance/internal/evidence_fit.h"

#include <gmock/gmock.h>
#include <Eigen/Dense>
#include <random>

namespace glisson::guidance {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd random_matrix(Eigen::Index rows, Eigen::Index columns, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  return MatrixXd::NullaryExpr(rows, columns, [&] { return normal(random); });
}

TEST(EvidenceFit, IsLeastSquaresWithThePriorThatItChose) {
  const MatrixXd modes = random_matrix(60, 8, 1), free = random_matrix(60, 3, 2);
  const VectorXd truth = 2.0 * random_matrix(8, 1, 3);
  const VectorXd rows = modes * truth + free * VectorXd::Constant(3, 5.0) + random_matrix(60, 1, 4);
  const EvidenceFit fit = fit_by_evidence(modes, free, rows, 1e9, 100);
  MatrixXd all(68, 11);
  all << modes, free, MatrixXd::Identity(8, 8) / std::sqrt(fit.variance), MatrixXd::Zero(8, 3);
  VectorXd right = VectorXd::Zero(68);
  right.head(60) = rows;
  const VectorXd slow = all.colPivHouseholderQr().solve(right);
  EXPECT_LT((fit.modes - slow.head(8)).norm(), 1e-8);
  EXPECT_LT((fit.free - slow.tail(3)).norm(), 1e-8);
  const MatrixXd covariance = fit.kappa * (all.transpose() * all).inverse();
  EXPECT_LT((fit.covariance() - covariance).norm(), 1e-8);
}

TEST(EvidenceFit, NoiseAloneAwakensNoModes) {
  const EvidenceFit fit =
      fit_by_evidence(random_matrix(200, 30, 5), random_matrix(200, 6, 6), random_matrix(200, 1, 7), 1e9, 100);
  EXPECT_LT(fit.variance, 0.01);
  EXPECT_NEAR(fit.kappa, 1, 0.25);
}

TEST(EvidenceFit, AVarianceThatIsThereIsFound) {
  const MatrixXd modes = random_matrix(300, 40, 8);
  const VectorXd rows = modes * (3.0 * random_matrix(40, 1, 9)) + random_matrix(300, 1, 10);
  const EvidenceFit fit = fit_by_evidence(modes, random_matrix(300, 6, 11), rows, 1e9, 100);
  EXPECT_GT(fit.variance, 9 * 0.5);
  EXPECT_LT(fit.variance, 9 * 2.0);
}

}  // namespace
}  // namespace glisson::guidance

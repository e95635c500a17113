#pragma once
// Residuals in units of what is to be expected of them: independent noise of each number, and the error of the
// prediction itself (ForwardModel::systematic_uncertainty). The covariance is C = N^2 + V V^T + U U^T. N is the noise,
// V what groups of rows share, and U the directions of that uncertainty. `whiten` multiplies with a square root of
// C^-1, so that its result is white with variance 1 where the model is right.

#include <Eigen/Core>
#include <vector>

namespace glisson::closedloop {

// How far a prediction may be off, besides the noise of what was measured. Empty: it is exact.
struct SystematicUncertainty {
  Eigen::MatrixXd directions;  // one standard deviation a column, independent of each other; rows as observations
  // Rows of one group are off together: by shared[row] times one number of variance 1. Both empty, or a row each.
  Eigen::VectorXd shared;
  std::vector<int> group;  // 0 and up
  // How far the prediction is off if the error goes on as a finer solve began, of the declared model; empty where
  // nobody looked.
  Eigen::VectorXd expected;
  // What changes the prediction by less than this cannot be told from the prediction's own error, whatever its shape.
  // It is a root mean square over rows, in units of the noise.
  double indistinct = 0;
};

class Whitening {
 public:
  // Over the rows named.
  Whitening(const Eigen::VectorXd& noise, const SystematicUncertainty& systematic, std::vector<Eigen::Index> rows);

  [[nodiscard]] const std::vector<Eigen::Index>& rows() const { return rows_; }

  // Of vectors (columns) over all rows of the experiment; gives the rows named alone.
  [[nodiscard]] Eigen::MatrixXd whiten(const Eigen::MatrixXd& columns) const;

 private:
  std::vector<Eigen::Index> rows_;
  // (1 + s s^T)^-1/2 is 1 - shrinking u u^T, with u = s / |s| and shrinking = 1 - 1 / sqrt(1 + s^2).
  struct Group {
    std::vector<Eigen::Index> rows;  // among those named
    Eigen::VectorXd direction;       // u
    double shrinking = 0;
  };

  void leave_groups_out(Eigen::MatrixXd& white) const;

  Eigen::VectorXd inverse_noise_;  // of the rows named
  std::vector<Group> groups_;
  Eigen::MatrixXd directions_;  // B, orthogonal columns: the inverse square root is 1 - B B^T
};

}  // namespace glisson::closedloop

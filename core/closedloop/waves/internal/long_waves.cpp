#include "closedloop/waves/internal/long_waves.h"

#include <algorithm>
#include <cmath>
#include <Eigen/SVD>

namespace glisson::closedloop {
namespace {

using Powers = std::array<int, 3>;

std::vector<Powers> monomials_of(int degree) {
  std::vector<Powers> all;
  for (int x = degree; x >= 0; --x)
    for (int y = degree - x; y >= 0; --y) all.push_back({x, y, degree - x - y});
  return all;
}

// Columns: coefficients of the monomials of a degree, of polynomials whose Laplacian vanishes.
Eigen::MatrixXd harmonic_polynomials(int degree) {
  const std::vector<Powers> monomials = monomials_of(degree);
  if (degree < 2) return Eigen::MatrixXd::Identity(3, 3);
  const std::vector<Powers> lower = monomials_of(degree - 2);
  Eigen::MatrixXd laplacian =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(lower.size()), static_cast<Eigen::Index>(monomials.size()));
  for (std::size_t m = 0; m < monomials.size(); ++m) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Powers less = monomials[m];
      const int power = less.at(axis);
      if (power < 2) continue;
      less.at(axis) -= 2;
      const auto row = std::find(lower.begin(), lower.end(), less) - lower.begin();
      laplacian(row, static_cast<Eigen::Index>(m)) += power * (power - 1);
    }
  }
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(laplacian, Eigen::ComputeFullV);
  return svd.matrixV().rightCols(2 * degree + 1);
}

}  // namespace

LongWaves::LongWaves(const imaging::Grid& grid, const TestFunctions& functions, const std::vector<Patch>& patches,
                     int degree) {
  const Eigen::Vector3d size(grid.size[0] - 1, grid.size[1] - 1, grid.size[2] - 1);
  const Eigen::Vector3d middle = 0.5 * size;
  const double half_mm = 0.5 * size.cwiseProduct(grid.spacing_mm).maxCoeff();
  std::vector<Eigen::MatrixXd> polynomials;
  Eigen::Index fields = 0;
  for (int d = 1; d <= degree; ++d) {
    polynomials.push_back(harmonic_polynomials(d));
    fields += polynomials.back().cols();
  }
  for (const Patch& patch : patches) {
    // Sums over the patch of each derivative of the bump's factors times powers of the place.
    std::array<std::array<std::vector<double>, 4>, 3> sums;
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      for (int order = 0; order < 4; ++order) {
        auto& of_order = sums.at(a).at(static_cast<std::size_t>(order));
        of_order.assign(static_cast<std::size_t>(degree), 0);
        for (int offset = -functions.reach(axis); offset <= functions.reach(axis); ++offset) {
          const double x = (patch.middle.at(a) + offset - middle[axis]) * grid.spacing_mm[axis] / half_mm;
          double power = functions.factor(axis, order, offset);
          for (double& sum : of_order) {
            sum += power;
            power *= x;
          }
        }
      }
    }
    Eigen::MatrixXd moments = Eigen::MatrixXd::Zero(3 * moments_of_a_component, fields);
    Eigen::Index first = 0;
    for (int d = 1; d <= degree; ++d) {
      const std::vector<Powers> monomials = monomials_of(d);
      const Eigen::MatrixXd& coefficients = polynomials[static_cast<std::size_t>(d - 1)];
      for (int component = 0; component < 3; ++component) {
        for (std::size_t m = 0; m < monomials.size(); ++m) {
          Powers less = monomials[m];
          int& power = less.at(static_cast<std::size_t>(component));
          if (power == 0) continue;
          const double times = power--;
          for (int moment = 0; moment < moments_of_a_component; ++moment) {
            const Derivative& derivative = derivatives().at(static_cast<std::size_t>(moment));
            double product = times;
            for (std::size_t axis = 0; axis < 3; ++axis)
              product *= sums.at(axis)
                             .at(static_cast<std::size_t>(derivative.at(axis)))
                             .at(static_cast<std::size_t>(less.at(axis)));
            moments.row(component * moments_of_a_component + moment).segment(first, coefficients.cols()) +=
                product * coefficients.row(static_cast<Eigen::Index>(m));
          }
        }
      }
      first += coefficients.cols();
    }
    moments_.push_back(std::move(moments));
  }
}

}  // namespace glisson::closedloop

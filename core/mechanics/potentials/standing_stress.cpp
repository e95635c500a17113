#include "mechanics/potentials/standing_stress.h"

#include <cmath>
#include <Eigen/Eigenvalues>
#include <numeric>

#include "mechanics/potentials/internal/cell_samples.h"

namespace glisson::mechanics {
namespace {

Eigen::Matrix3d pulling_part(const Eigen::Matrix3d& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(symmetric);
  return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0.0).asDiagonal() * solver.eigenvectors().transpose();
}

// The energy of each cell, as `of` makes it of a sample's.
template <typename Of>
double sum_over_cells(const Body& body, const std::vector<Eigen::Matrix3d>& stresses_kPa, const Eigen::VectorXd& u_mm,
                      const Of& of) {
  const Sampling sampling(body.options.order);
  std::vector<double> of_cell(body.layout.cells.size(), 0.0);
  visit_samples(body, sampling, u_mm,
                [&](std::size_t c, std::size_t q, const TetGradients&, const Eigen::Matrix3d& f, double volume_mm3) {
                  const Eigen::Matrix3d& stress_kPa = stresses_kPa[sampling.points() * c + q];
                  of_cell[c] +=
                      volume_mm3 *
                      of(0.5 * stress_kPa.cwiseProduct(f.transpose() * f - Eigen::Matrix3d::Identity()).sum());
                });
  return std::accumulate(of_cell.begin(), of_cell.end(), 0.0);
}

}  // namespace

StandingStress::StandingStress(const Body& body, std::vector<Eigen::Matrix3d> stresses_kPa)
    : body_(body), stresses_kPa_(std::move(stresses_kPa)) {
  GLISSON_ASSERT(stresses_kPa_.size() == Sampling(body.options.order).points() * body.layout.cells.size());
}

double StandingStress::energy_uJ(const Eigen::VectorXd& u_mm) const {
  return sum_over_cells(body_, stresses_kPa_, u_mm, [](double energy_kPa) { return energy_kPa; });
}

double StandingStress::scale_uJ(const Eigen::VectorXd& u_mm) const {
  return sum_over_cells(body_, stresses_kPa_, u_mm, [](double energy_kPa) { return std::abs(energy_kPa); });
}

void StandingStress::add_force(const Eigen::VectorXd& u_mm, Eigen::VectorXd& force_mN) const {
  const std::size_t points = Sampling(body_.options.order).points();
  force_mN -= resisting_force_mN(body_, u_mm, [&](std::size_t c, std::size_t q, const Eigen::Matrix3d& f) {
    return (f * stresses_kPa_[points * c + q]).eval();
  });
}

void StandingStress::add_tangent(const Eigen::VectorXd& /*u_mm*/, Tangent which, TangentSum& sum) const {
  if (which == Tangent::warped) return;
  const Sampling sampling(body_.options.order);
  std::vector<Eigen::Matrix3d> held = stresses_kPa_;
  if (which == Tangent::positive) {
    for (Eigen::Matrix3d& stress_kPa : held) stress_kPa = pulling_part(stress_kPa);
  }
  // Moving node b by e changes F by e g_b^T and the stress by e (H g_b)^T.
  const auto column_of_cell = [&](std::size_t cell, int b) {
    const CellGeometry shape = cell_geometry(body_.mesh, cell);
    std::array<TetGradients, 4> gradients;
    std::array<Eigen::Vector3d, 4> pulled;
    for (std::size_t q = 0; q < sampling.points(); ++q) {
      gradients[q] = tet_gradients(sampling.derivatives[q], shape);
      pulled[q] =
          sampling.weights[q] * shape.volume_mm3 * held[sampling.points() * cell + q] * gradients[q].row(b).transpose();
    }
    return [gradients, pulled, points = sampling.points()](int a) {
      double along = 0;
      for (std::size_t q = 0; q < points; ++q) along += gradients[q].row(a).dot(pulled[q]);
      return Eigen::Matrix3d(along * Eigen::Matrix3d::Identity());
    };
  };
  sum.add_cells(column_of_cell);
}

}  // namespace glisson::mechanics

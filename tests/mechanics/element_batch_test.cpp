// Eight cells at a time, by every instruction set that this machine has, against one cell at a time by its formulas.

#include "mechanics/dynamics/internal/element_batch.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <Eigen/LU>
#include <random>

#include "mechanics/materials/deformation.h"

namespace glisson::mechanics {
namespace {

using Eigen::Matrix3d;
using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

void slow_rotation(const double f[3][3], double r[3][3]) {
  const RowMajor gradient = Eigen::Map<const RowMajor>(&f[0][0]);
  const RowMajor rotation = polar_decomposition(gradient).rotation;
  std::copy_n(rotation.data(), 9, &r[0][0]);
}

struct Slow {
  Matrix3d gradients, rotation;
  double lambda, mu;

  Slow(const ElementBatch& batch, int lane) : lambda(batch.lambda_volume[lane]), mu(batch.mu_volume[lane]) {
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) {
        gradients(r, c) = batch.gradients[r][c][lane];
        rotation(r, c) = batch.rotation[r][c][lane];
      }
    }
  }
  Matrix3d gradient_of(const ElementBatch& batch, int lane, const Eigen::VectorXd& w) const {
    Matrix3d moved;
    for (int i = 0; i < 3; ++i) {
      moved.col(i) = w.segment<3>(batch.first[i + 1][lane]) - w.segment<3>(batch.first[0][lane]);
    }
    return moved * gradients.transpose();
  }
};

// Cells on nodes of their own, as skewed as chance has it; the displacements turn them, and more and more of them are
// turned inside out or flattened.
struct Sample {
  std::vector<ElementBatch> batches;
  Eigen::VectorXd u;
};

Sample some_cells() {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  Sample sample;
  sample.batches.resize(6);
  sample.u.resize(3 * 4 * 8 * 6);
  std::int64_t node = 0;
  for (std::size_t b = 0; b < sample.batches.size(); ++b) {
    ElementBatch& batch = sample.batches[b];
    batch = {};
    batch.count = b + 1 == sample.batches.size() ? 5 : ElementBatch::lanes;
    for (int lane = 0; lane < ElementBatch::lanes; ++lane) {
      Matrix3d edges = 4.0 * Matrix3d::Identity(), f = Matrix3d::Identity();
      for (double& value : edges.reshaped()) value += 0.5 * normal(random);
      for (double& value : f.reshaped()) value += 0.12 * static_cast<double>(b) * normal(random);
      const Eigen::Vector3d axis(normal(random), normal(random), normal(random));
      f = Eigen::AngleAxisd(3 * normal(random), axis.normalized()) * f;
      if (b > 0 && (lane == 2 || lane == 4)) f.col(1) *= -1;
      if (b > 0 && lane == 3) f.col(2) *= 1e-3;
      const Matrix3d gradients = edges.inverse().transpose();
      const bool real = lane < batch.count;
      for (int i = 0; i < 4; ++i) batch.first[i][lane] = real ? 3 * (node + i) : batch.first[i][lane - 1];
      for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) {
          batch.gradients[r][c][lane] = real ? gradients(r, c) : 0.0;
          batch.rotation[r][c][lane] = r == c ? 1.0 : 0.0;
        }
      }
      batch.lambda_volume[lane] = real ? 40.0 + lane : 0.0;
      batch.mu_volume[lane] = real ? 5.0 + lane : 0.0;
      sample.u.segment<3>(3 * node).setConstant(normal(random));
      for (int i = 0; i < 3; ++i) {
        sample.u.segment<3>(3 * (node + 1 + i)) =
            sample.u.segment<3>(3 * node) + (f - Matrix3d::Identity()) * edges.col(i);
      }
      node += 4;
    }
  }
  return sample;
}

void expect_as_one_by_one(const std::string& target) {
  Sample sample = some_cells();
  const CellKernels kernels = cell_kernels();
  const auto turned = kernels.turn(sample.batches.data(), sample.batches.data() + sample.batches.size(),
                                   sample.u.data(), false, slow_rotation);
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(sample.u.size()), changes = forces;
  const Eigen::VectorXd w = 0.3 * sample.u.cwiseAbs();
  const auto* begin = sample.batches.data();
  kernels.add_forces(begin, begin + sample.batches.size(), sample.u.data(), 1.0, 1.0, forces.data());
  kernels.add_forces(begin, begin + sample.batches.size(), w.data(), 0.0, -2.5, changes.data());

  double energy = 0;
  int inverted = 0;
  Eigen::VectorXd slow_forces = Eigen::VectorXd::Zero(sample.u.size()), slow_changes = slow_forces;
  for (const ElementBatch& batch : sample.batches) {
    for (int lane = 0; lane < batch.count; ++lane) {
      const Slow cell(batch, lane);
      const Matrix3d f = Matrix3d::Identity() + cell.gradient_of(batch, lane, sample.u);
      EXPECT_NEAR((cell.rotation - polar_decomposition(f).rotation).norm(), 0, 2e-9) << target << ", lane " << lane;
      inverted += f.determinant() <= 0 ? 1 : 0;
      const auto add = [&](const Matrix3d& stretch, double factor, Eigen::VectorXd& sum) {
        const Matrix3d strain = 0.5 * (stretch + stretch.transpose());
        const Matrix3d stress = 2 * cell.mu * strain + cell.lambda * strain.trace() * Matrix3d::Identity();
        const Matrix3d of_corner = factor * cell.rotation * stress * cell.gradients;
        for (int i = 0; i < 3; ++i) {
          sum.segment<3>(batch.first[i + 1][lane]) += of_corner.col(i);
          sum.segment<3>(batch.first[0][lane]) -= of_corner.col(i);
        }
        return 0.5 * (strain.cwiseProduct(stress)).sum();
      };
      energy += add(cell.rotation.transpose() * f - Matrix3d::Identity(), 1.0, slow_forces);
      add(cell.rotation.transpose() * cell.gradient_of(batch, lane, w), -2.5, slow_changes);
    }
  }
  EXPECT_EQ(turned.inverted_cells, inverted) << target;
  EXPECT_GE(inverted, 5);
  EXPECT_NEAR(turned.strain_energy_uJ, energy, 1e-12 * energy) << target;
  EXPECT_LT((forces - slow_forces).norm(), 1e-12 * slow_forces.norm()) << target;
  EXPECT_LT((changes - slow_changes).norm(), 1e-12 * slow_changes.norm()) << target;
}

TEST(ElementBatch, EveryInstructionSetTurnsAndResistsAsOneCellAtATimeDoes) {
  const std::int64_t supported = hwy::SupportedTargets();
  for (std::int64_t targets = supported; targets != 0; targets &= targets - 1) {
    const std::int64_t target = targets & -targets;
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(target);
    expect_as_one_by_one(hwy::TargetName(target));
    if ((target & HWY_STATIC_TARGET) != 0) break;  // narrower ones are not compiled
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().DeInit();
}

}  // namespace
}  // namespace glisson::mechanics

#include "closedloop/waves/internal/moments.h"

#include <cmath>

namespace glisson::closedloop {
namespace {

constexpr int across_slice = 10;  // derivatives in x and y of order 0 to 3 together

int place_across(int x, int y) {
  int place = 0;
  for (int order = 0; order < x + y; ++order) place += order + 1;
  return place + y;
}

}  // namespace

Moments::Moments(const Fields& fields, const imaging::Grid& grid, const TestFunctions& functions,
                 const std::vector<Patch>& patches)
    : components_(static_cast<Eigen::Index>(fields.size())) {
  const int reach_x = functions.reach(0), reach_y = functions.reach(1), reach_z = functions.reach(2);
  for (const Patch& patch : patches) {
    const auto [at_x, at_y, at_z] = patch.middle;
    Slices slices{at_z - reach_z, Eigen::MatrixXcd::Zero(2 * reach_z + 1, components_ * across_slice)};
    for (Eigen::Index c = 0; c < components_; ++c) {
      const auto& field = fields[static_cast<std::size_t>(c)];
      for (int k = -reach_z; k <= reach_z; ++k) {
        for (int j = -reach_y; j <= reach_y; ++j) {
          std::array<std::complex<double>, 4> line{};
          for (int i = -reach_x; i <= reach_x; ++i) {
            const std::complex<double> u(field[grid.offset(at_x + i, at_y + j, at_z + k)]);
            for (int order = 0; order < 4; ++order)
              line.at(static_cast<std::size_t>(order)) += functions.factor(0, order, i) * u;
          }
          for (int x = 0; x < 4; ++x) {
            for (int y = 0; x + y < 4; ++y)
              slices.sums(k + reach_z, c * across_slice + place_across(x, y)) +=
                  functions.factor(1, y, j) * line.at(static_cast<std::size_t>(x));
          }
        }
      }
    }
    patches_.push_back(std::move(slices));
  }
}

Eigen::MatrixXcd Moments::of(const TestFunctions& functions, const std::vector<double>& slice_phase) const {
  Eigen::MatrixXcd moments =
      Eigen::MatrixXcd::Zero(components_ * moments_of_a_component, static_cast<Eigen::Index>(patches_.size()));
  const int reach = functions.reach(2);
  for (std::size_t p = 0; p < patches_.size(); ++p) {
    const Slices& slices = patches_[p];
    for (Eigen::Index k = 0; k < slices.sums.rows(); ++k) {
      const std::complex<double> turn = turned_back(slice_phase, slices.first + static_cast<int>(k));
      for (Eigen::Index c = 0; c < components_; ++c) {
        for (int m = 0; m < moments_of_a_component; ++m) {
          const auto [x, y, z] = derivatives().at(static_cast<std::size_t>(m));
          moments(c * moments_of_a_component + m, static_cast<Eigen::Index>(p)) +=
              turn * functions.factor(2, z, static_cast<int>(k) - reach) *
              slices.sums(k, c * across_slice + place_across(x, y));
        }
      }
    }
  }
  return moments;
}

std::complex<double> turned_back(const std::vector<double>& slice_phase, int slice) {
  return slice_phase.empty() ? 1.0 : std::polar(1.0, -slice_phase[static_cast<std::size_t>(slice)]);
}

Fields along_grid(const WaveTrial& trial, const imaging::Grid& grid) {
  auto fields = trial.components;
  if (fields.size() != 3 || grid.direction.isIdentity(1e-6)) return fields;
  const Eigen::Matrix3f to_grid = grid.direction.transpose().cast<float>();
  for (std::size_t v = 0; v < fields[0].size(); ++v) {
    const Eigen::Vector3cf u(trial.components[0][v], trial.components[1][v], trial.components[2][v]);
    const Eigen::Vector3cf turned = to_grid * u;
    for (std::size_t c = 0; c < 3; ++c) fields[c][v] = turned[static_cast<Eigen::Index>(c)];
  }
  return fields;
}

}  // namespace glisson::closedloop

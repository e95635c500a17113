// The separable local fit against the slow obvious one, and what it makes of plane waves and of noise.

#include "elastography/internal/local_fit.h"

#include <gtest/gtest.h>
#include <Eigen/QR>

#include "elastography/wave_phantom.h"

namespace glisson::elastography {
namespace {

imaging::Mask full(const imaging::Grid& grid) { return {grid, std::vector<std::uint8_t>(grid.voxels(), 1)}; }

// Weighted least squares by orthogonalisation, over the same neighbourhood.
std::pair<Complex, Complex> slow_fit(const ComplexField& field, const imaging::Mask& mask, const Eigen::Vector3i& at,
                                     double sd_mm) {
  const imaging::Grid& grid = mask.grid;
  std::vector<Eigen::Matrix<double, 10, 1>> rows;
  std::vector<Complex> values;
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        const Eigen::Vector3d d = (Eigen::Vector3i(i, j, k) - at).cast<double>().cwiseProduct(grid.spacing_mm);
        const Eigen::Vector3d steps = (Eigen::Vector3i(i, j, k) - at).cast<double>();
        const bool near = (steps.cwiseAbs().array() <= (3 * sd_mm / grid.spacing_mm.array()).ceil()).all();
        if (mask.at(i, j, k) == 0 || !near) continue;
        const double root = std::exp(-0.25 * d.squaredNorm() / (sd_mm * sd_mm));
        Eigen::Matrix<double, 10, 1> row;
        row << 1, d.x(), d.y(), d.z(), d.x() * d.x(), d.y() * d.y(), d.z() * d.z(), d.x() * d.y(), d.x() * d.z(),
            d.y() * d.z();
        rows.push_back(root * row);
        values.push_back(root * Complex(field[grid.offset(i, j, k)]));
      }
    }
  }
  Eigen::MatrixXd a(rows.size(), 10);
  Eigen::MatrixXd b(rows.size(), 2);
  for (std::size_t n = 0; n < rows.size(); ++n) {
    a.row(static_cast<Eigen::Index>(n)) = rows[n].transpose();
    b.row(static_cast<Eigen::Index>(n)) << values[n].real(), values[n].imag();
  }
  const Eigen::MatrixXd p = a.colPivHouseholderQr().solve(b);
  const auto complex = [&](Eigen::Index row) { return Complex(p(row, 0), p(row, 1)); };
  const Complex laplacian = 2.0 * (complex(4) + complex(5) + complex(6));
  return {complex(0) + 0.5 * sd_mm * sd_mm * laplacian, laplacian};
}

TEST(LocalFit, AgreesWithTheSlowObviousOneAlsoAtARaggedBorder) {
  const imaging::Grid grid = cube_grid(16, 7, 2, 3);
  imaging::Mask mask = full(grid);
  std::mt19937 random(4);
  for (std::uint8_t& value : mask.values) value = random() % 4 != 0 ? 1 : 0;
  ComplexField field(grid.voxels());
  std::normal_distribution<float> normal(0, 1);
  for (auto& value : field) value = {normal(random), normal(random)};
  const LocalFitter fitter(mask, 3.5, FitDimension::volume);
  const LocalFit fit = fitter.fit(field);
  int judged = 0;
  for (const auto& at : {Eigen::Vector3i(8, 8, 3), {0, 0, 0}, {15, 4, 6}, {1, 14, 2}, {7, 0, 5}, {12, 12, 1}}) {
    const std::size_t v = grid.offset(at.x(), at.y(), at.z());
    if (mask.values[v] == 0) continue;
    ++judged;
    const auto [value, laplacian] = slow_fit(field, mask, at, 3.5);
    EXPECT_LT(std::abs(Complex(fit.value[v]) - value), 1e-4 * (1 + std::abs(value)));
    EXPECT_LT(std::abs(Complex(fit.laplacian[v]) - laplacian), 1e-4 * (1 + std::abs(laplacian)));
  }
  EXPECT_GE(judged, 3);
}

// The reason for the way in which the two are formed.
TEST(LocalFit, TheQuotientOfAPlaneWaveIsItsWavenumberSquaredInsideTheBody) {
  WavePhantom phantom;
  phantom.grid = cube_grid(33, 33, 2, 2);
  phantom.background_kPa = {3, 0};
  for (const double frequency_Hz : {40.0, 80.0, 160.0}) {
    phantom.frequency_Hz = frequency_Hz;
    const auto u = scattered_wave(phantom, Eigen::Vector3d(1, 0.7, 0.4).normalized());
    const double sd_mm = std::max(1.8, 0.1 * wavelength_mm(frequency_Hz, phantom.background_kPa));
    const LocalFit fit = LocalFitter(full(phantom.grid), sd_mm, FitDimension::volume).fit(u);
    const std::size_t middle = phantom.grid.offset(16, 16, 16);
    const Complex k = wavenumber(frequency_Hz, phantom.background_kPa);
    const Complex found = -Complex(fit.laplacian[middle]) / Complex(fit.value[middle]);
    EXPECT_NEAR(found.real() / (k * k).real(), 1, 0.01) << frequency_Hz << " Hz";
  }
}

TEST(LocalFit, SaysHowNoiseComesOut) {
  const imaging::Grid grid = cube_grid(24, 6, 2, 3);
  imaging::Mask mask = full(grid);
  for (std::size_t v = 0; v < mask.values.size(); ++v) mask.values[v] = v % 24 < 19 ? 1 : 0;
  const LocalFitter fitter(mask, 4, FitDimension::volume);
  std::mt19937 random(11);
  std::normal_distribution<float> normal(0, 1);
  const std::size_t deep = grid.offset(9, 12, 3);
  const std::size_t border = grid.offset(18, 12, 0);
  std::array<Eigen::Vector3d, 2> seen{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  constexpr int trials = 400;
  for (int n = 0; n < trials; ++n) {
    ComplexField noise(grid.voxels());
    for (auto& sample : noise) sample = {normal(random), normal(random)};
    const LocalFit fit = fitter.fit(noise);
    for (std::size_t place = 0; place < 2; ++place) {
      const Complex value(fit.value[place == 0 ? deep : border]);
      const Complex laplacian(fit.laplacian[place == 0 ? deep : border]);
      seen[place] +=
          Eigen::Vector3d(std::norm(value), (std::conj(value) * laplacian).real(), std::norm(laplacian)) / (2 * trials);
    }
  }
  // The mean of 800 squares scatters by 5 %.
  for (std::size_t place = 0; place < 2; ++place) {
    const auto& gain = fitter.noise_gain()[place == 0 ? deep : border];
    EXPECT_NEAR(seen[place][0] / static_cast<double>(gain.value), 1, 0.2);
    EXPECT_NEAR(seen[place][1] / static_cast<double>(gain.between), 1, 0.2);
    EXPECT_NEAR(seen[place][2] / static_cast<double>(gain.laplacian), 1, 0.2);
  }
  EXPECT_GT(fitter.support()[deep], 0.95F);
  EXPECT_LT(fitter.support()[border], 0.65F);
}

TEST(LocalFit, LonelyVoxelsAreNotFitted) {
  const imaging::Grid grid = cube_grid(12, 1, 2, 2);
  imaging::Mask mask{grid, std::vector<std::uint8_t>(grid.voxels(), 0)};
  mask.at(5, 5, 0) = mask.at(6, 5, 0) = 1;
  EXPECT_EQ(LocalFitter(mask, 3, FitDimension::slice).fitted().at(5, 5, 0), 0);
  EXPECT_EQ(LocalFitter(full(grid), 3, FitDimension::slice).fitted().at(5, 5, 0), 1);
}

}  // namespace
}  // namespace glisson::elastography

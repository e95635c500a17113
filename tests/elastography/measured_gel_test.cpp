// A gel whose shear waves were measured at the University of Utah (Hofstetter et al., Magnetic Resonance in Medicine
// 2019): a focused-ultrasound push sends a ring outwards, and the scanner shows where it is. The rings of its 16 pushes
// are 6.1 mm apart from peak to trough while the motion-encoding gradient lasts 3 ms a lobe, which makes 2.1 m/s and
// 4.3 kPa. Here the same is asked of the local frequency: the gradient, whose two lobes last 6 ms, picks the frequency
// 1 / 6 ms out of the pulse, and the wavelength of the ring times that is the speed.

#include <gtest/gtest.h>
#include <matio.h>
#include <algorithm>
#include <memory>

#include "elastography/local_frequency.h"
#include "support/data.h"

namespace glisson::elastography {
namespace {

constexpr double pixel_mm = 0.5;
constexpr double lobe_s = 3e-3;

struct Pushes {
  int rows = 0, columns = 0, count = 0;
  std::vector<double> phase_rad;  // row fastest, then column, then push
  std::vector<double> magnitude;  // row fastest, then column; 1 where it is largest

  [[nodiscard]] double at(int row, int column, int push) const {
    return phase_rad[static_cast<std::size_t>(row + rows * (column + columns * push))];
  }
  // Air around the gel has no phase but noise.
  [[nodiscard]] bool in_gel(int row, int column) const {
    return magnitude[static_cast<std::size_t>(row + rows * column)] > 0.25;
  }
};

std::vector<double> values_of(mat_t* file, const char* name, std::vector<int>& size) {
  const std::unique_ptr<matvar_t, void (*)(matvar_t*)> variable(Mat_VarRead(file, name), Mat_VarFree);
  if (!variable || variable->class_type != MAT_C_SINGLE || variable->isComplex != 0) return {};
  std::size_t count = 1;
  for (int axis = 0; axis < variable->rank; ++axis) {
    count *= variable->dims[axis];
    size.push_back(static_cast<int>(variable->dims[axis]));
  }
  const auto* values = static_cast<const float*>(variable->data);
  return {values, values + count};
}

Pushes read_pushes(const std::filesystem::path& path) {
  Pushes pushes;
  const std::unique_ptr<mat_t, int (*)(mat_t*)> file(Mat_Open(path.c_str(), MAT_ACC_RDONLY), Mat_Close);
  if (!file) return pushes;
  std::vector<int> size;
  pushes.phase_rad = values_of(file.get(), "pDiff", size);
  if (size.size() != 4) return pushes;
  pushes.rows = size[0];
  pushes.columns = size[1];
  pushes.count = size[3];
  pushes.magnitude = values_of(file.get(), "magnitude", size);
  const double maximum = *std::max_element(pushes.magnitude.begin(), pushes.magnitude.end());
  for (double& value : pushes.magnitude) value /= maximum;
  return pushes;
}

// The push itself is where the motion of a neighbourhood of 4 mm is strongest; how strong it is on average, in rad.
struct Centre {
  Eigen::Vector2i at{0, 0};
  double strength_rad = 0;
};
Centre centre_of(const Pushes& pushes, int push) {
  Centre centre;
  for (int c = 4; c + 4 < pushes.columns; ++c) {
    for (int r = 4; r + 4 < pushes.rows; ++r) {
      if (!pushes.in_gel(r - 4, c - 4) || !pushes.in_gel(r + 4, c + 4)) continue;
      double sum = 0;
      for (int dc = -4; dc <= 4; ++dc) {
        for (int dr = -4; dr <= 4; ++dr) sum += pushes.at(r + dr, c + dc, push);
      }
      if (std::abs(sum) / 81 <= centre.strength_rad) continue;
      centre = {{r, c}, std::abs(sum) / 81};
    }
  }
  return centre;
}

// Rings are round: averaged around the push they stand out of the noise.
std::vector<double> radial_mean(const Pushes& pushes, int push, const Eigen::Vector2i& centre) {
  std::vector<double> sum(80, 0);
  std::vector<double> count(80, 0);
  for (int c = 0; c < pushes.columns; ++c) {
    for (int r = 0; r < pushes.rows; ++r) {
      const auto bin = static_cast<std::size_t>(std::lround((Eigen::Vector2i(r, c) - centre).cast<double>().norm()));
      if (bin >= sum.size() || !pushes.in_gel(r, c)) continue;
      sum[bin] += pushes.at(r, c, push);
      count[bin] += 1;
    }
  }
  for (std::size_t bin = 0; bin < sum.size(); ++bin) sum[bin] /= std::max(count[bin], 1.0);
  return sum;
}

TEST(MeasuredGel, ItsShearWavesRunAt2Point1MetresASecond) {
  GLISSON_NEEDS_DATA("mre_swe_phantom_utah");
  const Pushes pushes = read_pushes(test::shared_data() / "mre_swe_phantom_utah" / "homogeneous_phantom_2D.mat");
  ASSERT_EQ(pushes.count, 16);
  std::vector<double> speeds_m_s;
  for (int push = 0; push < pushes.count; ++push) {
    Waves waves;
    waves.frequency_Hz = 1 / (2 * lobe_s);
    waves.grid.size = {pushes.rows, pushes.columns, 1};
    waves.grid.spacing_mm = {pixel_mm, pixel_mm, 1};
    waves.signal = {waves.grid, std::vector<std::uint8_t>(waves.grid.voxels(), 0)};
    waves.noise_rad.assign(waves.grid.voxels(), 0);
    waves.components.emplace_back(waves.grid.voxels(), 0);
    const auto [centre, strength_rad] = centre_of(pushes, push);
    if (strength_rad < 0.25) continue;  // this push hardly moved the slice
    const std::vector<double> profile = radial_mean(pushes, push, centre);
    imaging::Mask ring = waves.signal;
    for (int c = 0; c < pushes.columns; ++c) {
      for (int r = 0; r < pushes.rows; ++r) {
        const double away = (Eigen::Vector2i(r, c) - centre).cast<double>().norm();
        const std::size_t v = waves.grid.offset(r, c, 0);
        if (away * pixel_mm >= 30) continue;
        waves.signal.values[v] = 1;
        waves.components[0][v] = static_cast<float>(profile[static_cast<std::size_t>(std::lround(away))]);
        ring.values[v] = away * pixel_mm > 6 && away * pixel_mm < 20 ? 1 : 0;
      }
    }
    const double wavelength_mm = typical_wavelength_mm(local_frequency(waves), ring);
    speeds_m_s.push_back(1e-3 * wavelength_mm * waves.frequency_Hz);
  }
  std::sort(speeds_m_s.begin(), speeds_m_s.end());
  ASSERT_GE(speeds_m_s.size(), 6U);
  const double median_m_s = speeds_m_s[speeds_m_s.size() / 2];
  std::printf("%.2f m/s (%.2f to %.2f over %zu pushes), %.1f kPa\n", median_m_s, speeds_m_s.front(), speeds_m_s.back(),
              speeds_m_s.size(), median_m_s * median_m_s);
  EXPECT_NEAR(median_m_s, 2.1, 0.3);
}

}  // namespace
}  // namespace glisson::elastography

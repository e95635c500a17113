#include "elastography/waves.h"

#include <algorithm>
#include <cmath>
#include <Eigen/LU>
#include <numbers>

#include "base/parallel.h"
#include "imaging/filters.h"

namespace glisson::elastography {
namespace {

using imaging::Grid;
using imaging::Mask;

// At each instant the median over the tissue of each slice: the drift of the scanner's phase, and the swaying of the
// body as a whole.
void take_off_what_is_shared(std::vector<std::vector<float>>& phase_rad, const Mask& tissue);
// What a direction's instants hold besides their mean and the first harmonic, as the variance of one instant.
std::vector<float> residual_variance(const std::vector<std::vector<float>>& phase_rad, const ComplexField& harmonic);
ComplexField harmonic_of(const std::vector<std::vector<float>>& phase_rad);
void turn_slices(ComplexField& u, const WaveImages& images);

}  // namespace

Mask tissue_of(const WaveImages& images) {
  Mask tissue{images.grid, std::vector<std::uint8_t>(images.grid.voxels(), 1)};
  if (images.magnitude.empty()) return tissue;
  constexpr std::size_t bins = 256;
  const float maximum = *std::max_element(images.magnitude.begin(), images.magnitude.end());
  if (!(maximum > 0)) return tissue;
  const auto bin_of = [&](float value) {
    return static_cast<std::size_t>(std::clamp(value / maximum, 0.0F, 1.0F) * static_cast<float>(bins - 1));
  };
  std::vector<double> count(bins, 0);
  for (const float value : images.magnitude) count[bin_of(value)] += 1;
  double all = 0;
  double moment = 0;
  for (std::size_t b = 0; b < bins; ++b) {
    all += count[b];
    moment += count[b] * static_cast<double>(b);
  }
  double below = 0;
  double moment_below = 0;
  double best = -1;
  std::size_t threshold = 0;
  for (std::size_t b = 0; b + 1 < bins; ++b) {
    below += count[b];
    moment_below += count[b] * static_cast<double>(b);
    if (below == 0 || below == all) continue;
    const double apart = moment_below / below - (moment - moment_below) / (all - below);
    const double between_classes = below * (all - below) * apart * apart;
    if (between_classes > best) {
      best = between_classes;
      threshold = b;
    }
  }
  for (std::size_t v = 0; v < tissue.values.size(); ++v) tissue.values[v] = bin_of(images.magnitude[v]) > threshold;
  return tissue;
}

Waves first_harmonic(const WaveImages& images, const Mask& tissue, Unwrapping unwrapping) {
  const std::size_t directions = images.phase_rad.size();
  const std::size_t voxels = images.grid.voxels();
  Waves waves{images.frequency_Hz,           images.grid, std::vector<ComplexField>(directions),
              std::vector<float>(voxels, 0), tissue,      1};
  std::vector<std::vector<float>> variance(directions);
  std::vector<std::vector<std::uint8_t>> closed(directions, std::vector<std::uint8_t>(voxels, 1));
  parallel_for(directions, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t d = begin; d < end; ++d) {
      std::vector<std::vector<float>> phase_rad = images.phase_rad[d];
      if (images.wrapped) {
        UnwrappedPhase unwrapped = unwrap(phase_rad, tissue, unwrapping);
        phase_rad = std::move(unwrapped.phase_rad);
        closed[d] = std::move(unwrapped.closed);
      }
      take_off_what_is_shared(phase_rad, tissue);
      waves.components[d] = harmonic_of(phase_rad);
      variance[d] = residual_variance(phase_rad, waves.components[d]);
      turn_slices(waves.components[d], images);
    }
  });

  std::size_t in_tissue = 0;
  std::size_t kept = 0;
  std::vector<float> pooled(voxels, 0);
  std::vector<float> weight(voxels, 0);
  for (std::size_t v = 0; v < voxels; ++v) {
    if (tissue.values[v] == 0) continue;
    ++in_tissue;
    for (std::size_t d = 0; d < directions; ++d) waves.signal.values[v] &= closed[d][v];
    if (waves.signal.values[v] == 0) continue;
    ++kept;
    weight[v] = 1;
    for (std::size_t d = 0; d < directions; ++d) pooled[v] += variance[d][v] / static_cast<float>(directions);
  }
  if (in_tissue > 0) waves.closed_fraction = static_cast<double>(kept) / static_cast<double>(in_tissue);

  // One voxel has few instants to judge its noise by; its neighbours have much the same.
  const double sd_mm = 1.5 * images.grid.spacing_mm.head<2>().mean();
  pooled = imaging::gaussian_blur(std::move(pooled), images.grid, sd_mm);
  weight = imaging::gaussian_blur(std::move(weight), images.grid, sd_mm);
  const float of_harmonic = 2.0F / static_cast<float>(images.phase_rad.front().size());
  for (std::size_t v = 0; v < voxels; ++v) {
    if (weight[v] > 0.02F) waves.noise_rad[v] = std::sqrt(std::max(0.0F, of_harmonic * pooled[v] / weight[v]));
  }
  return waves;
}

Waves without_long_waves(Waves waves, double sd_mm) {
  const std::size_t voxels = waves.grid.voxels();
  // Slices so far apart that the filter leaves each to itself.
  Grid apart = waves.grid;
  apart.spacing_mm.z() = 100 * sd_mm;
  std::vector<float> weight(waves.signal.values.begin(), waves.signal.values.end());
  weight = imaging::gaussian_blur(std::move(weight), apart, sd_mm);
  parallel_for(waves.components.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      ComplexField& u = waves.components[c];
      std::vector<float> real(voxels, 0);
      std::vector<float> imaginary(voxels, 0);
      for (std::size_t v = 0; v < voxels; ++v) {
        if (waves.signal.values[v] == 0) continue;
        real[v] = u[v].real();
        imaginary[v] = u[v].imag();
      }
      real = imaging::gaussian_blur(std::move(real), apart, sd_mm);
      imaginary = imaging::gaussian_blur(std::move(imaginary), apart, sd_mm);
      for (std::size_t v = 0; v < voxels; ++v) {
        if (waves.signal.values[v] != 0) u[v] -= std::complex<float>(real[v], imaginary[v]) / weight[v];
      }
    }
  });
  return waves;
}

Waves without_swaying(Waves waves) {
  const Grid& grid = waves.grid;
  const auto width = static_cast<std::size_t>(grid.size[0]);
  const std::size_t slice = width * static_cast<std::size_t>(grid.size[1]);
  const auto plane_at = [&](std::size_t v) {
    const std::size_t i = v % width;
    const std::size_t j = v % slice / width;
    return Eigen::Vector3d(1, static_cast<double>(i) / grid.size[0], static_cast<double>(j) / grid.size[1]);
  };
  for (ComplexField& u : waves.components) {
    for (std::size_t begin = 0; begin < u.size(); begin += slice) {
      Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
      Eigen::Vector3cd moments = Eigen::Vector3cd::Zero();
      for (std::size_t v = begin; v < begin + slice; ++v) {
        if (waves.signal.values[v] == 0) continue;
        normal += plane_at(v) * plane_at(v).transpose();
        moments += plane_at(v) * std::complex<double>(u[v]);
      }
      if (!(normal(0, 0) > 3)) continue;
      const Eigen::FullPivLU<Eigen::Matrix3d> solver(normal);
      if (!solver.isInvertible()) continue;
      const Eigen::Vector3d real = solver.solve(moments.real());
      const Eigen::Vector3d imaginary = solver.solve(moments.imag());
      for (std::size_t v = begin; v < begin + slice; ++v) {
        if (waves.signal.values[v] == 0) continue;
        u[v] -= std::complex<float>(std::complex<double>(real.dot(plane_at(v)), imaginary.dot(plane_at(v))));
      }
    }
  }
  return waves;
}

Result<Waves> curl_of(const Waves& waves, const std::vector<Eigen::Vector3d>& along) {
  const Grid& grid = waves.grid;
  Eigen::Matrix3d directions = Eigen::Matrix3d::Zero();
  if (along.size() == 3) directions << along[0].transpose(), along[1].transpose(), along[2].transpose();
  if (waves.components.size() != 3 || std::abs(directions.determinant()) < 0.1 || grid.size[2] < 3) {
    return failure(Error{"waves-no-curl",
                         GLISSON_TEXT("The curl needs the motion along three known directions, in at least three "
                                      "slices."),
                         {},
                         GLISSON_TEXT("Take long waves off with the high-pass instead."),
                         {}});
  }
  const Eigen::Matrix3d patient_from_measured = directions.inverse();
  // d u / d(patient axis) = sum over image axes of (d u / d(image axis)) times that axis' direction.
  const std::array<std::size_t, 3> stride{
      1, static_cast<std::size_t>(grid.size[0]),
      static_cast<std::size_t>(grid.size[0]) * static_cast<std::size_t>(grid.size[1])};
  Waves curl = waves;
  parallel_for(static_cast<std::size_t>(grid.size[2]), 1, [&](std::size_t begin, std::size_t end) {
    for (int k = static_cast<int>(begin); k < static_cast<int>(end); ++k) {
      for (int j = 0; j < grid.size[1]; ++j) {
        for (int i = 0; i < grid.size[0]; ++i) {
          const std::size_t v = grid.offset(i, j, k);
          if (waves.signal.values[v] == 0) continue;
          const std::array<int, 3> at{i, j, k};
          Eigen::Matrix3cd gradient = Eigen::Matrix3cd::Zero();  // (measured component, patient axis)
          bool complete = true;
          for (std::size_t axis = 0; axis < 3; ++axis) {
            const bool low = at[axis] > 0 && waves.signal.values[v - stride[axis]] != 0;
            const bool high = at[axis] + 1 < grid.size[axis] && waves.signal.values[v + stride[axis]] != 0;
            complete = complete && (low || high);
            if (!low && !high) continue;
            const std::size_t from = low ? v - stride[axis] : v;
            const std::size_t to = high ? v + stride[axis] : v;
            const auto n = static_cast<Eigen::Index>(axis);
            const double step_mm = grid.spacing_mm[n] * (low && high ? 2 : 1);
            for (std::size_t c = 0; c < 3; ++c) {
              const std::complex<double> slope =
                  std::complex<double>(waves.components[c][to] - waves.components[c][from]) / step_mm;
              gradient.row(static_cast<Eigen::Index>(c)) += slope * grid.direction.col(n).transpose();
            }
          }
          if (!complete) curl.signal.values[v] = 0;
          const Eigen::Matrix3cd g = patient_from_measured * gradient;  // g(a, b) = d u_a / d x_b
          curl.components[0][v] = std::complex<float>(g(2, 1) - g(1, 2));
          curl.components[1][v] = std::complex<float>(g(0, 2) - g(2, 0));
          curl.components[2][v] = std::complex<float>(g(1, 0) - g(0, 1));
        }
      }
    }
  });
  // Each component is made of four differences over two voxels (in-plane; those along the normal are smaller).
  const auto gain = static_cast<float>(1 / grid.spacing_mm.head<2>().mean());
  for (float& noise : curl.noise_rad) noise *= gain;
  return curl;
}

namespace {

void take_off_what_is_shared(std::vector<std::vector<float>>& phase_rad, const Mask& tissue) {
  const std::size_t slice = tissue.values.size() / static_cast<std::size_t>(tissue.grid.size[2]);
  std::vector<float> in_tissue;
  for (std::vector<float>& instant : phase_rad) {
    for (std::size_t begin = 0; begin < instant.size(); begin += slice) {
      in_tissue.clear();
      for (std::size_t v = begin; v < begin + slice; ++v) {
        if (tissue.values[v] != 0) in_tissue.push_back(instant[v]);
      }
      if (in_tissue.empty()) continue;
      const auto middle = in_tissue.begin() + static_cast<std::ptrdiff_t>(in_tissue.size() / 2);
      std::nth_element(in_tissue.begin(), middle, in_tissue.end());
      const float median = *middle;
      for (std::size_t v = begin; v < begin + slice; ++v) instant[v] -= median;
    }
  }
}

// Back to one instant for all slices.
void turn_slices(ComplexField& u, const WaveImages& images) {
  if (images.slice_times_s.empty()) return;
  const std::size_t slice = u.size() / images.slice_times_s.size();
  for (std::size_t v = 0; v < u.size(); ++v) {
    const double turns = images.frequency_Hz * images.slice_times_s[v / slice];
    u[v] *= std::complex<float>(std::polar(1.0, -2 * std::numbers::pi * (turns - std::floor(turns))));
  }
}

ComplexField harmonic_of(const std::vector<std::vector<float>>& phase_rad) {
  const std::size_t instants = phase_rad.size();
  ComplexField harmonic(phase_rad.front().size(), 0);
  for (std::size_t t = 0; t < instants; ++t) {
    const double angle = -2 * std::numbers::pi * static_cast<double>(t) / static_cast<double>(instants);
    const auto factor = std::complex<float>(std::polar(2.0 / static_cast<double>(instants), angle));
    for (std::size_t v = 0; v < harmonic.size(); ++v) harmonic[v] += factor * phase_rad[t][v];
  }
  return harmonic;
}

std::vector<float> residual_variance(const std::vector<std::vector<float>>& phase_rad, const ComplexField& harmonic) {
  const std::size_t instants = phase_rad.size();
  std::vector<float> mean(harmonic.size(), 0);
  for (const std::vector<float>& instant : phase_rad) {
    for (std::size_t v = 0; v < mean.size(); ++v) mean[v] += instant[v] / static_cast<float>(instants);
  }
  std::vector<float> variance(harmonic.size(), 0);
  for (std::size_t t = 0; t < instants; ++t) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(t) / static_cast<double>(instants);
    const auto turn = std::complex<float>(std::polar(1.0, angle));
    for (std::size_t v = 0; v < variance.size(); ++v) {
      const float residual = phase_rad[t][v] - mean[v] - (harmonic[v] * turn).real();
      variance[v] += residual * residual / static_cast<float>(instants - 3);
    }
  }
  return variance;
}

}  // namespace
}  // namespace glisson::elastography

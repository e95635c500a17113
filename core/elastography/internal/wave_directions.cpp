#include "elastography/internal/wave_directions.h"

#include <cmath>
#include <numbers>

#include "base/parallel.h"
#include "elastography/internal/fourier.h"

namespace glisson::elastography {
namespace {

using imaging::Grid;

constexpr int minimum_slices_of_a_volume = 10;

std::vector<Eigen::Vector3d> lobe_directions(bool in_volume) {
  std::vector<Eigen::Vector3d> directions;
  if (!in_volume) {
    // The squared cosines of three or more axes add up to the same in all directions.
    constexpr int lobes = 6;
    for (int n = 0; n < lobes; ++n) {
      const double angle = 2 * std::numbers::pi * n / lobes;
      directions.emplace_back(std::cos(angle), std::sin(angle), 0);
    }
    return directions;
  }
  // The corners of an icosahedron.
  const double golden = std::numbers::phi;
  for (const double a : {-1.0, 1.0}) {
    for (const double b : {-golden, golden}) {
      directions.push_back(Eigen::Vector3d(0, a, b).normalized());
      directions.push_back(Eigen::Vector3d(a, b, 0).normalized());
      directions.push_back(Eigen::Vector3d(b, 0, a).normalized());
    }
  }
  return directions;
}

}  // namespace

SpectrumBlock block_of(const Grid& grid) {
  const bool in_volume = grid.size[2] >= minimum_slices_of_a_volume;
  SpectrumBlock block{grid.size, grid.size, in_volume ? 1 : grid.size[2]};
  if (!in_volume) block.size[2] = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    block.padded[axis] = block.size[axis] == 1 ? 1 : fast_length(block.size[axis] + block.size[axis] / 2);
  }
  return block;
}

std::vector<Eigen::Vector3f> sample_frequencies(const SpectrumBlock& block, const Grid& grid) {
  std::vector<Eigen::Vector3f> frequencies;
  const auto along = [&](int axis, int n) {
    const int length = block.padded[static_cast<std::size_t>(axis)];
    const int folded = n <= length / 2 ? n : n - length;
    return static_cast<float>(folded / (length * grid.spacing_mm[axis]));
  };
  for (int k = 0; k < block.padded[2]; ++k) {
    for (int j = 0; j < block.padded[1]; ++j) {
      for (int i = 0; i < block.padded[0]; ++i) frequencies.emplace_back(along(0, i), along(1, j), along(2, k));
    }
  }
  return frequencies;
}

ComplexField padded(const ComplexField& data, const std::vector<std::uint8_t>& signal, const SpectrumBlock& block,
                    int number) {
  const auto length = [](const std::array<int, 3>& size, std::size_t axis) {
    return static_cast<std::size_t>(size[axis]);
  };
  ComplexField out(length(block.padded, 0) * length(block.padded, 1) * length(block.padded, 2), 0);
  const std::size_t slice = length(block.size, 0) * length(block.size, 1);
  for (std::size_t k = 0; k < length(block.size, 2); ++k) {
    for (std::size_t j = 0; j < length(block.size, 1); ++j) {
      for (std::size_t i = 0; i < length(block.size, 0); ++i) {
        const std::size_t v = (static_cast<std::size_t>(number) + k) * slice + j * length(block.size, 0) + i;
        if (signal[v] == 0) continue;
        out[i + length(block.padded, 0) * (j + length(block.padded, 1) * k)] = data[v];
      }
    }
  }
  return out;
}

std::vector<std::vector<float>> direction_lobes(const SpectrumBlock& block,
                                                const std::vector<Eigen::Vector3f>& frequencies) {
  const auto directions = lobe_directions(block.size[2] > 1);
  std::vector<std::vector<float>> lobes(directions.size(), std::vector<float>(frequencies.size(), 0));
  for (std::size_t n = 0; n < frequencies.size(); ++n) {
    const double q = static_cast<double>(frequencies[n].norm());
    if (!(q > 0)) continue;
    for (std::size_t d = 0; d < directions.size(); ++d) {
      const double cosine = frequencies[n].cast<double>().dot(directions[d]) / q;
      lobes[d][n] = cosine > 0 ? static_cast<float>(cosine * cosine) : 0.0F;
    }
  }
  return lobes;
}

Waves running_apart(const Waves& waves) {
  const SpectrumBlock block = block_of(waves.grid);
  const FourierTransform transform(block.padded);
  const auto lobes = direction_lobes(block, sample_frequencies(block, waves.grid));
  Waves apart = waves;
  apart.components.assign(waves.components.size() * lobes.size(), ComplexField(waves.grid.voxels(), 0));
  const auto width = static_cast<std::size_t>(block.size[0]);
  const std::size_t slice = width * static_cast<std::size_t>(block.size[1]);
  parallel_for(waves.components.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      for (int number = 0; number < block.count; ++number) {
        ComplexField spectrum = padded(waves.components[c], waves.signal.values, block, number);
        transform.forward(spectrum);
        for (std::size_t d = 0; d < lobes.size(); ++d) {
          ComplexField part(spectrum.size());
          for (std::size_t n = 0; n < part.size(); ++n) part[n] = spectrum[n] * lobes[d][n];
          transform.inverse(part);
          ComplexField& out = apart.components[c * lobes.size() + d];
          for (std::size_t k = 0; k < static_cast<std::size_t>(block.size[2]); ++k) {
            for (std::size_t j = 0; j < static_cast<std::size_t>(block.size[1]); ++j) {
              const std::size_t from =
                  static_cast<std::size_t>(block.padded[0]) * (j + static_cast<std::size_t>(block.padded[1]) * k);
              const std::size_t to = (static_cast<std::size_t>(number) + k) * slice + j * width;
              for (std::size_t i = 0; i < width; ++i) {
                if (waves.signal.values[to + i] != 0) out[to + i] = part[from + i];
              }
            }
          }
        }
      }
    }
  });
  // Of white noise a filter keeps the mean of its squares.
  double squares = 0;
  for (const float weight : lobes.front()) squares += static_cast<double>(weight) * static_cast<double>(weight);
  const auto kept = static_cast<float>(std::sqrt(squares / static_cast<double>(lobes.front().size())));
  for (float& noise : apart.noise_rad) noise *= kept;
  return apart;
}

}  // namespace glisson::elastography

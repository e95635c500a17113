#include "studies/demo/elastography.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "base/noise.h"
#include "base/parallel.h"
#include "segmentation/edit.h"

namespace glisson::studies {
namespace {

using Eigen::Vector3d;
using imaging::Grid;
using imaging::Image;
using imaging::Mask;
using imaging::Volume;

// Calls value(i, j, k) for every voxel, on several threads.
template <typename Value>
Volume filled(const Grid& grid, const char* unit, Value value) {
  Volume volume;
  volume.grid = grid;
  volume.unit = unit;
  volume.values.resize(grid.voxels());
  const auto rows = static_cast<std::size_t>(grid.size[1]) * static_cast<std::size_t>(grid.size[2]);
  parallel_for(rows, 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      const int j = static_cast<int>(row) % grid.size[1], k = static_cast<int>(row) / grid.size[1];
      for (int i = 0; i < grid.size[0]; ++i) volume.at(i, j, k) = static_cast<float>(value(i, j, k));
    }
  });
  return volume;
}

double smooth_step(double low, double high, double value) {
  const double t = std::clamp((value - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

double shear_beside_the_liver_kPa(Tissue tissue);
double liver_shear_kPa(const Vector3d& position_mm, const DemoStiffness& stiffness, std::uint64_t seed);
Mask shaken_at(const Volume& shear_kPa, const Vector3d& center_mm, double radius_mm);
Volume blurred_where_positive(const Volume& volume, double sigma_mm);

}  // namespace

Volume true_shear_modulus(const TissueImage& tissues, const DemoStiffness& stiffness, std::uint64_t seed) {
  return filled(tissues.grid, "kPa", [&](int i, int j, int k) {
    const Vector3d position = tissues.grid.position_mm(i, j, k);
    switch (const Tissue tissue = tissues.at(i, j, k)) {
      case Tissue::tumour:
      case Tissue::tumour_rim:
      case Tissue::tumour_core:
        return stiffness.tumour_ratio * stiffness.liver_kPa * (1 + 0.25 * smooth_noise(seed + 403, position, 16));
      case Tissue::liver:
      case Tissue::portal_vein:  // vessels are not resolved: their walls and the tissue between carry the waves
      case Tissue::hepatic_vein:
      case Tissue::artery: return liver_shear_kPa(position, stiffness, seed);
      default: return shear_beside_the_liver_kPa(tissue);
    }
  });
}

Waves simulate_waves(const Volume& shear_kPa, const WaveOptions& options, std::uint64_t seed) {
  struct Front {
    Vector3d center_mm;
    double radius_mm;
    double strength;
  };
  // The driver lies on the right front of the chest over the liver; the others stand for what the ribs and the
  // diaphragm throw back.
  std::array<Front, 3> fronts = {
      Front{{-95, -290, -295}, 55, 1.0}, {{-140, -70, -300}, 30, 0.28}, {{90, -280, -270}, 30, 0.22}};
  for (Front& front : fronts) {
    const Vector3d porta_mm(0, -163, -285);  // bodies are scaled about it
    front.center_mm = porta_mm + options.body_size * (front.center_mm - porta_mm);
    front.radius_mm *= options.body_size;
  }
  const double omega = 2 * std::numbers::pi * options.frequency_Hz;

  const Grid& grid = shear_kPa.grid;
  std::vector<std::complex<float>> field(grid.voxels());
  for (const Front& front : fronts) {
    const Image<double> arrival =
        arrival_time_s(shear_kPa, options.density_kg_m3, shaken_at(shear_kPa, front.center_mm, front.radius_mm));
    for (std::size_t i = 0; i < field.size(); ++i) {
      if (!std::isfinite(arrival.values[i])) continue;
      const double phase = omega * arrival.values[i];
      const double size = options.amplitude_um * front.strength * std::exp(-options.damping_ratio * phase);
      field[i] += std::complex<float>(std::polar(size, -phase));
    }
  }

  Waves waves;
  waves.amplitude_um = Volume{{grid, std::vector<float>(field.size())}, "um"};
  for (std::size_t i = 0; i < field.size(); ++i) waves.amplitude_um.values[i] = std::abs(field[i]);
  constexpr double noise_um = 0.7;
  for (int offset = 0; offset < options.phase_offsets; ++offset) {
    const auto turn = std::complex<float>(std::polar(1.0, 2 * std::numbers::pi * offset / options.phase_offsets));
    const std::uint64_t noise_seed = seed + 500 + static_cast<std::uint64_t>(offset);
    waves.displacement_um.push_back(filled(grid, "um", [&](int i, int j, int k) {
      const std::size_t voxel = grid.offset(i, j, k);
      // Where there is hardly a signal the phase, and so the displacement, is anything.
      const double noise = shear_kPa.values[voxel] > 0 ? noise_um : 8 * noise_um;
      return static_cast<double>((field[voxel] * turn).real()) + noise * normal_pair(noise_seed, voxel).x();
    }));
  }
  return waves;
}

Image<double> arrival_time_s(const Volume& shear_kPa, double density_kg_m3, const Mask& source) {
  const Grid& grid = shear_kPa.grid;
  Image<double> arrival{grid, std::vector<double>(grid.voxels(), std::numeric_limits<double>::infinity())};
  std::vector<double> slowness_s_mm(grid.voxels());
  for (std::size_t i = 0; i < grid.voxels(); ++i) {
    if (source.values[i] != 0) arrival.values[i] = 0;
    // c = sqrt(G / rho): Pa over kg/m3 gives m/s.
    const double speed_mm_s = 1e3 * std::sqrt(1e3 * static_cast<double>(shear_kPa.values[i]) / density_kg_m3);
    slowness_s_mm[i] = speed_mm_s > 0 ? 1 / speed_mm_s : 0;
  }

  // Godunov's upwind scheme with a spacing of its own along each axis: sum over axes of max((T - t_a) / h_a, 0)^2 =
  // slowness^2, solved with the smallest neighbours first.
  const auto updated = [&](int i, int j, int k) {
    const std::array<int, 3> at = {i, j, k};
    std::array<std::pair<double, double>, 3> neighbours;  // earliest neighbour along each axis, spacing
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double earliest = std::numeric_limits<double>::infinity();
      for (const int step : {-1, 1}) {
        std::array<int, 3> beside = at;
        beside[axis] += step;
        if (grid.contains(beside[0], beside[1], beside[2])) {
          earliest = std::min(earliest, arrival.at(beside[0], beside[1], beside[2]));
        }
      }
      neighbours[axis] = {earliest, grid.spacing_mm[static_cast<Eigen::Index>(axis)]};
    }
    std::sort(neighbours.begin(), neighbours.end());
    const double slowness = slowness_s_mm[grid.offset(i, j, k)];
    double a = 0, b = 0, c = -slowness * slowness, time = std::numeric_limits<double>::infinity();
    for (const auto& [earliest, spacing] : neighbours) {
      if (!(earliest < time)) break;
      const double weight = 1 / (spacing * spacing);
      a += weight;
      b -= 2 * weight * earliest;
      c += weight * earliest * earliest;
      time = (-b + std::sqrt(std::max(0.0, b * b - 4 * a * c))) / (2 * a);
    }
    return time;
  };

  // One sweep for each way to walk the three axes: enough, since paths here bend little.
  const auto& size = grid.size;
  for (int sweep = 0; sweep < 8; ++sweep) {
    const bool back_i = (sweep & 1) != 0, back_j = (sweep & 2) != 0, back_k = (sweep & 4) != 0;
    for (int kk = 0; kk < size[2]; ++kk) {
      const int k = back_k ? size[2] - 1 - kk : kk;
      for (int jj = 0; jj < size[1]; ++jj) {
        const int j = back_j ? size[1] - 1 - jj : jj;
        for (int ii = 0; ii < size[0]; ++ii) {
          const int i = back_i ? size[0] - 1 - ii : ii;
          const std::size_t voxel = grid.offset(i, j, k);
          if (slowness_s_mm[voxel] > 0) arrival.values[voxel] = std::min(arrival.values[voxel], updated(i, j, k));
        }
      }
    }
  }
  return arrival;
}

MeasuredStiffness measure_stiffness(const Volume& true_shear_kPa, const Mask& liver, const Volume& wave_amplitude_um,
                                    std::uint64_t seed) {
  constexpr double inversion_window_mm = 3.2;  // standard deviation of the window that the inversion looks through
  constexpr double spoiled_border_mm = 3.0;    // about two voxels
  constexpr double weakest_wave_um = 0.6;      // under this the noise is as strong
  const Grid& grid = true_shear_kPa.grid;
  const Volume seen = blurred_where_positive(true_shear_kPa, inversion_window_mm);
  const Mask inner = segmentation::with_margin(liver, -spoiled_border_mm);

  const auto end_slice = [&](int k) { return k == 0 || k == grid.size[2] - 1; };
  MeasuredStiffness measured;
  measured.shear_kPa = filled(grid, "kPa", [&](int i, int j, int k) {
    const std::size_t voxel = grid.offset(i, j, k);
    const Vector3d position = grid.position_mm(i, j, k);
    double value = seen.values[voxel] * (1 + 0.25 * smooth_noise(seed + 601, position, 8));
    // At the border the wave's curvature is lost: too low, by a different amount everywhere.
    if (liver.values[voxel] != 0 && inner.values[voxel] == 0) {
      value *= 0.15 + 0.5 * (0.5 + 0.5 * smooth_noise(seed + 602, position, 5));
    }
    if (end_slice(k)) value *= 0.45 + 0.35 * smooth_noise(seed + 603, position, 12);
    return std::max(0.0, value);
  });
  measured.confidence = filled(grid, "", [&](int i, int j, int k) {
    const std::size_t voxel = grid.offset(i, j, k);
    const double needed = weakest_wave_um * (1 + 0.6 * smooth_noise(seed + 604, grid.position_mm(i, j, k), 9));
    const bool trusted = true_shear_kPa.values[voxel] > 0 && !end_slice(k) && wave_amplitude_um.values[voxel] > needed;
    return trusted ? 1.0 : 0.0;
  });
  return measured;
}

namespace {

// Published means differ by half; these are within them. They matter little: only waves on their way to the liver and
// the neighbourhood of its border see them.
double shear_beside_the_liver_kPa(Tissue tissue) {
  switch (tissue) {
    case Tissue::fat: return 1.4;
    case Tissue::muscle: return 3.2;
    case Tissue::spleen: return 4.8;
    case Tissue::kidney_cortex: return 4.2;
    case Tissue::kidney_medulla: return 5.0;
    case Tissue::pancreas: return 1.3;
    case Tissue::heart_muscle: return 6.0;
    case Tissue::stomach_wall: return 2.0;
    case Tissue::bowel_wall: return 1.5;
    case Tissue::bowel_content: return 1.0;
    case Tissue::disc: return 8.0;
    default: return 0;
  }
}

// A slow variation by a quarter, and patches of fibrosis some 4 cm wide that cover about a fifth of the liver.
double liver_shear_kPa(const Vector3d& p, const DemoStiffness& stiffness, std::uint64_t seed) {
  const double tissue = stiffness.liver_kPa * std::exp(0.45 * smooth_noise(seed + 401, p, 45));
  const double patch = smooth_step(0.2, 0.42, smooth_noise(seed + 402, p, 50) + 0.3 * smooth_noise(seed + 404, p, 17));
  return tissue + patch * (stiffness.fibrotic_kPa - stiffness.liver_kPa);
}

Mask shaken_at(const Volume& shear_kPa, const Vector3d& center_mm, double radius_mm) {
  const Grid& grid = shear_kPa.grid;
  Mask mask{grid, std::vector<std::uint8_t>(grid.voxels())};
  const auto carries = [&](int i, int j, int k) { return grid.contains(i, j, k) && shear_kPa.at(i, j, k) > 0; };
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        if (!carries(i, j, k) || (grid.position_mm(i, j, k) - center_mm).norm() > radius_mm) continue;
        const bool at_surface =
            !carries(i - 1, j, k) || !carries(i + 1, j, k) || !carries(i, j - 1, k) || !carries(i, j + 1, k);
        mask.at(i, j, k) = at_surface ? 1 : 0;
      }
    }
  }
  return mask;
}

// A Gaussian average over the voxels that carry waves, within each slice (inversions of 2-D MRE work slice by slice).
Volume blurred_where_positive(const Volume& volume, double sigma_mm) {
  const Grid& grid = volume.grid;
  const int reach = static_cast<int>(std::ceil(2.5 * sigma_mm / std::min(grid.spacing_mm[0], grid.spacing_mm[1])));
  return filled(grid, volume.unit.c_str(), [&](int i, int j, int k) {
    if (!(volume.at(i, j, k) > 0)) return 0.0;
    double sum = 0, weights = 0;
    for (int dj = -reach; dj <= reach; ++dj) {
      for (int di = -reach; di <= reach; ++di) {
        if (!grid.contains(i + di, j + dj, k) || !(volume.at(i + di, j + dj, k) > 0)) continue;
        const double squared_mm2 = std::pow(di * grid.spacing_mm[0], 2) + std::pow(dj * grid.spacing_mm[1], 2);
        const double weight = std::exp(-squared_mm2 / (2 * sigma_mm * sigma_mm));
        sum += weight * static_cast<double>(volume.at(i + di, j + dj, k));
        weights += weight;
      }
    }
    return sum / weights;
  });
}

}  // namespace
}  // namespace glisson::studies

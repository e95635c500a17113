#include "studies/demo/internal/images.h"

#include <cmath>

#include "base/noise.h"
#include "base/parallel.h"

namespace glisson::studies {
namespace {

using imaging::Grid;
using imaging::Volume;

// How bright a tissue is in each contrast, and how uneven (standard deviation of its texture, as a fraction).
struct Look {
  double t1 = 0;
  double elastography = 0;
  double texture = 0;
};
Look look_of(Tissue tissue);

// Between neighbours in a slice: how much of a voxel's signal comes from the voxels beside it.
struct Scanner {
  double neighbour_share;
  double noise;         // standard deviation of each of the two channels
  double field_uneven;  // how much the coils' sensitivity varies
};
Scanner scanner_for(Contrast contrast) {
  // The anatomy is of the type NORM: its coils' sensitivity was measured before and taken off, and a tenth is left.
  return contrast == Contrast::portal_venous_t1 ? Scanner{0.16, 9, 0.1} : Scanner{0.26, 11, 0.24};
}

// The same slices, each cut in two, so that a voxel can hold several tissues along the slice's normal.
Grid with_half_slices(const Grid& grid) {
  Grid halved = grid;
  halved.size[2] *= 2;
  halved.spacing_mm[2] /= 2;
  halved.origin_mm = grid.position_mm(Eigen::Vector3d(0, 0, -0.25));
  return halved;
}

void blur_rows(Volume& volume, double neighbour_share);
void blur_columns(Volume& volume, double neighbour_share);
double coil_sensitivity(const Eigen::Vector3d& position_mm, double uneven, std::uint64_t seed);

}  // namespace

Volume simulate_image(const DemoAnatomy& anatomy, const Grid& grid, Contrast contrast, std::uint64_t seed) {
  const TissueImage tissues = draw_tissues(anatomy, with_half_slices(grid), seed);
  const Scanner scanner = scanner_for(contrast);

  Volume volume;
  volume.grid = grid;
  volume.values.resize(grid.voxels());
  const auto rows = static_cast<std::size_t>(grid.size[1]) * static_cast<std::size_t>(grid.size[2]);
  parallel_for(rows, 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      const int j = static_cast<int>(row) % grid.size[1], k = static_cast<int>(row) / grid.size[1];
      for (int i = 0; i < grid.size[0]; ++i) {
        const Eigen::Vector3d position = grid.position_mm(i, j, k);
        const std::array<Look, 2> looks = {look_of(tissues.at(i, j, 2 * k)), look_of(tissues.at(i, j, 2 * k + 1))};
        const auto brightness = [&](const Look& look) {
          return contrast == Contrast::portal_venous_t1 ? look.t1 : look.elastography;
        };
        if (brightness(looks[0]) + brightness(looks[1]) == 0) continue;
        const double texture = smooth_noise(seed + 100, position, 6) + 0.8 * smooth_noise(seed + 101, position, 15);
        double signal = 0;
        for (const Look& look : looks) signal += 0.5 * brightness(look) * (1 + look.texture * texture / 0.4);
        volume.at(i, j, k) = static_cast<float>(signal * coil_sensitivity(position, scanner.field_uneven, seed));
      }
    }
  });
  blur_rows(volume, scanner.neighbour_share);
  blur_columns(volume, scanner.neighbour_share);

  const std::uint64_t noise_seed = seed + 1000 + static_cast<std::uint64_t>(contrast);
  parallel_for(volume.values.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Eigen::Vector2d noise = scanner.noise * normal_pair(noise_seed, i);
      volume.values[i] = static_cast<float>(std::hypot(volume.values[i] + noise.x(), noise.y()));
    }
  });
  return volume;
}

namespace {

// Brightness relative to the liver as in published portal venous T1 images, and as echo-planar images look; chosen by
// eye against such pictures, not measured.
Look look_of(Tissue tissue) {
  switch (tissue) {
    case Tissue::air: return {0, 0, 0};
    case Tissue::fat: return {92, 28, 0.12};
    case Tissue::muscle: return {150, 80, 0.09};
    case Tissue::marrow: return {118, 42, 0.15};
    case Tissue::cortical_bone: return {30, 12, 0.1};
    case Tissue::disc: return {105, 90, 0.06};
    case Tissue::spinal_canal: return {68, 300, 0.05};
    case Tissue::spinal_cord: return {165, 170, 0.04};
    case Tissue::lung: return {16, 8, 0.3};
    case Tissue::heart_muscle: return {225, 90, 0.06};
    case Tissue::blood: return {400, 60, 0.03};
    case Tissue::spleen: return {315, 230, 0.04};
    case Tissue::kidney_cortex: return {400, 240, 0.04};
    case Tissue::kidney_medulla: return {325, 260, 0.05};
    case Tissue::stomach_wall: return {228, 120, 0.08};
    case Tissue::stomach_content: return {78, 250, 0.22};
    case Tissue::bowel_wall: return {205, 110, 0.1};
    case Tissue::bowel_content: return {112, 200, 0.25};
    case Tissue::pancreas: return {222, 150, 0.1};
    case Tissue::bile: return {72, 330, 0.04};
    case Tissue::liver: return {270, 150, 0.035};
    case Tissue::portal_vein: return {385, 62, 0.02};
    case Tissue::hepatic_vein: return {372, 60, 0.02};
    case Tissue::artery: return {392, 58, 0.02};
    case Tissue::cyst: return {58, 320, 0.03};
    case Tissue::tumour: return {176, 215, 0.13};
    case Tissue::tumour_rim: return {300, 200, 0.07};
    case Tissue::tumour_core: return {118, 255, 0.16};
  }
  return {};
}

// Blurs a line of values in place with the kernel (s, 1 - 2s, s).
template <typename At>
void blur_line(int length, double share, At at) {
  const auto s = static_cast<float>(share);
  float before = at(0);
  for (int i = 0; i < length; ++i) {
    const float here = at(i), after = at(i + 1 < length ? i + 1 : i);
    at(i) = s * before + (1 - 2 * s) * here + s * after;
    before = here;
  }
}

void blur_rows(Volume& volume, double neighbour_share) {
  const auto& size = volume.grid.size;
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      blur_line(size[0], neighbour_share, [&](int i) -> float& { return volume.at(i, j, k); });
    }
  }
}

void blur_columns(Volume& volume, double neighbour_share) {
  const auto& size = volume.grid.size;
  for (int k = 0; k < size[2]; ++k) {
    for (int i = 0; i < size[0]; ++i) {
      blur_line(size[1], neighbour_share, [&](int j) -> float& { return volume.at(i, j, k); });
    }
  }
}

// Coils in front of and behind the body see the skin better than the middle; the transmitter adds a slow wave.
double coil_sensitivity(const Eigen::Vector3d& p, double uneven, std::uint64_t seed) {
  const double from_middle = std::abs(p.y() + 170) / 150;
  const double along = (p.z() + 300) / 120;
  return std::exp(uneven *
                  (from_middle * from_middle - 0.35 - 0.35 * along * along + 1.2 * smooth_noise(seed + 300, p, 190)));
}

}  // namespace
}  // namespace glisson::studies

#pragma once
// SIMULATED abdominal images around a liver's outline: neighbours that touch it and hardly differ from it, noise, and
// in MR a coil's light. The grey values are nobody's; the liver's shape is the outline's.
//
// T2, in and out of phase follow from relaxation times at 3 T. Liver, spleen, kidney, muscle, marrow and fat: de
// Bazelaire et al., Radiology 230:652, 2004; blood and heart: Stanisz et al., Magn Reson Med 54:507, 2005. How much of
// a tissue is fat, and what stomach and bowel hold, is assumed.

#include <algorithm>
#include <cmath>
#include <Eigen/Core>
#include <random>
#include <vector>

#include "anatomy/level_surface.h"
#include "geometry/surface.h"
#include "imaging/filters.h"
#include "imaging/image.h"
#include "segmentation/rasterise.h"

namespace glisson::test {

enum class Looks { portal_ct, native_ct, low_dose_ct, t1_mr, t2_mr, in_phase_mr, opposed_phase_mr, fatty_opposed_mr };

inline const char* name_of(Looks looks) {
  switch (looks) {
    case Looks::portal_ct: return "portal-venous CT";
    case Looks::native_ct: return "native CT";
    case Looks::low_dose_ct: return "low-dose CT";
    case Looks::t1_mr: return "T1 MR";
    case Looks::t2_mr: return "T2 MR";
    case Looks::in_phase_mr: return "in-phase MR";
    case Looks::opposed_phase_mr: return "opposed-phase MR";
    case Looks::fatty_opposed_mr: return "opposed-phase MR, a fatty liver";
  }
  return "";
}

inline bool is_mr(Looks looks) { return looks >= Looks::t1_mr; }

struct SimulatedAbdomen {
  imaging::Volume image;
  imaging::Mask liver;  // on the image's grid
};

namespace simulated_abdomen_detail {

using Eigen::Vector3d;

// What a tissue's water gives and, where both are told apart, its fat.
struct Signal {
  Signal(float of_water, float of_fat = 0) : water(of_water), fat(of_fat) {}
  float water, fat;
};

struct Brightness {
  Signal air, lung, fat, muscle, liver, spleen, heart, stomach, vein, kidney, bone, bowel, lesion;
  float noise;
};

// In thousandths of the signal that there is: a single-shot spin echo of 80 ms.
inline float spin_echo(double t2_ms) { return static_cast<float>(1000 * std::exp(-80 / t2_ms)); }
// A spoiled gradient echo of 65 degrees every 150 ms, of which so much is fat (T1 382 ms).
inline Signal gradient_echo(double t1_ms, double fat_share = 0) {
  const auto signal = [](double t1) {
    const double left = std::exp(-150 / t1), angle = 65 * 3.14159265358979 / 180;
    return 1000 * std::sin(angle) * (1 - left) / (1 - std::cos(angle) * left);
  };
  return {static_cast<float>((1 - fat_share) * signal(t1_ms)), static_cast<float>(fat_share * signal(382))};
}

inline Brightness brightness_of(Looks looks) {
  const auto of_phases = [](double liver_fat) -> Brightness {
    const Signal liver = gradient_echo(809, liver_fat), fluid = gradient_echo(1800);
    return {2,
            8,
            gradient_echo(898, 0.92),
            gradient_echo(898, 0.02),
            liver,
            gradient_echo(1328),
            gradient_echo(1600),
            fluid,
            gradient_echo(1932),
            gradient_echo(1142),
            gradient_echo(900, 0.45),
            fluid,
            gradient_echo(1200),
            13};
  };
  switch (looks) {
    case Looks::portal_ct: return {-1000, -850, -100, 62, 108, 118, 125, 85, 135, 175, 300, 45, 66.4F, 18};
    case Looks::native_ct: return {-1000, -850, -100, 55, 58, 50, 42, 35, 42, 32, 280, 30, 26.4F, 12};
    case Looks::low_dose_ct: return {-1000, -850, -100, 60, 100, 108, 112, 80, 118, 160, 300, 45, 60, 40};
    case Looks::t1_mr: return {5, 15, 430, 190, 300, 215, 240, 230, 150, 180, 120, 260, 326, 16};
    case Looks::t2_mr:  // blood flows out of its slice, the heart beats
      return {1,   4,  spin_echo(68), spin_echo(29), spin_echo(34), spin_echo(61), 110,
              550, 20, 349,           spin_echo(49), 450,           spin_echo(70), 5.5F};
    case Looks::in_phase_mr:
    case Looks::opposed_phase_mr: return of_phases(0.04);
    case Looks::fatty_opposed_mr: return of_phases(0.2);
  }
  return {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
}

struct Blob {
  Vector3d middle_mm, half_mm;
  Signal value;
  [[nodiscard]] bool holds(const Vector3d& at) const {
    return (at - middle_mm).cwiseQuotient(half_mm).squaredNorm() < 1;
  }
};

// The place of the liver's voxels that is farthest in a direction.
inline Vector3d farthest(const imaging::Mask& liver, const Vector3d& way) {
  Vector3d best = Vector3d::Zero();
  double most = -1e300;
  for (int k = 0; k < liver.grid.size[2]; ++k) {
    for (int j = 0; j < liver.grid.size[1]; ++j) {
      for (int i = 0; i < liver.grid.size[0]; ++i) {
        if (liver.at(i, j, k) == 0) continue;
        const Vector3d at = liver.grid.position_mm(i, j, k);
        if (at.dot(way) > most) most = at.dot(way), best = at;
      }
    }
  }
  return best;
}

}  // namespace simulated_abdomen_detail

// The liver given as a closed surface (LPS, mm). The same number gives the same image.
inline SimulatedAbdomen simulated_abdomen(const geometry::Surface& outline, Looks looks, unsigned number,
                                          double spacing_mm = 3) {
  using namespace simulated_abdomen_detail;
  std::mt19937 random(number);
  const auto drawn = [&random](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  geometry::Box box = geometry::bounding_box(outline.points_mm);
  const Vector3d low = box.min_mm, high = box.max_mm;
  box.min_mm -= Vector3d(20, 30, 30);
  box.max_mm += Vector3d(110, 50, 40);
  SimulatedAbdomen made;
  made.liver = segmentation::rasterise(outline, anatomy::grid_over(box, spacing_mm));
  const imaging::Grid& grid = made.liver.grid;
  const Brightness b = brightness_of(looks);
  const auto about = [&](Signal value, double by) {
    return Signal{value.water + static_cast<float>(drawn(-by, by)), value.fat};
  };
  const double by = is_mr(looks) ? static_cast<double>(b.liver.water) / 15 : 8;

  // The body's wall touches the liver on its right; the cavity's middle lies to its left.
  const double half_x = drawn(135, 160), half_y = 0.72 * half_x;
  const Vector3d cavity(low.x() + half_x - 4, 0.5 * (low.y() + high.y()) + drawn(0, 12), 0);
  const Vector3d left_tip = farthest(made.liver, {1, -0.2, 0}), back = farthest(made.liver, {0.3, 1, 0});
  const Vector3d bottom = farthest(made.liver, {0, 0, -1}), top = farthest(made.liver, {0, 0, 1});
  const Vector3d over_left = farthest(made.liver, {0.5, -0.3, 1});
  std::vector<Blob> blobs{
      {left_tip + Vector3d(28, 22, drawn(-25, -5)), {drawn(38, 48), 36, drawn(48, 62)}, about(b.stomach, by)},
      {over_left + Vector3d(drawn(5, 20), 5, 28), {55, 45, drawn(36, 42)}, about(b.heart, by)},
      {Vector3d(cavity.x() + 0.72 * half_x, cavity.y() + 45, top.z() - 60), {32, 42, 55}, about(b.spleen, by)},
      {bottom + Vector3d(25, 30, drawn(5, 25)), {30, 28, 55}, about(b.kidney, by)},
      {bottom + Vector3d(70, -30, -15), {60, 28, 28}, about(b.bowel, by)}};
  const Vector3d cava(back.x() + drawn(10, 25), back.y() - drawn(4, 12), 0);
  const double cava_mm = drawn(11, 15);
  const Signal vein = about(b.vein, by), muscle = about(b.muscle, by / 2), liver = about(b.liver, by);
  const Signal lesion_value{liver.water + b.lesion.water - b.liver.water, b.lesion.fat};
  struct Lesion {
    Vector3d middle_mm;
    double radius_mm;
  };
  std::vector<Lesion> lesions;
  const std::size_t voxels = grid.voxels();
  for (int tries = 0; tries < 2000 && lesions.size() < 3; ++tries) {
    const auto voxel = static_cast<std::size_t>(drawn(0, static_cast<double>(voxels) - 1));
    if (made.liver.values[voxel] == 0) continue;
    const auto nx = static_cast<std::size_t>(grid.size[0]), ny = static_cast<std::size_t>(grid.size[1]);
    lesions.push_back({grid.position_mm(static_cast<int>(voxel % nx), static_cast<int>(voxel / nx % ny),
                                        static_cast<int>(voxel / (nx * ny))),
                       drawn(5, 16)});
  }

  // The diaphragm: lungs lie above the highest liver of each column and what lies around it, smoothly.
  std::vector<float> height(static_cast<std::size_t>(grid.size[0]) * static_cast<std::size_t>(grid.size[1]),
                            static_cast<float>(top.z() - 55));
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        float& h = height[static_cast<std::size_t>(i + grid.size[0] * j)];
        if (made.liver.at(i, j, k) != 0) h = std::max(h, static_cast<float>(grid.position_mm(i, j, k).z() + 3));
      }
    }
  }
  made.image.grid = grid;
  made.image.unit = is_mr(looks) ? "" : "HU";
  made.image.values.resize(voxels);
  std::vector<float> fat(voxels);
  std::vector<float> texture(voxels), bowel(voxels);
  std::normal_distribution<float> normal(0, 1);
  for (float& value : texture) value = normal(random);
  for (float& value : bowel) value = normal(random);
  texture = imaging::gaussian_blur(std::move(texture), grid, 8);
  bowel = imaging::gaussian_blur(std::move(bowel), grid, 9);
  const auto scale_of = [](const std::vector<float>& values) {
    double sum = 0;
    for (const float value : values) sum += static_cast<double>(value) * static_cast<double>(value);
    return static_cast<float>(1 / std::sqrt(sum / static_cast<double>(values.size())));
  };
  const float to_texture = scale_of(texture) * (is_mr(looks) ? b.liver.water / 30 : 5.0F), to_bowel = scale_of(bowel);

  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        const std::size_t voxel = grid.offset(i, j, k);
        const Vector3d at = grid.position_mm(i, j, k);
        const double from_middle =
            Eigen::Vector2d((at.x() - cavity.x()) / half_x, (at.y() - cavity.y()) / half_y).norm();
        const double wall_mm = (from_middle - 1) * half_y;
        Signal value = b.air;
        if (wall_mm < 32) value = b.fat;
        if (wall_mm < 16) value = muscle;
        if (wall_mm < 0) {
          value = bowel[voxel] * to_bowel > 0.7F ? b.bowel : b.fat;
          if (at.z() > static_cast<double>(height[static_cast<std::size_t>(i + grid.size[0] * j)])) value = b.lung;
          for (const Blob& blob : blobs) {
            if (blob.holds(at)) value = blob.value;
          }
          if (std::hypot(at.x() - cava.x(), at.y() - cava.y()) < cava_mm) value = vein;
        }
        if (std::hypot(at.x() - cavity.x(), at.y() - cavity.y() - half_y + 5) < 24) value = b.bone;
        if (made.liver.values[voxel] != 0) {
          value = liver;
          for (const Lesion& lesion : lesions) {
            if ((at - lesion.middle_mm).norm() < lesion.radius_mm) value = lesion_value;
          }
        }
        const float darkest_tissue = b.lung.water + (is_mr(looks) ? b.liver.water / 6 : 50);
        made.image.values[voxel] = value.water + (value.water > darkest_tissue ? texture[voxel] * to_texture : 0.0F);
        fat[voxel] = value.fat;
      }
    }
  }
  made.image.values = imaging::gaussian_blur(std::move(made.image.values), grid, 1.5);
  fat = imaging::gaussian_blur(std::move(fat), grid, 1.5);
  const bool opposed = looks == Looks::opposed_phase_mr || looks == Looks::fatty_opposed_mr;
  for (std::size_t voxel = 0; voxel < voxels && is_mr(looks); ++voxel) {
    float& value = made.image.values[voxel];
    value = opposed ? std::abs(value - fat[voxel]) : value + fat[voxel];  // what is half fat gives nothing opposed
  }
  const Vector3d slope(drawn(-0.0018, 0.0018), drawn(-0.0018, 0.0018), drawn(-0.001, 0.001));
  std::normal_distribution<float> noise(0, b.noise);
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        float& value = made.image.at(i, j, k);
        if (is_mr(looks)) {
          const Vector3d off = grid.position_mm(i, j, k) - 0.5 * (low + high);
          value *= static_cast<float>(std::exp(slope.dot(off)));
          value = std::hypot(value + noise(random), noise(random));
        } else {
          value += noise(random);
        }
      }
    }
  }
  return made;
}

}  // namespace glisson::test

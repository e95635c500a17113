#include "anatomy/liver_shape.h"

#include <algorithm>
#include <cmath>

#include "base/noise.h"

namespace glisson::anatomy {

using Eigen::Vector3d;

LiverShape::LiverShape(const ShapeModes& m, LobeVariant variant, std::uint64_t seed)
    : seed_(seed), margin_mm_(9 + 2 * m.margin), has_left_(variant != LobeVariant::no_left_lobe) {
  const double deep = 1 + 0.05 * m.depth, wide = 1 / deep;
  const double right = variant == LobeVariant::small_right_lobe ? 0.62 : 1;
  const double left = variant == LobeVariant::small_right_lobe ? 1.25 : 1;
  const double dome_mm = 6 * m.dome, low_mm = 9 * m.right_length;

  right_ = ellipsoid({-70 * wide * right, 0, 0.5 * (dome_mm - low_mm) - 14},
                     {70 * wide * right, 94 * deep, (100 + 0.5 * (dome_mm + low_mm)) * right}, {0, 6, 0});
  left_ = ellipsoid({24 + 8 * m.left_extent, -46 * deep, 29 + 0.5 * dome_mm},
                    {(76 + 12 * m.left_extent) * wide * left, 48 * deep * left, (31 + 4 * m.left_thickness) * left},
                    {0, -8, 12});
  quadrate_ = ellipsoid({-22, -42 * deep, 4}, {52 * wide, 48 * deep, 56 + 5 * m.quadrate}, {0, 0, 0});
  caudate_ = ellipsoid({-8, 2, 22}, {23 + 2 * m.caudate, 17 + 1.5 * m.caudate, 37}, {-8, 0, 0});
  papillary_ = ellipsoid({0, -3, -6}, {12 + m.caudate, 10, 12 + m.caudate}, {0, 0, 0});

  neighbours_ = {
      ellipsoid({-8, 16, -106}, {90, 118, 106}, {0, 0, 10}),         // duodenum, colon, pancreas
      ellipsoid({82, 22, -12}, {86, 66, 66}, {0, 0, 0}),             // stomach
      ellipsoid({-66, 74, -64}, {38, 42, 66}, {10, 0, 25}),          // right kidney
      ellipsoid({-70, -10, -100 - low_mm}, {42, 46, 46}, {0, 0, 0})  // right bend of the colon
  };
  spine_ = ellipsoid({4, 74, 10}, {46, 50, 260}, {0, 0, 0});

  cava_ = {{{-27, 14, -150}, {-26, 14, -50}, {-24, 10, 0}, {-21, 2, 40}, {-18, -6, 72}, {-16, -9, 100}},
           {11.5, 11.5, 12, 12.5, 13, 13}};
  gall_bladder_ =
      smoothed({{{-24, -20, -7}, {-27, -30, -13}, {-32, -43, -22}, {-38, -57, -33}, {-43, -70, -43}, {-46, -78, -50}},
                {2.5, 5, 9, 12.5, 14, 12.5}});
  porta_ = {{{-44, -4, -3}, {-22, -12, -2}, {4, -22, 2}}, {5, 6, 4}};
  teres_ = {{{4, -26, 4}, {8, -50, -10}, {10, -84, -30}, {11, -112, -48}}, {3, 4, 5, 6}};
  venosum_ = {{6, -24, 0}, {-16, 12, 46}, {34, 10, 2}, 2.2};
}

double LiverShape::umbilical_plane_mm(const Vector3d& p) const { return p.x() - (4 - 0.07 * (p.y() + 26)); }

double LiverShape::gall_bladder_mm(const Vector3d& p) const { return gall_bladder_.distance_mm(p); }

double LiverShape::distance_mm(const Vector3d& p) const {
  double liver = united(right_.distance_mm(p), quadrate_.distance_mm(p), 40);
  if (has_left_) liver = united(liver, left_.distance_mm(p), 26);
  if (liver > 25) return liver;
  for (const Ellipsoid& neighbour : neighbours_) liver = without(liver, neighbour.distance_mm(p), margin_mm_);
  liver = united(liver, united(caudate_.distance_mm(p), papillary_.distance_mm(p), 6), 8);
  liver = without(liver, spine_.distance_mm(p), 8);
  liver += 1.6 * smooth_noise(seed_ + 11, p, 45) + 0.5 * smooth_noise(seed_ + 12, p, 16);
  liver = without(liver, cava_.distance_mm(p) - 0.8, 3);
  liver = without(liver, gall_bladder_.distance_mm(p) - 0.4, 6);
  liver = without(liver, porta_.distance_mm(p), 8);
  liver = without(liver, teres_.distance_mm(p), 6);
  if (has_left_) liver = without(liver, venosum_.distance_mm(p), 4);
  // Where the falciform ligament holds on: a shallow groove over the front and the dome.
  const double from_plane = umbilical_plane_mm(p) / 4;
  if (p.y() < -20 && std::abs(from_plane) < 4) liver += 1.8 * std::exp(-from_plane * from_plane);
  return liver;
}

}  // namespace glisson::anatomy

#include "studies/demo/internal/body.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <numbers>
#include <optional>

#include "base/noise.h"

namespace glisson::studies {
namespace {

using Eigen::Vector3d;

// Where the generator puts the porta: bodies of other sizes are scaled about it (anatomy/liver_body.h).
const Vector3d porta_mm(0, -163, -285);

// The outline in axial planes: a superellipse |x/a|^n + |y/b|^n = 1.
constexpr double outline_x_mm = 186, outline_y_mm = 148, outline_power = 2.35;
const Vector3d body_center(0, -163, -300);

constexpr double muscle_wall_mm = 11;
constexpr double deepest_wall_mm = 45;  // no part of the body's wall lies deeper
constexpr double diaphragm_mm = 3.5;

// The lattice that holds the diaphragm's height.
constexpr double dome_pitch_mm = 6;
constexpr int dome_columns = 68, dome_rows = 56;
constexpr double dome_x0_mm = -200, dome_y0_mm = -325;

Ellipsoid tilted(const Vector3d& center, const Vector3d& semi_axes, double about_x_deg, double about_z_deg) {
  constexpr double degree = std::numbers::pi / 180;
  return {center, semi_axes,
          (Eigen::AngleAxisd(about_z_deg * degree, Vector3d::UnitZ()) *
           Eigen::AngleAxisd(about_x_deg * degree, Vector3d::UnitX()))
              .toRotationMatrix()};
}

const Ellipsoid heart = tilted({34, -206, -188}, {62, 46, 41}, 0, 35);
const Ellipsoid left_ventricle = tilted({52, -196, -188}, {36, 24, 27}, 0, 35);
const Ellipsoid right_ventricle = tilted({18, -222, -190}, {38, 17, 27}, 0, 30);
const Ellipsoid right_atrium = tilted({-14, -190, -186}, {22, 24, 26}, 0, 0);
const Ellipsoid spleen = tilted({124, -104, -262}, {25, 52, 50}, 18, -25);
const Ellipsoid spleen_hollow = tilted({98, -128, -262}, {26, 46, 40}, 18, -25);
const Ellipsoid right_kidney = tilted({-66, -92, -352}, {29, 24, 55}, 10, 25);
const Ellipsoid left_kidney = tilted({76, -92, -330}, {29, 25, 57}, 10, -25);
const std::array<Ellipsoid, 3> stomach = {tilted({80, -170, -262}, {40, 44, 36}, 0, 0),
                                          tilted({78, -205, -290}, {34, 46, 34}, 25, 20),
                                          tilted({34, -228, -322}, {44, 24, 22}, 0, -15)};
const std::array<Ellipsoid, 5> pancreas = {
    tilted({-22, -188, -332}, {17, 14, 24}, 0, 0), tilted({4, -190, -318}, {22, 10, 12}, 0, 10),
    tilted({36, -180, -306}, {24, 10, 12}, 0, 20), tilted({66, -164, -298}, {22, 10, 12}, 0, 30),
    tilted({92, -146, -290}, {18, 10, 12}, 0, 35)};

// The aorta before the spine, which follows it: farther back where the chest begins. By eye, as anatomy books draw it.
Vector3d aorta_at(double z) { return {4, -138 - 15 * std::tanh((-z - 285) / 55), z}; }

double flat_distance(const Vector3d& a, const Vector3d& b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

std::optional<Tissue> spine_at(const Vector3d& p);
std::optional<Tissue> kidney_at(const Ellipsoid& kidney, const Vector3d& p);
std::optional<Tissue> stomach_at(const Vector3d& p, std::uint64_t seed);
bool on_a_vessel(std::uint64_t seed, const Vector3d& p, double length_mm);

}  // namespace

double Ellipsoid::level(const Vector3d& position_mm) const {
  return (axes.transpose() * (position_mm - center_mm)).cwiseQuotient(semi_axes_mm).norm();
}

double Ellipsoid::depth_mm(const Vector3d& position_mm) const {
  return (1 - level(position_mm)) * semi_axes_mm.minCoeff();
}

// The diaphragm lies on the liver: from every point of the liver's surface it may fall off no faster than a parabola.
// The left half is a dome of its own, and around them the lungs end in a rim, lower behind. The greatest of all these
// is its height.
DemoBody::DemoBody(const geometry::Surface& liver, double size, std::uint64_t seed) : size_(size), seed_(seed) {
  constexpr double curvature_mm = 5, left_curvature_mm = 80;
  const Vector3d left_top(76, -150, -226);
  std::vector<Vector3d> liver_mm = liver.points_mm;
  for (Vector3d& point : liver_mm) point = at_size_1(point);
  for (int row = 0; row < dome_rows; ++row) {
    for (int column = 0; column < dome_columns; ++column) {
      const double x = dome_x0_mm + column * dome_pitch_mm, y = dome_y0_mm + row * dome_pitch_mm;
      const double from_left_mm = flat_distance({x, y, 0}, left_top);
      const double rim_mm = -305 + 65 * std::clamp((-30 - y) / 270, 0.0, 1.0) + 14 * smooth_noise(seed, {x, y, 0}, 60);
      double height = std::max(rim_mm, left_top.z() - from_left_mm * from_left_mm / (2 * left_curvature_mm));
      for (const Vector3d& point : liver_mm) {
        const double squared = (point.x() - x) * (point.x() - x) + (point.y() - y) * (point.y() - y);
        height = std::max(height, point.z() - squared / (2 * curvature_mm));
      }
      dome_mm_.push_back(height);
    }
  }

  // Loops of bowel: chance places in the lower belly, before the kidneys.
  for (std::uint64_t i = 0; i < 90; ++i) {
    const auto chance = [&](std::uint64_t k) { return uniform(seed + 71, 16 * i + k); };
    const double radius = 10 + 7 * chance(0);
    bowel_.push_back(tilted({-95 + 225 * chance(1), -275 + 125 * chance(2), -425 + 95 * chance(3)},
                            {radius * (1 + 1.2 * chance(4)), radius, radius}, 90 * chance(5), 360 * chance(6)));
  }
  // The colon: its right and left bends, and what rises to them.
  bowel_.push_back(tilted({-88, -150, -412}, {24, 24, 40}, 0, 0));
  bowel_.push_back(tilted({118, -150, -330}, {22, 22, 45}, 0, 0));
  bowel_.push_back(tilted({132, -125, -390}, {20, 20, 50}, 0, 0));
}

Vector3d DemoBody::at_size_1(const Vector3d& position_mm) const { return porta_mm + (position_mm - porta_mm) / size_; }

Tissue DemoBody::tissue_at(const Vector3d& position_mm) const {
  const Vector3d p = at_size_1(position_mm);
  const double depth = depth_under_skin_mm(p);
  if (depth < 0) return Tissue::air;
  if (depth < 2) return Tissue::muscle;  // skin, about as bright
  if (const auto spine = spine_at(p)) return *spine;
  if (depth < deepest_wall_mm) {
    const double depth_in_wall = depth - fat_thickness_mm(p);
    if (depth_in_wall < muscle_wall_mm) return wall_at(p, depth_in_wall);
  }
  return p.z() > diaphragm_height_mm(p) ? chest_at(p) : abdomen_at(p);
}

double DemoBody::depth_under_skin_mm(const Vector3d& p) const {
  const Vector3d from = p - body_center;
  const double distance = std::hypot(from.x(), from.y());
  if (distance < 1) return outline_y_mm;
  // Narrower at the waist and flatter at the back; a little uneven.
  const double waist = 1 - 0.05 * std::clamp((body_center.z() - p.z()) / 120, 0.0, 1.0);
  const double back = from.y() > 0 ? 0.96 : 1.0;
  const double level = std::pow(std::pow(std::abs(from.x()) / (outline_x_mm * waist), outline_power) +
                                    std::pow(std::abs(from.y()) / (outline_y_mm * back), outline_power),
                                1 / outline_power);
  const double furrow = from.y() > 0 ? 9 * std::exp(-std::pow(from.x() / 16, 2)) : 0;  // over the spine
  const double depth = distance / level * (1 - level) - furrow;
  return depth > deepest_wall_mm ? depth : depth + 3 * smooth_noise(seed_ + 1, p, 70);
}

double DemoBody::fat_thickness_mm(const Vector3d& p) const {
  const Vector3d from = (p - body_center).normalized();
  const double flank = std::abs(from.x());
  const double low = std::clamp((-280 - p.z()) / 120, 0.0, 1.0);
  return 9 + 4 * flank * (from.y() > 0 ? 1 : 0.2) + 5 * low + 2 * smooth_noise(seed_ + 2, p, 60);
}

double DemoBody::diaphragm_height_mm(const Vector3d& p) const {
  const double u = std::clamp((p.x() - dome_x0_mm) / dome_pitch_mm, 0.0, dome_columns - 1.001);
  const double v = std::clamp((p.y() - dome_y0_mm) / dome_pitch_mm, 0.0, dome_rows - 1.001);
  const auto column = static_cast<std::size_t>(u), row = static_cast<std::size_t>(v);
  const double s = u - static_cast<double>(column), t = v - static_cast<double>(row);
  const auto at = [&](std::size_t c, std::size_t r) { return dome_mm_[c + dome_columns * r]; };
  return (1 - t) * ((1 - s) * at(column, row) + s * at(column + 1, row)) +
         t * ((1 - s) * at(column, row + 1) + s * at(column + 1, row + 1)) + diaphragm_mm;
}

// Fat under the skin, then muscle with the ribs in it. A rib runs down from the spine to the front.
Tissue DemoBody::wall_at(const Vector3d& p, double depth_in_wall_mm) const {
  if (depth_in_wall_mm < 0) return Tissue::fat;
  const Vector3d from = p - body_center;
  const double around_rad = std::atan2(std::abs(from.x()), from.y());  // 0 at the back, pi at the front
  const double costal_margin_mm = -375 + 95 * std::pow(around_rad / std::numbers::pi, 2);
  if (p.z() > costal_margin_mm && around_rad > 0.25 && around_rad < 2.75) {
    constexpr double pitch_mm = 28;
    const double along = p.z() + 42 * around_rad;
    const double across = along - pitch_mm * std::round(along / pitch_mm);
    const double level = std::hypot(across / 8.5, (depth_in_wall_mm - 5.5) / 4.5);
    if (level < 0.62) return Tissue::marrow;
    if (level < 1) return Tissue::cortical_bone;
    if (std::abs(depth_in_wall_mm - 5.5) > 4.6 && std::abs(across) > 9) return Tissue::fat;  // between the muscles
  }
  // The layers of the belly's muscles, told apart by thin fat.
  if (p.z() < costal_margin_mm && std::abs(depth_in_wall_mm - 5) < 0.7) return Tissue::fat;
  return Tissue::muscle;
}

Tissue DemoBody::chest_at(const Vector3d& p) const {
  if (left_ventricle.level(p) < 0.68 || right_ventricle.level(p) < 0.86 || right_atrium.level(p) < 0.92) {
    return Tissue::blood;
  }
  if (left_ventricle.level(p) < 1 || right_ventricle.level(p) < 1 || right_atrium.level(p) < 1) {
    return Tissue::heart_muscle;
  }
  if (heart.level(p) < 1) return Tissue::fat;
  const Vector3d aorta = aorta_at(p.z());
  if (flat_distance(p, aorta) < 12) return Tissue::blood;
  if (flat_distance(p, aorta + Vector3d(-4, -22, 0)) < 8) return Tissue::muscle;    // oesophagus
  if (flat_distance(p, {-16, -174, 0}) < 13 && p.z() > -195) return Tissue::blood;  // vena cava to the atrium
  if (flat_distance(p, aorta + Vector3d(-2, -10, 0)) < 26) return Tissue::fat;
  if (p.z() < diaphragm_height_mm(p) + 1.5) return Tissue::muscle;
  return on_a_vessel(seed_ + 50, p, 20) ? Tissue::blood : Tissue::lung;
}

Tissue DemoBody::abdomen_at(const Vector3d& p) const {
  if (p.z() > diaphragm_height_mm(p) - diaphragm_mm) return Tissue::muscle;
  const Vector3d aorta = aorta_at(p.z());
  if (flat_distance(p, aorta) < 10.5) return Tissue::blood;
  if (p.z() < -425 && flat_distance(p, {-27, -149, 0}) < 11.5) return Tissue::blood;  // vena cava below the liver's
  if (const auto organ = stomach_at(p, seed_ + 10)) return *organ;
  if (spleen_hollow.level(p) > 1 && spleen.level(p) < 1) return Tissue::spleen;
  for (const Ellipsoid& kidney : {right_kidney, left_kidney}) {
    if (const auto organ = kidney_at(kidney, p)) return *organ;
  }
  for (const Ellipsoid& part : pancreas) {
    const double depth = part.depth_mm(p);
    constexpr double lobules_mm = 2.5;
    if (depth > -lobules_mm && depth > lobules_mm * smooth_noise(seed_ + 6, p, 9)) return Tissue::pancreas;
  }
  // Psoas beside the lower spine, the diaphragm's crura beside the aorta above.
  for (const double side : {-1.0, 1.0}) {
    const double low = std::clamp((-300 - p.z()) / 120, 0.0, 1.0);
    if (p.z() < -300 && flat_distance(p, aorta + Vector3d(side * (38 + 8 * low), 46, 0)) < 10 + 12 * low) {
      return Tissue::muscle;
    }
    if (p.z() > -345 && flat_distance(p, aorta + Vector3d(side * 18, 8, 0)) < 6) return Tissue::muscle;
  }
  for (std::size_t i = 0; i < bowel_.size(); ++i) {
    const double reach_mm = bowel_[i].semi_axes_mm.maxCoeff() + 5;
    if ((p - bowel_[i].center_mm).squaredNorm() > reach_mm * reach_mm) continue;
    const double depth = bowel_[i].depth_mm(p) + 3 * smooth_noise(seed_ + 9, p, 16);
    if (depth < 0) continue;
    if (depth < 2.5) return Tissue::bowel_wall;
    const bool gas = uniform(seed_ + 8, i) < 0.3 && p.y() < bowel_[i].center_mm.y() - 2;
    return gas ? Tissue::air : Tissue::bowel_content;
  }
  return on_a_vessel(seed_ + 60, p, 26) ? Tissue::blood : Tissue::fat;  // of the mesentery
}

namespace {

// Vertebrae of 26 mm and discs of 8 mm, the canal behind, the arch and its processes, the long muscles of the back.
std::optional<Tissue> spine_at(const Vector3d& p) {
  const Vector3d aorta = aorta_at(p.z());
  const Vector3d body = aorta + Vector3d(-3, 36, 0);
  const double x = p.x() - body.x(), y = p.y() - body.y();
  constexpr double pitch_mm = 34, disc_mm = 8;
  const double in_segment = p.z() - pitch_mm * std::floor(p.z() / pitch_mm);
  const double level = std::hypot(x / 23, y / 18);
  if (level < 1) {
    if (in_segment < disc_mm) return Tissue::disc;
    return level < 0.93 && in_segment > disc_mm + 1 && in_segment < pitch_mm - 1 ? Tissue::marrow
                                                                                 : Tissue::cortical_bone;
  }
  const double canal = std::hypot(x / 11, (y - 26) / 9);
  if (std::hypot(x / 5.5, (y - 26) / 4.5) < 1) return Tissue::spinal_cord;
  if (canal < 1) return Tissue::spinal_canal;
  const bool arch = canal < 1.45 && in_segment > 10;
  const bool spinous = std::abs(x) < 3.5 && y > 34 && y < 62 && in_segment > 4 && in_segment < 26;
  const bool transverse =
      std::abs(y - 24 - 0.15 * std::abs(x)) < 4.5 && std::abs(x) < 42 && in_segment > 14 && in_segment < 26;
  if (arch || spinous || transverse) {
    return (arch ? canal > 1.12 && canal < 1.35 : std::abs(x) < 2 || transverse) ? Tissue::marrow
                                                                                 : Tissue::cortical_bone;
  }
  for (const double side : {-1.0, 1.0}) {
    const double muscle = std::pow(std::abs((x - side * 31) / 29), 2.5) + std::pow(std::abs((y - 47) / 20), 2.5);
    if (muscle < 1) return muscle > 0.93 || std::abs(x - side * 24) < 0.8 ? Tissue::fat : Tissue::muscle;
  }
  return std::nullopt;
}

// Cortex, pyramids of medulla, and fat in the sinus that opens to the middle.
std::optional<Tissue> kidney_at(const Ellipsoid& kidney, const Vector3d& p) {
  const double level = kidney.level(p);
  if (level > 1) return std::nullopt;
  const Vector3d inside = kidney.axes.transpose() * (p - kidney.center_mm);
  const double inward = kidney.center_mm.x() < 0 ? 1 : -1;
  const double sinus = std::hypot((inside.x() - inward * 12) / 14, inside.y() / 9, inside.z() / 26);
  if (sinus < 1) return sinus < 0.35 ? Tissue::kidney_medulla : Tissue::fat;
  const double columns = std::sin(inside.z() / 5.5) * std::cos(std::atan2(inside.y(), inside.x()) * 4);
  return level < 0.78 && columns > -0.25 ? Tissue::kidney_medulla : Tissue::kidney_cortex;
}

std::optional<Tissue> stomach_at(const Vector3d& p, std::uint64_t seed) {
  constexpr double folds_mm = 6;
  double depth = -folds_mm - 1;
  for (const Ellipsoid& part : stomach) depth = std::max(depth, part.depth_mm(p));
  if (depth < -folds_mm) return std::nullopt;
  depth += folds_mm * smooth_noise(seed, p, 24);
  if (depth < 0) return std::nullopt;
  if (depth < 4) return Tissue::stomach_wall;
  constexpr double fluid_level_mm = -226;  // the patient lies on the back: gas in front
  return p.y() < fluid_level_mm ? Tissue::air : Tissue::stomach_content;
}

// Thin winding tubes: where two random fields vanish together.
bool on_a_vessel(std::uint64_t seed, const Vector3d& p, double length_mm) {
  constexpr double thickness = 0.075;
  return std::abs(smooth_noise(seed, p, length_mm)) < thickness &&
         std::abs(smooth_noise(seed + 1, p, length_mm)) < thickness;
}

}  // namespace
}  // namespace glisson::studies

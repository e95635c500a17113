#include "studies/review/internal/example_scene.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <limits>
#include <numbers>

#include "geometry/manifold.h"
#include "vision/draw.h"

namespace glisson::studies {
namespace {

using Eigen::Vector3d;

constexpr double focal_px = 560;
constexpr double camera_distance_mm = 150;
constexpr double unseen_mm = std::numeric_limits<double>::infinity();

// From below the ribs, up and backwards, as through a port at the navel. LPS: y to the back, z to the head.
Eigen::Matrix3d camera_axes() {
  const Vector3d away = Vector3d(0, 0.96, 0.28).normalized();
  Eigen::Matrix3d axes;
  axes.row(0) = Vector3d::UnitX();  // the patient's left is to the right of the picture
  axes.row(2) = away;
  axes.row(1) = away.cross(Vector3d::UnitX());
  return axes;
}

// Smooth noise in 0..1 whose grain is about one unit: values at whole places, told from their numbers, and
// between them linearly.
double noise(const Vector3d& place) {
  const auto value_at = [](std::int64_t x, std::int64_t y, std::int64_t z) {
    auto h = static_cast<std::uint64_t>(x * 73856093 ^ y * 19349663 ^ z * 83492791);
    h ^= h >> 33;
    h *= 0xff51afd7ed558ccdULL;
    h ^= h >> 33;
    return static_cast<double>(h & 0xffff) / 65535.0;
  };
  const Vector3d floor = place.array().floor();
  const Vector3d within = place - floor;
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    double weight = 1;
    std::int64_t at[3];
    for (int axis = 0; axis < 3; ++axis) {
      const bool far = (corner >> axis) % 2 == 1;
      weight *= far ? within[axis] : 1 - within[axis];
      at[axis] = static_cast<std::int64_t>(floor[axis]) + (far ? 1 : 0);
    }
    sum += weight * value_at(at[0], at[1], at[2]);
  }
  return sum;
}

// Liver under a lamp beside the camera.
vision::Rgb colour_of(const Vector3d& rest_mm, const Vector3d& place_mm, const Vector3d& normal) {
  const Vector3d to_camera = -place_mm.normalized();
  const double facing = std::max(0.0, normal.dot(to_camera));
  const double fall_off = std::pow(camera_distance_mm / place_mm.norm(), 2);
  const double grain = 0.55 * noise(rest_mm / 11) + 0.3 * noise(rest_mm / 3.5) + 0.15 * noise(rest_mm / 1.2);
  const double vessel = std::pow(1 - std::abs(2 * noise(rest_mm / 6 + Vector3d(7, 3, 5)) - 1), 9);
  const double light = std::min(1.25, fall_off) * (0.12 + 0.88 * facing) * (0.6 + 0.8 * grain);
  const double gloss = 0.8 * std::pow(facing, 90) * noise(rest_mm / 2.5);
  const Vector3d base = Vector3d(168, 74, 58) - 0.5 * vessel * Vector3d(30, 34, 18);
  vision::Rgb rgb{};
  for (int channel = 0; channel < 3; ++channel) {
    rgb[static_cast<std::size_t>(channel)] =
        static_cast<std::uint8_t>(std::lround(std::clamp(light * base[channel] + 255 * gloss, 0.0, 255.0)));
  }
  return rgb;
}

double bump(double distance_mm, double width_mm) { return std::exp(-std::pow(distance_mm / width_mm, 2)); }

}  // namespace

std::optional<double> ExampleScene::View::depth_at(int x, int y) const {
  if (x < 0 || y < 0 || x >= width || y >= height) return std::nullopt;
  const double depth = depth_mm[static_cast<std::size_t>(x + width * y)];
  return std::isfinite(depth) ? std::optional(depth) : std::nullopt;
}

ExampleScene::ExampleScene(const geometry::Surface& liver_lps) {
  camera_.matrix << focal_px, 0, width / 2.0, 0, focal_px, height / 2.0, 0, 0, 1;
  const Eigen::Matrix3d axes = camera_axes();
  headwards_ = axes * Vector3d::UnitZ();
  geometry::Surface liver = liver_lps;
  for (Vector3d& point : liver.points_mm) point = axes * point;
  const auto normals = geometry::point_normals(liver);
  Vector3d facing_mm = Vector3d::Zero();
  int facing = 0;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    if (normals[i].z() > -0.6) continue;
    facing_mm += liver.points_mm[i];
    ++facing;
  }
  facing_mm /= std::max(1, facing);
  pose_.linear() = axes;
  pose_.translation() = Vector3d(0, 0, camera_distance_mm) - facing_mm;
  for (Vector3d& point : liver.points_mm) point += pose_.translation();

  geometry::Surface front = liver;
  std::erase_if(front.triangles, [&](const std::array<int, 3>& corners) {
    Vector3d middle = Vector3d::Zero(), normal = Vector3d::Zero();
    for (const int corner : corners) {
      middle += liver.points_mm[static_cast<std::size_t>(corner)] / 3;
      normal += normals[static_cast<std::size_t>(corner)] / 3;
    }
    const bool turned_away = normal.dot(middle) > 0.1 * middle.norm();
    // What the picture shows at some time, and a little around it.
    const bool beside = std::abs(middle.x()) * focal_px > 0.62 * width * middle.z() ||
                        std::abs(middle.y()) * focal_px > 0.68 * height * middle.z();
    return turned_away || beside;
  });
  model_ = geometry::largest_manifold_piece(front);
  const auto box = geometry::bounding_box(model_.points_mm);
  left_mm_ = box.min_mm.x();
  across_mm_ = box.max_mm.x() - box.min_mm.x();
  const View untouched = view(0);
  const auto pressed = static_cast<std::size_t>(width * 52 / 100 + width * (height * 55 / 100));
  pressed_mm_ = untouched.rest_mm[pressed];
}

double ExampleScene::pressing(double frame) const {
  return std::max(0.0, std::sin(2 * std::numbers::pi * frame / press_frames - 0.6));
}

Vector3d ExampleScene::moved(const Vector3d& rest_mm, double frame) const {
  const double breath = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * frame / breath_frames);
  const double across = (rest_mm.x() - left_mm_) / across_mm_;  // the right lobe, under the dome, goes farthest
  const Vector3d down_and_forth = -(13 - 6 * across) * breath * headwards_ - Vector3d(1, 0, 3 * (1 - across)) * breath;
  return rest_mm + down_and_forth + Vector3d(0, 0, 9 * pressing(frame) * bump((rest_mm - pressed_mm_).norm(), 26));
}

ExampleScene::View ExampleScene::view(double frame, double eye_mm) const {
  constexpr std::size_t pixels = std::size_t{width} * height;
  View view{{width, height, std::vector<std::uint8_t>(3 * pixels)},
            std::vector<double>(pixels, unseen_mm),
            std::vector<Vector3d>(pixels, Vector3d::Zero())};
  for (int y = 0; y < height; ++y) {  // the abdominal wall, out of focus
    for (int x = 0; x < width; ++x) {
      const double grain = noise(Vector3d(x, y, 0) / 60);
      std::uint8_t* pixel = view.picture.at(x, y);
      pixel[0] = static_cast<std::uint8_t>(46 + 34 * grain);
      pixel[1] = static_cast<std::uint8_t>(26 + 16 * grain);
      pixel[2] = static_cast<std::uint8_t>(22 + 12 * grain);
    }
  }
  draw_liver(frame, {eye_mm, 0, 0}, view);
  draw_tool(frame, {eye_mm, 0, 0}, view);
  return view;
}

// Each triangle's pixels, the nearest winning; places within it are found by its corners' depths, as perspective has
// it.
void ExampleScene::draw_liver(double frame, const Vector3d& eye_mm, View& view) const {
  geometry::Surface now = model_;
  for (Vector3d& point : now.points_mm) point = moved(point, frame) - eye_mm;
  const auto normals = geometry::point_normals(now);
  for (const auto& triangle : model_.triangles) {
    std::array<Vector3d, 3> corner;
    std::array<Eigen::Vector2d, 3> at;
    for (std::size_t c = 0; c < 3; ++c) {
      corner[c] = now.points_mm[static_cast<std::size_t>(triangle[c])];
      at[c] = (camera_.matrix * corner[c]).hnormalized();
    }
    const Eigen::Vector2d u = at[1] - at[0], v = at[2] - at[0];
    const double doubled_area = u.x() * v.y() - u.y() * v.x();
    if (std::abs(doubled_area) < 1e-9) continue;
    const auto [left, right] = std::minmax({at[0].x(), at[1].x(), at[2].x()});
    const auto [top, bottom] = std::minmax({at[0].y(), at[1].y(), at[2].y()});
    const int last_x = std::min(width - 1, static_cast<int>(std::floor(right)));
    const int last_y = std::min(height - 1, static_cast<int>(std::floor(bottom)));
    for (int y = std::max(0, static_cast<int>(std::ceil(top))); y <= last_y; ++y) {
      for (int x = std::max(0, static_cast<int>(std::ceil(left))); x <= last_x; ++x) {
        const Eigen::Vector2d w = Eigen::Vector2d(x, y) - at[0];
        const double b = (w.x() * v.y() - w.y() * v.x()) / doubled_area;
        const double c = (u.x() * w.y() - u.y() * w.x()) / doubled_area;
        if (b < 0 || c < 0 || b + c > 1) continue;
        Vector3d weight((1 - b - c) / corner[0].z(), b / corner[1].z(), c / corner[2].z());
        const double depth_mm = 1 / weight.sum();
        weight *= depth_mm;
        const auto pixel = static_cast<std::size_t>(x + width * y);
        if (depth_mm >= view.depth_mm[pixel]) continue;
        view.depth_mm[pixel] = depth_mm;
        Vector3d rest = Vector3d::Zero(), place = Vector3d::Zero(), normal = Vector3d::Zero();
        for (std::size_t i = 0; i < 3; ++i) {
          const auto point = static_cast<std::size_t>(triangle[i]);
          const double share = weight[static_cast<Eigen::Index>(i)];
          rest += share * model_.points_mm[point];
          place += share * corner[i];
          normal += share * normals[point];
        }
        view.rest_mm[pixel] = rest;
        const vision::Rgb rgb = colour_of(rest, place, normal.normalized());
        std::copy(rgb.begin(), rgb.end(), view.picture.at(x, y));
      }
    }
  }
}

// A rod from the lower right, its tip on the liver while it presses and above it otherwise.
void ExampleScene::draw_tool(double frame, const Vector3d& eye_mm, View& view) const {
  constexpr double radius_mm = 2.5;
  const Vector3d tip =
      moved(pressed_mm_, frame) - Vector3d(0, 0, 1 + 14 * std::max(0.0, 0.35 - pressing(frame))) - eye_mm;
  const Vector3d back = Vector3d(0.62, 0.36, -0.7).normalized();
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      // The nearest places of the pixel's ray and the rod's axis.
      const Vector3d ray = Vector3d((x - width / 2.0) / focal_px, (y - height / 2.0) / focal_px, 1).normalized();
      const double miss_mm = tip.dot(ray.cross(back).normalized());
      if (std::abs(miss_mm) > radius_mm) continue;
      const double alike = ray.dot(back);
      const double along_mm = (alike * tip.dot(ray) - tip.dot(back)) / (1 - alike * alike);
      if (along_mm < 0) continue;
      const double depth_mm = (tip + along_mm * back).z();
      const auto pixel = static_cast<std::size_t>(x + width * y);
      if (depth_mm <= 10 || depth_mm > view.depth_mm[pixel]) continue;
      view.depth_mm[pixel] = unseen_mm;
      const double round = std::sqrt(1 - std::pow(miss_mm / radius_mm, 2));
      const double shade = (along_mm < 9 ? 150 : 80) * (0.35 + 0.65 * round) + 70 * std::pow(round, 40);
      std::uint8_t* rgb = view.picture.at(x, y);
      for (int channel = 0; channel < 3; ++channel) {
        rgb[channel] = static_cast<std::uint8_t>(std::clamp(shade + 3 * channel, 0.0, 255.0));
      }
    }
  }
}

}  // namespace glisson::studies

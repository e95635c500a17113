#include "scene/heat_overlay.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "scene/internal/on_tissue.h"
#include "vision/draw.h"

namespace glisson::scene {
namespace {

using vision::Frame;
using vision::Rgb;

Rgb eight_bit(const Colour& colour) {
  const auto byte = [](double part) { return static_cast<std::uint8_t>(std::lround(255 * part)); };
  return {byte(colour.red), byte(colour.green), byte(colour.blue)};
}

Frame with_legend(const Frame& picture, const HeatScale& scale);

}  // namespace

HeatScale shared_scale(const std::vector<double>& a, const std::vector<double>& b, HeatScale::Good good,
                       std::string title) {
  std::vector<double> all = a;
  all.insert(all.end(), b.begin(), b.end());
  HeatScale scale;
  scale.good = good;
  scale.title = std::move(title);
  if (all.empty()) return scale;
  std::sort(all.begin(), all.end());
  const std::size_t off = all.size() / 50;
  scale.range = {all[off], all[all.size() - 1 - off]};
  if (!(scale.range[1] > scale.range[0])) scale.range[1] = scale.range[0] + 1e-6 + std::abs(scale.range[0]) * 1e-6;
  return scale;
}

Colour heat_colour(const HeatScale& scale, double value) {
  const double fraction = std::clamp((value - scale.range[0]) / (scale.range[1] - scale.range[0]), 0.0, 1.0);
  return colour_on_tissue(scale.good == HeatScale::Good::low ? 1 - fraction : fraction);
}

std::vector<SeenTriangle> seen_triangles(const vision::Camera& camera, const HeatMesh& mesh) {
  const auto pixels = vision::project(camera, mesh.points_mm);
  std::vector<std::size_t> order(mesh.triangles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto depth_mm = [&](std::size_t k) {
    double sum = 0;
    for (const int corner : mesh.triangles[k]) sum += mesh.points_mm[static_cast<std::size_t>(corner)].z();
    return sum;
  };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return depth_mm(a) > depth_mm(b); });
  std::vector<SeenTriangle> seen;
  for (const std::size_t k : order) {
    if (mesh.verdicts[k] == HeatMesh::Verdict::none) continue;
    SeenTriangle triangle{k, {}};
    bool shown = true;
    for (std::size_t c = 0; c < 3; ++c) {
      const auto& pixel = pixels[static_cast<std::size_t>(mesh.triangles[k][c])];
      shown = shown && pixel.has_value();
      if (pixel) triangle.corners_px[c] = *pixel;
    }
    if (shown) seen.push_back(triangle);
  }
  return seen;
}

Frame heat_overlay(const Frame& frame, const vision::Camera& camera, const HeatMesh& mesh, const HeatScale& scale) {
  constexpr Rgb grey{150, 150, 150};
  std::vector<vision::FlatTriangle> flat;
  for (const SeenTriangle& seen : seen_triangles(camera, mesh)) {
    const bool rejected = mesh.verdicts[seen.triangle] == HeatMesh::Verdict::rejected;
    flat.push_back({seen.corners_px, rejected ? grey : eight_bit(heat_colour(scale, mesh.values[seen.triangle]))});
  }
  Frame drawn = frame;
  vision::draw_triangles(drawn, flat, scale.opacity);
  return with_legend(drawn, scale);
}

namespace {

Frame with_legend(const Frame& picture, const HeatScale& scale) {
  constexpr Rgb white{255, 255, 255};
  const int text_px = std::clamp(picture.height / 40, 8, 24);
  const int bar_px = text_px, left = picture.width, top = 3 * text_px, height = picture.height - 5 * text_px;
  Frame frame{picture.width + 6 * text_px, picture.height, {}};
  frame.rgb.resize(3 * static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height));
  for (int y = 0; y < picture.height; ++y) std::copy_n(picture.at(0, y), 3 * picture.width, frame.at(0, y));
  if (height < 4 * text_px) return frame;  // too small a picture for a bar
  vision::draw_text(frame, left + text_px / 3, 3 * text_px / 2, 2 * text_px / 3, scale.title, white);
  const auto [low, high] = scale.range;
  for (int y = 0; y < height; ++y) {
    const double value = high - (high - low) * y / (height - 1);
    vision::draw_rectangle(frame, left + text_px / 2, top + y, bar_px, 1, eight_bit(heat_colour(scale, value)));
  }
  for (const double mark : round_marks(low, high, 5)) {
    if (mark < low || mark > high) continue;
    const int y = top + static_cast<int>(std::lround((high - mark) / (high - low) * (height - 1)));
    vision::draw_rectangle(frame, left + text_px / 2 + bar_px, y, text_px / 3, 1, white);
    vision::draw_text(frame, left + text_px + bar_px, y + text_px / 3, 3 * text_px / 4, fmt::format("{:.3g}", mark),
                      white);
  }
  return frame;
}

}  // namespace
}  // namespace glisson::scene

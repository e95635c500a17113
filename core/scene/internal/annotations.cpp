#include "scene/internal/annotations.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace glisson::scene {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr Colour amber{1.0, 0.77, 0.30};

// The page that one frame is laid out on: sizes in pixels of this frame, colours that suit its background.
struct Page {
  Overlay& overlay;
  const Viewport& viewport;
  const FlatContent& content;
  double unit;       // one pixel of the design, in pixels of the frame
  double floor = 0;  // the height that the warning's band takes up
  Colour ink;
  Colour faint;
  Colour plate;

  [[nodiscard]] double margin() const { return 14 * unit; }
  [[nodiscard]] TextStyle body(double size = 15) const { return {ink, size * unit, false, 0, plate, 1}; }
  [[nodiscard]] TextStyle small() const { return {faint, 13 * unit, false, 0, plate, 1}; }
};

Page page_for(Overlay& overlay, const Viewport& viewport, const FlatContent& content, double pixel_scale);
void lay_out_crosshair(Page& page);
void lay_out_lines(Page& page);
std::optional<Eigen::AlignedBox2d> place_of_scale_bar(const Page& page);
void lay_out_labels(Page& page);
void lay_out_warning(Page& page);
void lay_out_titles(Page& page);
void lay_out_scale_bar(Page& page);
void lay_out_legends(Page& page);
void lay_out_letters(Page& page);
void lay_out_cube(Page& page);

}  // namespace

void lay_out(Overlay& overlay, const Viewport& viewport, const FlatContent& content, double pixel_scale) {
  Page page = page_for(overlay, viewport, content, pixel_scale);
  overlay.begin();
  lay_out_warning(page);
  lay_out_crosshair(page);
  lay_out_lines(page);
  lay_out_labels(page);
  lay_out_titles(page);
  lay_out_scale_bar(page);
  lay_out_legends(page);
  if (content.annotations.orientation == Annotations::Orientation::letters) lay_out_letters(page);
  if (content.annotations.orientation == Annotations::Orientation::cube) lay_out_cube(page);
  overlay.end();
}

namespace {

Page page_for(Overlay& overlay, const Viewport& viewport, const FlatContent& content, double pixel_scale) {
  const bool dark = content.background != Background::light;
  return {overlay,
          viewport,
          content,
          pixel_scale * content.annotations.text_scale,
          0,
          dark ? Colour{0.93, 0.95, 0.97} : Colour{0.10, 0.12, 0.15},
          dark ? Colour{0.66, 0.71, 0.77} : Colour{0.36, 0.40, 0.45},
          dark ? Colour{0.04, 0.05, 0.07} : Colour{1, 1, 1}};
}

// A small disc with a dark rim.
void knob(Page& page, const Vector2d& at, double radius, const Colour& colour) {
  for (const auto& [r, fill] : {std::pair(radius + 1.2 * page.unit, page.plate), std::pair(radius, colour)}) {
    std::vector<Vector2d> rim;
    constexpr int corners = 16;
    for (int k = 0; k < corners; ++k) {
      const double angle = 2 * std::numbers::pi * k / corners;
      rim.push_back(at + r * Vector2d(std::cos(angle), std::sin(angle)));
    }
    page.overlay.fill(rim, fill);
  }
}

// The lines along which the planes cut the picture, with a gap about the point itself, so that they do not hide what
// they point at.
void lay_out_crosshair(Page& page) {
  if (!page.content.crosshair) return;
  const CrosshairItem& cross = *page.content.crosshair;
  const Vector2d at = page.viewport.pixel_of(cross.position_mm);
  const double gap = 9 * page.unit;
  const double width = std::max(1.0, std::round(page.unit));
  const double beyond = 2.0 * (page.viewport.width + page.viewport.height);
  for (Eigen::Index k = 0; k < 3; ++k) {
    const Vector3d along = cross.axes.col(k).cross(page.viewport.camera.sight);
    if (along.norm() < 0.5) continue;  // this plane is the picture's own
    const Vector2d way = Vector2d(along.dot(page.viewport.right()), along.dot(page.viewport.camera.up)).normalized();
    const Colour& colour = cross.axis_colours[static_cast<std::size_t>(k)];
    for (const double side : {-1.0, 1.0}) {
      page.overlay.line(at + side * gap * way, at + side * beyond * way, width, colour, 0.75);
      if (cross.handle_px > 0) knob(page, at + side * cross.handle_px * way, 4 * page.unit, colour);
    }
  }
}

void lay_out_lines(Page& page) {
  for (const LineItem& line : page.content.lines) {
    std::vector<Vector2d> at;
    for (const Vector3d& point_mm : line.points_mm) at.push_back(page.viewport.pixel_of(point_mm));
    for (const auto& [width, colour] : {std::pair(3.6, page.plate), std::pair(1.6, line.colour)}) {
      for (std::size_t k = 0; k + 1 < at.size(); ++k) page.overlay.line(at[k], at[k + 1], width * page.unit, colour);
    }
    if (line.ends == LineItem::Ends::plain) continue;
    for (const Vector2d& point : at) knob(page, point, 3.2 * page.unit, line.colour);
  }
}

struct Label {
  std::string words;
  Vector2d anchor;   // the point that it names
  double clearance;  // how far from it the text stays
};

// Labels stand to the upper right of their points; one that would cover another moves down until it does not, one over
// the scale bar moves up, and a thin line then leads to its point.
void lay_out_labels(Page& page) {
  std::vector<Label> labels;
  const double scale = page.viewport.pixels_per_mm();
  for (const LandmarkItem& landmark : page.content.landmarks) {
    if (landmark.label.empty()) continue;
    labels.push_back({landmark.label, page.viewport.pixel_of(landmark.position_mm), scale * landmark.radius_mm});
  }
  for (const LineItem& line : page.content.lines) {
    if (line.label.empty() || line.points_mm.empty()) continue;
    labels.push_back({line.label, page.viewport.pixel_of(line.points_mm.back()), 3});
  }
  for (const ArrowItem& arrow : page.content.arrows) {
    if (arrow.label.empty()) continue;
    labels.push_back({arrow.label, page.viewport.pixel_of(arrow.tail_mm), scale * arrow.thickness_mm});
  }
  std::sort(labels.begin(), labels.end(), [](const Label& a, const Label& b) { return a.anchor.y() > b.anchor.y(); });

  TextStyle style = page.body(14);
  style.plate_opacity = 0.55;
  const auto scale_bar = place_of_scale_bar(page);
  std::vector<Eigen::AlignedBox2d> taken;
  for (const Label& label : labels) {
    const double away = label.clearance * 0.75 + 5 * page.unit;
    const Vector2d size(0.56 * style.size_px * static_cast<double>(label.words.size()), 1.25 * style.size_px);
    Vector2d low = label.anchor + Vector2d(away, 0.4 * away);
    low.x() = std::clamp(low.x(), 0.0, std::max(0.0, page.viewport.width - size.x()));
    low.y() = std::clamp(low.y(), page.floor, std::max(page.floor, page.viewport.height - size.y()));
    const auto covers = [&](const Eigen::AlignedBox2d& other) {
      return other.intersects(Eigen::AlignedBox2d(low, low + size));
    };
    bool moved = false;
    if (scale_bar && covers(*scale_bar)) {
      low.y() = scale_bar->max().y() + 2 * page.unit;
      moved = true;
    }
    for (auto other = std::find_if(taken.begin(), taken.end(), covers); other != taken.end();
         other = std::find_if(taken.begin(), taken.end(), covers)) {
      low.y() = other->min().y() - size.y() - 2 * page.unit;
      moved = true;
    }
    taken.emplace_back(low, low + size);
    if (moved) page.overlay.line(label.anchor, low + Vector2d(0, 0.5 * size.y()), page.unit, page.ink, 0.6);
    page.overlay.text(label.words, low, Anchor::lower_left, style);
  }
}

void lay_out_warning(Page& page) {
  const std::string& words = page.content.annotations.warning;
  if (words.empty()) return;
  page.floor = 30 * page.unit;
  page.overlay.rectangle({0, 0}, {double(page.viewport.width), page.floor}, {0.16, 0.11, 0.02}, 0.88);
  page.overlay.rectangle({0, 0}, {4 * page.unit, page.floor}, amber);
  TextStyle style = page.body(14);
  style.colour = amber;
  style.bold = true;
  page.overlay.text(words, {page.margin(), 0.5 * page.floor}, Anchor::left_centre, style);
}

void lay_out_titles(Page& page) {
  const Annotations& annotations = page.content.annotations;
  double top = page.viewport.height - page.margin();
  TextStyle title = page.body(21);
  title.bold = true;
  if (!annotations.title.empty()) {
    page.overlay.text(annotations.title, {page.margin(), top}, Anchor::upper_left, title);
    top -= 29 * page.unit;
  }
  if (!annotations.subtitle.empty()) {
    page.overlay.text(annotations.subtitle, {page.margin(), top}, Anchor::upper_left, page.small());
    top -= 26 * page.unit;
  }
  for (const KeyEntry& entry : annotations.key) {
    const Vector2d low(page.margin(), top - 13 * page.unit);
    page.overlay.rectangle(low, low + Vector2d(12, 12) * page.unit, entry.colour);
    page.overlay.text(entry.text, low + Vector2d(20, 6) * page.unit, Anchor::left_centre, page.body(13));
    top -= 21 * page.unit;
  }
}

// The longest of 1, 2, 5, 10, ... mm that takes at most a fifth of the width; it holds in the plane of the focus.
double scale_bar_mm(const Page& page) {
  const double room_mm = 0.2 * page.viewport.width / page.viewport.pixels_per_mm();
  if (!(room_mm > 0)) return 0;
  const double decade = std::pow(10.0, std::floor(std::log10(room_mm)));
  return decade * (room_mm >= 5 * decade ? 5 : room_mm >= 2 * decade ? 2 : 1);
}

// With its words.
std::optional<Eigen::AlignedBox2d> place_of_scale_bar(const Page& page) {
  const double length_mm = scale_bar_mm(page);
  if (page.content.annotations.scale_bar != Annotations::ScaleBar::shown || !(length_mm > 0)) return std::nullopt;
  const Vector2d low(page.margin(), page.floor + page.margin());
  return Eigen::AlignedBox2d(low, low + Vector2d(length_mm * page.viewport.pixels_per_mm(), 24 * page.unit));
}

void lay_out_scale_bar(Page& page) {
  const auto place = place_of_scale_bar(page);
  if (!place) return;
  const double length_mm = scale_bar_mm(page);
  const Vector2d from = place->min(), to(place->max().x(), from.y());
  const Vector2d tick(0, 3.5 * page.unit);
  for (const double halo : {3.0, 0.0}) {  // first a dark rim, so that it reads on bright tissue too
    const double width = (1.6 + halo) * page.unit;
    const Colour colour = halo > 0 ? page.plate : page.ink;
    const double opacity = halo > 0 ? 0.5 : 1;
    page.overlay.line(from, to, width, colour, opacity);
    page.overlay.line(from - tick, from + tick, width, colour, opacity);
    page.overlay.line(to - tick, to + tick, width, colour, opacity);
  }
  const std::string words =
      length_mm >= 10 ? fmt::format("{:g} cm", length_mm / 10) : fmt::format("{:g} mm", length_mm);
  page.overlay.text(words, 0.5 * (from + to) + Vector2d(0, 5 * page.unit), Anchor::lower_centre, page.body(13));
}

std::string mark_text(double value, double step) {
  const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
  return fmt::format("{:.{}f}", value, std::min(decimals, 6));
}

void lay_out_legends(Page& page) {
  const double bar_width = 14 * page.unit;
  const double column = 92 * page.unit;
  double right = page.viewport.width - page.margin();
  for (const Legend& legend : page.content.legends) {
    // In the middle of the right edge, above the cube.
    const double wanted = std::min(0.42 * page.viewport.height, 300 * page.unit);
    const double low = std::max(0.5 * (page.viewport.height - wanted), page.floor + 104 * page.unit);
    const double height = std::min(wanted, page.viewport.height - low - 48 * page.unit);
    if (height < 40 * page.unit) return;  // no room in a picture this small
    const double left = right - column + 30 * page.unit;
    constexpr int steps = 128;
    for (int k = 0; k < steps; ++k) {
      page.overlay.rectangle({left, low + height * k / steps}, {left + bar_width, low + height * (k + 1) / steps},
                             colour_at(legend.map, (k + 0.5) / steps));
    }
    const std::vector<double> marks = round_marks(legend.range[0], legend.range[1], 5);
    const double step = marks.size() > 1 ? marks[1] - marks[0] : 1;
    for (const double mark : marks) {
      const double y = low + height * (mark - legend.range[0]) / (legend.range[1] - legend.range[0]);
      page.overlay.line({left + bar_width, y}, {left + bar_width + 4 * page.unit, y}, page.unit, page.ink);
      page.overlay.text(mark_text(mark, step), {left + bar_width + 8 * page.unit, y}, Anchor::left_centre,
                        page.body(13));
    }
    const Vector2d title_size =
        page.overlay.text(legend.title, {right, low + height + 14 * page.unit}, Anchor::lower_right, page.body(14));
    right -= std::max(column, title_size.x()) + 16 * page.unit;
  }
}

// "L", "PL": the patient's side that a direction points to, the strongest part first; parts under a third stay out.
std::string side_of(const Vector3d& direction) {
  constexpr std::array<const char*, 3> towards{"L", "P", "H"};
  constexpr std::array<const char*, 3> away{"R", "A", "F"};
  std::array<int, 3> axes{0, 1, 2};
  std::sort(axes.begin(), axes.end(), [&](int a, int b) { return std::abs(direction[a]) > std::abs(direction[b]); });
  std::string letters;
  for (const int axis : axes) {
    if (std::abs(direction[axis]) < 0.34) break;
    letters += (direction[axis] > 0 ? towards : away)[static_cast<std::size_t>(axis)];
  }
  return letters;
}

void lay_out_letters(Page& page) {
  const double w = page.viewport.width;
  const double h = page.viewport.height;
  TextStyle style = page.body(15);
  style.bold = true;
  const Vector3d right = page.viewport.right();
  const Vector3d up = page.viewport.camera.up;
  page.overlay.text(side_of(right), {w - page.margin(), 0.5 * h}, Anchor::right_centre, style);
  page.overlay.text(side_of(-right), {page.margin(), 0.5 * h}, Anchor::left_centre, style);
  page.overlay.text(side_of(up), {0.5 * w, h - page.margin() - 8 * page.unit}, Anchor::centre, style);
  page.overlay.text(side_of(-up), {0.5 * w, page.floor + page.margin() + 8 * page.unit}, Anchor::centre, style);
}

// A small cube in the lower right corner that turns with the patient, its faces named.
void lay_out_cube(Page& page) {
  const double half = 23 * page.unit;
  const Vector2d center(page.viewport.width - page.margin() - 1.6 * half, page.floor + page.margin() + 1.6 * half);
  const Vector3d right = page.viewport.right();
  const Vector3d up = page.viewport.camera.up;
  const auto flat = [&](const Vector3d& corner) {
    return Vector2d(center + half * Vector2d(corner.dot(right), corner.dot(up)));
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      const Vector3d normal = side * Vector3d::Unit(axis);
      const double facing = -normal.dot(page.viewport.camera.sight);
      if (facing <= 0.02) continue;
      const Vector3d a = Vector3d::Unit((axis + 1) % 3);
      const Vector3d b = Vector3d::Unit((axis + 2) % 3);
      const double light = 0.30 + 0.45 * facing;
      const std::vector<Vector2d> corners{flat(normal - a - b), flat(normal + a - b), flat(normal + a + b),
                                          flat(normal - a + b)};
      page.overlay.fill(corners, {0.80 * light, 0.90 * light, light}, 0.92);
      for (std::size_t k = 0; k < 4; ++k) {
        page.overlay.line(corners[k], corners[(k + 1) % 4], 1.2 * page.unit, page.plate, 0.9);
      }
      TextStyle letter = page.body(10 + 12 * facing);
      letter.colour = {1, 1, 1};
      letter.bold = true;
      if (facing > 0.25) page.overlay.text(side_of(normal), flat(normal), Anchor::centre, letter);
    }
  }
}

}  // namespace
}  // namespace glisson::scene

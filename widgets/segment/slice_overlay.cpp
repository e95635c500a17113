#include "widgets/segment/slice_overlay.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <limits>
#include <numbers>

#include "scene/anatomy.h"

namespace glisson::widgets {
namespace {

constexpr scene::Colour amber{1.0, 0.72, 0.2};
constexpr std::uint8_t faint = 46, strong = 96;  // how much a fill covers, of 255: others, and the one being drawn

segmentation::IndexBox whole(const imaging::Grid& grid) {
  return {{0, 0, 0}, {grid.size[0] - 1, grid.size[1] - 1, grid.size[2] - 1}};
}

// The part of the plane through `center_mm` that the image reaches, in squares as wide as its voxels are at the least.
imaging::Grid grid_in_plane(const imaging::Grid& image, const Eigen::Vector3d& center_mm,
                            const Eigen::Vector3d& normal) {
  constexpr int maximum_squares = 640;
  const Eigen::Vector3d across = normal.unitOrthogonal(), along = normal.cross(across);
  Eigen::Vector2d low(std::numeric_limits<double>::max(), std::numeric_limits<double>::max()), high = -low;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d index((corner & 1) * image.size[0] - 0.5, ((corner >> 1) & 1) * image.size[1] - 0.5,
                                (corner >> 2) * image.size[2] - 0.5);
    const Eigen::Vector3d from_center_mm = image.position_mm(index) - center_mm;
    const Eigen::Vector2d place(from_center_mm.dot(across), from_center_mm.dot(along));
    low = low.cwiseMin(place);
    high = high.cwiseMax(place);
  }
  const double edge_mm = std::max(image.spacing_mm.minCoeff(), (high - low).maxCoeff() / maximum_squares);
  imaging::Grid plane;
  plane.size = {static_cast<int>((high - low).x() / edge_mm) + 1, static_cast<int>((high - low).y() / edge_mm) + 1, 1};
  plane.spacing_mm = {edge_mm, edge_mm, edge_mm};
  plane.direction << across, along, normal;
  plane.origin_mm = center_mm + low.x() * across + low.y() * along;
  return plane;
}

// Whether the slice goes through the voxels of a box.
bool goes_through(const SliceView& view, const imaging::Grid& grid, const segmentation::IndexBox& box) {
  bool above = false, below = false;
  for (int corner = 0; corner < 8; ++corner) {
    Eigen::Vector3d index;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const bool high = ((corner >> axis) & 1) != 0;
      index[static_cast<Eigen::Index>(axis)] = high ? box.last[axis] + 0.5 : box.first[axis] - 0.5;
    }
    const double height_mm = view.normal().dot(grid.position_mm(index) - view.crosshair_mm());
    above = above || height_mm >= 0;
    below = below || height_mm <= 0;
  }
  return above && below;
}

std::array<std::uint8_t, 4> cell_colour(const std::string& name, bool active) {
  const scene::Colour colour = scene::appearance_of(name).colour;
  const auto byte = [](double share) { return static_cast<std::uint8_t>(std::clamp(255 * share, 0.0, 255.0)); };
  return {byte(colour.red), byte(colour.green), byte(colour.blue), active ? strong : faint};
}

// Circles in which a slice cuts balls around places.
scene::DrawnLines rings_in(const SliceView& view, const std::vector<Eigen::Vector3d>& places_mm) {
  constexpr double radius_mm = 15;
  scene::DrawnLines rings{{}, amber, 1.8};
  for (const Eigen::Vector3d& place_mm : places_mm) {
    const double off_mm = view.normal().dot(view.crosshair_mm() - place_mm);
    if (std::abs(off_mm) >= radius_mm) continue;
    add_circle(rings.ends_mm, place_mm + off_mm * view.normal(), view.normal(),
               std::sqrt(radius_mm * radius_mm - off_mm * off_mm));
  }
  return rings;
}

}  // namespace

void add_circle(std::vector<Eigen::Vector3d>& ends_mm, const Eigen::Vector3d& center_mm, const Eigen::Vector3d& normal,
                double radius_mm) {
  constexpr int pieces = 48;
  const Eigen::Vector3d across = normal.unitOrthogonal(), along = normal.cross(across);
  const auto on_circle = [&](int k) -> Eigen::Vector3d {
    const double angle = 2 * std::numbers::pi * k / pieces;
    return center_mm + radius_mm * (std::cos(angle) * across + std::sin(angle) * along);
  };
  for (int k = 0; k < pieces; ++k) {
    ends_mm.push_back(on_circle(k));
    ends_mm.push_back(on_circle(k + 1));
  }
}

SliceOverlay::SliceOverlay(LinkedViews& views, const StructureEditor& editor, QObject* parent)
    : QObject(parent), views_(views), editor_(editor) {
  for (std::size_t k = 0; k < shown_.size(); ++k) {
    shown_[k].view = views_.slices()[k];
    connect(shown_[k].view, &SliceView::slice_moved, this, [this, k] {
      if (on_) refresh(shown_[k]);
    });
  }
  connect(&editor_, &StructureEditor::opened, this, [this] { refresh(); });
  connect(&editor_, &StructureEditor::listed, this, [this] { refresh(); });
  connect(&editor_, &StructureEditor::changed, this, &SliceOverlay::refresh_part);
}

void SliceOverlay::set_on(bool on) {
  on_ = on;
  if (!on) {
    for (Shown& shown : shown_) shown.sketch.clear();
  }
  refresh();
}

void SliceOverlay::refresh() {
  for (Shown& shown : shown_) refresh(shown);
}

void SliceOverlay::set_sketch(SliceView* view, std::vector<scene::DrawnLines> lines) {
  for (Shown& shown : shown_) {
    if (shown.view != view || (shown.sketch.empty() && lines.empty())) continue;
    shown.sketch = std::move(lines);
    hand_over(shown);
    return;
  }
}

void SliceOverlay::set_rings(std::vector<Eigen::Vector3d> places_mm) {
  if (rings_mm_.empty() && places_mm.empty()) return;
  rings_mm_ = std::move(places_mm);
  for (const Shown& shown : shown_) hand_over(shown);
}

std::optional<SliceOverlay::Layer> SliceOverlay::layer_of(const SliceView& view, const imaging::Grid& grid) const {
  const Eigen::Vector3d normal = view.normal();
  const int axis = segmentation::axis_along(grid, normal);
  constexpr double nearly_along = 0.996;  // about 5 degrees off
  if (std::abs(grid.direction.col(axis).dot(normal)) < nearly_along) return std::nullopt;
  return Layer{axis, segmentation::layer_at(grid, axis, view.crosshair_mm())};
}

void SliceOverlay::refresh(Shown& shown) {
  shown.outlines.assign(editor_.structures().size(), {});
  shown.cells = {};
  shown.layer.reset();
  shown.tilted.reset();
  shown.sampled.clear();
  const imaging::Volume* anatomy = editor_.anatomy();
  if (on_ && anatomy != nullptr) shown.layer = layer_of(*shown.view, anatomy->grid);
  if (shown.layer) {
    const imaging::Grid& grid = anatomy->grid;
    const auto n = static_cast<std::size_t>(shown.layer->axis);
    if (shown.layer->index >= 0 && shown.layer->index < grid.size[n]) {
      Eigen::Vector3d corner = Eigen::Vector3d::Zero();
      corner[shown.layer->axis] = shown.layer->index;
      shown.cells.layer = grid;
      shown.cells.layer.size[n] = 1;
      // In the plane that is looked at, which may lie up to half a voxel beside the layer's middle.
      const Eigen::Vector3d normal = shown.view->normal(), middle_mm = grid.position_mm(corner);
      shown.cells.layer.origin_mm = middle_mm + normal * normal.dot(shown.view->crosshair_mm() - middle_mm);
      shown.cells.colours.assign(shown.cells.layer.voxels(), {0, 0, 0, 0});
      colour_cells(shown, whole(grid));
    }
    for (std::size_t k = 0; k < shown.outlines.size(); ++k) outline(shown, k);
  } else if (on_ && anatomy != nullptr) {
    refresh_tilted(shown);
  }
  hand_over(shown);
}

void SliceOverlay::refresh_tilted(Shown& shown) {
  shown.tilted = grid_in_plane(editor_.anatomy()->grid, shown.view->crosshair_mm(), shown.view->normal());
  shown.sampled.resize(editor_.structures().size());
  shown.cells.layer = *shown.tilted;
  for (std::size_t k = 0; k < shown.sampled.size(); ++k) sample(shown, k);
  colour_tilted_cells(shown);
}

// The structure in the squares of the tilted plane, each as the voxel is that its middle lies in.
void SliceOverlay::sample(Shown& shown, std::size_t structure) {
  const EditedStructure& drawn = editor_.structures()[structure];
  const bool active = static_cast<int>(structure) == editor_.active();
  shown.sampled[structure].reset();
  shown.outlines[structure] = {{}, scene::appearance_of(drawn.name).colour, active ? 2.2 : 1.3};
  if (!drawn.shown) return;
  const imaging::Grid& plane = *shown.tilted;
  const imaging::Mask& mask = *drawn.mask;
  imaging::Mask sampled{plane, std::vector<std::uint8_t>(plane.voxels(), 0)};
  const Eigen::Vector3d first = mask.grid.index_of(plane.position_mm(0, 0, 0));
  const Eigen::Vector3d right = mask.grid.index_of(plane.position_mm(1, 0, 0)) - first;
  const Eigen::Vector3d up = mask.grid.index_of(plane.position_mm(0, 1, 0)) - first;
  std::size_t square = 0;
  for (int b = 0; b < plane.size[1]; ++b) {
    for (int a = 0; a < plane.size[0]; ++a, ++square) {
      const Eigen::Vector3i voxel = (first + a * right + b * up).array().round().cast<int>();
      if (!mask.grid.contains(voxel.x(), voxel.y(), voxel.z())) continue;
      sampled.values[square] = mask.values[mask.grid.offset(voxel.x(), voxel.y(), voxel.z())];
    }
  }
  shown.outlines[structure].ends_mm = scene::outline_in_layer(sampled, 2, 0);
  shown.sampled[structure] = std::move(sampled);
}

void SliceOverlay::colour_tilted_cells(Shown& shown) {
  shown.cells.colours.assign(shown.tilted->voxels(), {0, 0, 0, 0});
  for (std::size_t k = 0; k < shown.sampled.size(); ++k) {
    if (!shown.sampled[k]) continue;
    const auto colour = cell_colour(editor_.structures()[k].name, static_cast<int>(k) == editor_.active());
    for (std::size_t square = 0; square < shown.cells.colours.size(); ++square) {
      if (shown.sampled[k]->values[square] != 0) shown.cells.colours[square] = colour;
    }
  }
}

void SliceOverlay::refresh_part(int structure, const segmentation::IndexBox& box) {
  if (!on_ || editor_.anatomy() == nullptr) return;
  const auto drawn = static_cast<std::size_t>(structure);
  const imaging::Mask& mask = *editor_.structures()[drawn].mask;
  for (Shown& shown : shown_) {
    if (drawn >= shown.outlines.size()) continue;
    if (shown.tilted) {
      if (!box.empty() && !goes_through(*shown.view, mask.grid, box)) continue;
      sample(shown, drawn);
      colour_tilted_cells(shown);
      hand_over(shown);
      continue;
    }
    if (!shown.layer) continue;
    const auto n = static_cast<std::size_t>(shown.layer->axis);
    const bool touched = box.empty() || (box.first[n] <= shown.layer->index && shown.layer->index <= box.last[n]);
    if (!touched) continue;
    colour_cells(shown, box.empty() ? whole(mask.grid) : box);
    outline(shown, drawn);
    hand_over(shown);
  }
}

void SliceOverlay::colour_cells(Shown& shown, const segmentation::IndexBox& box) {
  if (shown.cells.colours.empty()) return;
  const imaging::Grid& grid = editor_.anatomy()->grid;
  const auto n = static_cast<std::size_t>(shown.layer->axis);
  struct Filled {
    const imaging::Mask* mask;
    std::array<std::uint8_t, 4> colour;
  };
  std::vector<Filled> filled;  // what comes later lies on top: what is inside the liver, and the one being drawn
  for (std::size_t k = 0; k < editor_.structures().size(); ++k) {
    const EditedStructure& structure = editor_.structures()[k];
    const bool active = static_cast<int>(k) == editor_.active();
    if (!structure.shown || !imaging::same_grid(structure.mask->grid, grid)) continue;
    filled.push_back({structure.mask.get(), cell_colour(structure.name, active)});
  }
  segmentation::IndexBox part = box;
  part.first[n] = part.last[n] = shown.layer->index;
  for (int k = part.first[2]; k <= part.last[2]; ++k) {
    for (int j = part.first[1]; j <= part.last[1]; ++j) {
      for (int i = part.first[0]; i <= part.last[0]; ++i) {
        std::array<std::uint8_t, 4> colour{0, 0, 0, 0};
        const std::size_t voxel = grid.offset(i, j, k);
        for (const Filled& one : filled) {
          if (one.mask->values[voxel] != 0) colour = one.colour;
        }
        shown.cells.colours[shown.cells.layer.offset(n == 0 ? 0 : i, n == 1 ? 0 : j, n == 2 ? 0 : k)] = colour;
      }
    }
  }
}

void SliceOverlay::outline(Shown& shown, std::size_t structure) {
  const EditedStructure& drawn = editor_.structures()[structure];
  const bool active = static_cast<int>(structure) == editor_.active();
  scene::DrawnLines lines{{}, scene::appearance_of(drawn.name).colour, active ? 2.2 : 1.3};
  if (drawn.shown) {
    if (const auto layer = layer_of(*shown.view, drawn.mask->grid)) {
      lines.ends_mm = scene::outline_in_layer(*drawn.mask, layer->axis, layer->index);
      const Eigen::Vector3d normal = shown.view->normal();
      for (Eigen::Vector3d& end_mm : lines.ends_mm) end_mm += normal * normal.dot(shown.view->crosshair_mm() - end_mm);
    }
  }
  shown.outlines[structure] = std::move(lines);
}

void SliceOverlay::hand_over(const Shown& shown) {
  std::vector<scene::DrawnLines> lines = shown.outlines;
  lines.insert(lines.end(), shown.sketch.begin(), shown.sketch.end());
  if (!rings_mm_.empty()) lines.push_back(rings_in(*shown.view, rings_mm_));
  shown.view->view().set_drawn_lines(on_ ? lines : std::vector<scene::DrawnLines>());
  shown.view->view().set_drawn_cells(on_ && !shown.cells.colours.empty() ? std::optional(shown.cells) : std::nullopt);
  shown.view->redraw();
}

}  // namespace glisson::widgets

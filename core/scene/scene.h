#pragma once
// What a picture shows, as values, and the function that draws it.
//
// Positions are patient coordinates (LPS, mm). Whatever takes part in several pictures (a surface, a volume) is held by
// a shared pointer to const. So scenes are cheap to copy and to hand between threads. Drawing needs no screen.

#include <array>
#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "geometry/surface.h"
#include "imaging/image.h"
#include "scene/camera.h"
#include "scene/colour.h"
#include "scene/picture.h"

namespace glisson::scene {

// How a surface takes the light. `solid` is opaque tissue with a soft sheen. `glass` is clear where it faces the viewer
// and denser towards its rim, so that what lies inside stays readable; `opacity` scales it. `light` adds its colour to
// what lies behind, whatever the order, as in an x-ray. A red and a blue body are purple where they coincide, on a dark
// background only.
enum class Finish { solid, glass, light };

// A quantity shown by colour, with its legend.
struct Colouring {
  std::string field;  // a point or cell field of the surface with one component, or three (its length)
  ColourMap map = ColourMap::viridis;
  std::array<double, 2> range{0, 1};  // in the field's unit; values outside take the end colours
  std::string title;                  // with the unit: "Displacement (mm)"; empty for no legend
};

struct SurfaceItem {
  std::string name;
  std::shared_ptr<const geometry::Surface> surface;
  Colour colour;
  double opacity = 1;
  Finish finish = Finish::solid;
  std::optional<Colouring> colouring;
  bool framed = true;  // whether a camera that shows everything has to show it too; a tool for thinking need not be
};

// The line along which a surface cuts a slice.
struct CutLine {
  std::shared_ptr<const geometry::Surface> surface;
  Colour colour;
  double width_px = 1.8;
};

// The outline of a mask in a slice.
struct MaskLine {
  std::shared_ptr<const imaging::Mask> mask;
  Colour colour;
  double width_px = 1.8;
};

// A plane through a volume.
struct SliceItem {
  std::shared_ptr<const imaging::Volume> volume;
  Eigen::Vector3d center_mm{0, 0, 0};
  Eigen::Vector3d normal{0, 0, 1};
  double window_center = 0;  // in the volume's unit: the value shown mid-way
  double window_width = 1;   // from darkest to brightest
  ColourMap map = ColourMap::grey;
  std::string legend_title;  // "Stiffness (kPa)"; empty for no legend
  double opacity = 1;
  std::vector<CutLine> cuts;
  std::vector<MaskLine> masks;
};

// A point that is followed: a sphere with its name beside it.
struct LandmarkItem {
  std::string label;  // empty: no text
  Eigen::Vector3d position_mm{0, 0, 0};
  double radius_mm = 3;
  Colour colour;
};

// An arrow that ends at `tip_mm`: a tool's force with its label ("5.0 N"), or a landmark's way.
struct ArrowItem {
  Eigen::Vector3d tail_mm{0, 0, 0};
  Eigen::Vector3d tip_mm{0, 0, 1};
  double thickness_mm = 3;
  Colour colour;
  std::string label;
};

// A rod with round ends: part of a solid tool.
struct RodItem {
  Eigen::Vector3d from_mm{0, 0, 0};
  Eigen::Vector3d to_mm{0, 0, 1};
  double radius_mm = 1;
  Colour colour;
};

// Three planes through a point, drawn in slices as the lines along which they cut the picture.
struct CrosshairItem {
  Eigen::Vector3d position_mm{0, 0, 0};
  std::array<Colour, 3> axis_colours;                  // of the line that stands for the plane across each axis
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  // unit columns: the planes' normals
  double handle_px = 0;  // how far from the point each line carries a knob to turn it by, in device pixels; 0: none
};

// A line through points of the patient, drawn over everything, with a label at its last point: a measurement.
struct LineItem {
  enum class Ends { plain, marked };  // marked: a knob on each point
  std::vector<Eigen::Vector3d> points_mm;
  Colour colour;
  std::string label;
  Ends ends = Ends::marked;
};

enum class Background { dark, light, black };

// One line of a picture's key: what a colour stands for.
struct KeyEntry {
  Colour colour;
  std::string text;
};

// What stands in the picture's corners.
struct Annotations {
  enum class Orientation { hidden, letters, cube };  // letters at the edges (slices) or a cube in the corner (3D)
  enum class ScaleBar { hidden, shown };
  Orientation orientation = Orientation::cube;
  ScaleBar scale_bar = ScaleBar::shown;
  std::string title;          // top left
  std::string subtitle;       // below it, smaller
  std::string warning;        // bottom, on a band of its own: "SIMULATED: not a measurement"
  double text_scale = 1;      // 1 is 15 px for body text
  std::vector<KeyEntry> key;  // below the subtitle
};

struct Scene {
  std::vector<SurfaceItem> surfaces;
  std::vector<SliceItem> slices;
  std::vector<LandmarkItem> landmarks;
  std::vector<ArrowItem> arrows;
  std::optional<CrosshairItem> crosshair;
  std::optional<Camera> camera;  // absent: from the surgeon's side, everything in view
  Background background = Background::dark;
  Annotations annotations;
};

// Everything the scene shows, but for surfaces that are not framed; an empty box at the origin for an empty scene.
[[nodiscard]] geometry::Box bounds(const Scene& scene);

// The camera that looks from that side and shows everything, as large as the picture allows.
[[nodiscard]] Camera fit(const Scene& scene, PatientView view, double aspect);

// Fails with "scene-invalid", saying which item, where something cannot be drawn. That is a missing surface or volume,
// an index out of range, a position that is not finite, an unknown field, or an empty range.
Result<void> check_scene(const Scene& scene);

// Draws off screen, anti-aliased, with or without an X server: the same picture bit for bit either way. Sizes from 16
// to 8192 pixels a side. Fails when the scene is invalid, or with "picture-size" when the size is out of range. Fails
// with "drawing-unavailable" when the machine has no OpenGL 3.2 at all, not even in software.
Result<Picture> draw(const Scene& scene, int width, int height);

}  // namespace glisson::scene

#pragma once
// What has changed in a view since its last frame: everything that a Painter needs to draw the next one. Later changes
// take the place of earlier ones, so that a view that is not drawn for long gathers no more than one of each.

#include <cstddef>
#include <Eigen/Core>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "scene/backdrop.h"
#include "scene/drawing.h"
#include "scene/internal/viewport.h"
#include "scene/scene.h"

namespace glisson::scene {

enum class Visibility { shown, hidden };

// While the camera moves, a slow renderer is helped by fewer triangles: points that lie within a few mm become one.
enum class Detail { full, coarse };

// A surface is known by the pointer that the scene was given, wherever it stands there: drawn, cut by slices, or both.
using SurfaceId = std::shared_ptr<const geometry::Surface>;
using Points = std::shared_ptr<const std::vector<Eigen::Vector3d>>;

struct ViewChanges {
  struct Slice {
    std::optional<Eigen::Vector3d> center_mm;
    std::optional<Eigen::Vector3d> normal;
    struct Window {
      double center = 0;
      double width = 1;
    };
    std::optional<Window> window;
  };

  std::optional<Scene> scene;  // in place of what was there; what follows is said of it
  std::map<SurfaceId, Points> moved;
  std::map<SurfaceId, std::vector<double>> recoloured;
  std::map<SurfaceId, Visibility> visibility;
  std::map<std::size_t, Slice> slices;
  std::optional<std::vector<LandmarkItem>> landmarks;
  std::optional<std::vector<ArrowItem>> arrows;
  std::optional<std::vector<RodItem>> rods;
  std::optional<std::optional<CrosshairItem>> crosshair;
  std::optional<std::vector<LineItem>> lines;
  std::optional<Annotations> annotations;
  std::optional<std::vector<DrawnLines>> drawn_lines;
  std::optional<std::optional<DrawnCells>> drawn_cells;
  std::optional<std::optional<Backdrop>> backdrop;
  std::optional<double> pixel_scale;
  std::optional<Detail> detail;

  // Of every frame. At `shrink` 2 it is drawn at half that size each way, to be enlarged by whoever shows it.
  // Everything that is said in pixels stays in those of the full size.
  Viewport viewport;
  int shrink = 1;
};

}  // namespace glisson::scene

#pragma once
// What is drawn over the slices while a person works on them. Lines and coloured cells are values, which a view takes
// (view_changes.h). Drawing shows them in VTK's renderer.

#include <array>
#include <cstdint>
#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "imaging/image.h"
#include "scene/colour.h"

class vtkRenderer;

namespace glisson::scene {

// Straight pieces: two ends each, patient LPS, mm.
struct DrawnLines {
  std::vector<Eigen::Vector3d> ends_mm;
  Colour colour;
  double width_px = 1.8;
};

// One layer of a grid (one of its sizes is 1), a colour with its opacity for each voxel: red, green, blue, opacity.
struct DrawnCells {
  imaging::Grid layer;
  std::vector<std::array<std::uint8_t, 4>> colours;
};

// The outline of a mask in one layer of its grid, half-way between voxels inside and outside. Where the mask reaches
// the grid's border it is closed half a voxel beyond. Two ends a piece, patient LPS, mm, in the plane of the layer.
[[nodiscard]] std::vector<Eigen::Vector3d> outline_in_layer(const imaging::Mask& mask, int axis, int layer);

class Drawing {
 public:
  explicit Drawing(vtkRenderer& renderer);
  ~Drawing();
  Drawing(const Drawing&) = delete;
  Drawing& operator=(const Drawing&) = delete;

  void set_lines(const std::vector<DrawnLines>& lines);
  void set_cells(const std::optional<DrawnCells>& cells);
  // Towards the viewer, so that the slice does not hide it.
  void lift(const Eigen::Vector3d& towards_viewer_mm);
  void set_line_scale(double pixel_scale);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace glisson::scene

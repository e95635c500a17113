#pragma once
// Drawing onto frames: what a camera would show of points in space, and flat shapes over a picture.

#include <array>
#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "vision/calibration.h"
#include "vision/frame.h"

namespace glisson::vision {

// Where the camera shows each point (camera mm), with its lens's distortion; nothing for points at or behind it.
std::vector<std::optional<Eigen::Vector2d>> project(const Camera& camera,
                                                    const std::vector<Eigen::Vector3d>& points_mm);

// The directions (x, y, 1) in which pixels look, without the lens's distortion; nothing where no direction is seen
// there, as beyond where a polynomial of the lens turns back.
std::vector<std::optional<Eigen::Vector3d>> rays(const Camera& camera, const std::vector<Eigen::Vector2d>& pixels);

using Rgb = std::array<std::uint8_t, 3>;

struct FlatTriangle {
  std::array<Eigen::Vector2d, 3> corners_px;
  Rgb colour;
};

// Lays the triangles over the frame, later ones over earlier ones, all together with one opacity (0..1), and their
// edges as thin darker lines.
void draw_triangles(Frame& frame, const std::vector<FlatTriangle>& triangles, double opacity);

// The outlines of what the triangles cover together in a picture of that size: closed lines from pixel to neighbouring
// pixel, without those around holes.
std::vector<std::vector<Eigen::Vector2d>> outlines(int width, int height,
                                                   const std::vector<std::array<Eigen::Vector2d, 3>>& triangles_px);

// A line from point to point, open.
void draw_line(Frame& frame, const std::vector<Eigen::Vector2d>& points_px, Rgb colour, int width_px);

// A filled rectangle, and a line of text (ASCII) whose capitals are `height_px` tall, from its lower left corner.
void draw_rectangle(Frame& frame, int x, int y, int width, int height, Rgb colour);
void draw_text(Frame& frame, int x, int y, int height_px, const std::string& text, Rgb colour);

}  // namespace glisson::vision

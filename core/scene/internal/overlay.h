#pragma once
// What lies flat on a picture: text, bands, bars, lines. Drawn anew for each frame between begin() and end(); text that
// did not change is not laid out again. VTK types may stand here.
//
// Positions are in pixels from the lower left corner, as VTK counts them.

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>
#include <array>
#include <Eigen/Core>
#include <string>
#include <vector>

#include "scene/colour.h"

namespace glisson::scene {

enum class Anchor { lower_left, lower_centre, upper_left, upper_right, lower_right, centre, left_centre, right_centre };

struct TextStyle {
  Colour colour;
  double size_px = 15;
  bool bold = false;
  double plate_opacity = 0;  // of a plate behind the text that keeps it readable over anything
  Colour plate{0, 0, 0};
  double opacity = 1;
};

class FlatProp;

class Overlay {
 public:
  explicit Overlay(vtkRenderer& renderer);
  ~Overlay();
  Overlay(const Overlay&) = delete;
  Overlay& operator=(const Overlay&) = delete;

  void begin();
  void fill(const std::vector<Eigen::Vector2d>& corners, const Colour& colour, double opacity = 1);
  void rectangle(const Eigen::Vector2d& low, const Eigen::Vector2d& high, const Colour& colour, double opacity = 1);
  // A straight line of that width, as a thin rectangle.
  void line(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double width_px, const Colour& colour,
            double opacity = 1);
  // Returns the text's size in pixels.
  Eigen::Vector2d text(const std::string& words, const Eigen::Vector2d& place, Anchor anchor, const TextStyle& style);
  void end();

 private:
  vtkRenderer& renderer_;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> polygons_;
  vtkNew<vtkUnsignedCharArray> colours_;
  vtkNew<vtkPolyData> shapes_;
  vtkSmartPointer<FlatProp> prop_;
  std::size_t texts_used_ = 0;
};

}  // namespace glisson::scene

#pragma once
// Contours of a picture under a pose of the organ: how badly they fit, the steps that fit them better, and how far each
// is from where the pose puts it. A direction before the camera is (x, y, 1).

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "geometry/surface.h"
#include "guidance/contour_pose.h"

namespace glisson::guidance {

// The edges at which a surface may turn away. The surface outlives it.
class TurningEdges {
 public:
  explicit TurningEdges(const geometry::Surface& organ);
  // The middles of the edges between a side that the camera sees and one that it does not.
  [[nodiscard]] std::vector<Eigen::Vector3d> seen_from(const Eigen::Vector3d& camera_mm) const;

 private:
  struct Edge {
    Eigen::Vector3d middle_mm;
    int left, right;  // triangles
  };
  const geometry::Surface& organ_;
  std::vector<Edge> edges_;
};

class ContourFit {
 public:
  // Of each contour, at most some dozens of places are asked; pixels in which the lens tells no direction are left out.
  // `organ` outlives it.
  ContourFit(const geometry::Surface& organ, const vision::Camera& camera, const std::vector<SeenContour>& contours);

  [[nodiscard]] const Eigen::Vector3d& middle_mm() const { return middle_mm_; }  // of the organ at rest
  [[nodiscard]] std::size_t lines_at_rest() const;  // contours that are used and are no silhouette

  // Turned so, as far away as the lines look large, with their middle where they are seen.
  [[nodiscard]] Eigen::Isometry3d begun_at(const Eigen::Matrix3d& turn) const;
  // Least squares, round by round with narrower weights.
  [[nodiscard]] Eigen::Isometry3d refined(Eigen::Isometry3d pose) const;

  // 0: all lies where it was seen; 1: nothing does. As widely as a search begins, and as narrowly as it ends.
  [[nodiscard]] double wide_cost(const Eigen::Isometry3d& pose) const;
  [[nodiscard]] double narrow_cost(const Eigen::Isometry3d& pose) const;
  // The share of the lines that would lie on a side turned away from the camera: what is seen does not.
  [[nodiscard]] double turned_away(const Eigen::Isometry3d& pose) const;

  // Of a contour, by its place in the list; nothing where it is not used.
  [[nodiscard]] std::optional<ContourError> error(std::size_t contour, const Eigen::Isometry3d& pose) const;

 private:
  using Step = Eigen::Matrix<double, 6, 1>;  // a shift, mm, and a turn about the organ's middle
  // A contour that is used.
  struct Line {
    std::vector<Eigen::Vector3d> at_rest_mm;  // none: the silhouette
    std::vector<Eigen::Vector2d> seen;
    std::vector<Eigen::Vector3d> outwards;  // of the surface around each place at rest, unit
  };
  // A line's places before the camera.
  struct Shown {
    std::vector<Eigen::Vector3d> place_mm;
    std::vector<Eigen::Vector2d> at;
    bool has_ends = false;

    // Across the line what is off counts, along it hardly, but at its ends.
    [[nodiscard]] Eigen::Matrix2d trusted(std::size_t p) const;
  };
  [[nodiscard]] Shown shown_of(const Line& line, const Eigen::Isometry3d& pose) const;
  [[nodiscard]] bool is_within(const Eigen::Vector2d& at) const;  // where anything was seen
  // With a step that makes it less, where one is asked for.
  [[nodiscard]] double cost(const Eigen::Isometry3d& pose, double width_px, Step* step = nullptr) const;

  TurningEdges turning_;
  double focal_px_;
  Eigen::Vector3d middle_mm_{0, 0, 0};
  std::vector<Line> lines_;
  std::vector<std::optional<std::size_t>> line_of_;  // of each contour
  Eigen::Vector2d low_, high_;                       // around all that was seen
};

}  // namespace glisson::guidance

#pragma once
// A cut through a body, along a plane, or along a smooth sheet through points that somebody drew. It is open
// everywhere, or within a ball, where the rest still hangs together.

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "base/result.h"
#include "geometry/cut_surface.h"
#include "geometry/tetrahedra.h"

namespace glisson::mechanics {

struct Cut {
  Eigen::Vector3d center_mm{0, 0, 0};                          // on the plane; of a sheet's ball, otherwise not read
  Eigen::Vector3d normal{0, 0, 1};                             // of the plane; of a sheet not read
  double radius_mm = std::numeric_limits<double>::infinity();  // of the ball; infinite: open everywhere
  std::vector<Eigen::Vector3d> points_mm = {};                 // of a sheet (geometry/cut_surface.h); none: a plane
};

// A cut that can be asked.
struct CutInSpace {
  geometry::CutSurface surface;
  Eigen::Vector3d center_mm;
  double radius_mm;

  // Failure: "cut-invalid", as geometry::CutSurface has it.
  static Result<CutInSpace> of(const Cut& cut);

  [[nodiscard]] bool is_open_at(const Eigen::Vector3d& place_mm) const {
    return (place_mm - center_mm).norm() <= radius_mm;
  }
  // Whether the open part stands between two places at these heights over the surface. Where they are far apart, a
  // sheet is taken to cross the line between them where a plane would.
  [[nodiscard]] bool separates(const Eigen::Vector3d& a_mm, double height_a_mm, const Eigen::Vector3d& b_mm,
                               double height_b_mm) const;
  [[nodiscard]] bool separates(const Eigen::Vector3d& a_mm, const Eigen::Vector3d& b_mm) const {
    return separates(a_mm, surface.height_mm(a_mm), b_mm, surface.height_mm(b_mm));
  }
};

// The body with its cuts open (geometry/split_tetrahedra.h), one after the other.
struct OpenedBody {
  geometry::TetMesh mesh;
  struct Wall {
    int below, above;        // two points of the mesh that were one
    Eigen::Vector3d normal;  // of the cut, from below to above
  };
  std::vector<Wall> walls;
};

// The points of the mesh that lie on walls, each once, ascending.
[[nodiscard]] std::vector<int> points_on(const std::vector<OpenedBody::Wall>& walls);

// How far a point of the mesh is taken onto the surface (geometry::SplitOptions::snap). Exactly along it there are
// small tetrahedra, which are poor for finite elements. They are harmless to the meshfree engine, which only integrates
// over them, and which needs the walls where its cut is.
enum class Along { nearly, exactly };

// Failures: "cut-misses" (one that opens nothing, by its number), "cut-invalid".
Result<OpenedBody> open_cuts(const geometry::TetMesh& mesh, const std::vector<Cut>& cuts, Along along);

// `largest_opening_mm` is how far apart points are that were one. `largest_overlap_mm` is how far the walls have passed
// through each other, were they flat and had they not slid. Zeros without walls.
struct CutOpening {
  double largest_opening_mm = 0;
  double largest_overlap_mm = 0;
};
[[nodiscard]] CutOpening opening_of(const OpenedBody& body, const std::vector<Eigen::Vector3d>& displacement_mm);

}  // namespace glisson::mechanics

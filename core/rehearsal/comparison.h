#pragma once
// Two results of the same body side by side: how far apart do they put the same point? From 5 mm on it matters to a
// surgeon (section 4.4 of the dissertation, after its reference [44]).

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "geometry/tetrahedra.h"
#include "mechanics/simulation.h"

namespace glisson::rehearsal {

inline constexpr double significant_mm = 5.0;

struct LandmarkDifference {
  std::string id;
  double displacement_a_mm = 0;
  double displacement_b_mm = 0;
  double difference_mm = 0;  // distance between the two displaced positions
  [[nodiscard]] bool significant() const { return difference_mm >= significant_mm; }
};

struct Comparison {
  double mean_mm = 0;  // over the boundary points, each weighted by its share of the surface
  double max_mm = 0;   // over the boundary points and the landmarks
  std::optional<double>
      max_near_tool_mm;  // boundary points within twice the tool's radius of its centre; absent without a tool
  std::vector<double> difference_mm;          // one a point of the mesh
  std::vector<LandmarkDifference> landmarks;  // those in both
  [[nodiscard]] bool significant() const { return max_mm >= significant_mm; }
};

// Failures: "comparison-mismatch" where the meshes are not the same points (within 1e-3 mm) or a result did not
// converge. What a result is worth (validity.h) its caller tells: studies count linear answers beyond small strain too.
Result<Comparison> compare(const mechanics::Simulation& a, const mechanics::Simulation& b);

// The same from what is read back from files: one rest mesh, its two displacement fields.
struct ComparedResult {
  geometry::TetMesh mesh;  // rest points, with point field "displacement_mm"
  std::vector<mechanics::DisplacedLandmark> landmarks;
  std::vector<mechanics::ToolLoad> tools;
  mechanics::Validity validity = {};
};
Result<Comparison> compare(const ComparedResult& a, const ComparedResult& b);

// The landmarks that are in both lists, by id, in the order of the first.
[[nodiscard]] std::vector<LandmarkDifference> differences_between(const std::vector<mechanics::DisplacedLandmark>& a,
                                                                  const std::vector<mechanics::DisplacedLandmark>& b);

}  // namespace glisson::rehearsal

#pragma once
// The liver where it lies: at rest, or displaced under tools. A cut is set and measured there, and what it divides is
// told of the tissue, which does not change by being held aside.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "geometry/surface.h"
#include "geometry/tetrahedra.h"
#include "mechanics/statics/validity.h"

namespace glisson::rehearsal {

enum class StructureKind { tumour, cyst, vessel };  // a cyst has no margin to keep
struct NamedStructure {
  std::string name;
  StructureKind kind = StructureKind::tumour;
  geometry::Surface surface;  // closed, patient LPS, mm
  double shift_mm = 0;        // how far its middle has been displaced: 0 at rest
};

struct LyingLiver {
  geometry::TetMesh mesh;                // points where they lie; displaced ones with the point field "displacement_mm"
  std::vector<double> rest_volumes_mm3;  // of each cell
  // What the answer is worth that displaced it; nothing at rest.
  std::optional<mechanics::Validity> validity = std::nullopt;
};

[[nodiscard]] LyingLiver at_rest(const geometry::TetMesh& liver);

// Displaced by `displacement_mm`, one a point of the mesh at rest. Within a cell the displacement is linear, as it is
// drawn; by that its strain is judged, until the caller knows better. Failures: "retraction-mismatch" (another number
// of points, or one that is not finite); "retraction-inverted" where cells are turned inside out: nothing can be
// measured there.
Result<LyingLiver> displaced(const geometry::TetMesh& rest, const std::vector<Eigen::Vector3d>& displacement_mm);

// Structures carried along with the liver around them; what lies outside of it goes with its nearest place.
[[nodiscard]] std::vector<NamedStructure> displaced(const geometry::TetMesh& rest,
                                                    const std::vector<Eigen::Vector3d>& displacement_mm,
                                                    std::vector<NamedStructure> structures);

// How far the middle of a structure's points has gone.
[[nodiscard]] double shift_mm(const geometry::Surface& rest, const geometry::Surface& now);

// Back to rest: the points without their field "displacement_mm". Without that field it lies at rest already.
[[nodiscard]] geometry::TetMesh put_to_rest(geometry::TetMesh mesh);
[[nodiscard]] geometry::Surface put_to_rest(geometry::Surface surface);

}  // namespace glisson::rehearsal

#pragma once
// A planned resection: a surface divides the liver, and what is on which side, how much of it, how near to the tumours,
// and which vessels it meets.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "geometry/cut_surface.h"
#include "geometry/split_tetrahedra.h"

namespace glisson::rehearsal {

// Margins that matter: under 1 mm the resection counts as R1 (tumour at the edge), under 5 mm it is narrow.
inline constexpr double r1_margin_mm = 1.0;
inline constexpr double narrow_margin_mm = 5.0;

enum class StructureKind { tumour, cyst, vessel };  // a cyst has no margin to keep
struct NamedStructure {
  std::string name;
  StructureKind kind = StructureKind::tumour;
  geometry::Surface surface;  // closed, patient LPS, mm
};

enum class ResectionSide { specimen, remnant, both };
[[nodiscard]] std::string to_string(ResectionSide side);

struct TumourMargin {
  std::string name;
  ResectionSide side = ResectionSide::specimen;
  double margin_mm = 0;  // to the cut inside the liver; 0 where the cut goes through it
  [[nodiscard]] bool r1() const { return margin_mm < r1_margin_mm; }
  [[nodiscard]] bool narrow() const { return margin_mm < narrow_margin_mm; }
};

struct StructureSide {
  std::string name;
  ResectionSide side = ResectionSide::specimen;
};

// One outline that the cut leaves on a vessel. Of an oblique cut the diameter is the narrow one, that of the vessel
// itself: 4 sqrt of the smaller principal second moment per area, which is exact for an ellipse.
struct VesselCrossing {
  std::string name;
  Eigen::Vector3d center_mm{0, 0, 0};
  double diameter_mm = 0;
  double area_mm2 = 0;
};

struct Resection {
  double specimen_ml = 0;
  double remnant_ml = 0;
  double volume_error_ml = 0;  // 0 for a plane: exact on the mesh given
  double cut_area_mm2 = 0;
  std::vector<TumourMargin> tumours;
  std::vector<StructureSide> cysts;
  std::vector<StructureSide> vessels;
  std::vector<VesselCrossing> crossings;  // the widest first
  bool specimen_is_above = false;         // on the side that the cut's normal points to
  geometry::Surface cut;                  // inside the liver
  geometry::SplitMesh split;              // the liver in its parts, open along the cut
  std::vector<std::string> notes;

  [[nodiscard]] double remnant_percent() const { return 100.0 * remnant_ml / (remnant_ml + specimen_ml); }
};

// The specimen is the side that holds `specimen_mm`, or the smaller one. Margins are between the structure's triangles
// and the cut's; where a sheet is bent the cut's are chords of it within each cell. Vessels are followed where they lie
// in the liver, or at most 2 mm out of it. Failures: those of check_tetrahedra and check_surface; "cut-misses";
// "specimen-on-cut".
Result<Resection> plan_resection(const geometry::TetMesh& liver, const geometry::CutSurface& cut,
                                 const std::vector<NamedStructure>& structures,
                                 const std::optional<Eigen::Vector3d>& specimen_mm = {});

}  // namespace glisson::rehearsal

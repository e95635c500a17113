#pragma once
// A planned resection: a surface divides the liver. The answer is what is on which side, how much of it, how near to
// the tumours, and which vessels it meets.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "geometry/cut_surface.h"
#include "geometry/split_tetrahedra.h"
#include "rehearsal/retraction.h"

namespace glisson::rehearsal {

// Margins that matter: under 1 mm the resection counts as R1 (tumour at the edge), under 5 mm it is narrow.
inline constexpr double r1_margin_mm = 1.0;
inline constexpr double narrow_margin_mm = 5.0;

enum class ResectionSide { specimen, remnant, both };
[[nodiscard]] std::string to_string(ResectionSide side);

struct TumourMargin {
  std::string name;
  ResectionSide side = ResectionSide::specimen;
  double margin_mm = 0;  // to the cut inside the liver; 0 where the cut goes through it
  double shift_mm = 0;   // how far the tools have displaced it; 0 at rest
  [[nodiscard]] bool r1() const { return margin_mm < r1_margin_mm; }
  [[nodiscard]] bool narrow() const { return margin_mm < narrow_margin_mm; }
};

struct StructureSide {
  std::string name;
  ResectionSide side = ResectionSide::specimen;
};

// Hepatic veins reach 15 mm at their mouths where blood is held up in them (Henriksson et al., Acta Med Scand 211,
// 1982). What is wider under their name is the vena cava that they open into.
inline constexpr double widest_hepatic_vein_mm = 20.0;

// One outline that the cut leaves on a vessel. Of an oblique cut the diameter is the narrow one, that of the vessel
// itself. It is 4 sqrt of the smaller principal second moment per area, which is exact for an ellipse.
struct VesselCrossing {
  std::string name;
  Eigen::Vector3d center_mm{0, 0, 0};
  double diameter_mm = 0;
  double area_mm2 = 0;
  // Called a hepatic vein, and too wide for one.
  [[nodiscard]] bool vena_cava_by_calibre() const {
    return name.starts_with("hepatic-vein") && diameter_mm > widest_hepatic_vein_mm;
  }
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
  geometry::Surface cut;                  // inside the liver, where it lies
  geometry::SplitMesh split;              // the liver in its parts, open along the cut, where it lies
  std::vector<std::string> notes;
  std::optional<mechanics::Validity> retraction = {};  // of a liver that is held aside: what that answer is worth

  [[nodiscard]] double remnant_percent() const { return 100.0 * remnant_ml / (remnant_ml + specimen_ml); }
};

// The specimen is the side that holds `specimen_mm`, or the smaller one. Margins are between the structure's triangles
// and the cut's; where a sheet is bent the cut's are chords of it within each cell. Vessels are followed where they lie
// in the liver, or at most 2 mm out of it. Failures: those of check_tetrahedra and check_surface; "cut-misses";
// "specimen-on-cut".
Result<Resection> plan_resection(const geometry::TetMesh& liver, const geometry::CutSurface& cut,
                                 const std::vector<NamedStructure>& structures,
                                 const std::optional<Eigen::Vector3d>& specimen_mm = {});

// The same of a liver that is held aside. Cut, point and structures are where it lies now. So are margins, widths,
// areas and the parts (put_to_rest takes those back); volumes are those at rest.
Result<Resection> plan_resection(const LyingLiver& liver, const geometry::CutSurface& cut,
                                 const std::vector<NamedStructure>& structures,
                                 const std::optional<Eigen::Vector3d>& specimen_mm = {});

// The two parts of a liver of that volume, each by its share of the mesh, and what is uncertain of them. A mesh is one
// or two per cent off the outline that it was made from, while a liver has one volume.
void measure_as(Resection& plan, double liver_ml);

}  // namespace glisson::rehearsal

#pragma once
// What a plan consists of: cuts, whose union is taken out.
//
// Frame: patient coordinates, LPS, mm.

#include <Eigen/Core>
#include <string>
#include <variant>
#include <vector>

namespace glisson::planning {

// Which side of a surface goes: the smaller or the larger one, or that to which the normal points, or the other.
enum class Removed { smaller, larger, above, below };

struct PlaneCut {
  Eigen::Vector3d point_mm{0, 0, 0};
  Eigen::Vector3d normal{0, 0, 1};  // any length but zero
  Removed removed = Removed::smaller;

  bool operator==(const PlaneCut&) const = default;
};

// A smooth sheet through points (geometry::CutSurface::through).
struct SheetCut {
  std::vector<Eigen::Vector3d> through_mm;
  Removed removed = Removed::smaller;

  bool operator==(const SheetCut&) const = default;
};

// This and the next spare vessels that only run through: a branch is cut where at least half of what hangs on it goes.
struct SegmentsCut {
  std::vector<int> segments;  // Couinaud's, 1 to 8

  bool operator==(const SegmentsCut&) const = default;
};

// All that the branches of that name feed or drain, with what grows from them: "portal/right/posterior" are all whose
// names begin so.
struct TerritoryCut {
  std::string branch;

  bool operator==(const TerritoryCut&) const = default;
};

// A tumour with all tissue up to that distance from it.
struct MarginCut {
  std::string tumour;
  double margin_mm = 10;

  bool operator==(const MarginCut&) const = default;
};
inline constexpr double largest_margin_mm = 30;

// Tissue that is ablated where it stands: a spheroid around the probe. Vessels of 3 mm and more carry the heat away and
// go on flowing through it (Lu et al. 2002, AJR 178:47); narrower ones close.
struct AblationCut {
  Eigen::Vector3d center_mm{0, 0, 0};
  Eigen::Vector3d direction{0, 0, 1};  // of the probe, any length but zero
  double radius_along_mm = 15;
  double radius_across_mm = 15;

  bool operator==(const AblationCut&) const = default;
};
inline constexpr double ablation_spares_vessels_mm = 3;  // diameter
inline constexpr double largest_ablation_mm = 60;        // radius

// How far a place is from the surface of the zone, to first order; negative inside.
[[nodiscard]] double outside_mm(const AblationCut& zone, const Eigen::Vector3d& place_mm);

using Cut = std::variant<PlaneCut, SheetCut, SegmentsCut, TerritoryCut, MarginCut, AblationCut>;

struct Plan {
  std::string name;
  std::vector<Cut> cuts;
};

}  // namespace glisson::planning

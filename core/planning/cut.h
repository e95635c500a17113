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

using Cut = std::variant<PlaneCut, SheetCut, SegmentsCut, TerritoryCut, MarginCut>;

struct Plan {
  std::string name;
  std::vector<Cut> cuts;
};

}  // namespace glisson::planning

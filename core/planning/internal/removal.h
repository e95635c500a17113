#pragma once
// Which voxels of a liver the cuts of a plan take.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/result.h"
#include "geometry/cut_surface.h"
#include "planning/cut.h"
#include "planning/internal/cut_off.h"
#include "planning/internal/organ.h"
#include "planning/internal/tumour_margins.h"

namespace glisson::planning {

// Heights over a sheet are asked for at nodes some millimetres apart and are linear in between: a sheet bends less.
struct HeightNodes {
  std::array<int, 3> step{1, 1, 1};  // in voxels
  std::array<int, 3> size{0, 0, 0};
  std::vector<std::uint32_t> needed;  // those around voxels of the organ
};
[[nodiscard]] HeightNodes height_nodes(const Organ& organ);

// What the cuts need to know of a liver.
struct Cuttable {
  const Organ& organ;
  const HeightNodes& nodes;
  const std::vector<std::uint8_t>& segment;  // of each voxel, 0: none
  bool has_segments;
  const vasculature::VesselTrees& trees;
  const TreePoints& points;
  const std::array<std::vector<std::uint32_t>, 2>& point;  // of each voxel, of the portal and of the hepatic tree
  const std::vector<TumourSurroundings>& tumours;
};

// A cut as it is measured.
struct PreparedCut {
  std::optional<geometry::CutSurface> surface;
  double sign = 1;  // what goes lies where sign * height is positive
  std::optional<std::size_t> tumour;
  double margin_mm = 0;
  std::optional<AblationCut> ablation = {};
};

// Why a voxel goes, bit by bit. A cut by plane, sheet or margin spares no vessel. One along the anatomy (segments,
// territory) spares those that only run through. An ablation spares wide ones.
inline constexpr std::uint8_t goes_with_vessels = 1, goes_by_anatomy = 2, goes_by_ablation = 4;

struct Removal {
  std::vector<std::uint8_t> removed;  // of each voxel; 0: it stays
  std::vector<PreparedCut> cuts;
  bool along_anatomy = false;  // some of it goes by anatomy
  std::size_t ablated = 0;     // voxels that go by ablation alone
};

// Failures: as Planner::answer.
[[nodiscard]] Result<Removal> removal_by(const std::vector<Cut>& cuts, const Cuttable& liver);

}  // namespace glisson::planning

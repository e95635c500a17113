#pragma once
// The vessel trees of a case, and whose tissue is whose, kept in the case until what they were made from changes.
//
//   vessels/trees              glisson-vessel-trees/1 (vasculature/tree_file.h)
//   territories/couinaud       .nrrd, segments I to VIII as 3D Slicer names them
//   territories/doubt          .nrrd, of each voxel's segment, percent
//   territories/portal-vein    .nrrd, branch + 1 by its name; territories/hepatic-vein likewise
//
// The images lie on the part of the liver's grid around it.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "casefile/case.h"
#include "imaging/segment.h"
#include "vasculature/couinaud.h"

namespace glisson::casefile {

inline constexpr const char* trees_id = "vessels/trees";
inline constexpr const char* couinaud_id = "territories/couinaud";
// The eight segments by name and colour, with their values in that map.
[[nodiscard]] std::vector<imaging::SegmentInfo> couinaud_segment_infos();

// From labels/liver and one structure of both systems; without its name from portal-vein and hepatic-vein, or where
// these are not there from "vessels". Arteries and bile ducts that the case has outlined (artery, biliary-tract) get
// trees besides. Trees that were made so before, of what the case still holds, are read. Fails with vessels-missing,
// labels-grids-differ, vessels-overlap and as the room vasculature says.
Result<vasculature::VesselTrees> find_vessels(Case& patient, const std::optional<std::string>& structure,
                                              const vasculature::Told& told = {}, const Progress& progress = {});

enum class SegmentsBy { trees, shape };
struct FoundTerritories {
  vasculature::CouinaudSegments couinaud;
  vasculature::VesselTrees trees;  // empty by shape
  // By system of veins (vasculature::vein_systems): branch + 1 of each voxel; nothing where it has no branch.
  std::array<std::optional<imaging::LabelMap>, 2> territory;
};
// By trees: those that find_vessels saved, with the borders that these were told; borders are for the shape alone.
// Fails with vessels-missing and as the room vasculature says.
Result<FoundTerritories> find_territories(Case& patient, SegmentsBy by, const vasculature::BorderPlaces& borders = {},
                                          const Progress& progress = {});

// The same without keeping them: by the trees where the case has any; what is kept is read.
Result<FoundTerritories> territories_in(const Case& patient, SegmentsBy by, const Progress& progress = {});

// What vessels and segments were told when they were last found.
[[nodiscard]] vasculature::Told told_in(const Case& patient);

// Whether the case keeps them, and whether what they were made from has changed since.
enum class Kept { no, changed, current };
[[nodiscard]] Kept kept_territories(const Case& patient, SegmentsBy by);

}  // namespace glisson::casefile

#pragma once
// Couinaud's eight segments of a liver, from its vessel trees or, where there are none, from its shape alone.
//
// What parts the segments (internal/segment_planes.h) is fitted to one liver. It stays near the mean of real livers,
// with segments of about published sizes, hepatic veins on the borders, portal branches off them. Most probable answer
// of a model with 23 numbers; the doubt of a voxel is the share of other likely answers that call it otherwise.

#include <array>
#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "imaging/image.h"
#include "vasculature/systems.h"

namespace glisson::vasculature {

// "I" to "VIII" of 1 to 8.
[[nodiscard]] const char* segment_name(std::size_t number);

// Red, green and blue, 0 to 1, of 1 to 8: told apart by the colour blind too (Okabe and Ito 2008, and a grey).
[[nodiscard]] const std::array<double, 3>& segment_colour(std::size_t number);

enum class SegmentsFrom { trees, shape };

struct CouinaudSegments {
  SegmentsFrom from = SegmentsFrom::shape;
  imaging::LabelMap segment;               // 1 to 8 in the liver, 0 elsewhere
  std::vector<std::uint8_t> doubt;         // of each voxel, percent
  std::array<double, 9> volume_ml{};       // by segment; 0: all
  std::array<double, 9> confidence{};      // one less the mean doubt
  std::vector<BorderDoubt> border_doubts;  // the largest first; not kept with the maps
};

// Without trees (null, or none with branches) the liver's shape decides, with the borders that a hand set: these
// besides those of the trees. Each passes its place to half a voxel. Fails as liver_frame and lie_in_liver do, with
// vessels-outside (most of the trees' length lies outside of the liver), border-far (that border runs there in no
// liver), borders-contradict (borders cannot pass all of their places) and cancelled.
Result<CouinaudSegments> couinaud_segments(const imaging::Mask& liver, const VesselTrees* trees = nullptr,
                                           const BorderPlaces& borders = {}, const Progress& progress = {});

// Sets volumes and confidence from the voxels.
void measure(CouinaudSegments& segments);

// Where vessels enter, by the liver's shape alone. Fails as liver_frame does.
Result<VesselEntries> expected_entries(const imaging::Mask& liver);

// Fails with click-beside: one of them lies more than 10 mm from the wall of any vessel.
Result<void> lie_on_vessels(const VesselGraph& graph, const Clicks& clicks);

// Vessels of one class told apart, and the segments with them. Fails as couinaud_segments and lie_on_vessels do.
struct LiverAnatomy {
  VesselTrees trees;
  CouinaudSegments segments;
};
Result<LiverAnatomy> explain_vessels(const VesselGraph& graph, const imaging::Mask& liver, const Told& told = {},
                                     const Progress& progress = {});

// Gives each branch a stable name, such as "portal/right/posterior/VI/2" or "hepatic/middle/3". It has system, side,
// sector, segment and, from the thickest on, a number, as far as the branch has one of each. Arteries and bile ducts
// are named as portal branches are: "hepatic-artery/left/lateral/II"; what runs beside the liver "bile-duct/outside".
void name_branches(VesselTrees& trees, const CouinaudSegments& segments);

}  // namespace glisson::vasculature

#pragma once
// The vessels of an organ in a contrast CT or an MR, without a click: what is shaped like a tube and stands out.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "base/sentence.h"
#include "imaging/image.h"

namespace glisson::segmentation {

enum class VesselBrightness { bright, dark };

struct SegmentVesselsOptions {
  std::optional<VesselBrightness> brightness;  // absent: bright in CT (HU), else what more of the tubes are
  double narrowest_mm = 1;                     // radii that are looked for
  double widest_mm = 9;
  double sure_to_noise = 10;       // a tube begins where it stands out from noise so many times
  double likely_to_noise = 6;      // and goes on down to here
  double share_of_contrast = 0.4;  // and to this share of the clearest vessels' contrast
  double shortest_mm = 10;         // no piece shorter than this is a vessel
};

struct SegmentedVessels {
  imaging::Mask mask;  // on the grid of the image
  double volume_ml = 0;
  VesselBrightness brightness = VesselBrightness::bright;
  double contrast = 0;          // between the medians of vessels and tissue, in the image's unit; negative: darker
  std::vector<Sentence> notes;  // what they stand out by, and why to look at the outline
};

// Tubes by the Hessian over scales (internal/tubularity.h) from where they are sure along what is likely. Their border
// lies half-way between their own brightness and that of the tissue around them, as far from their axis as the
// scale allows: nothing leaks into what is no tube. `organ` (same grid: asserts), its holes filled, is all that is
// looked at. With seeds (patient LPS, mm) only what hangs on one of them is kept, else all pieces that are long enough.
// Deterministic.
//
// Fails with vessels-no-organ (`organ` holds nothing), vessels-none (nothing stands out as a tube), vessels-seed-off (a
// seed lies more than 5 mm from every vessel found), grow-bad-image or cancelled.
Result<SegmentedVessels> segment_vessels(const imaging::Volume& image, const imaging::Mask& organ,
                                         const std::vector<Eigen::Vector3d>& seeds_mm = {},
                                         const SegmentVesselsOptions& options = {}, const Progress& progress = {});

}  // namespace glisson::segmentation

#pragma once
// The liver from a few points inside it, in MR or CT.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "imaging/image.h"

namespace glisson::segmentation {

struct GrowOptions {
  // Around each seed the tissue's brightness and its spread are learnt in a ball of this radius. It holds a few
  // hundred voxels of a clinical image, and fits between the large vessels.
  double sample_radius_mm = 9;

  // A voxel belongs when its smoothed brightness lies within this many spreads of the tissue's. Wider takes in
  // muscle and stomach, narrower loses the noisy edge.
  double tolerance_sd = 2.5;

  // The brightness that is expected may drift over this length, as the coils of an MR scanner make it do. Organs
  // whose brightness differs are smaller than this and are not mistaken for a drift. Not used for CT (unit "HU").
  double bias_length_mm = 60;

  // A bridge to another organ that is narrower than twice this is cut. The liver itself is thicker but at the tips,
  // which are given back.
  double neck_radius_mm = 6;

  // Holes and clefts up to about this radius are taken as vessels or tumours and belong to the liver.
  double closing_radius_mm = 4;
};

// Why the outcome may not be the liver.
enum class GrowthDoubt {
  touches_border,  // reaches the edge of the image: the organ is cut, or the growth ran out through it
  too_large,       // more than a liver holds: probably leaked into a neighbour
  too_small,       // less than a liver holds: probably stopped early
  seeds_disagree,  // seeds in tissue of different brightness: one is probably outside the liver
  separate_pieces  // seeds whose regions do not meet
};

struct GrowResult {
  imaging::Mask mask;  // on the grid of the image
  double volume_ml = 0;
  double tissue_mean = 0;  // brightness at the seeds, after smoothing, in the image's unit
  double tissue_sd = 0;
  struct Doubt {
    GrowthDoubt kind;
    std::string sentence;  // what was seen and what to do, English
  };
  std::vector<Doubt> doubts;
  [[nodiscard]] bool probably_leaked() const;
};

// Grows from the seeds (patient LPS, mm) over connected tissue of the seeds' brightness, smoothed while edges are kept
// and with the slow drift of the scanner's sensitivity followed; cuts narrow bridges to the heart, stomach, kidney and
// muscle; closes vessels and tumours. Deterministic, whatever the number of threads.
//
// Fails with grow-no-seeds, grow-bad-image (empty or smaller than 3 voxels along an axis), grow-seed-outside (which
// seed, and how far), grow-seed-on-nothing (no finite value around it), grow-constant-image, grow-bad-options,
// grow-nothing-found, cancelled.
Result<GrowResult> grow_from_seeds(const imaging::Volume& image, const std::vector<Eigen::Vector3d>& seeds_mm,
                                   const GrowOptions& options = {}, const Progress& progress = {});

}  // namespace glisson::segmentation

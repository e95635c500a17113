#pragma once
// Vessels and lesions from points inside them: what stands out, brighter or darker, from the tissue around.

#include <Eigen/Core>
#include <optional>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "base/sentence.h"
#include "imaging/image.h"

namespace glisson::segmentation {

// How the structure is told from what it touches: a vessel by being thin, a lesion by being compact.
enum class Contrast { vessel, lesion };

// What a structure of that name is grown as; absent for organs ("liver", "kidney-left"), which grow_from_seeds() finds.
[[nodiscard]] std::optional<Contrast> contrast_of(std::string_view structure);

struct ContrastOptions {
  double sample_radius_mm = 3;   // around each seed its own brightness is learnt
  double smoothing_mm = 0.8;     // standard deviation of the Gaussian that noise is averaged with
  double widest_vessel_mm = 30;  // thicker parts are organs that the growth leaked into
  double reach_mm = 160;         // nothing farther from every seed is looked at
  double neck_share = 0.5;       // a lesion ends at necks thinner than this share of its own thickness
};

struct ContrastGrowth {
  imaging::Mask mask;  // on the grid of the image
  double volume_ml = 0;
  double brightness = 0;    // of the structure, in the image's unit
  double surroundings = 0;  // of the tissue around it
  std::vector<Sentence> doubts;
};

// Grows from the seeds (patient LPS, mm) over connected voxels that are nearer in brightness to the seeds than to the
// tissue around them. The border lies half-way, where partial volume puts it. The tissue around is the mode of the
// differing values that are nearest to the seeds' (half-sample mode, Robertson and Cryer 1974). A vessel loses parts
// thicker than a vessel is, and what only hangs on them; a lesion what hangs on it by a thin neck. With `within` (same
// grid: asserts) nothing outside of it is looked at. Deterministic.
//
// Fails with grow-no-seeds, grow-bad-image, grow-seed-outside or cancelled. Fails with grow-seed-on-nothing (no finite
// value at it, or not within) or grow-no-contrast (nothing around the seeds differs from them). Fails with
// grow-only-thick where a vessel's seed lies in something thicker than a vessel.
Result<ContrastGrowth> grow_contrast(const imaging::Volume& image, const std::vector<Eigen::Vector3d>& seeds_mm,
                                     Contrast kind, const imaging::Mask* within = nullptr,
                                     const ContrastOptions& options = {}, const Progress& progress = {});

}  // namespace glisson::segmentation

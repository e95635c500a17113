#pragma once
// The liver from a few points inside it, in MR or CT.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "base/sentence.h"
#include "imaging/image.h"

namespace glisson::segmentation {

struct GrowOptions {
  // Around each seed the tissue's brightness and its spread are learnt in a ball of this radius. It holds a few
  // hundred voxels of a clinical image, and vessels fill less than half of it.
  double sample_radius_mm = 9;

  // The image is judged at about this resolution: noise averages out, and the liver's outline is smooth on this scale.
  double working_spacing_mm = 2.5;
  double smoothing_mm = 3;  // standard deviation of the Gaussian in which a voxel's surroundings are judged

  // The surroundings' mean may be this many spreads (of single voxels) off the tissue's. Deviations are counted up to
  // twice that, so that the limit is crossed exactly where half of the surroundings is clearly something else.
  double tolerance_sd = 1.0;

  // The surroundings' mean absolute deviation, in spreads. Noise alone has 0.8; a mixture of brighter and darker
  // tissue (muscle between fat) has up to 2 although its mean may be the liver's.
  double roughness_sd = 1.5;

  // The expected brightness follows the tissue found so far over this length, as coils (MR) and beam hardening (CT)
  // make it drift. Other organs are smaller than this.
  double drift_length_mm = 30;

  // A bridge to another organ is cut where no ball of this radius fits. The liver itself is thicker but at its tips,
  // which are given back.
  double neck_radius_mm = 7;

  // Clefts and holes up to this radius count as vessels or tumours and belong to the liver.
  double closing_radius_mm = 6;
};

// Why the outcome may not be the liver.
enum class GrowthDoubt {
  cut_by_image,    // reaches the first or last slice: the organ is not wholly in the image
  leaves_image,    // reaches another face of the image: the growth has probably leaked
  too_large,       // more than a liver holds: probably leaked into a neighbour
  too_small,       // less than a liver holds, though the image does not cut it: probably stopped early
  seeds_disagree,  // seeds in tissue of different brightness: one is probably outside the liver
  seed_ignored,    // a seed with no tissue of its kind around it
  unsure_border    // much of the border lies on tissue that looks alike
};

struct GrowResult {
  imaging::Mask mask;  // on the grid of the image
  double volume_ml = 0;
  double tissue_mean = 0;    // brightness of the liver, in the image's unit
  double tissue_sd = 0;      // spread of single voxels about it, the drift taken off
  double unsure_border = 0;  // share of the border where what lies beyond looks much like the organ
  // The middles of the largest such places (patient LPS, mm), the largest first; at most three.
  std::vector<Eigen::Vector3d> unsure_places_mm;
  int rounds = 0;  // until the region stayed the same
  struct Doubt {
    GrowthDoubt kind;
    Sentence sentence;  // what was seen and what to do
  };
  std::vector<Doubt> doubts;
  [[nodiscard]] bool probably_leaked() const;  // leaves_image, too_large or seeds_disagree
};

// Grows from the seeds (patient LPS, mm) over connected tissue of the seeds' brightness. In rounds: a voxel is tissue
// when its surroundings are even and as bright as expected. An opening cuts narrow bridges to heart, stomach, kidney
// and muscle. What holds the seeds is kept, and from it the expected brightness and its drift are learnt anew. In the
// end vessels and tumours are closed and the outline is smoothed. Its border is put where both sides' brightness,
// learnt near by, divides best (outline_border.h). Where some of that border is unsure, wider tolerances are tried: the
// liver of a CT may be darker between the arms. They are taken if they come to a fifth more volume, and to nearly the
// same at still wider ones. They must come to a surer border too, and to no sign of a leak. Deterministic, whatever the
// number of threads.
//
// Fails with grow-no-seeds, grow-bad-options, grow-bad-image (an axis shorter than three voxels), grow-seed-outside
// (which, and how far), grow-seed-on-nothing (no finite value around it), grow-constant-image, grow-nothing-found,
// cancelled.
Result<GrowResult> grow_from_seeds(const imaging::Volume& image, const std::vector<Eigen::Vector3d>& seeds_mm,
                                   const GrowOptions& options = {}, const Progress& progress = {});

}  // namespace glisson::segmentation

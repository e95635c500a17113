#pragma once
// Non-rigid registration by optimal steps (Amberg, Romdhani, Vetter 2007). Each point of the source gets an affine map
// of its own, and a stiffness holds neighbours' maps alike. The stiffness is lowered step by step. For each
// nearest-point pairing one sparse solve finds the optimal maps exactly.

#include <Eigen/Core>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "geometry/surface.h"
#include "registration/rigid.h"

namespace glisson::registration {

// A point of the source whose place is known.
struct Landmark {
  int source_point = -1;
  Eigen::Vector3d target_mm{0, 0, 0};
};

struct NonrigidIcpOptions {
  // alpha of the paper, for a source scaled to a bounding sphere of about radius 1: from nearly rigid to as free as
  // noise allows.
  std::vector<double> stiffness{50, 20, 8, 3, 1.5, 0.7};
  int iterations_each = 8;         // with one stiffness, at most
  double smallest_step_mm = 0.02;  // root mean square over the points, below which the stiffness is lowered
  double largest_angle_deg = 60;   // between the normals of a pair; a wider one is no pair
  double farthest_pair_mm = 0;     // a longer one is no pair; 0: a tenth of the source's diagonal
  Overlap overlap = Overlap::by_area;
  int maximum_controls = 500;  // 2 cm apart on a liver; a solve takes hundredths of a second
  std::vector<Landmark> landmarks;
  double landmark_weight = 1;  // beta of the paper at first, for all landmarks together as for all points together;
                               // lowered with the stiffness, so that in the end the surface decides
};

struct NonrigidIcpResult {
  geometry::Surface surface;   // the source, moved; its points in their order
  double rms_mm = 0;           // of the pairs
  double paired_fraction = 0;  // of the points that looked for partners
  int iterations = 0;
  IcpStop stopped = IcpStop::not_run;
};

// From where the surfaces lie. Where the target is a part of the source, its points look for partners on the source,
// each of which they surely have. The rest of the source follows by stiffness. Otherwise the source's points look for
// partners on the target; one whose nearest point lies on the border of an open target has none. Failures: those of
// check_surface; "registration-no-pairs" (no point has a partner), "registration-singular". Fails with
// "landmark-unknown" where one names a point that is not there, or a place that is not finite.
Result<NonrigidIcpResult> nonrigid_icp(const geometry::Surface& source, const geometry::Surface& target,
                                       const NonrigidIcpOptions& options = {}, const Progress& progress = {});

}  // namespace glisson::registration

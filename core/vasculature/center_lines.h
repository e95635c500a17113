#pragma once
// From a vessel mask to its centre lines.
//
// Each connected piece gets a tree of paths that follow the middle of the vessel. They go from its thickest place to
// whatever is farthest and not yet covered (TEASAR: Sato et al. 2000, Pacific Graphics 281). A step costs its length
// over the square of the depth under the wall. Small bumps are covered by the path they stand on, so that noise makes
// no branches. Then gaps are bridged, and lines are joined where their vessels touch.
//
// Radii: the depth under the wall, and where the stretch is long enough that of a cylinder of the same volume.

#include "base/progress.h"
#include "base/result.h"
#include "imaging/image.h"
#include "vasculature/vessel_graph.h"

namespace glisson::vasculature {

struct CenterLineOptions {
  double minimum_branch_mm = 4;    // shorter side branches, beyond the wall of what they leave, are bumps
  double maximum_gap_mm = 8;       // between walls; bridged where the line goes on in about the same direction
  double minimum_piece_ml = 0.02;  // smaller pieces are noise
};

// Same mask, same graph, whatever the number of threads. Fails with vessels-empty, vessels-grid (axes not at right
// angles) and cancelled. Fails with vessels-one-blob where a piece is no vessel: as wide as long, and wider than 25 mm.
Result<VesselGraph> center_lines(const imaging::Mask& vessels, const CenterLineOptions& options = {},
                                 const Progress& progress = {});

}  // namespace glisson::vasculature

#pragma once
// From a segmented liver to tetrahedra: a watertight surface that follows the label boundary, and cells that conform to
// the structures inside.

#include <cstdint>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "geometry/surface.h"
#include "geometry/tetrahedra.h"
#include "imaging/image.h"
#include "meshing/label_pieces.h"

namespace glisson::meshing {

struct MeshOptions {
  // Reached within 15 %, or `notes` says why not: a structure inside needs some 100 cells to keep its shape. The edges
  // of 20,000 cells of a whole liver are about 9 mm. A factorisation of the elastic problem then takes seconds.
  int target_cells = 20000;

  // What the labels are called, for the notes.
  std::vector<LabelName> names = {};

  // Of the target, what inner structures may cost. They get finer cells, of about their own thickness. Those for which
  // that would cost more than this share (vessel trees, as a rule) get no cells of their own, the thinnest first.
  // `notes` says so. The liver itself must keep enough to bend.
  double inner_share = 0.5;
};

// What became of one label.
struct RegionVolume {
  std::uint16_t label = 0;
  double label_volume_ml = 0;  // of its voxels in the body, before anything was given to a neighbour
  double mesh_volume_ml = 0;   // of its cells; 0 where it got none
};

struct LiverMesh {
  geometry::TetMesh body;     // patient coordinates (LPS, mm); cell field "region": the label
  geometry::Surface surface;  // boundary_surface(body): watertight, manifold
  geometry::TetQuality quality;

  // Between the surface and the boundary of the labelled voxels (the faces between the body and the outside, steps and
  // all), both ways. Voxel faces are taken, not a smoothed surface. They are the label map's own boundary and need no
  // choice of ours. A perfect surface is still up to half a voxel's diagonal away from them.
  double hausdorff_mm = 0;
  double mean_distance_mm = 0;

  std::vector<RegionVolume> regions;  // by label
  std::vector<Sentence> notes;        // one sentence each: what was cut, left out, filled, or got no cells of its own
};

// All labels other than 0 together are the body, the largest of them the liver, the others structures inside.
//
// Failures: mesh-options, labels-empty, labels-grid, mesh-refinement (the mesh generator gave up), mesh-region-lost (an
// inner structure has less than half of its volume in cells), mesh-not-manifold, cancelled.
Result<LiverMesh> mesh_labels(const imaging::LabelMap& labels, const MeshOptions& options,
                              const Progress& progress = {});

}  // namespace glisson::meshing

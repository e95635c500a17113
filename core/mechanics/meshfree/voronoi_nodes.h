#pragma once
// Nodes for a meshfree engine: a centroidal Voronoi decomposition of a body of voxels.
//
// Every voxel belongs to the nearest node, and every node stands at the centroid of its voxels, nearly: Lloyd's
// iteration (S. Lloyd, Least squares quantization in PCM, 1982; Q. Du, V. Faber, M. Gunzburger, Centroidal Voronoi
// tessellations, SIAM Review 41, 1999), started from nodes spread evenly through the body. It minimises
//
//   energy = sum over voxels of voxel volume * |voxel centre - its node|^2        (mm^5)
//
// and lowers it in every round, so that nodes end up evenly spaced and their cells compact.

#include <cstdint>
#include <Eigen/Core>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "imaging/image.h"

namespace glisson::mechanics {

struct VoronoiOptions {
  int nodes = 1000;

  // Most of what there is to gain is gained in the first ten rounds; the energy then falls by less than a thousandth a
  // round.
  int maximum_rounds = 50;

  // Stops when a round lowers the energy by less than this share of it.
  double minimum_gain = 1e-3;
};

struct VoronoiNodes {
  std::vector<Eigen::Vector3d> positions_mm;  // patient coordinates (LPS): the centroids of the cells
  std::vector<double> volumes_mm3;            // of each node's cell; together the body's volume
  std::vector<std::int32_t> node_of_voxel;    // for each voxel of the mask's grid; -1 outside the body
  std::vector<double> energies_mm5;           // after each round, falling
  enum class Stopped { settled, rounds_spent } stopped = Stopped::settled;
};

// The body is the mask's voxels other than 0. There are never fewer voxels than nodes, and no cell is empty. The same
// mask gives the same nodes, whatever the number of threads.
// Failures: voronoi-options, mask-empty, voronoi-too-many-nodes (more than there are voxels), cancelled.
Result<VoronoiNodes> voronoi_nodes(const imaging::Mask& body, const VoronoiOptions& options,
                                   const Progress& progress = {});

}  // namespace glisson::mechanics

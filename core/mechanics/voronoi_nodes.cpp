#include "mechanics/voronoi_nodes.h"

#include <algorithm>
#include <numeric>
#include <random>

#include "base/parallel.h"
#include "geometry/nearest.h"

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;

// The body as a list of its voxels.
struct Voxels {
  std::vector<std::size_t> offsets;
  std::vector<Vector3d> centers_mm;
  double volume_mm3 = 0;  // of one
};
Voxels voxels_of(const imaging::Mask& body);

// One voxel from each of as many equal stretches of a space-filling order as there are nodes.
std::vector<Vector3d> spread_evenly(const Voxels& voxels, int nodes);

// Of every voxel, the nearest node and how far it is.
struct Assignment {
  std::vector<std::int32_t> node_of;
  std::vector<double> squared_distance_mm2;
};
Assignment assign(const Voxels& voxels, const std::vector<Vector3d>& nodes_mm);
double energy_mm5(const Voxels& voxels, const Assignment& assignment);
std::vector<int> voxels_of_nodes(const Assignment& assignment, std::size_t nodes);

// The centroids of the cells. A node without voxels moves onto the voxel that is farthest from its own node.
std::vector<Vector3d> centroids(const Voxels& voxels, const Assignment& assignment, std::size_t nodes);

}  // namespace

Result<VoronoiNodes> voronoi_nodes(const imaging::Mask& body, const VoronoiOptions& options, const Progress& progress) {
  if (options.nodes < 1 || options.most_rounds < 1 || !(options.least_gain >= 0)) {
    return failure("voronoi-options", GLISSON_TEXT("{0} nodes in {1} rounds cannot be made; both must be at least 1."),
                   {std::to_string(options.nodes), std::to_string(options.most_rounds)});
  }
  const Voxels voxels = voxels_of(body);
  if (voxels.offsets.empty()) return failure("mask-empty", GLISSON_TEXT("The body holds no voxels."));
  if (voxels.offsets.size() < static_cast<std::size_t>(options.nodes)) {
    return failure("voronoi-too-many-nodes", GLISSON_TEXT("{0} nodes are more than the body has voxels ({1})."),
                   {std::to_string(options.nodes), std::to_string(voxels.offsets.size())});
  }

  VoronoiNodes result;
  const auto nodes = static_cast<std::size_t>(options.nodes);
  result.positions_mm = spread_evenly(voxels, options.nodes);
  Assignment assignment = assign(voxels, result.positions_mm);
  std::vector<int> counts = voxels_of_nodes(assignment, nodes);
  result.energies_mm5.push_back(energy_mm5(voxels, assignment));
  for (int round = 0;; ++round) {
    if (progress.cancelled()) return cancelled();
    progress.report(std::min(1.0, static_cast<double>(round) / options.most_rounds),
                    GLISSON_TEXT("Spreading the nodes"));
    result.positions_mm = centroids(voxels, assignment, nodes);
    assignment = assign(voxels, result.positions_mm);
    counts = voxels_of_nodes(assignment, nodes);
    const double before = result.energies_mm5.back();
    result.energies_mm5.push_back(energy_mm5(voxels, assignment));

    if (std::find(counts.begin(), counts.end(), 0) != counts.end()) continue;
    const bool settled = before - result.energies_mm5.back() <= options.least_gain * before;
    result.stopped = settled ? VoronoiNodes::Stopped::settled : VoronoiNodes::Stopped::rounds_spent;
    if (settled || round + 1 >= options.most_rounds) break;
  }

  result.positions_mm = centroids(voxels, assignment, nodes);
  for (const int count : counts) result.volumes_mm3.push_back(count * voxels.volume_mm3);
  result.node_of_voxel.assign(body.values.size(), -1);
  for (std::size_t i = 0; i < voxels.offsets.size(); ++i) {
    result.node_of_voxel[voxels.offsets[i]] = assignment.node_of[i];
  }
  return result;
}

namespace {

Voxels voxels_of(const imaging::Mask& body) {
  Voxels voxels;
  voxels.volume_mm3 = body.grid.voxel_volume_mm3();
  std::size_t offset = 0;
  for (int k = 0; k < body.grid.size[2]; ++k) {
    for (int j = 0; j < body.grid.size[1]; ++j) {
      for (int i = 0; i < body.grid.size[0]; ++i, ++offset) {
        if (body.values[offset] == 0) continue;
        voxels.offsets.push_back(offset);
        voxels.centers_mm.push_back(body.grid.position_mm(i, j, k));
      }
    }
  }
  return voxels;
}

// The bits of three coordinates of a unit cube, interleaved: neighbours in this order are mostly neighbours in space
// (Morton's order).
std::uint64_t morton_number(const Vector3d& in_unit_cube) {
  constexpr int bits = 16;
  std::uint64_t number = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double scaled = std::clamp(in_unit_cube[axis], 0.0, 1.0) * ((1 << bits) - 1);
    const auto coordinate = static_cast<std::uint64_t>(scaled);
    for (int bit = 0; bit < bits; ++bit) number |= (coordinate >> bit & 1U) << (3 * bit + axis);
  }
  return number;
}

std::vector<Vector3d> spread_evenly(const Voxels& voxels, int nodes) {
  Vector3d lowest = voxels.centers_mm.front();
  Vector3d highest = lowest;
  for (const Vector3d& center : voxels.centers_mm) {
    lowest = lowest.cwiseMin(center);
    highest = highest.cwiseMax(center);
  }
  const double side_mm = std::max((highest - lowest).maxCoeff(), 1e-9);
  std::vector<std::pair<std::uint64_t, std::size_t>> order;
  order.reserve(voxels.centers_mm.size());
  for (std::size_t i = 0; i < voxels.centers_mm.size(); ++i) {
    order.emplace_back(morton_number((voxels.centers_mm[i] - lowest) / side_mm), i);
  }
  std::sort(order.begin(), order.end());

  std::mt19937 random(20111);  // any fixed seed; within its stretch each voxel is as good as another
  std::vector<Vector3d> positions_mm;
  const double stretch = static_cast<double>(order.size()) / nodes;
  for (int node = 0; node < nodes; ++node) {
    const auto first = static_cast<std::size_t>(node * stretch);
    const auto length = std::max<std::size_t>(static_cast<std::size_t>((node + 1) * stretch) - first, 1);
    positions_mm.push_back(voxels.centers_mm[order[first + random() % length].second]);
  }
  return positions_mm;
}

Assignment assign(const Voxels& voxels, const std::vector<Vector3d>& nodes_mm) {
  const geometry::NearestPoint nodes(nodes_mm);
  Assignment assignment;
  assignment.node_of.resize(voxels.centers_mm.size());
  assignment.squared_distance_mm2.resize(voxels.centers_mm.size());
  parallel_for(voxels.centers_mm.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto found = nodes.nearest(voxels.centers_mm[i]);
      assignment.node_of[i] = found.point;
      assignment.squared_distance_mm2[i] = found.squared_distance_mm2;
    }
  });
  return assignment;
}

double energy_mm5(const Voxels& voxels, const Assignment& assignment) {
  const auto& distances = assignment.squared_distance_mm2;
  return voxels.volume_mm3 * std::accumulate(distances.begin(), distances.end(), 0.0);
}

std::vector<int> voxels_of_nodes(const Assignment& assignment, std::size_t nodes) {
  std::vector<int> counts(nodes, 0);
  for (const std::int32_t node : assignment.node_of) ++counts[static_cast<std::size_t>(node)];
  return counts;
}

std::vector<Vector3d> centroids(const Voxels& voxels, const Assignment& assignment, std::size_t nodes) {
  const std::vector<int> counts = voxels_of_nodes(assignment, nodes);
  std::vector<Vector3d> positions_mm(nodes, Vector3d::Zero());
  for (std::size_t i = 0; i < assignment.node_of.size(); ++i) {
    positions_mm[static_cast<std::size_t>(assignment.node_of[i])] += voxels.centers_mm[i];
  }
  std::vector<double> distances = assignment.squared_distance_mm2;
  for (std::size_t node = 0; node < nodes; ++node) {
    if (counts[node] > 0) {
      positions_mm[node] /= counts[node];
      continue;
    }
    const auto farthest = std::max_element(distances.begin(), distances.end());
    positions_mm[node] = voxels.centers_mm[static_cast<std::size_t>(farthest - distances.begin())];
    *farthest = 0;
  }
  return positions_mm;
}

}  // namespace
}  // namespace glisson::mechanics

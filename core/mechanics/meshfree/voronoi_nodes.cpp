#include "mechanics/meshfree/voronoi_nodes.h"

#include <algorithm>
#include <cmath>
#include <Eigen/LU>
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
  imaging::Grid grid;
};

// Space cut into blocks of voxels, about as large as a node's share, and the nodes in each. What is nearest to a voxel
// is mostly found among the few dozen nodes of its own block and those around it, sooner than in a tree.
class VoronoiBlocks {
 public:
  VoronoiBlocks(const Voxels& voxels, std::size_t nodes);

  // For each block in turn, its voxels, by their place in the list.
  [[nodiscard]] const std::vector<std::vector<std::int32_t>>& voxels() const { return voxels_; }
  void sort_in(const std::vector<Vector3d>& nodes_mm);
  // The nodes of a block and of those that touch it. Any other node is farther than `reach_mm` from each of its voxels.
  void nodes_around(std::size_t block, std::vector<std::int32_t>& nodes) const;
  [[nodiscard]] double reach_mm() const { return reach_mm_; }

 private:
  [[nodiscard]] std::size_t block_of(const Vector3d& place_mm) const;

  const imaging::Grid* grid_;
  int edge_;  // in voxels
  std::array<int, 3> size_;
  double reach_mm_;
  std::vector<std::vector<std::int32_t>> voxels_, nodes_;
};
Voxels voxels_of(const imaging::Mask& body);

// One voxel from each of as many equal stretches of a space-filling order as there are nodes.
std::vector<Vector3d> spread_evenly(const Voxels& voxels, int nodes);

// Of every voxel, the nearest node and how far it is.
struct Assignment {
  std::vector<std::int32_t> node_of;
  std::vector<double> squared_distance_mm2;
};
Assignment assign(const Voxels& voxels, VoronoiBlocks& blocks, const std::vector<Vector3d>& nodes_mm);
double energy_mm5(const Voxels& voxels, const Assignment& assignment);
std::vector<int> voxels_of_nodes(const Assignment& assignment, std::size_t nodes);

// The centroids of the cells. A node without voxels moves onto the voxel that is farthest from its own node.
std::vector<Vector3d> centroids(const Voxels& voxels, const Assignment& assignment, std::size_t nodes);

}  // namespace

Result<VoronoiNodes> voronoi_nodes(const imaging::Mask& body, const VoronoiOptions& options, const Progress& progress) {
  if (options.nodes < 1 || options.maximum_rounds < 1 || !(options.minimum_gain >= 0)) {
    return failure("voronoi-options", GLISSON_TEXT("{0} nodes in {1} rounds cannot be made; both must be at least 1."),
                   {std::to_string(options.nodes), std::to_string(options.maximum_rounds)});
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
  VoronoiBlocks blocks(voxels, nodes);
  Assignment assignment = assign(voxels, blocks, result.positions_mm);
  std::vector<int> counts = voxels_of_nodes(assignment, nodes);
  result.energies_mm5.push_back(energy_mm5(voxels, assignment));
  for (int round = 0;; ++round) {
    if (progress.cancelled()) return cancelled();
    progress.report(std::min(1.0, static_cast<double>(round) / options.maximum_rounds),
                    GLISSON_TEXT("Spreading the nodes"));
    result.positions_mm = centroids(voxels, assignment, nodes);
    assignment = assign(voxels, blocks, result.positions_mm);
    counts = voxels_of_nodes(assignment, nodes);
    const double before = result.energies_mm5.back();
    result.energies_mm5.push_back(energy_mm5(voxels, assignment));

    if (std::find(counts.begin(), counts.end(), 0) != counts.end()) continue;
    const bool settled = before - result.energies_mm5.back() <= options.minimum_gain * before;
    result.stopped = settled ? VoronoiNodes::Stopped::settled : VoronoiNodes::Stopped::rounds_spent;
    if (settled || round + 1 >= options.maximum_rounds) break;
  }

  result.positions_mm = centroids(voxels, assignment, nodes);
  for (const int count : counts) result.volumes_mm3.push_back(count * voxels.grid.voxel_volume_mm3());
  result.node_of_voxel.assign(body.values.size(), -1);
  for (std::size_t i = 0; i < voxels.offsets.size(); ++i) {
    result.node_of_voxel[voxels.offsets[i]] = assignment.node_of[i];
  }
  return result;
}

namespace {

Voxels voxels_of(const imaging::Mask& body) {
  Voxels voxels;
  voxels.grid = body.grid;
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

VoronoiBlocks::VoronoiBlocks(const Voxels& voxels, std::size_t nodes)
    : grid_(&voxels.grid),
      edge_(std::max(1, static_cast<int>(std::lround(std::cbrt(double(voxels.offsets.size()) / double(nodes)))))) {
  for (int axis = 0; axis < 3; ++axis) {
    size_[static_cast<std::size_t>(axis)] = (grid_->size[static_cast<std::size_t>(axis)] + edge_ - 1) / edge_;
  }
  voxels_.resize(static_cast<std::size_t>(size_[0]) * static_cast<std::size_t>(size_[1]) *
                 static_cast<std::size_t>(size_[2]));
  for (std::size_t v = 0; v < voxels.offsets.size(); ++v) {
    voxels_[block_of(voxels.centers_mm[v])].push_back(static_cast<std::int32_t>(v));
  }
  // How far apart planes of equal index are.
  const Eigen::Matrix3d to_index = (grid_->direction * grid_->spacing_mm.asDiagonal()).inverse();
  reach_mm_ = edge_ / to_index.rowwise().norm().maxCoeff();
}

void VoronoiBlocks::sort_in(const std::vector<Vector3d>& nodes_mm) {
  nodes_.assign(voxels_.size(), {});
  for (std::size_t node = 0; node < nodes_mm.size(); ++node) {
    nodes_[block_of(nodes_mm[node])].push_back(static_cast<std::int32_t>(node));
  }
}

// A centroid may lie outside the grid by rounding alone: the nearest block.
std::size_t VoronoiBlocks::block_of(const Vector3d& place_mm) const {
  const Vector3d index = grid_->index_of(place_mm);
  std::array<std::size_t, 3> at{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto voxel = std::clamp(std::lround(index[static_cast<Eigen::Index>(axis)]), 0L, long{grid_->size[axis]} - 1);
    at[axis] = static_cast<std::size_t>(voxel / edge_);
  }
  return at[0] + static_cast<std::size_t>(size_[0]) * (at[1] + static_cast<std::size_t>(size_[1]) * at[2]);
}

void VoronoiBlocks::nodes_around(std::size_t block, std::vector<std::int32_t>& nodes) const {
  nodes.clear();
  const auto row = static_cast<std::size_t>(size_[0]), slice = row * static_cast<std::size_t>(size_[1]);
  const int i = static_cast<int>(block % row), j = static_cast<int>(block % slice / row),
            k = static_cast<int>(block / slice);
  for (int z = std::max(0, k - 1); z <= std::min(size_[2] - 1, k + 1); ++z) {
    for (int y = std::max(0, j - 1); y <= std::min(size_[1] - 1, j + 1); ++y) {
      for (int x = std::max(0, i - 1); x <= std::min(size_[0] - 1, i + 1); ++x) {
        const auto& there = nodes_[static_cast<std::size_t>(x) + row * static_cast<std::size_t>(y) +
                                   slice * static_cast<std::size_t>(z)];
        nodes.insert(nodes.end(), there.begin(), there.end());
      }
    }
  }
  std::sort(nodes.begin(), nodes.end());  // of two that are as near, the first
}

Assignment assign(const Voxels& voxels, VoronoiBlocks& blocks, const std::vector<Vector3d>& nodes_mm) {
  const geometry::NearestPoint tree(nodes_mm);
  blocks.sort_in(nodes_mm);
  Assignment assignment;
  assignment.node_of.resize(voxels.centers_mm.size());
  assignment.squared_distance_mm2.resize(voxels.centers_mm.size());
  parallel_for(blocks.voxels().size(), 64, [&](std::size_t begin, std::size_t end) {
    std::vector<std::int32_t> near;
    Eigen::ArrayXd x, y, z, squared;
    for (std::size_t block = begin; block < end; ++block) {
      if (blocks.voxels()[block].empty()) continue;
      blocks.nodes_around(block, near);
      const auto count = static_cast<Eigen::Index>(near.size());
      x.resize(count);
      y.resize(count);
      z.resize(count);
      for (Eigen::Index n = 0; n < count; ++n) {
        const Vector3d& at = nodes_mm[static_cast<std::size_t>(near[static_cast<std::size_t>(n)])];
        x[n] = at.x();
        y[n] = at.y();
        z[n] = at.z();
      }
      for (const std::int32_t v : blocks.voxels()[block]) {
        const Vector3d& center = voxels.centers_mm[static_cast<std::size_t>(v)];
        Eigen::Index best = -1;
        if (count > 0) {
          squared = (x - center.x()).square() + (y - center.y()).square() + (z - center.z()).square();
          squared.minCoeff(&best);
        }
        auto& node = assignment.node_of[static_cast<std::size_t>(v)];
        auto& distance = assignment.squared_distance_mm2[static_cast<std::size_t>(v)];
        if (best >= 0 && squared[best] <= blocks.reach_mm() * blocks.reach_mm()) {
          node = near[static_cast<std::size_t>(best)];
          distance = squared[best];
        } else {
          const auto found = tree.nearest(center);
          node = found.point;
          distance = found.squared_distance_mm2;
        }
      }
    }
  });
  return assignment;
}

double energy_mm5(const Voxels& voxels, const Assignment& assignment) {
  const auto& distances = assignment.squared_distance_mm2;
  return voxels.grid.voxel_volume_mm3() * std::accumulate(distances.begin(), distances.end(), 0.0);
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

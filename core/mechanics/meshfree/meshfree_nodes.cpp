#include "mechanics/meshfree/meshfree_nodes.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "geometry/nearest.h"
#include "mechanics/meshfree/compliance_distance.h"
#include "mechanics/meshfree/voronoi_nodes.h"

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;

double psi(double t) { return std::max(0.0, 1.0 - t); }

Result<void> check(const MeshfreeOptions& options);
int nodes_for(const geometry::TetMesh& mesh, const MeshfreeOptions& options);

// Adds a node to every part of the body from which no node can be reached. A part smaller than a tenth of a node's
// share, such as a voxel that touches the others by an edge alone, gets none: its points lean on the voxels around.
ComplianceDistance::Voronoi reach_everywhere(const ComplianceDistance& distance, double voxels_per_node,
                                             std::vector<Vector3d>& nodes_mm);
std::vector<Vector3d> beside_their_cells(const geometry::TetMesh& mesh);

// What one node does: psi at the mesh points that it reaches.
struct Influence {
  std::vector<int> points;
  std::vector<double> psi;
};
std::vector<Influence> influences(const geometry::TetMesh& mesh, const ComplianceDistance& distance,
                                  const ComplianceDistance::Voronoi& voronoi, const std::vector<Vector3d>& nodes_mm,
                                  double overlap);
void set_weights(const geometry::TetMesh& mesh, const std::vector<Influence>& influences, ShapeFunctions& shape);

}  // namespace

Result<ShapeFunctions> shape_functions_of(const geometry::TetMesh& mesh, const std::vector<double>& youngs_kPa,
                                          const MeshfreeOptions& options, const std::vector<Cut>& cuts,
                                          const Progress& progress) {
  if (auto checked = check(options); !checked) return failure(std::move(checked.error()));
  const int wanted = nodes_for(mesh, options);
  const double spacing_mm = std::cbrt(geometry::volume_mm3(mesh) / (wanted * options.voxels_per_node));
  const geometry::Box box = geometry::bounding_box(mesh.points_mm);
  if ((box.max_mm - box.min_mm).prod() / std::pow(spacing_mm, 3) > 5e8) {
    return failure("meshfree-options", GLISSON_TEXT("{0} nodes in this body need more than 5e8 voxels: take fewer."),
                   {std::to_string(wanted)});
  }
  progress.report(0.0, GLISSON_TEXT("Spreading the nodes"));
  const VoxelBody voxels = voxelise(mesh, youngs_kPa, spacing_mm);
  auto decomposition = voronoi_nodes(voxels.body, {.nodes = wanted}, progress.part(0.0, 0.3));
  if (!decomposition) return failure(std::move(decomposition.error()));

  ShapeFunctions shape;
  shape.nodes_mm = std::move(decomposition->positions_mm);
  const ComplianceDistance distance(voxels, cuts);
  for (Vector3d& node_mm : shape.nodes_mm) {  // a centroid may lie outside a bent body: its nearest place inside serves
    if (distance.inside(distance.voxel_at(node_mm))) continue;
    std::size_t nearest = 0;
    double nearest_mm = std::numeric_limits<double>::infinity();
    for (std::size_t voxel = 0; voxel < voxels.body.values.size(); ++voxel) {
      if (!distance.inside(voxel)) continue;
      const double away_mm = (distance.center_mm(voxel) - node_mm).norm();
      if (away_mm < nearest_mm) {
        nearest_mm = away_mm;
        nearest = voxel;
      }
    }
    node_mm = distance.center_mm(nearest);
  }
  if (progress.cancelled()) return cancelled();
  progress.report(0.3, GLISSON_TEXT("Measuring how the material sees the body"));
  const ComplianceDistance::Voronoi voronoi = reach_everywhere(distance, options.voxels_per_node, shape.nodes_mm);
  shape.node_volumes_mm3.assign(shape.nodes_mm.size(), 0.0);
  for (const int owner : voronoi.owner) {
    if (owner >= 0) shape.node_volumes_mm3[static_cast<std::size_t>(owner)] += std::pow(spacing_mm, 3);
  }
  for (const Vector3d& node_mm : shape.nodes_mm) {
    shape.node_youngs_kPa.push_back(voxels.youngs_kPa[distance.voxel_at(node_mm)]);
  }
  set_weights(mesh, influences(mesh, distance, voronoi, shape.nodes_mm, options.overlap), shape);
  return shape;
}

std::vector<double> youngs_of_nodes_kPa(const geometry::TetMesh& mesh, const ShapeFunctions& shape) {
  std::vector<double> youngs_kPa(mesh.cells.size(), 0.0);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    for (const int point : mesh.cells[c]) {
      for (std::size_t k = shape.starts[point]; k < shape.starts[point + 1]; ++k) {
        youngs_kPa[c] += 0.25 * shape.weights[k] * shape.node_youngs_kPa[shape.nodes[k]];
      }
    }
  }
  return youngs_kPa;
}

namespace {

Result<void> check(const MeshfreeOptions& options) {
  if (options.nodes < 0 || !(options.voxels_per_node >= 1) || !(options.overlap > 1) ||
      !std::isfinite(options.voxels_per_node * options.overlap)) {
    return failure("meshfree-options",
                   GLISSON_TEXT("{0} nodes, {1} voxels a node and an overlap of {2} cannot be: the last two must be at "
                                "least 1 and above 1."),
                   {std::to_string(options.nodes), fmt::format("{}", options.voxels_per_node),
                    fmt::format("{}", options.overlap)});
  }
  return {};
}

int nodes_for(const geometry::TetMesh& mesh, const MeshfreeOptions& options) {
  if (options.nodes > 0) return options.nodes;
  return std::max(4, static_cast<int>(mesh.points_mm.size() / 12));
}

ComplianceDistance::Voronoi reach_everywhere(const ComplianceDistance& distance, double voxels_per_node,
                                             std::vector<Vector3d>& nodes_mm) {
  ComplianceDistance::Voronoi voronoi = distance.voronoi(nodes_mm);
  std::vector<std::uint8_t> seen(voronoi.owner.size(), 0);
  const std::size_t nodes_before = nodes_mm.size();
  for (std::size_t voxel = 0; voxel < voronoi.owner.size(); ++voxel) {
    if (!distance.inside(voxel) || voronoi.owner[voxel] >= 0 || seen[voxel]) continue;
    ComplianceDistance::Workspace workspace(voronoi.owner.size());
    const auto part = distance.within(distance.center_mm(voxel), ComplianceDistance::unreached, workspace);
    for (const auto& reached : part) seen[reached.voxel] = 1;
    if (static_cast<double>(part.size()) < 0.1 * voxels_per_node) continue;
    // The middle of the part: its voxel nearest to its centroid.
    Vector3d centroid_mm = Vector3d::Zero();
    for (const auto& reached : part) centroid_mm += distance.center_mm(reached.voxel) / double(part.size());
    const auto away = [&](const auto& reached) {
      return (distance.center_mm(reached.voxel) - centroid_mm).squaredNorm();
    };
    const auto middle =
        std::min_element(part.begin(), part.end(), [&](const auto& a, const auto& b) { return away(a) < away(b); });
    nodes_mm.push_back(distance.center_mm(middle->voxel));
  }
  return nodes_mm.size() == nodes_before ? voronoi : distance.voronoi(nodes_mm);
}

// Each point, moved half the way into the cells that use it, the slivers beside a cut left out of account by their
// volume: what it sees on its own side of a cut, though the cut be bent.
std::vector<Vector3d> beside_their_cells(const geometry::TetMesh& mesh) {
  std::vector<Vector3d> sums(mesh.points_mm.size(), Vector3d::Zero());
  std::vector<double> volumes_mm3(mesh.points_mm.size(), 0.0);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const double volume_mm3 = geometry::cell_volume_mm3(mesh, c);
    for (const int point : mesh.cells[c]) {
      sums[point] += volume_mm3 * geometry::cell_centroid_mm(mesh, c);
      volumes_mm3[point] += volume_mm3;
    }
  }
  for (std::size_t p = 0; p < sums.size(); ++p) {
    sums[p] =
        volumes_mm3[p] > 0 ? (0.5 * mesh.points_mm[p] + 0.5 * sums[p] / volumes_mm3[p]).eval() : mesh.points_mm[p];
  }
  return sums;
}

// r_i of the header. A node that has no neighbour reaches its whole part.
std::vector<float> radii(const ComplianceDistance& distance, const ComplianceDistance::Voronoi& voronoi,
                         const std::vector<Vector3d>& nodes_mm, double overlap) {
  std::vector<float> to_frontier(nodes_mm.size(), 0.0F), farthest(nodes_mm.size(), 0.0F);
  for (std::size_t voxel = 0; voxel < voronoi.owner.size(); ++voxel) {
    if (voronoi.owner[voxel] < 0) continue;
    const auto node = static_cast<std::size_t>(voronoi.owner[voxel]);
    const float here = voronoi.distance[voxel];
    farthest[node] = std::max(farthest[node], here);
    for (const std::size_t next : distance.beside(voxel)) {
      if (voronoi.owner[next] == voronoi.owner[voxel]) continue;
      to_frontier[node] = std::max(to_frontier[node], 0.5F * (here + voronoi.distance[next]));
    }
  }
  std::vector<float> radius(nodes_mm.size());
  for (std::size_t n = 0; n < radius.size(); ++n) {
    // A cell of one voxel has no extent of its own but the voxel's.
    const Vector3d edge_mm(distance.grid().spacing_mm.x(), 0, 0);
    const std::size_t home = distance.voxel_at(nodes_mm[n]);
    const float voxel = distance.step(distance.center_mm(home) + edge_mm, distance.center_mm(home), home);
    radius[n] = std::max({static_cast<float>(overlap) * to_frontier[n], 1.05F * farthest[n], voxel});
  }
  return radius;
}

std::vector<Influence> influences(const geometry::TetMesh& mesh, const ComplianceDistance& distance,
                                  const ComplianceDistance::Voronoi& voronoi, const std::vector<Vector3d>& nodes_mm,
                                  double overlap) {
  const std::vector<float> radius = radii(distance, voronoi, nodes_mm, overlap);

  // The points that lean on each voxel, and how far they are from its centre.
  struct Leaning {
    int point;
    float step;
  };
  std::vector<std::vector<Leaning>> leaning(distance.grid().voxels());
  const std::vector<Vector3d> seen_from_mm = beside_their_cells(mesh);
  for (std::size_t p = 0; p < mesh.points_mm.size(); ++p) {
    for (const std::size_t voxel : distance.around(distance.voxel_at(mesh.points_mm[p]))) {
      const float step = distance.step(mesh.points_mm[p], seen_from_mm[p], voxel);
      if (step < ComplianceDistance::unreached) leaning[voxel].push_back({static_cast<int>(p), step});
    }
  }

  std::vector<Influence> all(nodes_mm.size());
  // A workspace is as large as the grid: one for a good many nodes.
  const std::size_t at_once = std::max<std::size_t>(16, nodes_mm.size() / 16);
  parallel_for(nodes_mm.size(), at_once, [&](std::size_t begin, std::size_t end) {
    ComplianceDistance::Workspace workspace(distance.grid().voxels());
    std::vector<std::pair<int, float>> found;
    for (std::size_t n = begin; n < end; ++n) {
      found.clear();
      for (const auto& [voxel, away] : distance.within(nodes_mm[n], radius[n], workspace)) {
        for (const Leaning& there : leaning[voxel]) found.emplace_back(there.point, away + there.step);
      }
      std::sort(found.begin(), found.end());
      for (std::size_t k = 0; k < found.size(); ++k) {
        if (k > 0 && found[k].first == found[k - 1].first) continue;  // the shortest comes first
        const double value = psi(found[k].second / radius[n]);
        if (value <= 0) continue;
        all[n].points.push_back(found[k].first);
        all[n].psi.push_back(value);
      }
    }
  });
  return all;
}

void set_weights(const geometry::TetMesh& mesh, const std::vector<Influence>& influences, ShapeFunctions& shape) {
  const std::size_t points = mesh.points_mm.size();
  std::vector<double> sums(points, 0.0);
  std::vector<std::size_t> counts(points, 0);
  for (const Influence& node : influences) {
    for (std::size_t k = 0; k < node.points.size(); ++k) {
      sums[node.points[k]] += node.psi[k];
      ++counts[node.points[k]];
    }
  }
  // A point in a corner of the mesh too thin for the voxels follows the nearest node.
  const geometry::NearestPoint nodes(shape.nodes_mm);
  shape.starts.assign(points + 1, 0);
  for (std::size_t p = 0; p < points; ++p) shape.starts[p + 1] = shape.starts[p] + std::max<std::size_t>(counts[p], 1);
  shape.nodes.assign(shape.starts.back(), -1);
  shape.weights.assign(shape.starts.back(), 1.0);
  std::vector<std::size_t> next(shape.starts.begin(), shape.starts.end() - 1);
  for (std::size_t n = 0; n < influences.size(); ++n) {
    for (std::size_t k = 0; k < influences[n].points.size(); ++k) {
      const int p = influences[n].points[k];
      shape.nodes[next[p]] = static_cast<int>(n);
      shape.weights[next[p]++] = influences[n].psi[k] / sums[p];
    }
  }
  for (std::size_t p = 0; p < points; ++p) {
    if (counts[p] == 0) shape.nodes[shape.starts[p]] = nodes.nearest(mesh.points_mm[p]).point;
  }
}

}  // namespace
}  // namespace glisson::mechanics

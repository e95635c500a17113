#include "vasculature/center_lines.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <queue>

#include "vasculature/internal/bridges.h"
#include "vasculature/internal/vessel_voxels.h"

namespace glisson::vasculature {
namespace {

using Eigen::Vector3d;
using imaging::Mask;

constexpr float unreached = std::numeric_limits<float>::infinity();

// Which voxels lie on a centre line: those on the paths from whatever is far and not covered.
std::vector<char> on_lines(const Voxels& voxels, const Paths& paths, const CenterLineOptions& options,
                           const std::vector<int>& pieces);

struct Lines {
  VesselGraph graph;
  std::vector<std::vector<int>> voxels_of;  // of each branch, from its `from` to its `to`
};
Lines lines_of(const Voxels& voxels, const Paths& paths, const std::vector<char>& chosen);

// The line point (branch, point) nearest to each voxel through the mask.
struct Nearest {
  std::vector<int> branch, point;
};
Nearest nearest_lines(const Voxels& voxels, const Lines& lines);

void set_radii(const Voxels& voxels, const Nearest& nearest, VesselGraph& graph);
void smooth(VesselGraph& graph);
void add_contacts(const Voxels& voxels, const Nearest& nearest, const Paths& paths, const Lines& lines,
                  VesselGraph& graph);

Result<void> check(const Mask& vessels);
Result<void> check_not_a_blob(const Voxels& voxels, const Paths& paths, const std::vector<int>& pieces);

}  // namespace

Result<VesselGraph> center_lines(const Mask& vessels, const CenterLineOptions& options, const Progress& progress) {
  if (auto checked = check(vessels); !checked) return failure(std::move(checked.error()));
  progress.report(0, GLISSON_TEXT("measuring the depth of the vessels"));
  const Voxels voxels(cropped(vessels));
  if (progress.cancelled()) return cancelled();

  progress.report(0.3, GLISSON_TEXT("following the vessels"));
  const Paths paths = paths_along_the_middle(voxels);
  std::vector<int> pieces;
  const double voxel_ml = voxels.grid().voxel_volume_mm3() / 1000;
  for (std::size_t p = 0; p < paths.pieces.size(); ++p) {
    if (static_cast<double>(paths.pieces[p].size()) * voxel_ml >= options.minimum_piece_ml) {
      pieces.push_back(static_cast<int>(p));
    }
  }
  if (pieces.empty() && !paths.pieces.empty()) pieces.push_back(0);
  if (auto checked = check_not_a_blob(voxels, paths, pieces); !checked) return failure(std::move(checked.error()));
  const Lines lines = lines_of(voxels, paths, on_lines(voxels, paths, options, pieces));
  if (progress.cancelled()) return cancelled();

  progress.report(0.7, GLISSON_TEXT("measuring the vessels"));
  VesselGraph graph = lines.graph;
  const Nearest nearest = nearest_lines(voxels, lines);
  set_radii(voxels, nearest, graph);
  smooth(graph);
  add_contacts(voxels, nearest, paths, lines, graph);
  add_bridges(graph, options.maximum_gap_mm);
  progress.report(1, GLISSON_TEXT("done"));
  return graph;
}

namespace {

Result<void> check(const Mask& vessels) {
  const Eigen::Matrix3d& d = vessels.grid.direction;
  if (!(d.transpose() * d).isIdentity(1e-3)) {
    return failure("vessels-grid", GLISSON_TEXT("The axes of the vessel mask are not at right angles: resample it."));
  }
  if (std::none_of(vessels.values.begin(), vessels.values.end(), [](std::uint8_t v) { return v != 0; })) {
    return failure("vessels-empty",
                   GLISSON_TEXT("The vessel mask holds no voxels: mark vessels first, or import another mask."));
  }
  return {};
}

Result<void> check_not_a_blob(const Voxels& voxels, const Paths& paths, const std::vector<int>& pieces) {
  for (const int p : pieces) {
    const std::vector<int>& piece = paths.pieces[static_cast<std::size_t>(p)];
    double depth = 0, length = 0;
    for (const int v : piece) {
      depth = std::max(depth, voxels.depth_mm(v));
      length = std::max<double>(length, paths.length_mm[static_cast<std::size_t>(v)]);
    }
    if (depth > 12.5 && length < 4 * depth) {
      return failure(
          "vessels-one-blob",
          GLISSON_TEXT("The vessel mask holds a piece of {0} mm width that is no vessel: mark vessels alone."),
          {fmt::format("{:.0f}", 2 * depth)});
    }
  }
  return {};
}

std::vector<char> on_lines(const Voxels& voxels, const Paths& paths, const CenterLineOptions& options,
                           const std::vector<int>& pieces) {
  std::vector<char> chosen(voxels.count(), 0), covered(voxels.count(), 0);
  const auto cover = [&](int v) {
    voxels.for_ball(v, 1.5 * voxels.depth_mm(v) + 1, [&](int other) { covered[static_cast<std::size_t>(other)] = 1; });
  };
  for (const int p : pieces) {
    std::vector<int> farthest_first = paths.pieces[static_cast<std::size_t>(p)];
    const int root = farthest_first.front();
    chosen[static_cast<std::size_t>(root)] = 1;
    cover(root);
    std::stable_sort(farthest_first.begin(), farthest_first.end(), [&](int a, int b) {
      return paths.length_mm[static_cast<std::size_t>(a)] > paths.length_mm[static_cast<std::size_t>(b)];
    });
    for (const int tip : farthest_first) {
      if (covered[static_cast<std::size_t>(tip)] != 0) continue;
      std::vector<int> path;
      int v = tip;
      for (; chosen[static_cast<std::size_t>(v)] == 0; v = paths.next[static_cast<std::size_t>(v)]) path.push_back(v);
      const double beyond_wall = paths.length_mm[static_cast<std::size_t>(tip)] -
                                 paths.length_mm[static_cast<std::size_t>(v)] - voxels.depth_mm(v);
      covered[static_cast<std::size_t>(tip)] = 1;
      if (beyond_wall < options.minimum_branch_mm) continue;
      for (const int on_path : path) {
        chosen[static_cast<std::size_t>(on_path)] = 1;
        cover(on_path);
      }
    }
  }
  return chosen;
}

Lines lines_of(const Voxels& voxels, const Paths& paths, const std::vector<char>& chosen) {
  const std::size_t count = voxels.count();
  std::vector<int> children(count, 0), vertex(count, -1);
  for (std::size_t v = 0; v < count; ++v) {
    if (chosen[v] != 0 && paths.next[v] >= 0) ++children[static_cast<std::size_t>(paths.next[v])];
  }
  Lines lines;
  for (std::size_t v = 0; v < count; ++v) {
    if (chosen[v] == 0 || (children[v] == 1 && paths.next[v] >= 0)) continue;
    vertex[v] = static_cast<int>(lines.graph.vertices_mm.size());
    lines.graph.vertices_mm.push_back(voxels.position_mm(static_cast<int>(v)));
  }
  for (std::size_t start = 0; start < count; ++start) {
    if (vertex[start] < 0 || paths.next[start] < 0) continue;
    std::vector<int> way = {static_cast<int>(start)};
    do {
      way.push_back(paths.next[static_cast<std::size_t>(way.back())]);
    } while (vertex[static_cast<std::size_t>(way.back())] < 0);
    std::reverse(way.begin(), way.end());
    GraphBranch branch{vertex[static_cast<std::size_t>(way.front())], vertex[start], {}, Joint::vessel, 0, 0};
    for (const int v : way) branch.points.push_back({voxels.position_mm(v), voxels.depth_mm(v)});
    lines.graph.branches.push_back(std::move(branch));
    lines.voxels_of.push_back(std::move(way));
  }
  return lines;
}

Nearest nearest_lines(const Voxels& voxels, const Lines& lines) {
  Nearest nearest{std::vector<int>(voxels.count(), -1), std::vector<int>(voxels.count(), -1)};
  std::vector<float> distance(voxels.count(), unreached);
  using Waiting = std::pair<float, int>;
  std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> queue;
  for (std::size_t b = 0; b < lines.voxels_of.size(); ++b) {
    for (std::size_t i = 0; i < lines.voxels_of[b].size(); ++i) {
      const auto v = static_cast<std::size_t>(lines.voxels_of[b][i]);
      if (distance[v] == 0) continue;  // a vertex goes to its first branch
      distance[v] = 0;
      nearest.branch[v] = static_cast<int>(b);
      nearest.point[v] = static_cast<int>(i);
      queue.emplace(0.0F, static_cast<int>(v));
    }
  }
  while (!queue.empty()) {
    const auto [reached, v] = queue.top();
    queue.pop();
    const auto from = static_cast<std::size_t>(v);
    if (reached > distance[from]) continue;
    voxels.for_neighbours(v, [&, so_far = reached](int other, float length) {
      const auto o = static_cast<std::size_t>(other);
      if (so_far + length >= distance[o]) return;
      distance[o] = so_far + length;
      nearest.branch[o] = nearest.branch[from];
      nearest.point[o] = nearest.point[from];
      queue.emplace(distance[o], other);
    });
  }
  return nearest;
}

// The mean over a window of about two radii each way.
template <typename Value, typename Get>
Value window_mean(const std::vector<CenterPoint>& points, std::size_t i, std::size_t reach, const Get& get) {
  const std::size_t span = std::min({i, points.size() - 1 - i, reach});
  Value sum = get(points[i]);
  for (std::size_t n = 1; n <= span; ++n) sum = sum + get(points[i - n]) + get(points[i + n]);
  return sum / static_cast<double>(2 * span + 1);
}

void set_radii(const Voxels& voxels, const Nearest& nearest, VesselGraph& graph) {
  std::vector<std::vector<double>> volume(graph.branches.size());
  for (std::size_t b = 0; b < graph.branches.size(); ++b) volume[b].assign(graph.branches[b].points.size(), 0);
  for (std::size_t v = 0; v < voxels.count(); ++v) {
    if (nearest.branch[v] >= 0) {
      volume[static_cast<std::size_t>(nearest.branch[v])][static_cast<std::size_t>(nearest.point[v])] +=
          voxels.grid().voxel_volume_mm3();
    }
  }
  for (std::size_t b = 0; b < graph.branches.size(); ++b) {
    std::vector<CenterPoint>& points = graph.branches[b].points;
    const std::size_t count = points.size();
    std::vector<CenterPoint> smoothed = points;
    for (std::size_t i = 0; i < count; ++i) {
      smoothed[i].position_mm = window_mean<Vector3d>(points, i, 4, [](const CenterPoint& p) { return p.position_mm; });
    }
    std::vector<double> along(count, 0);
    for (std::size_t i = 1; i < count; ++i) {
      along[i] = along[i - 1] + (smoothed[i].position_mm - smoothed[i - 1].position_mm).norm();
    }
    std::vector<double> radii(count);
    for (std::size_t i = 0; i < count; ++i) {
      const double depth = points[i].radius_mm;
      // The cylinder: only away from the ends, whose voxels belong to the neighbours or to a cap.
      double sum = 0;
      std::size_t low = i, high = i;
      const double reach = std::max(3.0, 1.5 * depth);
      while (low > 0 && along[i] - along[low - 1] <= reach) --low;
      while (high + 1 < count && along[high + 1] - along[i] <= reach) ++high;
      for (std::size_t n = low; n <= high; ++n) sum += volume[b][n];
      const double length = along[high] - along[low] + (along[high] - along[low]) / std::max<double>(1, high - low);
      const double cylinder = length > 0 ? std::sqrt(sum / (3.14159265358979 * length)) : depth;
      const bool inside = low > 0 && high + 1 < count;
      radii[i] = inside ? std::clamp(cylinder, depth, 1.35 * depth + 0.3) : depth;
    }
    for (std::size_t i = 0; i < count; ++i) points[i].radius_mm = radii[i];
  }
}

void smooth(VesselGraph& graph) {
  for (GraphBranch& branch : graph.branches) {
    std::vector<CenterPoint> smoothed = branch.points;
    for (int pass = 0; pass < 2; ++pass) {
      const std::vector<CenterPoint> before = smoothed;
      for (std::size_t i = 0; i < before.size(); ++i) {
        smoothed[i].position_mm =
            window_mean<Vector3d>(before, i, 4, [](const CenterPoint& p) { return p.position_mm; });
        smoothed[i].radius_mm = window_mean<double>(before, i, 3, [](const CenterPoint& p) { return p.radius_mm; });
      }
    }
    branch.points = std::move(smoothed);
    measure(branch);
  }
}

// Where voxels of two lines lie side by side though the way along the lines is long, the lines are joined once, where
// they come closest.
void add_contacts(const Voxels& voxels, const Nearest& nearest, const Paths& paths, const Lines& lines,
                  VesselGraph& graph) {
  struct Contact {
    double apart_mm = 0, depth_mm = 0;
    int point_a = 0, point_b = 0;
  };
  std::map<std::pair<int, int>, Contact> contacts;
  const auto voxel_at = [&](int branch, int point) {
    return lines.voxels_of[static_cast<std::size_t>(branch)][static_cast<std::size_t>(point)];
  };
  // Both ways to where they meet; voxels are numbered, and ways have lengths, so that climbing the longer one ends.
  const auto way_along_lines = [&](int a, int b) {
    const float sum = paths.length_mm[static_cast<std::size_t>(a)] + paths.length_mm[static_cast<std::size_t>(b)];
    while (a != b) {
      int& longer =
          paths.length_mm[static_cast<std::size_t>(a)] >= paths.length_mm[static_cast<std::size_t>(b)] ? a : b;
      if (paths.next[static_cast<std::size_t>(longer)] < 0) break;
      longer = paths.next[static_cast<std::size_t>(longer)];
    }
    return static_cast<double>(sum - 2 * paths.length_mm[static_cast<std::size_t>(a)]);
  };
  for (std::size_t v = 0; v < voxels.count(); ++v) {
    const int a = nearest.branch[v];
    if (a < 0) continue;
    voxels.for_neighbours(static_cast<int>(v), [&](int other, float) {
      const auto o = static_cast<std::size_t>(other);
      const int b = nearest.branch[o];
      if (b <= a) return;
      const int va = voxel_at(a, nearest.point[v]), vb = voxel_at(b, nearest.point[o]);
      const double apart = (voxels.position_mm(va) - voxels.position_mm(vb)).norm();
      const auto found = contacts.find({a, b});
      if (found != contacts.end() && found->second.apart_mm <= apart) return;
      const double thick = voxels.depth_mm(va) + voxels.depth_mm(vb);
      if (way_along_lines(va, vb) < 15 + 3 * thick) return;
      contacts[{a, b}] = {apart, std::min(voxels.depth_mm(static_cast<int>(v)), voxels.depth_mm(other)),
                          nearest.point[v], nearest.point[o]};
    });
  }
  std::vector<NewJoint> joints;
  for (const auto& [pair, contact] : contacts) {
    joints.push_back({pair.first, contact.point_a, pair.second, contact.point_b, Joint::contact, contact.depth_mm});
  }
  join(graph, joints);
}

}  // namespace
}  // namespace glisson::vasculature

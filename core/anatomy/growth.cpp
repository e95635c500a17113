#include "anatomy/growth.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <optional>

#include "anatomy/implicit.h"
#include "anatomy/internal/capsules.h"

namespace glisson::anatomy {

using Eigen::Vector3d;

std::vector<Vector3d> spread_places(const LiverBody& liver, const std::vector<Lesion>& lesions, int count,
                                    double depth_mm, std::uint64_t seed) {
  constexpr double saturation = 0.38 * 6 / 3.14159265358979;  // places times cubed distance, per volume
  Random random(seed);
  std::vector<Vector3d> candidates;
  const imaging::Grid& grid = liver.distance_mm.grid;
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        if (static_cast<double>(liver.distance_mm.at(i, j, k)) > -depth_mm) continue;
        const Vector3d jitter(random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5);
        candidates.push_back(grid.position_mm(Vector3d(i, j, k) + jitter));
      }
    }
  }
  std::erase_if(candidates, [&](const Vector3d& p) {
    return std::any_of(lesions.begin(), lesions.end(), [&](const Lesion& l) { return l.distance_mm(p) < 2; });
  });
  const double volume_mm3 = static_cast<double>(candidates.size()) * grid.voxel_volume_mm3();
  const double apart_mm = std::cbrt(saturation * volume_mm3 / count);
  random.shuffle(candidates);
  std::vector<Vector3d> places;
  for (const Vector3d& candidate : candidates) {
    const bool crowded = std::any_of(places.begin(), places.end(), [&](const Vector3d& other) {
      return (other - candidate).squaredNorm() < apart_mm * apart_mm;
    });
    if (!crowded) places.push_back(candidate);
  }
  return places;
}

namespace {

// Where a new branch leaves an old piece, and what that adds to the volume (up to a factor).
struct Joint {
  int piece = -1;  // the node at the piece's end
  Vector3d position_mm{0, 0, 0};
  double cost = 0;
};

class Grower {
 public:
  Grower(VesselTree trunk, const GrowthSite& site, std::size_t places) : tree_(std::move(trunk)), site_(site) {
    // A radius before growth is done: that of the flow's share now, and a terminal's of the share in the end.
    set_radii(tree_, site.root_radius_mm);
    for (const VesselNode& node : tree_.nodes) {
      if (node.parent < 0) whole_ += node.flow;
    }
    minimum_radius_mm_ = site.root_radius_mm / std::cbrt(static_cast<double>(places) + whole_);
  }

  void join(const Vector3d& place) {
    const int segment = site_.segments->at(place);
    for (const Joint& joint : joints_for(place, segment)) {
      if (!is_free(joint, place)) continue;
      add(joint, place, segment);
      return;
    }
  }

  VesselTree take() && { return ordered(); }

 private:
  [[nodiscard]] const VesselNode& node(int i) const { return tree_.nodes[static_cast<std::size_t>(i)]; }
  [[nodiscard]] VesselNode& node(int i) { return tree_.nodes[static_cast<std::size_t>(i)]; }

  // The cheapest joint of each of the nearest pieces, the cheapest first.
  [[nodiscard]] std::vector<Joint> joints_for(const Vector3d& place, int segment) const {
    constexpr std::size_t nearest = 24;
    std::vector<std::pair<double, int>> pieces;
    for (int i = 0; i < static_cast<int>(tree_.nodes.size()); ++i) {
      if (node(i).parent < 0 || (site_.by_segment && node(i).segment != segment)) continue;
      pieces.emplace_back(on_stretch(node(node(i).parent).position_mm, node(i).position_mm, place).distance_mm, i);
    }
    const std::size_t count = std::min(nearest, pieces.size());
    std::partial_sort(pieces.begin(), pieces.begin() + static_cast<std::ptrdiff_t>(count), pieces.end());
    std::vector<Joint> joints;
    for (std::size_t n = 0; n < count; ++n) {
      for (const Joint& joint : joints_on(pieces[n].second, place)) joints.push_back(joint);
    }
    std::sort(joints.begin(), joints.end(),
              [](const Joint& a, const Joint& b) { return std::pair(a.cost, a.piece) < std::pair(b.cost, b.piece); });
    return joints;
  }

  // Over a lattice in the triangle of the piece's ends and the place; a trunk keeps its course.
  [[nodiscard]] std::vector<Joint> joints_on(int piece, const Vector3d& place) const {
    constexpr int steps = 6;
    constexpr double shortest_mm = 2;
    const Vector3d &a = node(node(piece).parent).position_mm, &c = node(piece).position_mm;
    const double flow = node(piece).flow;
    const auto share = [](double f) { return std::cbrt(f * f); };
    const double upstream = upstream_cost(node(piece).parent);
    std::optional<Joint> best;
    for (int i = 1; i < steps; ++i) {
      for (int j = 0; j < steps - i; ++j) {
        if (j > 0 && node(piece).trunk) break;
        const double w_place = static_cast<double>(j) / steps, w_end = static_cast<double>(i) / steps;
        const Vector3d b = a + w_end * (c - a) + w_place * (place - a);
        const double up = (b - a).norm(), down = (c - b).norm(), out = (place - b).norm();
        if (std::min({up, down, out}) < (node(piece).trunk ? 0.7 : shortest_mm)) continue;
        if (out < radius_mm(flow) + 2 * minimum_radius_mm_) continue;
        const double cost = share(flow + 1) * up + share(flow) * down + out - share(flow) * (c - a).norm() + upstream;
        if (!best || cost < best->cost) best = Joint{piece, b, cost};
      }
    }
    return best ? std::vector<Joint>{*best} : std::vector<Joint>{};
  }

  // What one more terminal adds on the way from the entry to the node.
  [[nodiscard]] double upstream_cost(int i) const {
    double cost = 0;
    for (; i >= 0 && node(i).parent >= 0; i = node(i).parent) {
      const double flow = node(i).flow;
      cost += (std::cbrt((flow + 1) * (flow + 1)) - std::cbrt(flow * flow)) *
              (node(i).position_mm - node(node(i).parent).position_mm).norm();
    }
    return cost;
  }

  [[nodiscard]] double radius_mm(double flow) const {
    return std::max(minimum_radius_mm_, site_.root_radius_mm * std::cbrt(flow / (whole_ + 1)));
  }

  [[nodiscard]] bool is_free(const Joint& joint, const Vector3d& place) const {
    const VesselNode& end = node(joint.piece);
    const Vector3d& start = node(end.parent).position_mm;
    const Vector3d& b = joint.position_mm;
    // Each begins at an old node, or as far from one as the joint lies.
    struct Piece {
      Capsule capsule;
      int begins_at;
      double offset_mm;
    };
    const double up = (b - start).norm(), down = (b - end.position_mm).norm();
    const std::array<Piece, 3> pieces = {
        Piece{{b, place, minimum_radius_mm_}, up < down ? end.parent : joint.piece, std::min(up, down)},
        Piece{{start, b, radius_mm(end.flow + 1)}, end.parent, 0},
        Piece{{end.position_mm, b, radius_mm(end.flow)}, joint.piece, 0}};
    const std::size_t changed = end.trunk ? 1 : 3;  // a trunk stays where it is
    for (std::size_t n = 0; n < changed; ++n) {
      const auto& [capsule, begins_at, offset_mm] = pieces[n];
      if (!lies_inside(capsule)) return false;
      for (const VesselTree* other : site_.others) {
        if (comes_near(capsule, *other, 2 * clear_mm)) return false;
      }
      if (meets_own(capsule, begins_at, offset_mm, joint.piece)) return false;
    }
    return true;
  }

  [[nodiscard]] bool lies_inside(const Capsule& piece) const {
    const int steps = std::max(2, static_cast<int>((piece.to_mm - piece.from_mm).norm() / 2));
    for (int i = 0; i <= steps; ++i) {
      const Vector3d p = piece.from_mm + static_cast<double>(i) / steps * (piece.to_mm - piece.from_mm);
      if (site_.liver->depth_mm(p) < piece.radius_mm + 1) return false;
      for (const Lesion& lesion : *site_.lesions) {
        if (lesion.distance_mm(p) < piece.radius_mm + 0.5) return false;
      }
    }
    return true;
  }

  // Own branches, but where a piece parts from them: it begins `offset_mm` along the tree from the node.
  [[nodiscard]] bool meets_own(const Capsule& piece, int begins_at, double offset_mm, int old_piece) const {
    for (int i = 0; i < static_cast<int>(tree_.nodes.size()); ++i) {
      const VesselNode& other = node(i);
      if (other.parent < 0 || i == old_piece) continue;
      const Capsule capsule{node(other.parent).position_mm, other.position_mm, radius_mm(other.flow)};
      const double reach = piece.radius_mm + capsule.radius_mm + 2 * clear_mm;
      const double length = (capsule.from_mm - capsule.to_mm).norm() + (piece.from_mm - piece.to_mm).norm();
      if ((capsule.from_mm - piece.from_mm).norm() > length + reach) continue;
      if (distance_mm(piece.from_mm, piece.to_mm, capsule.from_mm, capsule.to_mm) >= reach) continue;
      Capsule rest = piece;
      const double path = std::min(path_mm(tree_, begins_at, i), path_mm(tree_, begins_at, other.parent));
      if (!trim_parting(rest, capsule.radius_mm, offset_mm + path)) continue;
      if (distance_mm(rest.from_mm, rest.to_mm, capsule.from_mm, capsule.to_mm) < reach) return true;
    }
    return false;
  }

  void add(const Joint& joint, const Vector3d& place, int segment) {
    const VesselNode old = node(joint.piece);
    VesselNode bifurcation = old;
    bifurcation.position_mm = joint.position_mm;
    const int middle = static_cast<int>(tree_.nodes.size());
    tree_.nodes.push_back(bifurcation);
    node(joint.piece).parent = middle;
    VesselNode terminal;
    terminal.position_mm = place;
    terminal.parent = middle;
    terminal.segment = segment;
    terminal.flow = 1;
    tree_.nodes.push_back(terminal);
    for (int i = middle; i >= 0; i = node(i).parent) node(i).flow += 1;
    whole_ += 1;
  }

  // Parents before children.
  [[nodiscard]] VesselTree ordered() const {
    std::vector<std::vector<int>> children(tree_.nodes.size());
    std::vector<int> open;
    for (int i = static_cast<int>(tree_.nodes.size()) - 1; i >= 0; --i) {
      if (node(i).parent < 0) {
        open.push_back(i);
      } else {
        children[static_cast<std::size_t>(node(i).parent)].push_back(i);
      }
    }
    VesselTree result{tree_.system, {}};
    std::vector<int> index(tree_.nodes.size(), -1);
    while (!open.empty()) {
      const int i = open.back();
      open.pop_back();
      index[static_cast<std::size_t>(i)] = static_cast<int>(result.nodes.size());
      result.nodes.push_back(node(i));
      if (node(i).parent >= 0) result.nodes.back().parent = index[static_cast<std::size_t>(node(i).parent)];
      for (const int child : children[static_cast<std::size_t>(i)]) open.push_back(child);
    }
    return result;
  }

  VesselTree tree_;
  GrowthSite site_;
  double whole_ = 0, minimum_radius_mm_ = 0;
};

// Cuts what meets, the finer of two first, until nothing does; of trunks only where two of them meet.
VesselTree without_meetings(VesselTree tree, const GrowthSite& site) {
  for (;;) {
    std::vector<bool> cut(tree.nodes.size(), false);
    bool any = false;
    const auto mark = [&](std::size_t i) {
      if (tree.nodes[i].trunk) return false;
      cut[i] = any = true;
      return true;
    };
    for (const Meeting& meeting : meetings_within(tree, clear_mm)) {
      const bool first_is_finer = tree.nodes[meeting.first].flow <= tree.nodes[meeting.second].flow;
      const auto [finer, wider] =
          first_is_finer ? std::pair(meeting.first, meeting.second) : std::pair(meeting.second, meeting.first);
      if (cut[finer] || cut[wider] || mark(finer) || mark(wider)) continue;
      cut[finer] = any = true;
    }
    for (const VesselTree* other : site.others) {
      for (const Meeting& meeting : meetings(tree, *other, clear_mm)) mark(meeting.first);
    }
    if (!any) return tree;
    tree = pruned(tree, std::move(cut));
    set_radii(tree, site.root_radius_mm);
  }
}

}  // namespace

VesselTree grown(VesselTree trunk, const std::vector<Vector3d>& places, const GrowthSite& site) {
  Grower grower(std::move(trunk), site, places.size());
  for (const Vector3d& place : places) grower.join(place);
  VesselTree tree = std::move(grower).take();
  set_radii(tree, site.root_radius_mm);
  return without_meetings(std::move(tree), site);
}

}  // namespace glisson::anatomy

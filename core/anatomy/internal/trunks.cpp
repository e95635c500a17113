#include "anatomy/internal/trunks.h"

#include <algorithm>
#include <cmath>

#include "anatomy/internal/capsules.h"

namespace glisson::anatomy {

using Eigen::Vector3d;

namespace {

constexpr double piece_mm = 9;  // of a curved trunk, about

int add_node(VesselTree& tree, const Vector3d& position, int parent, int segment) {
  VesselNode node;
  node.position_mm = position;
  node.parent = parent;
  node.segment = segment;
  node.trunk = true;
  tree.nodes.push_back(node);
  return static_cast<int>(tree.nodes.size()) - 1;
}

// Along a parabola that starts towards `by` (Bezier 1972), in pieces; returns the last node.
int add_curve(VesselTree& tree, int from, const Vector3d& by, const Vector3d& to, int segment) {
  const Vector3d start = tree.nodes[static_cast<std::size_t>(from)].position_mm;
  const int pieces = std::max(2, static_cast<int>(std::lround((to - start).norm() / piece_mm)));
  int last = from;
  for (int i = 1; i <= pieces; ++i) {
    const double t = static_cast<double>(i) / pieces;
    last = add_node(tree, (1 - t) * (1 - t) * start + 2 * t * (1 - t) * by + t * t * to, last, segment);
  }
  return last;
}

// Back towards `from` until it lies deep enough.
Vector3d deep_enough(const LiverBody& liver, const Vector3d& from, Vector3d to, double depth_mm) {
  for (int i = 0; i < 12 && liver.depth_mm(to) < depth_mm; ++i) to = from + 0.9 * (to - from);
  return to;
}

}  // namespace

VesselTree portal_trunk(const LiverBody& liver, const Segments& segments) {
  VesselTree tree{System::portal_vein, {}};
  const auto place = [&](double x, double y, double z) { return liver.to_patient({x, y, z}); };
  const auto at = [&](int node) { return tree.nodes[static_cast<std::size_t>(node)].position_mm; };
  const auto pedicle = [&](int from, int segment, const Vector3d& target) {
    if (segments.volume_ml(segment) <= 0) return;
    const Vector3d end = deep_enough(liver, at(from), target, 8);
    const Vector3d backwards = tree.nodes[static_cast<std::size_t>(from)].parent < 0
                                   ? Vector3d::Zero().eval()
                                   : (at(from) - at(tree.nodes[static_cast<std::size_t>(from)].parent)).normalized();
    add_curve(tree, from, at(from) + 0.3 * (end - at(from)).norm() * (0.6 * backwards + (end - at(from)).normalized()),
              end, segment);
  };
  const auto& middle = [&](int a, int b) { return (0.5 * (segments.centroid_mm(a) + segments.centroid_mm(b))).eval(); };

  const int entry = add_node(tree, place(10, -6, -82), -1, 0);
  const int porta = add_curve(tree, entry, place(-2, -16, -36), place(-20, -13, -3), 0);

  const int right = add_curve(tree, porta, place(-30, -11, 2), place(-42, -6, 1), 0);
  const auto sector = [&](int low, int high) {
    const Vector3d target = at(right) + 0.42 * (middle(low, high) - at(right));
    const int end = add_curve(tree, right, at(right) + 0.4 * (target - at(right)) + Vector3d(-5, 0, 0), target, 0);
    for (const int segment : {low, high}) {
      pedicle(end, segment, at(end) + 1.1 * (segments.centroid_mm(segment) - at(end)));
    }
  };
  sector(5, 8);
  sector(6, 7);

  const int caudate_start = add_curve(tree, porta, place(-16, -17, 1), place(-10, -19, 1), 0);
  pedicle(caudate_start, 1, segments.centroid_mm(1));
  const int bend = add_curve(tree, caudate_start, place(-4, -22, 2), place(2, -26, 3), 0);
  pedicle(bend, 2, segments.centroid_mm(2));
  const int umbilical = add_curve(tree, bend, place(6, -32, 3), place(6, -46, 0), 0);
  pedicle(umbilical, 3, segments.centroid_mm(3));
  pedicle(umbilical, 4, segments.centroid_mm(4) + Vector3d(2, 4, 14));
  pedicle(umbilical, 4, segments.centroid_mm(4) + Vector3d(-4, -14, -12));
  return tree;
}

namespace {

double reach_in_plane(const LiverBody& liver, const Segments& segments, Segments::Plane plane, double z_mm) {
  double reach = 0;
  for (double from_cava = 10; from_cava < 160; from_cava += 2) {
    if (liver.depth_mm(segments.on_plane(plane, z_mm, from_cava)) > 0) reach = from_cava;
  }
  return reach;
}

// Where the veins enter: as high as tissue still lies before the vena cava, a little below.
double confluence_height(const LiverBody& liver, const Segments& segments, double cava_radius) {
  const double top = liver.to_patient({0, 0, 90}).z();
  for (double z = top; z > top - 120; z -= 1) {
    if (liver.depth_mm(segments.on_plane(Segments::Plane::middle, z, cava_radius + 7)) > 5 &&
        liver.depth_mm(segments.on_plane(Segments::Plane::right, z, cava_radius + 7)) > 4) {
      return z - 2;
    }
  }
  return top - 60;
}

// Downwards and outwards in the plane, as far as the liver goes on.
void add_vein_in_plane(VesselTree& tree, int from, const LiverBody& liver, const Segments& segments,
                       Segments::Plane plane, const VesselTree& portal, double radius_mm) {
  const double start_z = tree.nodes[static_cast<std::size_t>(from)].position_mm.z();
  constexpr std::array<double, 9> drops_mm = {3, 8, 16, 26, 38, 50, 62, 76, 90};
  constexpr std::array<double, 9> fractions = {0.24, 0.34, 0.44, 0.53, 0.6, 0.65, 0.68, 0.7, 0.72};
  const auto lies_well = [&](int parent, const Vector3d& p, double r) {
    const Vector3d& start = tree.nodes[static_cast<std::size_t>(parent)].position_mm;
    return liver.depth_mm(p) > 7 && liver.depth_mm(0.5 * (p + start)) > r + 1 &&
           !comes_near({start, p, r}, portal, 1.5);
  };
  int last = from;
  for (std::size_t i = 0; i < drops_mm.size(); ++i) {
    const double z = start_z - drops_mm[i] * liver.scale / 0.87;
    const double reach = reach_in_plane(liver, segments, plane, z);
    bool added = false;
    for (const double change : {0.0, 0.05, -0.05, 0.1, -0.1, 0.15, -0.15, 0.2, -0.2}) {
      const Vector3d p = segments.on_plane(plane, z, (fractions[i] + change) * reach);
      if (!lies_well(last, p, radius_mm)) continue;
      last = add_node(tree, p, last, 0);
      added = true;
      break;
    }
    if (!added && i > 3) return;
  }
}

}  // namespace

VesselTree hepatic_trunk(const LiverBody& liver, const Segments& segments, const VesselTree& portal,
                         double root_radius_mm) {
  VesselTree tree{System::hepatic_vein, {}};
  const double cava_radius = liver.scale * 12;
  const double z = confluence_height(liver, segments, cava_radius);
  const auto at = [&](int node) { return tree.nodes[static_cast<std::size_t>(node)].position_mm; };
  const double radius = 0.72 * root_radius_mm;

  const int right = add_node(tree, segments.on_plane(Segments::Plane::right, z, 0.6 * cava_radius), -1, 0);
  add_vein_in_plane(tree, right, liver, segments, Segments::Plane::right, portal, radius);

  const int common = add_node(tree, segments.on_plane(Segments::Plane::middle, z, 0.6 * cava_radius), -1, 0);
  const Vector3d out = segments.on_plane(Segments::Plane::middle, z - 1, cava_radius + 6) + Vector3d(3, 0, 0);
  const int division = add_node(tree, out, common, 0);
  add_vein_in_plane(tree, division, liver, segments, Segments::Plane::middle, portal, radius);

  if (segments.volume_ml(2) > 0 && segments.volume_ml(3) > 0) {
    const Vector3d between = segments.on_left_plane(0.5 * (segments.centroid_mm(2) + segments.centroid_mm(3)));
    const Vector3d target = deep_enough(liver, at(division), at(division) + 1.25 * (between - at(division)), 7);
    add_curve(tree, division, at(division) + 0.5 * (target - at(division)) + Vector3d(0, -4, 6), target, 0);
  }
  if (segments.volume_ml(1) > 0) {
    const Vector3d& middle = segments.centroid_mm(1);
    const Vector3d cava = segments.on_plane(Segments::Plane::middle, middle.z() + 4, 0);
    const Vector3d way = middle - cava;
    const int entry = add_node(tree, cava + 0.6 * cava_radius * way.normalized(), -1, 1);
    add_node(tree, deep_enough(liver, at(entry), middle + Vector3d(3, -3, 6), 5), entry, 1);
  }
  return tree;
}

}  // namespace glisson::anatomy

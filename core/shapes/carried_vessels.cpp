#include "shapes/carried_vessels.h"

#include <algorithm>
#include <cmath>
#include <Eigen/LU>

#include "anatomy/level_surface.h"
#include "anatomy/patient.h"
#include "geometry/nearest.h"
#include "geometry/spread_points.h"
#include "registration/thin_plate.h"
#include "segmentation/rasterise.h"
#include "shapes/correspondence.h"
#include "vasculature/couinaud.h"
#include "vasculature/measured_branch.h"

namespace glisson::shapes {
namespace {

using Eigen::Vector3d;
using vasculature::CenterPoint;
using vasculature::TreeBranch;
using vasculature::VesselTrees;

using Depths = std::vector<std::vector<double>>;

constexpr double step_mm = 2;  // between points of a branch

void add_tree(const anatomy::Patient& patient, const anatomy::VesselTree& tree, vasculature::System system,
              VesselTrees& trees);
void set_entries(VesselTrees& trees);
int cut_shallow_twigs(double minimum_mm, VesselTrees& trees, Depths& depth_mm, Depths* before_mm = nullptr);
imaging::LabelMap segments_of(const anatomy::Patient& patient, const geometry::Surface& liver);
void pull_in(const Depths& before_mm, const geometry::Surface& liver, CarriedVessels& carried);
void keep_apart(const VesselTrees& before, VesselTrees& after);
int come_out(const Depths& before_mm, const Depths& after_mm);

// From one surface to the other in equal steps of all points, a spline each.
class Flow {
 public:
  Flow(const geometry::Surface& from, const geometry::Surface& to) {
    constexpr std::size_t maximum_controls = 900;  // as many as bent the reference onto each liver (correspondence.h)
    for (const std::size_t p : geometry::spread_points(from.points_mm, maximum_controls)) {
      now_mm_.push_back(from.points_mm[p]);
      step_mm_.emplace_back((to.points_mm[p] - from.points_mm[p]) / steps);
    }
  }
  [[nodiscard]] bool arrived() const { return taken_ == steps; }
  Result<registration::ThinPlateSpline> next() {
    std::vector<Vector3d> next_mm;
    for (std::size_t c = 0; c < now_mm_.size(); ++c) next_mm.emplace_back(now_mm_[c] + step_mm_[c]);
    auto warp = registration::ThinPlateSpline::fit(now_mm_, next_mm);
    now_mm_ = std::move(next_mm);
    ++taken_;
    return warp;
  }

 private:
  static constexpr int steps = 6;
  std::vector<Vector3d> now_mm_, step_mm_;
  int taken_ = 0;
};

}  // namespace

Result<LiverWithVessels> reference_vessels(double spacing_mm, const Progress& progress) {
  auto surface = reference_liver(spacing_mm);
  if (!surface) return failure(std::move(surface.error()));
  const auto patient = anatomy::make_patient({}, progress);
  if (!patient) return failure(patient.error());
  LiverWithVessels liver{*std::move(surface), {}, {}};
  add_tree(*patient, patient->portal_vein, vasculature::System::portal_vein, liver.trees);
  add_tree(*patient, patient->hepatic_vein, vasculature::System::hepatic_vein, liver.trees);
  add_tree(*patient, patient->artery, vasculature::System::artery, liver.trees);
  set_entries(liver.trees);
  liver.depth_mm = depths_mm(liver.trees, liver.surface);
  cut_shallow_twigs(shallow_mm, liver.trees, liver.depth_mm);
  vasculature::CouinaudSegments segments;
  segments.segment = segments_of(*patient, liver.surface);
  vasculature::name_branches(liver.trees, segments);
  return liver;
}

Result<CarriedVessels> carry_vessels(const LiverWithVessels& from, const geometry::Surface& to) {
  if (from.surface.triangles != to.triangles || from.surface.points_mm.size() != to.points_mm.size()) {
    return failure(
        Error{"vessels-not-corresponding",
              GLISSON_TEXT("The liver's points are not those of the liver whose vessels are carried along."),
              {},
              GLISSON_TEXT("Give the spacing of the reference that the model was made with, or draw without vessels."),
              {}});
  }
  CarriedVessels carried;
  carried.trees = from.trees;
  VesselTrees& trees = carried.trees;
  trees.clicks.clear();
  trees.borders.clear();
  trees.border_doubts.clear();
  Flow flow(from.surface, to);
  while (!flow.arrived()) {
    const auto warp = flow.next();
    if (!warp) return failure(warp.error());
    trees.portal_entry_mm = (*warp)(trees.portal_entry_mm);
    trees.hepatic_entry_mm = (*warp)(trees.hepatic_entry_mm);
    for (TreeBranch& branch : trees.branches) {
      for (CenterPoint& point : branch.points) {
        const double ratio = warp->jacobian(point.position_mm).determinant();
        if (!(ratio > 0)) {
          return failure("vessels-fold",
                         GLISSON_TEXT("The liver is bent so far that vessels carried along would be turned inside "
                                      "out."));
        }
        point.radius_mm *= std::cbrt(ratio);
        point.position_mm = (*warp)(point.position_mm);
      }
    }
  }
  pull_in(from.depth_mm, to, carried);
  keep_apart(from.trees, trees);
  for (TreeBranch& branch : trees.branches) vasculature::measure_by_points(branch);
  carried.depth_mm = depths_mm(trees, to);
  Depths before_mm = from.depth_mm;
  constexpr double out_mm = 0.1;  // what pull_in could not set under the surface
  carried.cut_off = cut_shallow_twigs(out_mm, trees, carried.depth_mm, &before_mm);
  carried.outside = come_out(before_mm, carried.depth_mm);
  return carried;
}

std::vector<std::vector<double>> depths_mm(const VesselTrees& trees, const geometry::Surface& liver) {
  const geometry::SurfaceDistance surface(liver);
  Depths depths;
  for (const TreeBranch& branch : trees.branches) {
    std::vector<double>& row = depths.emplace_back();
    for (const CenterPoint& point : branch.points) {
      const double distance_mm = surface.closest(point.position_mm).distance_mm;
      row.push_back(surface.is_inside(point.position_mm) ? distance_mm : -distance_mm);
    }
  }
  return depths;
}

namespace {

// Straight pieces between the nodes become points every few millimetres, so that they can bend.
void add_tree(const anatomy::Patient& patient, const anatomy::VesselTree& tree, vasculature::System system,
              VesselTrees& trees) {
  std::vector<int> branch_of(tree.nodes.size(), -1);
  for (const anatomy::VesselBranch& grown : anatomy::branches_of(tree)) {
    const auto first = static_cast<std::size_t>(grown.nodes.front());
    const auto before = static_cast<std::size_t>(tree.nodes[first].parent);
    TreeBranch branch;
    branch.system = system;
    branch.parent = branch_of[before];
    branch.generation = grown.generation;
    branch.points.push_back({anatomy::placed(patient, tree.nodes[before].position_mm), tree.nodes[first].radius_mm});
    for (const int n : grown.nodes) {
      branch_of[static_cast<std::size_t>(n)] = static_cast<int>(trees.branches.size());
      const anatomy::VesselNode& node = tree.nodes[static_cast<std::size_t>(n)];
      const CenterPoint from = branch.points.back();
      const Vector3d way_mm = anatomy::placed(patient, node.position_mm) - from.position_mm;
      const int pieces = std::max(1, static_cast<int>(std::ceil(way_mm.norm() / step_mm)));
      for (int piece = 1; piece <= pieces; ++piece) {
        branch.points.push_back({from.position_mm + way_mm * piece / pieces, node.radius_mm});
      }
    }
    vasculature::measure_by_points(branch);
    trees.branches.push_back(std::move(branch));
  }
}

// Where the portal trunk divides, and between the places where hepatic veins enter.
void set_entries(VesselTrees& trees) {
  Vector3d sum_mm = Vector3d::Zero();
  int entering = 0;
  for (const TreeBranch& branch : trees.branches) {
    if (branch.parent >= 0) continue;
    if (branch.system == vasculature::System::portal_vein) trees.portal_entry_mm = branch.points.back().position_mm;
    if (branch.system != vasculature::System::hepatic_vein) continue;
    sum_mm += branch.points.front().position_mm;
    ++entering;
  }
  trees.hepatic_entry_mm = sum_mm / std::max(1, entering);
}

// From the tips inwards; what is left of a branch has two points at least. Rows of depths are cut alike.
int cut_shallow_twigs(double minimum_mm, VesselTrees& trees, Depths& depth_mm, Depths* before_mm) {
  int cut = 0;
  std::vector<int> children(trees.branches.size(), 0), number(trees.branches.size(), -1);
  for (const TreeBranch& branch : trees.branches) {
    if (branch.parent >= 0) ++children[static_cast<std::size_t>(branch.parent)];
  }
  for (std::size_t b = trees.branches.size(); b-- > 0;) {
    if (children[b] > 0) continue;
    TreeBranch& branch = trees.branches[b];
    const std::size_t points = branch.points.size();
    while (!branch.points.empty() && depth_mm[b][branch.points.size() - 1] < minimum_mm) branch.points.pop_back();
    if (branch.points.size() < 2) {
      branch.points.clear();
      if (branch.parent >= 0) --children[static_cast<std::size_t>(branch.parent)];
    }
    cut += static_cast<int>(points - branch.points.size());
    depth_mm[b].resize(branch.points.size());
    if (before_mm != nullptr) (*before_mm)[b].resize(branch.points.size());
  }
  int left = 0;
  for (std::size_t b = 0; b < trees.branches.size(); ++b) {
    TreeBranch& branch = trees.branches[b];
    if (branch.points.empty()) continue;
    number[b] = left++;
    if (branch.parent >= 0) branch.parent = number[static_cast<std::size_t>(branch.parent)];
    vasculature::measure_by_points(branch);
  }
  std::erase_if(trees.branches, [](const TreeBranch& branch) { return branch.points.empty(); });
  for (Depths* rows : {&depth_mm, before_mm}) {
    if (rows != nullptr) std::erase_if(*rows, [](const std::vector<double>& row) { return row.empty(); });
  }
  return cut;
}

imaging::LabelMap segments_of(const anatomy::Patient& patient, const geometry::Surface& liver) {
  constexpr double voxel_mm = 4;
  const imaging::Mask inside =
      segmentation::rasterise(liver, anatomy::grid_over(geometry::bounding_box(liver.points_mm), voxel_mm));
  imaging::LabelMap map{inside.grid, std::vector<std::uint16_t>(inside.grid.voxels(), 0)};
  for (int k = 0; k < map.grid.size[2]; ++k) {
    for (int j = 0; j < map.grid.size[1]; ++j) {
      for (int i = 0; i < map.grid.size[0]; ++i) {
        if (inside.at(i, j, k) == 0) continue;
        map.at(i, j, k) = static_cast<std::uint16_t>(anatomy::segment_at(patient, map.grid.position_mm(i, j, k)));
      }
    }
  }
  return map;
}

// What lay in the liver and has come out, or nearly, goes back the shortest way.
void pull_in(const Depths& before_mm, const geometry::Surface& liver, CarriedVessels& carried) {
  const geometry::SurfaceDistance surface(liver);
  for (std::size_t b = 0; b < before_mm.size(); ++b) {
    for (std::size_t i = 0; i < before_mm[b].size(); ++i) {
      if (before_mm[b][i] <= 0) continue;
      const double under_mm = std::min(pulled_under_mm, before_mm[b][i]);
      Vector3d& place_mm = carried.trees.branches[b].points[i].position_mm;
      const auto wall = surface.closest(place_mm);
      const bool inside = surface.is_inside(place_mm);
      if ((inside && wall.distance_mm >= under_mm) || wall.distance_mm == 0) continue;
      const Vector3d inwards = (inside ? 1 : -1) * (place_mm - wall.point_mm).normalized();
      place_mm = wall.point_mm + under_mm * inwards;
      ++carried.pulled_in;
      carried.farthest_pulled_mm =
          std::max(carried.farthest_pulled_mm, inside ? under_mm - wall.distance_mm : under_mm + wall.distance_mm);
    }
  }
}

// Walls that did not touch before and would now stop where they meet: both become that much narrower there.
void keep_apart(const VesselTrees& before, VesselTrees& after) {
  std::vector<CenterPoint> points_before;
  std::vector<CenterPoint*> points;
  std::vector<Vector3d> places_mm;
  double widest_mm = 0;
  for (std::size_t b = 0; b < after.branches.size(); ++b) {
    for (std::size_t i = 0; i < after.branches[b].points.size(); ++i) {
      points_before.push_back(before.branches[b].points[i]);
      points.push_back(&after.branches[b].points[i]);
      places_mm.push_back(points.back()->position_mm);
      widest_mm = std::max(widest_mm, points.back()->radius_mm);
    }
  }
  std::vector<double> narrower(points.size(), 1);
  const geometry::NearestPoint around(std::move(places_mm));
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (const auto& found : around.within(points[i]->position_mm, points[i]->radius_mm + widest_mm)) {
      const auto j = static_cast<std::size_t>(found.point);
      if (j <= i) continue;
      const double both_mm = points[i]->radius_mm + points[j]->radius_mm;
      const double apart_mm = std::sqrt(found.squared_distance_mm2);
      if (apart_mm >= both_mm) continue;
      const double before_mm = (points_before[i].position_mm - points_before[j].position_mm).norm();
      if (before_mm < points_before[i].radius_mm + points_before[j].radius_mm) continue;
      for (const std::size_t k : {i, j}) narrower[k] = std::min(narrower[k], apart_mm / both_mm);
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i) points[i]->radius_mm *= narrower[i];
}

// Points that lay in the liver and do not now.
int come_out(const Depths& before_mm, const Depths& after_mm) {
  int out = 0;
  for (std::size_t b = 0; b < before_mm.size(); ++b) {
    for (std::size_t i = 0; i < before_mm[b].size(); ++i) out += before_mm[b][i] > 0 && !(after_mm[b][i] > 0) ? 1 : 0;
  }
  return out;
}

}  // namespace
}  // namespace glisson::shapes

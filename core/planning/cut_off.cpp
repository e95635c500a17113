#include "planning/internal/cut_off.h"

#include <algorithm>
#include <limits>

#include "base/parallel.h"

namespace glisson::planning {

using Eigen::Vector3d;
using vasculature::CenterPoint;
using vasculature::TreeBranch;
using vasculature::VesselTrees;

namespace {

std::size_t nearest_point(const TreeBranch& branch, const Vector3d& position_mm) {
  const auto nearest =
      std::min_element(branch.points.begin(), branch.points.end(), [&](const CenterPoint& a, const CenterPoint& b) {
        return (a.position_mm - position_mm).squaredNorm() < (b.position_mm - position_mm).squaredNorm();
      });
  return static_cast<std::size_t>(nearest - branch.points.begin());
}

// Outside of the organ the nearest voxel along the axes, where so many of their six ways have tissue.
std::int32_t voxel_at(const Vector3d& position_mm, int sides, const Organ& organ,
                      const std::vector<std::int32_t>& numbers) {
  const Vector3d at = organ.grid.index_of(position_mm);
  const Eigen::Vector3i here = (at.array() + 0.5).floor().cast<int>();
  const auto number_of = [&](const Eigen::Vector3i& index) {
    return organ.grid.contains(index.x(), index.y(), index.z())
               ? numbers[organ.grid.offset(index.x(), index.y(), index.z())]
               : -1;
  };
  if (const std::int32_t number = number_of(here); number >= 0) return number;
  constexpr double reach_mm = 15;
  int ways = 0;
  double nearest_mm = std::numeric_limits<double>::infinity();
  std::int32_t nearest = -1;
  for (int axis = 0; axis < 3; ++axis) {
    for (const int sign : {-1, 1}) {
      for (int step = 1; step * organ.grid.spacing_mm[axis] <= reach_mm; ++step) {
        const std::int32_t number = number_of(here + sign * step * Eigen::Vector3i::Unit(axis));
        if (number < 0) continue;
        ++ways;
        if (step * organ.grid.spacing_mm[axis] < nearest_mm) {
          nearest_mm = step * organ.grid.spacing_mm[axis];
          nearest = number;
        }
        break;
      }
    }
  }
  return ways >= sides ? nearest : -1;
}

}  // namespace

TreePoints points_of(const VesselTrees& trees, const Organ& organ, const std::vector<std::int32_t>& numbers) {
  TreePoints points;
  for (const TreeBranch& branch : trees.branches) {
    points.first.push_back(points.voxel.size());
    const int sides = vasculature::is_vein(branch.system) ? 5 : 2;
    for (const CenterPoint& point : branch.points) {
      points.voxel.push_back(voxel_at(point.position_mm, sides, organ, numbers));
      points.radius_mm.push_back(point.radius_mm);
    }
    const bool grows = branch.parent >= 0 && !branch.points.empty();
    points.joint.push_back(grows ? nearest_point(trees.branches[static_cast<std::size_t>(branch.parent)],
                                                 branch.points.front().position_mm)
                                 : 0);
  }
  points.first.push_back(points.voxel.size());
  return points;
}

std::vector<std::uint32_t> nearest_points(const VesselTrees& trees, const TreePoints& points, const Organ& organ,
                                          const imaging::LabelMap& territory) {
  std::vector<Eigen::Matrix3Xf> places;
  for (const TreeBranch& branch : trees.branches) {
    Eigen::Matrix3Xf& place = places.emplace_back(3, static_cast<Eigen::Index>(branch.points.size()));
    for (std::size_t p = 0; p < branch.points.size(); ++p) {
      place.col(static_cast<Eigen::Index>(p)) = branch.points[p].position_mm.cast<float>();
    }
  }
  std::vector<std::uint32_t> nearest(organ.voxels, static_cast<std::uint32_t>(points.count()));
  parallel_for(organ.runs.size(), 256, [&](std::size_t begin, std::size_t end) {
    // Runs are in order, so that the place of a number follows from the run it is in.
    std::size_t r = begin;
    sample(organ, territory, begin, end, [&](std::size_t voxel, std::uint16_t value) {
      if (value == 0 || value > places.size() || places[value - 1U].cols() == 0) return;
      while (voxel >= organ.runs[r].first + static_cast<std::size_t>(organ.runs[r].length)) ++r;
      const Run& run = organ.runs[r];
      const Eigen::Vector3f at =
          organ.grid.position_mm(run.i + static_cast<int>(voxel - run.first), run.j, run.k).cast<float>();
      const Eigen::Matrix3Xf& place = places[value - 1U];
      std::uint32_t best = 0;
      float best_mm2 = std::numeric_limits<float>::infinity();
      for (Eigen::Index p = 0; p < place.cols(); ++p) {
        const float mm2 = (place.col(p) - at).squaredNorm();
        if (mm2 < best_mm2) best_mm2 = mm2, best = static_cast<std::uint32_t>(p);
      }
      nearest[voxel] = static_cast<std::uint32_t>(points.first[value - 1U]) + best;
    });
  });
  return nearest;
}

// Parents stand before their branches.
std::vector<std::size_t> sum_beyond(const VesselTrees& trees, const TreePoints& points,
                                    const std::vector<std::size_t>& at_points) {
  std::vector<std::size_t> beyond = at_points;
  for (std::size_t b = trees.branches.size(); b-- > 0;) {
    for (std::size_t p = points.first[b + 1]; p-- > points.first[b] + 1;) beyond[p - 1] += beyond[p];
    const int parent = trees.branches[b].parent;
    if (parent < 0 || points.first[b] == points.first[b + 1]) continue;
    const std::size_t joint = points.first[static_cast<std::size_t>(parent)] + points.joint[b];
    if (joint < points.first[static_cast<std::size_t>(parent) + 1]) beyond[joint] += beyond[points.first[b]];
  }
  return beyond;
}

CutOff cut_off(const VesselTrees& trees, const TreePoints& points, const std::function<bool(std::size_t)>& is_cut) {
  CutOff off{std::vector<std::int32_t>(points.count() + 1, -1), {}};
  for (std::size_t b = 0; b < trees.branches.size(); ++b) {
    const TreeBranch& branch = trees.branches[b];
    const auto begin = off.cause.begin() + static_cast<std::ptrdiff_t>(points.first[b]);
    const auto end = off.cause.begin() + static_cast<std::ptrdiff_t>(points.first[b + 1]);
    if (begin == end) continue;
    if (branch.parent >= 0) {
      const auto parent = static_cast<std::size_t>(branch.parent);
      const std::size_t joint = points.first[parent] + points.joint[b];
      if (joint < points.first[parent + 1] && off.cause[joint] >= 0) {
        std::fill(begin, end, off.cause[joint]);
        continue;
      }
    }
    for (auto point = begin; point != end; ++point) {
      const auto number = static_cast<std::size_t>(point - off.cause.begin());
      if (!is_cut(number)) continue;
      std::fill(point, end, static_cast<std::int32_t>(off.cut.size()));
      off.cut.push_back({b, number - points.first[b]});
      break;
    }
  }
  return off;
}

}  // namespace glisson::planning

#include "known_trees.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "anatomy/random.h"
#include "base/noise.h"
#include "segmentation/rasterise.h"

namespace glisson::test {
namespace {

using anatomy::Patient;
using anatomy::VesselNode;
using anatomy::VesselTree;
using Eigen::Vector3d;

constexpr double in_mask_mm = 1;    // thinner vessels are not in the mask
constexpr double calibre_mm = 1.5;  // radius of the branches that count

// A millimetre or so of a known vessel.
struct Sample {
  Vector3d position_mm;
  double radius_mm;
  int system, branch, generation;
  Vector3d along;
};

// Samples of both trees, and of each branch the one before.
struct Truth {
  std::vector<Sample> samples;
  std::array<std::vector<int>, 2> before;
  std::array<std::vector<anatomy::VesselBranch>, 2> branches;

  explicit Truth(const Patient& patient) {
    for (const int system : {0, 1}) {
      const VesselTree& tree = system == 0 ? patient.portal_vein : patient.hepatic_vein;
      const auto s = static_cast<std::size_t>(system);
      branches[s] = branches_of(tree);
      std::vector<int> branch_of(tree.nodes.size(), -1);
      for (std::size_t b = 0; b < branches[s].size(); ++b) {
        const int first = branches[s][b].nodes.front();
        before[s].push_back(branch_of[static_cast<std::size_t>(tree.nodes[static_cast<std::size_t>(first)].parent)]);
        for (const int n : branches[s][b].nodes) {
          branch_of[static_cast<std::size_t>(n)] = static_cast<int>(b);
          const VesselNode& node = tree.nodes[static_cast<std::size_t>(n)];
          if (node.radius_mm < in_mask_mm) continue;
          const Vector3d from = tree.nodes[static_cast<std::size_t>(node.parent)].position_mm;
          const Vector3d way = node.position_mm - from;
          const int steps = std::max(1, static_cast<int>(way.norm()));
          for (int i = 0; i < steps; ++i) {
            samples.push_back({from + (i + 0.5) / steps * way, node.radius_mm, system, static_cast<int>(b),
                               node.generation, way.normalized()});
          }
        }
      }
    }
  }

  [[nodiscard]] const Sample& nearest(const Vector3d& position_mm) const {
    const Sample* best = &samples.front();
    double nearest_mm = 1e30;
    for (const Sample& sample : samples) {
      const double beyond = (sample.position_mm - position_mm).norm() - sample.radius_mm;
      if (beyond < nearest_mm) {
        nearest_mm = beyond;
        best = &sample;
      }
    }
    return *best;
  }
  [[nodiscard]] bool leads_to(int system, int above, int below) const {
    for (int b = below; b >= 0; b = before[static_cast<std::size_t>(system)][static_cast<std::size_t>(b)]) {
      if (b == above) return true;
    }
    return false;
  }
};

template <typename Change>
void for_box(const imaging::Grid& grid, const Vector3d& center_mm, double reach_mm, const Change& change) {
  const Vector3d at = grid.index_of(center_mm);
  std::array<int, 3> low{}, high{};
  for (int a = 0; a < 3; ++a) {
    const double reach = reach_mm / grid.spacing_mm[a];
    low[static_cast<std::size_t>(a)] = std::max(0, static_cast<int>(at[a] - reach));
    high[static_cast<std::size_t>(a)] =
        std::min(grid.size[static_cast<std::size_t>(a)] - 1, static_cast<int>(at[a] + reach) + 1);
  }
  for (int k = low[2]; k <= high[2]; ++k) {
    for (int j = low[1]; j <= high[1]; ++j) {
      for (int i = low[0]; i <= high[0]; ++i) change(grid.offset(i, j, k), grid.position_mm(i, j, k));
    }
  }
}

void cut_gaps(imaging::Mask& vessels, const std::vector<Sample>& samples, int gaps, anatomy::Random& random) {
  const double half_mm = 1.5 * vessels.grid.spacing_mm.x();
  for (int tries = 0; gaps > 0 && tries < 10000; ++tries) {
    const Sample& sample = samples[static_cast<std::size_t>(random.uniform() * static_cast<double>(samples.size()))];
    if (sample.radius_mm < 1 || sample.radius_mm > 2.5) continue;
    for_box(vessels.grid, sample.position_mm, sample.radius_mm + 2, [&](std::size_t voxel, const Vector3d& p) {
      const Vector3d way = p - sample.position_mm;
      if (std::abs(way.dot(sample.along)) <= half_mm && way.norm() < sample.radius_mm + 1.5) vessels.values[voxel] = 0;
    });
    --gaps;
  }
}

// Where portal and hepatic walls are less than 2.5 mm apart, thick vessels first, 15 mm from one another at least.
void grow_together(imaging::Mask& vessels, const std::vector<Sample>& samples, int touches) {
  std::vector<std::tuple<double, Vector3d, Vector3d>> near;
  for (const Sample& a : samples) {
    if (a.system != 0) continue;
    for (const Sample& b : samples) {
      if (b.system != 1) continue;
      const double apart = (a.position_mm - b.position_mm).norm() - a.radius_mm - b.radius_mm;
      if (apart < 2.5) near.emplace_back(std::min(a.radius_mm, b.radius_mm), a.position_mm, b.position_mm);
    }
  }
  std::stable_sort(near.begin(), near.end(),
                   [](const auto& a, const auto& b) { return std::get<0>(a) > std::get<0>(b); });
  std::vector<Vector3d> done;
  for (const auto& [radius, from, to] : near) {
    if (touches == 0) return;
    const Vector3d middle = 0.5 * (from + to);
    if (std::any_of(done.begin(), done.end(), [&](const Vector3d& p) { return (p - middle).norm() < 15; })) continue;
    done.push_back(middle);
    --touches;
    for_box(vessels.grid, middle, 0.5 * (to - from).norm() + 2,
            [&, from = from, way = Vector3d(to - from), wide = 0.7 * radius](std::size_t voxel, const Vector3d& p) {
              const double t = std::clamp((p - from).dot(way) / way.squaredNorm(), 0.0, 1.0);
              if ((p - from - t * way).norm() <= wide) vessels.values[voxel] = 1;
            });
  }
}

}  // namespace

KnownVessels make_known_vessels(std::uint64_t seed, const Damage& damage, double spacing_mm) {
  anatomy::PatientOptions options;
  options.seed = seed;
  options.arterial_terminals = 10;
  KnownVessels known{anatomy::make_patient(options).value(), {}, {}};
  const geometry::Box box = geometry::bounding_box(known.patient.liver->surface.points_mm);
  const Vector3d border = Vector3d::Constant(3);
  const imaging::Grid grid = anatomy::grid_over({box.min_mm - border, box.max_mm + border}, spacing_mm);
  known.liver = segmentation::rasterise(known.patient.liver->surface, grid);
  const anatomy::Field portal = tree_field(known.patient.portal_vein, grid, in_mask_mm);
  const anatomy::Field hepatic = tree_field(known.patient.hepatic_vein, grid, in_mask_mm);
  known.vessels = {grid, std::vector<std::uint8_t>(grid.voxels(), 0)};
  anatomy::Random random(mixed(seed, 77));
  for (std::size_t i = 0; i < known.vessels.values.size(); ++i) {
    const double wall = std::min(portal.values[i], hepatic.values[i]);
    if (wall > 4 || known.liver.values[i] == 0) continue;
    known.vessels.values[i] = wall + damage.noise_mm * random.bell() < 0 ? 1 : 0;
  }
  const Truth truth(known.patient);
  grow_together(known.vessels, truth.samples, damage.touches);
  cut_gaps(known.vessels, truth.samples, damage.gaps, random);
  return known;
}

TreeScore score_of(const vasculature::VesselTrees& trees, const Patient& patient) {
  const Truth truth(patient);
  TreeScore score;
  // What was found of each known branch, and its radii.
  std::array<std::vector<std::array<int, 2>>, 2> of_branch;
  for (std::size_t s = 0; s < 2; ++s) of_branch[s].resize(truth.branches[s].size());
  std::vector<double> errors;
  for (const Sample& sample : truth.samples) {
    if (sample.radius_mm < calibre_mm || patient.liver->depth_mm(sample.position_mm) < 2) continue;
    double nearest_mm = 1e30, radius = 0;
    for (const vasculature::TreeBranch& branch : trees.branches) {
      if (branch.joint == vasculature::Joint::contact) continue;
      for (const vasculature::CenterPoint& point : branch.points) {
        const double away = (point.position_mm - sample.position_mm).norm();
        if (away < nearest_mm) {
          nearest_mm = away;
          radius = point.radius_mm;
        }
      }
    }
    auto& counts = of_branch[static_cast<std::size_t>(sample.system)][static_cast<std::size_t>(sample.branch)];
    ++counts[0];
    if (nearest_mm > std::max(1.5, 0.8 * sample.radius_mm)) continue;
    ++counts[1];
    errors.push_back(std::abs(radius - sample.radius_mm));
  }
  for (const auto& counts : of_branch) {
    for (const auto& [all, found] : counts) {
      if (all == 0) continue;
      ++score.branches;
      if (found >= 0.7 * all) ++score.found;
    }
  }
  if (!errors.empty()) {
    score.radius_within_half_mm =
        static_cast<double>(std::count_if(errors.begin(), errors.end(), [](double e) { return e <= 0.5; })) /
        static_cast<double>(errors.size());
    std::nth_element(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2), errors.end());
    score.radius_error_mm = errors[errors.size() / 2];
  }

  double length = 0, right = 0, doubtful = 0;
  std::vector<const Sample*> middle;
  for (const vasculature::TreeBranch& branch : trees.branches) {
    middle.push_back(&truth.nearest(branch.points[branch.points.size() / 2].position_mm));
    if (branch.joint != vasculature::Joint::vessel) continue;
    for (std::size_t i = 1; i < branch.points.size(); ++i) {
      const Vector3d a = branch.points[i - 1].position_mm, b = branch.points[i].position_mm;
      length += (b - a).norm();
      const bool is_right = truth.nearest(0.5 * (a + b)).system == static_cast<int>(branch.system);
      (is_right ? right : doubtful) += is_right || branch.confidence < 0.8 ? (b - a).norm() : 0;
    }
  }
  score.system_right = length > 0 ? right / length : 0;
  score.marked_doubtful = length > right ? doubtful / (length - right) : 1;
  for (std::size_t b = 0; b < trees.branches.size(); ++b) {
    int parent = trees.branches[b].parent;
    while (parent >= 0 && trees.branches[static_cast<std::size_t>(parent)].joint != vasculature::Joint::vessel) {
      parent = trees.branches[static_cast<std::size_t>(parent)].parent;
    }
    if (parent < 0 || trees.branches[b].joint != vasculature::Joint::vessel) continue;
    const Sample &child = *middle[b], &above = *middle[static_cast<std::size_t>(parent)];
    ++score.joins;
    if (child.system != above.system || !truth.leads_to(child.system, above.branch, child.branch)) ++score.wrong_joins;
  }
  return score;
}

}  // namespace glisson::test

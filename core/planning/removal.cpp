#include "planning/internal/removal.h"

#include <fmt/format.h>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "base/parallel.h"

namespace glisson::planning {
namespace {

using Eigen::Vector3d;
using geometry::CutSurface;

// Sets `above` to 1 where the height is positive; how many that are.
std::size_t mark_above_plane(const CutSurface& plane, const Organ& organ, std::vector<std::uint8_t>& above);
std::size_t mark_above_sheet(const CutSurface& sheet, const Organ& organ, const HeightNodes& nodes,
                             std::vector<std::uint8_t>& above);

class Taking {
 public:
  Taking(const Cuttable& liver, Removal& removal) : liver_(liver), removal_(removal) {}

  Result<void> operator()(const PlaneCut& cut) {
    auto surface = CutSurface::plane(cut.point_mm, cut.normal);
    if (!surface) return failure(std::move(surface.error()));
    return take_side(*std::move(surface), cut.removed);
  }
  Result<void> operator()(const SheetCut& cut) {
    auto surface = CutSurface::through(cut.through_mm);
    if (!surface) return failure(std::move(surface.error()));
    return take_side(*std::move(surface), cut.removed);
  }
  Result<void> operator()(const SegmentsCut& cut);
  Result<void> operator()(const TerritoryCut& cut);
  Result<void> operator()(const MarginCut& cut);
  Result<void> operator()(const AblationCut& cut);

 private:
  Result<void> take_side(CutSurface surface, Removed which);
  template <typename Taken>
  std::size_t take_where(std::uint8_t why, const Taken& taken);

  const Cuttable& liver_;
  Removal& removal_;
};

}  // namespace

HeightNodes height_nodes(const Organ& organ) {
  constexpr double apart_mm = 4;
  HeightNodes nodes;
  for (std::size_t a = 0; a < 3; ++a) {
    const double spacing_mm = organ.grid.spacing_mm[static_cast<Eigen::Index>(a)];
    nodes.step[a] = std::max(1, static_cast<int>(std::lround(apart_mm / spacing_mm)));
    nodes.size[a] = (organ.grid.size[a] - 1) / nodes.step[a] + 2;
  }
  std::vector<std::uint8_t> needed(static_cast<std::size_t>(nodes.size[0]) * static_cast<std::size_t>(nodes.size[1]) *
                                       static_cast<std::size_t>(nodes.size[2]),
                                   0);
  const auto node = [&](int i, int j, int k) {
    return static_cast<std::size_t>(i) +
           static_cast<std::size_t>(nodes.size[0]) *
               (static_cast<std::size_t>(j) + static_cast<std::size_t>(nodes.size[1]) * static_cast<std::size_t>(k));
  };
  for (const Run& run : organ.runs) {
    const int first = run.i / nodes.step[0], last = (run.i + run.length - 1) / nodes.step[0] + 1;
    for (int k = 0; k < 2; ++k) {
      for (int j = 0; j < 2; ++j) {
        for (int i = first; i <= last; ++i) needed[node(i, run.j / nodes.step[1] + j, run.k / nodes.step[2] + k)] = 1;
      }
    }
  }
  for (std::size_t n = 0; n < needed.size(); ++n) {
    if (needed[n] != 0) nodes.needed.push_back(static_cast<std::uint32_t>(n));
  }
  return nodes;
}

Result<Removal> removal_by(const std::vector<Cut>& cuts, const Cuttable& liver) {
  if (cuts.empty()) return failure("plan-empty", GLISSON_TEXT("The plan holds no cut."));
  Removal removal;
  removal.removed.assign(liver.organ.voxels, 0);
  Taking take(liver, removal);
  for (const Cut& cut : cuts) {
    if (auto taken = std::visit(take, cut); !taken) return failure(std::move(taken.error()));
  }
  if (std::find(removal.removed.begin(), removal.removed.end(), 0) == removal.removed.end()) {
    return failure("nothing-left", GLISSON_TEXT("The plan takes the whole liver: nothing would be left."));
  }
  removal.ablated =
      static_cast<std::size_t>(std::count(removal.removed.begin(), removal.removed.end(), goes_by_ablation));
  return removal;
}

namespace {

template <typename Taken>
std::size_t Taking::take_where(std::uint8_t why, const Taken& taken) {
  std::atomic<std::size_t> count = 0;
  parallel_for(liver_.organ.voxels, 1 << 16, [&](std::size_t begin, std::size_t end) {
    std::size_t here = 0;
    for (std::size_t v = begin; v < end; ++v) {
      const bool goes = taken(v);
      removal_.removed[v] |= goes ? why : std::uint8_t{0};
      here += goes ? 1 : 0;
    }
    count += here;
  });
  return count;
}

Result<void> Taking::take_side(CutSurface surface, Removed which) {
  std::vector<std::uint8_t> above(liver_.organ.voxels);
  const std::size_t count = surface.is_plane() ? mark_above_plane(surface, liver_.organ, above)
                                               : mark_above_sheet(surface, liver_.organ, liver_.nodes, above);
  if (count == 0 || count == liver_.organ.voxels) {
    return failure(Error{"cut-misses",
                         GLISSON_TEXT("The cut passes the liver by."),
                         {},
                         GLISSON_TEXT("Move it through the liver; positions are patient coordinates (LPS, mm)."),
                         {}});
  }
  const bool above_is_smaller = 2 * count <= liver_.organ.voxels;
  const bool above_goes = which == Removed::above || which == (above_is_smaller ? Removed::smaller : Removed::larger);
  const auto wanted = static_cast<std::uint8_t>(above_goes);
  take_where(goes_with_vessels, [&](std::size_t v) { return above[v] == wanted; });
  removal_.cuts.push_back({std::move(surface), above_goes ? 1.0 : -1.0, {}, 0});
  return {};
}

Result<void> Taking::operator()(const SegmentsCut& cut) {
  if (!liver_.has_segments) {
    return failure(Error{"segments-missing",
                         GLISSON_TEXT("The liver's segments are not known yet."),
                         {},
                         GLISSON_TEXT("Find them first (glisson-cli territories)."),
                         {}});
  }
  if (cut.segments.empty()) {
    return failure("plan-empty", GLISSON_TEXT("The plan names no segment to take: give numbers from 1 to 8."));
  }
  std::array<bool, 9> goes{};
  for (const int segment : cut.segments) {
    if (segment < 1 || segment > 8) {
      return failure("segment-unknown", GLISSON_TEXT("There is no segment {0}: Couinaud's are 1 to 8."),
                     {std::to_string(segment)});
    }
    if (std::find(liver_.segment.begin(), liver_.segment.end(), segment) == liver_.segment.end()) {
      return failure("segment-empty", GLISSON_TEXT("Segment {0} holds no tissue of this liver."),
                     {std::to_string(segment)});
    }
    goes.at(static_cast<std::size_t>(segment)) = true;
  }
  take_where(goes_by_anatomy, [&](std::size_t v) { return goes[liver_.segment[v]]; });
  removal_.cuts.emplace_back();
  removal_.along_anatomy = true;
  return {};
}

Result<void> Taking::operator()(const TerritoryCut& cut) {
  std::vector<bool> taken(liver_.trees.branches.size());
  std::optional<vasculature::System> system;
  for (std::size_t b = 0; b < taken.size(); ++b) {
    const vasculature::TreeBranch& branch = liver_.trees.branches[b];
    const bool named = branch.name == cut.branch || branch.name.starts_with(cut.branch + "/");
    const bool grows_there = branch.parent >= 0 && taken[static_cast<std::size_t>(branch.parent)];
    taken[b] = !cut.branch.empty() && (named || grows_there);
    if (taken[b] && !system) system = branch.system;
  }
  if (!system) {
    return failure(Error{"branch-unknown",
                         GLISSON_TEXT("There is no branch {0} in the vessel trees."),
                         {cut.branch},
                         GLISSON_TEXT("glisson-cli vessels lists their names; portal/right/posterior stands for all "
                                      "that begin so."),
                         {}});
  }
  if (!vasculature::is_vein(*system)) {
    return failure(
        Error{"territory-empty",
              GLISSON_TEXT("{0} has no tissue of its own: arteries and bile ducts run with portal branches."),
              {cut.branch},
              GLISSON_TEXT("Take the portal branch beside it."),
              {}});
  }
  std::vector<std::uint8_t> of_point(liver_.points.count() + 1, 0);
  for (std::size_t b = 0; b < taken.size(); ++b) {
    for (std::size_t p = liver_.points.first[b]; p < liver_.points.first[b + 1]; ++p) of_point[p] = taken[b] ? 1 : 0;
  }
  const auto& point = liver_.point.at(static_cast<std::size_t>(*system));
  const std::size_t count =
      point.empty() ? 0 : take_where(goes_by_anatomy, [&](std::size_t v) { return of_point[point[v]] != 0; });
  if (count == 0) {
    return failure(Error{"territory-empty",
                         GLISSON_TEXT("No tissue of the liver belongs to the branch {0}."),
                         {cut.branch},
                         GLISSON_TEXT("Take a branch nearer to the stem."),
                         {}});
  }
  removal_.cuts.emplace_back();
  removal_.along_anatomy = true;
  return {};
}

Result<void> Taking::operator()(const MarginCut& cut) {
  const auto tumour = std::find_if(liver_.tumours.begin(), liver_.tumours.end(),
                                   [&](const TumourSurroundings& one) { return one.name == cut.tumour; });
  if (tumour == liver_.tumours.end() || tumour->voxels.empty()) {
    return failure(Error{"tumour-unknown",
                         GLISSON_TEXT("There is no tumour {0} in the liver."),
                         {cut.tumour},
                         GLISSON_TEXT("Give the name of a structure of the case that lies in the liver."),
                         {}});
  }
  if (!(cut.margin_mm >= 0 && cut.margin_mm <= largest_margin_mm)) {
    return failure("margin-invalid", GLISSON_TEXT("The margin around {0} must be 0 to {1} mm."),
                   {cut.tumour, fmt::format("{:g}", largest_margin_mm)});
  }
  for (const std::uint32_t voxel : tumour->voxels) removal_.removed[voxel] |= goes_with_vessels;
  for (const auto& near : tumour->around) {
    if (near.distance_mm > cut.margin_mm + 0.05) break;  // in order but for a twentieth of a millimetre
    if (near.distance_mm <= cut.margin_mm) removal_.removed[near.voxel] |= goes_with_vessels;
  }
  removal_.cuts.push_back({{}, 1, static_cast<std::size_t>(tumour - liver_.tumours.begin()), cut.margin_mm});
  return {};
}

Result<void> Taking::operator()(const AblationCut& cut) {
  const auto fits = [](double radius_mm) { return radius_mm > 0 && radius_mm <= largest_ablation_mm; };
  if (!fits(cut.radius_along_mm) || !fits(cut.radius_across_mm) || !(cut.direction.norm() > 0) ||
      !cut.direction.allFinite() || !cut.center_mm.allFinite()) {
    return failure("ablation-invalid",
                   GLISSON_TEXT("An ablation needs a direction, and radii of more than 0 and at most {0} mm."),
                   {fmt::format("{:g}", largest_ablation_mm)});
  }
  std::atomic<std::size_t> count = 0;
  parallel_for(liver_.organ.runs.size(), 512, [&](std::size_t begin, std::size_t end) {
    std::size_t here = 0;
    for (std::size_t r = begin; r < end; ++r) {
      const Run& run = liver_.organ.runs[r];
      for (int n = 0; n < run.length; ++n) {
        if (outside_mm(cut, liver_.organ.grid.position_mm(run.i + n, run.j, run.k)) > 0) continue;
        removal_.removed[run.first + static_cast<std::size_t>(n)] |= goes_by_ablation;
        ++here;
      }
    }
    count += here;
  });
  if (count == 0) {
    return failure(Error{"cut-misses",
                         GLISSON_TEXT("The ablation lies beside the liver."),
                         {},
                         GLISSON_TEXT("Move it into the liver; positions are patient coordinates (LPS, mm)."),
                         {}});
  }
  removal_.cuts.push_back({{}, 1, {}, 0, cut});
  return {};
}

std::size_t mark_above_plane(const CutSurface& plane, const Organ& organ, std::vector<std::uint8_t>& above) {
  std::atomic<std::size_t> count = 0;
  const Vector3d step_mm = organ.grid.position_mm(1, 0, 0) - organ.grid.position_mm(0, 0, 0);
  const double rise_mm = plane.normal().dot(step_mm);
  parallel_for(organ.runs.size(), 512, [&](std::size_t begin, std::size_t end) {
    std::size_t here = 0;
    for (std::size_t r = begin; r < end; ++r) {
      const Run& run = organ.runs[r];
      const double start_mm = plane.height_mm(organ.grid.position_mm(run.i, run.j, run.k));
      // Heights change evenly along a run: from one voxel on it is on the other side.
      const double crossing = rise_mm != 0 ? -start_mm / rise_mm : std::numeric_limits<double>::infinity();
      const auto voxel = [&](double n) {
        return static_cast<int>(std::clamp(n, 0.0, static_cast<double>(run.length)));
      };
      const int first = rise_mm > 0 ? voxel(std::floor(crossing) + 1) : 0;
      const int last = rise_mm > 0   ? run.length
                       : rise_mm < 0 ? voxel(std::ceil(crossing))
                                     : static_cast<int>(start_mm > 0) * run.length;
      if (first < last) std::fill_n(above.data() + run.first + first, last - first, std::uint8_t{1});
      here += static_cast<std::size_t>(std::max(0, last - first));
    }
    count += here;
  });
  return count;
}

std::size_t mark_above_sheet(const CutSurface& sheet, const Organ& organ, const HeightNodes& nodes,
                             std::vector<std::uint8_t>& above) {
  const auto row = static_cast<std::size_t>(nodes.size[0]), layer = row * static_cast<std::size_t>(nodes.size[1]);
  std::vector<float> height_mm(layer * static_cast<std::size_t>(nodes.size[2]));
  parallel_for(nodes.needed.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      const std::size_t node = nodes.needed[n];
      const std::size_t i = node % row, j = node % layer / row, k = node / layer;
      const Vector3d index(static_cast<double>(i) * nodes.step[0], static_cast<double>(j) * nodes.step[1],
                           static_cast<double>(k) * nodes.step[2]);
      height_mm[node] = static_cast<float>(sheet.height_mm(organ.grid.position_mm(index)));
    }
  });
  std::atomic<std::size_t> count = 0;
  parallel_for(organ.runs.size(), 512, [&](std::size_t begin, std::size_t end) {
    std::size_t here = 0;
    for (std::size_t r = begin; r < end; ++r) {
      const Run& run = organ.runs[r];
      const int j = run.j / nodes.step[1], k = run.k / nodes.step[2];
      const float v = static_cast<float>(run.j % nodes.step[1]) / static_cast<float>(nodes.step[1]);
      const float w = static_cast<float>(run.k % nodes.step[2]) / static_cast<float>(nodes.step[2]);
      const float* corner = height_mm.data() + static_cast<std::size_t>(j) * row + static_cast<std::size_t>(k) * layer;
      const auto across = [&](int i) {
        const auto at = static_cast<std::size_t>(i);
        return (1 - w) * ((1 - v) * corner[at] + v * corner[at + row]) +
               w * ((1 - v) * corner[at + layer] + v * corner[at + row + layer]);
      };
      std::uint8_t* out = above.data() + run.first;
      for (int n = 0; n < run.length;) {
        const int i = (run.i + n) / nodes.step[0], begins = i * nodes.step[0];
        const float from = across(i), rise = (across(i + 1) - from) / static_cast<float>(nodes.step[0]);
        const int stop = std::min(run.length, begins + nodes.step[0] - run.i);
        for (; n < stop; ++n) {
          out[n] = static_cast<std::uint8_t>(from + static_cast<float>(run.i + n - begins) * rise > 0);
          here += out[n];
        }
      }
    }
    count += here;
  });
  return count;
}

}  // namespace
}  // namespace glisson::planning

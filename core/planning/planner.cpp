#include "planning/planner.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

#include "base/parallel.h"
#include "planning/internal/margin_to_cut.h"
#include "planning/internal/removal.h"
#include "planning/internal/tissue_counts.h"
#include "planning/internal/unrolled.h"

namespace glisson::planning {

struct Planner::Liver {
  Organ organ;
  HeightNodes nodes;
  vasculature::VesselTrees trees;
  TreePoints points;
  std::array<bool, 2> has_system{};  // portal, hepatic: its territories are known
  std::vector<TumourSurroundings> tumours;
  bool has_segments = false;

  // Of each voxel.
  std::vector<std::uint8_t> segment, tumour;         // 0: none; tumour + 1
  std::array<std::vector<std::uint32_t>, 2> point;   // that it hangs on; points.count(): none
  std::vector<float> trusted_kPa;                    // 0 where it is not to be trusted, and in tumours; empty: no map
  std::array<std::vector<std::uint32_t>, 2> tissue;  // how many voxels hang on each point
  std::vector<Stretch> stretches;                    // all voxels, in order

  [[nodiscard]] Cuttable cuttable() const {
    return {organ, nodes, segment, has_segments, trees, points, point, tumours};
  }
  // Which vessels are cut, and what hangs on them. A cut along the anatomy spares a vessel that only runs through: one
  // of which less than half of what hangs on it goes. On an artery or a bile duct hangs its own length.
  [[nodiscard]] CutOff cut_off_by(const Removal& removal) const;
  [[nodiscard]] PlanAnswer answer_to(const Removal& removal, const CutOff& off) const;
  void add_lengths(const Removal& removal, const CutOff& off, std::vector<CutBranch>& cut) const;
  [[nodiscard]] std::vector<std::size_t> removed_on(const Removal& removal) const;  // voxels of each point
  [[nodiscard]] float youngs_at(std::size_t voxel) const { return trusted_kPa.empty() ? 0.0F : trusted_kPa[voxel]; }
};

namespace {

// What of that segment goes and stays; nothing where it is empty.
void add_segment(int number, const Counts& counts, double voxel_ml, PlanAnswer& answer);

// The liver's outline and its tumours, which outlines often leave out.
imaging::Mask organ_mask(const LiverParts& parts);

}  // namespace

const char* side_name(Side side) {
  switch (side) {
    case Side::removed: return "removed";
    case Side::left: return "left";
    case Side::cut_through: return "cut-through";
  }
  return "";
}

std::optional<BeyondCut> beyond_cut(const CutBranch& cut, vasculature::System system) {
  const bool vein = vasculature::is_vein(system);
  const BeyondCut told =
      vein ? BeyondCut{cut.beyond_ml, cut.affected_ml, "ml"} : BeyondCut{cut.beyond_mm, cut.left_mm, "mm"};
  return told.beyond >= (vein ? 1 : 10) ? std::optional(told) : std::nullopt;
}

double PlanAnswer::remnant_percent() const {
  return functional_ml() > 0 ? 100 * functional_remnant_ml / functional_ml() : 0;
}

double PlanAnswer::living_percent() const {
  return functional_ml() > 0 ? 100 * living_ml.value_or(functional_remnant_ml) / functional_ml() : 0;
}

Result<Planner> Planner::open(const LiverParts& parts, const Progress& progress) {
  progress.report(0, GLISSON_TEXT("looking at the liver"));
  if (parts.tumours.size() > 255) {
    return failure("plan-too-many-tumours", GLISSON_TEXT("A plan takes at most 255 tumours; there are {0}."),
                   {std::to_string(parts.tumours.size())});
  }
  const auto liver = std::make_shared<Liver>();
  liver->organ = organ_of(organ_mask(parts));
  const Organ& organ = liver->organ;
  if (organ.voxels == 0) return failure("liver-empty", GLISSON_TEXT("The liver's outline is empty."));
  liver->nodes = height_nodes(organ);
  const std::vector<std::int32_t> numbers = numbers_in(organ);
  liver->trees = parts.trees;
  liver->points = points_of(liver->trees, organ, numbers);

  progress.report(0.2, GLISSON_TEXT("looking what hangs on which vessel"));
  const std::array<const std::optional<imaging::LabelMap>*, 2> territories{&parts.portal, &parts.hepatic};
  for (std::size_t s = 0; s < 2; ++s) {
    liver->has_system[s] = territories[s]->has_value();
    if (!liver->has_system[s]) continue;
    liver->point[s] = nearest_points(liver->trees, liver->points, organ, **territories[s]);
    liver->tissue[s].assign(liver->points.count() + 1, 0);
    for (const std::uint32_t point : liver->point[s]) ++liver->tissue[s][point];
  }
  if (progress.cancelled()) return cancelled();

  progress.report(0.5, GLISSON_TEXT("looking at segments and stiffness"));
  liver->segment.assign(organ.voxels, 0);
  if (parts.segments) {
    liver->has_segments = true;
    parallel_for(organ.runs.size(), 512, [&](std::size_t begin, std::size_t end) {
      sample(organ, *parts.segments, begin, end, [&](std::size_t voxel, std::uint16_t value) {
        liver->segment[voxel] = value <= 8 ? static_cast<std::uint8_t>(value) : std::uint8_t{0};
      });
    });
  }
  if (parts.youngs_kPa) {
    liver->trusted_kPa.assign(organ.voxels, 0);
    parallel_for(organ.runs.size(), 512, [&](std::size_t begin, std::size_t end) {
      sample(organ, *parts.youngs_kPa, begin, end, [&](std::size_t voxel, float value) {
        if (std::isfinite(value) && value > 0) liver->trusted_kPa[voxel] = value;
      });
    });
  }

  liver->tumour.assign(organ.voxels, 0);
  for (std::size_t t = 0; t < parts.tumours.size(); ++t) {
    progress.report(0.6 + 0.4 * static_cast<double>(t) / static_cast<double>(parts.tumours.size()),
                    GLISSON_TEXT("looking around the tumours"));
    if (progress.cancelled()) return cancelled();
    liver->tumours.push_back(surroundings_of(parts.tumours[t].name, parts.tumours[t].mask, organ, numbers));
    for (const std::uint32_t voxel : liver->tumours.back().voxels) {
      liver->tumour[voxel] = static_cast<std::uint8_t>(t + 1);
      if (!liver->trusted_kPa.empty()) liver->trusted_kPa[voxel] = 0;
    }
  }
  liver->stretches =
      stretches_of({liver->segment, liver->tumour, liver->point, liver->trusted_kPa, liver->points.count()});
  progress.report(1, GLISSON_TEXT("done"));
  return Planner(liver);
}

Result<PlanAnswer> Planner::answer(const std::vector<Cut>& cuts) const {
  const auto removal = removal_by(cuts, liver_->cuttable());
  if (!removal) return failure(removal.error());
  return liver_->answer_to(*removal, liver_->cut_off_by(*removal));
}

Result<Planner::Unrolled> Planner::answer_unrolled(const std::vector<Cut>& cuts, double step_mm) const {
  const auto removal = removal_by(cuts, liver_->cuttable());
  if (!removal) return failure(removal.error());
  const CutOff off = liver_->cut_off_by(*removal);
  return Unrolled{liver_->answer_to(*removal, off),
                  unrolled(removal->cuts, off, {liver_->organ, liver_->tumours, liver_->trees}, step_mm)};
}

PlanAnswer Planner::Liver::answer_to(const Removal& removal, const CutOff& off) const {
  const double voxel_ml = organ.voxel_ml();
  const Counts counts = counted(stretches, removal.removed, off, trusted_kPa);
  using Key = Counts::Key;
  const auto ml = [&](auto asked) { return static_cast<double>(counts.of(asked)) * voxel_ml; };
  PlanAnswer answer;
  answer.liver_ml = static_cast<double>(organ.voxels) * voxel_ml;
  answer.tumours_ml = ml([](const Key& key) { return key.tumour; });
  answer.removed_ml = ml([](const Key& key) { return key.removed; });
  answer.remnant_ml = ml([](const Key& key) { return !key.removed; });
  answer.ablated_ml = static_cast<double>(removal.ablated) * voxel_ml;
  if (has_system[0]) {
    answer.ischaemic_ml = ml([](const Key& key) { return key.starved; });
    answer.perfused_ml = answer.remnant_ml - *answer.ischaemic_ml;
  }
  if (has_system[1]) {
    answer.congested_ml = ml([](const Key& key) { return key.held_up; });
    answer.drained_ml = answer.remnant_ml - *answer.congested_ml;
  }
  if (has_system[0] && has_system[1]) {
    answer.living_ml = ml([](const Key& key) { return !key.removed && !key.starved && !key.held_up; });
  }
  TissueSum left{counts.of([](const Key& key) { return !key.removed && !key.tumour; }), 0, 0};
  for (std::size_t s = 0; s < segments_and_none; ++s) {
    left.kPa += counts.kPa[s];
    left.trusted += counts.trusted[s];
    if (s != 0) add_segment(static_cast<int>(s), counts, voxel_ml, answer);
  }
  answer.left = left.tissue(voxel_ml);
  answer.functional_remnant_ml = answer.left.ml;

  for (std::size_t c = 0; c < off.cut.size(); ++c) {
    const auto& at = trees.branches[off.cut[c].branch].points[off.cut[c].point];
    answer.branches.push_back(
        {off.cut[c].branch, at.position_mm, at.radius_mm, 0, static_cast<double>(counts.affected[c]) * voxel_ml});
  }
  for (const auto& tissue_at : tissue) {
    for (std::size_t p = 0; p + 1 < tissue_at.size(); ++p) {
      if (off.cause[p] >= 0)
        answer.branches[static_cast<std::size_t>(off.cause[p])].beyond_ml += tissue_at[p] * voxel_ml;
    }
  }
  add_lengths(removal, off, answer.branches);
  std::stable_sort(answer.branches.begin(), answer.branches.end(), [](const CutBranch& a, const CutBranch& b) {
    return std::pair(a.beyond_ml, a.beyond_mm) > std::pair(b.beyond_ml, b.beyond_mm);
  });

  for (std::size_t t = 0; t < tumours.size(); ++t) {
    answer.tumours.push_back(margin_to_cut(t, removal, organ, tumours));
    const MarginAnswer& margin = answer.tumours.back();
    if (margin.side == Side::left || (answer.margin_mm && *answer.margin_mm <= margin.margin_mm)) continue;
    answer.margin_mm = margin.margin_mm;
    answer.margin_is_at_least = margin.is_at_least;
  }
  return answer;
}

// Between two points beside each other that both hang on the cut; the farther one says whether it stays.
void Planner::Liver::add_lengths(const Removal& removal, const CutOff& off, std::vector<CutBranch>& cut) const {
  for (std::size_t b = 0; b < trees.branches.size(); ++b) {
    const auto& branch_points = trees.branches[b].points;
    for (std::size_t p = 1; p < branch_points.size(); ++p) {
      const std::size_t number = points.first[b] + p;
      const std::int32_t voxel = points.voxel[number], cause = off.cause[number - 1];
      if (voxel < 0 || cause < 0) continue;
      const double mm = (branch_points[p].position_mm - branch_points[p - 1].position_mm).norm();
      CutBranch& at = cut[static_cast<std::size_t>(cause)];
      at.beyond_mm += mm;
      if (removal.removed[static_cast<std::size_t>(voxel)] == 0) at.left_mm += mm;
    }
  }
}

CutOff Planner::Liver::cut_off_by(const Removal& removal) const {
  std::vector<std::size_t> all, gone;  // what hangs on each point, and what of that goes
  if (removal.along_anatomy) {
    all.assign(points.count() + 1, 0);
    for (const auto& of_system : tissue) {
      for (std::size_t p = 0; p < of_system.size(); ++p) all[p] += of_system[p];
    }
    gone = removed_on(removal);
    for (std::size_t b = 0; b < trees.branches.size(); ++b) {
      if (vasculature::is_vein(trees.branches[b].system)) continue;
      for (std::size_t p = points.first[b]; p < points.first[b + 1]; ++p) {  // about one a millimetre
        const std::int32_t voxel = points.voxel[p];
        all[p] = voxel >= 0 ? 1 : 0;
        gone[p] = voxel >= 0 && removal.removed[static_cast<std::size_t>(voxel)] != 0 ? 1 : 0;
      }
    }
    all = sum_beyond(trees, points, all);
    gone = sum_beyond(trees, points, gone);
  }
  return cut_off(trees, points, [&](std::size_t number) {
    const std::int32_t voxel = points.voxel[number];
    const std::uint8_t why = voxel < 0 ? std::uint8_t{0} : removal.removed[static_cast<std::size_t>(voxel)];
    if ((why & goes_with_vessels) != 0) return true;
    if ((why & goes_by_ablation) != 0 && 2 * points.radius_mm[number] < ablation_spares_vessels_mm) return true;
    return (why & goes_by_anatomy) != 0 && all[number] > 0 && 2 * gone[number] >= all[number];
  });
}

std::vector<std::size_t> Planner::Liver::removed_on(const Removal& removal) const {
  std::vector<std::size_t> on_point(points.count() + 1, 0);
  for (std::size_t s = 0; s < 2; ++s) {
    if (!has_system[s]) continue;
    std::mutex adding;
    parallel_for(organ.voxels, 1 << 16, [&](std::size_t begin, std::size_t end) {
      std::vector<std::uint32_t> here(on_point.size(), 0);
      for (std::size_t v = begin; v < end; ++v) here[point[s][v]] += removal.removed[v] != 0 ? 1 : 0;
      const std::lock_guard lock(adding);
      for (std::size_t p = 0; p < on_point.size(); ++p) on_point[p] += here[p];
    });
  }
  return on_point;
}

Result<imaging::Mask> Planner::parts(const std::vector<Cut>& cuts) const {
  const Organ& organ = liver_->organ;
  const auto removal = removal_by(cuts, liver_->cuttable());
  if (!removal) return failure(removal.error());
  imaging::Mask mask{organ.grid, std::vector<std::uint8_t>(organ.grid.voxels(), 0)};
  for (const Run& run : organ.runs) {
    const std::uint8_t* from = removal->removed.data() + run.first;
    std::transform(from, from + run.length, mask.values.data() + organ.grid.offset(run.i, run.j, run.k),
                   [](std::uint8_t goes) { return static_cast<std::uint8_t>(goes != 0 ? 2 : 1); });
  }
  return mask;
}

const vasculature::VesselTrees& Planner::trees() const { return liver_->trees; }

std::vector<std::string> Planner::tumours() const {
  std::vector<std::string> names;
  for (const TumourSurroundings& tumour : liver_->tumours) {
    if (!tumour.voxels.empty()) names.push_back(tumour.name);
  }
  return names;
}

double Planner::tumours_ml() const {
  const std::vector<std::uint8_t>& tumour = liver_->tumour;
  const auto healthy = std::count(tumour.begin(), tumour.end(), std::uint8_t{0});
  return static_cast<double>(tumour.size() - static_cast<std::size_t>(healthy)) * liver_->organ.voxel_ml();
}

std::array<Tissue, 9> Planner::segments() const {
  std::array<TissueSum, 9> sums;
  for (std::size_t v = 0; v < liver_->organ.voxels; ++v) {
    if (liver_->tumour[v] != 0) continue;
    const float kPa = liver_->youngs_at(v);
    sums[0].add(kPa);
    if (liver_->segment[v] != 0) sums.at(liver_->segment[v]).add(kPa);
  }
  std::array<Tissue, 9> made;
  for (std::size_t s = 0; s < 9; ++s) made[s] = sums[s].tissue(liver_->organ.voxel_ml());
  return made;
}

std::vector<Tissue> Planner::branches() const {
  const std::size_t count = liver_->trees.branches.size();
  std::vector<std::uint32_t> branch_of(liver_->points.count());
  for (std::size_t b = 0; b < count; ++b) {
    for (std::size_t p = liver_->points.first[b]; p < liver_->points.first[b + 1]; ++p) {
      branch_of[p] = static_cast<std::uint32_t>(b);
    }
  }
  std::vector<TissueSum> sums(count);
  for (const auto& points : liver_->point) {
    for (std::size_t v = 0; v < points.size(); ++v) {
      if (points[v] >= branch_of.size() || liver_->tumour[v] != 0) continue;
      sums[branch_of[points[v]]].add(liver_->youngs_at(v));
    }
  }
  std::vector<Tissue> made;
  for (const TissueSum& sum : sums) made.push_back(sum.tissue(liver_->organ.voxel_ml()));
  return made;
}

namespace {

imaging::Mask organ_mask(const LiverParts& parts) {
  imaging::Mask organ = parts.liver;
  for (const NamedTumour& tumour : parts.tumours) {
    if (!imaging::same_grid(tumour.mask.grid, organ.grid)) continue;
    for (std::size_t v = 0; v < organ.values.size(); ++v) organ.values[v] |= tumour.mask.values[v] != 0 ? 1 : 0;
  }
  return organ;
}

void add_segment(int number, const Counts& counts, double voxel_ml, PlanAnswer& answer) {
  using Key = Counts::Key;
  const auto s = static_cast<std::size_t>(number);
  const auto healthy = [&](const Key& key) { return key.segment == s && !key.tumour; };
  const std::size_t removed = counts.of([&](const Key& key) { return healthy(key) && key.removed; });
  const TissueSum left{counts.of([&](const Key& key) { return healthy(key) && !key.removed; }), counts.trusted[s],
                       counts.kPa[s]};
  if (left.voxels + removed == 0) return;
  const std::size_t living =
      counts.of([&](const Key& key) { return healthy(key) && !key.removed && !key.starved && !key.held_up; });
  answer.segments.push_back(
      {number, static_cast<double>(removed) * voxel_ml, left.tissue(voxel_ml), static_cast<double>(living) * voxel_ml});
}

}  // namespace
}  // namespace glisson::planning

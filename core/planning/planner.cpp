#include "planning/planner.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

#include "base/parallel.h"
#include "planning/internal/removal.h"

namespace glisson::planning {

using Eigen::Vector3d;

// Voxels one after the other that hang on the same points and are of the same segment: counted at once where none goes.
struct Stretch {
  std::uint32_t first = 0;  // the number of its first voxel
  std::array<std::uint32_t, 2> point{};
  std::uint16_t voxels = 0, trusted = 0;
  float kPa = 0;           // summed
  std::uint8_t place = 0;  // in Counts::voxels, of what no cut changes
};

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
  // of which less than half of what hangs on it goes.
  [[nodiscard]] CutOff cut_off_by(const Removal& removal) const;
  [[nodiscard]] float youngs_at(std::size_t voxel) const { return trusted_kPa.empty() ? 0.0F : trusted_kPa[voxel]; }
};

namespace {

constexpr std::size_t segments_and_none = 9;

// Voxels counted by segment, tumour, removed, and whether either vessel is cut off.
struct Counts {
  // What a place in `voxels` is made of.
  static constexpr std::size_t segment = 16, tumour = 8, removed = 4, starved = 2, held_up = 1;
  struct Key {
    std::size_t segment;
    bool tumour, removed, starved, held_up;
  };
  std::array<std::size_t, segments_and_none * segment> voxels{};
  std::array<double, segments_and_none> kPa{};  // summed over tissue that stays and is trusted
  std::array<std::size_t, segments_and_none> trusted{};
  std::vector<std::size_t> affected;  // of each place of a cut, what stays

  void add(const Counts& other) {
    for (std::size_t n = 0; n < voxels.size(); ++n) voxels[n] += other.voxels[n];
    for (std::size_t s = 0; s < segments_and_none; ++s) {
      kPa[s] += other.kPa[s];
      trusted[s] += other.trusted[s];
    }
    for (std::size_t n = 0; n < affected.size(); ++n) affected[n] += other.affected[n];
  }
  // How many of those for which `counts(key)`.
  template <typename Asked>
  [[nodiscard]] std::size_t of(const Asked& counts) const {
    std::size_t sum = 0;
    for (std::size_t n = 0; n < voxels.size(); ++n) {
      const Key key{n / segment, (n & tumour) != 0, (n & removed) != 0, (n & starved) != 0, (n & held_up) != 0};
      if (counts(key)) sum += voxels[n];
    }
    return sum;
  }
};

Tissue tissue(std::size_t voxels, double summed_kPa, std::size_t trusted, double voxel_ml) {
  Tissue made{static_cast<double>(voxels) * voxel_ml, {}, 0};
  if (trusted == 0) return made;
  made.mean_kPa = summed_kPa / static_cast<double>(trusted);
  made.confident_share = static_cast<double>(trusted) / static_cast<double>(voxels);
  return made;
}

template <typename Liver>
std::vector<Stretch> stretches_of(const Liver& liver);

// How far a tumour is from the cut, which lies between the voxels that go and those that stay.
MarginAnswer margin_of(std::size_t number, const Removal& removal, const Organ& organ,
                       const std::vector<TumourSurroundings>& tumours);

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
  liver->stretches = stretches_of(*liver);
  progress.report(1, GLISSON_TEXT("done"));
  return Planner(liver);
}

Result<PlanAnswer> Planner::answer(const std::vector<Cut>& cuts) const {
  const Liver& liver = *liver_;
  const auto removal = removal_by(cuts, liver.cuttable());
  if (!removal) return failure(removal.error());
  const CutOff off = liver.cut_off_by(*removal);
  const double voxel_ml = liver.organ.voxel_ml();

  Counts counts;
  counts.affected.assign(off.cut.size() + 1, 0);
  std::vector<std::uint32_t> cause;  // of each point, the number of cuts where none
  for (const std::int32_t one : off.cause) {
    cause.push_back(static_cast<std::uint32_t>(one < 0 ? static_cast<std::int32_t>(off.cut.size()) : one));
  }
  const auto nowhere = static_cast<std::uint32_t>(off.cut.size());
  std::mutex adding;
  parallel_for(liver.stretches.size(), 1 << 14, [&](std::size_t begin, std::size_t end) {
    Counts here;
    here.affected.assign(off.cut.size() + 1, 0);  // the last: those that hang on no cut
    for (std::size_t n = begin; n < end; ++n) {
      const Stretch& stretch = liver.stretches[n];
      const std::uint8_t* goes = removal->removed.data() + stretch.first;
      std::size_t gone = 0;
      for (std::size_t v = 0; v < stretch.voxels; ++v) gone += goes[v] != 0 ? 1 : 0;
      here.voxels[stretch.place | Counts::removed] += gone;
      if (gone == stretch.voxels) continue;
      const std::size_t left = stretch.voxels - gone;
      const std::uint32_t starved = cause[stretch.point[0]], held_up = cause[stretch.point[1]];
      here.affected[starved] += left;
      here.affected[held_up] += left;
      here.voxels[stretch.place | (starved != nowhere ? Counts::starved : 0) |
                  (held_up != nowhere ? Counts::held_up : 0)] += left;
      const std::size_t segment = stretch.place / Counts::segment;
      if (gone == 0) {
        here.kPa[segment] += static_cast<double>(stretch.kPa);
        here.trusted[segment] += stretch.trusted;
        continue;
      }
      for (std::size_t v = 0; v < stretch.voxels && stretch.trusted > 0; ++v) {
        const float kPa = goes[v] != 0 ? 0 : liver.trusted_kPa[stretch.first + v];
        here.kPa[segment] += static_cast<double>(kPa);
        here.trusted[segment] += kPa > 0 ? 1 : 0;
      }
    }
    const std::lock_guard lock(adding);
    counts.add(here);
  });

  using Key = Counts::Key;
  const auto ml = [&](auto asked) { return static_cast<double>(counts.of(asked)) * voxel_ml; };
  PlanAnswer answer;
  answer.liver_ml = static_cast<double>(liver.organ.voxels) * voxel_ml;
  answer.tumours_ml = ml([](const Key& key) { return key.tumour; });
  answer.removed_ml = ml([](const Key& key) { return key.removed; });
  answer.remnant_ml = ml([](const Key& key) { return !key.removed; });
  if (liver.has_system[0]) {
    answer.ischaemic_ml = ml([](const Key& key) { return key.starved; });
    answer.perfused_ml = answer.remnant_ml - *answer.ischaemic_ml;
  }
  if (liver.has_system[1]) {
    answer.congested_ml = ml([](const Key& key) { return key.held_up; });
    answer.drained_ml = answer.remnant_ml - *answer.congested_ml;
  }
  if (liver.has_system[0] && liver.has_system[1]) {
    answer.living_ml = ml([](const Key& key) { return !key.removed && !key.starved && !key.held_up; });
  }
  double all_kPa = 0;
  std::size_t all_trusted = 0;
  for (std::size_t s = 0; s < segments_and_none; ++s) {
    all_kPa += counts.kPa[s];
    all_trusted += counts.trusted[s];
    const std::size_t left = counts.of([&](const Key& key) { return key.segment == s && !key.tumour && !key.removed; });
    const std::size_t removed =
        counts.of([&](const Key& key) { return key.segment == s && !key.tumour && key.removed; });
    if (s == 0 || left + removed == 0) continue;
    answer.segments.push_back({static_cast<int>(s), static_cast<double>(removed) * voxel_ml,
                               tissue(left, counts.kPa[s], counts.trusted[s], voxel_ml), ml([&](const Key& key) {
                                 return key.segment == s && !key.tumour && !key.removed && !key.starved && !key.held_up;
                               })});
  }
  answer.left =
      tissue(counts.of([](const Key& key) { return !key.removed && !key.tumour; }), all_kPa, all_trusted, voxel_ml);
  answer.functional_remnant_ml = answer.left.ml;

  for (std::size_t c = 0; c < off.cut.size(); ++c) {
    const vasculature::TreeBranch& branch = liver.trees.branches[off.cut[c].branch];
    const auto& point = branch.points[off.cut[c].point];
    answer.branches.push_back(
        {off.cut[c].branch, point.position_mm, point.radius_mm, 0, static_cast<double>(counts.affected[c]) * voxel_ml});
  }
  for (const auto& tissue_at : liver.tissue) {
    for (std::size_t p = 0; p + 1 < tissue_at.size(); ++p) {
      if (off.cause[p] >= 0)
        answer.branches[static_cast<std::size_t>(off.cause[p])].beyond_ml += tissue_at[p] * voxel_ml;
    }
  }
  std::stable_sort(answer.branches.begin(), answer.branches.end(),
                   [](const CutBranch& a, const CutBranch& b) { return a.beyond_ml > b.beyond_ml; });

  for (std::size_t t = 0; t < liver.tumours.size(); ++t) {
    answer.tumours.push_back(margin_of(t, *removal, liver.organ, liver.tumours));
    const MarginAnswer& tumour = answer.tumours.back();
    if (tumour.side == Side::left || (answer.margin_mm && *answer.margin_mm <= tumour.margin_mm)) continue;
    answer.margin_mm = tumour.margin_mm;
    answer.margin_is_at_least = tumour.is_at_least;
  }
  return answer;
}

CutOff Planner::Liver::cut_off_by(const Removal& removal) const {
  const auto why = [&](std::size_t number) {
    const std::int32_t voxel = points.voxel[number];
    return voxel < 0 ? std::uint8_t{0} : removal.removed[static_cast<std::size_t>(voxel)];
  };
  if (!removal.along_anatomy) {
    return cut_off(trees, points, [&](std::size_t number) { return why(number) != 0; });
  }
  std::vector<std::size_t> all(points.count() + 1, 0), gone(points.count() + 1, 0);
  for (std::size_t s = 0; s < 2; ++s) {
    if (!has_system[s]) continue;
    for (std::size_t p = 0; p < all.size(); ++p) all[p] += tissue[s][p];
    std::mutex adding;
    parallel_for(organ.voxels, 1 << 16, [&](std::size_t begin, std::size_t end) {
      std::vector<std::uint32_t> here(gone.size(), 0);
      for (std::size_t v = begin; v < end; ++v) here[point[s][v]] += removal.removed[v] != 0 ? 1 : 0;
      const std::lock_guard lock(adding);
      for (std::size_t p = 0; p < gone.size(); ++p) gone[p] += here[p];
    });
  }
  all = sum_beyond(trees, points, all);
  gone = sum_beyond(trees, points, gone);
  return cut_off(trees, points, [&](std::size_t number) {
    const std::uint8_t because = why(number);
    return (because & goes_with_vessels) != 0 || (because != 0 && all[number] > 0 && 2 * gone[number] >= all[number]);
  });
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

std::array<Tissue, 9> Planner::segments() const {
  std::array<std::size_t, 9> voxels{}, trusted{};
  std::array<double, 9> kPa{};
  for (std::size_t v = 0; v < liver_->organ.voxels; ++v) {
    if (liver_->tumour[v] != 0) continue;
    const float value = liver_->youngs_at(v);
    for (const std::size_t s : {std::size_t{0}, std::size_t{liver_->segment[v]}}) {
      ++voxels[s];
      if (value > 0) kPa[s] += static_cast<double>(value), ++trusted[s];
      if (liver_->segment[v] == 0) break;
    }
  }
  std::array<Tissue, 9> made;
  for (std::size_t s = 0; s < 9; ++s) made[s] = tissue(voxels[s], kPa[s], trusted[s], liver_->organ.voxel_ml());
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
  std::vector<std::size_t> voxels(count), trusted(count);
  std::vector<double> kPa(count);
  for (const auto& points : liver_->point) {
    for (std::size_t v = 0; v < points.size(); ++v) {
      if (points[v] >= branch_of.size() || liver_->tumour[v] != 0) continue;
      const std::size_t b = branch_of[points[v]];
      ++voxels[b];
      if (const float value = liver_->youngs_at(v); value > 0) kPa[b] += static_cast<double>(value), ++trusted[b];
    }
  }
  std::vector<Tissue> made;
  for (std::size_t b = 0; b < count; ++b) {
    made.push_back(tissue(voxels[b], kPa[b], trusted[b], liver_->organ.voxel_ml()));
  }
  return made;
}

namespace {

template <typename Liver>
std::vector<Stretch> stretches_of(const Liver& liver) {
  constexpr std::size_t longest = 1000;
  std::vector<Stretch> stretches;
  const auto nowhere = static_cast<std::uint32_t>(liver.points.count());
  for (std::size_t v = 0; v < liver.organ.voxels; ++v) {
    const auto point = [&](std::size_t system) { return liver.has_system[system] ? liver.point[system][v] : nowhere; };
    const std::size_t place = liver.segment[v] * Counts::segment + (liver.tumour[v] != 0 ? Counts::tumour : 0);
    const Stretch here{static_cast<std::uint32_t>(v), {point(0), point(1)}, 0, 0, 0, static_cast<std::uint8_t>(place)};
    if (stretches.empty() || stretches.back().point != here.point || stretches.back().place != here.place ||
        stretches.back().voxels == longest) {
      stretches.push_back(here);
    }
    ++stretches.back().voxels;
    stretches.back().kPa += liver.youngs_at(v);
    stretches.back().trusted += liver.youngs_at(v) > 0 ? 1 : 0;
  }
  return stretches;
}

imaging::Mask organ_mask(const LiverParts& parts) {
  imaging::Mask organ = parts.liver;
  for (const NamedTumour& tumour : parts.tumours) {
    if (!imaging::same_grid(tumour.mask.grid, organ.grid)) continue;
    for (std::size_t v = 0; v < organ.values.size(); ++v) organ.values[v] |= tumour.mask.values[v] != 0 ? 1 : 0;
  }
  return organ;
}

// Where each voxel of the organ stands, by its number.
Vector3d position_mm(const Organ& organ, std::uint32_t voxel) {
  const auto after = std::upper_bound(organ.runs.begin(), organ.runs.end(), static_cast<std::size_t>(voxel),
                                      [](std::size_t number, const Run& run) { return number < run.first; });
  const Run& run = *std::prev(after);
  return organ.grid.position_mm(run.i + static_cast<int>(voxel - run.first), run.j, run.k);
}

MarginAnswer margin_of(std::size_t number, const Removal& removal, const Organ& organ,
                       const std::vector<TumourSurroundings>& tumours) {
  const TumourSurroundings& tumour = tumours[number];
  const auto removed = static_cast<std::size_t>(std::count_if(
      tumour.voxels.begin(), tumour.voxels.end(), [&](std::uint32_t v) { return removal.removed[v] != 0; }));
  MarginAnswer margin{tumour.name, removed == 0 ? Side::left : Side::removed, 0, false};
  if (removed != 0 && removed != tumour.voxels.size()) {
    margin.side = Side::cut_through;
    return margin;
  }
  // A voxel on the other side of the cut lies some way beyond it: by its height over a surface, else by half a voxel.
  const bool goes = margin.side == Side::removed;
  const double half_mm = 0.5 * organ.voxel_mm(), deepest_mm = organ.grid.spacing_mm.norm();
  const auto beyond_cut_mm = [&](const TumourSurroundings::Near& near) {
    double beyond_mm = goes ? deepest_mm : 0;
    for (const PreparedCut& cut : removal.cuts) {
      double here_mm = goes ? half_mm : 0;
      if (cut.surface) {
        here_mm = (goes ? -cut.sign : cut.sign) * cut.surface->height_mm(position_mm(organ, near.voxel));
      } else if (cut.tumour == number && goes) {
        here_mm = static_cast<double>(near.distance_mm) - cut.margin_mm;
      } else if (!goes) {
        here_mm = half_mm;
      }
      beyond_mm = goes ? std::min(beyond_mm, here_mm) : std::max(beyond_mm, here_mm);
    }
    return std::clamp(beyond_mm, 0.0, deepest_mm);
  };
  margin.margin_mm = largest_margin_mm;
  margin.is_at_least = true;
  for (const auto& near : tumour.around) {
    const auto distance_mm = static_cast<double>(near.distance_mm);
    if (!margin.is_at_least && distance_mm > margin.margin_mm + deepest_mm + 0.05) break;
    if ((removal.removed[near.voxel] != 0) == goes) continue;
    const double to_cut_mm = std::max(0.0, distance_mm - beyond_cut_mm(near));
    if (!margin.is_at_least && to_cut_mm >= margin.margin_mm) continue;
    margin.margin_mm = to_cut_mm;
    margin.is_at_least = false;
  }
  return margin;
}

}  // namespace
}  // namespace glisson::planning

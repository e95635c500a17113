#pragma once
// Two studies of one liver compared, as before and after the embolisation of portal branches. The answer is by how much
// each segment and the future remnant of a plan grew or shrank.
//
// All tissue is without tumours. The degree of hypertrophy is the remnant's share of the liver after less its share
// before, in percentage points. Source: Ribero et al. 2007, Br J Surg 94:1386. By the week it is the kinetic growth
// rate (Shindoh et al. 2013, J Am Coll Surg 216:201). Both papers take for the liver its standard volume, estimated
// from body size and the same in both studies. That is -794.41 + 1267.28 x body surface in m2, in ml (Vauthey et al.
// 2002, Liver Transpl 8:233). Where that is not given, each study's own liver is the whole: what shrinks then makes the
// share larger too.
//
// Nothing is matched voxel by voxel, so volumes are as right as outlines and borders of segments are. The same liver's
// volumes differ somewhat when it is parted anew. A change within that may be none.

#include <optional>
#include <vector>

#include "planning/planner.h"

namespace glisson::planning {

// One part of the liver in both studies.
struct PartGrowth {
  Tissue before, after;
  double before_percent = 0, after_percent = 0;  // of the whole in the same study
  bool within_error = false;                     // the change is no more than such a volume's own error

  [[nodiscard]] double change_ml() const { return after.ml - before.ml; }
  // Of what it was; nothing where it was nothing.
  [[nodiscard]] std::optional<double> change_percent() const;
};

struct SegmentGrowth {
  int number = 0;
  PartGrowth part;
};

struct RemnantGrowth {
  PartGrowth part;
  std::optional<double> points_per_week;  // kinetic growth rate; where the days are known

  // Degree of hypertrophy, percentage points.
  [[nodiscard]] double hypertrophy_points() const { return part.after_percent - part.before_percent; }
};

struct Growth {
  PartGrowth liver;
  double tumours_before_ml = 0, tumours_after_ml = 0;
  std::vector<SegmentGrowth> segments;  // those that either study has
  std::optional<RemnantGrowth> remnant;
};

struct GrowthOptions {
  std::optional<double> days;               // between the studies, more than 0
  std::optional<double> standard_liver_ml;  // the whole in both; absent: each study's own liver without tumours
  // How far a change may be off, in per cent of the volume before: of a segment, of the remnant. Absent: nothing is
  // within_error.
  std::optional<double> segment_error_percent, remnant_error_percent;
};

// The same plan in each study; a plane's place is that study's own.
struct RemnantCuts {
  std::vector<Cut> before, after;
};

// Fails with "growth-days" and "growth-standard-volume" (not more than 0), and with a remnant as Planner::answer does.
[[nodiscard]] Result<Growth> growth_between(const Planner& before, const Planner& after,
                                            const std::optional<RemnantCuts>& remnant,
                                            const GrowthOptions& options = {});

}  // namespace glisson::planning

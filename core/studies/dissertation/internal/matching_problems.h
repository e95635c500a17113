#pragma once
// The problems of the matching study: pairs of poses, sampled, as fields of every wanted size.

#include "base/progress.h"
#include "geometry/surface.h"
#include "registration/mrf.h"
#include "registration/samples.h"
#include "studies/dissertation/matching_study.h"

namespace glisson::studies {

class MatchingProblems {
 public:
  // Reads or makes the surfaces and samples them, each from every start.
  static Result<MatchingProblems> create(const MatchingOptions& options, const Progress& progress);

  // Ids and fingerprints, a problem each.
  [[nodiscard]] const std::vector<BatchPatient>& list() const { return list_; }
  // The field of the first `points` samples, with the constants that GEO uses.
  [[nodiscard]] registration::MatchingProblem of(std::size_t problem, int points) const;

 private:
  struct Pose {
    double area_mm2 = 0;
    std::string fingerprint;
    std::vector<Eigen::MatrixXd> between_mm;  // by start
  };
  struct Pair {
    std::size_t source, target, start;  // poses; the target's start, the source's being the first
  };
  std::vector<Pose> poses_;
  std::vector<Pair> pairs_;
  std::vector<BatchPatient> list_;
};

// The surface bent about the z axis by so much over its extent in x: a pose that a soft organ may take. Distances along
// it change by some tenths where it is stretched or pressed together.
[[nodiscard]] geometry::Surface bent(geometry::Surface surface, double angle_rad);

}  // namespace glisson::studies

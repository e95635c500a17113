#pragma once
// What structures that are grown or found have in common.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "base/sentence.h"
#include "casefile/case.h"
#include "imaging/image.h"

namespace glisson::casefile {

// By the stage "segment" on volumes/anatomy, with the seeds (patient LPS, mm) among its options.
Provenance made_from_seeds(const std::string& method, const std::vector<Eigen::Vector3d>& seeds_mm);

// Among its options, as "NAME-1_mm" and so on.
void keep_points(Provenance& made, const std::string& name, const std::vector<Eigen::Vector3d>& points_mm);

// Lesions that a case already has belong to its liver, whatever found that. What was added is noted, and named among
// what it was made from.
Result<imaging::Mask> with_known_lesions(const Case& patient, imaging::Mask liver, Provenance& made,
                                         std::vector<Sentence>& notes);

}  // namespace glisson::casefile

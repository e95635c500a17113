#pragma once
// Livers whose stiffness is published, to be named where the patient's own was not measured.

#include <string>
#include <vector>

#include "base/result.h"

namespace glisson::mechanics {

struct PublishedTissue {
  std::string id;
  double shear_modulus_kPa;
  std::string source;

  [[nodiscard]] double youngs_modulus_kPa(double poisson_ratio) const;
};

[[nodiscard]] const std::vector<PublishedTissue>& published_tissues();

// Failure: "tissue-unknown", with those there are.
[[nodiscard]] Result<PublishedTissue> published_tissue(const std::string& id);

}  // namespace glisson::mechanics

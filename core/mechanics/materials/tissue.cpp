#include "mechanics/materials/tissue.h"

#include "base/units.h"

namespace glisson::mechanics {

double PublishedTissue::youngs_modulus_kPa(double poisson_ratio) const {
  return units::youngs_from_shear(shear_modulus_kPa, poisson_ratio);
}

const std::vector<PublishedTissue>& published_tissues() {
  // Means of healthy adults by MR elastography; section 4.3 of the dissertation gives both.
  static const std::vector<PublishedTissue> tissues{
      {"liver-dissertation-cohort", 2.1, "Mean shear stiffness of the dissertation's own cohort (section 4.3)"},
      {"liver-published-cohort", 2.6, "Mean shear stiffness of the dissertation's reference 212 (section 4.3)"},
  };
  return tissues;
}

Result<PublishedTissue> published_tissue(const std::string& id) {
  std::string known;
  for (const PublishedTissue& tissue : published_tissues()) {
    if (tissue.id == id) return tissue;
    known += (known.empty() ? "" : ", ") + tissue.id;
  }
  return failure(Error{"tissue-unknown",
                       GLISSON_TEXT("There is no published tissue {0}."),
                       {id, known},
                       GLISSON_TEXT("The tissues are: {1}."),
                       {}});
}

}  // namespace glisson::mechanics

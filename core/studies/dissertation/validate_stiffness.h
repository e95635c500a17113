#pragma once
// Whether MRE measures what a testing machine measures. The mean Young's modulus of regions of a map is held against
// that of excised samples (dissertation, section 4.6 and table 4.5).

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"

namespace glisson::studies {

// A cylinder under dry compression. E = (F / A) / (d / h), with the area at rest.
struct CompressedSample {
  std::string material;
  double diameter_mm = 0, height_mm = 0, displacement_mm = 0, force_mN = 0;
  double stated_kPa = 0;  // what the testing machine's program gave; 0 where it is not known
  double mean_kPa = 0;    // what is reported of all of the material's samples together; 0 where nothing is

  [[nodiscard]] double youngs_kPa() const;
};

// A CSV file with the columns material (1, 2, ...), diameter_mm, height_mm, displacement_mm, force_N and, optionally,
// stated_kPa and mean_kPa. Fails as read_csv does, with "csv-no-such-column", or with "samples-impossible" (a size, way
// or force that is not positive).
Result<std::vector<CompressedSample>> read_samples(const std::filesystem::path& file);

// What MRE says of a material: the mean Young's modulus of its region.
struct MreRegion {
  std::string material;
  double youngs_kPa = 0, sd_kPa = 0;
  std::size_t voxels = 0;  // 0: only the mean is known
};

// The regions 1, 2, ... of a label map on a map of shear stiffness, in any unit that imaging::stiffness_in_kPa takes.
// They are turned to Young's moduli by E = 2 G (1 + nu). Labels lie on the map's grid or are carried to it.
Result<std::vector<MreRegion>> regions_of(const std::filesystem::path& map, const std::filesystem::path& labels,
                                          double poisson_ratio);

// What the dissertation reports of its phantom, and the samples of its table 4.5 (shipped as a resource).
[[nodiscard]] std::vector<MreRegion> dissertation_regions();
Result<std::vector<CompressedSample>> dissertation_samples();

struct MaterialAgreement {
  std::string material;
  double mre_kPa = 0, machine_kPa = 0;  // machine: the median of the samples
  double machine_low_kPa = 0, machine_high_kPa = 0;
  std::size_t samples = 0;
  double difference_percent = 0;  // of the machine's value
  // The same with what is stated: of the material or, without that, the median of what is of each sample; 0 where
  // neither is known.
  double stated_kPa = 0, stated_difference_percent = 0;
};
struct StiffnessValidation {
  std::vector<MaterialAgreement> materials;
  std::vector<std::string> notes;  // samples whose stated modulus does not follow from their own figures, and the like
  double largest_difference_percent = 0;
};

// Fails with "validation-no-samples" where a material has none. Writes validation.csv, summary.json and report.html.
Result<StiffnessValidation> validate_stiffness(const std::vector<MreRegion>& regions,
                                               const std::vector<CompressedSample>& samples,
                                               const std::filesystem::path& out);

}  // namespace glisson::studies

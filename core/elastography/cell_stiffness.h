#pragma once
// From a map of shear stiffness to the Young's modulus of each cell or node of a model (dissertation, section 4.2).

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "base/result.h"
#include "base/tissue.h"
#include "imaging/image.h"

namespace glisson::elastography {

enum class Filling {
  nearest_reliable,  // the value of the nearest reliable voxel
  local_average      // Gaussian average over the reliable voxels (normalised convolution, Knutsson and Westin 1993)
};

struct StiffnessOptions {
  // E = 2 G (1 + nu).
  double poisson_ratio = usual_poisson_ratio;

  // A voxel nearer than this to the organ's border is not trusted. The wave is reflected there, and the inversion
  // differentiates over a window that reaches out of the organ. The 5 mm are three voxels of the dissertation's scans
  // (1.64 mm). Reading guides ask for up to half a wavelength, sqrt(G/rho) / f / 2. That would be 12 mm at 60 Hz and
  // 2.1 kPa, and leave little of a thin lobe. Without an organ mask nothing is done about the border.
  double unreliable_border_mm = 5;

  Filling filling = Filling::local_average;
  double averaging_length_mm = 8;  // standard deviation of the Gaussian: about the resolution of liver MRE
};

// What tells reliable voxels from others, besides a value that is positive and finite.
struct Reliability {
  std::optional<imaging::Mask> confident;  // the scanner's confidence mask, on any grid
  std::optional<imaging::Mask> organ;      // the liver, on any grid: voxels outside it or at its border do not count
};

enum class StiffnessSource : std::uint8_t { measured, filled, chosen };

struct CellStiffness {
  std::vector<double> youngs_kPa;       // one a cell
  std::vector<StiffnessSource> source;  // one a cell
  std::size_t cells_without_data = 0;   // those that were filled
  double filled_fraction = 0;
  // Why cells had no data, in the order in which it is asked; each cell counts once.
  std::size_t cells_outside_map = 0;
  std::size_t cells_without_value = 0;  // zero, negative or not finite
  std::size_t cells_not_confident = 0;
  std::size_t cells_at_border = 0;                            // of the organ, or outside it
  double mean_kPa = 0, sd_kPa = 0, min_kPa = 0, max_kPa = 0;  // of youngs_kPa, each cell counting once
};

// Each point is the centroid of a cell, or a node (patient LPS, mm). It takes the voxel of the map whose centre is
// nearest in mm, through the map's own geometry. Of equally near ones it takes the first in memory. A point more than
// half a voxel outside the map has no voxel. Points without a reliable voxel are filled from the reliable ones and
// flagged.
//
// Fails with stiffness-no-cells, stiffness-empty-map, stiffness-bad-options or stiffness-nothing-reliable. Fails with
// stiffness-bad-grid where axes are not at right angles. Fails with stiffness-no-overlap where no point lies in the
// map. It says how far apart the boxes are, as when two frames of reference were confused.
Result<CellStiffness> cell_stiffness(const std::vector<Eigen::Vector3d>& points_mm, const imaging::Volume& shear_kPa,
                                     const Reliability& reliability = {}, const StiffnessOptions& options = {});

// Young's modulus of each voxel of the map that is reliable, by the same rules; 0 elsewhere.
[[nodiscard]] imaging::Volume reliable_youngs_kPa(const imaging::Volume& shear_kPa, const Reliability& reliability = {},
                                                  const StiffnessOptions& options = {});

// One value for all cells.
[[nodiscard]] CellStiffness uniform_stiffness(std::size_t cells, double youngs_kPa);

// Which published mean of healthy adults' liver shear stiffness the atlas is. Section 4.3 of the dissertation gives
// both, its own cohort's mean first.
enum class PopulationMean {
  dissertation_cohort,  // 2.1 kPa
  published_cohort      // 2.6 kPa, reference 212 there
};
[[nodiscard]] double population_shear_kPa(PopulationMean mean);
[[nodiscard]] double reference_youngs_kPa(PopulationMean mean, double poisson_ratio = usual_poisson_ratio);

}  // namespace glisson::elastography

// Cells take the nearest voxel; what is not reliable is filled from what is.

#include "elastography/cell_stiffness.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "base/units.h"
#include "elastography/region_statistics.h"
#include "geometry/nearest.h"
#include "imaging/filters.h"

namespace glisson::elastography {
namespace {

using Eigen::Vector3d;
using imaging::Grid;
using imaging::Mask;
using imaging::Volume;

// What is the matter with a voxel of the map, in the order in which it is asked.
enum class Trust : std::uint8_t { reliable, without_value, not_confident, at_border };

Result<void> check(const std::vector<Vector3d>& points_mm, const Volume& shear_kPa, const StiffnessOptions& options);
std::vector<Trust> trust_in(const Volume& shear_kPa, const Reliability& reliability, double unreliable_border_mm);

// What to fill in where the map is not to be trusted.
class Fill {
 public:
  Fill(const Volume& shear_kPa, const std::vector<Trust>& trust, const StiffnessOptions& options);
  // The shear stiffness for a voxel of the map.
  [[nodiscard]] float shear_kPa(const std::array<int, 3>& index) const;

 private:
  Grid grid_;
  std::vector<std::size_t> reliable_;  // voxels
  geometry::NearestPoint centres_;     // of those
  std::vector<float> value_kPa_;       // of every voxel: what it gives to those near it
  std::vector<float> weight_;          // below smallest_weight the nearest reliable voxel's value stands
};

Error no_overlap(const std::vector<Vector3d>& points_mm, const Grid& grid);
void count(CellStiffness& stiffness, Trust trust);
void summarise(CellStiffness& stiffness);

// The voxel whose centre is nearest; whether the point lies in the cell of a voxel, or outside the map.
struct NearestVoxel {
  std::array<int, 3> index;
  enum class Where { in_map, outside } where;
};
NearestVoxel nearest_voxel(const Vector3d& point_mm, const Grid& grid, const Eigen::Matrix3d& index_from_mm);

}  // namespace

Result<CellStiffness> cell_stiffness(const std::vector<Vector3d>& points_mm, const Volume& shear_kPa,
                                     const Reliability& reliability, const StiffnessOptions& options) {
  if (Result<void> checked = check(points_mm, shear_kPa, options); !checked) return failure(checked.error());
  const Grid& grid = shear_kPa.grid;
  const Eigen::Matrix3d index_from_mm = grid.spacing_mm.cwiseInverse().asDiagonal() * grid.direction.transpose();

  std::vector<NearestVoxel> nearest(points_mm.size());
  parallel_for(points_mm.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) nearest[n] = nearest_voxel(points_mm[n], grid, index_from_mm);
  });
  const bool overlap = std::any_of(nearest.begin(), nearest.end(), [](const NearestVoxel& voxel) {
    return voxel.where == NearestVoxel::Where::in_map;
  });
  if (!overlap) return failure(no_overlap(points_mm, grid));

  const std::vector<Trust> trust = trust_in(shear_kPa, reliability, options.unreliable_border_mm);
  if (std::none_of(trust.begin(), trust.end(), [](Trust t) { return t == Trust::reliable; })) {
    return failure(Error{"stiffness-nothing-reliable",
                         GLISSON_TEXT("No voxel of the stiffness map is reliable: none is positive, confident, inside "
                                      "the organ and {0} mm away from its border at once."),
                         {fmt::format("{:g}", options.unreliable_border_mm)},
                         GLISSON_TEXT("Check that map, confidence mask and segmentation belong together, or trust "
                                      "voxels nearer to the border."),
                         {}});
  }
  const Fill fill(shear_kPa, trust, options);

  CellStiffness stiffness;
  stiffness.youngs_kPa.reserve(points_mm.size());
  stiffness.source.reserve(points_mm.size());
  for (const NearestVoxel& at : nearest) {
    const std::size_t voxel = grid.offset(at.index[0], at.index[1], at.index[2]);
    const bool in_map = at.where == NearestVoxel::Where::in_map;
    const bool measured = in_map && trust[voxel] == Trust::reliable;
    if (!in_map) {
      ++stiffness.cells_outside_map;
    } else {
      count(stiffness, trust[voxel]);
    }
    const float shear = measured ? shear_kPa.values[voxel] : fill.shear_kPa(at.index);
    stiffness.youngs_kPa.push_back(units::youngs_from_shear(static_cast<double>(shear), options.poisson_ratio));
    stiffness.source.push_back(measured ? StiffnessSource::measured : StiffnessSource::filled);
  }
  summarise(stiffness);
  return stiffness;
}

Volume reliable_youngs_kPa(const Volume& shear_kPa, const Reliability& reliability, const StiffnessOptions& options) {
  const std::vector<Trust> trust = trust_in(shear_kPa, reliability, options.unreliable_border_mm);
  Volume youngs{{shear_kPa.grid, std::vector<float>(shear_kPa.values.size(), 0)}, "kPa"};
  for (std::size_t voxel = 0; voxel < trust.size(); ++voxel) {
    if (trust[voxel] != Trust::reliable) continue;
    youngs.values[voxel] = static_cast<float>(
        units::youngs_from_shear(static_cast<double>(shear_kPa.values[voxel]), options.poisson_ratio));
  }
  return youngs;
}

CellStiffness uniform_stiffness(std::size_t cells, double youngs_kPa) {
  CellStiffness stiffness;
  stiffness.youngs_kPa.assign(cells, youngs_kPa);
  stiffness.source.assign(cells, StiffnessSource::chosen);
  if (cells > 0) summarise(stiffness);
  return stiffness;
}

double population_shear_kPa(PopulationMean mean) { return mean == PopulationMean::dissertation_cohort ? 2.1 : 2.6; }

double reference_youngs_kPa(PopulationMean mean, double poisson_ratio) {
  return units::youngs_from_shear(population_shear_kPa(mean), poisson_ratio);
}

namespace {

NearestVoxel nearest_voxel(const Vector3d& point_mm, const Grid& grid, const Eigen::Matrix3d& index_from_mm) {
  // The axes are at right angles, so that the nearest centre is nearest along each axis by itself.
  const Vector3d index = index_from_mm * (point_mm - grid.origin_mm);
  NearestVoxel nearest{{0, 0, 0}, NearestVoxel::Where::in_map};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double place = index[static_cast<Eigen::Index>(axis)];
    const double last = grid.size[axis] - 1;
    if (!(place >= -0.5 && place <= last + 0.5)) nearest.where = NearestVoxel::Where::outside;
    // Rounding halves down takes the first of two equally near voxels.
    nearest.index[axis] = static_cast<int>(std::clamp(std::ceil(place - 0.5), 0.0, last));
  }
  return nearest;
}

std::vector<Trust> trust_in(const Volume& shear_kPa, const Reliability& reliability, double unreliable_border_mm) {
  const Grid& grid = shear_kPa.grid;
  // How deep each voxel of the organ's mask lies: the distance to the nearest voxel outside, less half a voxel for
  // the border between the two.
  std::vector<float> squared_depth_mm2;
  if (reliability.organ) squared_depth_mm2 = imaging::squared_depths_mm2(*reliability.organ);
  const auto voxel_at = [](const Mask& mask, const Vector3d& at_mm) {
    const Eigen::Matrix3d index_from_mm =
        mask.grid.spacing_mm.cwiseInverse().asDiagonal() * mask.grid.direction.transpose();
    return nearest_voxel(at_mm, mask.grid, index_from_mm);
  };
  const auto is_confident = [&](const Vector3d& at_mm) {
    if (!reliability.confident) return true;
    const NearestVoxel at = voxel_at(*reliability.confident, at_mm);
    return at.where == NearestVoxel::Where::in_map &&
           reliability.confident->at(at.index[0], at.index[1], at.index[2]) != 0;
  };
  const auto is_deep = [&](const Vector3d& at_mm) {
    if (!reliability.organ) return true;
    const NearestVoxel at = voxel_at(*reliability.organ, at_mm);
    if (at.where == NearestVoxel::Where::outside) return false;
    const Grid& organ = reliability.organ->grid;
    const double to_outside_mm =
        std::sqrt(static_cast<double>(squared_depth_mm2[organ.offset(at.index[0], at.index[1], at.index[2])]));
    return to_outside_mm - 0.5 * organ.spacing_mm.minCoeff() >= unreliable_border_mm;
  };

  std::vector<Trust> trust(grid.voxels(), Trust::reliable);
  parallel_for(static_cast<std::size_t>(grid.size[2]), 1, [&](std::size_t begin, std::size_t end) {
    for (auto k = static_cast<int>(begin); k < static_cast<int>(end); ++k) {
      for (int j = 0; j < grid.size[1]; ++j) {
        for (int i = 0; i < grid.size[0]; ++i) {
          const std::size_t voxel = grid.offset(i, j, k);
          const float value = shear_kPa.values[voxel];
          const Vector3d at_mm = grid.position_mm(i, j, k);
          if (!std::isfinite(value) || value <= 0) {
            trust[voxel] = Trust::without_value;
          } else if (!is_confident(at_mm)) {
            trust[voxel] = Trust::not_confident;
          } else if (!is_deep(at_mm)) {
            trust[voxel] = Trust::at_border;
          }
        }
      }
    }
  });
  return trust;
}

// The Gaussian's recursion is exact to about a hundredth of its height: below that there is no average to speak of.
constexpr float smallest_weight = 0.01F;

std::vector<std::size_t> reliable_voxels(const std::vector<Trust>& trust) {
  std::vector<std::size_t> voxels;
  for (std::size_t voxel = 0; voxel < trust.size(); ++voxel) {
    if (trust[voxel] == Trust::reliable) voxels.push_back(voxel);
  }
  return voxels;
}

std::vector<Vector3d> centres_mm(const Grid& grid, const std::vector<std::size_t>& voxels) {
  const auto width = static_cast<std::size_t>(grid.size[0]), height = static_cast<std::size_t>(grid.size[1]);
  std::vector<Vector3d> centres;
  centres.reserve(voxels.size());
  for (const std::size_t voxel : voxels) {
    centres.push_back(grid.position_mm(static_cast<int>(voxel % width), static_cast<int>(voxel / width % height),
                                       static_cast<int>(voxel / width / height)));
  }
  return centres;
}

Fill::Fill(const Volume& shear_kPa, const std::vector<Trust>& trust, const StiffnessOptions& options)
    : grid_(shear_kPa.grid),
      reliable_(reliable_voxels(trust)),
      centres_(centres_mm(grid_, reliable_)),
      value_kPa_(shear_kPa.values),
      weight_(trust.size(), 0.0F) {
  if (options.filling == Filling::nearest_reliable) return;
  std::vector<float> sum(trust.size(), 0.0F);
  for (const std::size_t voxel : reliable_) {
    weight_[voxel] = 1.0F;
    sum[voxel] = shear_kPa.values[voxel];
  }
  weight_ = imaging::gaussian_blur(std::move(weight_), grid_, options.averaging_length_mm);
  sum = imaging::gaussian_blur(std::move(sum), grid_, options.averaging_length_mm);
  for (std::size_t voxel = 0; voxel < sum.size(); ++voxel) {
    if (weight_[voxel] >= smallest_weight) value_kPa_[voxel] = sum[voxel] / weight_[voxel];
  }
}

float Fill::shear_kPa(const std::array<int, 3>& index) const {
  const std::size_t voxel = grid_.offset(index[0], index[1], index[2]);
  if (weight_[voxel] >= smallest_weight) return value_kPa_[voxel];
  const int nearest = centres_.nearest(grid_.position_mm(index[0], index[1], index[2])).point;
  return value_kPa_[reliable_[static_cast<std::size_t>(nearest)]];
}

void count(CellStiffness& stiffness, Trust trust) {
  switch (trust) {
    case Trust::reliable: break;
    case Trust::without_value: ++stiffness.cells_without_value; break;
    case Trust::not_confident: ++stiffness.cells_not_confident; break;
    case Trust::at_border: ++stiffness.cells_at_border; break;
  }
}

void summarise(CellStiffness& stiffness) {
  stiffness.cells_without_data =
      static_cast<std::size_t>(std::count(stiffness.source.begin(), stiffness.source.end(), StiffnessSource::filled));
  stiffness.filled_fraction =
      static_cast<double>(stiffness.cells_without_data) / static_cast<double>(stiffness.source.size());
  const Result<RegionStatistics> found = statistics_of(stiffness.youngs_kPa);
  GLISSON_ASSERT(found.has_value());
  stiffness.mean_kPa = found->mean;
  stiffness.sd_kPa = found->sd;
  stiffness.min_kPa = found->min;
  stiffness.max_kPa = found->max;
}

Error no_overlap(const std::vector<Vector3d>& points_mm, const Grid& grid) {
  std::vector<Vector3d> corners_mm;
  corners_mm.reserve(8);
  for (int corner = 0; corner < 8; ++corner) {
    corners_mm.push_back(grid.position_mm(Vector3d((corner & 1) != 0 ? grid.size[0] - 0.5 : -0.5,
                                                   (corner & 2) != 0 ? grid.size[1] - 0.5 : -0.5,
                                                   (corner & 4) != 0 ? grid.size[2] - 0.5 : -0.5)));
  }
  const geometry::Box body = geometry::bounding_box(points_mm);
  const geometry::Box map = geometry::bounding_box(corners_mm);
  const Vector3d gap_mm = (body.min_mm - map.max_mm).cwiseMax(map.min_mm - body.max_mm).cwiseMax(Vector3d::Zero());
  const auto text = [](const Vector3d& v) { return fmt::format("({:.0f}, {:.0f}, {:.0f})", v.x(), v.y(), v.z()); };
  return Error{"stiffness-no-overlap",
               GLISSON_TEXT("The model does not lie in the stiffness map: {0} mm are between their boxes (model around "
                            "{1}, map around {2})."),
               {fmt::format("{:.1f}", gap_mm.norm()), text(body.center_mm()), text(map.center_mm())},
               GLISSON_TEXT("They are probably in different frames of reference: take the stiffness series of the same "
                            "study, or register the two."),
               {}};
}

Result<void> check(const std::vector<Vector3d>& points_mm, const Volume& shear_kPa, const StiffnessOptions& options) {
  if (points_mm.empty())
    return failure("stiffness-no-cells", GLISSON_TEXT("There are no cells to give a stiffness to."));
  const Grid& grid = shear_kPa.grid;
  if (grid.voxels() == 0 || shear_kPa.values.size() != grid.voxels()) {
    return failure("stiffness-empty-map", GLISSON_TEXT("The stiffness map holds no voxels."));
  }
  const Eigen::Matrix3d gram = grid.direction.transpose() * grid.direction;
  if (!((gram - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < 1e-3) || !(grid.spacing_mm.minCoeff() > 0)) {
    return failure(
        "stiffness-bad-grid",
        GLISSON_TEXT("The axes of the stiffness map are not at right angles, so that the nearest voxel is not "
                     "to be told."));
  }
  const bool sensible = options.poisson_ratio > -1 && options.poisson_ratio <= 0.5 &&
                        options.unreliable_border_mm >= 0 && options.averaging_length_mm > 0 &&
                        std::isfinite(options.unreliable_border_mm) && std::isfinite(options.averaging_length_mm);
  if (!sensible) {
    return failure("stiffness-bad-options",
                   GLISSON_TEXT("Poisson's ratio must lie in (-1, 0.5], the border must not be negative and the "
                                "averaging length must be positive; they are {0}, {1} mm and {2} mm."),
                   {fmt::format("{:g}", options.poisson_ratio), fmt::format("{:g}", options.unreliable_border_mm),
                    fmt::format("{:g}", options.averaging_length_mm)});
  }
  return {};
}

}  // namespace
}  // namespace glisson::elastography

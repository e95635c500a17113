// Positions to a grid, and what is not as it should be about them.

#include "imaging/internal/place_slices.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <numbers>

#include <fmt/format.h>

namespace glisson::imaging {
namespace {

using Images = std::vector<DicomImage>;
using Slices = std::vector<PictureRef>;

// Under gantry tilt slices slide sideways by tan(tilt) of the way up; below 0.005 (0.3 degrees) it is rounding.
constexpr double minimum_slide = 0.005;
constexpr double minimum_tilt_deg = 0.1;
constexpr std::size_t maximum_gaps_named = 5;

Grid grid_of_one_slice(const Picture& picture);
void name_gaps(const Images& images, const Slices& slices, const EvenSlices& even, PlacedSlices& placed);
Eigen::Vector3d slide_per_mm(const Images& images, const Slices& slices, const Eigen::Vector3d& normal);
void lean(const DicomImage& image, const Eigen::Vector3d& slide, PlacedSlices& placed);
void name_sideways_shift(const Images& images, const Volumes& volumes, const Eigen::Vector3d& upwards,
                         PlacedSlices& placed);

}  // namespace

PlacedSlices place_slices(const Images& images, const Volumes& volumes) {
  const Slices& slices = volumes.of_volume.front();
  const Picture& first = picture_of(images, slices.front());
  PlacedSlices placed;
  placed.grid = grid_of_one_slice(first);
  placed.slices = {{0, 0, 0}};
  if (slices.size() >= 2) {
    const EvenSlices even = even_slices(volumes.positions_mm);
    placed.slices = even.slices;
    placed.grid.spacing_mm[2] = even.spacing_mm;
    if (first.placed) name_gaps(images, slices, even, placed);
  }
  placed.grid.size[2] = static_cast<int>(placed.slices.size());

  if (!first.placed) {
    placed.problems.emplace_back(
        "No place in the patient is given: the pictures are in the order of their numbers, one mm apart.");
  } else if (slices.size() < 2) {
    placed.problems.emplace_back("It is a single slice; its thickness is taken for the third dimension.");
  } else {
    const Eigen::Vector3d normal = placed.grid.direction.col(2);
    const Eigen::Vector3d slide = slide_per_mm(images, slices, normal);
    if (!slide.isZero()) lean(images[slices.front().image], slide, placed);
    name_sideways_shift(images, volumes, normal + slide, placed);
  }
  return placed;
}

namespace {

Grid grid_of_one_slice(const Picture& picture) {
  Grid grid;
  grid.size = {picture.columns, picture.rows, 1};
  const bool has_thickness = picture.slice_thickness_mm > 0 && picture.slice_thickness_mm < 1e4;
  grid.spacing_mm = {picture.column_spacing_mm, picture.row_spacing_mm, has_thickness ? picture.slice_thickness_mm : 1};
  grid.origin_mm = picture.position_mm;
  grid.direction.col(0) = picture.along_row;
  grid.direction.col(1) = picture.along_column;
  grid.direction.col(2) = picture.along_row.cross(picture.along_column);
  return grid;
}

std::string gap_sentence(const std::string& before, const std::string& after, const SliceGap& gap, double spacing_mm) {
  if (gap.missing > 0) {
    return fmt::format(
        "{} missing between {} and {}, which are {:.4g} mm apart where the others are {:.4g} mm: the "
        "gap is filled by interpolation.",
        gap.missing == 1 ? "One slice is" : fmt::format("{} slices are", gap.missing), before, after, gap.width_mm,
        spacing_mm);
  }
  return fmt::format(
      "The spacing is uneven: {} and {} are {:.4g} mm apart where the usual is {:.4g} mm; slices off the "
      "grid are interpolated.",
      before, after, gap.width_mm, spacing_mm);
}

void name_gaps(const Images& images, const Slices& slices, const EvenSlices& even, PlacedSlices& placed) {
  for (std::size_t n = 0; n < std::min(even.gaps.size(), maximum_gaps_named); ++n) {
    const SliceGap& gap = even.gaps[n];
    placed.problems.push_back(gap_sentence(name_of(images, slices[gap.before]), name_of(images, slices[gap.before + 1]),
                                           gap, even.usual_gap_mm));
  }
  if (even.gaps.size() > maximum_gaps_named) {
    placed.problems.push_back(fmt::format("{} more gaps are not as wide as the usual {:.4g} mm.",
                                          even.gaps.size() - maximum_gaps_named, even.usual_gap_mm));
  }
}

// How far the slices slide sideways for each mm along the normal; zero where it is only rounding.
Eigen::Vector3d slide_per_mm(const Images& images, const Slices& slices, const Eigen::Vector3d& normal) {
  const Eigen::Vector3d way =
      picture_of(images, slices.back()).position_mm - picture_of(images, slices.front()).position_mm;
  const double up_mm = way.dot(normal);
  const Eigen::Vector3d slide = (way - up_mm * normal) / up_mm;
  return slide.norm() < minimum_slide ? Eigen::Vector3d::Zero() : slide;
}

// The third axis follows the slices, so that every voxel keeps its place and nothing is resampled.
void lean(const DicomImage& image, const Eigen::Vector3d& slide, PlacedSlices& placed) {
  const Eigen::Vector3d upwards = placed.grid.direction.col(2) + slide;
  placed.grid.direction.col(2) = upwards.normalized();
  placed.grid.spacing_mm[2] *= upwards.norm();
  const std::string in_header = std::abs(image.gantry_tilt_deg) > minimum_tilt_deg
                                    ? fmt::format(" (the header gives {:.1f})", image.gantry_tilt_deg)
                                    : "";
  placed.problems.push_back(fmt::format(
      "The slices are sheared by {:.1f} degrees, as under gantry tilt{}: the third axis of the volume is not "
      "perpendicular to the slices.",
      std::atan(slide.norm()) * 180 / std::numbers::pi, in_header));
}

void name_sideways_shift(const Images& images, const Volumes& volumes, const Eigen::Vector3d& upwards,
                         PlacedSlices& placed) {
  const Slices& slices = volumes.of_volume.front();
  const Picture& first = picture_of(images, slices.front());
  double worst_mm = 0;
  for (std::size_t k = 0; k < slices.size(); ++k) {
    const double up_mm = volumes.positions_mm[k] - volumes.positions_mm.front();
    const Eigen::Vector3d expected_mm = first.position_mm + upwards * up_mm;
    worst_mm = std::max(worst_mm, (picture_of(images, slices[k]).position_mm - expected_mm).norm());
  }
  if (worst_mm <= 0.5 * std::max(first.column_spacing_mm, first.row_spacing_mm)) return;
  placed.problems.push_back(fmt::format(
      "Slices are shifted sideways against each other by up to {:.2f} mm, which is not corrected.", worst_mm));
}

}  // namespace
}  // namespace glisson::imaging

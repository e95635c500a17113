#include "vasculature/internal/hand_borders.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace glisson::vasculature {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

// Drawn borders of the tuning half lie up to 51 mm from the mean's, but for that of I. mm at scale 1.
constexpr double most_usual_mm = 60;

// On which side of each surface a segment lies, as segment_at() asks; 0 where it does not ask.
SurfaceLevels sides_of(int segment) {
  SurfaceLevels sides{};
  sides[caudate_border] = segment == 1 ? -1 : 1;
  if (segment == 1) return sides;
  const bool is_right = segment >= 5, is_posterior = segment == 6 || segment == 7;
  sides[middle_vein] = is_right ? 1 : -1;
  if (is_right) {
    sides[right_vein] = is_posterior ? 1 : -1;
    sides[is_posterior ? posterior_level : anterior_level] = segment >= 7 ? 1 : -1;
  } else {
    sides[umbilical_fissure] = segment == 4 ? 1 : -1;
    if (segment != 4) sides[left_vein] = segment == 2 ? 1 : -1;
  }
  return sides;
}

// Matérn's covariance of order 3/2: the border bends without kinks, and far away nothing changes.
double covariance_mm2(const Vector3d& a_mm, const Vector3d& b_mm, double scale) {
  const double away = std::numbers::sqrt3 * (a_mm - b_mm).norm() / (strays_along_mm * scale);
  return strays_mm * strays_mm * scale * scale * (1 + away) * std::exp(-away);
}

Eigen::LLT<MatrixXd> factor_of(const std::vector<Vector3d>& places_mm, double scale) {
  const auto count = static_cast<Eigen::Index>(places_mm.size());
  constexpr double hand_mm = 0.01;  // a place told twice is told once
  MatrixXd covariance = MatrixXd::Identity(count, count) * hand_mm * hand_mm;
  for (Eigen::Index a = 0; a < count; ++a) {
    for (Eigen::Index b = 0; b < count; ++b) {
      covariance(a, b) +=
          covariance_mm2(places_mm[static_cast<std::size_t>(a)], places_mm[static_cast<std::size_t>(b)], scale);
    }
  }
  return covariance.llt();
}

std::string place_text(const BorderPlace& place) {
  const Vector3d& p = place.position_mm;
  return fmt::format("{:.1f},{:.1f},{:.1f}", p.x(), p.y(), p.z());
}

// Whether both segments lie within half a voxel of the place.
bool both_around(const BentPlanes& planes, const imaging::Grid& grid, const BorderPlace& place) {
  std::array<bool, 9> here{};
  const Vector3d at = grid.index_of(place.position_mm);
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3d off((corner & 1) != 0 ? 0.5 : -0.5, (corner & 2) != 0 ? 0.5 : -0.5, (corner & 4) != 0 ? 0.5 : -0.5);
    here.at(static_cast<std::size_t>(planes.at(grid.position_mm(at + off)))) = true;
  }
  return here.at(static_cast<std::size_t>(place.segments[0])) && here.at(static_cast<std::size_t>(place.segments[1]));
}

}  // namespace

HandBorders::HandBorders(const BorderPlaces& places, double scale, double clear_mm)
    : scale_(scale), clear_mm_(clear_mm) {
  for (const BorderPlace& told : places) {
    GLISSON_ASSERT(border_named(border_name(told.segments)));
    const SurfaceLevels a = sides_of(told.segments[0]), b = sides_of(told.segments[1]);
    Place& place = places_.emplace_back(Place{told, surface_count, {}});
    for (std::size_t s = 0; s < surface_count; ++s) {
      if (a.at(s) * b.at(s) < 0) {
        place.passes = static_cast<Surface>(s);
      } else if (a.at(s) + b.at(s) != 0) {
        place.sides.push_back({static_cast<Surface>(s), a.at(s) + b.at(s) > 0 ? 1.0 : -1.0});
      }
    }
    on_mm_.at(place.passes).push_back(told.position_mm);
  }
  for (std::size_t s = 0; s < surface_count; ++s) factors_.at(s) = factor_of(on_mm_.at(s), scale);
}

double HandBorders::energy(const SegmentPlanes& planes) const {
  if (places_.empty()) return 0;
  std::array<std::vector<double>, surface_count> off_mm;
  double sum = 0;
  for (const Place& place : places_) {
    const SurfaceLevels levels = planes.levels_mm(place.told.position_mm);
    off_mm.at(place.passes).push_back(levels.at(place.passes));
    for (const Side& side : place.sides) {
      const double beyond = std::max(0.0, clear_mm_ - side.sign * levels.at(side.surface)) / (strays_mm * scale_);
      sum += 0.5 * beyond * beyond;
    }
  }
  for (std::size_t s = 0; s < surface_count; ++s) {
    if (off_mm.at(s).empty()) continue;
    const auto off = Eigen::Map<const VectorXd>(off_mm.at(s).data(), static_cast<Eigen::Index>(off_mm.at(s).size()));
    sum += 0.5 * factors_.at(s).matrixL().solve(off).squaredNorm();
  }
  return sum;
}

Result<void> HandBorders::may_pass(const SegmentPlanes& mean) const {
  for (const Place& place : places_) {
    const SurfaceLevels levels = mean.levels_mm(place.told.position_mm);
    double away_mm = std::abs(levels.at(place.passes));
    for (const Side& side : place.sides) away_mm = std::max(away_mm, -side.sign * levels.at(side.surface));
    if (away_mm <= most_usual_mm * scale_) continue;
    return failure(
        "border-far",
        GLISSON_TEXT("{0} lies {1} mm from the usual course of the border of {2}: tell the border that is meant, "
                     "or put the place on it."),
        {place_text(place.told), fmt::format("{:.0f}", away_mm), border_name(place.told.segments)});
  }
  return {};
}

Result<void> HandBorders::pass(const SegmentPlanes& planes, const imaging::Grid& grid) const {
  const double near_mm = 0.5 * grid.spacing_mm.norm();
  const BentPlanes bent(planes, *this);
  for (const Place& place : places_) {
    const auto& [a, b] = place.told.segments;
    const auto other = std::find_if(places_.begin(), places_.end(), [&](const Place& beside) {
      const auto& [c, d] = beside.told.segments;
      const bool near = (beside.told.position_mm - place.told.position_mm).norm() < near_mm;
      return near && a != c && a != d && b != c && b != d;
    });
    if (other == places_.end() && both_around(bent, grid, place.told)) continue;
    return failure("borders-contradict",
                   GLISSON_TEXT("The border of {0} cannot pass {1} as well as the other borders where they were told: "
                                "take one of the places back."),
                   {border_name(place.told.segments), place_text(place.told)});
  }
  return {};
}

BentPlanes::BentPlanes(SegmentPlanes planes, const HandBorders& hand) : planes_(planes), scale_(hand.scale_) {
  if (hand.places_.empty()) return;
  std::array<std::vector<double>, surface_count> by_mm;
  for (const HandBorders::Place& place : hand.places_) {
    bends_.at(place.passes).places_mm.push_back(place.told.position_mm);
    by_mm.at(place.passes).push_back(-planes.levels_mm(place.told.position_mm).at(place.passes));
  }
  const auto solve = [&](std::size_t s) {
    const auto by = Eigen::Map<const VectorXd>(by_mm.at(s).data(), static_cast<Eigen::Index>(by_mm.at(s).size()));
    bends_.at(s).weights = factor_of(bends_.at(s).places_mm, scale_).solve(by);
  };
  for (std::size_t s = 0; s < surface_count; ++s) solve(s);
  // What would run between a place and its segments is bent away from there, as far as it must.
  for (const HandBorders::Place& place : hand.places_) {
    const SurfaceLevels levels = planes.levels_mm(place.told.position_mm);
    for (const HandBorders::Side& side : place.sides) {
      Bend& bend = bends_.at(side.surface);
      const double level = levels.at(side.surface) + bent_mm(bend, place.told.position_mm);
      if (side.sign * level >= hand.clear_mm_) continue;
      bend.places_mm.push_back(place.told.position_mm);
      by_mm.at(side.surface).push_back(side.sign * hand.clear_mm_ - levels.at(side.surface));
      solve(side.surface);
    }
  }
  bent_ = true;
}

int BentPlanes::at(const Vector3d& patient_mm) const {
  if (!bent_) return planes_.at(patient_mm);
  SurfaceLevels levels = planes_.levels_mm(patient_mm);
  for (std::size_t s = 0; s < surface_count; ++s) levels.at(s) += bent_mm(bends_.at(s), patient_mm);
  return segment_at(levels);
}

double BentPlanes::bent_mm(const Bend& bend, const Vector3d& patient_mm) const {
  double sum = 0;
  for (std::size_t i = 0; i < bend.places_mm.size(); ++i) {
    sum += bend.weights[static_cast<Eigen::Index>(i)] * covariance_mm2(patient_mm, bend.places_mm[i], scale_);
  }
  return sum;
}

}  // namespace glisson::vasculature

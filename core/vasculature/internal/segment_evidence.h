#pragma once
// What is known of one liver and its vessels, and how probable a model of what parts its segments is under it.

#include <Eigen/Core>
#include <vector>

#include "base/result.h"
#include "imaging/image.h"
#include "vasculature/internal/hand_borders.h"
#include "vasculature/systems.h"

namespace glisson::vasculature {

// Where the portal vein divides is counted from the vena cava's axis and the middle of the borders of V and VI. Where
// the hepatic veins meet is counted from the axis and the base point. Both are means of generated patients 1 to 10,
// carried over to this base point and rounded, mm at scale 1.
inline const Eigen::Vector3d portal_from_axis(-20, -24, -4), hepatic_from_axis(-23, -31, 39);

// A piece of vessel with what it counts as one of each system.
struct VesselSample {
  Eigen::Vector3d position_mm;
  double hepatic_weight, portal_weight;
  bool left_portal;  // thick, and to the left of where the portal vein divides
};

// A place of a vessel that somebody named, on the border where it runs, with what it counts.
struct BorderSample {
  Eigen::Vector3d position_mm;
  Surface border;
  double weight;
};

// What is known of one liver.
struct Evidence {
  LiverFrame liver;
  std::vector<Eigen::Vector3d> places_mm;  // spread over the liver
  std::vector<VesselSample> vessels;
  std::vector<BorderSample> borders;
  HandBorders hand;
  Eigen::Vector3d portal_mm{0, 0, 0}, hepatic_mm{0, 0, 0};
};

// Failures: those of liver_frame, lie_in_liver and HandBorders::may_pass.
Result<Evidence> evidence_of(const imaging::Mask& liver, const BorderPlaces& borders);

// Failure: "vessels-outside" (less than half of them lie in the liver).
Result<void> add_vessels(const imaging::Mask& liver, const VesselTrees& trees, Evidence& evidence);

// Minus the logarithm of the probability, but for a constant.
double energy(const Evidence& evidence, const PlaneParameters& parameters);

}  // namespace glisson::vasculature

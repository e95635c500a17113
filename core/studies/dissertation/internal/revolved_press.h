#pragma once
// A rigid ball pressed into the middle of a round gel: the truth that a simulation is held against.
//
// It shares nothing with core/mechanics but Eigen. A body of revolution takes a plane mesh: quadrilaterals of eight
// nodes at two by two points, total Lagrangian (Bonet and Wood, Nonlinear Continuum Mechanics, 6 to 9). The energy per
// rest volume is w(I) + K/2 (J - 1)^2, I = J^(-2/3) |F|^2, w = G/2 ((I - 3) + c (I - 3)^2): neo-Hookean where c is 0,
// else Yeoh's law of two terms. The ball is smooth, and a stiff spring under each point of the surface keeps it out.
// It goes down in small steps, by Newton's method at each.
//
// Frame: (r, z) in mm, the axis at r = 0, the bottom at z = 0, held; side and top are free. Forces mN, moduli kPa.

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "base/progress.h"
#include "base/result.h"

namespace glisson::studies {

struct Gel {
  double shear_kPa = 0;
  double bulk_kPa = 0;
  double stiffening = 0;  // c above
};

struct RevolvedBody {
  double radius_mm = 0, height_mm = 0;
  std::function<Gel(double r_mm, double z_mm)> gel_at;
};

struct PressOptions {
  double finest_mm = 1.5;     // of an element across, from the axis to 1.6 times the ball's radius
  double growth = 1.25;       // of each element beyond over the one before
  int layers = 16;            // of elements, even in height
  double step_mm = 0.5;       // of the ball's way
  double largest_part = 0.6;  // of the height: no ball goes deeper
};

struct PressedProfile {
  double depth_mm = 0;  // of the ball's lowest point below the top at rest
  double force_mN = 0;
  double energy_uJ = 0;                     // of the gel
  double contact_radius_mm = 0;             // of the farthest point that touches
  std::vector<Eigen::Vector2d> profile_mm;  // from the axis over the top to the rim, and down the side
};

struct PressCurve {
  std::vector<Eigen::Vector2d> rest_profile_mm;
  std::vector<PressedProfile> steps;     // by depth, all that were taken
  std::vector<PressedProfile> at_force;  // one a force that was asked for, to within 1e-4 of it
};

// The forces (mN) are positive and ascend. Fails with "press-not-converged" (at which depth), "press-too-deep" (which
// force was not reached), or "cancelled".
Result<PressCurve> press_revolved(const RevolvedBody& body, double ball_radius_mm, const std::vector<double>& forces_mN,
                                  const PressOptions& options = {}, const Progress& progress = {});

}  // namespace glisson::studies

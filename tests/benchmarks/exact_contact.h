#pragma once
// How far a session's landmarks are from those of a contact a hundred times tighter.

#include <algorithm>

#include "mechanics/contact/contact.h"
#include "rehearsal/session.h"

namespace glisson {

// The patient's landmarks in `state`, of a session over `setup` in which `held` was taken and then `drawn`; in mm, at
// most. -1 where the tight contact itself does not converge.
inline double landmark_error_mm(const rehearsal::RehearsalSetup& setup, const mechanics::ContactTool& held,
                                const mechanics::ContactTool& drawn, const rehearsal::SessionState& state) {
  auto model =
      mechanics::StaticModel::create(setup.mesh, setup.patient_youngs_kPa, setup.supports, setup.options).value();
  auto places = mechanics::locate_landmarks(setup.mesh, setup.landmarks, setup.landmark_tolerance_mm).value();
  const auto body = mechanics::ContactBody::create(std::move(model), setup.standing_loads, places).value();
  mechanics::ContactOptions tight;
  tight.movement_tolerance_mm *= 0.01;
  tight.max_rounds = 500;
  auto exact = body.solve(body.untouched(), {held}, tight).value();
  exact = body.solve(exact, {held, drawn}, tight).value();
  if (!exact.report.converged) return -1;
  double error_mm = 0;
  for (std::size_t l = 0; l < setup.landmarks.size(); ++l) {
    const Eigen::Vector3d moved_mm = state.patient.landmarks[l].displaced_mm - setup.landmarks[l].position_mm;
    error_mm = std::max(error_mm, (moved_mm - exact.watched_mm[l]).norm());
  }
  return error_mm;
}

}  // namespace glisson

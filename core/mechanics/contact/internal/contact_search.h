#pragma once
// The rounds that bring a linear body in contact to rest (contact.h). Each finds the places that touch, and solves for
// their forces on the body's remembered answers. Then it moves the surface and the pushed tools on, and looks again.
// Inside of this room.

#include <set>

#include "mechanics/contact/contact.h"
#include "mechanics/contact/internal/contact_columns.h"

namespace glisson::mechanics {

// Gives a state the displacements that its forces make, and the jumps, and tells the largest strain. Failure:
// "not-converged".
[[nodiscard]] Result<StrainRange> show(const SurfaceResponses& responses, ContactState& state);

class ContactSearch {
 public:
  // `walls`, of cuts that are kept apart, speak of the points of the surface as their nodes.
  ContactSearch(const SurfaceResponses& responses, CutSelfContact walls, const std::vector<ContactTool>& tools,
                const ContactOptions& options);

  // Either comes first. From rest walls meet where they were one, wherever the loads alone would take them.
  [[nodiscard]] Result<void> begin_from(const ContactState& state);
  [[nodiscard]] Result<void> begin_from_rest();

  // Rounds until the state has come to rest, or as many as there may be.
  [[nodiscard]] Result<ContactState> run();

 private:
  Result<void> hold(const ContactState& before);
  Result<bool> find_places();  // false where a pushed tool had lost the surface and went on to it
  Result<bool> round();        // true where there is nothing more to do
  [[nodiscard]] Result<void> set_up_columns();
  void meet_live_walls();
  [[nodiscard]] Result<ContactState> state() const;
  [[nodiscard]] double deepest_mm();
  [[nodiscard]] double live_overlap_mm() const;

  const SurfaceResponses& responses_;
  CutSelfContact walls_;
  const std::vector<ContactTool>& tools_;
  ContactOptions options_;

  PointForces force_mN_;
  WallForces wall_mN_;
  Eigen::VectorXd advance_mm_;  // one a tool; 0 for one that is held
  Eigen::VectorXd surface_mm_;  // displacement, 3 values a point
  bool from_rest_ = false;
  std::set<int> live_walls_met_;  // they stay in the problem until the state is found
  std::vector<Gripped> grips_;
  std::vector<TrackedContact> kept_;

  std::vector<ContactCandidate> places_;
  ContactColumns columns_;
  ContactForces forces_;

  // Across a tool's bend the surface may swing to and fro: a round that goes back on the one before goes half as far.
  // Where rounds go on in one direction, it slides, and they go farther again.
  double share_ = 1.0;
  Eigen::VectorXd last_way_mm_;
  ContactReport report_;
};

}  // namespace glisson::mechanics

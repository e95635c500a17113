#pragma once
// Tools that press on a body whose rest, or whose step in time, is the minimum of a potential energy (newton.h):
// large_contact.h says how. What the tools do is added to the potential energy over the body's nodes; who gives it says
// how its minimum is found. Inside of this room.

#include <functional>

#include "mechanics/contact/contact.h"
#include "mechanics/contact/internal/contact_candidates.h"
#include "mechanics/contact/internal/contact_constraint.h"
#include "mechanics/contact/internal/cut_self_contact.h"
#include "mechanics/elements/load_vector.h"
#include "mechanics/solvers/internal/newton.h"

namespace glisson::mechanics {

// Jaws that hold the mean of some nodes, by weight, at a displacement, and the force that they are known to need.
struct PrescribedPatch {
  std::size_t tool;
  std::vector<int> nodes;
  std::vector<double> weights;
  Eigen::Vector3d from_mm{0, 0, 0};  // where the mean was when they closed
  Eigen::Vector3d wanted_mm{0, 0, 0};
  Eigen::Vector3d force_mN{0, 0, 0};
};

// What all but the tools makes of the body, how large its forces are, and how its minimum with the tools is found, from
// a displacement.
struct BodyProblem {
  const Potential& alone;
  double scale_mN;
  std::function<Result<NewtonResult>(const Potential& with_tools, double scale_mN, const Eigen::VectorXd& from_mm)>
      settle;
};

// Moved on from station to station.
class AugmentedLagrangian {
 public:
  // `tools` are those of the first station; the walls of cuts are kept apart. Failures: "tool-invalid",
  // "tool-touches-nothing".
  static Result<AugmentedLagrangian> create(const Body& body, const std::vector<ContactTool>& tools,
                                            const ContactOptions& options, Eigen::VectorXd u_mm,
                                            const std::vector<OpenedBody::Wall>& walls = {});

  // What graspers that pull add to the loads.
  [[nodiscard]] AppliedLoads with_pulls(AppliedLoads loads, const std::vector<ContactTool>& tools) const;

  // Brings the body and the pushed tools to rest. False where they do not come to it.
  Result<bool> equilibrate(const std::vector<ContactTool>& tools, const BodyProblem& problem);

  [[nodiscard]] const Eigen::VectorXd& displacement_mm() const { return u_mm_; }
  // What the tools push with, 3 a node, without what pulls.
  [[nodiscard]] Eigen::VectorXd force_mN() const;
  [[nodiscard]] std::vector<ToolContact> contacts(const std::vector<ContactTool>& tools) const;
  [[nodiscard]] const ContactReport& report() const { return report_; }

 private:
  AugmentedLagrangian(const Body& body, const ContactOptions& options, Eigen::VectorXd u_mm);
  Result<bool> rest_at_advances(const std::vector<ContactTool>& tools, const BodyProblem& problem);
  void update_multipliers(const std::vector<ContactTool>& tools);
  [[nodiscard]] Eigen::VectorXd surface_mm(const Eigen::VectorXd& u_mm) const;
  [[nodiscard]] Eigen::Vector3d force_of_tool(std::size_t tool) const;
  [[nodiscard]] Rod rod_of(const TrackedContact& place, const std::vector<ContactTool>& tools) const;
  [[nodiscard]] Pose pose_of(std::size_t tool, const std::vector<ContactTool>& tools) const;
  void restart_friction(ContactConstraint& constraint, const std::vector<ContactTool>& tools) const;

  const Body* body_;
  ContactOptions options_;
  geometry::Surface surface_;
  std::vector<int> node_of_point_;  // of the surface
  double k_mN_mm_;
  Eigen::VectorXd u_mm_, advance_mm_;
  std::vector<Gripped> grips_;
  std::vector<ContactConstraint> constraints_;
  std::vector<PrescribedPatch> patches_;
  CutSelfContact walls_;
  ContactReport report_;
};

}  // namespace glisson::mechanics

#pragma once
// Contact at large deformation and in motion, where equilibrium or a step in time is the minimum of a potential energy
// (newton.h). Tools, jaws and faces of cuts are three terms more of it; large_contact.h says which. Inside of this
// room.

#include "mechanics/contact/contact.h"
#include "mechanics/contact/internal/contact_candidates.h"
#include "mechanics/contact/internal/contact_constraint.h"
#include "mechanics/contact/internal/cut_self_contact.h"
#include "mechanics/contact/internal/grasp_potential.h"
#include "mechanics/elements/load_vector.h"
#include "mechanics/statics/internal/unknowns.h"

namespace glisson::mechanics {

// Where a minimum was found last, and what it took all together.
struct Minimum {
  Eigen::VectorXd x_mm;  // unknowns
  int newton_steps = 0;
  double relative_residual = 0;
};

// The body's minimisation without contact.
struct BodyProblem {
  const TotalPotential& alone;
  double scale_mN;           // of its forces
  const Unknowns& unknowns;  // nodes or handles
  Minimum& minimum;          // where the search begins; moved on
  MinimiseOptions options;
  Progress progress;
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
  Result<bool> equilibrate_at_advances(const std::vector<ContactTool>& tools, const BodyProblem& problem);
  void update_multipliers(const std::vector<ContactTool>& tools);
  [[nodiscard]] Eigen::VectorXd surface_mm(const Eigen::VectorXd& u_mm) const;
  [[nodiscard]] Eigen::Vector3d force_of_tool(std::size_t tool) const;
  [[nodiscard]] Rod rod_of(const ContactConstraint& place, const std::vector<ContactTool>& tools) const;
  [[nodiscard]] Pose pose_of(std::size_t tool, const std::vector<ContactTool>& tools) const;

  const Body* body_;
  ContactOptions options_;
  geometry::Surface surface_;
  std::vector<int> node_of_point_;  // of the surface
  double k_mN_mm_, k_kPa_mm_;
  Eigen::VectorXd u_mm_, advance_mm_;
  std::vector<Gripped> grips_;
  std::vector<ContactConstraint> constraints_;
  std::vector<PrescribedPatch> patches_;
  CutSelfContact walls_;
  ContactReport report_;
};

}  // namespace glisson::mechanics

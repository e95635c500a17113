#pragma once
// Rigid tools that touch a linear elastic body, several at once, without friction. None enters it by more than a
// tolerance. Each is held in place or pushed by a force. Graspers hold a patch of the surface.
//
// The factor of the static model is kept. A unit force on a point of the surface is solved for once and remembered.
// That is done in fixed groups of neighbours, so that what is remembered does not depend on who asked first. Which
// points touch, and how hard, is then a small dense problem on the compliance of the points that may touch
// (contact_forces.h). It is solved again as the surface moves under the tool, until neither changes. The surface is the
// triangles of the body's boundary moved by their corners, on which the distance to a rod or a ball is exact.
// Self-contact of the walls of cuts is part of that problem.
//
// Lengths mm, forces mN, patient coordinates (LPS). Valid as far as small strain is.

#include <cstdint>
#include <Eigen/Core>
#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "base/result.h"
#include "geometry/surface.h"
#include "mechanics/cutting/opening.h"
#include "mechanics/elements/point_location.h"
#include "mechanics/scenario/rigid_tool.h"
#include "mechanics/statics/static_model.h"

namespace glisson::mechanics {

// A rigid tool either stays at its pose, or slides from it along the pose's forward direction until the body pushes
// back with `push_mN`.
struct TouchingTool {
  ToolShape shape;
  Pose pose;
  std::optional<double> push_mN;
  double friction = 0;  // Coulomb's coefficient, at large deformation alone: to ContactBody every tool is smooth
};

// Jaws that closed on the points of the surface within the radius of a place at rest, and turn freely about it. Their
// mean displacement (by area) beyond what the standing loads made is given, or a force pulls at them.
struct Grasp {
  Eigen::Vector3d at_rest_mm{0, 0, 0};
  double radius_mm = 0;
  std::variant<Eigen::Vector3d, double> drawn = Eigen::Vector3d(0, 0, 0);  // displacement (mm), or pull (mN) along:
  Eigen::Vector3d direction{0, 0, 1};
};

// A force spread over a patch is a dead load (scenario.h) that live_body.h alone takes in hand.
struct ContactTool {
  std::string id;
  std::variant<TouchingTool, Grasp, ToolLoad> what;
};

struct ContactOptions {
  double penetration_tolerance_mm = 0.1;  // a fiftieth of the smallest tool
  double movement_tolerance_mm = 0.05;    // of the surface, between the last two rounds
  int max_rounds = 60;
  double largest_move_mm = 3.0;  // of the surface or a tool in a round, so that none passes through the other
  // Of a state that only leads to the next: watched places and the largest strain are left out.
  bool on_the_way = false;
};

// What one tool does in a state.
struct ToolContact {
  std::string id;
  Eigen::Vector3d force_mN{0, 0, 0};  // on the body
  int contacts = 0;                   // places that it presses on, or points that it holds
  double advance_mm = 0;              // how far a pushed tool slid from its pose
  double penetration_mm = 0;          // the deepest of any place of the surface in it
  int sticking = 0, slipping = 0;     // of the contacts, where there is friction
};

struct ContactReport {
  bool converged = false;
  int rounds = 0;
  double penetration_mm = 0;     // the deepest of all
  double overlap_mm = 0;         // the deepest of walls that are kept apart, in each other
  double movement_mm = 0;        // between the last two rounds
  double relative_residual = 0;  // the largest of the solves that the state is a sum of
  double energy_uJ = 0;          // of the body, from the work of the tools' forces; standing loads apart
  double largest_strain = 0;     // the largest mean strain of any cell, by the corners' displacements
  int inverted_cells = 0;        // turned inside out, by their corners
  int new_solves = 0;            // right-hand sides that this state needed beyond what was remembered
  double solve_ms = 0;
};

// A place of the surface that a tool touched.
struct TouchedPlace {
  std::string tool;
  std::size_t rod = 0;        // of the tool's shape
  std::array<int, 3> points;  // of the surface
  Eigen::Vector3d weights;
};

struct ContactState {
  std::map<int, Eigen::Vector3d> force_mN;  // of tools and walls, on points of the surface
  std::map<int, double> wall_mN;            // by which walls of a live cut push each other apart, at opening()'s points
  std::vector<Eigen::Vector3d> jumps_mm;    // across a live cut, at opening()'s points
  std::vector<Eigen::Vector3d> surface_mm;  // displacement of each point of ContactBody::surface()
  std::vector<Eigen::Vector3d> watched_mm;  // and of each watched place
  std::vector<ToolContact> tools;
  std::vector<TouchedPlace> touched;  // where the next state looks first
  ContactReport report;
};

// A step in time of all nodes (mm, 3 a node). Without tools it would take the body to `taken_mm`. Jaws count from where
// it rests, `rest_mm`.
struct StepInTime {
  const Eigen::VectorXd& rest_mm;
  const Eigen::VectorXd& taken_mm;
};

class ContactBody {
 public:
  // The model's mutual points are those on walls of cuts (points_on), which slide along each other and do not pass
  // through. Without any, nothing keeps walls apart. Failures: those of StaticModel::solve; "not-converged" where that
  // may not be used.
  // The first `judged` watched places have the same bits in a state, whatever was solved for before; the others differ
  // by rounding in single precision.
  static Result<ContactBody> create(StaticModel model, const Loads& standing_loads, std::vector<PointInMesh> watched,
                                    std::size_t judged = 0);

  // Under the standing loads alone. With walls it may not have converged.
  [[nodiscard]] const ContactState& untouched() const;

  // With the tools, beginning from another state (its forces and advances are a guess). The same beginning and tools
  // give the same bits. A state that did not converge says so and must not be shown as right. Fails with
  // "tool-invalid". Fails with "tool-touches-nothing" where a pushed tool meets no surface on its way, or jaws hold no
  // point. Fails with "not-converged" (a solve that may not be used) or "not-available" (a force spread over a patch).
  [[nodiscard]] Result<ContactState> solve(const ContactState& from, const std::vector<ContactTool>& tools,
                                           const ContactOptions& options = {}) const;

  // The same within a step in time, of which the model's answers are (dynamics/moving_body.h): without a cut.
  [[nodiscard]] Result<ContactState> solve(const ContactState& from, const std::vector<ContactTool>& tools,
                                           const StepInTime& step, const ContactOptions& options) const;
  // Where a state's body lies when its nodes do so (mm, 3 a node): displacements, and the report's strain.
  void show(const Eigen::VectorXd& u_mm, ContactState& state) const;

  // The body with a cut opened further (opening.h), whose walls do not pass through each other. What was solved for is
  // shared. Its states begin from any of this one's. Failures: those of Opening::advanced; "not-available" where the
  // model has mutual points.
  [[nodiscard]] Result<ContactBody> opened(const CutStrip& strip) const;
  [[nodiscard]] const Opening* opening() const;  // nullptr: nothing is cut
  // Opening::prepare; false where nothing is cut.
  [[nodiscard]] Result<bool> prepare(const CutStrip& ahead) const;
  // Solves for what tools may touch next, nearest to where they are, so that a touch need not: less than a tenth of a
  // second's work on a liver. False where there is nothing more. No state changes by it. Failure: "not-converged".
  [[nodiscard]] Result<bool> prepare_touch(const ContactState& state, const std::vector<ContactTool>& tools) const;

  // The outer surface at rest.
  [[nodiscard]] const geometry::Surface& surface() const;
  [[nodiscard]] const StaticModel& model() const;

  // The surface as it lies, divided where a cut has opened, with the cut's walls (opened_surface.h).
  [[nodiscard]] Result<geometry::Surface> opened_surface(const ContactState& state) const;

  // A state without its displacements, which are a thousand times what forces take: what is kept of many. It begins a
  // solve as the whole state does, and `with_shape` gives its displacements back. Failure: "not-converged".
  [[nodiscard]] static ContactState without_shape(ContactState state);
  [[nodiscard]] Result<ContactState> with_shape(ContactState state) const;

  // Every mesh point's displacement (mm), and the whole result, by one more solve with the state's forces.
  [[nodiscard]] Result<StaticResult> whole_result(const ContactState& state) const;

 private:
  struct Impl;
  explicit ContactBody(std::shared_ptr<Impl> parts) : impl_(std::move(parts)) {}
  std::shared_ptr<Impl> impl_;  // what it remembers grows behind a lock; everything else stays
};

}  // namespace glisson::mechanics

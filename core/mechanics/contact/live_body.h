#pragma once
// A hyperelastic body under rigid tools and jaws at the speed of a hand, at large deformation. Around it are supports,
// foundations, ligaments, capsule, gas and gravity. There is Coulomb's friction, and cuts open. The fast counterpart of
// large_contact.h, with the same energy. Its minimum is not found by factors of each new tangent, but by a few
// conjugate gradients a picture, from the picture before.
//
// A step looks for the places that touch, and moves on by truncated Newton (Nocedal and Wright, Numerical Optimization,
// 7.1). The tangent's products are differences of the force, which costs two milliseconds for 20,000 cells. Two levels
// precondition it (spline_levels.h). How many gradients a step takes is a rule and never a clock. What is then left of
// the balance says how far the judged places are from where they will come to rest. It is the residual times what the
// body answered to unit forces there, by a factor that is kept (a dual weighted residual: Becker and Rannacher 2001,
// Acta Numerica 10:1), with what the tools keep from moving taken off. `error_bound_mm` is that with a safety found on
// other paths (docs/performance.md): an estimate that holds there, not a proof. Where the body slips off a tool to
// another rest, no residual foresees it.
//
// A tool presses by p = max(0, m - k g) at each place with gap g, as in large_contact.h. Steps may lead through cells
// turned inside out where the law's energy is finite there; no state has any. A step moves the multipliers m on once.
// Settling begins without them and with a stiffer k, and doubles that where a smooth tool is at rest deeper than the
// tolerance, up to 16 times: multipliers keep to the body, and such a tool slides from under them. Only then, under
// tools with friction and on walls, they move on. A pushed tool's advance is one unknown more; near nothing it slides
// on to the next place. A force spread over a patch is a dead load, as in statics.
//
// Friction is elastic and perfectly plastic with return mapping (Wriggers, Computational Contact Mechanics, 5.2). A
// spring along the surface, softer than k, ties a place to an anchor that goes with the tool. The place slips where the
// spring would pull with more than mu p; then the anchor is drawn along. What first presses in a step is anchored where
// it was, as the tool saw it, when the step began. The values of p and the normal are those at the beginning of each
// round of Newton's method. So a round has a potential energy. Once the rest is found they are those of the rest
// (lagged, as in Li et al. 2020, Incremental Potential Contact, ACM TOG 39:49). The spring gives by mu p over its
// stiffness, some hundredths of a millimetre. Anchors move from one step to the next: settling looks for the rest of
// the step under way.
//
// A cut opens as at small strain (cutting/opening.h). The same cells are open, by jumps that follow the nodes among the
// unknowns. The same springs bridge what the front has not passed. Nodes stay, and so does every level but one that is
// made for the cut. Walls do not pass through each other. Multipliers as for tools keep a point's jump from closing
// beyond zero along the wall's normal as it has turned. That holds while walls slide along each other by less than a
// cell. Gas follows the walls. Tools touch the outer surface, by the triangles that it had before. None reaches between
// the walls, and what is stretched over the gap still takes a tool.
//
// Lengths mm, forces mN, patient coordinates (LPS).

#include <array>
#include <Eigen/Core>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "mechanics/contact/contact.h"
#include "mechanics/cutting/opening.h"
#include "mechanics/scenario/scenario.h"

namespace glisson::mechanics {

struct LiveOptions {
  int gradients = 4;      // conjugate, of a round of Newton's method
  int most_rounds = 3;    // of a first picture, which ends before where it may be shown
  double shown_mm = 0.5;  // the bound up to which a picture may be shown as it is
  int settling_rounds = 60, settling_gradients = 60;
  double settled_mm = 0.01;         // what the weighted residual leaves at the judged places when it has come to rest
  double relative_residual = 1e-3;  // of all forces, then
  double penetration_tolerance_mm = 0.05, movement_tolerance_mm = 0.05;
  std::shared_ptr<const Eigen::VectorXd> besides_mN = nullptr;  // in motion: what acts on the nodes in this step, too
};

// A place of the surface that a tool is near (internal/contact_points.h), with the multiplier found so far.
struct LivePlace {
  std::string tool;
  std::size_t rod = 0;
  int face = 0, point = 0;                           // of the boundary, and which of the face's
  double multiplier_mN = 0;                          // of the next picture: what it presses with
  std::optional<double> settling_mN = std::nullopt;  // that of settling, once it has begun
  // Where it sticks to a tool with friction, in the tool's frame. The first is as the step began, the second where what
  // presses is drawn to by now.
  std::optional<Eigen::Vector3d> anchor_before_mm = std::nullopt, anchor_mm = std::nullopt;
};

// What the step under way began from, for friction: what meets a tool in it has slid as they moved by each other since.
struct LiveBegin {
  Eigen::VectorXd u_mm;               // of the nodes
  std::map<std::string, Pose> poses;  // of touching tools
};

struct LiveState {
  Eigen::VectorXd u_mm;                      // of all nodes, and then the jumps across a cut
  std::size_t advances = 0;                  // of the cut that it is of
  Eigen::VectorXd resisting_mN;              // what body and supports resist with there; empty: not computed yet
  std::map<std::string, double> advance_mm;  // of pushed tools
  std::vector<LivePlace> places;
  std::vector<double> wall_mN;              // by which walls push each other apart, one a jump
  std::vector<Eigen::Vector3d> surface_mm;  // displacement of each point of LiveBody::surface()
  std::vector<Eigen::Vector3d> watched_mm;
  std::vector<ToolContact> tools;
  std::map<std::string, Pose> poses;  // of touching tools, as far as they have advanced
  std::shared_ptr<const LiveBegin> began;
  double stiffer = 1;                  // times as stiff as settling began is what smooth tools press by
  Eigen::Vector3d moment_uJ{0, 0, 0};  // of the tools' forces about the origin (mN mm)
  double error_bound_mm = 0;           // of the judged places
  bool settled = false;
  ContactReport report;  // `rounds` counts conjugate gradients
};

class LiveBody {
 public:
  // Neo-Hookean or Veronda-Westmann. The model is of small strain, on the same mesh, with the same supports but for
  // ligaments. It gives the answers that errors are weighted by. The bound is of the first `judged` of the watched
  // places. Failures: "not-available" (another law, linear cells, an anisotropic body), "not-converged" (the standing
  // loads alone find no rest), those of applied_loads.
  // In motion (dynamics/moving_live_body.h) `inertia_mN_mm`, a diagonal over the nodes' displacements, resists as a
  // stiffness does, and the model is that of a step.
  static Result<LiveBody> create(StaticModel model, const ChosenLaw& law, const std::vector<Support>& supports,
                                 const Loads& standing_loads, std::vector<PointInMesh> watched, std::size_t judged,
                                 const Eigen::VectorXd& inertia_mN_mm = {});

  // Under the standing loads alone, at rest; of a body that was cut, before it was.
  [[nodiscard]] const LiveState& untouched() const;

  // A first picture with the tools where they are now; between two none should move by more than some millimetres. The
  // same beginning and tools give the same bits. Failures: "tool-invalid", "tool-touches-nothing", "not-converged"
  // (no step leads on without turning cells inside out, a tool would lie deep in the body, or slides past it).
  [[nodiscard]] Result<LiveState> step(const LiveState& from, const std::vector<ContactTool>& tools,
                                       const LiveOptions& options = {}) const;
  // Until it has come to rest; `settled` says whether it did. Failures: those of step, and "cancelled".
  [[nodiscard]] Result<LiveState> settle(const LiveState& from, const std::vector<ContactTool>& tools,
                                         const LiveOptions& options = {}, const Progress& progress = {}) const;

  // The body with a cut opened further. Its states begin from any of this one's; what is solved for is shared.
  // Failures: those of Opening::advanced.
  [[nodiscard]] Result<LiveBody> opened(const CutStrip& strip) const;
  [[nodiscard]] const Opening* opening() const;  // nullptr: nothing is cut
  // Opening::prepare; false where nothing is cut.
  [[nodiscard]] Result<bool> prepare(const CutStrip& ahead) const;

  [[nodiscard]] const geometry::Surface& surface() const;
  // The surface as it lies, divided where a cut has opened, with the cut's walls (opened_surface.h).
  [[nodiscard]] geometry::Surface opened_surface(const LiveState& state) const;
  // Across a live cut, at opening()'s points.
  [[nodiscard]] std::vector<Eigen::Vector3d> jumps_mm(const LiveState& state) const;
  [[nodiscard]] const StaticModel& model() const;
  // Every mesh point's displacement (mm), and the whole result.
  [[nodiscard]] StaticResult whole_result(const LiveState& state) const;

 private:
  struct Impl;
  explicit LiveBody(std::shared_ptr<const Impl> parts) : impl_(std::move(parts)) {}
  std::shared_ptr<const Impl> impl_;
};

}  // namespace glisson::mechanics

#pragma once
// A live linear rehearsal: the patient's liver and its reference body (the atlas) (same mesh and supports, one modulus)
// under the same tool. Moving the tool costs a solve; turning it or changing its force is a superposition, well under 1
// ms.
//
// There is no state in which a force could be set and no tool be there. create() gives the rehearsal, place_tool()
// gives a tool placed, and only that answers. All of it is immutable: the window may place a tool on a worker thread
// while it draws the answers of the one before.

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "geometry/surface.h"
#include "geometry/tetrahedra.h"
#include "mechanics/scenario/meshfree_options.h"
#include "mechanics/statics/static_model.h"
#include "mechanics/statics/validity.h"
#include "rehearsal/comparison.h"
#include "rehearsal/session_cut.h"

namespace glisson::rehearsal {

struct RehearsalModels;

struct RehearsalSetup {
  geometry::TetMesh mesh;
  std::vector<double> patient_youngs_kPa;      // one a cell
  std::optional<double> reference_youngs_kPa;  // the reference body's single modulus; absent: no reference body
  std::vector<mechanics::Support> supports;
  mechanics::Loads standing_loads;  // act always: gravity, pneumoperitoneum
  std::vector<mechanics::Landmark> landmarks;
  std::vector<geometry::Surface> structures;  // tumours, vessels: their points move with the liver around them
  mechanics::StaticOptions options;           // a fibre direction in them is the patient's; the reference body has none
  double landmark_tolerance_mm = 10.0;
  // Of a session's bodies; linear is small strain. StaticRehearsal is linear whatever it says.
  mechanics::ChosenLaw law = mechanics::MaterialLaw::linear;
  // How soon the patient stiffens with strain, where that was found (Veronda and Westmann's c2): at large strain that
  // is the patient's law in place of a neo-Hookean one. The reference body keeps `law`.
  std::optional<double> patient_stiffening = std::nullopt;
  // A session moves in steps of that many seconds, with that damping (session.h); its `steps` are not read. Absent:
  // every state is at rest.
  std::optional<mechanics::Motion> motion = std::nullopt;
  // In motion at small strain, how the patient's tissue relaxes to its moduli, which are those after long. The
  // reference body is elastic.
  mechanics::Relaxation relaxation = {};
  // By the meshfree engine, at small strain alone; absent: by finite elements.
  std::optional<mechanics::MeshfreeOptions> meshfree = std::nullopt;
  // Of this very setup, where they were made before: seconds and a factor each are spared.
  std::shared_ptr<const RehearsalModels> models = nullptr;
  // Of a meshfree session, where they were made before: the same by finite elements.
  std::shared_ptr<const RehearsalModels> elements = nullptr;
};

[[nodiscard]] mechanics::ChosenLaw law_of_patient(const RehearsalSetup& setup);
// The same by another law, with its models where they serve that law.
[[nodiscard]] RehearsalSetup with_law(RehearsalSetup setup, const mechanics::ChosenLaw& law);

// The same, linear and by finite elements, in motion. On two cores the demo patient and its reference body are shown in
// slow motion by such steps.
inline constexpr double step_in_the_hand_s = 0.04;
[[nodiscard]] RehearsalSetup in_motion(RehearsalSetup setup, double step_s);

// The same, linear, by the meshfree engine, beside its own models.
[[nodiscard]] RehearsalSetup by_meshfree(RehearsalSetup setup, const mechanics::MeshfreeOptions& options);

// A mesh with what a scenario says of it, without a reference body; its loads stand, and tissue that relaxes has done
// so. A scenario's motion is the session's. Failures: "not-available" (what no session knows: cuts, tools), those of
// youngs_modulus_of_cells.
Result<RehearsalSetup> rehearsal_setup(geometry::TetMesh mesh, const mechanics::Scenario& scenario);

// The patient's mesh and supports with one modulus and no fibre direction. It is factorised when somebody first asks
// for it, and then kept: until something is compared it would take as much memory as the patient.
class ReferenceBody {
 public:
  ReferenceBody(mechanics::StaticModel patient, double youngs_kPa);
  // Made once, whoever asks first; the others wait. Failures: those of StaticModel::create.
  [[nodiscard]] Result<mechanics::StaticModel> model(const Progress& progress = {}) const;

 private:
  struct Made;
  mechanics::StaticModel patient_;
  double youngs_kPa_;
  std::shared_ptr<Made> made_;
};

// The two bodies. Copies are cheap.
struct RehearsalModels {
  mechanics::StaticModel patient;               // factorised
  std::optional<ReferenceBody> reference = {};  // absent without a reference body
};
// `setup.models` where there are any; at large strain without ligaments, which only pull. Failures: those of
// StaticModel::create, and of MeshfreeModel::create and static_model.
Result<std::shared_ptr<const RehearsalModels>> rehearsal_models(const RehearsalSetup& setup,
                                                                const Progress& progress = {});

// One of the two bodies under the present force.
struct RehearsalBody {
  std::vector<Eigen::Vector3d> surface_mm;                  // displaced points of StaticRehearsal::surface()
  std::vector<std::vector<Eigen::Vector3d>> structures_mm;  // displaced points of each structure
  std::vector<mechanics::DisplacedLandmark> landmarks;
  double max_displacement_mm = 0;  // over the surface
};

struct RehearsalState {
  Eigen::Vector3d force_N{0, 0, 0};
  RehearsalBody patient;
  std::optional<RehearsalBody> reference;
  std::vector<LandmarkDifference> differences;  // patient against atlas; empty without a reference body
  double max_difference_mm = 0;                 // over the surface
  double relative_residual = 0;                 // the larger of the solves it is made from
  mechanics::Validity validity = {};            // of the patient's body
  double answer_ms = 0;
  std::shared_ptr<const SessionCut> cut = nullptr;  // of a session (session.h) alone
};

class PlacedTool {
 public:
  [[nodiscard]] const Eigen::Vector3d& center_mm() const;
  [[nodiscard]] double radius_mm() const;
  [[nodiscard]] std::size_t touched_faces() const;
  [[nodiscard]] double solve_ms() const;  // what placing it cost
  [[nodiscard]] bool compared() const;    // the reference body lies under it too

  // The bodies under that force (N, patient LPS). The force must be finite.
  [[nodiscard]] RehearsalState answer(const Eigen::Vector3d& force_N) const;

  // The largest force (N, to a thousandth of `maximum_N`) along that unit direction which stays within the model. It is
  // at most `maximum_N`, and 0 where the standing loads leave it already.
  [[nodiscard]] double force_within_the_model_N(const Eigen::Vector3d& direction, double maximum_N) const;

  // Displacement of every mesh point of the patient's body (mm), for saving a result.
  [[nodiscard]] std::vector<Eigen::Vector3d> patient_displacement_mm(const Eigen::Vector3d& force_N) const;

 private:
  friend class StaticRehearsal;
  struct Impl;
  explicit PlacedTool(std::shared_ptr<const Impl> parts) : impl_(std::move(parts)) {}
  std::shared_ptr<const Impl> impl_;
};

class StaticRehearsal {
 public:
  // Failures: those of StaticModel::create; "landmark-outside".
  static Result<StaticRehearsal> create(RehearsalSetup setup, const Progress& progress = {});

  // On both bodies, or on the patient's alone, whose answers then are compared with nothing. The first tool on both
  // makes the reference body, which takes as long as create. Failures: "tool-touches-nothing"; "not-converged" where a
  // solve may not be used; those of make_reference.
  enum class On { both, patient };
  [[nodiscard]] Result<PlacedTool> place_tool(const Eigen::Vector3d& center_mm, double radius_mm,
                                              On bodies = On::both) const;

  [[nodiscard]] bool has_reference() const;
  // Whether a tool on both would not have to wait for it; true where there is none.
  [[nodiscard]] bool reference_is_made() const;
  // Nothing where it is there, or there is none. Failures: those of StaticModel::create; "not-converged".
  [[nodiscard]] Result<void> make_reference(const Progress& progress = {}) const;

  // The liver's outer surface at rest, whose points the states displace.
  [[nodiscard]] const geometry::Surface& surface() const;
  [[nodiscard]] const std::shared_ptr<const RehearsalModels>& models() const;
  [[nodiscard]] const mechanics::StaticModel& patient() const;
  [[nodiscard]] double setup_s() const;

 private:
  struct Impl;
  explicit StaticRehearsal(std::shared_ptr<const Impl> parts) : impl_(std::move(parts)) {}
  std::shared_ptr<const Impl> impl_;
  friend class PlacedTool;
};

}  // namespace glisson::rehearsal

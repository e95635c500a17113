#pragma once
// A scenario on a mesh, from question to answer: what `glisson-cli simulate` runs.

#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "geometry/tetrahedra.h"
#include "mechanics/contact/contact.h"
#include "mechanics/dynamics/implicit_euler.h"
#include "mechanics/elements/point_location.h"
#include "mechanics/materials/material_data.h"
#include "mechanics/scenario/cut.h"
#include "mechanics/scenario/scenario.h"
#include "mechanics/statics/static_result.h"
#include "mechanics/statics/validity.h"

namespace glisson::mechanics {

// The point field of a result, three components.
inline const std::string displacement_field = "displacement_mm";

struct DisplacedLandmark {
  std::string id;
  Eigen::Vector3d rest_mm{0, 0, 0};
  Eigen::Vector3d displaced_mm{0, 0, 0};
  double displacement_mm = 0;
  double outside_by_mm = 0;  // above 0: the landmark lies outside the body and moves with its nearest place
};

// A step of a motion, at its end.
struct TimeStep {
  double time_s = 0;
  std::vector<Eigen::Vector3d> landmarks_mm;   // in the scenario's order
  Eigen::Vector3d fixed_reaction_mN{0, 0, 0};  // as in StaticResult, with what the damping takes
  Eigen::Vector3d foundation_reaction_mN{0, 0, 0};
  Eigen::Vector3d ligament_reaction_mN{0, 0, 0};
  StepReport report;
  double largest_strain = 0;  // as in StaticResult
};

struct SimulationOptions {
  // A landmark farther than this from the body is refused: it is in another frame, or of another patient.
  double landmark_tolerance_mm = 10.0;

  // Measured strain and stress in place of the scenario's material and modulus (data_driven.h): an equilibrium by
  // finite elements.
  std::optional<MaterialData> data = std::nullopt;

  // The first OpenCL device whose name contains this solves the system of each step of a motion; "" takes any. The
  // motion is by finite elements, linear or corotational, without tools.
  std::optional<std::string> device = std::nullopt;
};

struct Simulation {
  Scenario scenario;
  StaticResult result;
  std::vector<DisplacedLandmark> landmarks;
  std::vector<ToolContact> tools;        // in contact, as the scenario lists them
  std::optional<ContactReport> contact;  // where there are any
  std::optional<CutOpening> cut;         // where the body was cut
  double share_beyond_data = 0;          // of an equilibrium from data (data_driven.h)
  std::vector<TimeStep> steps;           // of a motion; empty for an equilibrium
  geometry::TetMesh mesh;                // the rest mesh with point field "displacement_mm" (3) and cell fields
                                         // "youngs_modulus_kPa" and "von_mises_kPa", as written to result.vtu
};

// Of a motion the worst of its steps.
[[nodiscard]] Validity validity_of(const Simulation& simulation);

// Failures: those of StaticModel and of ContactBody; "landmark-outside", "cut-invalid", "cut-misses". Fails with
// "modulus-missing" where there is no such cell field, or one of the wrong size (the fields there are named). Fails
// with "not-available" for data in motion, in the meshfree engine, in a capsule or on a foundation.
Result<Simulation> simulate(const geometry::TetMesh& mesh, const Scenario& scenario,
                            const SimulationOptions& options = {}, const Progress& progress = {});

// Can this question be asked of a body with a fibre direction?
[[nodiscard]] bool may_be_anisotropic(const Scenario& scenario);

// Where the landmarks lie in the body. Failures: "landmark-outside" (the first beyond the tolerance),
// "landmark-invalid" (not a finite point).
Result<std::vector<PointInMesh>> locate_landmarks(const geometry::TetMesh& mesh, const std::vector<Landmark>& landmarks,
                                                  double tolerance_mm);

// One for each landmark, from its place and displacement.
[[nodiscard]] std::vector<DisplacedLandmark> displaced_landmarks(const std::vector<Landmark>& landmarks,
                                                                 const std::vector<PointInMesh>& places,
                                                                 const std::vector<Eigen::Vector3d>& displacements_mm);

// Young's modulus of every cell in an equilibrium (kPa): as the scenario says, the mesh's own converted to the
// scenario's Poisson's ratio (scenario/mesh_moduli.h), and of tissue that relaxes what is left of it after long.
Result<std::vector<double>> youngs_modulus_of_cells(const geometry::TetMesh& mesh, const Scenario& scenario);

}  // namespace glisson::mechanics

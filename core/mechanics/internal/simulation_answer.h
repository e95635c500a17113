#pragma once
// What the engines answer a scenario with, whichever it was.

#include <optional>
#include <vector>

#include "mechanics/elements/body.h"
#include "mechanics/materials/material.h"
#include "mechanics/scenario/cut.h"
#include "mechanics/simulation.h"
#include "mechanics/statics/static_model.h"

namespace glisson::mechanics {

struct Answer {
  StaticResult result;
  std::vector<Eigen::Vector3d> landmark_displacements_mm;
  std::vector<double> von_mises_kPa;  // one a cell
  std::vector<TimeStep> steps;
  std::vector<ToolContact> tools;  // in contact
  std::optional<ContactReport> contact;
  double share_beyond_data = 0;  // of an answer from data
};
using Places = std::vector<PointInMesh>;

// A scenario on a mesh that is open along its cuts. What is named must outlive it.
struct Question {
  const geometry::TetMesh& mesh;
  const std::vector<double>& youngs_kPa;  // one a cell
  const Scenario& scenario;
  const Places& places;                      // of the landmarks
  std::vector<OpenedBody::Wall> walls = {};  // of cuts, to be kept apart
  std::optional<std::string> device = {};    // as in SimulationOptions
};

[[nodiscard]] bool has_ligaments(const Scenario& scenario);
[[nodiscard]] StaticOptions options_of(const Scenario& scenario);

// A body of any material, laid out for its equilibrium.
struct MaterialBody {
  Body body;
  std::vector<Material> materials;
  double setup_s = 0;
};
Result<MaterialBody> material_body(const Question& question);
[[nodiscard]] Answer answer_of(const MaterialBody& prepared, StaticResult result, const Places& places);

// All tools' ways gone to a part. And the radius of the thinnest rod of any, 10 at most.
[[nodiscard]] std::vector<ContactTool> tools_at(const std::vector<ScenarioTool>& tools, double part);
[[nodiscard]] double thinnest_rod_mm(const std::vector<ScenarioTool>& tools);

// By finite elements and the kept factor, with the scenario's tools and the walls. Material, supports and tools must be
// such that forces answer linearly.
Result<Answer> linear_contact_equilibrium(const Question& question, const Progress& progress);
// At large deformation, of any material: the minimum of the potential energy, with tools and walls or without.
Result<Answer> nonlinear_equilibrium(const Question& question, const Progress& progress);
// The same over the handles of the meshfree engine, of linear materials too; without walls.
Result<Answer> meshfree_equilibrium(const Question& question, const Progress& progress);

// From rest, under loads that are there from the first moment.
// Of a motion by finite elements: one linear system a step, and not Newton's method.
[[nodiscard]] bool moves_by_one_solve(const Scenario& scenario);
Result<Answer> fem_dynamics(const Question& question, const Progress& progress);
Result<Answer> meshfree_dynamics(const Question& question, const Progress& progress);

}  // namespace glisson::mechanics

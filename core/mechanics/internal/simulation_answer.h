#pragma once
// What the engines answer a scenario with, whichever it was. Inside of this room.

#include <optional>
#include <vector>

#include "mechanics/elements/body.h"
#include "mechanics/materials/material.h"
#include "mechanics/simulation.h"
#include "mechanics/statics/static_model.h"

namespace glisson::mechanics {

struct Answer {
  StaticResult result;
  std::vector<Eigen::Vector3d> landmark_displacements_mm;
  std::vector<double> von_mises_kPa;  // one a cell
  std::vector<MotionStep> steps;
  std::vector<ToolContact> tools;  // in contact
  std::optional<ContactReport> contact;
};
using Places = std::vector<PointInMesh>;

[[nodiscard]] bool has_ligaments(const Scenario& scenario);
[[nodiscard]] StaticOptions options_of(const Scenario& scenario);

// A body of any material, laid out for its equilibrium.
struct MaterialBody {
  Body body;
  std::vector<Material> materials;
  double setup_s = 0;
};
Result<MaterialBody> material_body(const geometry::TetMesh& mesh, std::vector<double> youngs_kPa,
                                   const Scenario& scenario);
[[nodiscard]] Answer answer_of(const MaterialBody& prepared, StaticResult result, const Places& places);

// All tools' ways gone to a part. And the radius of the thinnest rod of any, 10 at most.
[[nodiscard]] std::vector<ContactTool> tools_at(const std::vector<ScenarioTool>& tools, double part);
[[nodiscard]] double thinnest_rod_mm(const std::vector<ScenarioTool>& tools);

// With the scenario's tools.
Result<Answer> small_contact_equilibrium(const geometry::TetMesh& mesh, std::vector<double> youngs_kPa,
                                         const Scenario& scenario, const Places& places, const Progress& progress);
Result<Answer> large_contact_equilibrium(const geometry::TetMesh& mesh, std::vector<double> youngs_kPa,
                                         const Scenario& scenario, const Places& places, const Progress& progress);
Result<Answer> meshfree_contact_equilibrium(const geometry::TetMesh& mesh, std::vector<double> youngs_kPa,
                                            const Scenario& scenario, const Places& places, const Progress& progress);

// The same by finite elements, tools or none, with the walls of the scenario's cuts kept apart.
Result<Answer> small_equilibrium_of_walls(const geometry::TetMesh& mesh, std::vector<double> youngs_kPa,
                                          const Scenario& scenario, const Places& places,
                                          const std::vector<OpenedBody::Wall>& walls, const Progress& progress);
Result<Answer> large_equilibrium_of_walls(const geometry::TetMesh& mesh, std::vector<double> youngs_kPa,
                                          const Scenario& scenario, const Places& places,
                                          const std::vector<OpenedBody::Wall>& walls, const Progress& progress);

// From rest, under loads that are there from the first moment.
Result<Answer> end_of_motion(const geometry::TetMesh& mesh, std::vector<double> youngs_kPa, const Scenario& scenario,
                             const Places& places, const Progress& progress);
Result<Answer> end_of_meshfree_motion(const geometry::TetMesh& mesh, std::vector<double> youngs_kPa,
                                      const Scenario& scenario, const Places& places, const Progress& progress);

}  // namespace glisson::mechanics

#include "casefile/sofa.h"

#include <fmt/format.h>
#include <algorithm>

#include "base/files.h"
#include "base/write_file.h"
#include "casefile/internal/sofa_scene.h"
#include "casefile/model.h"
#include "casefile/used_entries.h"
#include "geometry/mesh_file.h"
#include "mechanics/elements/load_vector.h"
#include "mechanics/scenario/scenario_file.h"
#include "mechanics/simulation.h"
#include "mechanics/statics/static_model.h"
#include "rehearsal/tool_presets.h"

namespace glisson::casefile {
namespace fs = std::filesystem;
namespace {

using Eigen::Vector3d;
using mechanics::Scenario;

Result<void> check_can_hold(const Scenario& scenario);
Result<Scenario> usual_retraction(const PatientModel& model, std::vector<Sentence>& remarks);
Sentence left_out(const char* effect);
void leave_out(Scenario& scenario, std::vector<Sentence>& remarks);
Result<SofaScene> scene_of(const mechanics::Body& body, const Scenario& scenario, const PatientModel& model);
Result<std::string> expected_places(const mechanics::Body& body, const Scenario& scenario,
                                    std::vector<Sentence>& remarks, const Progress& progress);

}  // namespace

Result<SofaExport> export_sofa(const Case& patient, std::optional<Scenario> asked, const fs::path& out,
                               const Progress& progress) {
  if (asked) {
    if (auto can = check_can_hold(*asked); !can) return failure(std::move(can.error()));
  }
  auto model = read_model(patient);
  if (!model) return failure(model.error());
  SofaExport written;
  written.remarks = model_remarks(patient);
  if (!asked) {
    auto usual = usual_retraction(*model, written.remarks);
    if (!usual) return failure(std::move(usual.error()));
    asked = *std::move(usual);
  }
  Scenario& scenario = *asked;
  if (model->assumed && !scenario.youngs_modulus) written.remarks.push_back(*model->assumed);
  if (scenario.motion && !model->relaxation.empty()) written.remarks.push_back(left_out("viscoelastic-creep"));
  model->relaxation.clear();  // the scene has the moduli that are left after long
  for (Sentence& said : put_into(scenario, *model)) written.remarks.push_back(std::move(said));
  leave_out(scenario, written.remarks);

  auto youngs_kPa = mechanics::youngs_modulus_of_cells(model->mesh, scenario);
  if (!youngs_kPa) return failure(std::move(youngs_kPa.error()));
  mechanics::StaticOptions options;
  options.poisson_ratio = scenario.poisson_ratio;
  options.density_kg_mm3 = scenario.density_kg_mm3;
  options.order = mechanics::ElementOrder::linear;
  const auto body =
      mechanics::prepare_body(model->mesh, *std::move(youngs_kPa), scenario.supports, options,
                              scenario.motion ? mechanics::Holding::optional : mechanics::Holding::required);
  if (!body) return failure(body.error());
  const auto scene = scene_of(*body, scenario, *model);
  if (!scene) return failure(scene.error());
  std::string expected;
  if (scenario.material == mechanics::MaterialLaw::linear && !scenario.motion) {
    auto places = expected_places(*body, scenario, written.remarks, progress.part(0, 0.9));
    if (!places) return failure(std::move(places.error()));
    expected = *std::move(places);
  }

  progress.report(0.9, GLISSON_TEXT("Writing"));
  const auto write = [&](const fs::path& file, const std::string& text) {
    written.files.push_back(file);
    return write_file(file, text);
  };
  return write_together([&]() -> Result<void> {
           if (auto mesh = write(out / scene->mesh_file, sofa_mesh(body->layout)); !mesh) return mesh;
           for (std::size_t s = 0; s < scene->shapes.size(); ++s) {
             written.files.push_back(out / scene->shapes[s].file);
             if (auto shape = geometry::write_surface(written.files.back(), model->structures[s].surface); !shape) {
               return shape;
             }
           }
           if (!expected.empty()) {
             if (auto places = write(out / "expected.csv", expected); !places) return places;
           }
           return write(out / "scene.scn", sofa_scene(*body, *scene));
         })
      .map([&] { return std::move(written); });
}

namespace {

Result<void> check_can_hold(const Scenario& scenario) {
  const auto cannot = [](const std::string& what) {
    return failure(Error{"sofa-cannot-hold",
                         GLISSON_TEXT("A scene for SOFA cannot hold what the scenario says with {0}."),
                         {what},
                         GLISSON_TEXT("It holds linear and corotational bodies by finite elements, fixed points, "
                                      "foundations and loads."),
                         {}});
  };
  const bool linear = scenario.material == mechanics::MaterialLaw::linear;
  if (scenario.engine != mechanics::Engine::fem) return cannot("\"engine\": \"meshfree\"");
  if (!linear && scenario.material != mechanics::MaterialLaw::corotational) {
    return cannot(fmt::format("\"material\": \"{}\"", mechanics::name_of(scenario.material)));
  }
  if (!scenario.cuts.empty()) return cannot("\"cuts\"");
  if (!scenario.tools.empty()) return cannot("\"tools\"");
  if (scenario.capsule) return cannot("\"capsule\"");
  if (scenario.anisotropy) return cannot("\"anisotropy\"");
  if (!scenario.relaxation.empty()) return cannot("\"relaxation\"");
  for (const mechanics::Support& support : scenario.supports) {
    if (std::holds_alternative<mechanics::Ligament>(support.how)) return cannot("\"ligament\"");
    const auto* fixed = std::get_if<mechanics::Fixed>(&support.how);
    if (fixed != nullptr && !fixed->displacement_mm.isZero(0)) return cannot("\"displacement_mm\"");
  }
  const bool gas = std::any_of(scenario.loads.begin(), scenario.loads.end(), [](const mechanics::Load& load) {
    return std::holds_alternative<mechanics::PressureLoad>(load);
  });
  if (gas && !linear) return cannot("\"pressure_kPa\"");  // which there follows the surface
  return {};
}

Result<Scenario> usual_retraction(const PatientModel& model, std::vector<Sentence>& remarks) {
  return rehearsal::hoist_segment_vi(model.mesh).map([&](const rehearsal::ToolPlacement& placement) {
    Scenario scenario;
    const double force_N = placement.preset.usual_force_N;
    scenario.loads = {rehearsal::tool_load(placement, force_N)};
    remarks.push_back(
        {GLISSON_TEXT("Without a scenario, the scene hoists segment VI with {0} N."), {fmt::format("{:g}", force_N)}});
    return scenario;
  });
}

Sentence left_out(const char* effect) {
  return {GLISSON_TEXT("A scene for SOFA cannot hold the effect {0}: it is left out."), {effect}};
}

void leave_out(Scenario& scenario, std::vector<Sentence>& remarks) {
  if (scenario.capsule) remarks.push_back(left_out("capsule"));
  if (scenario.anisotropy) remarks.push_back(left_out("anisotropy"));
  scenario.capsule.reset();
  scenario.anisotropy.reset();
  if (scenario.material == mechanics::MaterialLaw::linear) return;
  // Gas that follows the surface of a body that turns.
  const auto is_gas = [](const mechanics::Load& load) { return std::holds_alternative<mechanics::PressureLoad>(load); };
  if (std::erase_if(scenario.loads, is_gas) > 0) remarks.push_back(left_out("preload"));
}

Result<SofaScene> scene_of(const mechanics::Body& body, const Scenario& scenario, const PatientModel& model) {
  SofaScene scene;
  scene.title = fmt::format("A liver's model, written by Glisson {}.", version());
  scene.law = scenario.material;
  scene.motion = scenario.motion;
  scene.mesh_file = "liver.vtk";
  for (std::size_t l = 0; l < scenario.loads.size(); ++l) {
    const mechanics::Load& load = scenario.loads[l];
    const char* kind = std::holds_alternative<mechanics::ToolLoad>(load)       ? "tool"
                       : std::holds_alternative<mechanics::PressureLoad>(load) ? "pressure"
                                                                               : "gravity";
    auto forces = mechanics::load_vector(body.mesh, body.layout, body.boundary, body.options.density_kg_mm3, {load});
    if (!forces) return failure(std::move(forces.error()));
    scene.loads.push_back({fmt::format("{}-{}", kind, l + 1), *std::move(forces)});
  }
  for (const mechanics::Landmark& landmark : scenario.landmarks) {
    scene.landmarks.push_back({landmark.id, landmark.position_mm});
  }
  for (const StructureSurface& structure : model.structures) {
    scene.shapes.push_back({structure.name, structure.name + ".obj", structure.color_rgb});
  }
  return scene;
}

// Where the scene should bring what is followed, and where Glisson does, as a table.
Result<std::string> expected_places(const mechanics::Body& body, const Scenario& scenario,
                                    std::vector<Sentence>& remarks, const Progress& progress) {
  const auto model = mechanics::StaticModel::create(body.mesh, body.youngs_kPa, scenario.supports, body.options,
                                                    progress.part(0, 0.3));
  if (!model) return failure(model.error());
  const auto linear = model->solve(scenario.loads);
  if (!linear) return failure(linear.error());
  const auto quadratic = mechanics::simulate(body.mesh, scenario, {}, progress.part(0.3, 1));
  if (!quadratic) return failure(quadratic.error());
  const auto places =
      mechanics::locate_landmarks(body.mesh, scenario.landmarks, mechanics::SimulationOptions{}.landmark_tolerance_mm);
  if (!places) return failure(places.error());
  const std::vector<Vector3d> by_linear_mm = model->displacement_at(*linear, *places);

  std::string table = "id,x_mm,y_mm,z_mm,scene_x_mm,scene_y_mm,scene_z_mm,glisson_x_mm,glisson_y_mm,glisson_z_mm\n";
  const auto add = [&](const std::string& id, const Vector3d& rest_mm, const Vector3d& scene_mm,
                       const Vector3d& glisson_mm) {
    table += id;
    for (const Vector3d& at_mm : {rest_mm, scene_mm, glisson_mm}) {
      table += fmt::format(",{:.4f},{:.4f},{:.4f}", at_mm.x(), at_mm.y(), at_mm.z());
    }
    table += "\n";
  };
  for (std::size_t l = 0; l < scenario.landmarks.size(); ++l) {
    const Vector3d& rest_mm = scenario.landmarks[l].position_mm;
    add(scenario.landmarks[l].id, rest_mm, rest_mm + by_linear_mm[l], quadratic->landmarks[l].displaced_mm);
  }
  const auto& moved_mm = linear->displacement_mm;
  const auto farthest = static_cast<std::size_t>(
      std::max_element(moved_mm.begin(), moved_mm.end(),
                       [](const Vector3d& a, const Vector3d& b) { return a.squaredNorm() < b.squaredNorm(); }) -
      moved_mm.begin());
  const Vector3d& rest_mm = body.mesh.points_mm[farthest];
  add(fmt::format("node-{}", body.layout.node_of_point[farthest]), rest_mm, rest_mm + moved_mm[farthest],
      rest_mm + quadratic->result.displacement_mm[farthest]);

  remarks.push_back({GLISSON_TEXT("SOFA's linear tetrahedra are stiffer than the quadratic ones here: the largest "
                                  "displacement should be {0} mm in the scene, and is {1} mm in Glisson."),
                     {fmt::format("{:.2f}", linear->max_displacement_mm),
                      fmt::format("{:.2f}", quadratic->result.max_displacement_mm)}});
  remarks.push_back(mechanics::validity_of(*quadratic).sentence());
  return table;
}

}  // namespace
}  // namespace glisson::casefile

// A palpation that creeps, from what was measured to a motion that creeps alike: explain, accept and simulate, through
// the program itself. What is measured and what is expected are made of elastic answers and the closed form of a creep
// function; the program is told neither.

#include <gmock/gmock.h>
#include <cmath>
#include <random>

#include "base/files.h"
#include "base/json.h"
#include "base/units.h"
#include "casefile/case.h"
#include "geometry/mesh_file.h"
#include "mechanics/bodies.h"
#include "mechanics/scenario/mesh_moduli.h"
#include "mechanics/statics/displacements.h"
#include "mechanics/statics/equilibrium.h"
#include "mechanics/statics/static_model.h"
#include "support/process.h"

namespace glisson::test {
namespace {

namespace fs = std::filesystem;
namespace mt = mechanics::test;
using Eigen::Vector3d;

constexpr double amplitude = 0.45, delay_s = 3.0, youngs_kPa = 8.0, noise_mm = 0.03;

// F + a y, T y' + y = F, for a force that grows evenly from 0 at 0 s to `ramp_s` and is held then: by hand.
double creeping_load(double force_N, double ramp_s, double time_s) {
  const double ramp = std::min(time_s, ramp_s), slope = force_N / ramp_s;
  double delayed = slope * (ramp - delay_s * (1 - std::exp(-ramp / delay_s)));
  if (time_s > ramp_s) delayed = force_N + (delayed - force_N) * std::exp(-(time_s - ramp_s) / delay_s);
  return slope * ramp + amplitude * delayed;
}

geometry::TetMesh pad() {
  auto mesh = mt::box(5, 5, 3, {60, 60, 30});
  mt::disturb_inner_points(mesh, 1.0);
  mt::name_points(mesh, "bare_area", [](const Vector3d& p) { return p.z() < 1e-9; });
  mechanics::set_moduli(mesh, mt::uniform(mesh, youngs_kPa), 0.45);
  return mesh;
}
const std::vector<mechanics::Support> held{mt::fixed("bare_area")};

Json answer(std::vector<std::string> arguments) {
  arguments.insert(arguments.end(), {"--json", "--quiet"});
  const Finished finished = glisson_cli(arguments);
  EXPECT_EQ(finished.exit_code, 0) << arguments.front() << ": " << finished.err;
  return finished.json();
}

// Four places pressed by 0.8 N within a second, watched at once and through a hold of 12 s.
void write_palpation(const fs::path& folder, const geometry::TetMesh& mesh) {
  const auto model = mechanics::StaticModel::create(mesh, mt::uniform(mesh, youngs_kPa), held, {}).value();
  std::mt19937 random(11);
  std::uniform_real_distribution<double> anywhere(3, 57);
  std::normal_distribution<double> noise(0, noise_mm);
  std::vector<Vector3d> places;
  for (int m = 0; m < 30; ++m) places.emplace_back(anywhere(random), anywhere(random), 30.0);
  const auto in_mesh = mechanics::locate_points(mesh, places);
  Json trials = Json::array();
  for (int t = 0; t < 4; ++t) {
    const Vector3d center(t % 2 == 0 ? 20.0 : 40.0, t < 2 ? 22.0 : 40.0, 30);
    const mechanics::Loads one_N{mechanics::ToolLoad{center, 9, {0, 0, -1000}}};
    const auto by_one_N = model.displacement_at(model.solve(one_N).value(), in_mesh);
    const std::string id = "p0" + std::to_string(t + 1);
    Json samples = Json::array();
    samples.push_back(Json{{"time_s", 0}, {"force_N", 0}});
    for (const double time_s : {1.0, 2.5, 5.0, 13.0}) {
      const std::string name = id + "_" + std::to_string(static_cast<int>(10 * time_s)) + ".csv";
      std::string markers = "id,rest_x_mm,rest_y_mm,rest_z_mm,x_mm,y_mm,z_mm\n";
      for (std::size_t m = 0; m < places.size(); ++m) {
        const Vector3d at = places[m] + creeping_load(0.8, 1.0, time_s) * by_one_N[m] +
                            Vector3d(noise(random), noise(random), noise(random));
        markers += "m" + std::to_string(m);
        for (const Vector3d& p : {places[m], at}) {
          for (int d = 0; d < 3; ++d) markers += "," + std::to_string(p[d]);
        }
        markers += "\n";
      }
      ASSERT_TRUE(write_text_file(folder / name, markers));
      samples.push_back(Json{{"time_s", time_s}, {"force_N", 0.8}, {"markers", name}});
    }
    trials.push_back(Json{{"id", id},
                          {"tool", {{"center_mm", json_of(center)}, {"radius_mm", 9}, {"direction", {0, 0, -1}}}},
                          {"samples", samples}});
  }
  ASSERT_TRUE(geometry::write_tetrahedra(folder / "pad.vtu", mesh));
  ASSERT_TRUE(write_text_file(folder / "experiment.json", Json{{"format", "glisson-experiment/1"},
                                                               {"kind", "palpation"},
                                                               {"title", "A pad that creeps"},
                                                               {"specimen",
                                                                {{"mesh", "pad.vtu"},
                                                                 {"youngs_modulus_kPa", "youngs_modulus_kPa"},
                                                                 {"poisson_ratio", 0.45},
                                                                 {"density_kg_m3", 1000}}},
                                                               {"supports", {{{"point_array", "bare_area"}}}},
                                                               {"noise_mm", noise_mm},
                                                               {"trials", trials}}
                                                              .dump()));
}

TEST(Creep, ThatAPalpationShowsIsAcceptedAndTheMotionCreepsByItsClosedForm) {
  const TemporaryFolder folder;
  const auto file = [&](const std::string& name) { return (folder.path() / name).string(); };
  const geometry::TetMesh mesh = pad();
  write_palpation(folder.path(), mesh);
  auto made = casefile::Case::create(file("pad.glisson"));
  ASSERT_TRUE(made);
  ASSERT_TRUE(made->add("meshes/model", ".vtu", {"stiffness", {}, {}, {}, {}},
                        [&](const fs::path& to) { return geometry::write_tetrahedra(to, mesh); }));

  const Json report = answer({"explain", file("experiment.json"), "--out", file("explained")});
  ASSERT_EQ(report.at("verdict"), "explained");
  ASSERT_EQ(report.at("effects").size(), 1u);
  ASSERT_EQ(report.at("effects")[0].at("kind"), "viscoelastic-creep");
  const Json accepted = answer({"accept", file("pad.glisson"), file("explained/model.json")});
  EXPECT_TRUE(accepted.at("effects")[0].at("carried").get<bool>());

  // Pushed to the side for 6 s, elsewhere than it was measured.
  const mechanics::ToolLoad push{{30, 30, 30}, 12, {150, 0, 80}};
  const std::vector<mechanics::Landmark> landmarks{{"top", {30, 30, 29}}, {"middle", {22, 35, 15}}};
  Json scenario{{"motion", {{"step_s", 0.02}, {"steps", 300}, {"mass_damping_per_s", 10}}},
                {"supports", {{{"point_array", "bare_area"}}}},
                {"loads", {{{"tool", {{"center_mm", {30, 30, 30}}, {"radius_mm", 12}, {"force_N", {0.15, 0, 0.08}}}}}}},
                {"landmarks", Json::array()}};
  std::vector<Vector3d> places;
  for (const auto& landmark : landmarks) {
    scenario["landmarks"].push_back(Json{{"id", landmark.id}, {"position_mm", json_of(landmark.position_mm)}});
    places.push_back(landmark.position_mm);
  }
  ASSERT_TRUE(write_text_file(file("push.json"), scenario.dump()));
  const Json moved = answer({"simulate", file("pad.glisson"), "--scenario", file("push.json"), "--out", file("moved")});
  EXPECT_EQ(moved.at("evidence").size(), 1u);
  const Json asked = Json::parse(read_text_file(file("moved/scenario.json")).value());
  ASSERT_EQ(asked.at("relaxation").size(), 1u);

  // The elastic answer of the same linear cells, by Newton's method at rest, times J(t).
  mechanics::StaticOptions options;
  options.order = mechanics::ElementOrder::linear;
  const auto body =
      mechanics::prepare_body(mesh, mt::uniform(mesh, youngs_kPa), held, options, mechanics::Holding::required).value();
  const auto elastic = mechanics::displacement_at(
      body,
      mechanics::find_equilibrium(body, materials_of(body, mechanics::MaterialLaw::linear), mechanics::Loads{push})
          .value(),
      mechanics::locate_points(mesh, places));
  ASSERT_GT(elastic[0].norm(), 0.5);
  for (const int step : {24, 49, 99, 199, 299}) {
    const double time_s = 0.02 * (step + 1);
    const double crept = 1 + amplitude * (1 - std::exp(-time_s / delay_s));
    for (std::size_t l = 0; l < landmarks.size(); ++l) {
      const Json& at = moved.at("steps")[static_cast<std::size_t>(step)].at("landmarks")[l].at("position_mm");
      const Vector3d u_mm =
          Vector3d(at[0].get<double>(), at[1].get<double>(), at[2].get<double>()) - landmarks[l].position_mm;
      EXPECT_LT((u_mm - crept * elastic[l]).norm(), 0.02 * elastic[l].norm()) << landmarks[l].id << ", " << time_s;
    }
  }

  // In the hand: jaws pull for as long and let go. What a session at rest shows is what is left after long.
  scenario.erase("loads");
  scenario["relaxation"] = asked.at("relaxation");
  ASSERT_TRUE(write_text_file(file("in-motion.json"), scenario.dump()));
  scenario.erase("motion");
  ASSERT_TRUE(write_text_file(file("at-rest.json"), scenario.dump()));
  Json commands = Json::array();
  commands.push_back({{"hold",
                       {{"id", "jaws"},
                        {"grasp", {{"at_rest_mm", {30, 30, 30}}, {"radius_mm", 12}}},
                        {"pull_mN", 150},
                        {"direction", {1, 0, 0.5}}}}});
  for (const int steps : {24, 25, 50, 100, 100}) commands.push_back({{"wait_steps", steps}});
  commands.push_back({{"release", "jaws"}});
  for (const int steps : {49, 100}) commands.push_back({{"wait_steps", steps}});
  ASSERT_TRUE(write_text_file(file("pull.json"), Json{{"format", "glisson-session/1"}, {"commands", commands}}.dump()));
  const auto session = [&](const char* by) {
    return answer({"session", "--mesh", file("pad.vtu"), "--scenario", file(by), "--commands", file("pull.json")});
  };
  const Json rest = session("at-rest.json"), moving = session("in-motion.json");
  const auto pulled_mm = [](const Json& frame) {
    const Json& at = frame.at("landmarks")[0].at("displaced_mm");
    return at[0].get<double>() - 30;
  };
  const auto crept = [](double time_s) { return 1 + amplitude * (1 - std::exp(-time_s / delay_s)); };
  const double elastic_mm = pulled_mm(rest.at("frames")[0]) / (1 + amplitude);
  ASSERT_GT(elastic_mm, 0.5);
  for (std::size_t frame = 1; frame < 9; ++frame) {
    const Json& shown = moving.at("frames")[frame];
    const double time_s = shown.at("motion").at("time_s");
    const double expected = frame < 6 ? crept(time_s) : crept(time_s) - crept(time_s - 6);
    if (frame == 6) continue;  // it has just been let go
    EXPECT_NEAR(pulled_mm(shown), expected * elastic_mm, 0.02 * elastic_mm) << time_s;
  }
  EXPECT_EQ(moving.at("motion").at("steps"), 450);
  EXPECT_GT(moving.at("motion").at("steps_per_s").get<double>(), 0);
  EXPECT_FALSE(rest.contains("motion"));
}

}  // namespace
}  // namespace glisson::test

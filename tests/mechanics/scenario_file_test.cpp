// Scenarios are read as they are meant, or refused with what is wrong and where.

#include "mechanics/scenario/scenario_file.h"

#include <gmock/gmock.h>

#include "base/files.h"

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;
using testing::AllOf;
using testing::HasSubstr;

constexpr const char* whole_scenario = R"({
  "engine": "fem", "material": "linear", "poisson_ratio": 0.45, "density_kg_m3": 1060,
  "youngs_modulus_kPa": "measured_kPa",
  "supports": [{"point_array": "fixed"},
               {"sphere": {"center_mm": [1, 2, 3], "radius_mm": 20}, "foundation_kPa_per_mm": 0.5},
               {"box": {"min_mm": [0, 0, 0], "max_mm": [1, 2, 3]}, "directions": ["x", "z"]}],
  "loads": [{"tool": {"center_mm": [4, 5, 6], "radius_mm": 10, "force_N": [0, 0, 5]}},
            {"pressure_kPa": 1.6}, {"gravity_m_s2": [0, 0, -9.81]}],
  "motion": {"step_s": 0.01, "steps": 50, "stiffness_damping_s": 0.002},
  "landmarks": [{"id": "tumour-1", "position_mm": [7, 8, 9]}]})";

TEST(ScenarioFile, ReadsEveryPartAndConvertsItsUnits) {
  const Scenario scenario = parse_scenario(whole_scenario).value();
  EXPECT_EQ(scenario.engine, Engine::fem);
  EXPECT_EQ(scenario.material, MaterialLaw::linear);
  EXPECT_DOUBLE_EQ(scenario.density_kg_mm3, 1060e-9);
  EXPECT_EQ(std::get<std::string>(*scenario.youngs_modulus), "measured_kPa");
  ASSERT_EQ(scenario.supports.size(), 3u);
  EXPECT_EQ(std::get<NamedPoints>(scenario.supports[0].where).point_array, "fixed");
  EXPECT_EQ(std::get<Fixed>(scenario.supports[0].how).directions, (std::array{true, true, true}));
  EXPECT_EQ(std::get<Ball>(scenario.supports[1].where).center_mm, Vector3d(1, 2, 3));
  EXPECT_EQ(std::get<Foundation>(scenario.supports[1].how).stiffness_kPa_per_mm, 0.5);
  EXPECT_EQ(std::get<geometry::Box>(scenario.supports[2].where).max_mm, Vector3d(1, 2, 3));
  EXPECT_EQ(std::get<Fixed>(scenario.supports[2].how).directions, (std::array{true, false, true}));
  ASSERT_EQ(scenario.loads.size(), 3u);
  EXPECT_EQ(std::get<ToolLoad>(scenario.loads[0]).force_mN, Vector3d(0, 0, 5000));
  EXPECT_EQ(std::get<PressureLoad>(scenario.loads[1]).pressure_kPa, 1.6);
  EXPECT_EQ(std::get<GravityLoad>(scenario.loads[2]).acceleration_mm_s2, Vector3d(0, 0, -9810));
  EXPECT_EQ(scenario.landmarks[0].position_mm, Vector3d(7, 8, 9));
  EXPECT_EQ(scenario.motion->steps, 50);
  EXPECT_EQ(scenario.motion->stiffness_damping_s, 0.002);
}

TEST(ScenarioFile, WhatIsWrittenReadsBackTheSame) {
  const std::string once = scenario_text(parse_scenario(whole_scenario).value());
  EXPECT_EQ(scenario_text(parse_scenario(once).value()), once);
}

constexpr const char* surgical_scenario = R"({
  "material": "veronda-westmann", "strain_stiffening": 3.5, "tissue": "liver-dissertation-cohort",
  "supports": [{"point_array": "bare_area"},
               {"sphere": {"center_mm": [1, 2, 3], "radius_mm": 20},
                "ligament": {"anchor_mm": [0, -90, 10], "stiffness_N_per_mm": 0.2, "slack_mm": 4}}],
  "capsule": {"thickness_mm": 0.08},
  "relaxation": [{"weight": 0.3, "time_s": 0.5}, {"weight": 0.25, "time_s": 40}],
  "loads": [{"gravity_of_patient": {"reverse_trendelenburg_deg": 30, "right_tilt_deg": 10, "scanned_supine": true}}],
  "cuts": [{"center_mm": [1, 2, 3], "normal": [0, 0, 2], "radius_mm": 30},
           {"points_mm": [[0, 0, 0], [9, 0, 1], [0, 9, 0], [9, 9, 2]]},
           {"points_mm": [[0, 0, 0], [9, 0, 1], [0, 9, 0]], "center_mm": [5, 5, 0], "radius_mm": 4}],
  "tools": [{"id": "hook", "shape": "nathanson-retractor", "position_mm": [1, 2, 3], "direction": [0, 0, 1],
             "push_N": 2},
            {"id": "rod", "shape": {"rods": [{"from_mm": [0, 0, 0], "to_mm": [9, 0, 0], "radius_mm": 2}]},
             "position_mm": [1, 2, 3], "direction": [0, 1, 0], "advance_mm": 5, "friction": 0.2},
            {"id": "jaws", "grasp": {"center_mm": [4, 5, 6], "radius_mm": 6}, "pull_N": [0, 0, 1.5]}]})";

TEST(ScenarioFile, ReadsLigamentsCapsuleTissueThePositionOfThePatientCutsAndTools) {
  const Scenario scenario = parse_scenario(surgical_scenario).value();
  EXPECT_EQ(scenario.material, MaterialLaw::veronda_westmann);
  EXPECT_EQ(scenario.strain_stiffening, 3.5);
  EXPECT_DOUBLE_EQ(std::get<double>(*scenario.youngs_modulus), 2.1 * 2 * 1.45);
  EXPECT_EQ(std::get<Ligament>(scenario.supports[1].how).stiffness_mN_per_mm, 200);
  EXPECT_EQ(std::get<Ligament>(scenario.supports[1].how).slack_mm, 4);
  EXPECT_EQ(scenario.capsule->youngs_modulus_kPa, 8220);
  EXPECT_EQ(scenario.capsule->thickness_mm, 0.08);
  ASSERT_EQ(scenario.relaxation.size(), 2u);
  EXPECT_EQ(scenario.relaxation[1].weight, 0.25);
  EXPECT_EQ(scenario.relaxation[1].time_s, 40);
  // What is new since the scan: towards the feet and the right, and less towards the back.
  const Vector3d gravity = std::get<GravityLoad>(scenario.loads[0]).acceleration_mm_s2;
  EXPECT_NEAR(gravity.z(), -4905, 1e-9);
  EXPECT_LT(gravity.x(), 0);
  EXPECT_LT(gravity.y(), 0);
  ASSERT_EQ(scenario.cuts.size(), 3u);
  EXPECT_EQ(scenario.cuts[0].normal, Vector3d(0, 0, 1));
  EXPECT_EQ(scenario.cuts[0].radius_mm, 30);
  EXPECT_EQ(scenario.cuts[1].points_mm.size(), 4u);
  EXPECT_EQ(scenario.cuts[2].center_mm, Vector3d(5, 5, 0));
  ASSERT_EQ(scenario.tools.size(), 3u);
  EXPECT_EQ(*std::get<ScenarioRigidTool>(scenario.tools[0].what).push_mN, 2000);
  EXPECT_EQ(std::get<ScenarioRigidTool>(scenario.tools[1].what).advance_mm, 5);
  EXPECT_EQ(std::get<ScenarioRigidTool>(scenario.tools[1].what).friction, 0.2);
  EXPECT_EQ(std::get<ScenarioRigidTool>(scenario.tools[0].what).friction, 0);
  EXPECT_EQ(*std::get<ScenarioGrasp>(scenario.tools[2].what).pull_mN, Vector3d(0, 0, 1500));
  const std::string once = scenario_text(scenario);
  EXPECT_EQ(scenario_text(parse_scenario(once).value()), once);
}

TEST(ScenarioFile, AnEmptyScenarioHasTheDefaults) {
  const Scenario scenario = parse_scenario("{}").value();
  EXPECT_EQ(scenario.poisson_ratio, 0.45);
  EXPECT_FALSE(scenario.youngs_modulus);  // the mesh's own field
}

std::string refusal(const std::string& json) {
  const auto scenario = parse_scenario(json, "s.json");
  if (scenario) return "accepted";
  EXPECT_EQ(scenario.error().file, "s.json");
  return scenario.error().message() + " " + scenario.error().advice();
}

TEST(ScenarioFile, AMisspeltKeyIsToldWhatWasMeantAtEveryDepth) {
  EXPECT_THAT(refusal(R"({"poison_ratio": 0.4})"), HasSubstr("Did you mean \"poisson_ratio\"?"));
  EXPECT_THAT(refusal(R"({"supports": [{"point_aray": "fixed"}]})"),
              AllOf(HasSubstr("support 1"), HasSubstr("Did you mean \"point_array\"?")));
  EXPECT_THAT(
      refusal(
          R"({"loads": [{"pressure_kPa": 1}, {"tool": {"centre_mm": [0,0,0], "radius_mm": 1, "force_N": [0,0,1]}}]})"),
      AllOf(HasSubstr("load 2, tool"), HasSubstr("Did you mean \"center_mm\"?")));
  EXPECT_THAT(refusal(R"({"landmarks": [{"id": "a", "position": [0,0,0]}]})"), HasSubstr("position_mm"));
}

TEST(ScenarioFile, ValuesThatCannotBeMeantAreRefusedWithTheirPlace) {
  const std::pair<const char*, const char*> refused[] = {
      {R"({"engine": "fen"})", "engine must be one of \"fem\", \"meshfree\""},
      {R"({"material": "ogden"})", "material must be one of"},
      {R"({"poisson_ratio": 0.5})", "poisson_ratio must lie between -1 and 0.5"},
      {R"({"poisson_ratio": "0.4"})", "poisson_ratio must be a finite number"},
      {R"({"density_kg_m3": -1})", "density_kg_m3 must be above zero"},
      {R"({"youngs_modulus_kPa": 0})", "youngs_modulus_kPa must be above zero"},
      {R"({"youngs_modulus_kPa": 1e999})", ""},
      {R"({"supports": {"point_array": "fixed"}})", "supports must be a list"},
      {R"({"supports": [{}]})", "support 1 needs exactly one of"},
      {R"({"supports": [{"point_array": "a", "box": {"min_mm": [0,0,0], "max_mm": [1,1,1]}}]})", "exactly one of"},
      {R"({"supports": [{"sphere": {"center_mm": [0,0], "radius_mm": 2}}]})", "must be three numbers"},
      {R"({"supports": [{"sphere": {"center_mm": [0,0,0]}}]})", "lacks \"radius_mm\""},
      {R"({"supports": [{"box": {"min_mm": [0,0,5], "max_mm": [1,1,1]}}]})", "must not exceed"},
      {R"({"supports": [{"point_array": "a", "foundation_kPa_per_mm": 0}]})", "must be above zero"},
      {R"({"supports": [{"point_array": "a", "foundation_kPa_per_mm": 1, "directions": ["x"]}]})", "has both"},
      {R"({"supports": [{"point_array": "a", "directions": ["w"]}]})", "must be one of \"x\", \"y\", \"z\""},
      {R"({"loads": [{"tool": {"center_mm": [0,0,0], "radius_mm": -1, "force_N": [0,0,1]}}]})",
       "radius_mm must be above zero"},
      {R"({"loads": [{"pressure_kPa": 1, "gravity_m_s2": [0,0,1]}]})", "load 1 needs exactly one of"},
      {R"({"loads": [3]})", "load 1 must be an object"},
      {R"({"landmarks": [{"id": "a", "position_mm": [0,0,0]}, {"id": "a", "position_mm": [1,0,0]}]})", "the same id"},
      {R"({"motion": {"step_s": 0.02, "steps": 0}})", "whole number from 1"},
      {R"({"motion": {"step_s": 0.02, "steps": 5, "mass_damping_per_s": -1}})", "must not be below zero"},
      {R"({"material": "veronda-westmann"})", "give both or neither"},
      {R"({"tissue": "spleen"})", "There is no published tissue spleen"},
      {R"({"tissue": "liver-published-cohort", "youngs_modulus_kPa": 3})", "both say how stiff"},
      {R"({"relaxation": {"weight": 0.3, "time_s": 1}})", "relaxation must be a list"},
      {R"({"relaxation": [{"weight": 0.3}]})", "relaxation 1 lacks \"time_s\""},
      {R"({"relaxation": [{"weight": 0, "time_s": 1}]})", "relaxation 1, weight must be above zero"},
      {R"({"relaxation": [{"weight": 0.3, "time_s": -1}]})", "relaxation 1, time_s must be above zero"},
      {R"({"relaxation": [{"weight": 1.5, "time_s": 1}]})", "Term 1 of a relaxation needs a weight between 0 and 1"},
      {R"({"relaxation": [{"weight": 0.7, "time_s": 1}, {"weight": 0.3, "time_s": 2}]})", "sum to less than 1"},
      {R"({"relaxation": [{"weight": 0.7, "times": 1}]})", "\"time_s\""},
      {R"({"capsule": {}})", "lacks \"thickness_mm\""},
      {R"({"supports": [{"point_array": "a", "directions": ["x"], "ligament": {}}]})", "is a ligament"},
      {R"({"loads": [{"gravity_of_patient": {"left_tilt_deg": 120}}]})", "between -90 and 90"},
      {R"({"cut_walls": "closed"})", "cut_walls"},
      {R"({"cuts": [{"center_mm": [0,0,0], "normal": [0,0,0]}]})", "cut 1, normal must not be zero"},
      {R"({"cuts": [{"center_mm": [0,0,0]}]})", "cut 1 needs exactly one of"},
      {R"({"cuts": [{"center_mm": [0,0,0], "normal": [0,0,1], "radius": 3}]})", "\"radius_mm\""},
      {R"({"cuts": [{"points_mm": [[0,0,0], [1,0,0]]}]})", "three points or more"},
      {R"({"cuts": [{"points_mm": [[0,0,0], [1,0,0], [0,1,0]], "center_mm": [0,0,0]}]})", "needs the \"radius_mm\""},
      {R"({"tools": [{"id": "a", "shape": "hammer", "position_mm": [0,0,0], "direction": [0,0,1], "push_N": 1}]})",
       "tool 1, shape must be"},
      {R"({"tools": [{"id": "a", "shape": "palpation-probe", "position_mm": [0,0,0], "direction": [0,0,1]}]})",
       "exactly one of \"advance_mm\" and \"push_N\""},
      {R"({"tools": [{"id": "a", "grasp": {"center_mm": [0,0,0], "radius_mm": 3}, "push_N": 1}]})", "push_N"},
      {R"({"tools": [{"id": "a", "shape": "palpation-probe", "position_mm": [0,0,0], "direction": [0,0,1], "push_N": 1,
          "friction": -0.1}]})",
       "tool 1, friction must not be below zero"},
      {R"([])", "must be an object"},
      {R"({"engine": )", "not valid JSON"},
  };
  for (const auto& [json, expected] : refused) {
    EXPECT_THAT(refusal(json), HasSubstr(expected)) << json;
    EXPECT_NE(refusal(json), "accepted") << json;
  }
}

TEST(ScenarioFile, AFileThatIsNotThereIsNamed) {
  const TemporaryFolder folder;
  const auto scenario = read_scenario(folder.path() / "none.json");
  ASSERT_FALSE(scenario);
  EXPECT_THAT(scenario.error().message(), HasSubstr("none.json"));
}

}  // namespace
}  // namespace glisson::mechanics

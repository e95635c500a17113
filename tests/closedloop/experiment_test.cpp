// Experiments are read strictly: what cannot be right is refused with the file, the line and the likely cause.

#include "closedloop/experiment/experiment.h"

#include <gmock/gmock.h>
#include <fstream>

#include "base/files.h"
#include "base/json.h"
#include "geometry/mesh_file.h"
#include "mechanics/scenario/mesh_moduli.h"
#include "support/shapes.h"

namespace glisson::closedloop {
namespace {

using testing::HasSubstr;

class ExperimentFile : public testing::Test {
 protected:
  TemporaryFolder folder;

  void write(const std::string& name, const std::string& text) const { std::ofstream(folder.path() / name) << text; }
  Result<Experiment> read(const Json& json, Needs needs = Needs::measurements) const {
    write("e.json", json.dump(1));
    return read_experiment(folder.path() / "e.json", needs);
  }
  std::string refusal(const Json& json) const {
    const auto experiment = read(json);
    return experiment ? "it was read" : experiment.error().message() + " " + experiment.error().advice();
  }

  Json material() const {
    write("a.csv", "t,stretch,stress\n0,1,0\n1,0.9,-1.3\n2,0.8,-2.5\n");
    return Json::parse(R"({"format": "glisson-experiment/1", "kind": "material", "title": "cylinder",
      "specimen": {"shape": "cylinder", "diameter_mm": 50, "height_mm": 30}, "mode": "compression",
      "declared": {"law": "linear", "youngs_modulus_kPa": 13.2}, "noise_kPa": 0.2,
      "trials": [{"id": "a1", "file": "a.csv",
                  "columns": {"time_s": "t", "stretch": "stretch", "stress_kPa": "stress"}}]})");
  }
  Json hardware() const {
    write("1c.csv", "t,I,U,T\n0,3,3.6,23\n10,3,3.5,24\n20,3,3.4,25\n");
    return Json::parse(R"({"format": "glisson-experiment/1", "kind": "platform",
      "declared": {"law": "constant", "energy_Wh": 10.8, "nominal_voltage_V": 3.6, "idle_W": 0},
      "noise": {"voltage_V": 0.005, "temperature_C": 0.2},
      "trials": [{"id": "1C", "file": "1c.csv", "ambient_C": 23,
                  "columns": {"time_s": "t", "current_A": "I", "voltage_V": "U", "temperature_C": "T"}}]})");
  }
  Json palpation() const {
    auto mesh = glisson::test::box_of_tetrahedra({4, 4, 2}, {80, 80, 40});
    geometry::set_field(mesh.point_fields, {"fixed", 1, std::vector<double>(mesh.points_mm.size(), 1)});
    EXPECT_TRUE(geometry::write_tetrahedra(folder.path() / "specimen.vtu", mesh));
    write("p01_1.csv",
          "id,rest_x_mm,rest_y_mm,rest_z_mm,x_mm,y_mm,z_mm\nm1,10,10,40,10,10,39.5\nm2,70,40,40,70,40,38.5\n");
    return Json::parse(R"({"format": "glisson-experiment/1", "kind": "palpation", "title": "pad",
      "specimen": {"mesh": "specimen.vtu", "youngs_modulus_kPa": 17.5, "poisson_ratio": 0.45, "density_kg_m3": 1000},
      "supports": [{"point_array": "fixed"}], "gravity_m_s2": [0,0,0], "noise_mm": 0.15,
      "trials": [{"id": "p01", "tool": {"center_mm": [40,40,40], "radius_mm": 10, "direction": [0,0,-2]},
                  "samples": [{"time_s": 0, "force_N": 0},
                              {"time_s": 2, "force_N": 1.7, "markers": "p01_1.csv"}]}]})");
  }
};

TEST_F(ExperimentFile, StressAgainstTheStrainIsRefusedAndALoadCellsZeroIsNot) {
  const Json json = material();
  write("a.csv", "t,stretch,stress\n0,1,0\n1,0.9,1.3\n2,0.8,2.5\n");
  EXPECT_THAT(refusal(json), HasSubstr("opposite signs"));
  write("a.csv", "t,stretch,stress\n0,1,2\n1,0.98,1.7\n2,0.96,1.5\n");
  EXPECT_TRUE(read(json));
}

TEST_F(ExperimentFile, AMaterialTestIsReadInNominalStressAndStretch) {
  Json json = material();
  write("forces.csv", "Time,mm,N\n0,0,0\n1,-3,-2.5\n");
  json["trials"].push_back({{"id", "a2"},
                            {"file", "forces.csv"},
                            {"columns", {{"time_s", "Time"}, {"displacement_mm", "mm"}, {"force_N", "N"}}}});
  const auto experiment = read(json);
  ASSERT_TRUE(experiment) << experiment.error().message();
  const auto& read = std::get<Material>(experiment->setup);
  ASSERT_EQ(read.trials.size(), 2u);
  EXPECT_EQ(read.trials[0].stress_kPa[2], -2.5);
  EXPECT_DOUBLE_EQ(read.trials[1].stretch[1], 0.9);
  EXPECT_NEAR(read.trials[1].stress_kPa[1], -2.5e3 / (3.14159265 * 625), 1e-6);  // mN over mm2
}

TEST_F(ExperimentFile, APlatformsEnergyVoltageAndCapacityCompleteEachOther) {
  const auto experiment = read(hardware());
  ASSERT_TRUE(experiment) << experiment.error().message();
  EXPECT_DOUBLE_EQ(std::get<Hardware>(experiment->setup).capacity_Ah.value(), 3.0);
}

TEST_F(ExperimentFile, APalpationIsReadInTheUnitsInside) {
  const auto experiment = read(palpation());
  ASSERT_TRUE(experiment) << experiment.error().message();
  const auto& read = std::get<Palpation>(experiment->setup);
  EXPECT_EQ(read.trials[0].tool.direction, Eigen::Vector3d(0, 0, -1));
  EXPECT_DOUBLE_EQ(read.trials[0].samples[1].force_mN, 1700);
  EXPECT_EQ(read.trials[0].samples[1].markers[1].id, "m2");
  EXPECT_EQ(read.cell_young_kPa.size(), read.mesh.cells.size());
}

TEST_F(ExperimentFile, ModuliMadeByAnotherPoissonsRatioAreRefused) {
  Json json = palpation();
  const auto file = folder.path() / "specimen.vtu";
  auto mesh = geometry::read_tetrahedra(file).value();
  mechanics::set_moduli(mesh, std::vector<double>(mesh.cells.size(), 17.5), 0.49);
  ASSERT_TRUE(geometry::write_tetrahedra(file, mesh));
  json["specimen"]["youngs_modulus_kPa"] = mechanics::youngs_modulus_field;
  EXPECT_THAT(refusal(json), HasSubstr("by a Poisson's ratio of 0.49, not 0.45. Say \"poisson_ratio\": 0.49"));
  json["specimen"]["poisson_ratio"] = 0.49;
  EXPECT_TRUE(read(json));
}

TEST_F(ExperimentFile, WhatIsNotThereIsRefusedWithTheLineThatNamesIt) {
  Json json = palpation();
  json["trials"][0]["samples"][1]["markers"] = "p99.csv";
  EXPECT_THAT(refusal(json), AllOf(HasSubstr("Line "), HasSubstr("p99.csv"), HasSubstr("not there")));
  json["trials"][0]["samples"] = Json::array();
  EXPECT_THAT(refusal(json), AllOf(HasSubstr("p01"), HasSubstr("no samples"), HasSubstr("line ")));
  json = material();
  json["trials"][0]["columns"]["stress_kPa"] = "load";
  EXPECT_THAT(refusal(json), AllOf(HasSubstr("a.csv"), HasSubstr("no column \"load\""), HasSubstr("line 1")));
}

TEST_F(ExperimentFile, UnitsThatCannotBeRightAreRefused) {
  Json json = palpation();
  json["specimen"]["youngs_modulus_kPa"] = 17000;
  EXPECT_THAT(refusal(json), AllOf(HasSubstr("17000"), HasSubstr("Pa?")));
  json = palpation();
  write("p01_1.csv",
        "id,rest_x_mm,rest_y_mm,rest_z_mm,x_mm,y_mm,z_mm\n1,.01,.01,.04,.01,.01,.039\n2,.07,.04,.04,.07,.04,.038\n");
  EXPECT_THAT(refusal(json), AllOf(HasSubstr("p01_1.csv"), HasSubstr("metres")));
  write("p01_1.csv", "id,rest_x_mm,rest_y_mm,rest_z_mm,x_mm,y_mm,z_mm\nm1,10,10,40,10,10,39\nm2,170,40,40,170,40,38\n");
  EXPECT_THAT(refusal(json), AllOf(HasSubstr("Line 3 of p01_1.csv"), HasSubstr("outside")));
  json = material();
  write("a.csv", "t,stretch,stress\n0,0,0\n1,-10,-1.3\n2,-20,-2.5\n");
  EXPECT_THAT(refusal(json), AllOf(HasSubstr("Line 2 of a.csv"), HasSubstr("stretch")));
}

TEST_F(ExperimentFile, BrokenTablesAreRefusedWithTheLine) {
  Json json = material();
  write("a.csv", "t,stretch,stress\n0,1,0\n2,0.9,-1.3\n1,0.8,-2.5\n");
  EXPECT_THAT(refusal(json), AllOf(HasSubstr("goes back at line 4 of a.csv"), HasSubstr("recordings")));
  write("a.csv", "t,stretch,stress\n0,1,0\n1,0.9,\n2,0.8,-2.5\n");
  EXPECT_THAT(refusal(json), HasSubstr("Line 3 of a.csv has no number under \"stress\""));
  json = palpation();
  json["trials"][0]["samples"][1]["time_s"] = -1;
  EXPECT_THAT(refusal(json), AllOf(HasSubstr("p01"), HasSubstr("time goes back at sample 2")));
  json = palpation();
  write("p01_1.csv", "id,rest_x_mm,rest_y_mm,rest_z_mm,x_mm,y_mm\nm1,10,10,40,10,10\n");
  EXPECT_THAT(refusal(json), HasSubstr("Line 1 of p01_1.csv names no column \"z_mm\""));
}

TEST_F(ExperimentFile, MisspeltKeysAndForeignFilesAreRefused) {
  Json json = hardware();
  json["declared"]["enery_Wh"] = 10;
  EXPECT_THAT(refusal(json), AllOf(HasSubstr("enery_Wh"), HasSubstr("energy_Wh")));
  EXPECT_THAT(refusal(Json::object()), HasSubstr("glisson-experiment/1"));
  json = hardware();
  json["kind"] = "telepathy";
  EXPECT_THAT(refusal(json), HasSubstr("telepathy"));
}

TEST_F(ExperimentFile, ToPredictNoMeasurementIsNeeded) {
  Json json = material();
  json["trials"][0]["columns"].erase("stress_kPa");
  EXPECT_THAT(refusal(json), HasSubstr("stress_kPa"));
  EXPECT_TRUE(read(json, Needs::conditions));
}

}  // namespace
}  // namespace glisson::closedloop

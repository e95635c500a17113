// The liver retracted straight from measurements: what a law of the same numbers says, where measurements are its line.

#include "casefile/retraction_from_data.h"

#include <gmock/gmock.h>

#include "base/files.h"
#include "base/write_file.h"
#include "casefile/structures.h"
#include "mechanics/simulation.h"
#include "rehearsal/tool_presets.h"
#include "segmentation/edit.h"

namespace glisson::casefile {
namespace {

namespace fs = std::filesystem;

constexpr double own_kPa = 6, force_N = 0.3;

class RetractionFromMeasurements : public testing::Test {
 protected:
  void SetUp() override {
    auto patient = Case::create(folder_);
    ASSERT_TRUE(patient);
    imaging::Mask ball;
    ball.grid.size = {24, 24, 24};
    ball.grid.spacing_mm = {3, 3, 3};
    ball.values.resize(ball.grid.voxels());
    ball = segmentation::paint(std::move(ball), {{36, 36, 36}, 28});
    ASSERT_TRUE(save_structure(*patient, segmentation::make_structure("liver", ball), {"segment", {}, {}, {}, {}}));
    meshing::MeshOptions options;
    options.target_cells = 600;
    ASSERT_TRUE(mesh_liver(*patient, options));
    ASSERT_TRUE(assign_stiffness(*patient, Uniform{own_kPa}));
  }
  Case open() { return Case::open(folder_).value(); }

  // A straight line of stress over strain, from -20 to 20 %.
  fs::path line(double slope_kPa) {
    std::string text = "strain,stress_kPa\n";
    for (int i = -20; i <= 20; ++i) {
      text += std::to_string(0.01 * i) + "," + std::to_string(0.01 * i * slope_kPa) + "\n";
    }
    fs::path file = temporary_.path() / "line.csv";
    EXPECT_TRUE(write_text_file(file, text));
    return file;
  }

  TemporaryFolder temporary_;
  fs::path folder_ = temporary_.path() / "patient.glisson";
};

TEST_F(RetractionFromMeasurements, OfTheModelsOwnLineIsTheModelsAnswer) {
  const auto answer = retract_from_data(open(), line(own_kPa), force_N);
  ASSERT_TRUE(answer) << answer.error().message();
  EXPECT_EQ(answer->measured.size(), 41U);
  EXPECT_NEAR(answer->slope_kPa, own_kPa, 1e-6);
  ASSERT_GT(answer->by_model_mm, 0.5);
  EXPECT_NEAR(answer->from_data_mm, answer->by_model_mm, 0.01 * answer->by_model_mm);
  EXPECT_LT(answer->apart_largest_mm, 0.02 * answer->by_model_mm);
}

TEST_F(RetractionFromMeasurements, OfSofterTissueGoesFartherAndSaysByHowMuch) {
  const auto answer = retract_from_data(open(), line(own_kPa / 2), force_N);
  ASSERT_TRUE(answer) << answer.error().message();
  EXPECT_GT(answer->from_data_mm, 1.2 * answer->by_model_mm);
  EXPECT_GE(answer->apart_largest_mm, answer->from_data_mm - answer->by_model_mm);
  EXPECT_LT(answer->apart_mean_mm, answer->apart_largest_mm);
  const auto* apart = geometry::find_field(answer->surface.point_fields, apart_field);
  ASSERT_NE(apart, nullptr);
  EXPECT_NEAR(*std::max_element(apart->values.begin(), apart->values.end()), answer->apart_largest_mm,
              0.2 * answer->apart_largest_mm);
}

// As `simulate CASE --scenario --data` answers it.
TEST_F(RetractionFromMeasurements, IsTheSimulationFromThatData) {
  const Case patient = open();
  PatientModel model = read_model(patient).value();
  mechanics::Scenario scenario;
  scenario.loads = {rehearsal::tool_load(rehearsal::hoist_segment_vi(model.mesh).value(), force_N)};
  static_cast<void>(put_into(scenario, model));
  std::vector<mechanics::StressStrain> measured;
  for (int i = -20; i <= 20; ++i) measured.push_back({0.01 * i, 0.01 * i * 9});
  mechanics::SimulationOptions options;
  options.data = mechanics::MaterialData::create(measured, {.poisson_ratio = scenario.poisson_ratio}).value();
  const auto simulation = mechanics::simulate(model.mesh, scenario, options);
  ASSERT_TRUE(simulation) << simulation.error().message();
  const auto answer = retract_from_data(patient, line(9), force_N);
  ASSERT_TRUE(answer) << answer.error().message();
  EXPECT_NEAR(answer->from_data_mm, simulation->result.max_displacement_mm, 1e-9);
  EXPECT_EQ(answer->beyond_data, simulation->share_beyond_data);
}

TEST_F(RetractionFromMeasurements, StrainBeyondWhatWasMeasuredIsSaid) {
  const fs::path file = temporary_.path() / "short.csv";
  ASSERT_TRUE(write_text_file(file, "strain,stress_kPa\n-0.001,-0.006\n0.0005,0.003\n0.001,0.006\n"));
  const auto answer = retract_from_data(open(), file, force_N);
  ASSERT_TRUE(answer) << answer.error().message();
  EXPECT_GT(answer->beyond_data, 0.1);
}

TEST_F(RetractionFromMeasurements, WhatIsNoMeasurementIsRefusedByName) {
  const fs::path file = temporary_.path() / "two.csv";
  ASSERT_TRUE(write_text_file(file, "strain,stress_kPa\n0.1,1\n0.2,2\n"));
  const auto few = retract_from_data(open(), file, force_N);
  ASSERT_FALSE(few);
  EXPECT_EQ(few.error().code, "data-invalid");
  EXPECT_EQ(few.error().file, file);
}

}  // namespace
}  // namespace glisson::casefile

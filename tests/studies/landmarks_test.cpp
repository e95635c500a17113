// What the landmark studies say of livers that are as the atlas, softer, or of two halves.

#include "studies/dissertation/landmarks.h"

#include <gmock/gmock.h>
#include <algorithm>
#include <cmath>

#include "base/files.h"
#include "imaging/volume_file.h"

namespace glisson::studies {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

// An ellipsoid of 150 x 110 x 100 mm, whose right half has another modulus than its left one.
void write_liver(const fs::path& file, double right_kPa, double left_kPa) {
  imaging::Volume map{{}, "kPa"};
  map.grid.size = {34, 26, 24};
  map.grid.spacing_mm = {5, 5, 5};
  for (int k = 0; k < 24; ++k) {
    for (int j = 0; j < 26; ++j) {
      for (int i = 0; i < 34; ++i) {
        const Eigen::Array3d place((i - 16.5) / 15, (j - 12.5) / 11, (k - 11.5) / 10);
        const double kPa = place.square().sum() > 1 ? 0 : i < 17 ? right_kPa : left_kPa;
        map.values.push_back(static_cast<float>(kPa));
      }
    }
  }
  ASSERT_TRUE(imaging::write_volume_file(file, map));
}

double value(const BatchRow& row, const std::string& column) { return column_of({row}, column).at(0); }

TEST(Landmarks, AreMisplacedWhereALiverIsNotLikeTheReferenceBody) {
  const TemporaryFolder folder;
  const fs::path maps = folder.path() / "maps";
  fs::create_directories(maps);
  write_liver(maps / "p1-stiffness.nrrd", 2.6, 2.6);
  write_liver(maps / "p2-stiffness.nrrd", 1.3, 1.3);
  write_liver(maps / "p3-stiffness.nrrd", 1.3, 3.9);
  LandmarksOptions options;
  options.retraction.target_cells = 800;
  options.pictures = 1;
  options.warning = "SIMULATED ellipsoids";
  const auto summary = run_landmarks(maps, folder.path() / "out", options);
  ASSERT_TRUE(summary.has_value()) << summary.error().message();
  ASSERT_EQ(summary->patients, 3u);
  const BatchRow &like_reference = summary->rows[0], &soft = summary->rows[1], &halves = summary->rows[2];

  EXPECT_LT(value(like_reference, "atlas_max_mm"), 1e-6);
  EXPECT_LT(value(like_reference, "uneven_max_mm"), 1e-6);
  // Twice as soft, it is lifted further by up to as much again; what holds it at the diaphragm is as stiff as before.
  EXPECT_NEAR(value(soft, "atlas_near_tool_mm"), value(soft, "atlas_lifted_mm"), 0.2 * value(soft, "atlas_lifted_mm"));
  EXPECT_NEAR(value(soft, "mean_stiffness_near_tool_mm"), value(soft, "atlas_near_tool_mm"), 1e-6);
  EXPECT_LT(value(soft, "own_mean_near_tool_mm"), 1e-6);
  EXPECT_LT(value(soft, "soft_max_mm"), 1e-6);  // all of it is as its mean
  // The mean is the atlas's, but the tool touches the soft half.
  EXPECT_NEAR(value(halves, "mean_kPa"), 2.6, 0.05);
  EXPECT_NEAR(value(halves, "soft_mean_kPa"), 1.3, 1e-3);
  EXPECT_NEAR(value(halves, "stiff_mean_kPa"), 3.9, 1e-3);
  EXPECT_GT(value(halves, "uneven_sd_kPa"), 1.2);
  EXPECT_GT(value(halves, "own_mean_near_tool_mm"), 1);
  EXPECT_GT(value(halves, "soft_max_mm"), value(halves, "stiff_max_mm"));

  // One box a distance, with the 5 mm line; the share counts patients.
  EXPECT_EQ(summary->within.size(), 3u);
  EXPECT_NEAR(summary->within[0].significant.fraction, value(halves, "soft_max_mm") >= 5 ? 1.0 / 3 : 0, 1e-12);
  const std::string page = read_text_file(folder.path() / "out" / "report.html").value();
  EXPECT_THAT(page, HasSubstr("SIMULATED ellipsoids"));
  EXPECT_THAT(page, HasSubstr("5 mm: matters"));
  EXPECT_THAT(page, HasSubstr("data:image/png"));
  const bool one_agrees =
      value(halves, "soft_max_mm") >= 5 && value(halves, "stiff_max_mm") < 5 && value(halves, "uneven_max_mm") >= 5;
  EXPECT_EQ(fs::exists(folder.path() / "out" / "examples" / "p3-stiffness" / "beams.png"), one_agrees);

  const auto again = run_landmarks(maps, folder.path() / "out", options);
  ASSERT_TRUE(again.has_value());
  EXPECT_EQ(again->reused, 3u);
  options.retraction.force_N = 3;
  options.part.patient = "p2-stiffness";
  const auto other = run_landmarks(maps, folder.path() / "out", options);
  ASSERT_TRUE(other.has_value());
  EXPECT_EQ(other->reused, 0u);  // rows of another force do not count
}

TEST(Landmarks, APatientWhoseLiverIsTooSmallStopsNobody) {
  const TemporaryFolder folder;
  const fs::path maps = folder.path() / "maps";
  fs::create_directories(maps);
  imaging::Volume small{{}, "kPa"};
  small.grid.size = {6, 6, 6};
  small.grid.spacing_mm = {5, 5, 5};
  small.values.assign(216, 2.6F);
  ASSERT_TRUE(imaging::write_volume_file(maps / "p1-stiffness.nrrd", small));
  write_liver(maps / "p2-stiffness.nrrd", 2.6, 2.6);
  LandmarksOptions options;
  options.retraction.target_cells = 800;
  options.pictures = 0;
  const auto summary = run_landmarks(maps, folder.path() / "out", options);
  ASSERT_TRUE(summary.has_value()) << summary.error().message();
  EXPECT_EQ(summary->failed, 1u);
  EXPECT_FALSE(summary->rows[0].error.empty());
  EXPECT_EQ(summary->patients, 1u);
}

// The meshfree engine's displacements are some of the finite elements': it lifts less, and more nodes come nearer.
TEST(Landmarks, TheMeshfreeEngineStandsBesideFiniteElementsAndComesNearerWithMoreNodes) {
  const TemporaryFolder folder;
  write_liver(folder.path() / "p1-stiffness.nrrd", 1.3, 3.9);
  const auto subjects = find_subjects(folder.path()).value();
  auto liver = read_subject(subjects.at(0)).value();
  const Eigen::Vector3d middle_mm(82, 62, 57);
  liver.landmarks = {{"deep", middle_mm}, {"right", middle_mm - Eigen::Vector3d(40, 0, 0)}};
  liver.groups = {{"landmarks", {0, 1}}};
  RetractionOptions options;
  options.target_cells = 800;
  options.force_N = 0.5;
  EXPECT_FALSE(retract(liver, options).value().meshfree.has_value());
  std::vector<double> apart_mm;
  for (const int nodes : {10, 60}) {
    options.meshfree = mechanics::MeshfreeOptions{.nodes = nodes};
    const auto retraction = retract(liver, options);
    ASSERT_TRUE(retraction) << retraction.error().message();
    ASSERT_TRUE(retraction->meshfree.has_value());
    const MeshfreeRetraction& meshfree = *retraction->meshfree;
    EXPECT_EQ(meshfree.measured.scenario.engine, mechanics::Engine::meshfree);
    EXPECT_LT(meshfree.measured.result.strain_energy_uJ + meshfree.measured.result.foundation_energy_uJ,
              retraction->measured.result.strain_energy_uJ + retraction->measured.result.foundation_energy_uJ);
    double farthest_mm = 0;
    for (std::size_t p = 0; p < meshfree.measured.result.displacement_mm.size(); ++p) {
      farthest_mm = std::max(
          farthest_mm,
          (meshfree.measured.result.displacement_mm[p] - retraction->measured.result.displacement_mm[p]).norm());
    }
    EXPECT_GE(farthest_mm, meshfree.against_elements.max_mm - 1e-9);  // that is of the boundary and the landmarks
    EXPECT_GT(meshfree.against_elements.max_mm, 0.01);
    ASSERT_EQ(meshfree.against_elements.landmarks.size(), 2u);
    EXPECT_NEAR(meshfree.against_elements.landmarks[1].difference_mm,
                (meshfree.measured.landmarks[1].displaced_mm - retraction->measured.landmarks[1].displaced_mm).norm(),
                1e-12);
    apart_mm.push_back(meshfree.against_elements.mean_mm);
  }
  EXPECT_LT(apart_mm[1], 0.7 * apart_mm[0]);
}

TEST(Landmarks, TheEnginesHaveColumnsOfTheirOwnWhereBothAreAskedFor) {
  const TemporaryFolder folder;
  const fs::path maps = folder.path() / "maps";
  fs::create_directories(maps);
  write_liver(maps / "p1-stiffness.nrrd", 1.3, 3.9);
  LandmarksOptions options;
  options.retraction.target_cells = 800;
  options.retraction.law = RetractionLaw::by_strain;
  options.pictures = 0;
  const auto without = run_landmarks(maps, folder.path() / "out", options);
  ASSERT_TRUE(without) << without.error().message();
  EXPECT_TRUE(without->engines.empty());
  options.retraction.meshfree = mechanics::MeshfreeOptions{.nodes = 30};
  const auto summary = run_landmarks(maps, folder.path() / "out", options);
  ASSERT_TRUE(summary) << summary.error().message();
  EXPECT_EQ(summary->reused, 0u);
  const BatchRow& row = summary->rows[0];
  EXPECT_EQ(value(row, "atlas_near_tool_mm"), value(without->rows[0], "atlas_near_tool_mm"));
  ASSERT_EQ(value(row, "meshfree_answered"), 1);
  EXPECT_GT(value(row, "engines_near_tool_mm"), 0);
  EXPECT_LT(value(row, "engines_mean_mm"), value(row, "lifted_mm"));
  EXPECT_GT(value(row, "meshfree_atlas_near_tool_mm"), 0);
  ASSERT_FALSE(summary->engines.empty());
  EXPECT_EQ(summary->engines.front().mm.mean, value(row, "engines_mean_mm"));
  EXPECT_THAT(read_text_file(folder.path() / "out" / "report.html").value(), HasSubstr("meshfree nodes (30)"));
}

// Wilson's bounds are the probabilities whose own 1.96 standard deviations just reach what was seen.
TEST(Landmarks, AShareHasTheIntervalThatItsDefinitionGives) {
  for (const auto& [patients, all] : {std::pair{0, 30}, {1, 30}, {17, 30}, {30, 30}, {59, 81}, {1, 1}}) {
    const Share share = share_of(static_cast<std::size_t>(patients), static_cast<std::size_t>(all));
    const double of = all, seen = patients / of;
    const auto reaches = [&](double p) { return std::abs(seen - p) <= 1.959964 * std::sqrt(p * (1 - p) / of); };
    double low = 1, high = 0;
    for (int step = 0; step <= 100000; ++step) {
      const double p = step * 1e-5;
      if (!reaches(p)) continue;
      low = std::min(low, p);
      high = std::max(high, p);
    }
    EXPECT_DOUBLE_EQ(share.fraction, seen);
    EXPECT_NEAR(share.low, low, 2e-5) << patients << " of " << all;
    EXPECT_NEAR(share.high, high, 2e-5) << patients << " of " << all;
  }
}

}  // namespace
}  // namespace glisson::studies

// The studies on beams: convergence with resolution, and soft, stiff and uneven tissue against the mean.

#include <gmock/gmock.h>
#include <cmath>

#include "base/files.h"
#include "hardware/convergence_curve.h"
#include "studies/dissertation/beam_regions.h"
#include "studies/dissertation/convergence_study.h"
#include "studies/dissertation/internal/beam_mesh.h"

namespace glisson::studies {
namespace {

// The four coarsest resolutions of the study as it is run for the curve that ships.
TEST(ConvergenceStudy, ErrorsFallAsNodesGetSmallerAndTheCurveThatShipsSaysSo) {
  const ConvergenceOptions whole;
  const double step = std::pow(whole.coarsest_mm3 / whole.finest_mm3, 1.0 / (whole.resolutions - 1));
  const auto study = run_convergence(
      {.finest_mm3 = whole.coarsest_mm3 / (step * step * step), .coarsest_mm3 = whole.coarsest_mm3, .resolutions = 4});
  ASSERT_TRUE(study) << study.error().message();
  ASSERT_EQ(study->rows.size(), 4u);
  EXPECT_NEAR(study->eq_6_6_tip_mm, 76.4, 0.1);  // f L^4 / (8 E I) with f = 0.978 mN/mm
  for (std::size_t i = 1; i < 4; ++i) EXPECT_GT(study->rows[i].error_mm, study->rows[i - 1].error_mm);
  for (const ConvergenceRow& row : study->rows) EXPECT_LT(row.tip_mm, study->theory_tip_mm);

  const TemporaryFolder out;
  ASSERT_TRUE(write_convergence(out.path(), *study));
  const auto curve = hardware::read_convergence_curve(out.path() / "convergence.json");
  ASSERT_TRUE(curve) << curve.error().message();
  EXPECT_EQ(curve->source, hardware::Source::computed);
  ASSERT_EQ(curve->points.size(), 4u);
  const auto ships = hardware::read_convergence_curve(*resource_folder() / "devices" / "convergence.json");
  ASSERT_TRUE(ships) << ships.error().message();
  EXPECT_GE(ships->points.size(), 10u);
  EXPECT_GT(ships->points.back().error_mm, 8);  // the coarsest of figure 6.5
  int shipped = 0;                              // a resolution whose error is below that of a finer one is in no curve
  for (const hardware::ConvergencePoint& made : curve->points) {
    for (const hardware::ConvergencePoint& point : ships->points) {
      if (point.resolution_mm3 != made.resolution_mm3) continue;
      // Other processors add up in another order.
      EXPECT_NEAR(made.error_mm, point.error_mm, 0.005 * point.error_mm) << point.resolution_mm3 << " mm3";
      ++shipped;
    }
  }
  EXPECT_GE(shipped, 3);
  for (const char* file : {"convergence.csv", "summary.json", "report.html"}) {
    EXPECT_TRUE(std::filesystem::exists(out.path() / file)) << file;
  }
}

TEST(ConvergenceStudy, ResolutionsOutOfRangeAreRefused) {
  EXPECT_EQ(run_convergence({.finest_mm3 = 0.1}).error().code, "study-options");
  EXPECT_EQ(run_convergence({.finest_mm3 = 100, .coarsest_mm3 = 10}).error().code, "study-options");
}

// A block of tissue: soft at one end, stiff at the other, and striped in between.
struct BeamTissue {
  geometry::TetMesh liver = beam_mesh({36, 8, 8}, {180, 40, 40});
  std::vector<double> youngs_kPa;

  BeamTissue() {
    for (std::size_t c = 0; c < liver.cells.size(); ++c) {
      const double x = geometry::cell_centroid_mm(liver, c).x();
      youngs_kPa.push_back(x < 60 ? 3.0 : x > 120 ? 20.0 : static_cast<int>(x / 10) % 2 == 0 ? 2.0 : 32.0);
    }
  }
};

TEST(BeamStudy, FindsTheSoftestTheStiffestAndTheMostUnevenPlace) {
  const BeamTissue tissue;
  const auto places = beam_places(tissue.liver, tissue.youngs_kPa);
  ASSERT_TRUE(places) << places.error().message();
  EXPECT_NEAR((*places)[0].mean_kPa, 2.0, 1.5);
  EXPECT_NEAR((*places)[1].mean_kPa, 20.0, 12.5);
  EXPECT_GT((*places)[2].sd_kPa, 12.0);
  for (const BeamPlace& place : *places) {
    for (int d = 0; d < 3; ++d) {
      EXPECT_GE(place.corner_mm[d], -1e-9);
      EXPECT_LE(place.corner_mm[d] + (d == place.axis ? 50 : 10), (d == 0 ? 180 : 40) + 1e-9);
    }
  }
  const auto too_small = beam_mesh({4, 4, 4}, {20, 20, 20});
  EXPECT_EQ(beam_places(too_small, std::vector<double>(too_small.cells.size(), 5.0)).error().code, "liver-too-small");
}

TEST(BeamStudy, SoftTissueIsLiftedFartherThanTheControlAndStiffLess) {
  const BeamTissue tissue;
  const BeamOptions options{.force_N = 0.02, .nodes = 16};
  const auto row = compare_beams("block", tissue.liver, tissue.youngs_kPa, options);
  ASSERT_TRUE(row) << row.error().message();
  EXPECT_GT(row->regions[0].largest_displacement_mm, row->control_displacement_mm);
  EXPECT_LT(row->regions[1].largest_displacement_mm, row->control_displacement_mm);
  EXPECT_GT(row->regions[0].max_mm, row->regions[1].max_mm);
  const TemporaryFolder out;
  ASSERT_TRUE(write_beams(out.path(), {*row}, options));
  for (const char* file : {"beams.csv", "summary.json", "report.html"}) {
    EXPECT_TRUE(std::filesystem::exists(out.path() / file)) << file;
  }
}

}  // namespace
}  // namespace glisson::studies

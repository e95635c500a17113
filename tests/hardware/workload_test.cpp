// From a case to the work and traffic of a frame.

#include "hardware/workload.h"

#include <gmock/gmock.h>
#include <cmath>
#include <functional>
#include <limits>

#include "base/files.h"
#include "base/json.h"
#include "platform_fixtures.h"

namespace glisson::hardware {
namespace {

TEST(Convergence, ShippedCurveSaysWhichStudyMadeIt) {
  const ConvergenceCurve curve = test::shipped_curve();
  EXPECT_EQ(curve.source, Source::computed);
  EXPECT_THAT(curve.provenance, testing::HasSubstr("glisson-cli study convergence"));
  EXPECT_EQ(curve.youngs_kPa, 12);  // table 6.1
  EXPECT_NEAR(curve.points.front().resolution_mm3, 1.65, 0.01);
  EXPECT_GE(curve.points.back().resolution_mm3, 1000);  // beyond figure 6.5: few nodes in the whole beam
}

TEST(Convergence, SofterTissueMissesMoreOfALargerMotion) {
  const ConvergenceCurve beam = test::shipped_curve();
  const ConvergenceCurve soft = in_tissue(beam, 4);
  for (const double resolution_mm3 : {2.0, 20.0, 100.0}) {
    EXPECT_NEAR(error_at_resolution_mm(soft, resolution_mm3), 3 * error_at_resolution_mm(beam, resolution_mm3), 1e-9);
  }
  EXPECT_LT(*resolution_for_accuracy_mm3(soft, 5), *resolution_for_accuracy_mm3(beam, 5));
}

TEST(Convergence, ResolutionAndErrorAreInverse) {
  const ConvergenceCurve curve = test::dissertation_curve();
  for (const double accuracy_mm : {1.0, 1.3, 2.0, 5.0, 7.9, 8.0}) {
    EXPECT_NEAR(error_at_resolution_mm(curve, *resolution_for_accuracy_mm3(curve, accuracy_mm)), accuracy_mm, 1e-12);
  }
}

TEST(Convergence, FinerThanTheStudyIsRefusedAndCoarserIsItsEnd) {
  const ConvergenceCurve curve = test::shipped_curve();
  ASSERT_FALSE(resolution_for_accuracy_mm3(curve, 0.5));
  EXPECT_EQ(resolution_for_accuracy_mm3(curve, 0.5).error().code, "accuracy-not-reached");
  EXPECT_FALSE(resolution_for_accuracy_mm3(curve, std::numeric_limits<double>::quiet_NaN()));
  EXPECT_DOUBLE_EQ(*resolution_for_accuracy_mm3(curve, 20), curve.points.back().resolution_mm3);
}

TEST(Convergence, BadCurvesAreRefused) {
  const auto code = [](const std::function<void(Json&)>& change) {
    const TemporaryFolder folder;
    Json document = *read_json_file(test::devices_file().parent_path() / "convergence.json");
    change(document);
    EXPECT_TRUE(write_text_file(folder.path() / "c.json", document.dump()));
    const auto curve = read_convergence_curve(folder.path() / "c.json");
    return curve ? std::string("read") : curve.error().code;
  };
  EXPECT_EQ(code([](Json&) {}), "read");
  EXPECT_EQ(code([](Json& d) { d["points"] = Json::array({d["points"][0]}); }), "convergence-invalid");
  EXPECT_EQ(code([](Json& d) { d["youngs_kPa"] = 0; }), "figure-out-of-range");
  EXPECT_EQ(code([](Json& d) { std::swap(d["points"][0], d["points"][1]); }), "convergence-invalid");
  EXPECT_EQ(code([](Json& d) { d["points"][0]["error_mm"] = -1; }), "figure-out-of-range");
  EXPECT_EQ(code([](Json& d) { d["points"] = 3; }), "convergence-invalid");
  EXPECT_EQ(code([](Json& d) { d.erase("source"); }), "key-missing");
}

TEST(WorkloadOfACase, CountsAreThoseOfTheBatchedProducts) {
  // 1000 cm3 at 165 mm3 are 6061 nodes. A 3 x 3 block: 9 + 3 + 3 numbers of 4 bytes, 18 operations.
  const auto work = workload_at_resolution(1000, 165);
  ASSERT_TRUE(work);
  EXPECT_EQ(work->nodes, 6061);
  EXPECT_EQ(work->bytes_per_node, 60);
  EXPECT_EQ(work->product_flops, 18.0 * 6061);
  EXPECT_EQ(work->frame_bytes, 200.0 * 60 * 6061);
  // The cube of 27 nodes: 3 x 81.
  const auto coupled = workload_at_resolution(1000, 165, {27, 200, 4});
  EXPECT_EQ(coupled->bytes_per_node, (3 * 81 + 81 + 3) * 4);
  EXPECT_EQ(coupled->product_flops, 2.0 * 3 * 81 * 6061);
}

TEST(WorkloadOfACase, FinerAccuracyIsMoreWork) {
  const ConvergenceCurve curve = test::dissertation_curve();
  double before = std::numeric_limits<double>::infinity();
  for (const double accuracy_mm : {1.0, 2.0, 4.0, 8.0}) {
    const auto work = workload_for_accuracy(1000, accuracy_mm, curve);
    ASSERT_TRUE(work);
    EXPECT_LT(work->frame_bytes, before);
    before = work->frame_bytes;
  }
}

TEST(WorkloadOfACase, TenLitresAreNoLiver) {
  for (const double volume_cm3 : {10000.0, 0.0, -1000.0, 1.0, std::numeric_limits<double>::quiet_NaN()}) {
    const auto work = workload_at_resolution(volume_cm3, 10);
    ASSERT_FALSE(work) << volume_cm3;
    EXPECT_EQ(work.error().code, "volume-not-a-liver");
  }
  EXPECT_EQ(workload_at_resolution(1000, 10, {7, 200, 4}).error().code, "domain-invalid");
  EXPECT_EQ(workload_at_resolution(1000, 0).error().code, "resolution-invalid");
}

}  // namespace
}  // namespace glisson::hardware

// SIRGn against sequences whose truth is known.

#include "registration_quality/sirgn.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "base/files.h"
#include "geometry/mesh_file.h"
#include "registration_quality/register_sequence.h"
#include "sequences.h"
#include "support/data.h"

namespace glisson::registration_quality {
namespace {

using test::Fault;
using test::SequenceSpec;

geometry::Surface liver() {
  return geometry::read_surface(glisson::test::shared_data() / "pbsm_liver_insilico" / "Liver1" / "src.ply").value();
}

struct Judgement {
  Quality quality;
  double rank_of_correlation, area_of_correlation;  // of 1 - SIRGn, as a predictor of the true error
  double rank_of_error, area_of_error;              // of the corners' registered error
  double rank_of_doubt, area_of_doubt;
};

enum class By { itself, benchmark };

Judgement judge(const SequenceSpec& spec, By by = By::itself) {
  auto made = test::make_sequence(liver(), spec);
  if (by == By::benchmark) made.sequence.benchmark = test::benchmark_for(made);
  Judgement judgement{sirgn(made.sequence).value(), 0, 0, 0, 0, 0, 0};
  const auto truth_mm = test::true_triangle_errors_mm(made, judgement.quality.mesh);
  std::vector<double> rated_bad;
  for (const double correlation : judgement.quality.correlation) rated_bad.push_back(1 - correlation);
  judgement.rank_of_correlation = test::rank_correlation(rated_bad, truth_mm);
  judgement.area_of_correlation = test::roc_area(rated_bad, truth_mm, 5);
  judgement.rank_of_error = test::rank_correlation(judgement.quality.error_mm, truth_mm);
  judgement.area_of_error = test::roc_area(judgement.quality.error_mm, truth_mm, 5);
  judgement.rank_of_doubt = test::rank_correlation(judgement.quality.doubt_mm, truth_mm);
  judgement.area_of_doubt = test::roc_area(judgement.quality.doubt_mm, truth_mm, 5);
  ::testing::Test::RecordProperty("rank_of_doubt", fmt::format("{:.2f}", judgement.rank_of_doubt));
  ::testing::Test::RecordProperty("roc_area_of_doubt", fmt::format("{:.2f}", judgement.area_of_doubt));
  // The figures are kept in the test's report, for people to read.
  ::testing::Test::RecordProperty("rank_of_correlation", fmt::format("{:.2f}", judgement.rank_of_correlation));
  ::testing::Test::RecordProperty("roc_area_of_correlation", fmt::format("{:.2f}", judgement.area_of_correlation));
  ::testing::Test::RecordProperty("rank_of_error", fmt::format("{:.2f}", judgement.rank_of_error));
  ::testing::Test::RecordProperty("roc_area_of_error", fmt::format("{:.2f}", judgement.area_of_error));
  return judgement;
}

Fault fault(Fault::Course course) {
  const auto box = geometry::bounding_box(liver().points_mm);
  return {box.center_mm() + Eigen::Vector3d(-40, -40, 0), 40, 15, course};
}

// What a triangle's history is drawn from.
TEST(Sirgn, SaysHowATrianglesValuesCameToBe) {
  GLISSON_NEEDS_DATA("pbsm_liver_insilico");
  SequenceSpec spec;
  spec.faults = {fault(Fault::Course::irregular)};
  const Quality quality = judge(spec).quality;
  ASSERT_EQ(quality.courses.size(), quality.mesh.triangles.size());
  for (std::size_t k = 0; k < quality.courses.size(); ++k) {
    const TriangleCourse& course = quality.courses[k];
    double sum = 0;
    int seen = 0;
    for (std::size_t t = 0; t < course.error_mm.size(); ++t) {
      EXPECT_EQ(std::isnan(course.error_mm[t]), std::isnan(course.landmarks_mm[t]));
      if (std::isnan(course.error_mm[t])) continue;
      sum += course.error_mm[t];
      ++seen;
      EXPECT_EQ(std::isnan(course.warp_mm[t]), quality.frames_seen[k] < fewest_frames);
    }
    EXPECT_EQ(seen, quality.frames_seen[k]);
    EXPECT_NEAR(seen > 0 ? sum / seen : 0, quality.error_mm[k], 1e-9);
  }
}

TEST(Sirgn, CallsAPerfectRegistrationPerfect) {
  GLISSON_NEEDS_DATA("pbsm_liver_insilico");
  const Judgement judgement = judge({});
  EXPECT_GT(judgement.quality.mean_correlation, 0.98);
  // The registration is exact; 0.3 mm of noise a coordinate on clouds (mean of four) and on landmarks remain.
  for (const double tre_mm : judgement.quality.tre_mm) EXPECT_LT(tre_mm, 1.0);
  EXPECT_EQ(judgement.quality.rejected_fraction, (std::vector<double>{0, 0, 0}));
}

// The question that SIRGn is for. Measured: rank correlation with the true error 0.87 to 0.95, area under the curve
// for 5 mm 0.94 to 0.99, whatever the number of landmarks.
TEST(Sirgn, RanksTrianglesByTheirTrueErrorWhereAFaultComesAndGoes) {
  GLISSON_NEEDS_DATA("pbsm_liver_insilico");
  for (const Fault::Course course : {Fault::Course::irregular, Fault::Course::with_time}) {
    for (const int landmarks : {60, 200}) {
      const Judgement judgement = judge({.landmarks = landmarks, .faults = {fault(course)}});
      EXPECT_GT(judgement.rank_of_correlation, 0.8);
      EXPECT_GT(judgement.area_of_correlation, 0.9);
    }
  }
}

// Landmarks that jump spoil what is measured at the landmarks alone (rank correlation 0.9 to 0.5) but hardly SIRGn's
// value, since a jump that the registration does not follow looks alike on both sides of it.
TEST(Sirgn, BearsTrackingOutliersBetterThanLandmarkErrors) {
  GLISSON_NEEDS_DATA("pbsm_liver_insilico");
  const Judgement judgement = judge({.outlier_share = 0.1, .faults = {fault(Fault::Course::irregular)}});
  EXPECT_GT(judgement.rank_of_correlation, 0.8);
  EXPECT_GT(judgement.rank_of_correlation, judgement.rank_of_error + 0.1);
}

// The blind spot of judging a registration by itself: a fault that never changes moves the landmarks' mean with it, and
// the correlation sees only change. Measured: rank correlation 0.6, area 0.65. Kept as a test so that it stays known.
TEST(Sirgn, HardlySeesAFaultThatNeverChangesWithoutABenchmark) {
  GLISSON_NEEDS_DATA("pbsm_liver_insilico");
  const Judgement judgement = judge({.faults = {fault(Fault::Course::constant)}});
  EXPECT_LT(judgement.area_of_correlation, 0.85);
  EXPECT_LT(judgement.area_of_error, 0.7);
  ASSERT_FALSE(judgement.quality.notes.empty());
  EXPECT_NE(judgement.quality.notes.back().message().find("without a benchmark"), std::string::npos);
}

// Printed for docs/figures/sirgn.json. The rule (sirgn.h) was written down before any of these was looked at.
void print_areas(const char* what, const Judgement& judgement) {
  fmt::print("{}: {:.2f} / {:.2f}\n", what, judgement.rank_of_correlation, judgement.area_of_correlation);
}

TEST(Sirgn, SeesAFaultThatNeverChangesAgainstTheBenchmark) {
  GLISSON_NEEDS_DATA("pbsm_liver_insilico");
  double smallest = 1, largest = 0;
  for (const int landmarks : {60, 200}) {
    for (const unsigned seed : {1U, 2U, 3U}) {
      const Judgement judgement =
          judge({.landmarks = landmarks, .faults = {fault(Fault::Course::constant)}, .seed = seed}, By::benchmark);
      EXPECT_TRUE(judgement.quality.against_benchmark);
      EXPECT_GE(judgement.area_of_correlation, 0.85);
      if (seed == 1) print_areas(landmarks == 60 ? "constant, 60" : "constant, 200", judgement);
      smallest = std::min(smallest, judgement.area_of_correlation);
      largest = std::max(largest, judgement.area_of_correlation);
    }
  }
  fmt::print("constant, three seeds: {:.2f} to {:.2f}\n", smallest, largest);
}

// Not for nothing: without landmarks that jump the area is 0.89 to 0.94 (0.94 to 0.99 by itself), since a fault pulls
// the registration's own landmarks along with it where the benchmark stands still, and with a tenth of them jumping
// 0.86 to 0.91 (0.94 to 0.99), since the benchmark does not follow a jump that the sightings show.
TEST(Sirgn, SeesFaultsThatComeAndGoAgainstTheBenchmarkToo) {
  GLISSON_NEEDS_DATA("pbsm_liver_insilico");
  for (const Fault::Course course : {Fault::Course::irregular, Fault::Course::with_time}) {
    for (const double outliers : {0.0, 0.1}) {
      for (const int landmarks : {60, 200}) {
        const Judgement judgement =
            judge({.landmarks = landmarks, .outlier_share = outliers, .faults = {fault(course)}}, By::benchmark);
        EXPECT_GE(judgement.area_of_correlation, 0.85);
        const std::string what = fmt::format("{}, {}{}", course == Fault::Course::irregular ? "irregular" : "growing",
                                             landmarks, outliers > 0 ? ", some jump" : "");
        print_areas(what.c_str(), judgement);
      }
    }
  }
}

// Those of the table in docs/real-data.md, for docs/examples/python/judge_known_fault.py too: they stay in
// $GLISSON_KEEP_SEQUENCES where that is set.
TEST(Sirgn, JudgesTheSameSequencesFromDisk) {
  GLISSON_NEEDS_DATA("pbsm_liver_insilico");
  const TemporaryFolder temporary;
  const char* kept = std::getenv("GLISSON_KEEP_SEQUENCES");
  const std::filesystem::path folder = kept != nullptr ? std::filesystem::path(kept) : temporary.path();
  struct Row {
    const char* name;
    Fault::Course course;
    int landmarks;
    double outliers;
  };
  for (const Row& row :
       {Row{"growing-200", Fault::Course::with_time, 200, 0}, Row{"jumps-200", Fault::Course::irregular, 200, 0.1},
        Row{"jumps-60", Fault::Course::irregular, 60, 0.1}, Row{"constant-200", Fault::Course::constant, 200, 0},
        Row{"constant-60", Fault::Course::constant, 60, 0}}) {
    const SequenceSpec spec{.landmarks = row.landmarks, .outlier_share = row.outliers, .faults = {fault(row.course)}};
    const auto made = test::make_sequence(liver(), spec);
    test::write_made(made, folder / row.name);
    const auto files = read_sequence(folder / row.name / "sequence.json");
    ASSERT_TRUE(files) << files.error().message();
    const auto registered = register_sequence(*files, SequenceMethod::given);
    ASSERT_TRUE(registered) << registered.error().message();
    const auto found = sirgn(*registered);
    ASSERT_TRUE(found) << found.error().message();
    EXPECT_NEAR(found->mean_correlation, judge(spec, By::benchmark).quality.mean_correlation, 2e-3) << row.name;
  }
}

TEST(Sirgn, CallsAPerfectRegistrationPerfectAgainstTheBenchmark) {
  GLISSON_NEEDS_DATA("pbsm_liver_insilico");
  const Judgement judgement = judge({}, By::benchmark);
  EXPECT_GT(judgement.quality.mean_correlation, 0.9);
  EXPECT_EQ(judgement.quality.rejected_fraction.front(), 0);
}

// The inverse of the warps that align the frames, at the landmarks.
TEST(Benchmark, HoldsWhereTheAlignmentHasEachPlaceInEachFrame) {
  GLISSON_NEEDS_DATA("pbsm_liver_insilico");
  const auto made = test::make_sequence(liver(), {.frames = 12, .outlier_share = 0.1, .faults = {}});
  registration::Sightings sightings;
  for (const LandmarkTrack& track : made.sequence.landmarks) sightings.push_back(track.positions_mm);
  const auto alignment = registration::align_globally(sightings).value();
  const Benchmark benchmark = benchmark_of(alignment);
  int places = 0;
  for (std::size_t k = 0; k < sightings.size(); ++k) {
    if (!benchmark.on_model_mm[k]) continue;
    for (std::size_t t = 0; t < 12; ++t) {
      if (!benchmark.in_frames_mm[k][t]) continue;
      EXPECT_LT((alignment.frames[t]->warp(*benchmark.in_frames_mm[k][t]) - *benchmark.on_model_mm[k]).norm(), 2e-3);
      ++places;
    }
  }
  EXPECT_GT(places, 0.99 * 12 * 60);

  const TemporaryFolder folder;
  ASSERT_TRUE(write_benchmark(folder.path() / "b.csv", made.sequence.landmarks, benchmark));
  const Benchmark read = read_benchmark(folder.path() / "b.csv", made.sequence.landmarks, 12).value();
  for (std::size_t k = 0; k < sightings.size(); ++k) {
    ASSERT_EQ(read.on_model_mm[k].has_value(), benchmark.on_model_mm[k].has_value());
    if (read.on_model_mm[k]) {
      EXPECT_LT((*read.on_model_mm[k] - *benchmark.on_model_mm[k]).norm(), 1e-3);
    }
    for (std::size_t t = 0; t < 12; ++t) {
      EXPECT_EQ(read.in_frames_mm[k][t].has_value(), benchmark.in_frames_mm[k][t].has_value());
    }
  }
  const auto refused = [&](const char* line) {
    EXPECT_TRUE(write_text_file(folder.path() / "bad.csv", std::string("landmark,frame,x_mm,y_mm,z_mm\n") + line));
    return read_benchmark(folder.path() / "bad.csv", made.sequence.landmarks, 12).error().code;
  };
  EXPECT_EQ(refused("nobody,model,0,0,0\n"), "benchmark-invalid");
  EXPECT_EQ(refused("g0,12,0,0,0\n"), "benchmark-invalid");
  EXPECT_EQ(refused("g0,model,0,nan,0\n"), "benchmark-invalid");
}

// Noise of 3 mm on the tracks alone: an alignment that follows it agrees with the landmarks that it follows, and is no
// better for that. Of landmarks that it has not seen it cannot know the noise.
TEST(RegisterSequence, JudgesTheGlobalAlignmentByLandmarksThatItWasNotFittedTo) {
  GLISSON_NEEDS_DATA("pbsm_liver_insilico");
  const TemporaryFolder folder;
  const auto made = test::make_sequence(liver(), {.frames = 8, .tracking_noise_mm = 3, .faults = {}});
  SequenceFiles files;
  files.landmarks = made.sequence.landmarks;
  registration::Sightings sightings;
  for (const LandmarkTrack& track : files.landmarks) sightings.push_back(track.positions_mm);
  for (std::size_t t = 0; t < 8; ++t) {
    files.clouds.push_back(folder.path() / fmt::format("f{}.ply", t));
    geometry::Surface cloud;
    cloud.points_mm = made.sequence.frames[t].cloud_mm;
    cloud.triangles = {{0, 1, 2}};
    ASSERT_TRUE(geometry::write_surface(files.clouds.back(), cloud));
  }
  const auto registered = register_sequence(files, SequenceMethod::gnra);
  ASSERT_TRUE(registered.has_value()) << registered.error().message();
  const Quality quality = sirgn(*registered).value();
  double held_out_mm = 0;
  for (const double tre_mm : quality.tre_mm) held_out_mm += tre_mm / 8;
  const double fitted_mm = registration::align_globally(sightings)->rms_mm;
  // The mean length of an error of 3 mm a coordinate is 4.8 mm.
  EXPECT_GT(held_out_mm, 4.5);
  EXPECT_LT(fitted_mm, 0.8 * held_out_mm);
  EXPECT_FALSE(quality.against_benchmark);
}

// Measured with 200 landmarks over two seeds, correlation's value first: a constant fault 0.65 and 0.64 to 0.72 and
// 0.72 (area 0.63 and 0.64 to 0.69 and 0.71), with outliers 0.54 and 0.64 to 0.66 and 0.73; faults that come and go
// 0.86 to 0.95 for both. With 60 landmarks a constant fault is seen no better than before.
TEST(Sirgn, DoubtSeesMoreOfAFaultThatNeverChanges) {
  GLISSON_NEEDS_DATA("pbsm_liver_insilico");
  const Judgement constant = judge({.landmarks = 200, .faults = {fault(Fault::Course::constant)}});
  EXPECT_GT(constant.rank_of_doubt, constant.rank_of_correlation + 0.03);
  EXPECT_GT(constant.area_of_doubt, constant.area_of_correlation + 0.03);
  const Judgement irregular =
      judge({.landmarks = 200, .outlier_share = 0.1, .faults = {fault(Fault::Course::irregular)}});
  EXPECT_GT(irregular.rank_of_doubt, irregular.rank_of_correlation - 0.02);
  EXPECT_GT(irregular.area_of_doubt, irregular.area_of_correlation - 0.02);
}

TEST(Sirgn, LabelsByTolerance) {
  GLISSON_NEEDS_DATA("pbsm_liver_insilico");
  const auto made = test::make_sequence(liver(), {.faults = {fault(Fault::Course::irregular)}});
  const Quality quality = sirgn(made.sequence, {.tolerances_mm = {1e6, 2, 1e-6}}).value();
  EXPECT_EQ(quality.rejected_fraction.front(), 0);
  EXPECT_EQ(quality.rejected_fraction.back(), 1);
  const geometry::Field* accepted = geometry::find_field(quality.mesh.cell_fields, "accepted_2");
  ASSERT_NE(accepted, nullptr);
  for (std::size_t k = 0; k < quality.error_mm.size(); ++k) {
    EXPECT_EQ(accepted->values[k] == 1, quality.error_mm[k] < 2);
  }
}

TEST(Sirgn, MeasuresDistanceFromTheModelWhereThereIsOne) {
  GLISSON_NEEDS_DATA("pbsm_liver_insilico");
  auto made = test::make_sequence(liver(), {.frames = 6, .faults = {fault(Fault::Course::with_time)}});
  EXPECT_TRUE(sirgn(made.sequence).value().rmse_mm.empty());
  made.sequence.model = liver();
  const Quality quality = sirgn(made.sequence).value();
  ASSERT_EQ(quality.rmse_mm.size(), 6u);
  EXPECT_LT(quality.rmse_mm.front(), 1e-3);  // at the first frame there is no fault yet
  EXPECT_GT(quality.rmse_mm.back(), 0.5);
}

RegisteredSequence small_sequence() {
  RegisteredSequence sequence;
  const std::vector<Eigen::Vector3d> cloud{{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {10, 10, 0}, {5, 5, 1}};
  for (int t = 0; t < 3; ++t) sequence.frames.push_back({cloud, cloud});
  for (int k = 0; k < 5; ++k) {
    const auto position = std::optional(cloud[static_cast<std::size_t>(k)]);
    sequence.landmarks.push_back({std::to_string(k), {position, position, position}});
  }
  return sequence;
}

TEST(Sirgn, RefusesWhatCannotBeJudgedAndSaysWhy) {
  EXPECT_TRUE(sirgn(small_sequence()).has_value());

  RegisteredSequence sequence = small_sequence();
  sequence.frames.pop_back();
  EXPECT_EQ(sirgn(sequence).error().code, "sirgn-too-few-frames");

  sequence = small_sequence();
  sequence.landmarks.resize(3);
  EXPECT_EQ(sirgn(sequence).error().code, "sirgn-too-few-landmarks");

  sequence = small_sequence();
  sequence.landmarks[0].positions_mm.pop_back();
  EXPECT_EQ(sirgn(sequence).error().code, "sirgn-tracks");

  sequence = small_sequence();
  sequence.frames[1].registered_mm.pop_back();
  EXPECT_EQ(sirgn(sequence).error().code, "sirgn-not-point-for-point");

  sequence = small_sequence();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (auto& point : sequence.frames[1].cloud_mm) point.x() = nan;
  EXPECT_EQ(sirgn(sequence).error().code, "sirgn-empty-frame");

  sequence = small_sequence();
  for (LandmarkTrack& track : sequence.landmarks) {
    for (auto& position : track.positions_mm) position->z() += 1000;  // another camera's
  }
  EXPECT_EQ(sirgn(sequence).error().code, "sirgn-landmarks-off");
  EXPECT_EQ(sirgn(sequence).error().message(), "Landmarks that lie far from the points of their frames: 5 of 5.");

  sequence = small_sequence();
  sequence.benchmark = Benchmark{{std::nullopt}, {{}}};
  EXPECT_EQ(sirgn(sequence).error().code, "sirgn-tracks");

  EXPECT_EQ(sirgn(small_sequence(), {.tolerances_mm = {-1}}).error().code, "sirgn-tolerance");
}

TEST(Sirgn, LeavesOutALandmarkThatLiesNowhereNearTheTissueAndSaysSo) {
  RegisteredSequence sequence = small_sequence();
  for (auto& position : sequence.landmarks[4].positions_mm) position->z() += 1000;
  const Quality quality = sirgn(sequence).value();
  EXPECT_EQ(quality.mesh.points_mm.size(), 4u);
  ASSERT_FALSE(quality.notes.empty());
  EXPECT_NE(quality.notes.front().message().find("far from the points of their frames: 1"), std::string::npos);
}

TEST(Sirgn, LeavesOutLandmarksThatWereHardlySeenAndPointsThatAreNotFinite) {
  RegisteredSequence sequence = small_sequence();
  sequence.landmarks[4].positions_mm[0].reset();
  sequence.frames[0].cloud_mm[2].x() = std::numeric_limits<double>::infinity();
  const Quality quality = sirgn(sequence).value();
  EXPECT_EQ(quality.mesh.points_mm.size(), 4u);
  ASSERT_FALSE(quality.notes.empty());
  EXPECT_NE(quality.notes.front().message().find("fewer than three frames: 1"), std::string::npos);
}

}  // namespace
}  // namespace glisson::registration_quality

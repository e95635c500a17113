// A liver of 20,000 cells on a simulated laparoscopy's frames: the first, found without a guess, and those that follow.
//
//   build/release/bin/bench_guidance
//
// error_mm: of twelve places inside, on average over what was timed. BM_FirstPoses judges the search for a first pose
// on eight livers that it was not built with.

#include <benchmark/benchmark.h>
#include <memory>

#include "anatomy/patient.h"
#include "casefile/guided_sequence.h"
#include "guidance/guidance_answer.h"
#include "guidance/pose_search.h"
#include "registration_quality/video_sequence.h"
#include "studies/review/example_sequence.h"
#include "support/folders.h"
#include "support/liver_on_video.h"

namespace {

using namespace glisson;
using Eigen::Vector3d;

constexpr int frames = 12;
constexpr std::uint64_t patient_seed = 3;

// `truth_mm`: the places of the first frame, then of the second, ...
double mean_error_mm(const std::vector<Vector3d>& truth_mm, std::size_t frame, const std::vector<Vector3d>& found_mm) {
  double sum = 0;
  for (std::size_t k = 0; k < found_mm.size(); ++k) sum += (found_mm[k] - truth_mm[frame * found_mm.size() + k]).norm();
  return sum / static_cast<double>(found_mm.size());
}

struct Laparoscopy {
  TemporaryFolder folder;
  casefile::GuidedSequence guided;
  std::unique_ptr<guidance::ForceModes> modes;
  std::vector<Vector3d> truth_mm;

  Laparoscopy() {
    studies::ExampleSequenceOptions video;
    video.frames = frames;
    video.patient = patient_seed;
    const auto file = studies::write_example_sequence(folder.path() / "video", video).value();
    anatomy::PatientOptions patient;
    patient.seed = patient_seed;
    const auto model = test::liver_model(anatomy::make_liver_surface(patient).value(), 20000,
                                         test::places_in(file.parent_path() / "hidden.csv"));
    truth_mm = test::places_in(file.parent_path() / "hidden-truth.csv");
    guided = casefile::guided_sequence(model, registration_quality::read_sequence(file).value(), std::nullopt).value();
    modes = std::make_unique<guidance::ForceModes>(
        guidance::ForceModes::create(guided.guidance.mesh, guided.guidance.youngs_kPa, guided.guidance.poisson_ratio)
            .value());
  }
};

const Laparoscopy& laparoscopy() {
  static const Laparoscopy made;
  return made;
}

// Preparing the organ: once a case.
void BM_SetUp(benchmark::State& state) {
  const auto& guidance = laparoscopy().guided.guidance;
  for (auto _ : state) {
    benchmark::DoNotOptimize(guidance::ForceModes::create(guidance.mesh, guidance.youngs_kPa, guidance.poisson_ratio));
  }
  state.counters["cells"] = static_cast<double>(guidance.mesh.cells.size());
}
BENCHMARK(BM_SetUp)->Unit(benchmark::kMillisecond);

// The pose alone, from the cloud's shape.
void BM_FirstPose(benchmark::State& state) {
  const auto& frame = laparoscopy().guided.guidance.frames.front();
  for (auto _ : state) benchmark::DoNotOptimize(guidance::find_pose(laparoscopy().modes->surface(), frame));
}
BENCHMARK(BM_FirstPose)->Unit(benchmark::kMillisecond)->UseRealTime();

// All frames: the first takes its pose and its fit, each other follows the one before.
void BM_Video(benchmark::State& state) {
  double first_s = 0, following_s = 0, error_mm = 0;
  for (auto _ : state) {
    first_s = following_s = error_mm = 0;
    const auto answer = guidance::answer(*laparoscopy().modes, laparoscopy().guided.guidance).value();
    for (std::size_t f = 0; f < answer.frames.size(); ++f) {
      (f == 0 ? first_s : following_s) += answer.frames[f].seconds;
      error_mm += mean_error_mm(laparoscopy().truth_mm, f, answer.frames[f].placement.target_mm) / frames;
    }
  }
  state.counters["first_ms"] = 1e3 * first_s;
  state.counters["following_ms"] = 1e3 * following_s / (frames - 1);
  state.counters["error_mm"] = error_mm;
}
BENCHMARK(BM_Video)->Unit(benchmark::kMillisecond)->UseRealTime();

// The clouds as they are given (0), or as they come out of both eyes' pictures (1); each frame by itself.
void BM_FirstPoses(benchmark::State& state) {
  double frames_seen = 0, found = 0, error_mm = 0, largest_mm = 0;
  for (auto _ : state) {
    for (std::uint64_t seed = 11; seed <= 18; ++seed) {
      const TemporaryFolder folder;
      studies::ExampleSequenceOptions options;
      options.frames = 6;
      options.patient = seed;
      options.stereo = state.range(0) != 0;
      const auto given = studies::write_example_sequence(folder.path() / "given", options).value();
      std::filesystem::path file = given;
      if (options.stereo) {
        const auto video = given.parent_path() / "video";
        auto source = vision::StereoSource::open({video / "left", video / "right"}).value();
        const auto calibration = vision::read_stereo_calibration(video / "camera.json").value();
        file = registration_quality::make_sequence(source, calibration, folder.path() / "made").value().file;
      }
      const auto rest_mm = test::places_in(given.parent_path() / "hidden.csv");
      const auto truth_mm = test::places_in(given.parent_path() / "hidden-truth.csv");
      anatomy::PatientOptions patient;
      patient.seed = seed;
      const geometry::Surface liver = anatomy::make_liver_surface(patient).value();
      const auto clouds = registration_quality::read_sequence(file).value().clouds;
      for (std::size_t f = 0; f < clouds.size(); ++f, ++frames_seen) {
        guidance::SeenFrame frame;
        frame.points_mm = registration_quality::read_cloud(clouds[f]).value().points_mm;
        const auto pose = guidance::find_pose(liver, frame);
        if (!pose) continue;
        std::vector<Vector3d> found_mm;
        for (const Vector3d& place : rest_mm) found_mm.push_back(*pose * place);
        const double off_mm = mean_error_mm(truth_mm, f, found_mm);
        ++found;
        error_mm += off_mm;
        largest_mm = std::max(largest_mm, off_mm);
      }
    }
  }
  state.counters["frames"] = frames_seen;
  state.counters["found"] = found;
  state.counters["error_mm"] = error_mm / std::max(1.0, found);
  state.counters["largest_mm"] = largest_mm;
}
BENCHMARK(BM_FirstPoses)->Arg(0)->Arg(1)->Unit(benchmark::kSecond)->Iterations(1);

}  // namespace

BENCHMARK_MAIN();

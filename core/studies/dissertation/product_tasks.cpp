#include "studies/dissertation/product_tasks.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>

#include "base/noise.h"
#include "base/parallel.h"
#include "base/upper_median.h"
#include "guidance/guidance_answer.h"
#include "hardware/block_product.h"
#include "mechanics/meshfree/meshfree_model.h"
#include "registration/trwls.h"
#include "rehearsal/session.h"
#include "rehearsal/tool_presets.h"
#include "studies/dissertation/internal/matching_problems.h"

namespace glisson::studies {
namespace {

using Eigen::Vector3d;

// "AMD EPYC, 2 threads, 2026-11-26, glisson-cli platform measure --product": where and how a time was got.
std::string provenance() {
  std::string processor = "an unnamed processor";
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (!line.starts_with("model name") || colon == std::string::npos) continue;
    processor = line.substr(colon + 2);
    break;
  }
  return fmt::format("{}, {} threads, {:%F}, glisson-cli platform measure --product", processor, thread_count(),
                     fmt::gmtime(std::time(nullptr)));
}

hardware::Task by_memory(const std::string& id, const std::string& what, double seconds, double memory_GB_per_s) {
  return {id,
          what,
          seconds * memory_GB_per_s * 1e9,
          0,
          seconds,
          hardware::Source::measured,
          fmt::format("{:.3g} s where memory gives {:.3g} GB/s: {}", seconds, memory_GB_per_s, provenance())};
}

// Jaws at segment VI, drawn a millimetre further each frame.
Result<double> live_frame_s(const rehearsal::RehearsalSetup& setup, const rehearsal::ToolPlacement& place, int frames,
                            const Progress& progress) {
  auto session = rehearsal::SessionEngine::create(setup, progress);
  if (!session) return failure(session.error());
  std::vector<double> seconds;
  for (int frame = 0; frame <= frames; ++frame) {
    if (progress.cancelled()) return cancelled();
    const mechanics::Grasp grasp{place.center_mm, place.preset.radius_mm, Vector3d((1.0 + frame) * place.direction),
                                 place.direction};
    const auto& state = session->step(rehearsal::HoldTool{{"jaws", grasp}});
    if (!state.refused.empty()) return failure("not-converged", state.refused, {});
    if (frame > 0) seconds.push_back(state.step_ms * 1e-3);  // the first one makes what later ones keep
  }
  return upper_median(std::move(seconds));
}

Result<double> meshfree_frame_s(const rehearsal::RehearsalSetup& setup, const rehearsal::ToolPlacement& place,
                                const ProductTaskOptions& options, const Progress& progress) {
  const auto body = mechanics::MeshfreeModel::create(setup.mesh, setup.patient_youngs_kPa, setup.supports,
                                                     mechanics::MaterialLaw::linear, setup.options,
                                                     {.nodes = options.meshfree_nodes}, {}, progress);
  if (!body) return failure(body.error());
  std::vector<double> seconds;
  for (int frame = 0; frame < options.frames; ++frame) {
    const auto result = body->solve({rehearsal::tool_load(place, 0.5 + 0.1 * frame)});
    if (!result) return failure(result.error());
    seconds.push_back(result->step_ms * 1e-3);
  }
  return upper_median(std::move(seconds));
}

// The half of the surface that looks to the front, as a camera there would see it, shifted, with noise.
Result<double> guided_frame_s(const rehearsal::RehearsalSetup& setup, int frames, const Progress& progress) {
  guidance::GuidanceCase asked;
  asked.mesh = setup.mesh;
  asked.youngs_kPa = setup.patient_youngs_kPa;
  const geometry::Surface surface = geometry::boundary_surface(setup.mesh);
  const std::vector<Vector3d> normals = geometry::point_normals(surface);
  for (int frame = 0; frame < frames; ++frame) {
    guidance::SeenFrame seen;
    seen.id = fmt::format("f{}", frame);
    seen.pose_guess = Eigen::Isometry3d::Identity();
    for (std::size_t point = 0; point < normals.size(); ++point) {
      if (normals[point].y() > -0.2) continue;  // LPS: the front is where y falls
      const Eigen::Vector2d noise = normal_pair(static_cast<std::uint64_t>(frame), point);
      seen.points_mm.push_back(surface.points_mm[point] + Vector3d(2 + noise.x() / 2, 1 + noise.y() / 2, frame));
    }
    asked.frames.push_back(std::move(seen));
  }
  const auto answer = guidance::answer(asked, progress);
  if (!answer) return failure(answer.error());
  std::vector<double> seconds;
  for (const guidance::FrameAnswer& frame : answer->frames) seconds.push_back(frame.seconds);
  return upper_median(std::move(seconds));
}

// The liver found again in its own bent shape.
Result<hardware::Task> registration_task(const geometry::Surface& surface, const ProductTaskOptions& options) {
  const int points = options.matched_points;
  const auto source = registration::sample_surface(surface, points);
  if (!source) return failure(source.error());
  const auto target = registration::sample_surface(bent(surface, 0.7), points);
  if (!target) return failure(target.error());
  registration::MatchingProblem problem;
  problem.source_mm = source->between_mm;
  problem.target_mm = target->between_mm;
  problem.sigma_mm = 0.4 * problem.target_mm.maxCoeff();
  problem.tau_mm = 0.25 * problem.target_mm.maxCoeff();
  std::vector<double> seconds;
  double passes = 0;
  for (int frame = 0; frame < options.frames; ++frame) {
    const auto solution = registration::trwls(problem);
    if (!solution) return failure(solution.error());
    seconds.push_back(solution->solve_ms * 1e-3);
    passes = static_cast<double>(solution->passes.size());
  }
  // A device's peak counts an addition and a product a lane of 32 bits; of 16 bits there are twice as many lanes.
  constexpr double operations_a_cost = 7;
  const double costs = passes * std::pow(points, 3) * (points - 1);
  return hardware::Task{"match",
                        fmt::format("a registration of {} points by geodesic distances, {:.0f} passes", points, passes),
                        0,
                        operations_a_cost * costs,
                        upper_median(std::move(seconds)),
                        hardware::Source::computed,
                        "seven operations of 16 bits a cost, counted; timed on " + provenance()};
}

}  // namespace

Result<ProductTasks> time_product_tasks(const casefile::PatientModel& model, const ProductTaskOptions& options,
                                        const Progress& progress) {
  ProductTasks times;
  times.memory_GB_per_s = hardware::memory_bandwidth_GB_s();
  rehearsal::RehearsalSetup setup = casefile::rehearsal_setup(model);
  setup.reference_youngs_kPa.reset();
  const auto place = rehearsal::hoist_segment_vi(setup.mesh);
  if (!place) return failure(place.error());
  const std::string of = fmt::format("of {} cells", setup.mesh.cells.size());

  const auto keep = [&](const char* id, const std::string& what, const Result<double>& seconds) -> Result<void> {
    if (!seconds && seconds.error().code == "cancelled") return failure(seconds.error());
    if (seconds) {
      times.tasks.push_back(by_memory(id, what, *seconds, times.memory_GB_per_s));
    } else {
      times.remarks.push_back(fmt::format("{}: {}", id, seconds.error().message()));
    }
    return {};
  };
  auto done = keep("rehearse", "a live frame at small strain " + of,
                   live_frame_s(setup, *place, options.frames, progress.part(0, 0.2)));
  if (!done) return failure(done.error());
  rehearsal::RehearsalSetup large = setup;
  large.law = mechanics::MaterialLaw::neo_hookean;
  done = keep("rehearse-large-strain", "the first picture of a live frame at large strain (neo-Hookean) " + of,
              live_frame_s(large, *place, options.frames, progress.part(0.2, 0.5)));
  if (!done) return failure(done.error());
  done = keep("rehearse-meshfree",
              fmt::format("an equilibrium of the meshfree engine, {} nodes over {} cells", options.meshfree_nodes,
                          setup.mesh.cells.size()),
              meshfree_frame_s(setup, *place, options, progress.part(0.5, 0.7)));
  if (!done) return failure(done.error());
  done = keep("guide", "a frame of the guidance, the liver's front seen, " + of,
              guided_frame_s(setup, options.frames, progress.part(0.7, 0.9)));
  if (!done) return failure(done.error());
  auto match = registration_task(geometry::boundary_surface(setup.mesh), options);
  if (match) {
    times.tasks.push_back(std::move(*match));
  } else {
    times.remarks.push_back("match: " + match.error().message());
  }
  return times;
}

}  // namespace glisson::studies

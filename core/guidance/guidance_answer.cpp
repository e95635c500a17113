#include "guidance/guidance_answer.h"

#include "base/files.h"
#include "base/json.h"
#include "base/stopwatch.h"
#include "base/units.h"
#include "geometry/mesh_file.h"
#include "guidance/pose_search.h"

namespace glisson::guidance {

using Eigen::Vector3d;

namespace {

ElasticPlacement unanswered(std::string why) {
  ElasticPlacement placement;
  placement.why_not = std::move(why);
  return placement;
}

// What no registration should be tried on: a sentence, or nothing.
std::string problem_of(const SeenFrame& frame, const geometry::Surface& organ) {
  if (frame.points_mm.size() < 20) {
    return GLISSON_TEXT("Fewer than 20 points of the surface were seen.");
  }
  const double seen_mm = geometry::bounding_box(frame.points_mm).diagonal_mm();
  const double organ_mm = geometry::bounding_box(organ.points_mm).diagonal_mm();
  if (seen_mm < 0.05 * organ_mm) {
    return GLISSON_TEXT(
        "What was seen is twenty times smaller than the organ: lengths are in mm, are these in metres?");
  }
  if (seen_mm > 5 * organ_mm) {
    return GLISSON_TEXT("What was seen is five times larger than the organ: lengths are in mm.");
  }
  return {};
}

ElasticPlacement place(const ForceModes& modes, const SeenFrame& frame, const GuidanceCase& guidance,
                       const std::vector<mechanics::PointInMesh>& targets) {
  if (std::string problem = problem_of(frame, modes.surface()); !problem.empty()) return unanswered(std::move(problem));
  RegistrationOptions options;
  Eigen::Isometry3d from = Eigen::Isometry3d::Identity();
  if (frame.pose_guess) {
    from = *frame.pose_guess;
  } else {
    const auto found = find_pose(modes.surface(), frame);
    if (!found) return unanswered(found.error().message());
    from = *found;
  }
  return register_elastic(modes, frame, from, targets, guidance.gravity_mm_s2, options);
}

Json json_of_frame(const GuidanceCase& guidance, const FrameAnswer& frame) {
  const ElasticPlacement& placed = frame.placement;
  Json json{{"id", frame.id},
            {"residual_rms_mm", placed.residual_rms_mm},
            {"converged", placed.converged},
            {"seconds", frame.seconds},
            {"visible_share", placed.visible_share},
            {"elastic_rms_mm", placed.elastic_rms_mm}};
  if (!placed.converged) {
    json["note"] = placed.why_not;
    json["targets"] = Json::array();
    return json;
  }
  json["pose"] = Json::array();
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) json["pose"].push_back(placed.pose.matrix()(row, column));
  }
  json["targets"] = Json::array();
  for (std::size_t t = 0; t < guidance.targets.size(); ++t) {
    json["targets"].push_back({{"id", guidance.targets[t].id},
                               {"position_mm", json_of(placed.target_mm[t])},
                               {"sd_mm", placed.target_sd_mm[t]}});
  }
  json["tools"] = Json::array();
  for (const FoundTool& tool : placed.tools) {
    json["tools"].push_back({{"id", tool.id},
                             {"force_N", json_of(Vector3d(units::N_from_mN(1.0) * tool.force_mN))},
                             {"sd_N", units::N_from_mN(tool.sd_mN)}});
  }
  return json;
}

}  // namespace

Result<GuidanceAnswer> answer(const GuidanceCase& guidance, const Progress& progress) {
  const auto modes =
      ForceModes::create(guidance.mesh, guidance.youngs_kPa, guidance.poisson_ratio, {}, progress.part(0.0, 0.3));
  if (!modes) return failure(modes.error());
  std::vector<Vector3d> at_rest_mm;
  for (const Target& target : guidance.targets) at_rest_mm.push_back(target.at_rest_mm);
  const auto targets = mechanics::locate_points(modes->mesh(), at_rest_mm);
  GuidanceAnswer answer{{}, guidance.notes};
  for (std::size_t f = 0; f < guidance.frames.size(); ++f) {
    if (progress.cancelled()) return cancelled();
    progress.report(0.3 + 0.7 * static_cast<double>(f) / static_cast<double>(guidance.frames.size()),
                    GLISSON_TEXT("Placing the organ"));
    const Stopwatch watch;
    ElasticPlacement placement = place(*modes, guidance.frames[f], guidance, targets);
    answer.frames.push_back({guidance.frames[f].id, watch.seconds(), std::move(placement)});
  }
  return answer;
}

Json answer_json(const GuidanceCase& guidance, const GuidanceAnswer& answer) {
  Json json{{"format", "glisson-guidance-answer/1"}, {"title", guidance.title}, {"frames", Json::array()}};
  for (const FrameAnswer& frame : answer.frames) json["frames"].push_back(json_of_frame(guidance, frame));
  if (!answer.notes.empty()) json["notes"] = answer.notes;
  return json;
}

Result<void> write_answer(const std::filesystem::path& folder, const GuidanceCase& guidance,
                          const GuidanceAnswer& answer) {
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem) {
    return failure(
        Error{"folder-not-writable", GLISSON_TEXT("The folder cannot be made: {0}"), {problem.message()}, {}, folder});
  }
  for (const FrameAnswer& frame : answer.frames) {
    if (!frame.placement.converged) continue;
    geometry::TetMesh mesh{guidance.mesh.points_mm, guidance.mesh.cells, {}, {}};
    geometry::Field field{"displacement_mm", 3, {}};
    for (const Vector3d& u : frame.placement.displacement_mm)
      field.values.insert(field.values.end(), u.begin(), u.end());
    mesh.point_fields.push_back(std::move(field));
    if (auto written = geometry::write_tetrahedra(folder / (frame.id + ".vtu"), mesh); !written) return written;
  }
  return write_json_file(folder / "guidance.json", answer_json(guidance, answer));
}

}  // namespace glisson::guidance

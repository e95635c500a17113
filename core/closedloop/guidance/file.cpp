// Guidance as an experiment, from JSON: the organ, and what a camera saw of it in each frame.

#include <fmt/format.h>
#include <algorithm>
#include <Eigen/Geometry>
#include <map>
#include <set>

#include "base/units.h"
#include "closedloop/experiment/internal/experiment_source.h"
#include "geometry/ply_file.h"

namespace glisson::closedloop {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;

constexpr std::size_t maximum_frame_points =
    150;  // of a frame, evenly chosen: neighbours on a smooth surface say the same

void add_frame(const Json& json, const Source& source, Guidance& guidance);
std::vector<GuidanceTrial> trials_from(const Json& json, const Guidance& guidance);

}  // namespace

Guidance guidance_from(const Json& json, const Source& source) {
  only_keys(json,
            {"format", "kind", "title", "model", "supports", "gravity_m_s2", "features", "frames", "targets", "trials",
             "noise_mm", "landmark_noise_mm"},
            "The experiment");
  Guidance guidance;
  read_specimen(required(json, "model", "The experiment"), source, guidance.organ);
  guidance.organ.supports = supports_from(required(json, "supports", "The experiment"));
  if (json.contains("gravity_m_s2"))
    guidance.organ.gravity_mm_s2 = vector_in(json["gravity_m_s2"], "gravity_m_s2").unaryExpr(&units::mm_s2_from_m_s2);
  guidance.organ.noise_mm = positive_in(required(json, "noise_mm", "The experiment"), "noise_mm");
  guidance.landmark_noise_mm = json.contains("landmark_noise_mm")
                                   ? positive_in(json["landmark_noise_mm"], "landmark_noise_mm")
                                   : guidance.organ.noise_mm;
  const Json& frames = required(json, "frames", "The experiment");
  if (!frames.is_array() || frames.empty())
    refuse("experiment-invalid", GLISSON_TEXT("\"frames\" must be a list with at least one frame."), {});
  for (const Json& frame : frames) add_frame(frame, source, guidance);
  guidance.trials = trials_from(json, guidance);
  return guidance;
}

namespace {

// Scan to camera, row by row.
Eigen::Isometry3d pose_from(const Json& json, const std::string& where) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
  if (json.is_array() && json.size() == 16) {
    for (int i = 0; i < 16; ++i) matrix(i / 4, i % 4) = number_in(json[static_cast<std::size_t>(i)], where);
  }
  constexpr double near_enough = 1e-4;
  const Eigen::Matrix3d turn = matrix.topLeftCorner<3, 3>();
  const bool rigid = (turn * turn.transpose() - Eigen::Matrix3d::Identity()).norm() < near_enough &&
                     turn.determinant() > 0 && (matrix.row(3) - Eigen::RowVector4d(0, 0, 0, 1)).norm() < near_enough;
  if (!rigid)
    refuse("experiment-invalid", GLISSON_TEXT("{0} must be a rigid motion: 16 numbers, row by row, scan to camera."),
           {where}, GLISSON_TEXT("Is it stretched or mirrored, or given column by column?"));
  Eigen::Isometry3d pose(matrix);
  pose.linear() = Eigen::Quaterniond(turn).normalized().toRotationMatrix();
  return pose;
}

// Points brought to the scan's frame. They are the organ's surface: most of them lie near it.
std::vector<Vector3d> points_from(const fs::path& file, const std::string& where, const Eigen::Isometry3d& to_scan,
                                  const geometry::TetMesh& mesh) {
  std::vector<Vector3d> all_mm = taken(geometry::read_ply(file)).points_mm;
  std::erase_if(all_mm, [](const Vector3d& point) { return !point.allFinite(); });
  const std::size_t step = std::max<std::size_t>(1, (all_mm.size() + maximum_frame_points - 1) / maximum_frame_points);
  std::vector<Vector3d> points_mm;
  for (std::size_t i = 0; i < all_mm.size(); i += step) points_mm.push_back(to_scan * all_mm[i]);
  if (points_mm.empty()) refuse("experiment-invalid", GLISSON_TEXT("{0} holds no points."), {file.string()}, {}, file);
  Eigen::AlignedBox3d box;
  for (const Vector3d& point : mesh.points_mm) box.extend(point);
  const double reach_mm = 0.25 * box.diagonal().norm();
  const auto far = std::count_if(points_mm.begin(), points_mm.end(),
                                 [&](const Vector3d& point) { return box.exteriorDistance(point) > reach_mm; });
  if (2 * static_cast<std::size_t>(far) > points_mm.size())
    refuse("experiment-points-outside",
           GLISSON_TEXT("In {0} most points of {1} lie farther than {2} mm from the organ, as the pose has it."),
           {where, file.filename().string(), fmt::format("{:.0f}", reach_mm)},
           GLISSON_TEXT("Are they in metres, in another camera's frame, or is \"pose_guess\" that of another frame?"),
           file);
  return points_mm;
}

// A frame is a palpation of one reading: at rest, then as it is seen.
void add_frame(const Json& json, const Source& source, Guidance& guidance) {
  const std::string id =
      text_in(required(json, "id", "frames"), fmt::format("frame {}, id", guidance.organ.trials.size() + 1));
  const std::string where = "frame " + id;
  only_keys(json, {"id", "time_s", "points", "noise_mm", "pose_guess", "features", "landmarks", "targets", "tools"},
            where);
  const Eigen::Isometry3d to_scan = pose_from(required(json, "pose_guess", where), where + ", pose_guess").inverse();
  PalpationTrial frame;
  frame.id = id;
  PalpationSample seen;
  seen.time_s = 1;
  const double time_s = json.contains("time_s") ? number_in(json["time_s"], where + ", time_s")
                                                : static_cast<double>(guidance.organ.trials.size());
  guidance.points_mm.push_back(
      points_from(source.named_file(text_in(required(json, "points", where), where + ", points")), where, to_scan,
                  guidance.organ.mesh));
  const auto table = [&](const char* key) {
    return markers_from(source.named_file(text_in(json[key], where + ", " + key)), to_scan, guidance.organ.mesh);
  };
  if (json.contains("landmarks")) seen.markers = table("landmarks");
  guidance.targets.push_back(json.contains("targets") ? table("targets") : std::vector<Marker>());
  const Json* tools = json.contains("tools") ? &json["tools"] : nullptr;
  if (tools != nullptr && tools->size() > 1)
    refuse("experiment-invalid", GLISSON_TEXT("In {0} more than one tool touches the organ."), {where},
           GLISSON_TEXT("An experiment takes frames with one tool, or none."));
  if (tools != nullptr && tools->is_array() && !tools->empty()) {
    const Json& tool = tools->front();
    only_keys(tool, {"id", "contact_mm", "at_rest_mm", "radius_mm", "force_N"}, where + ", tools");
    frame.tool.center_mm = vector_in(required(tool, "at_rest_mm", where + ", tools"), where + ", at_rest_mm");
    frame.tool.radius_mm = positive_in(required(tool, "radius_mm", where + ", tools"), where + ", radius_mm");
    const Vector3d force_N =
        to_scan.linear() * vector_in(required(tool, "force_N", where + ", tools"), where + ", force_N");
    if (force_N.norm() > 500)
      refuse("experiment-unit", GLISSON_TEXT("{0}: a force of {1} N presses no soft specimen."),
             {where, std::to_string(force_N.norm())}, GLISSON_TEXT("Was it given in mN?"));
    if (force_N.norm() > 0) frame.tool.direction = force_N.normalized();
    seen.force_mN = units::mN_from_N(force_N.norm());
  } else {
    // Nothing pushes: on all of the surface, with no force.
    Eigen::AlignedBox3d box;
    for (const Vector3d& point : guidance.organ.mesh.points_mm) box.extend(point);
    frame.tool.center_mm = box.center();
    frame.tool.radius_mm = box.diagonal().norm();
  }
  frame.samples = {PalpationSample{}, std::move(seen)};
  guidance.organ.trials.push_back(std::move(frame));
  guidance.time_s.push_back(time_s);
}

// Absent: each frame is a trial by itself.
std::vector<GuidanceTrial> trials_from(const Json& json, const Guidance& guidance) {
  std::map<std::string, std::size_t> number;
  for (std::size_t f = 0; f < guidance.organ.trials.size(); ++f) {
    if (!number.emplace(guidance.organ.trials[f].id, f).second)
      refuse("experiment-invalid", GLISSON_TEXT("Two frames have the id \"{0}\"."), {guidance.organ.trials[f].id});
  }
  std::vector<GuidanceTrial> trials;
  if (!json.contains("trials")) {
    for (std::size_t f = 0; f < guidance.organ.trials.size(); ++f) trials.push_back({guidance.organ.trials[f].id, {f}});
    return trials;
  }
  std::set<std::size_t> taken_frames;
  const std::vector<std::string> ids = trial_ids(json);
  for (std::size_t t = 0; t < ids.size(); ++t) {
    const std::string where = "trial " + ids[t];
    only_keys(json["trials"][t], {"id", "frames"}, where);
    GuidanceTrial trial{ids[t], {}};
    const Json& frames = required(json["trials"][t], "frames", where);
    if (!frames.is_array() || frames.empty())
      refuse("experiment-invalid", GLISSON_TEXT("{0} names no frames."), {where});
    for (const Json& frame : frames) {
      const std::string id = text_in(frame, where + ", frames");
      const auto known = number.find(id);
      if (known == number.end())
        refuse("experiment-invalid", GLISSON_TEXT("{0} names the frame \"{1}\", which is not there."), {where, id});
      if (!taken_frames.insert(known->second).second)
        refuse("experiment-invalid", GLISSON_TEXT("The frame \"{0}\" belongs to two trials."), {id});
      trial.frames.push_back(known->second);
    }
    trials.push_back(std::move(trial));
  }
  if (taken_frames.size() != guidance.organ.trials.size())
    refuse("experiment-invalid", GLISSON_TEXT("Frames that belong to no trial: {0}."),
           {std::to_string(guidance.organ.trials.size() - taken_frames.size())},
           GLISSON_TEXT("Name each frame in one trial, or leave \"trials\" out: each frame is one then."));
  return trials;
}

}  // namespace
}  // namespace glisson::closedloop

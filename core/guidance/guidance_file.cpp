#include "guidance/guidance_file.h"

#include "base/json_value.h"
#include "base/units.h"
#include "geometry/mesh_file.h"
#include "geometry/ply_file.h"
#include "guidance/internal/file_parts.h"
#include "mechanics/scenario/mesh_moduli.h"
#include "mechanics/scenario/scenario_file.h"

namespace glisson::guidance {

namespace fs = std::filesystem;
using Eigen::Vector3d;

namespace {

constexpr const char* described = GLISSON_TEXT("The format \"glisson-guidance/1\" is described in the documentation.");

std::vector<Vector3d> cloud_from(const fs::path& file) {
  std::vector<Vector3d> points = taken(geometry::read_ply(file)).points_mm;
  std::erase_if(points, [](const Vector3d& point) { return !point.allFinite(); });
  return points;
}

void add_curves(const Json& json, const std::vector<CurveAtRest>& at_rest, const fs::path& folder,
                const std::string& where, SeenFrame& frame) {
  const Json* features = value_in(json, "features");
  for (const Json& feature : features == nullptr ? Json::array() : *features) {
    const std::string id = text_under(feature, "id", where);
    SeenCurve curve{id, curve_called(id, at_rest, where).points_mm,
                    curve_from(folder / text_under(feature, "points", where)), 1.5};
    curve.noise_mm = positive_or(feature, "noise_mm", curve.noise_mm, where);
    if (!curve.seen_mm.empty()) frame.curves.push_back(std::move(curve));
  }
}

void add_tools(const Json& json, const std::string& where, SeenFrame& frame) {
  const Json* tools = value_in(json, "tools");
  for (const Json& each : tools == nullptr ? Json::array() : *tools) {
    SeenTool tool{
        text_under(each, "id", where), vector_in(required(each, "contact_mm", where), where + ", contact_mm"), 10, {}};
    tool.radius_mm = positive_or(each, "radius_mm", tool.radius_mm, where);
    if (const Json* force = value_in(each, "force_N"); force != nullptr && !force->is_null()) {
      tool.force_mN = units::mN_from_N(1.0) * vector_in(*force, where + ", force_N");
    }
    frame.tools.push_back(std::move(tool));
  }
}

// `follows`: a frame before it has a time too.
SeenFrame frame_from(const Json& json, const std::vector<CurveAtRest>& at_rest, const fs::path& folder, bool follows) {
  SeenFrame frame;
  frame.id = frame_id_from(json);
  const std::string where = "frame " + frame.id;
  frame.points_mm = cloud_from(folder / text_under(json, "points", where));
  frame.noise_mm = positive_or(json, "noise_mm", frame.noise_mm, where);
  if (const Json* guess = value_in(json, "pose_guess"); guess != nullptr && !guess->is_null()) {
    frame.pose_guess = pose_from(*guess, where);
  }
  if (const Json* time = value_in(json, "time_s"); time != nullptr && !time->is_null()) {
    frame.time_s = number_in(*time, where + ", time_s");
  }
  add_curves(json, at_rest, folder, where, frame);
  add_tools(json, where, frame);
  if (!frame.pose_guess && frame.curves.empty() && !(follows && frame.time_s)) {
    refuse_in(where, "neither \"pose_guess\" nor \"features\" are given, nor a time after that of another frame");
  }
  return frame;
}

void read_model(const Json& json, const fs::path& folder, GuidanceCase& guidance) {
  guidance.mesh = taken(geometry::read_tetrahedra(folder / text_under(json, "mesh", "model")));
  guidance.poisson_ratio = number_or(json, "poisson_ratio", guidance.poisson_ratio, "model");
  const Json& modulus = required(json, "youngs_modulus_kPa", "model");
  if (modulus.is_string()) {
    const auto name = modulus.get<std::string>();
    const auto* field = geometry::find_field(guidance.mesh.cell_fields, name);
    if (field == nullptr || field->components != 1) refuse_in("model", "the mesh has no cell array \"" + name + "\"");
    auto moduli = taken(mechanics::moduli_of(guidance.mesh, name, guidance.poisson_ratio));
    guidance.youngs_kPa = std::move(moduli.youngs_kPa);
    if (moduli.note) guidance.notes.push_back(std::move(*moduli.note));
  } else {
    guidance.youngs_kPa.assign(guidance.mesh.cells.size(), positive_in(modulus, "model, youngs_modulus_kPa"));
  }
}

GuidanceCase guidance_from(const Json& json, const fs::path& folder) {
  if (!says(json, "format", "glisson-guidance/1")) {
    refuse_in("the document", "\"format\" must be \"glisson-guidance/1\"");
  }
  GuidanceCase guidance;
  if (auto title = string_in(json, "title")) guidance.title = std::move(*title);
  read_model(required(json, "model", "the document"), folder, guidance);
  if (const Json* gravity = value_in(json, "gravity_m_s2"); gravity != nullptr) {
    guidance.gravity_mm_s2 = units::mm_s2_from_m_s2(1.0) * vector_in(*gravity, "gravity_m_s2");
  }
  if (const Json* supports = value_in(json, "supports"); supports != nullptr && !supports->empty()) {
    guidance.supports = taken(mechanics::parse_supports(*supports, "guidance-invalid"));
    const auto ligaments = std::erase_if(guidance.supports, [](const mechanics::Support& support) {
      return std::holds_alternative<mechanics::Ligament>(support.how);
    });
    if (ligaments > 0) guidance.notes.emplace_back("Ligaments among the supports, which only pull, are not used.");
  }
  const std::vector<CurveAtRest> at_rest = curves_at_rest(json, folder);
  const Json& frames = required(json, "frames", "the document");
  if (!frames.is_array() || frames.empty()) refuse_in("the document", "\"frames\" must name at least one");
  std::optional<double> time_s;
  for (const Json& frame : frames) {
    guidance.frames.push_back(frame_from(frame, at_rest, folder, time_s.has_value()));
    const std::optional<double> now_s = guidance.frames.back().time_s;
    if (time_s && now_s && *now_s <= *time_s) {
      refuse_in("frame " + guidance.frames.back().id, "\"time_s\" must grow from frame to frame");
    }
    if (now_s) time_s = now_s;
  }
  guidance.targets = targets_from(folder / text_under(json, "targets", "the document"));
  return guidance;
}

}  // namespace

std::optional<Eigen::Isometry3d> rigid_pose(const std::vector<double>& numbers) {
  if (numbers.size() != 16) return std::nullopt;
  const Eigen::Matrix4d matrix = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>(numbers.data());
  const Eigen::Matrix3d turn = matrix.topLeftCorner<3, 3>();
  const bool is_rigid = matrix.allFinite() && (turn.transpose() * turn - Eigen::Matrix3d::Identity()).norm() < 1e-3 &&
                        turn.determinant() > 0 && (matrix.row(3) - Eigen::RowVector4d(0, 0, 0, 1)).norm() < 1e-6;
  if (!is_rigid) return std::nullopt;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::Quaterniond(turn).normalized().toRotationMatrix();
  pose.translation() = matrix.topRightCorner<3, 1>();
  return pose;
}

Result<GuidanceCase> read_guidance(const fs::path& file) {
  auto document = read_json_file(file);
  if (!document) return failure(std::move(document.error()));
  return reading("guidance-invalid", file, [&] { return guidance_from(*document, file.parent_path()); })
      .map_error([](Error error) {
        if (error.code == "guidance-invalid" && error.hint.empty()) error.hint = described;
        return error;
      });
}

}  // namespace glisson::guidance

#include "guidance/contour_file.h"

#include "base/json.h"
#include "base/json_value.h"
#include "base/stopwatch.h"
#include "geometry/mesh_file.h"
#include "guidance/internal/file_parts.h"
#include "guidance/seen_line.h"

namespace glisson::guidance {

namespace fs = std::filesystem;

namespace {

constexpr const char* contours_format = "glisson-contours/1";
constexpr const char* silhouette = "silhouette";
constexpr const char* contours_described =
    GLISSON_TEXT("The format \"glisson-contours/1\" is described in the documentation.");
constexpr std::size_t fewest_pixels = 2;
constexpr double spacing_mm = 2;  // of a line at rest, at most

ContourFrame frame_from(const Json& json, const std::vector<CurveAtRest>& at_rest, const fs::path& folder) {
  ContourFrame frame;
  frame.id = frame_id_from(json);
  const std::string where = "frame " + frame.id;
  if (const Json* guess = value_in(json, "pose_guess"); guess != nullptr && !guess->is_null()) {
    frame.pose_guess = pose_from(*guess, where);
  }
  const Json& contours = required(json, "contours", where);
  if (!contours.is_array() || contours.empty()) refuse_in(where, "\"contours\" must name at least one");
  for (const Json& each : contours) {
    SeenContour contour;
    contour.id = text_under(each, "id", where);
    if (contour.id != silhouette) {
      contour.at_rest_mm = filled_in(curve_called(contour.id, at_rest, where).points_mm, spacing_mm);
    }
    contour.seen_px = pixels_from(folder / text_under(each, "pixels", where));
    if (contour.seen_px.size() < fewest_pixels) {
      refuse_in(where, "the contour \"" + contour.id + "\" needs two pixels and more");
    }
    frame.contours.push_back(std::move(contour));
  }
  return frame;
}

ContourCase contours_from(const Json& json, const fs::path& folder) {
  if (!says(json, "format", contours_format)) refuse_in("the document", "\"format\" must be \"glisson-contours/1\"");
  ContourCase asked;
  if (auto title = string_in(json, "title")) asked.title = std::move(*title);
  asked.organ =
      taken(geometry::read_surface(folder / text_under(required(json, "model", "the document"), "surface", "model")));
  if (asked.organ.triangles.empty()) refuse_in("model", "the surface has no triangles");
  const auto camera = vision::camera_from_json(required(json, "camera", "the document").dump());
  if (!camera) {
    refuse_in("camera",
              "it has no 3 x 3 matrix with positive focal lengths, or a distortion that is not a list of 4, 5, "
              "8, 12 or 14 numbers");
  }
  asked.camera = *camera;
  const std::vector<CurveAtRest> at_rest = curves_at_rest(json, folder);
  const Json& frames = required(json, "frames", "the document");
  if (!frames.is_array() || frames.empty()) refuse_in("the document", "\"frames\" must name at least one");
  for (const Json& frame : frames) asked.frames.push_back(frame_from(frame, at_rest, folder));
  if (value_in(json, "targets") != nullptr) {
    asked.targets = targets_from(folder / text_under(json, "targets", "the document"));
  }
  return asked;
}

// Each contour in turn, by a pose that the others tell.
std::vector<std::optional<ContourError>> left_out(const ContourCase& asked, const ContourFrame& frame,
                                                  const Eigen::Isometry3d& from) {
  std::vector<std::optional<ContourError>> errors(frame.contours.size());
  for (std::size_t c = 0; c < frame.contours.size(); ++c) {
    std::vector<SeenContour> others = frame.contours;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(c));
    if (others.empty()) continue;
    const auto found = pose_of_contours(asked.organ, asked.camera, others, from);
    if (found) errors[c] = error_of(frame.contours[c], asked.organ, asked.camera, found->pose);
  }
  return errors;
}

Json json_of_frame(const ContourCase& asked, std::size_t f, const ContourAnswer& answer) {
  Json json{{"id", answer.id}, {"converged", answer.found.has_value()}, {"seconds", answer.seconds}};
  json["targets"] = Json::array();
  if (!answer.found) {
    json["note"] = answer.found.error().message();
    return json;
  }
  json["pose"] = Json::array();
  for (int k = 0; k < 16; ++k) json["pose"].push_back(answer.found->pose.matrix()(k / 4, k % 4));
  json["contours"] = Json::array();
  for (std::size_t c = 0; c < asked.frames[f].contours.size(); ++c) {
    Json contour{{"id", asked.frames[f].contours[c].id},
                 {"off_px", nullptr},
                 {"off_mm", nullptr},
                 {"left_out_px", nullptr},
                 {"left_out_mm", nullptr}};
    if (const auto& off = answer.found->off[c]) {
      contour["off_px"] = off->px;
      contour["off_mm"] = off->mm;
    }
    if (const auto& left = answer.left_out[c]) {
      contour["left_out_px"] = left->px;
      contour["left_out_mm"] = left->mm;
    }
    json["contours"].push_back(std::move(contour));
  }
  for (const Target& target : asked.targets) {
    const Eigen::Vector3d position_mm = answer.found->pose * target.at_rest_mm;
    json["targets"].push_back({{"id", target.id}, {"position_mm", json_of(position_mm)}});
  }
  return json;
}

}  // namespace

bool holds_contours(const fs::path& file) {
  const auto document = read_json_file(file);
  return document && says(*document, "format", contours_format);
}

Result<ContourCase> read_contours(const fs::path& file) {
  auto document = read_json_file(file);
  if (!document) return failure(std::move(document.error()));
  return reading("contours-invalid", file, [&] { return contours_from(*document, file.parent_path()); })
      .map_error([](Error error) {
        if (error.code == "contours-invalid" && error.hint.empty()) error.hint = contours_described;
        return error;
      });
}

Result<std::vector<ContourAnswer>> answer(const ContourCase& asked, const Progress& progress) {
  std::vector<ContourAnswer> answers;
  for (const ContourFrame& frame : asked.frames) {
    if (progress.cancelled()) return cancelled();
    progress.report(static_cast<double>(answers.size()) / static_cast<double>(asked.frames.size()),
                    GLISSON_TEXT("Placing the organ"));
    const Stopwatch since;
    ContourAnswer answer{
        frame.id, 0, pose_of_contours(asked.organ, asked.camera, frame.contours, frame.pose_guess), {}};
    answer.seconds = since.seconds();
    if (answer.found) answer.left_out = left_out(asked, frame, answer.found->pose);
    answers.push_back(std::move(answer));
  }
  return answers;
}

Json answer_json(const ContourCase& asked, const std::vector<ContourAnswer>& answers) {
  Json json{{"format", "glisson-contours-answer/1"}, {"title", asked.title}, {"frames", Json::array()}};
  for (std::size_t f = 0; f < answers.size(); ++f) json["frames"].push_back(json_of_frame(asked, f, answers[f]));
  return json;
}

}  // namespace glisson::guidance

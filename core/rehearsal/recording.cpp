// Recordings of a session as JSON. Numbers are written so that they read back to the same bits.

#include <algorithm>
#include <cmath>

#include "base/json_reading.h"
#include "base/json_value.h"
#include "rehearsal/session.h"

namespace glisson::rehearsal {
namespace {

using Eigen::Vector3d;
using glisson::json_of;
using mechanics::ContactTool;
using mechanics::Grasp;
using mechanics::Rod;
using mechanics::ToolLoad;
using mechanics::TouchingTool;

Json json_of(const ContactTool& tool) {
  Json json{{"id", tool.id}};
  if (const auto* grasp = std::get_if<Grasp>(&tool.what)) {
    json["grasp"] = {{"at_rest_mm", json_of(grasp->at_rest_mm)}, {"radius_mm", grasp->radius_mm}};
    if (const auto* drawn_mm = std::get_if<Vector3d>(&grasp->drawn)) {
      json["displacement_mm"] = json_of(*drawn_mm);
    } else {
      json["pull_mN"] = std::get<double>(grasp->drawn);
      json["direction"] = json_of(grasp->direction);
    }
    return json;
  }
  if (const auto* patch = std::get_if<ToolLoad>(&tool.what)) {
    json["patch"] = {{"center_mm", json_of(patch->center_mm)}, {"radius_mm", patch->radius_mm}};
    json["force_mN"] = json_of(patch->force_mN);
    return json;
  }
  const auto& touching = std::get<TouchingTool>(tool.what);
  json["rods"] = Json::array();
  for (const Rod& rod : touching.shape) {
    json["rods"].push_back(
        {{"from_mm", json_of(rod.from_mm)}, {"to_mm", json_of(rod.to_mm)}, {"radius_mm", rod.radius_mm}});
  }
  json["position_mm"] = json_of(touching.pose.position_mm);
  json["rotation"] = Json::array();  // by rows
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) json["rotation"].push_back(touching.pose.rotation(r, c));
  }
  if (touching.push_mN) json["push_mN"] = *touching.push_mN;
  if (touching.friction > 0) json["friction"] = touching.friction;
  return json;
}

// Sentences end in parse_recording's, which says which command they are of.
void check_keys(const Json& json, std::initializer_list<std::string_view> known) {
  for (const auto& [key, value] : json.items()) {
    if (std::find(known.begin(), known.end(), key) == known.end())
      refuse_at("it", "{0} has an unknown key \"{1}\".", {key});
  }
}

double number_under(const Json& json, const char* key, const std::string& where) {
  return number_in(required(json, key, where), key);
}

Vector3d vector_under(const Json& json, const char* key, const std::string& where) {
  return vector_in(required(json, key, where), key);
}

std::vector<Json> list_under(const Json& json, const char* key, const std::string& where) {
  const Json& list = required(json, key, where);
  if (!list.is_array()) refuse_at(key, GLISSON_TEXT("{0} must be a list in brackets."));
  return list;
}

ContactTool tool_from(const Json& json) {
  const std::string id = text_in(required(json, "id", "the tool"), "id");
  if (json.contains("grasp")) {
    check_keys(json, {"id", "grasp", "displacement_mm", "pull_mN", "direction"});
    Grasp grasp;
    grasp.at_rest_mm = vector_under(json["grasp"], "at_rest_mm", "the grasp");
    grasp.radius_mm = number_under(json["grasp"], "radius_mm", "the grasp");
    if (json.contains("pull_mN")) {
      grasp.drawn = number_under(json, "pull_mN", "the tool");
      grasp.direction = vector_under(json, "direction", "the tool");
    } else {
      grasp.drawn = vector_under(json, "displacement_mm", "the tool");
    }
    return {id, grasp};
  }
  if (json.contains("patch")) {
    check_keys(json, {"id", "patch", "force_mN"});
    return {id, ToolLoad{vector_under(json["patch"], "center_mm", "the patch"),
                         number_under(json["patch"], "radius_mm", "the patch"),
                         vector_under(json, "force_mN", "the tool")}};
  }
  check_keys(json, {"id", "rods", "shape", "position_mm", "rotation", "direction", "push_mN", "friction"});
  TouchingTool touching;
  if (json.contains("shape")) {
    const std::string shape = text_in(json["shape"], "shape");
    if (shape != "nathanson-retractor" && shape != "palpation-probe")
      refuse_at(shape, "there is no tool shaped \"{0}\".");
    touching.shape = shape == "palpation-probe" ? mechanics::palpation_probe() : mechanics::nathanson_retractor();
  } else {
    for (const Json& rod : list_under(json, "rods", "the tool")) {
      touching.shape.push_back({vector_under(rod, "from_mm", "the rod"), vector_under(rod, "to_mm", "the rod"),
                                number_under(rod, "radius_mm", "the rod")});
    }
  }
  touching.pose.position_mm = vector_under(json, "position_mm", "the tool");
  if (json.contains("direction")) {
    touching.pose = mechanics::pose_towards(touching.pose.position_mm, vector_under(json, "direction", "the tool"));
  } else {
    const std::vector<Json> rotation = list_under(json, "rotation", "the tool");
    if (rotation.size() != 9) refuse_at("rotation", "{0} must be nine numbers, row by row.");
    for (int i = 0; i < 9; ++i)
      touching.pose.rotation(i / 3, i % 3) = number_in(rotation[static_cast<std::size_t>(i)], "rotation");
  }
  if (json.contains("push_mN")) touching.push_mN = number_under(json, "push_mN", "the tool");
  if (json.contains("friction")) touching.friction = not_negative_in(json["friction"], "friction");
  return {id, std::move(touching)};
}

Json json_of(const mechanics::CutStrip& strip) {
  Json cut{{"from_mm", json_of(strip.from_mm)}, {"to_mm", json_of(strip.to_mm)}};
  if (!strip.surface.is_plane()) {
    for (const Vector3d& point : strip.surface.through_mm()) cut["points_mm"].push_back(json_of(point));
    if (strip.surface.is_swept()) cut["into_mm"] = json_of(strip.surface.into_mm());
    return cut;
  }
  cut["plane"] = json_of(strip.surface.point_mm());
  for (const double n : strip.surface.normal()) cut["plane"].push_back(n);
  return cut;
}

geometry::CutSurface surface_from(const Json& json) {
  if (json.contains("points_mm")) {
    std::vector<Vector3d> points_mm;
    for (const Json& point : list_under(json, "points_mm", "the cut"))
      points_mm.push_back(vector_in(point, "points_mm"));
    auto sheet = json.contains("into_mm")
                     ? geometry::CutSurface::swept(points_mm, vector_under(json, "into_mm", "the cut"))
                     : geometry::CutSurface::through(points_mm);
    if (!sheet) refuse_at("points_mm", "{0}: {1}", {sheet.error().message()});
    return std::move(*sheet);
  }
  const std::vector<Json> plane = list_under(json, "plane", "the cut");
  if (plane.size() != 6) refuse_at("plane", "{0} must be six numbers: a point on it, then its normal.");
  Vector3d point_mm, normal;
  for (int i = 0; i < 3; ++i) {
    point_mm[i] = number_in(plane[static_cast<std::size_t>(i)], "plane");
    normal[i] = number_in(plane[static_cast<std::size_t>(i + 3)], "plane");
  }
  auto surface = geometry::CutSurface::plane(point_mm, normal);
  if (!surface) refuse_at("plane", "{0} needs a normal with a length.");
  return std::move(*surface);
}

mechanics::CutStrip strip_from(const Json& json) {
  check_keys(json, {"plane", "points_mm", "into_mm", "from_mm", "to_mm"});
  return {surface_from(json), vector_under(json, "from_mm", "the cut"), vector_under(json, "to_mm", "the cut")};
}

Wait wait_from(const Json& json) {
  const double steps = number_in(json, "wait_steps");
  if (!(steps >= 1 && steps <= SessionEngine::most_waited_steps && steps == std::floor(steps))) {
    refuse_at("wait_steps", "{0} must be a whole number from 1 to {1}.",
              {std::to_string(SessionEngine::most_waited_steps)});
  }
  return {static_cast<int>(steps)};
}

std::pair<SessionCommand, std::string> command_from(const Json& json) {
  check_keys(json, {"hold", "release", "undo", "settle", "cut", "compare", "wait_steps", "digest"});
  const auto commands = {"hold", "release", "undo", "settle", "cut", "compare", "wait_steps"};
  if (std::count_if(commands.begin(), commands.end(), [&](const char* one) { return json.contains(one); }) != 1)
    refuse_at("it", "{0} must say one thing to do.");
  const std::string digest = json.contains("digest") ? text_in(json["digest"], "digest") : std::string();
  if (json.contains("hold")) return {HoldTool{tool_from(json["hold"])}, digest};
  if (json.contains("release")) return {ReleaseTool{text_in(json["release"], "release")}, digest};
  if (json.contains("settle")) return {Settle{}, digest};
  if (json.contains("compare")) return {Compare{}, digest};
  if (json.contains("wait_steps")) return {wait_from(json["wait_steps"]), digest};
  if (json.contains("cut")) return {AdvanceCut{strip_from(json["cut"])}, digest};
  return {Undo{}, digest};
}

}  // namespace

std::string recording_text(const Recording& recording) {
  Json commands = Json::array();
  for (const auto& [command, digest] : recording) {
    Json json;
    if (const auto* hold = std::get_if<HoldTool>(&command)) {
      json["hold"] = json_of(hold->tool);
    } else if (const auto* release = std::get_if<ReleaseTool>(&command)) {
      json["release"] = release->id;
    } else if (const auto* advance = std::get_if<AdvanceCut>(&command)) {
      json["cut"] = json_of(advance->strip);
    } else if (const auto* wait = std::get_if<Wait>(&command)) {
      json["wait_steps"] = wait->steps;
    } else {
      json[std::holds_alternative<Settle>(command)    ? "settle"
           : std::holds_alternative<Compare>(command) ? "compare"
                                                      : "undo"] = true;
    }
    if (!digest.empty()) json["digest"] = digest;
    commands.push_back(std::move(json));
  }
  return Json{{"format", "glisson-session/1"}, {"commands", std::move(commands)}}.dump(2) + "\n";
}

Result<Recording> parse_recording(std::string_view json, const std::filesystem::path& file) {
  const auto document = parse_json(json, file);
  if (!document) return failure(document.error());
  const auto cannot_be_read = [&](const std::string& which, const std::string& why) {
    return failure(
        Error{"session-invalid",
              GLISSON_TEXT("{0} of the session cannot be read: {1}."),
              {which, why},
              GLISSON_TEXT("A command is {\"hold\": {...}}, {\"release\": id}, {\"cut\": {...}}, {\"undo\": true}, "
                           "{\"settle\": true}, {\"compare\": true} or {\"wait_steps\": n}."),
              file});
  };
  const Json* commands = value_in(*document, "commands");
  if (!says(*document, "format", "glisson-session/1") || commands == nullptr || !commands->is_array()) {
    return cannot_be_read("The head", "it does not say \"format\": \"glisson-session/1\" with a list of commands");
  }
  Recording recording;
  for (const Json& json_of_command : *commands) {
    auto command = reading("session-invalid", file, [&] { return command_from(json_of_command); });
    if (!command) {
      std::string why = command.error().message();
      if (why.ends_with('.')) why.pop_back();
      return cannot_be_read("Command " + std::to_string(recording.size() + 1), why);
    }
    recording.push_back(*std::move(command));
  }
  return recording;
}

WithReference reference_in(const Recording& recording) {
  const auto asks = [](const auto& one) { return std::holds_alternative<Compare>(one.first); };
  return std::any_of(recording.begin(), recording.end(), asks) ? WithReference::when_asked : WithReference::at_once;
}

std::optional<std::size_t> replay(SessionEngine& engine, const Recording& recording) {
  std::optional<std::size_t> first_other;
  for (std::size_t i = 0; i < recording.size(); ++i) {
    const SessionState& state = engine.step(recording[i].first);
    if (!first_other && !recording[i].second.empty() && state.digest != recording[i].second) first_other = i;
  }
  return first_other;
}

}  // namespace glisson::rehearsal

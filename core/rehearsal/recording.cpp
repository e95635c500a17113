// Recordings of a session as JSON. Numbers are written so that they read back to the same bits.

#include <algorithm>
#include <stdexcept>

#include "base/json_value.h"
#include "rehearsal/session.h"

namespace glisson::rehearsal {
namespace {

using Eigen::Vector3d;
using glisson::json_of;
using mechanics::ContactTool;
using mechanics::Grasp;
using mechanics::Rod;
using mechanics::TouchingTool;

Vector3d vector_from(const Json& json) {
  if (json.size() != 3) throw std::invalid_argument("a vector needs three numbers");
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

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
  return json;
}

void check_keys(const Json& json, std::initializer_list<std::string_view> known) {
  for (const auto& [key, value] : json.items()) {
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      throw std::invalid_argument("it has an unknown key \"" + key + "\"");
    }
  }
}

ContactTool tool_from(const Json& json) {
  const std::string id = json.at("id").get<std::string>();
  if (json.contains("grasp")) {
    check_keys(json, {"id", "grasp", "displacement_mm", "pull_mN", "direction"});
    Grasp grasp;
    grasp.at_rest_mm = vector_from(json.at("grasp").at("at_rest_mm"));
    grasp.radius_mm = json.at("grasp").at("radius_mm").get<double>();
    if (json.contains("pull_mN")) {
      grasp.drawn = json.at("pull_mN").get<double>();
      grasp.direction = vector_from(json.at("direction"));
    } else {
      grasp.drawn = vector_from(json.at("displacement_mm"));
    }
    return {id, grasp};
  }
  check_keys(json, {"id", "rods", "shape", "position_mm", "rotation", "direction", "push_mN"});
  TouchingTool touching;
  if (json.contains("shape")) {
    const std::string shape = json.at("shape").get<std::string>();
    if (shape != "nathanson-retractor" && shape != "palpation-probe") {
      throw std::invalid_argument("there is no tool shaped \"" + shape + "\"");
    }
    touching.shape = shape == "palpation-probe" ? mechanics::palpation_probe() : mechanics::nathanson_retractor();
  } else {
    for (const Json& rod : json.at("rods")) {
      touching.shape.push_back(
          {vector_from(rod.at("from_mm")), vector_from(rod.at("to_mm")), rod.at("radius_mm").get<double>()});
    }
  }
  touching.pose.position_mm = vector_from(json.at("position_mm"));
  if (json.contains("direction")) {
    touching.pose = mechanics::pose_towards(touching.pose.position_mm, vector_from(json.at("direction")));
  } else {
    for (int i = 0; i < 9; ++i) touching.pose.rotation(i / 3, i % 3) = json.at("rotation").at(i).get<double>();
  }
  if (json.contains("push_mN")) touching.push_mN = json.at("push_mN").get<double>();
  return {id, std::move(touching)};
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
    } else {
      json["undo"] = true;
    }
    if (!digest.empty()) json["digest"] = digest;
    commands.push_back(std::move(json));
  }
  return Json{{"format", "glisson-session/1"}, {"commands", std::move(commands)}}.dump(2) + "\n";
}

Result<Recording> parse_recording(std::string_view json, const std::filesystem::path& file) {
  const auto document = parse_json(json, file);
  if (!document) return failure(document.error());
  const auto refuse = [&](const std::string& which, const std::string& why) {
    return failure(Error{"session-invalid",
                         GLISSON_TEXT("{0} of the session cannot be read: {1}."),
                         {which, why},
                         GLISSON_TEXT("A command is {\"hold\": {...}}, {\"release\": id} or {\"undo\": true}."),
                         file});
  };
  const Json* commands = value_in(*document, "commands");
  if (!says(*document, "format", "glisson-session/1") || commands == nullptr || !commands->is_array()) {
    return refuse("The head", "it does not say \"format\": \"glisson-session/1\" with a list of commands");
  }
  Recording recording;
  for (const Json& command : *commands) {
    const std::string which = "Command " + std::to_string(recording.size() + 1);
    try {
      check_keys(command, {"hold", "release", "undo", "digest"});
      if (command.count("hold") + command.count("release") + command.count("undo") != 1) {
        return refuse(which, "it must say one thing to do");
      }
      const std::string digest = command.value("digest", "");
      if (command.contains("hold")) {
        recording.emplace_back(HoldTool{tool_from(command.at("hold"))}, digest);
      } else if (command.contains("release")) {
        recording.emplace_back(ReleaseTool{command.at("release").get<std::string>()}, digest);
      } else {
        recording.emplace_back(Undo{}, digest);
      }
    } catch (const Json::exception& problem) {
      return refuse(which, problem.what());
    } catch (const std::invalid_argument& problem) {
      return refuse(which, problem.what());
    }
  }
  return recording;
}

}  // namespace glisson::rehearsal

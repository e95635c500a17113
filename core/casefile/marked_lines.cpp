#include "casefile/marked_lines.h"

#include <algorithm>

#include "base/json.h"
#include "geometry/nearest.h"
#include "guidance/seen_line.h"

namespace glisson::casefile {

using Eigen::Vector3d;

namespace {

constexpr const char* format = "glisson-marked-lines/1";
constexpr std::size_t most_places = 10'000;
constexpr double spacing_mm = 3;  // between places of a line that is handed on
constexpr double noise_mm = 2;    // of each coordinate, as a hand marks it

Json json_of_places(const std::vector<Vector3d>& places_mm) {
  Json json = Json::array();
  for (const Vector3d& place : places_mm) json.push_back(glisson::json_of(place));
  return json;
}

// Nothing where one is no place.
std::optional<std::vector<Vector3d>> places_from(const Json& json) {
  if (!json.is_array() || json.size() > most_places) return std::nullopt;
  std::vector<Vector3d> places_mm;
  for (const Json& each : json) {
    if (!each.is_array() || each.size() != 3) return std::nullopt;
    if (!std::all_of(each.begin(), each.end(), [](const Json& number) { return number.is_number(); }))
      return std::nullopt;
    places_mm.emplace_back(each[0].get<double>(), each[1].get<double>(), each[2].get<double>());
    if (!places_mm.back().allFinite()) return std::nullopt;
  }
  return places_mm;
}

std::optional<MarkedLine> line_from(const Json& json) {
  if (!json.is_object() || !json.contains("id") || !json.at("id").is_string()) return std::nullopt;
  MarkedLine line{json.at("id").get<std::string>(), {}, {}};
  const auto at_rest_mm = places_from(json.value("at_rest", Json::array()));
  const Json seen = json.value("seen", Json::object());
  if (!at_rest_mm || !seen.is_object()) return std::nullopt;
  line.at_rest_mm = *at_rest_mm;
  for (const auto& [frame, places] : seen.items()) {
    const bool is_number = !frame.empty() && frame.size() < 7 &&
                           std::all_of(frame.begin(), frame.end(), [](char c) { return c >= '0' && c <= '9'; });
    const auto seen_mm = places_from(places);
    if (!is_number || !seen_mm) return std::nullopt;
    line.seen_mm[std::stoul(frame)] = *seen_mm;
  }
  return line;
}

// A line is one from two places on.
bool is_marked(const std::vector<Vector3d>& places_mm) { return places_mm.size() >= 2; }

}  // namespace

Json json_of(const MarkedLines& marked) {
  Json lines = Json::array();
  for (const MarkedLine& line : marked.lines) {
    Json seen = Json::object();
    for (const auto& [frame, places_mm] : line.seen_mm) seen[std::to_string(frame)] = json_of_places(places_mm);
    lines.push_back({{"id", line.id}, {"at_rest", json_of_places(line.at_rest_mm)}, {"seen", seen}});
  }
  return {{"format", format}, {"sequence", marked.sequence}, {"lines", lines}};
}

std::optional<MarkedLines> marked_lines_from(const Json& json) {
  const auto text = [&](const char* key) {
    return json.contains(key) && json.at(key).is_string() ? json.at(key).get<std::string>() : std::string();
  };
  if (!json.is_object() || text("format") != format || !json.contains("lines") || !json.at("lines").is_array()) {
    return std::nullopt;
  }
  MarkedLines marked{text("sequence"), {}};
  for (const Json& each : json.at("lines")) {
    auto line = line_from(each);
    if (!line) return std::nullopt;
    marked.lines.push_back(*std::move(line));
  }
  return marked;
}

Result<MarkedLines> read_marked_lines(const std::filesystem::path& file) {
  const auto document = read_json_file(file);
  if (!document) return failure(document.error());
  auto marked = marked_lines_from(*document);
  if (marked) return *std::move(marked);
  return failure(
      Error{"lines-invalid",
            GLISSON_TEXT("{0} holds no marked lines."),
            {file.string()},
            GLISSON_TEXT("It begins with \"format\": \"glisson-marked-lines/1\"; a line has an id, places at "
                         "rest and places seen, three numbers each."),
            file});
}

std::optional<std::size_t> first_marked_frame(const MarkedLines& marked) {
  std::optional<std::size_t> first;
  for (const MarkedLine& line : marked.lines) {
    if (!is_marked(line.at_rest_mm)) continue;
    for (const auto& [frame, places_mm] : line.seen_mm) {
      if (is_marked(places_mm)) first = std::min(first.value_or(frame), frame);
    }
  }
  return first;
}

void add_lines(GuidedSequence& guided, const MarkedLines& marked) {
  const geometry::SurfaceDistance liver(guided.structures.front().at_rest);
  for (const MarkedLine& line : marked.lines) {
    if (!is_marked(line.at_rest_mm)) continue;
    std::vector<Vector3d> at_rest_mm = guidance::filled_in(line.at_rest_mm, spacing_mm);
    for (Vector3d& place : at_rest_mm) place = liver.closest(place).point_mm;  // a chord runs below a ridge
    for (std::size_t k = 0; k < guided.frame_of.size(); ++k) {
      const auto seen = line.seen_mm.find(guided.frame_of[k]);
      if (seen == line.seen_mm.end() || !is_marked(seen->second)) continue;
      guided.guidance.frames[k].curves.push_back(
          {line.id, at_rest_mm, guidance::filled_in(seen->second, spacing_mm), noise_mm});
    }
  }
}

}  // namespace glisson::casefile

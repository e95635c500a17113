#include "registration_quality/sequence_file.h"

#include <fmt/format.h>
#include <cmath>
#include <map>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/csv.h"
#include "base/files.h"
#include "base/json.h"
#include "geometry/mesh_file.h"
#include "geometry/ply_file.h"
#include "registration_quality/benchmark.h"

namespace glisson::registration_quality {
namespace {

namespace fs = std::filesystem;

Failure not_made(const fs::path& folder, const std::error_code& problem) {
  return failure("folder-not-made", GLISSON_TEXT("The folder {0} cannot be made: {1}."),
                 {folder.string(), problem.message()});
}

Failure invalid(const fs::path& file, std::string what) {
  return failure(Error{"sequence-invalid",
                       GLISSON_TEXT("{0}: {1}."),
                       {file.filename().string(), std::move(what)},
                       GLISSON_TEXT("A sequence names frames with a cloud each, and landmarks."),
                       file});
}

struct Sighting {
  std::string landmark;
  std::size_t frame = 0;
  Eigen::Vector3d position_mm;
};
std::optional<Sighting> sighting_in(const CsvRow& row, std::size_t frames);
Result<std::vector<LandmarkTrack>> read_tracks(const fs::path& file, std::size_t frames);

}  // namespace

Result<SequenceFiles> read_sequence(const fs::path& file) {
  const auto document = read_json_file(file);
  if (!document) return failure(document.error());
  const fs::path folder = file.parent_path();
  const Json& json = *document;
  const auto text_of = [](const Json& object, const char* key) -> std::optional<std::string> {
    if (!object.is_object() || !object.contains(key) || !object[key].is_string()) return std::nullopt;
    return object[key].get<std::string>();
  };
  if (!json.is_object()) return invalid(file, GLISSON_TEXT("it is not an object"));
  if (auto known = refuse_unknown_keys(
          json, {"frames", "landmarks", "model", "camera", "registered", "benchmark", "simulated"}, "sequence");
      !known) {
    return failure(std::move(known.error()).in_file(file));
  }
  if (!json.contains("frames") || !json["frames"].is_array())
    return invalid(file, GLISSON_TEXT("it has no list of frames"));

  SequenceFiles sequence;
  for (const Json& frame : json["frames"]) {
    const auto cloud = text_of(frame, "cloud");
    if (!cloud) return invalid(file, "frame " + std::to_string(sequence.clouds.size()) + " names no cloud");
    sequence.clouds.push_back(folder / *cloud);
    const auto image = text_of(frame, "image");
    sequence.images.push_back(image ? folder / *image : fs::path());
  }
  if (json.contains("registered")) {
    if (!json["registered"].is_array() || json["registered"].size() != sequence.clouds.size()) {
      return invalid(file, GLISSON_TEXT("registered does not name one cloud a frame"));
    }
    for (const Json& cloud : json["registered"]) {
      if (!cloud.is_string()) return invalid(file, GLISSON_TEXT("registered holds something that is no file name"));
      sequence.registered.push_back(folder / cloud.get<std::string>());
    }
  }
  if (json.contains("camera")) {
    auto camera = vision::camera_from_json(json["camera"].dump());
    if (!camera) {
      return invalid(file,
                     GLISSON_TEXT("camera has no 3 x 3 matrix with positive focal lengths, or a distortion that is no "
                                  "list of numbers"));
    }
    sequence.camera = std::move(*camera);
  }
  sequence.simulated = text_of(json, "simulated").value_or("");
  if (const auto model = text_of(json, "model")) sequence.model = folder / *model;
  for (const auto* list : {&sequence.clouds, &sequence.registered}) {
    for (std::size_t frame = 0; frame < list->size(); ++frame) {
      std::error_code no_name;  // of a length that the system takes
      if (fs::exists((*list)[frame], no_name)) continue;
      return failure(Error{"sequence-frame-missing",
                           GLISSON_TEXT("Frame {0} is missing: there is no file {1}."),
                           {std::to_string(frame), (*list)[frame].string()},
                           GLISSON_TEXT("Remove the frame from the sequence (and number the tracks anew), or add it."),
                           file});
    }
  }
  const auto tracks = text_of(json, "landmarks");
  if (!tracks) return invalid(file, GLISSON_TEXT("it names no file of landmarks"));
  auto landmarks = read_tracks(folder / *tracks, sequence.clouds.size());
  if (!landmarks) return failure(landmarks.error());
  sequence.landmarks = std::move(*landmarks);
  if (json.contains("benchmark")) {
    const auto name = text_of(json, "benchmark");
    if (!name) return invalid(file, GLISSON_TEXT("benchmark is no file name"));
    auto benchmark = read_benchmark(folder / *name, sequence.landmarks, sequence.clouds.size());
    if (!benchmark) return failure(benchmark.error());
    sequence.benchmark = std::move(*benchmark);
  }
  return sequence;
}

Result<NewSequenceFolder> NewSequenceFolder::make(const fs::path& folder) {
  std::error_code problem;
  if (fs::exists(folder, problem) && !fs::is_empty(folder, problem)) {
    return failure(Error{"sequence-folder-not-empty",
                         GLISSON_TEXT("The folder {0} is not empty."),
                         {folder.string()},
                         GLISSON_TEXT("Name a new folder for the sequence."),
                         folder});
  }
  const fs::path whole = fs::absolute(folder, problem).lexically_normal();
  const fs::path place = whole.has_filename() ? whole : whole.parent_path();
  fs::create_directories(place.parent_path(), problem);
  if (problem) return not_made(folder, problem);
  auto made = NewFolder::begin(place);
  if (!made) return failure(std::move(made.error()));
  return NewSequenceFolder(std::move(*made));
}

Result<void> NewSequenceFolder::keep() {
  std::error_code filled;
  fs::remove(folder_.target(), filled);  // an empty one may have been there
  const int code = folder_.put_in_place();
  if (code == 0) return {};
  return not_made(folder_.target(), std::error_code(code, std::generic_category()));
}

Result<geometry::Surface> read_cloud(const fs::path& file) {
  return file.extension() == ".ply" ? geometry::read_ply(file) : geometry::read_surface(file);
}

namespace {

constexpr std::string_view tracks_header = "landmark,frame,x_mm,y_mm,z_mm";

Error no_tracks(const fs::path& file) {
  return {"tracks-invalid",
          GLISSON_TEXT("The first line of {0} is not {1}."),
          {file.filename().string(), std::string(tracks_header)},
          GLISSON_TEXT("Name the columns so, in this order, with commas between them."),
          file};
}

Result<std::vector<LandmarkTrack>> read_tracks(const fs::path& file, std::size_t frames) {
  const auto text = read_text_file(file);
  if (!text) return failure(text.error());
  std::vector<LandmarkTrack> tracks;
  std::map<std::string, std::size_t> place;
  const std::vector<CsvRow> rows = csv_rows(*text);
  if (rows.empty() || fmt::format("{}", fmt::join(rows.front().cells, ",")) != tracks_header) {
    return failure(no_tracks(file));
  }
  for (auto row = rows.begin() + 1; row != rows.end(); ++row) {
    const auto sighting = sighting_in(*row, frames);
    if (!sighting) {
      return failure(Error{"tracks-invalid",
                           GLISSON_TEXT("Line {1} of {0} is not landmark,frame,x_mm,y_mm,z_mm with a frame below {2}."),
                           {file.filename().string(), std::to_string(row->line), std::to_string(frames)},
                           {},
                           file});
    }
    const auto [found, is_new] = place.try_emplace(sighting->landmark, tracks.size());
    if (is_new) tracks.push_back({sighting->landmark, std::vector<std::optional<Eigen::Vector3d>>(frames)});
    tracks[found->second].positions_mm[sighting->frame] = sighting->position_mm;
  }
  return tracks;
}

std::optional<Sighting> sighting_in(const CsvRow& row, std::size_t frames) {
  const double frame = row.number(1);
  const bool is_one = frame >= 0 && frame < static_cast<double>(frames) && frame == std::floor(frame);
  if (row.cells.size() != 5 || !is_one) return std::nullopt;
  const Sighting sighting{
      std::string(row.cells[0]), static_cast<std::size_t>(frame), {row.number(2), row.number(3), row.number(4)}};
  return sighting.position_mm.allFinite() ? std::optional(sighting) : std::nullopt;
}

}  // namespace
}  // namespace glisson::registration_quality

#pragma once
// A sequence on disk is a JSON document that names the frames' images and clouds, the landmarks' tracks and the model.
// Where somebody else registered the clouds, it names those as registered.
//
//   {"frames": [{"image": "f000.png", "cloud": "f000.ply"}, ...], "landmarks": "tracks.csv", "model": "model.ply",
//    "camera": {"matrix": [3x3], "distortion": [..]}, "registered": ["r000.ply", ...], "benchmark": "benchmark.csv",
//    "simulated": "how"}
//
// tracks.csv: landmark,frame,x_mm,y_mm,z_mm, frames counted from 0. benchmark.csv: benchmark.h. Paths are relative to
// the document.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/new_folder.h"
#include "base/result.h"
#include "registration_quality/sirgn.h"
#include "vision/calibration.h"

namespace glisson::registration_quality {

struct SequenceFiles {
  std::vector<std::filesystem::path> images;      // empty paths where a frame names none
  std::vector<std::filesystem::path> clouds;      // one a frame
  std::vector<std::filesystem::path> registered;  // one a frame, or none at all
  std::optional<std::filesystem::path> model;
  std::optional<vision::Camera> camera;  // that took the images; clouds and landmarks are in its space
  std::vector<LandmarkTrack> landmarks;
  std::optional<Benchmark> benchmark;  // that registrations are judged against, whatever their algorithm
  std::string simulated;  // how, to be said wherever it is shown; empty: the document says nothing of the kind
};

// Failures: file-not-readable, json-..., "sequence-invalid" (what is missing, or of which kind), "tracks-invalid"
// (which line), those of read_benchmark. Fails with "sequence-frame-missing" where a file that is named is not there.
Result<SequenceFiles> read_sequence(const std::filesystem::path& file);

// A folder that a sequence is written into. It must not exist or be empty ("sequence-folder-not-empty"), and unless
// what is in it is kept, it is left as it was found. Other failure: "folder-not-made".
class NewSequenceFolder {
 public:
  static Result<NewSequenceFolder> make(const std::filesystem::path& folder);
  // Where the files are written until all are there.
  [[nodiscard]] const std::filesystem::path& beside() const { return folder_.path(); }
  // Puts the whole folder in its place.
  Result<void> keep();

 private:
  explicit NewSequenceFolder(NewFolder folder) : folder_(std::move(folder)) {}
  NewFolder folder_;
};

// The points of a surface or cloud file, triangles or not. PLY clouds need no triangles.
Result<geometry::Surface> read_cloud(const std::filesystem::path& file);

}  // namespace glisson::registration_quality

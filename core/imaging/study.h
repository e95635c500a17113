#pragma once
// Finding the image series in a folder, a DICOMDIR or a file, and what is wrong with each of them.
//
//   const Result<Study> study = scan("/media/cdrom");
//   for (const Series& series : study->series) ... series.role, series.grid, series.problems
//
// Only headers are read here; read_series.h reads the voxels.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "imaging/image.h"

namespace glisson::imaging {

// What a series is for, in a study with MR elastography (MRE).
enum class Role {
  anatomy,
  mre_magnitude,   // the magnitude of the motion-encoded images
  mre_phase,       // their phase: what the scanner measured of the motion, usually wrapped
  mre_wave,        // displacement or curl computed from the phase
  mre_stiffness,   // the map of the shear stiffness (an elastogram)
  mre_confidence,  // where that map is to be trusted
  segmentation,
  other,  // nothing in the headers says
};
// The name used in files and on the command line: "mre_stiffness".
[[nodiscard]] std::string_view role_name(Role role);

// For which motion the images of an elastography volume were encoded, as far as the header says.
struct MotionEncoding {
  std::optional<double> frequency_Hz;    // of the vibration
  std::optional<int> direction;          // which of the encoded directions, from 0
  std::optional<Eigen::Vector3d> along;  // that direction: a unit vector, patient LPS
  std::optional<int> offset;             // which of the instants that are spread over one period, from 0
  // When each slice of the volume was acquired, after the first one of them. Unless the scanner waits for the
  // vibration, the slices show it at other instants by as much. Empty where the header gives none.
  std::vector<double> slice_times_s = {};
};

// How the voxels of a series lie in its files; only read_series looks inside.
struct VoxelLayout;

// A stack of parallel slices, taken once or several times. One DICOM series that holds several stacks (other sizes,
// orientations, echoes, magnitude and phase together) is split, and `problems` says so.
struct Series {
  std::string uid;  // SeriesInstanceUID, with "#2", "#3", ... for the further stacks of one series; a path for a
                    // volume file
  std::string study_uid;
  std::string frame_of_reference_uid;
  std::string description;
  std::string modality;
  int number = 0;  // SeriesNumber
  Role role = Role::other;
  std::string role_evidence;  // the header fields that decided, for a person to read
  std::string unit;           // of the voxels once read: "HU", "kPa", "Pa", "rad", "um"; empty: arbitrary
  std::string unit_evidence;  // which header field said so
  Grid grid;                  // of one volume. Under gantry tilt its third axis is not perpendicular
  std::vector<std::filesystem::path> files;  // volume after volume, by position along the normal in each
  int volumes = 1;                           // how many complete volumes there are (24: 3 directions x 8 offsets)
  std::vector<std::string> volume_labels;    // what tells the volumes apart ("echo 2", "acquisition 17"); may be empty
  std::vector<MotionEncoding> motion;        // one a volume; empty for what is no elastography
  std::vector<std::string> problems;         // one sentence each, in English
  std::shared_ptr<const VoxelLayout> layout;
};

struct SkippedFile {
  std::filesystem::path path;
  std::string reason;  // one sentence
};

struct Study {
  std::vector<Series> series;        // by series number, then as first met
  std::vector<SkippedFile> skipped;  // image files that could not be used, and files that are no images
};

// All series under a folder (walked to the bottom, links to folders not followed), in the files that a DICOMDIR names,
// or in one file: DICOM, NIfTI, NRRD or MetaImage. Slices are ordered by where they stand and never by name or number;
// the spacing comes from their positions.
//
// A file that cannot be used is skipped with its reason and never stops the rest. Fails only where the path itself
// cannot be read ("path-not-found", "path-not-readable", "dicomdir-damaged"), or with "cancelled".
[[nodiscard]] Result<Study> scan(const std::filesystem::path& path, const Progress& progress = {});

}  // namespace glisson::imaging

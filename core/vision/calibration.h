#pragma once
// A stereo camera: what each eye's lens does, and where the right eye is. Lengths in mm; a camera looks along +z, with
// x to the right and y down its picture.

#include <Eigen/Geometry>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"

namespace glisson::vision {

struct Camera {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();  // focal lengths and principal point, in pixels
  std::vector<double> distortion;                        // k1, k2, p1, p2, k3, ... as OpenCV numbers them; may be empty
};

struct StereoCalibration {
  Camera left;
  Camera right;
  Eigen::Isometry3d left_to_right =
      Eigen::Isometry3d::Identity();  // takes a point in left-camera mm to right-camera mm
  int width = 0, height = 0;          // of the pictures that it was made of; 0 where nothing says
  std::string simulated;              // how, where no camera took its pictures; empty: nothing says so
  std::vector<std::string> notes;     // what was put right, and why

  [[nodiscard]] double baseline_mm() const { return left_to_right.translation().norm(); }
};

// Reads
//   {"left": {"matrix": [3x3], "distortion": [..]}, "right": {...}, "left_to_right": [4x4]}      (.json)
// where "image_size": [width, height] may say which pictures it is of, and "simulated" that no camera took them;
// or OpenCV's M1, D1, M2, D2, R, T, as its calibration samples write them                          (.yml, .yaml, .xml)
// or a folder of plain text files, as public sets of laparoscopes have them. A name holds left or right, and intrinsic
// (3 x 3) or distortion (any number, may be missing). One more file is l2r or r2l (4 x 4). A left_to_right that would
// put the right eye to the left of the left one is the other direction. It is turned around, and a note says so.
// Failures: file-not-readable, json-..., "calibration-invalid" (what is missing), "calibration-not-rotation" (by how
// much), "calibration-no-baseline".
Result<StereoCalibration> read_stereo_calibration(const std::filesystem::path& file);

// The two lenses alone, left first, from a folder of text files that need not say where the right eye is.
Result<std::pair<Camera, Camera>> read_cameras(const std::filesystem::path& folder);

// One camera, {"matrix": [3x3], "distortion": [..]}, as text. Failure: "calibration-invalid".
Result<Camera> camera_from_json(const std::string& text);

// As the JSON above. Failures: those of write_json_file.
Result<void> write_stereo_calibration(const std::filesystem::path& file, const StereoCalibration& calibration);

// Whether both principal points lie within the middle two fifths of pictures of that size, as lenses are built: a
// calibration at another size mostly does not, and nothing else tells where it says no size itself.
[[nodiscard]] bool may_be_of_size(const StereoCalibration& calibration, int width, int height);

// The same checks on values from elsewhere.
Result<StereoCalibration> checked(StereoCalibration calibration);

}  // namespace glisson::vision

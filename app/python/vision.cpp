// Stereo video: calibration, clouds, tracked landmarks, and sequences that sirgn_of_sequence judges.

#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <limits>

#include "arrays.h"
#include "choices.h"
#include "geometry/surface.h"
#include "long_call.h"
#include "registration_quality/video_sequence.h"
#include "rooms.h"
#include "vision/calibrate.h"
#include "vision/picture_check.h"

namespace py = pybind11;
using namespace py::literals;

namespace glisson::python {
namespace {

using namespace vision;
using std::filesystem::path;
using Bytes = py::array_t<std::uint8_t, py::array::c_style>;

// height x width x 3, red, green, blue.
Frame frame_from(const Bytes& picture) {
  if (picture.ndim() != 3 || picture.shape(2) != 3 || picture.size() == 0) {
    raise("array-shape", "A picture must be uint8 of height x width x 3; this one has {0}.", {shape_in_words(picture)});
  }
  constexpr py::ssize_t most = 32768;
  if (picture.shape(0) > most || picture.shape(1) > most) raise("array-shape", "The picture is too large.");
  return {static_cast<int>(picture.shape(1)),
          static_cast<int>(picture.shape(0)),
          {picture.data(), picture.data() + picture.size()}};
}

py::array array_of(Frame frame) {
  const py::ssize_t height = frame.height, width = frame.width;
  return handed_over(std::move(frame.rgb)).reshape({height, width, py::ssize_t(3)});
}

py::dict dict_of(const vision::Camera& camera) {
  return py::dict("matrix"_a = camera.matrix, "distortion"_a = camera.distortion);
}

vision::Camera camera_from(const py::dict& dict, const char* which) {
  if (!dict.contains("matrix")) raise("calibration-invalid", "The {0} camera has no matrix.", {which});
  vision::Camera camera;
  camera.matrix = dict["matrix"].cast<Eigen::Matrix3d>();
  if (dict.contains("distortion")) camera.distortion = dict["distortion"].cast<std::vector<double>>();
  return camera;
}

void add_calibration(py::module_& module) {
  py::class_<StereoCalibration, std::shared_ptr<StereoCalibration>>(
      module, "StereoCalibration",
      R"(A stereo camera: what each lens does, and where the right eye is.

left, right     dicts: matrix (3 x 3, pixels), distortion (k1, k2, p1, p2, k3, ..., as OpenCV numbers them)
left_to_right   4 x 4: takes a point in left-camera mm to right-camera mm

Raises glisson.Error: calibration-invalid, calibration-not-rotation, calibration-no-baseline.)")
      .def(py::init([](const py::dict& left, const py::dict& right, const Eigen::Matrix4d& left_to_right) {
             StereoCalibration made;
             made.left = camera_from(left, "left");
             made.right = camera_from(right, "right");
             made.left_to_right.matrix() = left_to_right;
             return or_raise(checked(std::move(made)));
           }),
           py::arg("left"), py::arg("right"), py::arg("left_to_right"))
      .def_property_readonly(
          "left", [](const StereoCalibration& self) { return dict_of(self.left); }, "Lens of the left eye: a dict.")
      .def_property_readonly(
          "right", [](const StereoCalibration& self) { return dict_of(self.right); }, "Lens of the right eye: a dict.")
      .def_property_readonly(
          "left_to_right", [](const StereoCalibration& self) { return Eigen::Matrix4d(self.left_to_right.matrix()); },
          "4 x 4, mm.")
      .def_property_readonly("baseline_mm", &StereoCalibration::baseline_mm, "Between the eyes, mm.")
      .def_readonly("notes", &StereoCalibration::notes, "What was put right, and why.");
  module.def(
      "read_calibration",
      [](const path& file) {
        return std::make_shared<StereoCalibration>(short_call([&] { return read_stereo_calibration(file); }));
      },
      py::arg("file"),
      "A StereoCalibration of JSON, OpenCV's YAML, or a folder of text files.\n\nRaises glisson.Error: "
      "calibration-invalid, calibration-not-rotation, calibration-no-baseline.");
  module.def(
      "write_calibration",
      [](const path& file, const StereoCalibration& calibration) {
        short_call([&] { return write_stereo_calibration(file, calibration); });
      },
      py::arg("file"), py::arg("calibration"), "Writes a StereoCalibration as JSON, all or nothing.");
  module.def(
      "calibrate",
      [](const std::vector<Bytes>& left, const std::vector<Bytes>& right, const std::string& board, int columns,
         int rows, double spacing_mm) {
        if (left.size() != right.size()) {
          raise("calibration-not-paired", "There are {0} left and {1} right pictures: they must be taken in pairs.",
                {std::to_string(left.size()), std::to_string(right.size())});
        }
        using Pattern = Board::Pattern;
        Board seen;
        seen.pattern = chosen<Pattern>(
            "board", board,
            {{"chessboard", Pattern::chessboard}, {"circles", Pattern::circles}, {"dots", Pattern::dots}});
        seen.columns = columns;
        seen.rows = rows;
        seen.spacing_mm = spacing_mm;
        std::vector<BoardPair> pairs;
        for (std::size_t n = 0; n < left.size(); ++n) {
          pairs.push_back({"pair " + std::to_string(n + 1), frame_from(left[n]), frame_from(right[n])});
        }
        const CalibrationFit fit = short_call([&] { return calibrate(pairs, seen); });
        return py::dict("calibration"_a = std::make_shared<StereoCalibration>(fit.calibration),
                        "rms_px"_a = fit.stereo_rms_px, "pair_rms_px"_a = fit.pair_rms_px, "pairs"_a = fit.pairs,
                        "points"_a = fit.points, "left_rms_px"_a = fit.left.rms_px, "right_rms_px"_a = fit.right.rms_px,
                        "notes"_a = fit.notes);
      },
      py::arg("left"), py::arg("right"), py::kw_only(), py::arg("board"), py::arg("columns"), py::arg("rows"),
      py::arg("spacing_mm"),
      R"(A StereoCalibration from pictures of a board that both eyes took at once.

left, right     lists of pictures: uint8, (height, width, 3)
board           "chessboard" (columns x rows inner corners), "circles", or "dots" (circles, four of them larger)

A dict: calibration, rms_px (reprojection, both eyes together), pair_rms_px, pairs, points, left_rms_px, right_rms_px,
notes. Raises glisson.Error: board-invalid, calibration-too-few-views, stereo-image-sizes, calibration-failed.)");
}

py::dict cloud_of(const Bytes& left, const Bytes& right, const StereoCalibration& calibration, double nearest_mm,
                  double farthest_mm, int step_px) {
  const Frame l = frame_from(left), r = frame_from(right);
  if (step_px < 1 || step_px > 64) raise("stereo-range", "step_px must be from 1 to 64.");
  StereoOptions options;
  options.nearest_mm = nearest_mm;
  options.farthest_mm = farthest_mm;
  options.step_px = step_px;
  StereoCloud cloud = short_call([&] {
    return StereoMatcher::prepare(calibration, l.width, l.height, options).and_then([&](StereoMatcher matcher) {
      return check_against_pictures(calibration, l, r).and_then([&](const PictureCheck&) {
        return matcher.cloud(l, r);
      });
    });
  });
  auto surface = std::make_shared<geometry::Surface>();
  py::dict dict("valid_fraction"_a = cloud.valid_fraction, "picture"_a = array_of(std::move(cloud.picture)),
                "confidence"_a = handed_over(std::move(cloud.confidence)),
                "colour"_a = py::array_t<std::uint8_t>({py::ssize_t(cloud.colour.size()), py::ssize_t(3)},
                                                       reinterpret_cast<const std::uint8_t*>(cloud.colour.data())),
                "pixels"_a = py::array_t<int>({py::ssize_t(cloud.pixels.size()), py::ssize_t(2)},
                                              reinterpret_cast<const int*>(cloud.pixels.data())));
  surface->points_mm = std::move(cloud.points_mm);
  surface->triangles = std::move(cloud.triangles);
  dict["surface"] = std::move(surface);
  return dict;
}

py::array positions_of(const Track& track) {
  constexpr double unseen = std::numeric_limits<double>::quiet_NaN();
  std::vector<Eigen::Vector3d> all;
  for (const auto& position : track.positions_mm) all.push_back(position.value_or(Eigen::Vector3d::Constant(unseen)));
  return handed_over(std::move(all));
}

void add_video(py::module_& module) {
  module.def(
      "read_picture", [](const path& file) { return array_of(short_call([&] { return read_frame(file); })); },
      py::arg("file"), "PNG, JPEG, TIFF, BMP or PNM: uint8, (height, width, 3), red, green, blue.");
  module.def(
      "write_picture",
      [](const path& file, const Bytes& picture) {
        const Frame frame = frame_from(picture);
        short_call([&] { return write_frame(frame, file); });
      },
      py::arg("file"), py::arg("picture"), "Writes uint8 of (height, width, 3), by the extension, all or nothing.");
  module.def("stereo_cloud", &cloud_of, py::arg("left"), py::arg("right"), py::arg("calibration"), py::kw_only(),
             py::arg("nearest_mm") = StereoOptions{}.nearest_mm, py::arg("farthest_mm") = StereoOptions{}.farthest_mm,
             py::arg("step_px") = 1,
             R"(A pair of pictures (uint8, (height, width, 3)) to points in left-camera mm.

A dict: surface (a Surface between neighbouring pixels), confidence (0..1, one a point), colour (n, 3), pixels (n, 2: x,
y in `picture`), picture (the rectified left one), valid_fraction (of what is not masked).
Raises glisson.Error: stereo-range, stereo-calibration-size, stereo-image-sizes, stereo-eyes-exchanged,
calibration-not-of-pictures, stereo-failed.)");
  module.def(
      "track_landmarks",
      [](const py::iterable& pairs, const StereoCalibration& calibration) {
        LandmarkTracker tracker(calibration);
        for (const py::handle& pair : pairs) {
          const auto [left, right] = pair.cast<std::pair<Bytes, Bytes>>();
          const Frame l = frame_from(left), r = frame_from(right);
          short_call([&] { return tracker.add(l, r); });
          if (PyErr_CheckSignals() != 0) throw py::error_already_set();
        }
        py::dict tracks;
        for (const Track& track : tracker.tracks()) tracks[py::str(track.id)] = positions_of(track);
        return tracks;
      },
      py::arg("pairs"), py::arg("calibration"),
      R"(Landmarks of a stereo video, followed in both eyes at once.

pairs  (left, right) a frame, pictures each; any iterable, read one by one

id -> (frames, 3): left-camera mm, NaN where it was not seen; the longest first, as sirgn() takes them.
Raises glisson.Error: stereo-image-sizes, stereo-failed.)");
  module.def(
      "make_sequence",
      [](const path& left, const path& right, const StereoCalibration& calibration, const path& folder, int every,
         int frames, int step_px, const std::optional<path>& model, const std::optional<path>& landmarks,
         const py::object& progress) {
        registration_quality::VideoSequenceOptions options;
        options.every = std::max(1, every);
        options.maximum_frames = std::max(3, frames);
        options.stereo.step_px = std::clamp(step_px, 1, 64);
        options.model = model;
        options.landmarks = landmarks;
        const auto made = long_call(progress, [&](const Progress& told) -> Result<registration_quality::VideoSequence> {
          auto video = StereoSource::open({left, right});
          if (!video) return failure(video.error());
          return registration_quality::make_sequence(*video, calibration, folder, options, told);
        });
        return py::dict("file"_a = made.file, "frames"_a = made.frames, "landmarks"_a = made.landmarks,
                        "mean_points"_a = made.mean_points, "valid_fraction"_a = made.mean_valid_fraction,
                        "epipolar_px"_a = made.epipolar_px, "alignment_rms_mm"_a = made.alignment_rms_mm,
                        "notes"_a = made.notes);
      },
      py::arg("left"), py::arg("right"), py::arg("calibration"), py::arg("folder"), py::kw_only(), py::arg("every") = 1,
      py::arg("frames") = 600, py::arg("step_px") = 4, py::arg("model") = py::none(), py::arg("landmarks") = py::none(),
      py::arg("progress") = py::none(),
      R"(A stereo video (files, or folders of pictures) to a sequence on disk for sirgn_of_sequence: a cloud a frame, tracked
landmarks and a model, in a new folder.

every, frames  one frame of so many, at most so many; step_px: a point every so many pixels
model          a surface file to register to; without, the frames' own, aligned globally
landmarks      tracks.csv of an expert; without, tracked features

A dict: file (sequence.json), frames, landmarks, mean_points, valid_fraction, epipolar_px, alignment_rms_mm (how well
the frames' landmarks agree before, as rigid bodies, and aligned; None with a model), notes.
progress is told (fraction, stage); KeyboardInterrupt cancels.
Raises glisson.Error: video-not-readable, video-no-frames, sequence-folder-not-empty, sequence-lengths,
sequence-too-few-frames, sequence-no-landmarks.)");
}

}  // namespace

void add_vision(py::module_& module) {
  add_calibration(module);
  add_video(module);
}

}  // namespace glisson::python

#include "vision/calibration.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <opencv2/core/eigen.hpp>
#include <opencv2/core/persistence.hpp>
#include <optional>
#include <tuple>

#include "base/files.h"
#include "base/folder_contents.h"
#include "base/json.h"

namespace glisson::vision {
namespace {

namespace fs = std::filesystem;

Result<void> checked_camera(const Camera& camera);
Result<void> checked_rotation(const StereoCalibration& calibration);

Failure invalid(const fs::path& file, std::string what) {
  return failure(Error{"calibration-invalid",
                       GLISSON_TEXT("The calibration {0} has no {1}."),
                       {file.filename().string(), std::move(what)},
                       GLISSON_TEXT("It needs left and right, each with a matrix and distortion, and left_to_right."),
                       file});
}

// Numbers of a JSON array, nested by rows or not.
std::optional<std::vector<double>> numbers(const Json& json) {
  if (!json.is_array()) return std::nullopt;
  std::vector<double> all;
  for (const Json& item : json) {
    if (item.is_number()) {
      all.push_back(item.get<double>());
    } else if (const auto row = numbers(item)) {
      all.insert(all.end(), row->begin(), row->end());
    } else {
      return std::nullopt;
    }
  }
  return all;
}

std::optional<Camera> camera_of(const Json& json) {
  if (!json.is_object() || !json.contains("matrix")) return std::nullopt;
  const auto matrix = numbers(json["matrix"]);
  if (!matrix || matrix->size() != 9) return std::nullopt;
  Camera camera;
  camera.matrix = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(matrix->data());
  if (json.contains("distortion")) {
    const auto distortion = numbers(json["distortion"]);
    if (!distortion) return std::nullopt;
    camera.distortion = *distortion;
  }
  return camera;
}

std::optional<Camera> camera_in(const Json& document, const char* eye) {
  if (!document.is_object() || !document.contains(eye)) return std::nullopt;
  return camera_of(document[eye]);
}

Result<StereoCalibration> read_json(const fs::path& file) {
  const auto document = read_json_file(file);
  if (!document) return failure(document.error());
  StereoCalibration calibration;
  const auto left = camera_in(*document, "left");
  if (!left) return invalid(file, "left camera");
  const auto right = camera_in(*document, "right");
  if (!right) return invalid(file, "right camera");
  calibration.left = *left;
  calibration.right = *right;
  const auto transform = document->contains("left_to_right") ? numbers((*document)["left_to_right"])
                                                             : std::optional<std::vector<double>>();
  if (!transform || transform->size() != 16) return invalid(file, "left_to_right of 4 x 4 numbers");
  calibration.left_to_right.matrix() =
      Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(transform->data());
  if (document->contains("simulated")) {
    const Json& how = (*document)["simulated"];
    if (!how.is_string()) return invalid(file, "text that says how it was simulated");
    calibration.simulated = how;
  }
  if (!document->contains("image_size")) return calibration;
  const auto size = numbers((*document)["image_size"]);
  const auto is_length = [](double length) { return length >= 1 && length <= 1e6 && length == std::floor(length); };
  if (!size || size->size() != 2 || !is_length((*size)[0]) || !is_length((*size)[1])) {
    return invalid(file, "image_size of two whole numbers");
  }
  calibration.width = static_cast<int>((*size)[0]);
  calibration.height = static_cast<int>((*size)[1]);
  return calibration;
}

Result<StereoCalibration> read_opencv(const fs::path& file) {
  // Read by us: of a file that is not there OpenCV writes to stderr.
  const auto text = read_text_file(file, std::uint64_t{1} << 24);
  if (!text) return failure(text.error());
  try {
    const cv::FileStorage storage(*text, cv::FileStorage::READ | cv::FileStorage::MEMORY);
    if (!storage.isOpened()) return invalid(file, "content that OpenCV can read");
    StereoCalibration calibration;
    const auto read = [&](const char* name) {
      cv::Mat matrix, in_double;
      storage[name] >> matrix;
      if (!matrix.empty()) matrix.convertTo(in_double, CV_64F);
      return in_double;
    };
    for (auto& [camera, matrix_name, distortion_name] :
         {std::tuple{&calibration.left, "M1", "D1"}, std::tuple{&calibration.right, "M2", "D2"}}) {
      const cv::Mat matrix = read(matrix_name), distortion = read(distortion_name);
      if (matrix.rows != 3 || matrix.cols != 3) return invalid(file, matrix_name);
      cv::cv2eigen(matrix, camera->matrix);
      for (int i = 0; i < static_cast<int>(distortion.total()); ++i)
        camera->distortion.push_back(distortion.at<double>(i));
    }
    const cv::Mat rotation = read("R"), translation = read("T");
    if (rotation.rows != 3 || rotation.cols != 3) return invalid(file, "R");
    if (translation.total() != 3) return invalid(file, "T");
    Eigen::Matrix3d linear;
    cv::cv2eigen(rotation, linear);
    calibration.left_to_right.linear() = linear;
    for (int i = 0; i < 3; ++i) calibration.left_to_right.translation()[i] = translation.at<double>(i);
    return calibration;
  } catch (const cv::Exception&) {
    return invalid(file, "content that OpenCV can read");
  }
}

// The numbers of a text file, between spaces, commas or line ends; nothing where there is anything else.
std::optional<std::vector<double>> numbers_in_text(const fs::path& file) {
  constexpr std::uint64_t maximum_bytes = 1 << 16;
  const auto text = read_text_file(file, maximum_bytes);
  if (!text) return std::nullopt;
  std::vector<double> all;
  const char* at = text->data();
  const char* const end = at + text->size();
  for (;;) {
    while (at != end && (std::isspace(static_cast<unsigned char>(*at)) != 0 || *at == ',')) ++at;
    if (at == end) return all;
    double number = 0;
    const auto [after, problem] = std::from_chars(at, end, number);
    if (problem != std::errc{}) return std::nullopt;
    all.push_back(number);
    at = after;
  }
}

// The file of a calibration folder whose name contains all these words; empty where there is none.
fs::path named(const fs::path& folder, std::initializer_list<std::string_view> words) {
  for (const fs::path& file : contents_of(folder)) {
    const std::string name = file.filename().string();
    if (std::all_of(words.begin(), words.end(),
                    [&](std::string_view word) { return name.find(word) != std::string::npos; })) {
      return file;
    }
  }
  return {};
}

Result<StereoCalibration> read_text_folder(const fs::path& folder) {
  StereoCalibration calibration;
  auto cameras = read_cameras(folder);
  if (!cameras) return failure(cameras.error());
  std::tie(calibration.left, calibration.right) = std::move(*cameras);
  const fs::path forth = named(folder, {"l2r"}), back = named(folder, {"r2l"});
  const auto transform = numbers_in_text(forth.empty() ? back : forth);
  if (!transform || transform->size() != 16) return invalid(folder, "file l2r or r2l of 4 x 4 numbers");
  calibration.left_to_right.matrix() =
      Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(transform->data());
  if (!forth.empty()) return calibration;
  auto good = checked_rotation(calibration);  // what is no rotation has no inverse to speak of
  if (!good) return failure(good.error());
  calibration.left_to_right = calibration.left_to_right.inverse();
  return calibration;
}

}  // namespace

Result<StereoCalibration> read_stereo_calibration(const fs::path& file) {
  std::error_code problem;
  auto calibration = fs::is_directory(file, problem) ? read_text_folder(file)
                     : file.extension() == ".json"   ? read_json(file)
                                                     : read_opencv(file);
  if (!calibration) return calibration;
  auto good = checked(std::move(*calibration));
  if (!good) return failure(std::move(good.error()).in_file(file));
  return good;
}

Result<Camera> camera_from_json(const std::string& text) {
  const auto json = parse_json(text);
  if (!json) return failure(json.error());
  const auto camera = camera_of(*json);
  if (!camera) return invalid("of a camera", "3 x 3 matrix, or a distortion that is no list of numbers");
  if (auto good = checked_camera(*camera); !good) return failure(good.error());
  return *camera;
}

Result<std::pair<Camera, Camera>> read_cameras(const fs::path& folder) {
  std::pair<Camera, Camera> cameras;
  for (auto& [camera, eye] :
       {std::pair{&cameras.first, std::string("left")}, std::pair{&cameras.second, std::string("right")}}) {
    const auto matrix = numbers_in_text(named(folder, {eye, "intrinsic"}));
    if (!matrix || matrix->size() != 9) return invalid(folder, "file of 3 x 3 " + eye + " intrinsics");
    camera->matrix = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(matrix->data());
    const fs::path distortion_file = named(folder, {eye, "distortion"});
    if (distortion_file.empty()) continue;
    const auto distortion = numbers_in_text(distortion_file);
    if (!distortion) return invalid(folder, eye + " distortion made of numbers");
    camera->distortion = *distortion;
  }
  return cameras;
}

Result<void> write_stereo_calibration(const fs::path& file, const StereoCalibration& calibration) {
  const auto rows = [](const auto& matrix) {
    Json json = Json::array();
    for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
      json.push_back(std::vector<double>(matrix.row(row).begin(), matrix.row(row).end()));
    }
    return json;
  };
  const auto camera = [&](const Camera& eye) {
    return Json{{"matrix", rows(eye.matrix)}, {"distortion", eye.distortion}};
  };
  Json document{{"left", camera(calibration.left)},
                {"right", camera(calibration.right)},
                {"left_to_right", rows(calibration.left_to_right.matrix())}};
  if (!calibration.simulated.empty()) document["simulated"] = calibration.simulated;
  if (calibration.width > 0) document["image_size"] = {calibration.width, calibration.height};
  return write_json_file(file, document);
}

bool may_be_of_size(const StereoCalibration& calibration, int width, int height) {
  const auto in_the_middle = [](double at, int length) { return at > 0.3 * length && at < 0.7 * length; };
  return in_the_middle(calibration.left.matrix(0, 2), width) && in_the_middle(calibration.left.matrix(1, 2), height) &&
         in_the_middle(calibration.right.matrix(0, 2), width) && in_the_middle(calibration.right.matrix(1, 2), height);
}

Result<StereoCalibration> checked(StereoCalibration calibration) {
  for (const Camera* camera : {&calibration.left, &calibration.right}) {
    if (auto good = checked_camera(*camera); !good) return failure(good.error());
  }
  if (auto good = checked_rotation(calibration); !good) return failure(good.error());
  if (calibration.baseline_mm() <= 0) {
    return failure("calibration-no-baseline", GLISSON_TEXT("Both eyes are in one place: there is no depth to see."));
  }
  const Eigen::Vector3d right_eye_mm = calibration.left_to_right.inverse().translation();
  if (right_eye_mm.x() < 0) {
    calibration.left_to_right = calibration.left_to_right.inverse();
    calibration.notes.push_back(
        "left_to_right puts the right eye to the left of the left one: it was taken as right to left");
  }
  return calibration;
}

namespace {

Result<void> checked_camera(const Camera& camera) {
  if (!camera.matrix.allFinite() || camera.matrix(0, 0) <= 0 || camera.matrix(1, 1) <= 0) {
    return failure("calibration-invalid", GLISSON_TEXT("A camera's focal length is not positive."));
  }
  constexpr std::array<std::size_t, 6> known{0, 4, 5, 8, 12, 14};  // of OpenCV's models of a lens
  if (std::find(known.begin(), known.end(), camera.distortion.size()) == known.end()) {
    return failure("calibration-invalid",
                   GLISSON_TEXT("A lens's distortion has 4, 5, 8, 12 or 14 coefficients; here there are {0}."),
                   {std::to_string(camera.distortion.size())});
  }
  for (const double coefficient : camera.distortion) {
    if (!std::isfinite(coefficient)) {
      return failure("calibration-invalid", GLISSON_TEXT("A coefficient of distortion is not finite."));
    }
  }
  return {};
}

Result<void> checked_rotation(const StereoCalibration& calibration) {
  constexpr double largest_deviation = 1e-3;  // files print few digits
  const Eigen::Matrix3d rotation = calibration.left_to_right.linear();
  const Eigen::RowVector4d last_row = calibration.left_to_right.matrix().row(3);
  const double deviation =
      std::max((rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff(),
               (last_row - Eigen::RowVector4d(0, 0, 0, 1)).cwiseAbs().maxCoeff());
  if (!calibration.left_to_right.matrix().allFinite() || deviation > largest_deviation || rotation.determinant() < 0) {
    return failure("calibration-not-rotation",
                   GLISSON_TEXT("left_to_right does not hold a rotation: R R^T or the last row is off by {0}."),
                   {fmt::format("{:.3g}", deviation)});
  }
  return {};
}

}  // namespace
}  // namespace glisson::vision

#include "studies/review/example_sequence.h"

#include <fmt/format.h>
#include <cmath>
#include <numbers>
#include <random>

#include "anatomy/patient.h"
#include "base/files.h"
#include "base/json.h"
#include "geometry/manifold.h"
#include "geometry/mesh_file.h"
#include "geometry/nearest.h"
#include "registration_quality/sequence_file.h"
#include "studies/review/internal/example_scene.h"
#include "vision/draw.h"

namespace glisson::studies {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;

// A registration that is true but for one place.
struct Fault {
  Vector3d center_mm{0, 0, 0};  // on the model
  double radius_mm = 0;
  double largest_mm = 0;

  [[nodiscard]] Vector3d at(const Vector3d& rest_mm, int frame) const {
    const double course =
        std::sin(2 * std::numbers::pi * frame / 13.0) + 0.4 * std::sin(0.9 * frame);  // comes and goes
    const double bump = std::exp(-(rest_mm - center_mm).squaredNorm() / (radius_mm * radius_mm));
    return largest_mm / 1.4 * course * bump * Vector3d(0.7, 0.6, 0.39);
  }
};

constexpr double eyes_apart_mm = 5.5;      // of the stereo video
constexpr std::size_t hidden_places = 12;  // whose truth is told

class Recording {
 public:
  Recording(const ExampleScene& scene, const geometry::Surface& liver_lps, const fs::path& folder,
            const ExampleSequenceOptions& options);
  Result<void> add(int frame);
  Result<fs::path> finish();
  Result<void> begin_video();

 private:
  [[nodiscard]] geometry::Surface cloud_of(const ExampleScene::View& view, std::vector<Vector3d>& rest_mm);
  void sight_landmarks(const ExampleScene::View& view, int frame);
  Vector3d jitter(double sd_mm) {
    return {sd_mm * normal_(random_), sd_mm * normal_(random_), sd_mm * normal_(random_)};
  }

  const ExampleScene& scene_;
  const fs::path& folder_;
  const ExampleSequenceOptions& options_;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_{0, 1};
  std::uniform_real_distribution<double> uniform_{0, 1};
  Fault fault_;
  std::vector<Vector3d> hidden_mm_;     // inside the liver, patient coordinates
  std::vector<Vector3d> landmarks_mm_;  // at rest
  std::vector<bool> outlier_;
  std::string tracks_ = "landmark,frame,x_mm,y_mm,z_mm\n", hidden_truth_ = "id,frame,x_mm,y_mm,z_mm\n";
  Json frames_ = Json::array(), registered_ = Json::array();
};

}  // namespace

Result<fs::path> write_example_sequence(const fs::path& folder, const ExampleSequenceOptions& options,
                                        const Progress& progress) {
  anatomy::PatientOptions patient;
  patient.seed = options.patient;
  const auto liver = anatomy::make_liver_surface(patient);
  if (!liver) return failure(liver.error());
  auto made = registration_quality::NewSequenceFolder::make(folder);
  if (!made) return failure(made.error());
  const ExampleScene scene(*liver);
  Recording recording(scene, *liver, made->beside(), options);
  if (options.stereo) {
    if (auto begun = recording.begin_video(); !begun) return failure(begun.error());
  }
  for (int frame = 0; frame < options.frames; ++frame) {
    if (progress.cancelled()) return cancelled();
    if (auto added = recording.add(frame); !added) return failure(added.error());
    progress.report(static_cast<double>(frame + 1) / options.frames, GLISSON_TEXT("frames"));
  }
  auto file = recording.finish();
  if (!file) return file;
  return made->keep().map([&] { return folder / file->filename(); });
}

namespace {

// On a grid of 12 mm, at least 12 mm under the surface.
std::vector<Vector3d> places_inside(const geometry::Surface& surface) {
  constexpr double apart_mm = 12;
  const geometry::SurfaceDistance distance(surface);
  const geometry::Box box = geometry::bounding_box(surface.points_mm);
  std::vector<Vector3d> places;
  for (double z = box.min_mm.z(); z < box.max_mm.z(); z += apart_mm) {
    for (double y = box.min_mm.y(); y < box.max_mm.y(); y += apart_mm) {
      for (double x = box.min_mm.x(); x < box.max_mm.x(); x += apart_mm) {
        const Vector3d place(x, y, z);
        if (distance.closest(place).distance_mm >= apart_mm && distance.is_inside(place)) places.push_back(place);
      }
    }
  }
  return places;
}

// Points of the list, each as far as can be from those before it.
std::vector<Vector3d> spread(const std::vector<Vector3d>& among, std::size_t count) {
  std::vector<double> squared_mm2(among.size(), std::numeric_limits<double>::infinity());
  std::vector<Vector3d> chosen;
  std::size_t next = 0;
  while (chosen.size() < std::min(count, among.size())) {
    chosen.push_back(among[next]);
    for (std::size_t i = 0; i < among.size(); ++i) {
      squared_mm2[i] = std::min(squared_mm2[i], (among[i] - chosen.back()).squaredNorm());
    }
    next = static_cast<std::size_t>(std::max_element(squared_mm2.begin(), squared_mm2.end()) - squared_mm2.begin());
  }
  return chosen;
}

Recording::Recording(const ExampleScene& scene, const geometry::Surface& liver_lps, const fs::path& folder,
                     const ExampleSequenceOptions& options)
    : scene_(scene),
      folder_(folder),
      options_(options),
      random_(options.seed),
      hidden_mm_(spread(places_inside(liver_lps), hidden_places)) {
  // Features are found where the first frame shows the liver well.
  const ExampleScene::View first = scene.view(0);
  std::vector<Vector3d> seen_mm;
  for (int y = 12; y < ExampleScene::height - 12; y += 4) {
    for (int x = 12; x < ExampleScene::width - 12; x += 4) {
      if (first.depth_at(x, y)) seen_mm.push_back(first.rest_mm[static_cast<std::size_t>(x + ExampleScene::width * y)]);
    }
  }
  landmarks_mm_ = spread(seen_mm, static_cast<std::size_t>(options.landmarks));
  for (std::size_t k = 0; k < landmarks_mm_.size(); ++k) outlier_.push_back(uniform_(random_) < options.outlier_share);
  const auto box = geometry::bounding_box(seen_mm);
  const Vector3d wanted = box.center_mm() - Vector3d(0.22 * (box.max_mm - box.min_mm).x(), 0, 0);
  fault_.center_mm = *std::min_element(seen_mm.begin(), seen_mm.end(), [&](const Vector3d& a, const Vector3d& b) {
    return (a - wanted).head<2>().norm() < (b - wanted).head<2>().norm();
  });
  fault_.radius_mm = options.fault_radius_mm;
  fault_.largest_mm = options.fault_mm;
}

Result<void> Recording::add(int frame) {
  const ExampleScene::View view = scene_.view(frame);
  const std::string image = fmt::format("f{:03}.jpg", frame), cloud = fmt::format("f{:03}.ply", frame),
                    registered = fmt::format("r{:03}.ply", frame);
  if (auto written = vision::write_frame(view.picture, folder_ / image); !written) return written;
  if (options_.stereo) {
    const std::string name = fmt::format("f{:03}.png", frame);
    const vision::Frame right = scene_.view(frame, eyes_apart_mm).picture;
    if (auto written = vision::write_frame(view.picture, folder_ / "video" / "left" / name); !written) return written;
    if (auto written = vision::write_frame(right, folder_ / "video" / "right" / name); !written) return written;
  }
  std::vector<Vector3d> rest_mm;
  geometry::Surface seen = cloud_of(view, rest_mm);
  if (auto written = geometry::write_surface(folder_ / cloud, seen); !written) return written;
  for (std::size_t i = 0; i < rest_mm.size(); ++i) seen.points_mm[i] = rest_mm[i] + fault_.at(rest_mm[i], frame);
  if (auto written = geometry::write_surface(folder_ / registered, seen); !written) return written;
  sight_landmarks(view, frame);
  for (std::size_t k = 0; k < hidden_mm_.size(); ++k) {
    const Vector3d place = scene_.moved(scene_.pose() * hidden_mm_[k], frame);
    hidden_truth_ += fmt::format("hidden-{},{},{:.4f},{:.4f},{:.4f}\n", k + 1, frame, place.x(), place.y(), place.z());
  }
  frames_.push_back({{"image", image}, {"cloud", cloud}});
  registered_.push_back(registered);
  return {};
}

Result<void> Recording::begin_video() {
  for (const char* eye : {"left", "right"}) {
    std::error_code problem;
    fs::create_directories(folder_ / "video" / eye, problem);
    if (problem) {
      return failure("folder-not-made", GLISSON_TEXT("The folder {0} cannot be made: {1}."),
                     {(folder_ / "video" / eye).string(), problem.message()});
    }
  }
  vision::StereoCalibration calibration;
  calibration.left = calibration.right = scene_.camera();
  calibration.left_to_right.translation() = Vector3d(-eyes_apart_mm, 0, 0);
  calibration.width = ExampleScene::width;
  calibration.height = ExampleScene::height;
  calibration.simulated =
      GLISSON_TEXT("SIMULATED: a generated liver, breathing and pressed by a tool as a formula says.");
  return vision::write_stereo_calibration(folder_ / "video" / "camera.json", calibration);
}

// A point every few pixels, as stereo would have them; `rest_mm` says where each lies at rest.
geometry::Surface Recording::cloud_of(const ExampleScene::View& view, std::vector<Vector3d>& rest_mm) {
  constexpr double step_in_depth_mm = 8;  // across which no triangle goes
  const int columns = (ExampleScene::width - 1) / options_.step_px + 1;
  const int rows = (ExampleScene::height - 1) / options_.step_px + 1;
  const Eigen::Matrix3d to_ray = scene_.camera().matrix.inverse();
  std::vector<int> point_at(static_cast<std::size_t>(columns * rows), -1);
  geometry::Surface cloud;
  geometry::Field rest{"rest_mm", 3, {}};
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const int x = column * options_.step_px, y = row * options_.step_px;
      const auto depth_mm = view.depth_at(x, y);
      if (!depth_mm) continue;
      point_at[static_cast<std::size_t>(column + columns * row)] = static_cast<int>(cloud.points_mm.size());
      cloud.points_mm.push_back(to_ray * Vector3d(x, y, 1) * *depth_mm + jitter(options_.cloud_noise_mm));
      const Vector3d& at_rest = view.rest_mm[static_cast<std::size_t>(x + ExampleScene::width * y)];
      rest.values.insert(rest.values.end(), at_rest.begin(), at_rest.end());
    }
  }
  const auto depth_of = [&](int point) { return cloud.points_mm[static_cast<std::size_t>(point)].z(); };
  const auto join = [&](int a, int b, int c) {
    if (a < 0 || b < 0 || c < 0) return;
    const auto [near, far] = std::minmax({depth_of(a), depth_of(b), depth_of(c)});
    if (far - near < step_in_depth_mm) cloud.triangles.push_back({a, b, c});
  };
  for (int row = 0; row + 1 < rows; ++row) {
    for (int column = 0; column + 1 < columns; ++column) {
      const auto at = static_cast<std::size_t>(column + columns * row);
      const auto below = at + static_cast<std::size_t>(columns);
      // Counter-clockwise for whoever looks from the camera, whose y runs down.
      join(point_at[at], point_at[below], point_at[at + 1]);
      join(point_at[at + 1], point_at[below], point_at[below + 1]);
    }
  }
  cloud.point_fields.push_back(std::move(rest));
  cloud = geometry::largest_manifold_piece(cloud);
  const auto& kept = geometry::find_field(cloud.point_fields, "rest_mm")->values;
  for (std::size_t i = 0; i < kept.size(); i += 3) rest_mm.emplace_back(kept[i], kept[i + 1], kept[i + 2]);
  cloud.point_fields.clear();
  return cloud;
}

void Recording::sight_landmarks(const ExampleScene::View& view, int frame) {
  constexpr double hidden_mm = 2;  // behind what its pixel shows
  for (std::size_t k = 0; k < landmarks_mm_.size(); ++k) {
    const Vector3d place = scene_.moved(landmarks_mm_[k], frame);
    const auto pixel = vision::project(scene_.camera(), {place}).front();
    if (!pixel) continue;
    const auto depth_mm =
        view.depth_at(static_cast<int>(std::lround(pixel->x())), static_cast<int>(std::lround(pixel->y())));
    const bool lost = uniform_(random_) < options_.lost_share;
    Vector3d seen = place + jitter(options_.tracking_noise_mm);
    if (outlier_[k] && frame > options_.frames / 2)
      seen += Vector3d(14, 6, 0);  // followed another feature from then on
    if (lost || !depth_mm || place.z() - *depth_mm > hidden_mm) continue;
    tracks_ += fmt::format("g{},{},{:.4f},{:.4f},{:.4f}\n", k, frame, seen.x(), seen.y(), seen.z());
  }
}

Result<fs::path> Recording::finish() {
  if (auto written = write_text_file(folder_ / "tracks.csv", tracks_); !written) return failure(written.error());
  if (auto written = geometry::write_surface(folder_ / "model.ply", scene_.model()); !written) {
    return failure(written.error());
  }
  const auto list = [](const auto& vector) { return std::vector<double>(vector.begin(), vector.end()); };
  Json outliers = Json::array();
  for (std::size_t k = 0; k < outlier_.size(); ++k) {
    if (outlier_[k]) outliers.push_back(fmt::format("g{}", k));
  }
  std::string hidden = "id,x_mm,y_mm,z_mm\n";
  for (std::size_t k = 0; k < hidden_mm_.size(); ++k) {
    hidden +=
        fmt::format("hidden-{},{:.4f},{:.4f},{:.4f}\n", k + 1, hidden_mm_[k].x(), hidden_mm_[k].y(), hidden_mm_[k].z());
  }
  for (const auto& [name, text] : {std::pair("hidden.csv", &hidden), std::pair("hidden-truth.csv", &hidden_truth_)}) {
    if (auto written = write_text_file(folder_ / name, *text); !written) return failure(written.error());
  }
  Json pose = Json::array();
  for (int i = 0; i < 16; ++i) pose.push_back(scene_.pose().matrix()(i / 4, i % 4));
  if (auto written = write_json_file(folder_ / "truth.json", {{"patient_to_camera", pose},
                                                              {"fault_center_mm", list(fault_.center_mm)},
                                                              {"fault_radius_mm", fault_.radius_mm},
                                                              {"fault_largest_mm", fault_.largest_mm},
                                                              {"landmarks_that_jump", outliers}});
      !written) {
    return failure(written.error());
  }
  Json matrix = Json::array();
  for (Eigen::Index row = 0; row < 3; ++row) matrix.push_back(list(scene_.camera().matrix.row(row)));
  const fs::path file = folder_ / "sequence.json";
  auto written = write_json_file(
      file,
      {{"simulated", GLISSON_TEXT("SIMULATED: a generated liver, breathing and pressed by a tool as a formula says."
                                  " The registration called \"given\" is the true one with a "
                                  "fault put into it on the left of the picture.")},
       {"frames", frames_},
       {"landmarks", "tracks.csv"},
       {"model", "model.ply"},
       {"camera", {{"matrix", matrix}}},
       {"registered", registered_}});
  if (!written) return failure(written.error());
  return file;
}

}  // namespace
}  // namespace glisson::studies

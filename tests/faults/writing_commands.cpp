#include "faults/writing_commands.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <Eigen/Geometry>
#include <numbers>
#include <random>

#include "base/files.h"
#include "base/json.h"
#include "elastography/wave_phantom.h"
#include "geometry/mesh_file.h"
#include "imaging/dicom_uid.h"
#include "imaging/dicom_write.h"
#include "shapes/ellipsoids.h"
#include "shapes/model_file.h"
#include "support/dicom_files.h"
#include "support/process.h"
#include "support/small_liver.h"
#include "support/stereo_video.h"

namespace glisson::test {

namespace fs = std::filesystem;

namespace {

void write_sequence(const fs::path& folder) {
  Json document{{"frames", Json::array()},
                {"landmarks", "tracks.csv"},
                {"registered", Json::array()},
                {"camera", {{"matrix", {{90, 0, 60}, {0, 90, 45}, {0, 0, 1}}}, {"distortion", {0, 0, 0, 0, 0}}}}};
  const vision::Frame grey{120, 90, std::vector<std::uint8_t>(std::size_t{3} * 120 * 90, 90)};
  std::string tracks = "landmark,frame,x_mm,y_mm,z_mm\n";
  for (int t = 0; t < 8; ++t) {
    const double depth_mm = 60 + 5 * std::sin(t);
    std::string seen =
        "ply\nformat ascii 1.0\nelement vertex 9\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
    std::string registered = seen;
    for (int k = 0; k < 9; ++k) {
      const int x = 10 * (k % 3), y = 10 * (k / 3);
      seen += fmt::format("{} {} {}\n", x, y, depth_mm);
      registered += fmt::format("{} {} {}\n", x, y, k == 8 ? depth_mm : 60.0);
      tracks += fmt::format("g{},{},{},{},{}\n", k, t, x, y, depth_mm);
    }
    EXPECT_TRUE(write_text_file(folder / fmt::format("f{}.ply", t), seen));
    EXPECT_TRUE(write_text_file(folder / fmt::format("r{}.ply", t), registered));
    EXPECT_TRUE(vision::write_frame(grey, folder / fmt::format("f{}.png", t)));
    document["frames"].push_back({{"cloud", fmt::format("f{}.ply", t)}, {"image", fmt::format("f{}.png", t)}});
    document["registered"].push_back(fmt::format("r{}.ply", t));
  }
  EXPECT_TRUE(write_text_file(folder / "tracks.csv", tracks));
  EXPECT_TRUE(write_json_file(folder / "sequence.json", document));
}

// A portal and a hepatic tree, each a trunk that divides, as wide as voxels of 5 mm can show.
void write_vessels(const fs::path& room) {
  using Point = Eigen::Vector3d;
  struct Tube {
    Point from_mm, to_mm;
    double radius_mm;
  };
  const auto write = [&](const char* name, const std::vector<Tube>& tubes) {
    EXPECT_TRUE(write_text_file(room / name, nrrd("uint8", [&](double x, double y, double z) -> std::string {
                                  for (const Tube& tube : tubes) {
                                    const Point along = tube.to_mm - tube.from_mm, here = Point(x, y, z) - tube.from_mm;
                                    const double share = std::clamp(here.dot(along) / along.squaredNorm(), 0.0, 1.0);
                                    if ((here - share * along).norm() < tube.radius_mm) return "\1";
                                  }
                                  return {'\0'};
                                })));
  };
  write("portal.nrrd", {{{0, 5, -45}, {0, 5, -12}, 6}, {{0, 5, -12}, {-45, 5, -5}, 5}, {{0, 5, -12}, {45, 5, -5}, 5}});
  write("hepatic.nrrd",
        {{{0, -5, 48}, {0, -5, 25}, 7}, {{0, -5, 25}, {-40, -5, 12}, 5}, {{0, -5, 25}, {40, -5, 12}, 5}});
}

// A model of ellipsoids, and one of them without its dome.
void write_shapes(const fs::path& room) {
  EXPECT_TRUE(shapes::write_model(room / "shapes.vtp", shapes::honest_model(ellipsoids(12)).value()));
  geometry::Surface cut = ellipsoid({1, 0, -1});
  std::erase_if(cut.triangles, [&](const std::array<int, 3>& triangle) {
    return std::any_of(triangle.begin(), triangle.end(),
                       [&](int p) { return cut.points_mm[static_cast<std::size_t>(p)].z() > 25; });
  });
  EXPECT_TRUE(geometry::write_surface(room / "cut_off.vtp", cut));
}

// Six pairs of a surface that breathes, with spots to follow.
void write_stereo_video(const fs::path& room) {
  vision::Frame texture{320, 240, std::vector<std::uint8_t>(std::size_t{3} * 320 * 240)};
  std::mt19937 random(5);
  std::array<std::array<double, 66>, 50> grey{};
  for (auto& row : grey) {
    for (double& value : row) value = 60 + static_cast<double>(random() % 160);
  }
  for (int y = 0; y < texture.height; ++y) {
    for (int x = 0; x < texture.width; ++x) {
      const double right = x % 5 / 5.0, down = y % 5 / 5.0;
      const auto row = [&](int j) { return (1 - right) * grey[j][x / 5] + right * grey[j][x / 5 + 1]; };
      const double value = (1 - down) * row(y / 5) + down * row(y / 5 + 1);
      std::fill_n(texture.at(x, y), 3, static_cast<std::uint8_t>(value));
    }
  }
  const StereoVideo video(texture);
  for (const char* eye : {"left", "right"}) fs::create_directories(room / eye);
  for (int t = 0; t < 6; ++t) {
    const std::string name = std::to_string(t) + ".png";
    EXPECT_TRUE(vision::write_frame(video.left(t), room / "left" / name));
    EXPECT_TRUE(vision::write_frame(video.right(t), room / "right" / name));
  }
  EXPECT_TRUE(vision::write_stereo_calibration(room / "camera.json", StereoVideo::calibration()));
}

// A chessboard of 8 x 6 fields of 10 mm, as an eye sees it that looks along z from `eye_x_mm`.
vision::Frame board_seen(const Eigen::Isometry3d& pose, double eye_x_mm) {
  vision::Frame frame{320, 240, std::vector<std::uint8_t>(std::size_t{3} * 320 * 240)};
  constexpr int finer = 4;
  const Eigen::Vector3d eye_mm(eye_x_mm, 0, 0), normal = pose.linear().col(2);
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      int white = 0;
      for (int s = 0; s < finer * finer; ++s) {
        const double u = x + (s % finer + 0.5) / finer - 0.5, v = y + (s / finer + 0.5) / finer - 0.5;
        const Eigen::Vector3d ray((u - 160) / 300, (v - 120) / 300, 1);
        const double far = normal.dot(pose.translation() - eye_mm) / normal.dot(ray);
        const Eigen::Vector3d on_board_mm = pose.inverse() * Eigen::Vector3d(eye_mm + far * ray);
        const double column = on_board_mm.x() / 10 + 4, row = on_board_mm.y() / 10 + 3;
        const bool outside = column < 0 || column >= 8 || row < 0 || row >= 6;
        white += outside || (static_cast<int>(column) + static_cast<int>(row)) % 2 == 1 ? 1 : 0;
      }
      std::fill_n(frame.at(x, y), 3, static_cast<std::uint8_t>(20 + 220 * white / (finer * finer)));
    }
  }
  return frame;
}

// Four views of it, by eyes 5 mm apart.
void write_boards(const fs::path& folder) {
  for (int n = 0; n < 4; ++n) {
    const Eigen::Isometry3d pose = Eigen::Translation3d(4 * n - 6, 3 - 2 * n, 150 + 10 * n) *
                                   Eigen::AngleAxisd(n % 2 == 0 ? 0.35 : -0.35, Eigen::Vector3d::UnitX()) *
                                   Eigen::AngleAxisd(n < 2 ? 0.3 : -0.3, Eigen::Vector3d::UnitY());
    for (const auto& [eye, x_mm] : {std::pair{"left", 0.0}, std::pair{"right", 5.0}}) {
      fs::create_directories(folder / eye);
      EXPECT_TRUE(vision::write_frame(board_seen(pose, x_mm), folder / eye / (std::to_string(n) + ".png")));
    }
  }
}

constexpr int wave_directions = 3;
std::string wave_series(int direction) { return imaging::uid_from_name("waves, " + std::to_string(direction)); }

// Shear waves of 60 Hz in three directions at four instants, and what they were measured in.
void write_waves(const fs::path& folder) {
  constexpr int instants = 4;
  elastography::WavePhantom phantom;
  phantom.grid = elastography::cube_grid(24, 5, 2, 4);
  phantom.background_kPa = {4, 0.3};
  const elastography::WaveImages images = measured(phantom, crossing_waves(phantom), 1.0, 0.02, instants);
  const auto series = [](const std::string& name, const std::string& image_type, int number) {
    imaging::SeriesDescription described;
    described.study_uid = imaging::uid_from_name("waves");
    described.series_uid = wave_series(number);
    described.frame_of_reference_uid = imaging::uid_from_name("waves, frame");
    described.series_number = number;
    described.series_description = name;
    described.image_type = image_type;
    return described;
  };
  const imaging::Volume anatomy{{images.grid, std::vector<float>(images.grid.voxels(), 300)}, ""};
  EXPECT_TRUE(imaging::write_dicom_series(folder / "anatomy", anatomy, series("T1 axial", "ORIGINAL\\PRIMARY\\M", 9)));
  for (int d = 0; d < wave_directions; ++d) {
    auto described = series("MRE phase 60 Hz", "ORIGINAL\\PRIMARY\\P\\MRE", d);
    described.rescale_type = "rad";
    described.rescale_slope = 1e-4;
    for (int t = 0; t < instants; ++t) {
      described.temporal_position = {t + 1, instants, 1000.0 / 60 * t / instants};
      const auto& phase_rad = images.phase_rad[static_cast<std::size_t>(d)][static_cast<std::size_t>(t)];
      EXPECT_TRUE(
          imaging::write_dicom_series(folder / std::to_string(d), {{images.grid, phase_rad}, "rad"}, described));
    }
  }
}

// The top of the phantom of section 4.5, as a scanner might see it at rest and hardly pressed.
void write_scans(const fs::path& folder) {
  geometry::Surface top;
  top.points_mm.emplace_back(0, 0, 26);
  constexpr int rings = 12, around = 36;
  for (int r = 1; r <= rings; ++r) {
    for (int k = 0; k < around; ++k) {
      const double angle = 2 * std::numbers::pi * k / around, radius_mm = 112.5 * r / rings;
      top.points_mm.emplace_back(radius_mm * std::cos(angle), radius_mm * std::sin(angle), 26);
      const int next = (k + 1) % around, inner = 1 + (r - 2) * around, outer = 1 + (r - 1) * around;
      if (r == 1) {
        top.triangles.push_back({0, outer + k, outer + next});
      } else {
        top.triangles.push_back({inner + k, outer + k, outer + next});
        top.triangles.push_back({inner + k, outer + next, inner + next});
      }
    }
  }
  for (const char* name : {"B-rest.ply", "B-0.78N.ply"}) EXPECT_TRUE(geometry::write_surface(folder / name, top));
}

}  // namespace

void prepare_room(const fs::path& room) {
  const auto run = [&](std::vector<std::string> words) {
    for (std::string& word : words) {
      if (word.starts_with("@")) word = (room / word.substr(1)).string();
    }
    words.push_back("--quiet");
    const Finished finished = glisson_cli(words);
    ASSERT_EQ(finished.exit_code, 0) << words.front() << ": " << finished.err;
  };
  const auto write = [&](const char* name, const std::string& text) {
    EXPECT_TRUE(write_text_file(room / name, text));
  };
  EXPECT_TRUE(write_small_liver(room));
  save_stack(room / "study", 3);
  write_vessels(room);
  write_stereo_video(room);
  write_shapes(room);
  write_boards(room / "board");
  write_waves(room / "waves");
  write_scans(room / "scans");
  write("history.csv", "case,seconds,dice\na,30,0.9\nb,30,0.8\na,30,0.7\nb,30,0.8\n");
  for (const char* file : {"scan.nrrd", "liver.nrrd"}) {
    write((std::string("labelled/") + file).c_str(), read_text_file(room / file).value());
  }
  write("pull.json", R"({"loads": [{"tool": {"center_mm": [0, -50, 0], "radius_mm": 15, "force_N": [0, -0.5, 0]}}]})");
  write("push.json", R"({"loads": [{"tool": {"center_mm": [0, -50, 0], "radius_mm": 15, "force_N": [0, 0.1, 0]}}]})");
  write("hook.json", R"({"format": "glisson-session/1", "commands": [{"hold": {"id": "hook",
      "shape": "nathanson-retractor", "position_mm": [0, 0, -70], "direction": [0, 0, 1], "push_mN": 200}}]})");
  write("right.json", R"({"name": "right", "plane": {"point_mm": [-10, 0, 0], "normal": [1, 0, 0]}})");
  write("wedge.json", R"({"name": "wedge", "around": "tumour-1", "margin_mm": 8})");
  write("targets.csv", "id,x_mm,y_mm,z_mm\nmiddle,10,0,0\n");
  write("guidance.json", R"({"format": "glisson-guidance/1", "targets": "targets.csv",
      "model": {"mesh": "liver.vtu", "youngs_modulus_kPa": 6, "poisson_ratio": 0.45},
      "frames": [{"id": "f0", "points": "moved.ply", "noise_mm": 1,
                  "pose_guess": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]}]})");
  write("edge.csv", "x_mm,y_mm,z_mm\n-40,-38,0\n0,-50,0\n40,-38,0\n");
  write("seen.csv", "x_px,y_px\n100,120\n160,118\n220,121\n");
  write("contours.json", R"({"format": "glisson-contours/1", "model": {"surface": "stl/liver.stl"},
      "camera": {"matrix": [[400, 0, 160], [0, 400, 120], [0, 0, 1]]}, "features": [{"id": "edge", "points": "edge.csv"}],
      "frames": [{"id": "f0", "pose_guess": [1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 250, 0, 0, 0, 1],
                  "contours": [{"id": "edge", "pixels": "seen.csv"}]}]})");
  write("version-1/metrics.csv", "case,tre_mm\na,1\nb,2\n");
  write("version-2/metrics.csv", "case,tre_mm\na,1\nb,2.1\n");
  write("loose.json", R"({"metrics": {"tre_mm": {"percent": 20}}})");
  write("model.json", R"({"format": "glisson-closedloop-model/1", "kind": "palpation", "verdict": "explained",
      "effects": [{"kind": "stiffness-scale", "parameters": {"factor": 0.5}}]})");
  write("device.json", R"({"format": "glisson-closedloop-model/1", "kind": "platform", "verdict": "explained",
      "learnt_from": "tx2.json", "effects": [{"kind": "static-power", "parameters": {"static_W": 1.17}}]})");
  std::string rows = "Time,Stretch,Stress\n";
  for (int n = 0; n <= 20; ++n) rows += fmt::format("{},{},{}\n", n, 1 + 0.01 * n, 0.132 * n);
  write("a1.csv", rows);
  write("material.json", R"({"format": "glisson-experiment/1", "kind": "material", "mode": "tension",
      "declared": {"law": "linear", "youngs_modulus_kPa": 13.2}, "noise_kPa": 0.05, "trials": [{"id": "a1",
      "file": "a1.csv", "columns": {"time_s": "Time", "stretch": "Stretch", "stress_kPa": "Stress"}}]})");
  run({"import", "@scan.nrrd", "--case", "@small.glisson"});
  run({"segment", "@small.glisson", "--structure", "liver", "--labels", "@liver.nrrd"});
  run({"segment", "@small.glisson", "--structure", "tumour-1", "--labels", "@tumour.nrrd"});
  run({"segment", "@small.glisson", "--structure", "portal-vein", "--labels", "@portal.nrrd"});
  run({"segment", "@small.glisson", "--structure", "hepatic-vein", "--labels", "@hepatic.nrrd"});
  run({"vessels", "@small.glisson"});
  run({"mesh", "@small.glisson", "--target-cells", "600"});
  run({"stiffness", "@small.glisson", "--uniform-kPa", "6"});
  run({"simulate", "@small.glisson", "--scenario", "@push.json", "--out", "@result"});
  run({"export", "@small.glisson", "--format", "stl", "--out", "@stl"});
  run({"export", "@small.glisson", "--format", "vtu", "--out", "@liver.vtu"});
  run({"resect", "@small.glisson", "--plane=-20,0,0,1,0,0", "--out", "@resection"});
  run({"plan", "@small.glisson", "--add", "@wedge.json"});
  fs::create_directories(room / "video");
  write_sequence(room / "video");
  run({"sirgn", "@video/sequence.json", "--method", "given", "--out", "@quality"});
  run({"register", "@stl/liver.stl", "@stl/liver.stl", "--method", "icp", "--out", "@moved.ply"});
  run({"study", "anatomy", "--seed", "7", "--tumour", "20", "--label-spacing-mm", "8", "--out", "@patient"});
  fs::copy(room / "small.glisson", room / "before.glisson", fs::copy_options::recursive);
  run({"territories", "@before.glisson", "--from", "prior"});
  fs::copy(room / "before.glisson", room / "after.glisson", fs::copy_options::recursive);
  std::vector<std::string> waves{"import", "@waves", "--case", "@waves.glisson"};
  for (int d = 0; d < wave_directions; ++d) waves.insert(waves.end(), {"--phase", wave_series(d)});
  run(waves);
  run({"study", "example-sequence", "--frames", "3", "--out", "@seen-liver"});
  fs::create_directories(room / "livers");
  fs::copy_file(room / "patient" / "labels" / "liver.nrrd", room / "livers" / "p_liver.nrrd");
}

std::vector<WritingCommand> writing_commands() {
  std::vector<WritingCommand> all{
      {"import", {"import", "@scan.nrrd", "--case", "@new.glisson"}},
      {"import-dicom", {"import", "@study", "--case", "@new.glisson"}},
      {"import-add", {"import", "@study", "--case", "@small.glisson", "--add", "--replace"}},
      {"import-labels",
       {"import", "@labelled", "--labels", "@labelled/liver.nrrd", "--label-value", "1=liver", "--case",
        "@new.glisson"}},
      {"invert", {"invert", "@waves.glisson"}},
      {"segment", {"segment", "@small.glisson", "--structure", "kidney-right", "--seed", "0,0,0"}},
      {"segment-again", {"segment", "@small.glisson", "--structure", "liver", "--labels", "@tumour.nrrd"}},
      {"vessels", {"vessels", "@small.glisson", "--seed", "0,5,-12"}},
      {"territories", {"territories", "@small.glisson", "--from", "prior"}},
      {"mesh", {"mesh", "@small.glisson", "--target-cells", "400"}},
      {"stiffness", {"stiffness", "@small.glisson", "--uniform-kPa", "9"}},
      {"simulate", {"simulate", "@small.glisson", "--scenario", "@pull.json", "--out", "@pulled"}},
      {"simulate-again", {"simulate", "@small.glisson", "--scenario", "@pull.json", "--out", "@result"}, false, true},
      {"resect", {"resect", "@small.glisson", "--plane=-10,0,0,1,0,0", "--out", "@cut"}},
      {"resect-again", {"resect", "@small.glisson", "--plane=-10,0,0,1,0,0", "--out", "@resection"}, false, true},
      {"plan-add", {"plan", "@small.glisson", "--add", "@right.json"}},
      {"plan-drop", {"plan", "@small.glisson", "--drop", "wedge"}},
      {"plan-compare", {"plan", "@small.glisson", "--compare", "--out", "@plans"}},
      {"session-orders", {"session", "@small.glisson", "--commands", "@hook.json", "@hook.json", "--out", "@orders"}},
      {"session-folder", {"session", "@small.glisson", "--commands", "@hook.json", "--out", "@rehearsed"}},
      {"session", {"session", "@small.glisson", "--commands", "@hook.json", "--out", "@recorded.json"}},
      {"accept", {"accept", "@small.glisson", "@model.json", "--of-this-patient"}},
      {"register", {"register", "@stl/liver.stl", "@stl/tumour-1.stl", "--method", "icp", "--out", "@moved.ply"}},
      {"guide", {"guide", "@guidance.json", "--out", "@guided"}},
      {"guide-contours", {"guide", "@contours.json", "--out", "@posed"}},
      {"guide-case",
       {"guide", "@small.glisson", "--sequence", "@seen-liver/sequence.json",
        "--pose=1,0,0,0,0,1,0,0,0,0,1,150,0,0,0,1", "--out", "@placed"}},
      {"growth", {"growth", "@before.glisson", "@after.glisson", "--same-patient", "--days", "30", "--out", "@grown"}},
      {"calibrate",
       {"calibrate", "--left", "@board/left", "--right", "@board/right", "--board", "chessboard", "--columns", "7",
        "--rows", "5", "--spacing-mm", "10", "--out", "@calibrated.json"}},
      {"stereo",
       {"stereo", "@left/0.png", "@right/0.png", "--calibration", "@camera.json", "--step", "8", "--out", "@seen.ply"}},
      {"sequence", {"sequence", "@left", "@right", "--calibration", "@camera.json", "--step", "8", "--out", "@filmed"}},
      {"match", {"match", "@stl/liver.stl", "@stl/liver.stl", "--points", "20", "--out", "@matches.csv"}},
      {"report", {"report", "@small.glisson", "--out", "@page.html"}},
      {"render", {"render", "@small.glisson", "--scene", "liver", "--size", "120x90", "--out", "@organ.png"}},
      {"deidentify", {"deidentify", "@study", "--key", "key", "--out", "@nameless"}},
      {"sirgn", {"sirgn", "@video/sequence.json", "--method", "given", "--pictures", "--out", "@judged"}},
      {"sirgn-again",
       {"sirgn", "@video/sequence.json", "--method", "given", "--tolerance-mm", "3", "--out", "@quality"},
       false,
       true},
      {"review", {"review", "@quality", "@quality", "--out", "@reviewed"}},
      {"gate", {"gate", "@version-1", "@version-2", "--tolerances", "@loose.json", "--out", "@gated"}},
      {"gate-cases", {"gate-cases", "@history.csv", "--budget", "0.6", "--out", "@chosen.txt"}},
      {"explain", {"explain", "@material.json", "--out", "@explained"}},
      {"predict", {"predict", "@material.json", "--values", "@predicted.csv"}},
      {"platform-measure",
       {"platform", "measure", "--seconds-per-point", "0.001", "--largest-MB", "1", "--out", "@mine.json"}},
      {"platform-grid", {"platform", "grid", "--device", "tx2-gpu", "--out", "@grid.html"}},
      {"platform-learn", {"platform", "learn", "--device", "tx2-gpu", "--model", "@device.json", "--out", "@tx2.json"}},
      {"study-anatomy", {"study", "anatomy", "--seed", "3", "--label-spacing-mm", "8", "--out", "@another"}},
      {"study-anatomy-again",
       {"study", "anatomy", "--seed", "3", "--label-spacing-mm", "8", "--out", "@patient"},
       false,
       true},
      {"study-sequence", {"study", "example-sequence", "--frames", "3", "--out", "@example"}},
      {"study-shapes",
       {"study", "shapes", "@livers", "--only", "p", "--reference-spacing-mm", "20", "--out", "@shapes"},
       true},
      {"shapes-complete", {"shapes", "complete", "@shapes.vtp", "@cut_off.vtp", "--out", "@whole.vtp"}},
      {"shapes-draw",
       {"shapes", "draw", "@shapes.vtp", "--count", "1", "--target-cells", "400", "--vessels", "none", "--out",
        "@drawn"},
       true},
      {"study-stiffness", {"study", "validate-stiffness", "--out", "@validation"}},
      {"study-cohort", {"study", "cohort", "--simulated", "2", "--out", "@cohort"}, true},
      {"study-chunk", {"study", "cohort", "--simulated", "2", "--out", "@cohort", "--chunk", "2/2"}, true},
      {"study-landmarks",
       {"study", "landmarks", "--simulated", "1", "--target-cells", "500", "--out", "@misplaced"},
       true},
      {"study-convergence",
       {"study", "convergence", "--resolutions", "2", "--finest-mm3", "40", "--out", "@converged"}},
      {"study-data-driven",
       {"study", "data-driven", "--measurements", "21", "--noise-percent", "0", "--target-cells", "400", "--out",
        "@data-driven"}},
      {"study-matching",
       {"study", "matching", "--points", "20", "--starts", "0", "--livers", "1", "--passes", "2", "--seconds-a-timing",
        "0", "--out", "@matching"},
       true},
      {"study-palpation", {"study", "palpation", "--scans", "@scans", "--out", "@palpation"}, true},
      {"study-beams", {"study", "beams", "@small.glisson", "--nodes", "60", "--out", "@beams"}},
  };
  for (const char* format : {"nrrd", "nifti", "stl", "obj", "vtp", "sofa"}) {
    all.push_back({std::string("export-") + format,
                   {"export", "@small.glisson", "--format", format, "--out", std::string("@exported-") + format}});
  }
  all.push_back({"export-seg", {"export", "@small.glisson", "--format", "dicom-seg", "--out", "@seg.dcm"}});
  all.push_back(
      {"export-plan", {"export", "@small.glisson", "--format", "dicom-seg", "--plan", "wedge", "--out", "@plan.dcm"}});
  all.push_back({"export-vtu", {"export", "@small.glisson", "--format", "vtu", "--out", "@model.vtu"}});
  return all;
}

}  // namespace glisson::test

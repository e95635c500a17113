#include "faults/writing_commands.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "base/files.h"
#include "base/json.h"
#include "geometry/mesh_file.h"
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
  fs::create_directories(room / "livers");
  fs::copy_file(room / "patient" / "labels" / "liver.nrrd", room / "livers" / "p_liver.nrrd");
}

std::vector<WritingCommand> writing_commands() {
  std::vector<WritingCommand> all{
      {"import", {"import", "@scan.nrrd", "--case", "@new.glisson"}},
      {"import-dicom", {"import", "@study", "--case", "@new.glisson"}},
      {"import-add", {"import", "@study", "--case", "@small.glisson", "--add", "--replace"}},
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
      {"explain", {"explain", "@material.json", "--out", "@explained"}},
      {"predict", {"predict", "@material.json", "--values", "@predicted.csv"}},
      {"platform-measure",
       {"platform", "measure", "--seconds-per-point", "0.001", "--largest-MB", "1", "--out", "@mine.json"}},
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
       {"shapes", "draw", "@shapes.vtp", "--count", "1", "--target-cells", "400", "--out", "@drawn"},
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
      {"study-beams", {"study", "beams", "@small.glisson", "--nodes", "60", "--out", "@beams"}},
  };
  for (const char* format : {"nrrd", "nifti", "stl", "obj", "vtp"}) {
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

// Documents and tables that people write by hand or with a script: JSON in our formats, and CSV. Seeds
// are what ships, and short documents of each format.

#include <cmath>
#include <numbers>

#include "base/csv.h"
#include "base/files.h"
#include "closedloop/experiment/experiment.h"
#include "closedloop/explain.h"
#include "fuzz/reader_target.h"
#include "geometry/mesh_file.h"
#include "guidance/contour_file.h"
#include "guidance/guidance_file.h"
#include "hardware/convergence_curve.h"
#include "hardware/device_file.h"
#include "imaging/volume_file.h"
#include "mechanics/scenario/scenario_file.h"
#include "registration_quality/sequence_file.h"
#include "rehearsal/session.h"
#include "support/folders.h"
#include "support/shapes.h"
#include "vision/calibration.h"

namespace glisson::fuzz {
namespace {

namespace fs = std::filesystem;

std::string shipped(const char* file) { return read_text_file(test::source_folder() / "resources" / file).value(); }

const char* const scenario = R"({"engine": "fem", "material": "neo-hookean", "poisson_ratio": 0.45,
 "youngs_modulus_kPa": 5.0, "supports": [{"point_array": "fixed"}, {"sphere": {"center_mm": [0, 1, 2], "radius_mm": 5},
 "foundation_kPa_per_mm": 1.1}, {"box": {"min_mm": [0, 0, 0], "max_mm": [1, 2, 3]}, "directions": ["x", "y"]}],
 "loads": [{"tool": {"center_mm": [1, 2, 3], "radius_mm": 8, "force_N": [0, 0, 1.5]}}, {"pressure_kPa": 1.6},
 {"gravity_m_s2": [0, 9.81, 0]}], "motion": {"step_s": 0.02, "steps": 5, "mass_damping_per_s": 0.1,
 "stiffness_damping_s": 0.01}, "landmarks": [{"id": "tumour-1", "position_mm": [4, 5, 6]}]})";

const char* const recording = R"({"format": "glisson-session/1", "commands": [
 {"hold": {"id": "hook", "shape": "nathanson-retractor", "position_mm": [0, 0, -70], "direction": [0, 0, 1],
 "push_mN": 200}}, {"release": "hook"}, {"undo": true}]})";

const char* const sequence = R"({"frames": [{"image": "f0.png", "cloud": "f0.ply"}, {"cloud": "f0.ply"}],
 "landmarks": "tracks.csv", "model": "f0.ply", "camera": {"matrix": [[500, 0, 320], [0, 500, 240], [0, 0, 1]],
 "distortion": [0.1, 0, 0, 0]}, "simulated": "by hand"})";

const char* const stereo = R"({"left": {"matrix": [[500, 0, 320], [0, 500, 240], [0, 0, 1]], "distortion": [0.1, 0]},
 "right": {"matrix": [[500, 0, 320], [0, 500, 240], [0, 0, 1]], "distortion": []},
 "left_to_right": [[1, 0, 0, -5], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]})";

const char* const guided = R"({"format": "glisson-guidance/1", "title": "a box", "model": {"mesh": "box.vtu",
 "youngs_modulus_kPa": 5.0, "poisson_ratio": 0.45}, "gravity_m_s2": [0, 9.8, 0],
 "features": [{"id": "edge", "points": "edge.csv"}], "frames": [{"id": "f0", "points": "f0.ply", "noise_mm": 0.5,
 "pose_guess": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1], "features": [{"id": "edge", "points": "edge.csv",
 "noise_mm": 1}], "tools": [{"id": "t", "contact_mm": [1, 2, 3], "radius_mm": 4, "force_N": [0, 0, 1]}]}],
 "targets": "targets.csv"})";

const char* const contours = R"({"format": "glisson-contours/1", "title": "a ball", "model": {"surface": "f0.ply"},
 "camera": {"matrix": [[500, 0, 320], [0, 500, 240], [0, 0, 1]], "distortion": [-0.2, 0.3, 0, 0, -0.2]},
 "features": [{"id": "edge", "points": "edge.csv"}], "frames": [{"id": "f0",
 "pose_guess": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 90, 0, 0, 0, 1], "contours": [{"id": "edge", "pixels": "f0_edge.csv"},
 {"id": "silhouette", "pixels": "f0_edge.csv"}]}], "targets": "targets.csv"})";

const char* const plate = R"({"format": "glisson-experiment/1", "kind": "full-field", "title": "a square",
 "specimen": {"mesh": "square.vtp", "thickness": 1, "state": "plane-strain"}, "boundaries": {"grip": {"side": "top",
 "prescribed": ["y"]}}, "declared": {"law": "neo-hookean", "C10": 0.5, "D": 1.5}, "noise": 1e-4, "noise_reaction": 1e-3,
 "trials": [{"id": "l1", "displacement": "l1.csv", "reactions": "r1.csv", "prescribed": {"top": {"ux": 0, "uy": 0.1}}}]})";

void files_of_a_plate(const fs::path& folder) {
  const geometry::Surface square{
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}, {{"group_x", 1, {1, 2, 2, 1}}}, {}};
  promise(bool(geometry::write_surface(folder / "square.vtp", square)), "the square is written");
  file_of("point,ux,uy\n0,0,0\n1,0.1,0\n2,0.1,0.1\n3,0,0.1\n", folder, "l1.csv");
  file_of("boundary,fx,fy\n2,1.5,\nleft,-1.5,\ntop,,0.7\n", folder, "r1.csv");
}

const char* const waves = R"({"format": "glisson-experiment/1", "kind": "elastography", "title": "a block",
 "declared": {"law": "kelvin-voigt", "shear_modulus_kPa": 3, "viscosity_Pa_s": 1.5, "density_kg_m3": 1000,
 "pressure": "none"}, "noise": 0.01, "region": "mask.nrrd", "patch_radius_mm": 6, "trials": [{"id": "60 Hz",
 "frequency_Hz": 60, "noise": 0.02, "components": {"x": {"real": "real.nrrd", "imaginary": "imaginary.nrrd"}}},
 {"id": "80 Hz", "frequency_Hz": 80, "components": {"x": {"real": "imaginary.nrrd", "imaginary": "real.nrrd"}}}]})";

const char* const springpot = R"({"format": "glisson-experiment/1", "kind": "elastography", "declared": {
 "law": "springpot", "shear_modulus_kPa": 3, "exponent": 0.3, "reference_Hz": 60, "pressure": "free"}, "noise": 0.01,
 "trials": [{"id": "a", "frequency_Hz": 60, "components": {"x": {"real": "real.nrrd", "imaginary": "imaginary.nrrd"},
 "y": {"real": "real.nrrd", "imaginary": "imaginary.nrrd"}, "z": {"real": "real.nrrd", "imaginary": "imaginary.nrrd"}}}]})";

// A wave of 30 mm along x in a block of 16 x 8 x 8 voxels.
void files_of_waves(const fs::path& folder) {
  imaging::Volume real;
  real.grid.size = {16, 8, 8};
  real.grid.spacing_mm.setConstant(2);
  imaging::Volume imaginary = real, mask = real;
  for (std::size_t v = 0; v < real.grid.voxels(); ++v) {
    const double phase = 2 * std::numbers::pi * 2 * static_cast<double>(v % 16) / 30;
    real.values.push_back(static_cast<float>(std::cos(phase)));
    imaginary.values.push_back(static_cast<float>(-std::sin(phase)));
    mask.values.push_back(v % 16 < 15 ? 1 : 0);
  }
  for (const auto& [name, image] :
       {std::pair("real.nrrd", &real), std::pair("imaginary.nrrd", &imaginary), std::pair("mask.nrrd", &mask)})
    promise(bool(imaging::write_volume_file(folder / name, *image)), "an image is written");
}

// What is read is asked as `explain` asks it: the declared law over what it holds.
Result<Eigen::VectorXd> declared_law_over(const fs::path& file) {
  const auto experiment = closedloop::read_experiment(file);
  if (!experiment) return failure(experiment.error());
  const auto model = closedloop::forward_model(*experiment);
  if (!model) return failure(model.error());
  return (*model)->predict({});
}

void files_of_a_sequence(const fs::path& folder) {
  promise(bool(geometry::write_surface(folder / "f0.ply", test::sphere_surface(10, 1))), "the model is written");
  file_of("landmark,frame,x_mm,y_mm,z_mm\n1,0,1,2,3\n1,1,1,2,3.5\n", folder, "tracks.csv");
}

void curves_of_the_example(const fs::path& folder) {
  for (const auto& entry : fs::directory_iterator(test::source_folder() / "resources/examples/tissue")) {
    if (entry.path().extension() == ".csv") fs::copy_file(entry.path(), folder / entry.path().filename());
  }
}

void files_of_a_guidance(const fs::path& folder) {
  files_of_a_sequence(folder);
  promise(bool(geometry::write_tetrahedra(folder / "box.vtu", test::box_of_tetrahedra({2, 1, 1}, {20, 10, 10}))),
          "the mesh is written");
  file_of("x_mm,y_mm,z_mm\n0,0,0\n5,0,0\n10,0,0\n", folder, "edge.csv");
  file_of("id,x_mm,y_mm,z_mm\nt1,5,5,5\n", folder, "targets.csv");
}

void files_of_contours(const fs::path& folder) {
  files_of_a_guidance(folder);
  file_of("x_px,y_px\n300,200\n310,205\n320,207\n", folder, "f0_edge.csv");
}

}  // namespace

std::vector<Target> targets() {
  return {
      reader_of("csv", "t.csv", {"time_s,force_N\n0,1\n0.5,1.5\n", "1;2;3\r\n4;5;6\r\n", "a\tb\n1\t\n,2\n"},
                [](const fs::path& file) { return read_csv(file); }),
      reader_of("scenario", "s.json", {scenario}, [](const fs::path& file) { return mechanics::read_scenario(file); }),
      reader_of("recording", "r.json", {recording},
                [](const fs::path& file) {
                  return read_text_file(file).and_then(
                      [](const std::string& text) { return rehearsal::parse_recording(text); });
                }),
      reader_of(
          "sequence", "sequence.json", {sequence},
          [](const fs::path& file) { return registration_quality::read_sequence(file); }, files_of_a_sequence),
      reader_of("calibration", "c.json", {stereo},
                [](const fs::path& file) { return vision::read_stereo_calibration(file); }),
      reader_of("devices", "d.json", {shipped("devices/devices.json")},
                [](const fs::path& file) { return hardware::read_devices(file); }),
      reader_of("convergence", "c.json", {shipped("devices/convergence.json")},
                [](const fs::path& file) { return hardware::read_convergence_curve(file); }),
      reader_of(
          "experiment", "e.json", {shipped("examples/tissue/experiment.json")},
          [](const fs::path& file) { return closedloop::read_experiment(file); }, curves_of_the_example),
      reader_of(
          "full-field", "e.json", {plate}, [](const fs::path& file) { return closedloop::read_experiment(file); },
          files_of_a_plate),
      reader_of("elastography", "e.json", {waves, springpot}, declared_law_over, files_of_waves),
      reader_of(
          "guidance", "guidance.json", {guided}, [](const fs::path& file) { return guidance::read_guidance(file); },
          files_of_a_guidance),
      reader_of(
          "contours", "contours.json", {contours},
          [](const fs::path& file) {
            return guidance::read_contours(file).and_then(
                [](const guidance::ContourCase& asked) { return guidance::answer(asked); });
          },
          files_of_contours),
  };
}

}  // namespace glisson::fuzz

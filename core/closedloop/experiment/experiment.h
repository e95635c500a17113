#pragma once
// What was done to a specimen and what was measured: the six sorts of experiment, as plain values. They are in the
// units of base/units.h (mm, mN, kPa, kg, s). Platforms have V, A, W, Wh and degrees Celsius besides. Read from JSON of
// the format "glisson-experiment/1", which speaks N and kg/m3, and from the tables that it names.

#include <array>
#include <complex>
#include <cstdint>
#include <Eigen/Core>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/result.h"
#include "base/tissue.h"
#include "geometry/tetrahedra.h"
#include "imaging/image.h"
#include "mechanics/scenario/scenario.h"

namespace glisson::closedloop {

// --- palpation: a specimen with markers, pressed by a tool

struct Marker {
  std::string id;
  Eigen::Vector3d rest_mm;
  Eigen::Vector3d position_mm;  // where it was seen
};

struct PalpationSample {
  double time_s = 0;
  double force_mN = 0;          // what the load cell read, along the tool's direction
  std::vector<Marker> markers;  // empty: the sample only shapes the history of the load
};

struct PalpationTool {
  Eigen::Vector3d center_mm{0, 0, 0};
  double radius_mm = 0;
  Eigen::Vector3d direction{0, 0, -1};  // of length 1
};

struct PalpationTrial {
  std::string id;
  PalpationTool tool;
  std::vector<PalpationSample> samples;  // by time; the first says what the untouched load cell read
};

struct Palpation {
  geometry::TetMesh mesh;              // at rest; has passed check_tetrahedra
  std::vector<double> cell_young_kPa;  // the declared modulus, one a cell
  double poisson_ratio = usual_poisson_ratio;
  double density_kg_mm3 = 1e-6;
  std::vector<mechanics::Support> supports;
  Eigen::Vector3d gravity_mm_s2{0, 0, 0};
  double noise_mm = 0;  // standard deviation of each coordinate
  std::vector<PalpationTrial> trials;
};

// --- material: nominal stress against stretch and time

enum class Mode { compression, tension, shear };

struct MaterialSpecimen {
  std::optional<double> area_mm2;   // under load, at rest; absent where the file does not give the size
  std::optional<double> height_mm;  // or gauge length, along the load (thickness in shear)
};

enum class DeclaredLaw { linear, neo_hookean };

struct MaterialTrial {
  std::string id;
  Eigen::VectorXd time_s;      // never goes back
  Eigen::VectorXd stretch;     // in shear: 1 + the amount of shear
  Eigen::VectorXd stress_kPa;  // nominal, compression negative; empty where predict() was given no measurement
};

struct Material {
  MaterialSpecimen specimen;
  Mode mode = Mode::compression;
  DeclaredLaw law = DeclaredLaw::linear;
  double young_kPa = 0;  // instantaneous
  double noise_kPa = 0;
  std::vector<MaterialTrial> trials;
};

// --- platform: battery, power and temperature against time

struct HardwareTrial {
  std::string id;
  double ambient_C = 25;
  Eigen::VectorXd time_s;  // never goes back
  // Each as long as time_s, or empty where the experiment names no such column.
  Eigen::VectorXd current_A;  // positive: discharge
  Eigen::VectorXd voltage_V;
  Eigen::VectorXd power_W;  // positive: drawn
  Eigen::VectorXd temperature_C;
  Eigen::VectorXd load;  // 0 to 1, or work a second
};

struct Hardware {
  std::optional<double> energy_Wh;
  std::optional<double> nominal_voltage_V;
  std::optional<double> capacity_Ah;
  double idle_W = 0;
  std::optional<double> full_load_W;  // above idle, at load 1
  std::optional<double> thermal_resistance_C_per_W;
  std::optional<double> time_constant_s;  // of the temperature; absent: it follows power at once
  // Standard deviations; a quantity without one is not judged.
  std::optional<double> noise_V, noise_C, noise_W;
  std::vector<HardwareTrial> trials;
};

// --- guidance: an organ seen by a camera, frame after frame

// Frames that belong together, as of one breath or one pull: they are left out together.
struct GuidanceTrial {
  std::string id;
  std::vector<std::size_t> frames;
};

// What was seen stands in the scan's frame, to which the declared pose of the camera brings it.
struct Guidance {
  // A trial a frame, of two samples: at rest, and as it is seen, with the force of its tool and the landmarks.
  Palpation organ;
  std::vector<std::vector<Eigen::Vector3d>> points_mm;  // of the surface, a frame each, without names
  std::vector<double> time_s;                           // of each frame
  std::vector<std::vector<Marker>> targets;             // of each frame: hidden places, judged by and never fitted
  double landmark_noise_mm = 0;                         // standard deviation of each coordinate; points: organ.noise_mm
  std::vector<GuidanceTrial> trials;                    // each frame in one
};

// To explain an experiment its trials must be measured; to predict one they need only say what was done.
enum class Needs { measurements, conditions };

// --- full field: a plate in plane strain, its displacements at every point and the forces at its borders

// Points whose displacement in one or both directions is the machine's, the same for all of them; elsewhere nothing
// pulls in that direction.
struct PlaneBoundary {
  std::string name;
  std::vector<int> points;
  std::array<bool, 2> prescribed{false, false};  // in x, in y
};

// Stands where something was not measured or not said.
constexpr double not_given = std::numeric_limits<double>::quiet_NaN();

struct PlaneTrial {
  std::string id;
  Eigen::Matrix2Xd displacement;  // of each point
  Eigen::Matrix2Xd prescribed;    // of each boundary; where nothing is said it is taken from the displacements
  Eigen::Matrix2Xd reaction;      // force on each boundary
};

// Without units, as published data are: lengths in one, stress in another, forces in their product times the thickness.
struct FullField {
  std::vector<Eigen::Vector2d> points;
  std::vector<std::array<int, 3>> triangles;  // counter-clockwise
  double thickness = 1;
  std::string law;              // a name of fullfield/laws.h
  Eigen::VectorXd law_numbers;  // in the law's order; empty: declared is its name alone
  double noise = 0;             // standard deviation of each displacement
  std::optional<double> noise_of_reactions;
  std::vector<PlaneBoundary> boundaries;
  std::vector<PlaneTrial> trials;
  Needs needs = Needs::measurements;  // what it was read for
};

// --- elastography: displacement fields of vibrated tissue against a wave equation

enum class WaveLaw { elastic, kelvin_voigt, springpot };

// With e^(i w t) for time, the complex shear modulus: G (elastic), G + i w eta (Kelvin and Voigt), or
// G (i w / w0)^a, G its magnitude at the frequency w0 / 2 pi (springpot).
struct DeclaredWaves {
  WaveLaw law = WaveLaw::elastic;
  double shear_modulus_kPa = 0;
  double viscosity_kPa_s = 0;
  double exponent = 0;
  double reference_Hz = 0;
  double density_kg_mm3 = 1e-6;
  // Whether a pressure of any shape may act besides (nearly incompressible tissue), so that only what has no divergence
  // is judged; else every component obeys the equation of shear waves by itself.
  bool pressure_is_free = false;
};

// One frequency, or one way of shaking.
struct WaveTrial {
  std::string id;
  double frequency_Hz = 0;
  double noise = 0;  // standard deviation of the real and of the imaginary part of each component
  std::vector<std::vector<std::complex<float>>> components;  // a value a voxel, in any one unit
};

struct Elastography {
  imaging::Grid grid;
  std::vector<std::uint8_t> region;     // 1 where the law is declared, a voxel each
  std::vector<std::string> components;  // "x", "y", "z", in this order; the patient's axes (LPS)
  DeclaredWaves declared;
  double patch_radius_mm = 0;  // of a test function; 0: half of the declared wavelength, a frequency each
  std::vector<WaveTrial> trials;
};

struct Experiment {
  std::filesystem::path file;
  std::string title;
  std::variant<Palpation, Material, Hardware, Guidance, FullField, Elastography> setup;
};

// Paths in the experiment are relative to its file. Refused are unknown or missing keys, tables or meshes that are not
// there, columns that are not in their table, and cells without a number. Refused are time that goes back, trials
// without samples, and two trials of one name. Refused are numbers that cannot be in the stated unit (a liver of 17000
// kPa, markers in metres), and markers outside the specimen. Each refusal names the file, where possible the line, and
// the likely cause. Codes: "experiment-invalid", "experiment-unit", "experiment-file-missing", and those of reading
// JSON and meshes.
Result<Experiment> read_experiment(const std::filesystem::path& file, Needs needs = Needs::measurements);

}  // namespace glisson::closedloop

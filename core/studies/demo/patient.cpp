#include "studies/demo/patient.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <numbers>
#include <tuple>

#include "base/files.h"
#include "base/json.h"
#include "imaging/dicom_seg.h"
#include "imaging/dicom_uid.h"
#include "imaging/dicom_write.h"
#include "imaging/filters.h"
#include "imaging/volume_file.h"
#include "segmentation/rasterise.h"
#include "segmentation/structures.h"
#include "studies/demo/internal/images.h"

namespace glisson::studies {
namespace fs = std::filesystem;
namespace {

using imaging::Grid;
using imaging::Mask;
using imaging::Role;
using imaging::SegmentedMask;
using imaging::SeriesDescription;
using imaging::Volume;

struct ElastographyImages {
  Volume true_shear_kPa;
  Volume magnitude;
  Waves waves;
  MeasuredStiffness measured;
};
Result<ElastographyImages> simulate_elastography(const DemoAnatomy& anatomy, const DemoOptions& options,
                                                 const Progress& progress);

Result<DemoSeries> write_anatomy(const fs::path& dicom, const Volume& image, const DemoOptions& options);
Result<std::vector<DemoSeries>> write_elastography(const fs::path& dicom, const ElastographyImages& images,
                                                   const DemoOptions& options);

std::vector<SegmentedMask> true_structures(const DemoAnatomy& anatomy, const Grid& grid);
std::vector<DemoSeeds> seeds_for(const DemoAnatomy& anatomy, const std::vector<SegmentedMask>& structures);
Result<DemoSeries> write_drawn_structures(const fs::path& dicom, const std::vector<SegmentedMask>& structures,
                                          const DemoSeries& anatomy);
Result<void> write_truth(const fs::path& folder, const DemoPatient& patient,
                         const std::vector<SegmentedMask>& structures, const Volume& true_shear_kPa,
                         const DemoOptions& options);

// A folder beside `out` that vanishes unless its content was moved into place.
class Staging {
 public:
  explicit Staging(const fs::path& out) : out_(out), folder_(out / ".demo-part") { clear(); }
  ~Staging() { clear(); }
  Staging(const Staging&) = delete;
  Staging& operator=(const Staging&) = delete;
  [[nodiscard]] fs::path path(const char* name) const { return folder_ / name; }
  Result<void> move_into_place(std::initializer_list<const char*> names) const;

 private:
  void clear() const {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  fs::path out_, folder_;
};

}  // namespace

Result<DemoPatient> write_demo_study(const fs::path& out_folder, const DemoOptions& options, const Progress& progress) {
  const auto anatomy = make_demo_anatomy(demo_patient_options(), progress.part(0, 0.1));
  if (!anatomy) return failure(anatomy.error());

  if (progress.cancelled()) return cancelled();
  progress.report(0.1, GLISSON_TEXT("simulating the MR images"));
  const Volume image = simulate_image(*anatomy, demo_anatomy_grid(), Contrast::portal_venous_t1, options.seed);
  if (progress.cancelled()) return cancelled();
  progress.report(0.4, GLISSON_TEXT("simulating the elastography"));
  const auto elastography = simulate_elastography(*anatomy, options, progress);
  if (!elastography) return failure(elastography.error());
  if (progress.cancelled()) return cancelled();

  progress.report(0.8, GLISSON_TEXT("writing the study"));
  const Staging staging(out_folder);
  DemoPatient patient;
  auto anatomy_series = write_anatomy(staging.path("dicom"), image, options);
  if (!anatomy_series) return failure(std::move(anatomy_series.error()));
  patient.series.push_back(std::move(*anatomy_series));
  auto elastography_series = write_elastography(staging.path("dicom"), *elastography, options);
  if (!elastography_series) return failure(std::move(elastography_series.error()));
  patient.series.insert(patient.series.end(), elastography_series->begin(), elastography_series->end());
  if (progress.cancelled()) return cancelled();

  const std::vector<SegmentedMask> structures = true_structures(*anatomy, image.grid);
  auto drawn = write_drawn_structures(staging.path("dicom"), structures, patient.series.front());
  if (!drawn) return failure(std::move(drawn.error()));
  patient.series.push_back(std::move(*drawn));

  progress.report(0.9, GLISSON_TEXT("writing the truth"));
  patient.landmarks = anatomy->landmarks;
  patient.seeds = seeds_for(*anatomy, structures);
  auto truth = write_truth(staging.path("truth"), patient, structures, elastography->true_shear_kPa, options);
  if (!truth) return failure(std::move(truth.error()));
  auto moved = staging.move_into_place({"dicom", "truth"});
  if (!moved) return failure(std::move(moved.error()));

  patient.dicom_folder = out_folder / "dicom";
  patient.truth_folder = out_folder / "truth";
  for (DemoSeries& series : patient.series) {
    series.folder = patient.dicom_folder / series.folder.filename();
    for (fs::path& file : series.files) file = series.folder / file.filename();
  }
  progress.report(1, GLISSON_TEXT("done"));
  return patient;
}

Grid demo_anatomy_grid() {
  Grid grid;
  grid.size = {256, 208, 70};
  grid.spacing_mm = {1.6, 1.6, 3.3};
  grid.origin_mm = {-204, -329, -420};
  return grid;
}

Grid demo_elastography_grid() {
  constexpr double degree = std::numbers::pi / 180;
  Grid grid;
  grid.size = {232, 196, 28};
  grid.spacing_mm = {1.64, 1.64, 6};
  grid.direction = (Eigen::AngleAxisd(8 * degree, Eigen::Vector3d::UnitX()) *
                    Eigen::AngleAxisd(-5 * degree, Eigen::Vector3d::UnitY()))
                       .toRotationMatrix();
  const Eigen::Vector3d middle_mm(-4, -166, -303);
  const Eigen::Vector3d half(0.5 * (grid.size[0] - 1), 0.5 * (grid.size[1] - 1), 0.5 * (grid.size[2] - 1));
  grid.origin_mm = middle_mm - grid.direction * grid.spacing_mm.cwiseProduct(half);
  return grid;
}

namespace {

Result<ElastographyImages> simulate_elastography(const DemoAnatomy& anatomy, const DemoOptions& options,
                                                 const Progress& progress) {
  const Grid grid = demo_elastography_grid();
  ElastographyImages images;
  images.true_shear_kPa =
      true_shear_modulus(draw_tissues(anatomy, grid, options.seed), options.stiffness, options.seed);
  if (progress.cancelled()) return cancelled();
  images.magnitude = simulate_image(anatomy, grid, Contrast::elastography, options.seed);
  if (progress.cancelled()) return cancelled();
  WaveOptions waves = options.waves;
  waves.body_size = anatomy.size;
  images.waves = simulate_waves(images.true_shear_kPa, waves, options.seed);
  if (progress.cancelled()) return cancelled();
  images.measured =
      measure_stiffness(images.true_shear_kPa, liver_mask(anatomy, grid), images.waves.amplitude_um, options.seed);
  return images;
}

// What all series of the demo have in common.
SeriesDescription described(const DemoOptions& options, int number, const std::string& description) {
  const std::string study = fmt::format("glisson demo patient, seed {}", options.seed);
  SeriesDescription series;
  series.patient_name = "SIMULATED^GLISSON DEMO";
  series.patient_id = fmt::format("SIMULATED-{}", options.seed);
  series.patient_comments = demo_is_simulated;
  series.study_uid = imaging::uid_from_name(study);
  series.series_uid = imaging::uid_from_name(fmt::format("{}, series {}", study, number));
  series.frame_of_reference_uid = imaging::uid_from_name(study + ", frame of reference");
  series.study_id = "DEMO";
  series.study_description = "SIMULATED liver study";
  series.study_date = "20260101";
  series.study_time = "080000";
  series.series_number = number;
  series.series_description = "SIMULATED " + description;
  series.protocol_name = "SIMULATED";
  series.manufacturer = "Glisson (simulated)";
  series.image_comments = demo_is_simulated;
  series.field_strength_T = 3;
  return series;
}

// Several volumes are the phase offsets of one motion, evenly over its period.
Result<DemoSeries> write_series(const fs::path& folder, Role role, const std::vector<Volume>& volumes,
                                SeriesDescription description, double period_ms) {
  DemoSeries series{role, description.series_uid, folder, {}};
  const int count = static_cast<int>(volumes.size());
  for (int offset = 0; offset < count; ++offset) {
    if (count > 1) description.temporal_position = {offset + 1, count, offset * period_ms / count};
    auto files = imaging::write_dicom_series(folder, volumes[static_cast<std::size_t>(offset)], description);
    if (!files) return failure(std::move(files.error()));
    series.files.insert(series.files.end(), files->begin(), files->end());
  }
  return series;
}

Result<DemoSeries> write_anatomy(const fs::path& dicom, const Volume& image, const DemoOptions& options) {
  SeriesDescription series = described(options, 1, "Ax T1 FS portal venous");
  series.image_type = "DERIVED\\PRIMARY\\M\\NORM";
  series.sequence_name = "fl3d";
  series.slice_thickness_mm = 3.0;
  series.repetition_time_ms = 4.1;
  series.echo_time_ms = 1.9;
  series.flip_angle_deg = 12;
  series.rescale_slope = 1;
  return write_series(dicom / "1_anatomy", Role::anatomy, {image}, series, 0);
}

Result<std::vector<DemoSeries>> write_elastography(const fs::path& dicom, const ElastographyImages& images,
                                                   const DemoOptions& options) {
  const auto common = [&](int number, const std::string& description, const std::string& image_type) {
    SeriesDescription series = described(options, number, description);
    series.image_type = image_type;
    series.sequence_name = "epse2d_mre";
    series.slice_thickness_mm = 5.0;
    series.repetition_time_ms = 1000.0 * 60 / options.waves.frequency_Hz;
    series.echo_time_ms = 48;
    return series;
  };
  SeriesDescription magnitude = common(2, "MRE magnitude", "DERIVED\\PRIMARY\\M\\MRE");
  magnitude.rescale_slope = 1;

  SeriesDescription wave =
      common(3, fmt::format("MRE wave {:g} Hz", options.waves.frequency_Hz), "DERIVED\\PRIMARY\\WAVE\\MRE");
  wave.rescale_type = "um";
  wave.rescale_slope = 0.01;

  // Scanners store pascals in whole numbers.
  SeriesDescription stiffness = common(4, "MRE stiffness (Pa)", "DERIVED\\PRIMARY\\STIFFNESS\\MRE");
  stiffness.rescale_type = "Pa";
  stiffness.rescale_slope = 1;
  Volume stiffness_Pa = images.measured.shear_kPa;
  for (float& value : stiffness_Pa.values) value *= 1000;

  SeriesDescription confidence = common(5, "MRE confidence mask", "DERIVED\\PRIMARY\\CONFIDENCE\\MRE");
  confidence.rescale_slope = 1;

  std::vector<DemoSeries> all;
  for (auto& [role, folder, volumes, series] :
       std::vector<std::tuple<Role, const char*, std::vector<Volume>, SeriesDescription>>{
           {Role::mre_magnitude, "2_mre_magnitude", {images.magnitude}, magnitude},
           {Role::mre_wave, "3_mre_wave", images.waves.displacement_um, wave},
           {Role::mre_stiffness, "4_mre_stiffness", {stiffness_Pa}, stiffness},
           {Role::mre_confidence, "5_mre_confidence", {images.measured.confidence}, confidence}}) {
    auto written = write_series(dicom / folder, role, volumes, series, 1000 / options.waves.frequency_Hz);
    if (!written) return failure(std::move(written.error()));
    all.push_back(std::move(*written));
  }
  return all;
}

// What a radiologist marks and sends along as DICOM SEG: the tumour, the cysts and the vessels. The liver itself is
// left to be segmented.
Result<DemoSeries> write_drawn_structures(const fs::path& dicom, const std::vector<SegmentedMask>& structures,
                                          const DemoSeries& anatomy) {
  std::vector<SegmentedMask> drawn;
  for (const SegmentedMask& structure : structures) {
    if (structure.info.name == "liver") continue;
    drawn.push_back(structure);
    drawn.back().info.label_value = static_cast<int>(drawn.size());
  }
  auto source = imaging::segmentation_source(anatomy.files);
  if (!source) return failure(source.error());
  source->series_description = "SIMULATED structures drawn by a radiologist";
  source->content_date = source->study_date;  // the same bytes every day
  source->content_time = source->study_time;
  const fs::path folder = dicom / "6_structures";
  std::error_code problem;
  fs::create_directories(folder, problem);  // a failure shows in the writing
  const fs::path file = folder / "structures.dcm";
  if (auto written = imaging::write_dicom_seg(file, drawn, *source); !written) return failure(written.error());
  return DemoSeries{Role::segmentation, {}, folder, {file}};
}

std::vector<SegmentedMask> true_structures(const DemoAnatomy& anatomy, const Grid& grid) {
  std::vector<SegmentedMask> structures;
  const auto add = [&](const std::string& name, Mask mask) {
    structures.push_back({{name, 1, segmentation::known_structure(name).color_rgb}, std::move(mask)});
  };
  add("liver", liver_mask(anatomy, grid));
  add("tumour-1", segmentation::rasterise(anatomy.tumour, grid));
  add("portal-vein", segmentation::rasterise(anatomy.drawn_portal_vein, grid));
  add("hepatic-vein", segmentation::rasterise(anatomy.drawn_hepatic_veins, grid));
  add("gallbladder", segmentation::rasterise(anatomy.gallbladder, grid));
  add("cyst", segmentation::rasterise(anatomy.cysts, grid));
  return structures;
}

// Points deep in plain liver tissue and far from each other, the deepest first; the middle of the tumour; points that
// landmarks mark in the vessels.
std::vector<DemoSeeds> seeds_for(const DemoAnatomy& anatomy, const std::vector<SegmentedMask>& structures) {
  constexpr int wanted = 5;
  constexpr double apart_mm = 45;
  Mask elsewhere = structures.front().mask;
  for (std::size_t i = 0; i < elsewhere.values.size(); ++i) {
    bool plain = elsewhere.values[i] != 0;
    for (std::size_t s = 1; s < structures.size(); ++s) plain = plain && structures[s].mask.values[i] == 0;
    elsewhere.values[i] = plain ? 0 : 1;
  }
  const Grid& grid = elsewhere.grid;
  std::vector<float> depth = imaging::squared_distances_mm2(elsewhere);
  DemoSeeds liver{"liver", {}};
  for (int seed = 0; seed < wanted; ++seed) {
    const auto deepest = static_cast<std::size_t>(std::max_element(depth.begin(), depth.end()) - depth.begin());
    const auto width = static_cast<std::size_t>(grid.size[0]), height = static_cast<std::size_t>(grid.size[1]);
    const auto position = [&](std::size_t voxel) {
      return grid.position_mm(static_cast<int>(voxel % width), static_cast<int>(voxel / width % height),
                              static_cast<int>(voxel / width / height));
    };
    liver.positions_mm.push_back(position(deepest));
    for (std::size_t i = 0; i < depth.size(); ++i) {  // what is near is out
      if (depth[i] > 0 && (position(i) - liver.positions_mm.back()).norm() < apart_mm) depth[i] = 0;
    }
  }

  std::vector<DemoSeeds> seeds = {std::move(liver)};
  for (const char* structure : {"tumour-1", "portal-vein", "hepatic-vein"}) {
    seeds.push_back({structure, {}});
    for (const DemoLandmark& landmark : anatomy.landmarks) {
      if (landmark.structure == structure) seeds.back().positions_mm.push_back(landmark.position_mm);
    }
  }
  return seeds;
}

Json rounded(const Eigen::Vector3d& position_mm) {
  Json list = Json::array();
  for (const double value : position_mm) list.push_back(std::round(value * 100) / 100);
  return list;
}

Result<void> write_truth(const fs::path& folder, const DemoPatient& patient,
                         const std::vector<SegmentedMask>& structures, const Volume& true_shear_kPa,
                         const DemoOptions& options) {
  Json truth;
  truth["simulated"] = demo_is_simulated;
  truth["seed"] = options.seed;
  truth["frame"] = "patient coordinates, LPS, mm";
  truth["liver_kPa"] = options.stiffness.liver_kPa;
  truth["fibrotic_kPa"] = options.stiffness.fibrotic_kPa;
  truth["tumour_ratio"] = options.stiffness.tumour_ratio;
  truth["frequency_Hz"] = options.waves.frequency_Hz;
  truth["true_shear_modulus"] = "shear_kPa.nrrd";
  for (const DemoSeries& series : patient.series) {
    truth["series"].push_back({{"role", imaging::role_name(series.role)}, {"uid", series.uid}});
  }
  for (const DemoLandmark& landmark : patient.landmarks) {
    truth["landmarks"].push_back(
        {{"id", landmark.id}, {"structure", landmark.structure}, {"position_mm", rounded(landmark.position_mm)}});
  }
  for (const DemoSeeds& seeds : patient.seeds) {
    Json positions = Json::array();
    for (const Eigen::Vector3d& position : seeds.positions_mm) positions.push_back(rounded(position));
    truth["seeds"].push_back({{"structure", seeds.structure}, {"positions_mm", positions}});
  }
  for (const SegmentedMask& structure : structures) {
    const std::string file = structure.info.name + ".nrrd";
    truth["structures"].push_back(
        {{"name", structure.info.name}, {"volume_ml", segmentation::volume_ml(structure.mask)}, {"file", file}});
    if (auto written = imaging::write_mask_file(folder / file, structure.mask, structure.info); !written) {
      return written;
    }
  }
  if (auto written = imaging::write_volume_file(folder / "shear_kPa.nrrd", true_shear_kPa); !written) return written;
  return write_json_file(folder / "truth.json", truth);
}

Result<void> Staging::move_into_place(std::initializer_list<const char*> names) const {
  std::error_code problem;
  for (const char* name : names) {
    fs::remove_all(out_ / name, problem);
    if (!problem) fs::rename(folder_ / name, out_ / name, problem);
    if (problem) {
      return failure(Error{"demo-not-written",
                           GLISSON_TEXT("{0} cannot be written: {1}."),
                           {(out_ / name).string(), problem.message()},
                           GLISSON_TEXT("Check the folder and your rights there."),
                           out_ / name});
    }
  }
  return {};
}

}  // namespace
}  // namespace glisson::studies

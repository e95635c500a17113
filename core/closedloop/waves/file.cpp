// Elastography from JSON: the declared law, the region, and of each trial its frequency and the images of the real and
// the imaginary part of each component.

#include <algorithm>
#include <cmath>

#include "closedloop/experiment/internal/experiment_source.h"
#include "imaging/volume_file.h"

namespace glisson::closedloop {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t maximum_field_voxels = std::size_t{1} << 24;  // of an image: 256 cubed
constexpr std::size_t maximum_values = std::size_t{1} << 27;        // complex ones, of all trials: 1 GB

DeclaredWaves declared_from(const Json& json);
WaveTrial wave_trial_from(const Json& json, const Source& source, const std::string& id, double noise,
                          Elastography& waves);
imaging::Volume image_of(const Json& json, const Source& source, const std::string& where, Elastography& waves);
void read_region(const Json& json, const Source& source, Elastography& waves);

}  // namespace

Elastography elastography_from(const Json& json, const Source& source) {
  only_keys(json, {"format", "kind", "title", "declared", "noise", "region", "patch_radius_mm", "trials"},
            "The experiment");
  Elastography waves;
  waves.declared = declared_from(required(json, "declared", "The experiment"));
  if (json.contains("patch_radius_mm")) waves.patch_radius_mm = positive_in(json["patch_radius_mm"], "patch_radius_mm");
  const std::vector<std::string> ids = trial_ids(json);
  std::size_t values = 0;
  for (std::size_t t = 0; t < ids.size(); ++t) {
    const Json& trial = json["trials"][t];
    const Json& noise = trial.contains("noise") ? trial["noise"] : required(json, "noise", "The experiment");
    waves.trials.push_back(wave_trial_from(trial, source, ids[t], positive_in(noise, "noise"), waves));
    values += waves.grid.voxels() * waves.components.size();
    if (values > maximum_values)
      refuse("experiment-invalid", GLISSON_TEXT("The trials hold more than {0} values together."),
             {std::to_string(maximum_values)}, GLISSON_TEXT("Cut the images to the region, or leave trials out."));
  }
  read_region(json, source, waves);
  return waves;
}

namespace {

DeclaredWaves declared_from(const Json& json) {
  only_keys(json,
            {"law", "shear_modulus_kPa", "viscosity_Pa_s", "exponent", "reference_Hz", "density_kg_m3", "pressure"},
            "declared");
  DeclaredWaves declared;
  declared.law = one_of<WaveLaw>(
      required(json, "law", "declared"), "declared, law",
      {{"elastic", WaveLaw::elastic}, {"kelvin-voigt", WaveLaw::kelvin_voigt}, {"springpot", WaveLaw::springpot}});
  declared.shear_modulus_kPa =
      positive_in(required(json, "shear_modulus_kPa", "declared"), "declared, shear_modulus_kPa");
  refuse_unlikely_modulus(declared.shear_modulus_kPa, "declared, shear_modulus_kPa");
  if (declared.law == WaveLaw::kelvin_voigt)
    declared.viscosity_kPa_s =
        1e-3 * positive_in(required(json, "viscosity_Pa_s", "declared"), "declared, viscosity_Pa_s");
  if (declared.law == WaveLaw::springpot) {
    declared.exponent = positive_in(required(json, "exponent", "declared"), "declared, exponent");
    if (declared.exponent >= 1) refuse_at("declared, exponent", GLISSON_TEXT("{0} must lie between 0 and 1."));
    declared.reference_Hz = positive_in(required(json, "reference_Hz", "declared"), "declared, reference_Hz");
  }
  if (const auto density = optional_positive(json, "density_kg_m3", "declared")) {
    if (*density < 100 || *density > 10000)
      refuse("experiment-unit", GLISSON_TEXT("The declared density is {0} kg/m3, which no tissue has."),
             {std::to_string(*density)}, GLISSON_TEXT("Was it given in g/cm3?"));
    declared.density_kg_mm3 = 1e-9 * *density;
  }
  if (json.contains("pressure"))
    declared.pressure_is_free = one_of<bool>(json["pressure"], "declared, pressure", {{"none", false}, {"free", true}});
  return declared;
}

// Components come in the order x, y, z, and of all trials the same.
WaveTrial wave_trial_from(const Json& json, const Source& source, const std::string& id, double noise,
                          Elastography& waves) {
  const std::string where = "trial " + id;
  only_keys(json, {"id", "frequency_Hz", "noise", "components"}, where);
  WaveTrial trial{id, positive_in(required(json, "frequency_Hz", where), where + ", frequency_Hz"), noise, {}};
  const Json& components = required(json, "components", where);
  only_keys(components, {"x", "y", "z"}, where + ", components");
  std::vector<std::string> names;
  for (const char* name : {"x", "y", "z"}) {
    if (components.contains(name)) names.emplace_back(name);
  }
  if (names.empty()) refuse_at(where + ", components", GLISSON_TEXT("{0} names none of x, y and z."));
  if (waves.declared.pressure_is_free && names.size() < 3)
    refuse_at(where + ", components",
              GLISSON_TEXT("{0} must have x, y and z: without one of them a free pressure cannot be taken off."));
  if (!waves.trials.empty() && names != waves.components)
    refuse_at(where + ", components", GLISSON_TEXT("{0} must be those of the first trial."));
  waves.components = names;
  for (const std::string& name : names) {
    const std::string here = where + ", component " + name;
    const Json& parts = components[name];
    only_keys(parts, {"real", "imaginary"}, here);
    const imaging::Volume real = image_of(required(parts, "real", here), source, here + ", real", waves);
    const imaging::Volume imaginary = image_of(required(parts, "imaginary", here), source, here + ", imaginary", waves);
    std::vector<std::complex<float>> field(real.values.size());
    for (std::size_t v = 0; v < field.size(); ++v) field[v] = {real.values[v], imaginary.values[v]};
    trial.components.push_back(std::move(field));
  }
  return trial;
}

// All images lie on the grid of the first.
imaging::Volume image_of(const Json& json, const Source& source, const std::string& where, Elastography& waves) {
  const fs::path file = source.named_file(text_in(json, where));
  imaging::Volume image = taken(imaging::read_volume_file(file));
  if (image.grid.voxels() > maximum_field_voxels)
    refuse("experiment-invalid", GLISSON_TEXT("{0} has more than {1} voxels."),
           {file.filename().string(), std::to_string(maximum_field_voxels)}, GLISSON_TEXT("Cut it to the region."),
           file);
  if (waves.grid.voxels() == 0) {
    const Eigen::Matrix3d square = image.grid.direction.transpose() * image.grid.direction;
    if (!square.isIdentity(1e-3))
      refuse("experiment-invalid", GLISSON_TEXT("The axes of {0} are not at right angles."), {file.filename().string()},
             {}, file);
    waves.grid = image.grid;
  } else if (!imaging::same_grid(image.grid, waves.grid)) {
    refuse("experiment-invalid", GLISSON_TEXT("{0} lies on another grid than the first image."),
           {file.filename().string()}, GLISSON_TEXT("All images of an experiment have the same voxels."), file);
  }
  return image;
}

// Without a mask it is all of the image; where a value is no number the law is not declared.
void read_region(const Json& json, const Source& source, Elastography& waves) {
  waves.region.assign(waves.grid.voxels(), 1);
  if (json.contains("region")) {
    const fs::path file = source.named_file(text_in(json["region"], "region"));
    const imaging::Volume mask = taken(imaging::read_volume_file(file));
    if (!imaging::same_grid(mask.grid, waves.grid))
      refuse("experiment-invalid", GLISSON_TEXT("{0} lies on another grid than the first image."),
             {file.filename().string()}, GLISSON_TEXT("All images of an experiment have the same voxels."), file);
    for (std::size_t v = 0; v < mask.values.size(); ++v) waves.region[v] = mask.values[v] > 0 ? 1 : 0;
  }
  for (WaveTrial& trial : waves.trials) {
    for (auto& field : trial.components) {
      for (std::size_t v = 0; v < field.size(); ++v) {
        if (std::isfinite(field[v].real()) && std::isfinite(field[v].imag())) continue;
        waves.region[v] = 0;
        field[v] = 0;
      }
    }
  }
  if (std::none_of(waves.region.begin(), waves.region.end(), [](std::uint8_t in) { return in != 0; }))
    refuse("experiment-invalid", GLISSON_TEXT("The region holds no voxel in which all images have numbers."), {},
           GLISSON_TEXT("Was the mask drawn on these images?"));
}

}  // namespace
}  // namespace glisson::closedloop

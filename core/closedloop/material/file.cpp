// Material tests from JSON and their tables.

#include <cmath>
#include <numbers>

#include "base/units.h"
#include "closedloop/experiment/internal/experiment_source.h"

namespace glisson::closedloop {
namespace {

MaterialSpecimen specimen_from(const Json& json);
void read_declared(const Json& json, Material& material);
MaterialTrial trial_from(const Json& json, const std::string& id, const Source& source, const Material& material,
                         Needs needs);

}  // namespace

Material material_from(const Json& json, const Source& source, Needs needs) {
  only_keys(json, {"format", "kind", "title", "specimen", "mode", "declared", "noise_kPa", "trials"}, "The experiment");
  Material material;
  if (json.contains("specimen")) material.specimen = specimen_from(json["specimen"]);
  const std::string mode = text_in(required(json, "mode", "The experiment"), "mode");
  if (mode == "compression") {
    material.mode = Mode::compression;
  } else if (mode == "tension") {
    material.mode = Mode::tension;
  } else if (mode == "shear") {
    material.mode = Mode::shear;
  } else {
    refuse("experiment-invalid", GLISSON_TEXT("The mode \"{0}\" is not known."), {mode},
           GLISSON_TEXT("The modes are compression, tension and shear."));
  }
  read_declared(required(json, "declared", "The experiment"), material);
  material.noise_kPa = positive_in(required(json, "noise_kPa", "The experiment"), "noise_kPa");
  const std::vector<std::string> ids = trial_ids(json);
  for (std::size_t t = 0; t < ids.size(); ++t)
    material.trials.push_back(trial_from(json["trials"][t], ids[t], source, material, needs));
  return material;
}

namespace {

MaterialSpecimen specimen_from(const Json& json) {
  only_keys(json, {"shape", "diameter_mm", "height_mm", "width_mm", "thickness_mm", "length_mm", "area_mm2"},
            "The specimen");
  MaterialSpecimen specimen;
  specimen.height_mm = optional_positive(json, "height_mm", "specimen");
  if (!specimen.height_mm) specimen.height_mm = optional_positive(json, "length_mm", "specimen");
  specimen.area_mm2 = optional_positive(json, "area_mm2", "specimen");
  const auto diameter_mm = optional_positive(json, "diameter_mm", "specimen");
  const auto width_mm = optional_positive(json, "width_mm", "specimen");
  const auto thickness_mm = optional_positive(json, "thickness_mm", "specimen");
  if (!specimen.area_mm2 && diameter_mm) specimen.area_mm2 = std::numbers::pi / 4 * *diameter_mm * *diameter_mm;
  if (!specimen.area_mm2 && width_mm && thickness_mm) specimen.area_mm2 = *width_mm * *thickness_mm;
  return specimen;
}

void read_declared(const Json& json, Material& material) {
  only_keys(json, {"law", "youngs_modulus_kPa"}, "declared");
  const std::string law = text_in(required(json, "law", "declared"), "declared, law");
  if (law != "linear" && law != "neo-hookean")
    refuse("experiment-invalid", GLISSON_TEXT("The declared law \"{0}\" is not known."), {law},
           GLISSON_TEXT("The laws are linear and neo-hookean."));
  material.law = law == "linear" ? DeclaredLaw::linear : DeclaredLaw::neo_hookean;
  material.young_kPa = positive_in(required(json, "youngs_modulus_kPa", "declared"), "declared, youngs_modulus_kPa");
  refuse_unlikely_modulus(material.young_kPa, "declared, youngs_modulus_kPa");
}

double size_for(const std::optional<double>& size, const char* what, const char* key, const std::string& where) {
  if (!size)
    refuse("experiment-invalid", GLISSON_TEXT("{0} gives \"{1}\", which needs the specimen's {2}."), {where, key, what},
           GLISSON_TEXT("Give the specimen's diameter_mm (or width_mm and thickness_mm, or area_mm2) and height_mm."));
  return *size;
}

// A specimen resists: stress has the sign of the strain over most of a test, whatever it dissipates; and so has its
// change since the first sample, where the load cell's zero is off by more than the test's own stress.
void refuse_opposed_signs(const MaterialTrial& trial, const std::filesystem::path& file) {
  if (trial.stress_kPa.size() == 0) return;
  const Eigen::ArrayXd strain = trial.stretch.array() - 1;
  const Eigen::ArrayXd& stress = trial.stress_kPa.array();
  if ((stress * strain).sum() >= 0 || ((stress - stress[0]) * (strain - strain[0])).sum() >= 0) return;
  refuse("experiment-unit", GLISSON_TEXT("In {0} stress and strain mostly have opposite signs."),
         {file.filename().string()},
         GLISSON_TEXT("In compression stretch is below 1, and displacement, force and stress are negative."), file);
}

MaterialTrial trial_from(const Json& json, const std::string& id, const Source& source, const Material& material,
                         Needs needs) {
  const std::string where = "trial " + id;
  only_keys(json, {"id", "file", "columns"}, where);
  const std::filesystem::path file = source.named_file(text_in(required(json, "file", where), where + ", file"));
  const Json& columns = required(json, "columns", where);
  only_keys(columns, {"time_s", "stretch", "displacement_mm", "stress_kPa", "force_N"}, where + ", columns");
  const CsvTable table = table_of(file);
  const auto column = [&](const char* key) {
    return column_of(table, text_in(columns[key], where + ", " + key), file, key);
  };

  MaterialTrial trial{id, {}, {}, {}};
  trial.time_s = times_of(table, text_in(required(columns, "time_s", where + ", columns"), where + ", time_s"), file);
  if (columns.contains("stretch")) {
    trial.stretch = column("stretch");
  } else if (columns.contains("displacement_mm")) {
    const double height_mm = size_for(material.specimen.height_mm, "height", "displacement_mm", where);
    trial.stretch = 1 + column("displacement_mm").array() / height_mm;
  } else {
    refuse("experiment-invalid", GLISSON_TEXT("{0} names no column for \"stretch\" or \"displacement_mm\"."), {where});
  }
  if (columns.contains("stress_kPa")) {
    trial.stress_kPa = column("stress_kPa");
  } else if (columns.contains("force_N")) {
    const double area_mm2 = size_for(material.specimen.area_mm2, "cross-section", "force_N", where);
    trial.stress_kPa = column("force_N").unaryExpr(&units::mN_from_N) / area_mm2;
  } else if (needs == Needs::measurements) {
    refuse("experiment-invalid", GLISSON_TEXT("{0} names no column for \"stress_kPa\" or \"force_N\"."), {where});
  }
  for (Eigen::Index row = 0; row < trial.stretch.size(); ++row) {
    if (material.mode != Mode::shear && !(trial.stretch[row] > 0.02 && trial.stretch[row] < 20))
      refuse("experiment-unit", GLISSON_TEXT("Line {0} of {1} gives a stretch of {2}, which no specimen survives."),
             {std::to_string(table.lines[static_cast<std::size_t>(row)]), file.filename().string(),
              std::to_string(trial.stretch[row])},
             GLISSON_TEXT("Is it strain, or a percentage? Stretch is length over length at rest."), file);
  }
  refuse_opposed_signs(trial, file);
  return trial;
}

}  // namespace
}  // namespace glisson::closedloop

#include "closedloop/material/stress_strain_file.h"

#include <cmath>

#include "base/csv.h"
#include "closedloop/experiment/experiment.h"

namespace glisson::closedloop {
namespace {

Result<std::vector<mechanics::StressStrain>> from_experiment(const std::filesystem::path& file) {
  const auto experiment = read_experiment(file);
  if (!experiment) return failure(experiment.error());
  const auto* material = std::get_if<Material>(&experiment->setup);
  if (material == nullptr) {
    return failure(Error{"experiment-not-material",
                         GLISSON_TEXT("The experiment is not of kind \"material\": it holds no strain and stress."),
                         {},
                         {},
                         file});
  }
  if (material->mode == Mode::shear) {
    return failure(Error{"data-invalid",
                         GLISSON_TEXT("A shear test cannot be used straight: take compression or tension."),
                         {},
                         {},
                         file});
  }
  std::vector<mechanics::StressStrain> measured;
  for (const MaterialTrial& trial : material->trials) {
    for (Eigen::Index i = 0; i < trial.stress_kPa.size(); ++i) {
      measured.push_back({trial.stretch[i] - 1.0, trial.stress_kPa[i]});
    }
  }
  return measured;
}

Result<std::vector<mechanics::StressStrain>> from_table(const std::filesystem::path& file) {
  const auto table = read_csv(file);
  if (!table) return failure(table.error());
  const auto strain = table->column("strain");
  if (!strain) return failure(Error(strain.error()).in_file(file));
  const auto stress = table->column("stress_kPa");
  if (!stress) return failure(Error(stress.error()).in_file(file));
  std::vector<mechanics::StressStrain> measured;
  for (std::size_t row = 0; row < table->rows(); ++row) {
    measured.push_back({table->columns[*strain][row], table->columns[*stress][row]});
    for (const std::size_t column : {*strain, *stress}) {
      if (std::isfinite(table->columns[column][row])) continue;
      return failure(Error{"data-not-a-number",
                           GLISSON_TEXT("In line {0} no number stands in the column \"{1}\"."),
                           {std::to_string(table->lines[row]), table->names[column]},
                           GLISSON_TEXT("A line needs a strain (0.05 for 5 %) and a stress in kPa, numbers with a dot: "
                                        "look for a missing value, a unit, or a decimal comma."),
                           file});
    }
  }
  return measured;
}

}  // namespace

Result<std::vector<mechanics::StressStrain>> read_stress_strain(const std::filesystem::path& file) {
  return file.extension() == ".json" ? from_experiment(file) : from_table(file);
}

}  // namespace glisson::closedloop

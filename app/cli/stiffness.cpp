// glisson-cli stiffness CASE: gives each cell its Young's modulus, from the MRE map or one value.

#include <fmt/format.h>

#include "casefile/model_upkeep.h"
#include "command.h"

namespace glisson::cli {
namespace {

Outcome describe(const elastography::CellStiffness& stiffness, const std::optional<Sentence>& assumed) {
  return {
      {{"assumed", assumed.has_value()},
       {"mean_kPa", stiffness.mean_kPa},
       {"sd_kPa", stiffness.sd_kPa},
       {"min_kPa", stiffness.min_kPa},
       {"max_kPa", stiffness.max_kPa},
       {"cells", stiffness.youngs_kPa.size()},
       {"cells_without_data", stiffness.cells_without_data},
       {"filled_fraction", stiffness.filled_fraction}},
      assumed
          ? assumed->message() + "\n"
          : fmt::format(
                "Young's modulus {:.2f} kPa on average (sd {:.2f}, {:.2f} to {:.2f}); {} of {} cells had no reliable "
                "measurement and were filled from inside\n",
                stiffness.mean_kPa, stiffness.sd_kPa, stiffness.min_kPa, stiffness.max_kPa,
                stiffness.cells_without_data, stiffness.youngs_kPa.size())};
}

}  // namespace

void add_stiffness(CLI::App& app, Action& chosen) {
  CLI::App* command =
      app.add_subcommand("stiffness", "Give each cell its stiffness: from MR elastography, or one value");
  auto case_folder = std::make_shared<std::string>();
  auto uniform_kPa = std::make_shared<std::optional<double>>();
  auto population_shear_kPa = std::make_shared<std::optional<std::string>>();
  command->add_option("case", *case_folder, "The case")->required();
  CLI::Option* uniform = command->add_option("--uniform-kPa", *uniform_kPa, "One Young's modulus for the whole liver");
  CLI::Option* reference =
      command
          ->add_option("--atlas", *population_shear_kPa, "The atlas's mean shear stiffness: 2.1 (default) or 2.6 kPa")
          ->expected(0, 1)
          ->default_str("2.1")
          ->check(CLI::IsMember({"2.1", "2.6"}));
  uniform->excludes(reference);
  command->callback([&chosen, case_folder, uniform_kPa, population_shear_kPa, reference] {
    const bool from_population_mean = reference->count() > 0;
    chosen = [=](const Progress& progress) -> Result<Outcome> {
      auto patient = casefile::Case::open(*case_folder);
      if (!patient) return failure(patient.error());
      casefile::StiffnessChoice choice = casefile::FromMre{};
      if (*uniform_kPa) choice = casefile::Uniform{**uniform_kPa};
      if (from_population_mean) {
        choice = casefile::FromPopulationMean{population_shear_kPa->value_or("2.1") == "2.6"
                                                  ? elastography::PopulationMean::published_cohort
                                                  : elastography::PopulationMean::dissertation_cohort};
      }
      return casefile::assign_stiffness(*patient, choice, {}, progress)
          .map([&](const elastography::CellStiffness& stiffness) {
            return describe(stiffness, casefile::assumed_stiffness(*patient));
          });
    };
  });
}

}  // namespace glisson::cli

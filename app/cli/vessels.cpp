// glisson-cli vessels CASE [--structure NAME] [--seed X,Y,Z ...] [--click VESSEL=X,Y,Z ...] [--border V-VIII=X,Y,Z
// ...]: the vessel trees of a case.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>

#include "casefile/vascular.h"
#include "command.h"
#include "shared_options.h"
#include "vasculature/tree_file.h"

namespace glisson::cli {
namespace {

using vasculature::System;
using vasculature::TreeBranch;
using vasculature::Vessel;

struct VesselsCommand {
  std::string case_folder;
  std::optional<std::string> structure;
  std::vector<std::string> seeds, clicks, borders;
};

Outcome describe(const vasculature::VesselTrees& trees, const std::string& file) {
  Json branches = Json::array();
  std::array<double, vasculature::all_systems.size()> length{}, sure{};
  for (std::size_t b = 0; b < trees.branches.size(); ++b) {
    const TreeBranch& branch = trees.branches[b];
    branches.push_back({{"id", b},
                        {"name", branch.name},
                        {"parent", branch.parent},
                        {"system", vasculature::system_name(branch.system)},
                        {"radius_mm", branch.radius_mm},
                        {"length_mm", branch.length_mm},
                        {"confidence", branch.confidence}});
    length.at(static_cast<std::size_t>(branch.system)) += branch.length_mm;
    if (branch.confidence >= 0.8) sure.at(static_cast<std::size_t>(branch.system)) += branch.length_mm;
  }
  Outcome outcome{{{"branches", std::move(branches)},
                   {"portal_entry_mm", json_of(trees.portal_entry_mm)},
                   {"hepatic_entry_mm", json_of(trees.hepatic_entry_mm)},
                   {"border_doubts", vasculature::border_doubts_json(trees)},
                   {"file", file}},
                  {}};
  for (const System system : vasculature::all_systems) {
    const auto n = static_cast<std::size_t>(system);
    const auto count = std::count_if(trees.branches.begin(), trees.branches.end(),
                                     [&](const TreeBranch& branch) { return branch.system == system; });
    if (count == 0 && !vasculature::is_vein(system)) continue;
    outcome.text +=
        fmt::format("{}: {} branches, {:.0f} mm, {:.0f} % of it without doubt\n", vasculature::system_name(system),
                    count, length.at(n), length.at(n) > 0 ? 100 * sure.at(n) / length.at(n) : 0);
  }
  if (!trees.border_doubts.empty()) {
    const vasculature::BorderDoubt& most = trees.border_doubts.front();
    outcome.text +=
        fmt::format("The border along the {} is most in doubt, {:.0f} ml: --click {}=X,Y,Z would tell it.\n",
                    vasculature::vessel_name(most.vessel), most.doubt_ml, vasculature::vessel_name(most.vessel));
  }
  return outcome;
}

std::string names_of_vessels() {
  std::vector<std::string> names;
  for (const Vessel vessel : vasculature::all_vessels) names.emplace_back(vasculature::vessel_name(vessel));
  return fmt::format("{}", fmt::join(names, ", "));
}

// "right-hepatic-vein=1,2,3".
Result<vasculature::Click> parse_click(const std::string& text) {
  const std::size_t equals = std::min(text.find('='), text.size());
  const auto vessel = vasculature::vessel_named(text.substr(0, equals));
  if (!vessel || equals == text.size()) {
    return failure("click-invalid", GLISSON_TEXT("--click wants VESSEL=X,Y,Z with one of {0}, not \"{1}\"."),
                   {names_of_vessels(), text});
  }
  return parse_position(text.substr(equals + 1), "--click").map([&](const Eigen::Vector3d& position_mm) {
    return vasculature::Click{*vessel, position_mm};
  });
}

Result<Outcome> run(const VesselsCommand& options, const Progress& progress) {
  vasculature::Clicks clicks;
  for (const std::string& seed : options.seeds) {
    const auto position = parse_position(seed, "--seed");
    if (!position) return failure(position.error());
    clicks.push_back({clicks.empty() ? Vessel::portal_vein : Vessel::hepatic_vein, *position});
  }
  for (const std::string& text : options.clicks) {
    const auto click = parse_click(text);
    if (!click) return failure(click.error());
    clicks.push_back(*click);
  }
  auto borders = parse_borders(options.borders);
  if (!borders) return failure(std::move(borders.error()));
  auto patient = casefile::Case::open(options.case_folder);
  if (!patient) return failure(patient.error());
  const auto trees = casefile::find_vessels(*patient, options.structure, {clicks, *borders}, progress);
  if (!trees) return failure(trees.error());
  return describe(*trees, patient->file_of(casefile::trees_id)->string());
}

}  // namespace

void add_vessels(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand("vessels",
                                         "Make trees of the case's vessels: centre lines, radii, branches; portal and "
                                         "hepatic veins told apart, arteries and "
                                         "bile ducts where they are outlined");
  auto options = std::make_shared<VesselsCommand>();
  command->add_option("case", options->case_folder, "The case")->required();
  command->add_option("--structure", options->structure,
                      "A structure that holds both systems (default: portal-vein and hepatic-vein, else vessels)");
  command
      ->add_option("--seed", options->seeds,
                   "X,Y,Z in mm (LPS) where the portal vein divides; a second one where the hepatic veins meet")
      ->allow_extra_args(false);
  command
      ->add_option("--click", options->clicks,
                   "VESSEL=X,Y,Z in mm (LPS): what the vessel there is; " + names_of_vessels())
      ->allow_extra_args(false);
  add_border_option(*command, options->borders);
  command->callback([&chosen, options] {
    if (options->seeds.size() > 2) throw CLI::ValidationError("--seed", "one for each system, the portal vein's first");
    chosen = [options](const Progress& progress) { return run(*options, progress); };
  });
}

}  // namespace glisson::cli

// glisson-cli territories CASE [--from tree|prior] [--couinaud] [--border V-VIII=X,Y,Z ...]: which tissue belongs to
// which branch.

#include <fmt/format.h>

#include "casefile/plans.h"
#include "casefile/vascular.h"
#include "command.h"
#include "shared_options.h"

namespace glisson::cli {
namespace {

struct TerritoriesCommand {
  std::string case_folder;
  std::string from = "tree";
  bool couinaud = false;
  std::vector<std::string> borders;
};

// Young's modulus, where the case has a map of it.
void add_stiffness(Json& json, const planning::Tissue& tissue) {
  if (!tissue.mean_kPa) return;
  json["mean_kPa"] = *tissue.mean_kPa;
  json["confident_share"] = tissue.confident_share;
}

Outcome describe(const casefile::FoundTerritories& found, const planning::Planner& planner, const std::string& file,
                 std::size_t borders, bool couinaud_only) {
  Json territories = Json::array(), segments = Json::array();
  std::string text;
  const auto stiffness = planner.segments();
  const auto tissue = planner.branches();
  std::vector<double> beyond_ml(found.trees.branches.size(), 0);
  for (std::size_t b = beyond_ml.size(); b-- > 0;) {  // children come after their parents
    beyond_ml[b] += tissue[b].ml;
    const int parent = found.trees.branches[b].parent;
    if (parent >= 0) beyond_ml[static_cast<std::size_t>(parent)] += beyond_ml[b];
  }
  if (!couinaud_only) {
    for (std::size_t b = 0; b < found.trees.branches.size(); ++b) {
      const vasculature::TreeBranch& branch = found.trees.branches[b];
      if (!vasculature::is_vein(branch.system)) continue;
      territories.push_back({{"id", b},
                             {"branch", branch.name},
                             {"system", vasculature::system_name(branch.system)},
                             {"volume_ml", tissue[b].ml},
                             {"with_branches_ml", beyond_ml[b]}});
      add_stiffness(territories.back(), tissue[b]);
    }
  }
  for (std::size_t s = 1; s <= 8; ++s) {
    const double ml = found.couinaud.volume_ml[s], confidence = found.couinaud.confidence[s];
    segments.push_back({{"number", s}, {"volume_ml", ml}, {"confidence", confidence}});
    add_stiffness(segments.back(), stiffness.at(s));
    text += fmt::format("{:>4}: {:6.1f} ml, {:4.1f} %, confidence {:.2f}{}\n", vasculature::segment_name(s), ml,
                        found.couinaud.volume_ml[0] > 0 ? 100 * ml / found.couinaud.volume_ml[0] : 0, confidence,
                        stiffness.at(s).mean_kPa ? fmt::format(", {:.1f} kPa", *stiffness.at(s).mean_kPa) : "");
  }
  const bool by_shape = found.couinaud.from == vasculature::SegmentsFrom::shape;
  text += fmt::format(
      "By the liver's shape {}{}.\n", by_shape ? "alone" : "and its vessels",
      borders > 0 ? fmt::format(", and {} place{} on borders set by hand", borders, borders > 1 ? "s" : "") : "");
  return {{{"from", by_shape ? "prior" : "tree"},
           {"territories", std::move(territories)},
           {"segments", std::move(segments)},
           {"file", file}},
          std::move(text)};
}

Result<Outcome> run(const TerritoriesCommand& options, const Progress& progress) {
  const auto borders = parse_borders(options.borders);
  if (!borders) return failure(borders.error());
  auto patient = casefile::Case::open(options.case_folder);
  if (!patient) return failure(patient.error());
  const auto by = options.from == "prior" ? casefile::SegmentsBy::shape : casefile::SegmentsBy::trees;
  const auto found = casefile::find_territories(*patient, by, *borders, progress.part(0, 0.8));
  if (!found) return failure(found.error());
  const auto opened = casefile::open_planner(*patient, *found, progress.part(0.8, 1));
  if (!opened) return failure(opened.error());
  return describe(*found, opened->planner, patient->file_of("territories/couinaud")->string(),
                  borders->size() + found->trees.borders.size(), options.couinaud);
}

}  // namespace

void add_territories(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand(
      "territories", "Tell which tissue belongs to which branch, and part the liver into Couinaud's eight segments");
  auto options = std::make_shared<TerritoriesCommand>();
  command->add_option("case", options->case_folder, "The case")->required();
  command
      ->add_option("--from", options->from, "tree: the case's vessel trees (vessels); prior: the liver's shape alone")
      ->capture_default_str()
      ->check(CLI::IsMember({"tree", "prior"}));
  command->add_flag("--couinaud", options->couinaud, "The eight segments alone, no territories of branches");
  add_border_option(*command, options->borders);
  command->callback([&chosen, options] {
    if (options->from == "tree" && !options->borders.empty()) {
      throw CLI::ValidationError("--border", "goes with --from prior; by trees, tell vessels of it");
    }
    chosen = [options](const Progress& progress) { return run(*options, progress); };
  });
}

}  // namespace glisson::cli

// glisson-cli compare DIR_A DIR_B: how far apart two results put the same points.

#include <fmt/format.h>

#include "casefile/result_folder.h"
#include "command.h"
#include "rehearsal/comparison.h"

namespace glisson::cli {
namespace {

Outcome describe(const rehearsal::Comparison& comparison, const std::array<mechanics::Validity, 2>& worth) {
  Outcome outcome{{{"mean_mm", comparison.mean_mm},
                   {"max_mm", comparison.max_mm},
                   {"significant", comparison.significant()},
                   {"landmarks", Json::array()}},
                  fmt::format("Mean {:.2f} mm, largest {:.2f} mm{}\n", comparison.mean_mm, comparison.max_mm,
                              comparison.significant() ? ": 5 mm or more, significant to a surgeon" : "")};
  if (comparison.max_near_tool_mm) {
    outcome.document["max_near_tool_mm"] = *comparison.max_near_tool_mm;
  } else {
    outcome.document["max_near_tool_reason"] = "neither result has a tool";
  }
  for (const auto& landmark : comparison.landmarks) {
    outcome.document["landmarks"].push_back({{"id", landmark.id},
                                             {"displacement_a_mm", landmark.displacement_a_mm},
                                             {"displacement_b_mm", landmark.displacement_b_mm},
                                             {"difference_mm", landmark.difference_mm},
                                             {"significant", landmark.significant()}});
    outcome.text += fmt::format("  {:24} {:7.2f} mm{}\n", landmark.id, landmark.difference_mm,
                                landmark.significant() ? "  >= 5 mm" : "");
  }
  outcome.document["states"] = Json::array();
  for (std::size_t k = 0; k < worth.size(); ++k) {
    outcome.document["states"].push_back({{"state", to_string(worth[k].state())},
                                          {"largest_strain", worth[k].largest_strain},
                                          {"inverted_cells", worth[k].inverted_cells}});
    outcome.text += fmt::format("{}: {}\n", k == 0 ? "A" : "B", worth[k].sentence().message());
  }
  return outcome;
}

}  // namespace

void add_compare(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand("compare", "Distance between two results' landmarks and surfaces");
  auto folders = std::make_shared<std::pair<std::string, std::string>>();
  command->add_option("a", folders->first, "Result folder")->required();
  command->add_option("b", folders->second, "Result folder")->required();
  command->callback([&chosen, folders] {
    chosen = [folders](const Progress&) -> Result<Outcome> {
      const auto a = casefile::read_result(folders->first);
      if (!a) return failure(a.error());
      const auto b = casefile::read_result(folders->second);
      if (!b) return failure(b.error());
      return rehearsal::compare(*a, *b).map([&](const rehearsal::Comparison& comparison) {
        return describe(comparison, {a->validity, b->validity});
      });
    };
  });
}

}  // namespace glisson::cli

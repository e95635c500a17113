#include "cohort_options.h"

#include <fmt/format.h>
#include <filesystem>
#include <string_view>

#include "base/text.h"
#include "studies/dissertation/cohort.h"

namespace glisson::cli {
namespace {

// "3/20"
studies::BatchPart chunk_of(std::string_view text) {
  studies::BatchPart part;
  const std::size_t slash = text.find('/');
  if (slash != std::string_view::npos) {
    part.chunk = read_whole_number<int>(text.substr(0, slash)).value_or(0);
    part.chunks = read_whole_number<int>(text.substr(slash + 1)).value_or(0);
  }
  if (part.chunk < 1 || part.chunk > part.chunks || part.chunks > 100000)
    throw CLI::ValidationError("--chunk", "K/N, as 3/20: K from 1 to N, N at most 100000");
  return part;
}

}  // namespace

void add_cohort_options(CLI::App& command, CohortChoice& choice) {
  CLI::Option* folder =
      command.add_option("folder", choice.folder, "Folder with stiffness maps or cases (NAME.glisson)");
  command.add_option("--out", choice.out, "Folder for the rows, the table, the summary and the report")->required();
  command.add_option("--simulated", choice.simulated, "Instead of a folder: a SIMULATED cohort of so many patients")
      ->check(CLI::Range(1, 100000))
      ->excludes(folder);
  command.add_option("--seed", choice.seed, "Of what is simulated")->capture_default_str();
  CLI::Option* patient =
      command.add_option("--patient", choice.part.patient, "Compute this patient alone: one job of many");
  command
      .add_option_function<std::string>(
          "--chunk", [&choice](const std::string& text) { choice.part = chunk_of(text); },
          "Compute the K-th of N equal runs of patients, into one file: one job of many")
      ->type_name("K/N")
      ->excludes(patient);
  command.add_flag("--list", choice.list, "Compute nothing: name the patients");
}

Result<std::string> folder_of(const CohortChoice& choice) {
  if (choice.simulated > 0) {
    const std::string folder = (std::filesystem::path(choice.out) / "simulated").string();
    return studies::write_simulated_cohort(folder, choice.simulated, choice.seed).map([&] { return folder; });
  }
  if (choice.folder.empty()) {
    return failure("cohort-no-folder", GLISSON_TEXT("Name the cohort's folder, or ask for a simulated one with "
                                                    "--simulated N."));
  }
  return choice.folder;
}

Result<Outcome> list_patients(const std::string& folder) {
  return studies::cohort_patients(folder).map([](const std::vector<std::string>& ids) {
    Outcome outcome{{{"ids", ids}}, {}};
    for (const std::string& id : ids) outcome.text += id + "\n";
    return outcome;
  });
}

void add_rows(const std::vector<studies::BatchRow>& rows, Outcome& outcome) {
  outcome.document["rows"] = Json::array();
  for (const studies::BatchRow& row : rows) {
    Json json{{"patient", row.id}};
    for (const auto& [name, value] : row.values) json[name] = value;
    if (!row.error.empty()) {
      json["error"] = row.error;
      outcome.text += fmt::format("  {}: {}\n", row.id, row.error);
    }
    outcome.document["rows"].push_back(std::move(json));
  }
}

}  // namespace glisson::cli

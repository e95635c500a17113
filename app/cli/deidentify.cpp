// glisson-cli deidentify PATH --out PATH: copies of DICOM files that say nothing of the patient.

#include "imaging/deidentify.h"

#include <fmt/format.h>

#include "command.h"
#include "shared_options.h"

namespace glisson::cli {
namespace {

Outcome describe_deidentify(const imaging::DeidentifyResult& result) {
  Outcome outcome{{{"files", Json::array()},
                   {"removed", Json::object()},
                   {"warnings", result.warnings},
                   {"skipped", Json::array()}},
                  fmt::format("{} files written\n", result.files.size())};
  for (const auto& file : result.files) outcome.document["files"].push_back(file.string());
  for (const auto& [attribute, count] : result.removed) {
    outcome.document["removed"][attribute] = count;
    outcome.text += fmt::format("  {:32} {} times removed or replaced\n", attribute, count);
  }
  for (const auto& file : result.skipped) {
    outcome.document["skipped"].push_back({{"file", file.path.string()}, {"reason", file.reason}});
    outcome.text += fmt::format("skipped: {}\n", file.reason);
  }
  outcome.text += bullet_list(result.warnings);
  return outcome;
}

}  // namespace

void add_deidentify(CLI::App& app, Action& chosen) {
  CLI::App* command =
      app.add_subcommand("deidentify",
                         "Copy DICOM files without what names the patient: the basic confidentiality profile of "
                         "DICOM PS3.15 with its options Clean Descriptors (a series is described by its "
                         "role) and Retain Safe Private (three numbers that elastography needs)");
  auto path = std::make_shared<std::string>();
  auto out = std::make_shared<std::string>();
  auto options = std::make_shared<imaging::DeidentifyOptions>();
  command->add_option("path", *path, "Folder or file")->required();
  command->add_option("--out", *out, "Folder for the copies")->required();
  command->add_option("--key", options->key,
                      "Secret that the new identifiers follow from, to be used again for the same patients");
  command->callback([&chosen, path, out, options] {
    chosen = [path, out, options](const Progress& progress) {
      return imaging::deidentify(*path, *out, *options, progress).map(describe_deidentify);
    };
  });
}

}  // namespace glisson::cli

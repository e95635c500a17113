// glisson-cli export CASE --format F --out PATH: a case's contents for other programs.

#include <fmt/format.h>

#include "casefile/export.h"
#include "casefile/sofa.h"
#include "command.h"
#include "mechanics/scenario/scenario_file.h"
#include "shared_options.h"

namespace glisson::cli {
namespace {

Outcome describe(const std::vector<std::filesystem::path>& files, const std::vector<std::string>& remarks) {
  Outcome outcome{{{"files", Json::array()}, {"notes", remarks}}, {}};
  for (const auto& file : files) {
    outcome.document["files"].push_back(file.string());
    outcome.text += file.string() + "\n";
  }
  outcome.text += bullet_list(remarks);
  return outcome;
}

constexpr const char* sofa_format = "sofa";

Result<Outcome> write_sofa(const casefile::Case& patient, const std::optional<std::string>& scenario_file,
                           const std::filesystem::path& out, const Progress& progress) {
  std::optional<mechanics::Scenario> scenario;
  if (scenario_file) {
    auto read = mechanics::read_scenario(*scenario_file);
    if (!read) return failure(std::move(read.error()));
    scenario = *std::move(read);
  }
  return casefile::export_sofa(patient, std::move(scenario), out, progress)
      .map([](const casefile::SofaExport& written) { return describe(written.files, messages(written.remarks)); })
      .map_error([&](const Error& error) {
        return scenario_file && error.file.empty() ? Error(error).in_file(*scenario_file) : error;
      });
}

}  // namespace

void add_export(CLI::App& app, Action& chosen) {
  CLI::App* command =
      app.add_subcommand("export", "Write a case's images, labels, surfaces, mesh or model for other programs");
  auto case_folder = std::make_shared<std::string>();
  auto format = std::make_shared<std::string>();
  auto out = std::make_shared<std::string>();
  auto study = std::make_shared<std::optional<std::string>>();
  auto plan = std::make_shared<std::optional<std::string>>();
  auto scenario = std::make_shared<std::optional<std::string>>();
  command->add_option("case", *case_folder, "The case")->required();
  command->add_option("--format", *format, "nrrd, nifti, stl, obj, vtp, sofa (a folder); dicom-seg, vtu (a file)")
      ->required()
      ->check([](const std::string& name) {
        return casefile::export_format(name) || name == sofa_format
                   ? std::string()
                   : "one of nrrd, nifti, dicom-seg, stl, obj, vtp, vtu, sofa";
      });
  command->add_option("--out", *out, "File or folder to write")->required();
  command->add_option("--study", *study,
                      "dicom-seg: the images that the case was made from; the file then carries the patient's name and "
                      "number and names each slice, so that an archive can put it to them");
  command->add_option("--plan", *plan, "dicom-seg: a plan of the case, whose remnant and specimen go along");
  command->add_option("--scenario", *scenario,
                      "sofa: supports, loads and landmarks (JSON); without it, segment VI is hoisted");
  command->callback([&chosen, case_folder, format, out, study, plan, scenario] {
    chosen = [=](const Progress& progress) -> Result<Outcome> {
      const auto patient = casefile::Case::open(*case_folder);
      if (!patient) return failure(patient.error());
      if ((*study || *plan) && *format != "dicom-seg") {
        return failure("export-study-unused",
                       GLISSON_TEXT("--study and --plan serve a DICOM SEG alone (--format dicom-seg)."));
      }
      if (*scenario && *format != sofa_format) {
        return failure("export-scenario-unused",
                       GLISSON_TEXT("--scenario serves a scene for SOFA alone (--format sofa)."));
      }
      if (*format == sofa_format) return write_sofa(*patient, *scenario, *out, progress);
      const auto wanted = *casefile::export_format(*format);
      return casefile::export_case(*patient, wanted, *out, progress, {*study, *plan}).map([&](const auto& files) {
        return describe(files, messages(casefile::export_remarks(*patient, wanted)));
      });
    };
  });
}

}  // namespace glisson::cli

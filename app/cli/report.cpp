// glisson-cli report CASE --out FILE.html: one page of what was done for a patient.

#include "command.h"
#include "report/html.h"
#include "report/patient_page.h"

namespace glisson::cli {
namespace {

struct ReportCommand {
  std::string case_folder;
  std::string out;
  std::string name;
};

Result<Outcome> run(const ReportCommand& command, const Progress& progress) {
  const auto patient = casefile::Case::open(command.case_folder);
  if (!patient) return failure(patient.error());
  report::PatientPageContent content;
  if (!command.name.empty()) content.name = command.name;
  const auto page = report::patient_page(*patient, content, progress);
  if (!page) return failure(page.error());
  if (auto written = report::write_html(command.out, *page); !written) return failure(std::move(written.error()));
  return Outcome{{{"file", command.out}, {"name_shown", content.name.has_value()}}, command.out + "\n"};
}

}  // namespace

void add_report(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand("report", "Write one page of what was done for a patient");
  auto settings = std::make_shared<ReportCommand>();
  command->add_option("case", settings->case_folder, "The case")->required();
  command->add_option("--out", settings->out, "HTML file to write")->required();
  command->add_option("--name", settings->name, "The patient's name, which the page otherwise withholds");
  command->callback(
      [&chosen, settings] { chosen = [settings](const Progress& progress) { return run(*settings, progress); }; });
}

}  // namespace glisson::cli

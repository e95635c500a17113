// glisson-cli growth BEFORE AFTER [--plan NAME] [--days N] --out DIR: two studies of one patient, segment by segment.

#include <fmt/format.h>

#include "casefile/growth.h"
#include "command.h"
#include "report/growth.h"
#include "report/growth_page.h"
#include "vasculature/couinaud.h"

namespace glisson::cli {
namespace {

struct GrowthCommand {
  std::string before, after, out;
  casefile::GrowthQuestion question;
  bool same_patient = false;
};

std::string in_words(const casefile::ComparedStudies& compared, const std::vector<Sentence>& said) {
  std::string text;
  const auto line = [&](const std::string& name, const planning::PartGrowth& part) {
    const auto kPa = [](const planning::Tissue& tissue) {
      return tissue.mean_kPa ? fmt::format("{:.1f}", *tissue.mean_kPa) : std::string("-");
    };
    const auto change = part.change_percent();
    text += fmt::format("{:>8}: {:7.1f} ml, {:7.1f} ml before, {}{}, {:.1f} %, {:.1f} % before", name, part.after.ml,
                        part.before.ml, part.within_error ? "~" : "",
                        change ? fmt::format("{:+.1f} %", *change) : std::string("new"), part.after_percent,
                        part.before_percent);
    if (part.before.mean_kPa || part.after.mean_kPa) {
      text += fmt::format("; {} kPa, {} before", kPa(part.after), kPa(part.before));
    }
    text += "\n";
  };
  for (const planning::SegmentGrowth& segment : compared.growth.segments) {
    line(vasculature::segment_name(static_cast<std::size_t>(segment.number)), segment.part);
  }
  if (compared.growth.remnant) line("remnant", compared.growth.remnant->part);
  line("liver", compared.growth.liver);
  for (const Sentence& sentence : said) text += "- " + sentence.message() + "\n";
  return text;
}

Result<Outcome> run(const GrowthCommand& options, const Progress& progress) {
  const auto before = casefile::Case::open(options.before);
  if (!before) return failure(before.error());
  const auto after = casefile::Case::open(options.after);
  if (!after) return failure(after.error());
  const auto compared = casefile::compare_studies(*before, *after, options.question, progress);
  if (!compared) return failure(compared.error());
  const std::string origin = before->origin().empty() ? after->origin() : before->origin();
  Outcome outcome{report::growth_json(*compared), in_words(*compared, report::growth_sentences(*compared))};
  const auto files = report::write_growth(options.out, *compared, origin);
  if (!files) return failure(files.error());
  for (const std::filesystem::path& file : *files) {
    outcome.document["files"].push_back(file.string());
    outcome.text += file.string() + "\n";
  }
  return outcome;
}

}  // namespace

void add_growth(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand(
      "growth", "Compare two studies of one patient, as before and after an embolisation: what grew, by how much");
  auto options = std::make_shared<GrowthCommand>();
  command->add_option("before", options->before, "The case of the earlier study, with its segments")->required();
  command->add_option("after", options->after, "The case of the later study, with its segments")->required();
  command->add_option("--out", options->out, "Folder for growth.json, growth.csv and growth.html")->required();
  command->add_option("--plan", options->question.plan,
                      "The plan whose remnant is followed: each case's own of that name; one by segments or "
                      "territories may stand in one case alone");
  command
      ->add_option("--days", options->question.options.days,
                   "Days between the studies, where their images have no dates")
      ->check(CLI::Range(0.5, 36525.0));
  command
      ->add_option("--standard-liver-ml", options->question.options.standard_liver_ml,
                   "The liver's standard volume, of which the per cent are in both studies: from body size "
                   "-794.41 + 1267.28 x body surface in m2 (Vauthey et al. 2002); without it each study's own liver")
      ->check(CLI::Range(1.0, 10000.0));
  command->add_flag("--same-patient", options->same_patient,
                    "The images name two patients, and they are of one all the same");
  command->callback([&chosen, options] {
    using Patients = casefile::GrowthQuestion::Patients;
    options->question.patients = options->same_patient ? Patients::one : Patients::as_images_say;
    chosen = [options](const Progress& progress) { return run(*options, progress); };
  });
}

}  // namespace glisson::cli

// glisson-cli accept CASE [MODEL.json] [--effect KIND ...] [--of-this-patient] [--take-back]: what explain found
// becomes part of the organ that is rehearsed, or ceases to be.

#include "casefile/evidence.h"
#include "casefile/model.h"
#include "command.h"
#include "evidence_answer.h"

namespace glisson::cli {
namespace {

struct AcceptCommand {
  std::string case_folder;
  std::string model;
  std::vector<std::string> kinds;
  bool of_this_patient = false;
  bool take_back = false;
};

Result<Outcome> run(const AcceptCommand& options) {
  auto patient = casefile::Case::open(options.case_folder);
  if (!patient) return failure(patient.error());
  const auto evidence = options.take_back ? casefile::take_back_evidence(*patient, options.kinds)
                        : !options.model.empty()
                            ? casefile::accept_evidence(*patient, options.model, options.kinds,
                                                        options.of_this_patient ? casefile::Tissue::told_by_person
                                                                                : casefile::Tissue::shown_by_file)
                            : casefile::read_model(*patient).map([](const auto& model) { return model.evidence; });
  if (!evidence) return failure(evidence.error());
  Outcome outcome{evidence_json(*evidence), evidence_text(*evidence)};
  if (evidence->effects.empty()) outcome.text = "No evidence: the organ is as elastography says.\n";
  return outcome;
}

}  // namespace

void add_accept(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand(
      "accept", "Take what explain found into a case's model, so that rehearsals have it, or take it back");
  auto options = std::make_shared<AcceptCommand>();
  command->add_option("case", options->case_folder, "The case")->required();
  CLI::Option* model = command->add_option(
      "model", options->model, "Better model (model.json of explain); without: what was accepted is listed");
  CLI::Option* kinds =
      command->add_option("--effect", options->kinds, "Only the effect of this kind (several may be given)");
  command->add_flag("--of-this-patient", options->of_this_patient,
                    "The specimen is tissue of this patient, though neither its place nor its title shows it");
  CLI::Option* take_back = command->add_flag("--take-back", options->take_back, "Take back what was accepted");
  take_back->excludes(model);
  command->callback([&chosen, options, kinds] {
    if (kinds->count() > 0 && options->model.empty() && !options->take_back) {
      throw CLI::RequiredError("a model or --take-back");
    }
    chosen = [options](const Progress&) { return run(*options); };
  });
}

}  // namespace glisson::cli

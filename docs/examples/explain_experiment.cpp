// What does a model lack that measurements show?
//
//   explain_experiment resources/examples/tissue/experiment.json OUT
//
// Prints the verdict and its evidence, and leaves report.html and the better model in OUT.

#include "closedloop/explain.h"
#include "closedloop/explanation_file.h"
#include "or_stop.h"
#include "report/explanation_folder.h"

using namespace glisson;

int main(int count, char** words) {
  if (count != 3) {
    fmt::print(stderr, "usage: explain_experiment EXPERIMENT.json OUT\n");
    return 2;
  }
  const auto explained = or_stop(closedloop::explain(words[1]));
  const closedloop::Explanation& found = explained.explanation;
  const std::string& unit = explained.model->observations().unit;

  fmt::print("{}: the declared model is off by {:.2f} {}, the better one by {:.2f}, noise is {:.2f}.\n",
             closedloop::name_of(found.verdict), found.before.rms, unit, found.after.rms, found.after.noise);
  if (found.held_out)
    fmt::print("Trials that a fit never saw: {:.2f} {} ({:.2f} to {:.2f}).\n", found.held_out->rms, unit,
               found.held_out->low, found.held_out->high);
  for (const auto& effect : found.effects) {
    fmt::print("{}: {}\n", effect.kind, effect.sentence);
    for (const auto& each : effect.parameters)
      fmt::print("    {} = {:.3g} (95 %: {:.3g} to {:.3g})\n", each.parameter.name, each.value, each.low, each.high);
    for (const auto& kind : effect.alike) fmt::print("    these data cannot tell it from {}\n", kind);
  }
  for (const Sentence& note : found.notes) fmt::print("- {}\n", note.message());
  or_stop(report::write_explanation(words[2], explained));
}

#include "report/explanation_page.h"

#include <fmt/format.h>
#include <utility>

#include "closedloop/inference/posterior.h"
#include "report/explanation_pictures.h"

namespace glisson::report {
namespace {

using closedloop::Explanation;
using closedloop::Observations;
using closedloop::Verdict;

std::string unit_of(const Observations& observations) {
  return observations.unit == "noise" ? "× noise" : observations.unit;
}

std::string figure(double value) { return fmt::format("{:.3g}", value); }

std::string answer(const Explanation& explanation) {
  switch (explanation.verdict) {
    case Verdict::nothing_missing:
      return "Nothing is missing: what the declared model leaves is noise, and nothing was added to it.";
    case Verdict::explained:
      return "Explained: with the effects below, what is left is as small as the noise of the measurement.";
    default:
      if (explanation.evidence_over_smooth)
        return "Unexplained: known effects can be bent until what is left is noise, but a smooth function of what was "
               "done, which has no cause, accounts for it about as well. What is named below is not a cause that these "
               "data establish.";
      return "Unexplained: no combination of known effects brings the error near the noise. What is named below "
             "removes "
             "a part of it and is not a cause that these data establish.";
  }
}

Table errors_table(const Explanation& explanation, const Observations& observations);
Table effects_table(const Explanation& explanation);
Table candidates_table(const Explanation& explanation, const Observations& observations);
Table visible_table(const Explanation& explanation);
std::string shape_sentence(const closedloop::ResidualDiagnostics& diagnostics);

}  // namespace

Page explanation_page(const Explanation& explanation, const Observations& observations, const std::string& title) {
  Page page;
  page.title = title;
  page.subtitle = "What the declared model lacks, by the measurements";
  page.blocks.push_back(Paragraph{answer(explanation)});
  if (!explanation.posterior.empty()) {
    page.blocks.push_back(Paragraph{posterior_sentence(explanation)});
    page.blocks.push_back(DrawingRow{{probability_bars(explanation.posterior)}});
    page.blocks.push_back(Paragraph{
        "A probability weighs how well an explanation predicts what was measured, whatever the size of its "
        "effects, against how common it is taken to be before anything is measured. \"Something else\" "
        "stands for every cause that is not in the catalogue. These probabilities are not calibrated: of explanations "
        "given 90 % and more, three in four were right where the answer was known. Read them as an order."});
  }
  page.blocks.push_back(errors_table(explanation, observations));
  if (!explanation.smallest_visible.empty()) {
    page.blocks.push_back(Heading{"What these trials could have shown"});
    page.blocks.push_back(visible_table(explanation));
  }
  page.blocks.push_back(Heading{"Before"});
  page.blocks.push_back(Paragraph{shape_sentence(explanation.residual_before)});
  page.blocks.push_back(DrawingRow{explanation_pictures(explanation, observations)});
  if (!explanation.effects.empty()) {
    page.blocks.push_back(Heading{"What was found"});
    for (const auto& effect : explanation.effects)
      page.blocks.push_back(Paragraph{effect.kind + ": " + effect.sentence});
    page.blocks.push_back(effects_table(explanation));
  }
  if (explanation.smooth_correction)
    page.blocks.push_back(
        Paragraph{"A smooth correction over load and place predicts trials better that it was not "
                  "fitted to. It claims no cause."});
  if (!explanation.ranking.empty()) {
    page.blocks.push_back(Heading{"Candidates, each by itself"});
    page.blocks.push_back(candidates_table(explanation, observations));
  }
  page.blocks.push_back(Heading{"After"});
  page.blocks.push_back(Paragraph{shape_sentence(explanation.residual_after)});
  page.blocks.push_back(Heading{"What to measure next"});
  if (explanation.next) {
    std::string alternatives;
    for (const auto& kind : explanation.next->alternatives) alternatives += (alternatives.empty() ? "" : ", ") + kind;
    page.blocks.push_back(Paragraph{
        fmt::format("{} Expected to tell what was found from {}: the predictions are {:.0f} standard deviations "
                    "of the noise apart.",
                    explanation.next->sentence.message(), alternatives, explanation.next->expected_separation)});
  } else {
    page.blocks.push_back(
        Paragraph{"No further trial is needed to tell the leading explanations apart, or none is "
                  "known that would."});
  }
  for (const Sentence& note : explanation.notes) page.blocks.push_back(Paragraph{note.message()});
  page.footer = "Glisson plans and reviews liver surgery. Not a medical device.";
  return page;
}

namespace {

std::string shape_sentence(const closedloop::ResidualDiagnostics& diagnostics) {
  if (diagnostics.is_noise) return "What is left is noise: no test finds anything that noise would not do.";
  std::string sentence = "What is left is not noise: ";
  bool first = true;
  for (const std::string& feature : diagnostics.shape()) {
    sentence += (first ? "" : "; ") + feature;
    first = false;
  }
  return sentence + ".";
}

Table visible_table(const Explanation& explanation) {
  Table table{"From this value on, nine of ten such experiments would have shown the effect",
              {"effect", "parameter", "without effect", "seen from"},
              {}};
  for (const auto& one : explanation.smallest_visible)
    table.rows.push_back({{one.kind + (one.form.empty() ? "" : " (" + one.form + ")")},
                          {one.parameter + (one.component > 0 ? fmt::format(" {}", one.component) : "")},
                          {fmt::format("{:.4g}", one.no_effect)},
                          {one.value ? fmt::format("{:.4g}", *one.value) : "at no size in its range"}});
  return table;
}

Table errors_table(const Explanation& explanation, const Observations& observations) {
  Table table{fmt::format("Errors ({})", unit_of(observations)), {"", "before", "after"}, {}};
  const auto row = [&](std::string name, double before, double after) {
    table.rows.push_back({{std::move(name)}, {figure(before)}, {figure(after)}});
  };
  row("root mean square, trials that were fitted", explanation.before.rms, explanation.after.rms);
  row("mean", explanation.before.mean, explanation.after.mean);
  row("95 of 100 are below", explanation.before.p95, explanation.after.p95);
  row("chi-squared over number", explanation.before.reduced_chi2, explanation.after.reduced_chi2);
  if (explanation.held_out && explanation.held_out_before) {
    const auto& after = explanation.held_out_corrected ? *explanation.held_out_corrected : *explanation.held_out;
    table.rows.push_back({{"root mean square, trials left out whole"},
                          {fmt::format("{:.3g} ({:.3g} to {:.3g})", explanation.held_out_before->rms,
                                       explanation.held_out_before->low, explanation.held_out_before->high)},
                          {fmt::format("{:.3g} ({:.3g} to {:.3g})", after.rms, after.low, after.high)}});
  }
  if (explanation.hidden_targets) {
    row("hidden targets, which nothing was fitted to: mean (mm)", explanation.hidden_targets->before.mean,
        explanation.hidden_targets->after.mean);
    row("hidden targets: the farthest (mm)", explanation.hidden_targets->before.max,
        explanation.hidden_targets->after.max);
  }
  table.rows.push_back(
      {{"noise of the measurement"}, {figure(explanation.before.noise)}, {figure(explanation.after.noise)}});
  return table;
}

Table effects_table(const Explanation& explanation) {
  Table table{"Parameters, with standard deviation and 95 % interval",
              {"effect", "parameter", "value", "±", "from", "to", "could also be"},
              {}};
  for (const auto& effect : explanation.effects) {
    std::string alike;
    for (const std::string& kind : effect.alike) alike += (alike.empty() ? "" : ", ") + kind;
    const std::string name = effect.kind + (effect.form.empty() ? "" : " (" + effect.form + ")");
    if (effect.parameters.empty()) table.rows.push_back({{name}, {""}, {""}, {""}, {""}, {""}, {alike}});
    for (const auto& found : effect.parameters) {
      table.rows.push_back({{name},
                            {found.parameter.name},
                            {fmt::format("{:.4g}", found.value)},
                            {found.determined ? figure(found.std) : "not determined"},
                            {figure(found.low)},
                            {figure(found.high)},
                            {alike}});
    }
  }
  return table;
}

Table candidates_table(const Explanation& explanation, const Observations& observations) {
  Table table{fmt::format("Errors in {}; the lower the BIC, the better", unit_of(observations)),
              {"effect", "error fitted", "error on trials left out", "change of BIC", "remark"},
              {}};
  for (const auto& candidate : explanation.ranking) {
    const std::string name = candidate.kind + (candidate.form.empty() ? "" : " (" + candidate.form + ")");
    if (!candidate.removed.empty()) {
      table.rows.push_back({{name}, {""}, {""}, {""}, {"left out: " + candidate.removed}});
      continue;
    }
    std::string alike;
    for (const std::string& kind : candidate.alike) alike += (alike.empty() ? "like " : ", ") + kind;
    table.rows.push_back({{name},
                          {figure(candidate.rms)},
                          {candidate.held_out_rms ? figure(*candidate.held_out_rms) : "-"},
                          {fmt::format("{:.0f}", candidate.delta_bic)},
                          {alike}});
  }
  return table;
}

}  // namespace
}  // namespace glisson::report

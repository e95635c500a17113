// glisson-cli plan CASE (--list | --answer PLAN.json [--out DIR] | --add PLAN.json | --compare [--rank-by BY]
// [--embolise BRANCH] [--out DIR] | --drop NAME): resection plans by anatomy.

#include <fmt/format.h>
#include <iterator>
#include <utility>

#include "base/write_file.h"
#include "casefile/plans.h"
#include "casefile/vascular.h"
#include "command.h"
#include "planning/plan_file.h"
#include "planning/ranking.h"
#include "planning/two_stage.h"
#include "report/html.h"
#include "report/plan_comparison.h"

namespace glisson::cli {
namespace {

struct PlanCommand {
  std::string case_folder;
  bool list = false, compare = false;
  std::optional<std::string> answer, add, drop, out, rank_by;
  std::optional<double> body_weight_kg;
  std::vector<std::string> embolised;
  double growth_percent = planning::mean_growth_percent;
};

Json json_of_plan(const casefile::KeptPlan& kept, const Json& answer) {
  Json json{{"id", kept.id.substr(kept.id.find('/') + 1)}, {"name", kept.plan.name}};
  json["cuts"] = planning::plan_json(kept.plan).at("cuts");
  json.update(answer);
  json["current"] = kept.remarks.empty();
  if (!kept.remarks.empty()) json["remarks"] = messages(kept.remarks);
  return json;
}

std::string in_words(const Json& plan) {
  const auto number = [&](const char* key) { return plan.value(key, 0.0); };
  std::string text = fmt::format("{}: removes {:.0f} ml, leaves {:.0f} ml ({:.1f} % of the liver without tumours)\n",
                                 plan.at("name").get<std::string>(), number("removed_ml"), number("remnant_ml"),
                                 number("remnant_percent"));
  if (plan.contains("ablated_ml")) text += fmt::format("  of it {:.0f} ml are ablated\n", number("ablated_ml"));
  if (plan.contains("living_ml")) {
    text += fmt::format("  perfused and drained {:.0f} ml, ischaemic {:.0f} ml, congested {:.0f} ml\n",
                        number("living_ml"), number("ischaemic_ml"), number("congested_ml"));
  }
  if (plan.contains("living_percent_of_body_weight")) {
    text += fmt::format("  what lives is {:.2f} % of the body's weight\n", number("living_percent_of_body_weight"));
  }
  if (plan.contains("after_embolisation")) {
    const Json& after = plan.at("after_embolisation");
    text += fmt::format(
        "  embolised before: {:.0f} ml shrink, {:.0f} ml of what stays grow to {:.0f} ml ({:.1f} % of the liver "
        "without "
        "tumours), if by {:.1f} %\n",
        after.at("embolised_ml").get<double>(), after.at("grows_ml").get<double>(), after.at("grown_ml").get<double>(),
        after.at("grown_percent").get<double>(), after.at("growth_percent").get<double>());
    if (after.at("embolised_left_ml").get<double>() >= 0.5) {
      text += fmt::format("  of what is embolised {:.0f} ml stay in the patient, not counted\n",
                          after.at("embolised_left_ml").get<double>());
    }
  }
  if (plan.contains("margin_mm")) {
    text += fmt::format("  smallest margin {}{:.1f} mm\n", plan.value("margin_is_at_least", false) ? "at least " : "",
                        number("margin_mm"));
  }
  if (plan.contains("mean_kPa")) {
    text += fmt::format("  what is left {:.1f} kPa on average, {:.0f} % of it measured\n", number("mean_kPa"),
                        100 * number("confident_share"));
  }
  for (const Json& tumour : plan.value("tumours", Json::array())) {
    if (tumour.at("side") == "removed") continue;
    text += fmt::format("  {} is {}\n", tumour.at("name").get<std::string>(),
                        tumour.at("side") == "left" ? "left in the patient" : "cut through");
  }
  for (const Json& branch : plan.value("branches", Json::array())) {
    const auto told = planning::beyond_cut(branch);
    if (!told) continue;
    text += fmt::format("  cuts {:32} {:.1f} mm wide, {:.0f} {} hang on it, {:.0f} {} of them stay\n",
                        branch.at("name").get<std::string>(), 2 * branch.at("radius_mm").get<double>(), told->beyond,
                        told->unit, told->left, told->unit);
  }
  for (const Json& better : plan.value("beaten_by", Json::array())) {
    text += fmt::format("  {} is no worse in anything, and better\n", better.get<std::string>());
  }
  for (const Json& remark : plan.value("remarks", Json::array())) text += "- " + remark.get<std::string>() + "\n";
  return text;
}

Outcome outcome_of(const std::vector<Json>& plans, const std::vector<Sentence>& remarks) {
  Outcome outcome{{{"plans", plans}}, plans.empty() ? "The case has no plan.\n" : ""};
  for (const Json& plan : plans) outcome.text += in_words(plan);
  if (!remarks.empty()) outcome.document["remarks"] = messages(remarks);
  for (const Sentence& remark : remarks) outcome.text += "- " + remark.message() + "\n";
  return outcome;
}

// As they were answered when they were kept.
Result<Outcome> list(const casefile::Case& patient) {
  const auto plans = casefile::kept_plans(patient);
  if (!plans) return failure(plans.error());
  std::vector<Json> described;
  for (const casefile::KeptPlan& kept : *plans) {
    const auto answer = casefile::kept_answer(patient, kept.id);
    if (!answer) return failure(answer.error());
    described.push_back(json_of_plan(kept, *answer));
  }
  return outcome_of(described, {});
}

// With the case's territories, which are kept for the next time.
Result<casefile::OpenedPlanner> open(casefile::Case& patient, const Progress& progress) {
  if (patient.find("vessels/trees") != nullptr &&
      casefile::kept_territories(patient, casefile::SegmentsBy::trees) != casefile::Kept::current) {
    const auto found = casefile::find_territories(patient, casefile::SegmentsBy::trees, {}, progress.part(0, 0.6));
    if (!found) return failure(found.error());
  }
  return casefile::open_planner(patient, progress.part(0.6, 1));
}

Result<Outcome> add(casefile::Case& patient, const std::string& file, const Progress& progress) {
  const auto plan = planning::read_plan(file);
  if (!plan) return failure(plan.error());
  const auto opened = open(patient, progress);
  if (!opened) return failure(opened.error());
  const auto answer = opened->planner.answer(plan->cuts);
  if (!answer) {
    Error error = answer.error();
    error.file = file;
    return failure(std::move(error));
  }
  const auto id = casefile::keep_plan(patient, *plan, *answer, opened->planner.trees());
  if (!id) return failure(id.error());
  return outcome_of({json_of_plan({*id, *plan, {}}, planning::answer_json(*answer, opened->planner.trees()))},
                    opened->remarks);
}

// By what the case holds, which stays as it is.
Result<Outcome> answer_alone(const casefile::Case& patient, const PlanCommand& options, const Progress& progress) {
  const auto plan = planning::read_plan(*options.answer);
  if (!plan) return failure(plan.error());
  const auto opened = casefile::open_planner(patient, progress);
  if (!opened) return failure(opened.error());
  const auto answer = opened->planner.answer(plan->cuts);
  if (!answer) return failure(Error(answer.error()).in_file(*options.answer));
  Json described{{"name", plan->name}, {"cuts", planning::plan_json(*plan).at("cuts")}};
  described.update(planning::answer_json(*answer, opened->planner.trees()));
  if (options.out) {
    const std::filesystem::path file = std::filesystem::path(*options.out) / "answer.json";
    if (auto written = write_json_file(file, described); !written) return failure(std::move(written.error()));
  }
  return outcome_of({described}, opened->remarks);
}

// Of a body of that weight, the liver as heavy as water. At least 0.5 % is what many surgeons want of a healthy liver
// (Truant et al. 2007, J Am Coll Surg 204:22).
void add_share_of_body(Json& plan, double body_weight_kg) {
  for (const auto& [share, ml] : {std::pair{"remnant_percent_of_body_weight", "functional_remnant_ml"},
                                  std::pair{"living_percent_of_body_weight", "living_ml"}}) {
    if (plan.contains(ml)) plan[share] = plan.at(ml).get<double>() / (10 * body_weight_kg);
  }
}

// What the plan leaves after those portal branches were embolised; why not, where it cannot be said.
void add_embolisation(Json& plan, const planning::Planner& planner, const std::vector<planning::Cut>& cuts,
                      const PlanCommand& options) {
  const auto stages = planning::two_stages(planner, options.embolised, cuts, options.growth_percent);
  if (!stages) {
    plan["remarks"].push_back(stages.error().message());
    return;
  }
  plan["after_embolisation"] = {
      {"branches", options.embolised},         {"growth_percent", options.growth_percent},
      {"embolised_ml", stages->embolised_ml},  {"embolised_left_ml", stages->embolised_left_ml},
      {"grows_ml", stages->grows_ml},          {"grown_ml", stages->grown_ml},
      {"grown_percent", stages->grown_percent}};
}

struct Compared {
  Json described;
  std::optional<planning::PlanAnswer> answer;  // none where it no longer holds
};

// In the order that was asked for, each with the names of those that beat it; those that failed last.
std::vector<Json> put_in_order(const std::vector<Compared>& plans, const std::optional<std::string>& rank_by) {
  std::vector<planning::PlanAnswer> answers;
  std::vector<Json> ordered, failed;
  for (const Compared& plan : plans) {
    if (plan.answer) answers.push_back(*plan.answer);
    (plan.answer ? ordered : failed).push_back(plan.described);
  }
  const auto better = planning::beaten_by(answers);
  for (std::size_t n = 0; n < answers.size(); ++n) {
    Json& names = ordered[n]["beaten_by"] = Json::array();
    for (const std::size_t other : better[n]) names.push_back(ordered[other].at("name"));
  }
  if (const auto by = rank_by ? planning::rank_by(*rank_by) : std::nullopt) {
    const std::vector<Json> as_kept = std::exchange(ordered, {});
    for (const std::size_t n : planning::ranked(answers, *by)) ordered.push_back(as_kept[n]);
  }
  std::move(failed.begin(), failed.end(), std::back_inserter(ordered));
  return ordered;
}

Result<planning::Planner::Unrolled> answered(const planning::Planner& planner, const std::vector<planning::Cut>& cuts,
                                             bool with_resectograms) {
  if (with_resectograms) return planner.answer_unrolled(cuts);
  return planner.answer(cuts).map([](const planning::PlanAnswer& answer) {
    return planning::Planner::Unrolled{answer, {}};
  });
}

// All of them by what the case holds now.
Result<Outcome> compare(casefile::Case& patient, const PlanCommand& options, const Progress& progress) {
  const auto plans = casefile::kept_plans(patient);
  if (!plans) return failure(plans.error());
  if (plans->empty()) {
    return failure(Error{"plan-none",
                         GLISSON_TEXT("The case has no plan to compare."),
                         {},
                         GLISSON_TEXT("Add some first: glisson-cli plan CASE --add PLAN.json."),
                         patient.folder()});
  }
  const auto opened = open(patient, progress);
  if (!opened) return failure(opened.error());
  std::vector<Compared> compared;
  report::Page resectograms;  // those of all plans, for the end of the page
  for (const casefile::KeptPlan& kept : *plans) {
    const auto answer = answered(opened->planner, kept.plan.cuts, options.out.has_value());
    if (!answer) {  // a plan that no longer holds is no reason to keep the others back
      compared.push_back({json_of_plan(kept, Json{{"failed", answer.error().message()}}), std::nullopt});
      compared.back().described["remarks"].push_back(answer.error().message());
      continue;
    }
    const Json described = planning::answer_json(answer->answer, opened->planner.trees());
    compared.push_back({json_of_plan(kept, described), answer->answer});
    if (options.body_weight_kg) add_share_of_body(compared.back().described, *options.body_weight_kg);
    if (!options.embolised.empty()) {
      add_embolisation(compared.back().described, opened->planner, kept.plan.cuts, options);
    }
    report::add_resectograms(resectograms, kept.plan.name, answer->resectograms, {});
  }
  const std::vector<Json> described = put_in_order(compared, options.rank_by);
  Outcome outcome = outcome_of(described, opened->remarks);
  if (!options.out) return outcome;
  const std::filesystem::path folder = *options.out;
  report::Page page = report::plan_comparison(described, patient.origin(), opened->remarks);
  std::move(resectograms.blocks.begin(), resectograms.blocks.end(), std::back_inserter(page.blocks));
  auto written = write_together([&] {
    return report::write_html(folder / "plans.html", page).and_then([&] {
      return write_file(folder / "plans.csv", report::plan_table(described));
    });
  });
  if (!written) return failure(std::move(written.error()));
  outcome.document["files"] = {(folder / "plans.html").string(), (folder / "plans.csv").string()};
  outcome.text += (folder / "plans.html").string() + "\n" + (folder / "plans.csv").string() + "\n";
  return outcome;
}

Result<Outcome> run(const PlanCommand& options, const Progress& progress) {
  auto patient = casefile::Case::open(options.case_folder);
  if (!patient) return failure(patient.error());
  if (options.answer) return answer_alone(*patient, options, progress);
  if (options.add) return add(*patient, *options.add, progress);
  if (options.compare) return compare(*patient, options, progress);
  if (options.drop) {
    if (auto dropped = casefile::drop_plan(*patient, *options.drop); !dropped)
      return failure(std::move(dropped.error()));
  }
  return list(*patient);
}

}  // namespace

void add_plan(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand(
      "plan", "Keep resection plans in a case and compare them: what each takes, what lives after it, what it cuts");
  auto options = std::make_shared<PlanCommand>();
  command->add_option("case", options->case_folder, "The case")->required();
  CLI::Option_group* what = command->add_option_group("what");
  what->add_flag("--list", options->list, "The plans of the case, as they were answered when they were kept");
  what->add_option("--answer", options->answer, "PLAN.json: answer this plan and keep nothing");
  what->add_option("--add", options->add, "PLAN.json: answer this plan and keep it, in the place of one of its name");
  what->add_flag("--compare", options->compare, "All plans side by side, by what the case holds now");
  what->add_option("--drop", options->drop, "Take the plan of that name out of the case");
  what->require_option(1);
  command->add_option("--out", options->out,
                      "With --compare: folder for plans.html and plans.csv; with --answer: for answer.json");
  command->add_option("--rank-by", options->rank_by, "With --compare: the best first by margin, living or branches")
      ->check(CLI::IsMember({"margin", "living", "branches"}));
  command->add_option("--body-weight-kg", options->body_weight_kg, "With --compare: what is left, of the body's weight")
      ->check(CLI::Range(0.5, 500.0));
  command->add_option("--embolise", options->embolised,
                      "With --compare: a portal branch that is embolised before the cut (portal/right); what it feeds "
                      "shrinks, the rest grows. May be given again");
  command
      ->add_option("--growth-percent", options->growth_percent,
                   "With --embolise: by how much what keeps its portal inflow grows; on average of 44 studies 37.9 "
                   "(van Lienden et al. 2013)")
      ->capture_default_str()
      ->check(CLI::Range(0.0, planning::largest_growth_percent));
  command->callback([&chosen, options] {
    if (options->body_weight_kg && !options->compare) throw CLI::RequiresError("--body-weight-kg", "--compare");
    if (!options->embolised.empty() && !options->compare) throw CLI::RequiresError("--embolise", "--compare");
    if (options->rank_by && !options->compare) throw CLI::RequiresError("--rank-by", "--compare");
    if (options->out && !options->compare && !options->answer) {
      throw CLI::RequiresError("--out", "--compare or --answer");
    }
    chosen = [options](const Progress& progress) { return run(*options, progress); };
  });
}

}  // namespace glisson::cli

#include "studies/dissertation/internal/palpation_report.h"

#include <fmt/format.h>
#include <cmath>
#include <map>

#include "base/json.h"
#include "base/write_file.h"
#include "report/html.h"
#include "studies/dissertation/internal/palpation_specimen.h"
#include "studies/dissertation/validate_stiffness.h"

namespace glisson::studies {
namespace {

Json document_of(const PalpationSummary& summary, const PalpationOptions& options);
std::string verdict(const PalpationSummary& summary);
report::Table specimens_table();
report::Table compounds_table(const PalpationSummary& summary);
report::Table errors_table(const PalpationSummary& summary);
report::Table faults_table(const PalpationSummary& summary);
std::vector<report::Block> curves(const PalpationSummary& summary);

}  // namespace

Result<void> write_palpation(const std::filesystem::path& out, const PalpationSummary& summary,
                             const PalpationOptions& options) {
  report::Page page;
  page.title = "A phantom pressed: simulation on elastography against surface scans";
  page.subtitle = "Dissertation, section 4.5, tables 4.2 to 4.4";
  if (summary.simulated_scans)
    page.warning = "Phantoms, elastography and scans are SIMULATED: nothing was measured here.";
  page.footer = fmt::format("Glisson {}. Research software; not a medical device.", version());
  page.blocks.push_back(report::Paragraph{verdict(summary)});
  page.blocks.push_back(report::Paragraph{fmt::format(
      "Over the trials of table 4.4 the scanned surface lies {:.2f} mm from the simulated one on average, {:.2f} mm in "
      "the worst of them. The dissertation reports {:.2f} mm in its text, while the errors of table 4.4 for the same "
      "trials average {:.2f} mm. The tool is taken to be a ball of {:.0f} mm radius, which the dissertation does not "
      "say; under it nothing is scanned.",
      summary.mean_mm, summary.worst_mm, reported_mean_in_text_mm, summary.reported_mean_mm, options.ball_radius_mm)});
  if (summary.simulated_scans) {
    page.blocks.emplace_back(specimens_table());
    page.blocks.emplace_back(compounds_table(summary));
  }
  page.blocks.emplace_back(errors_table(summary));
  if (summary.simulated_scans) {
    if (summary.faults > 0) page.blocks.emplace_back(faults_table(summary));
    for (report::Block& block : curves(summary)) page.blocks.push_back(std::move(block));
  }
  return write_together([&] {
    return write_batch_csv(out / "palpation.csv", summary.rows)
        .and_then([&] { return write_json_file(out / "summary.json", document_of(summary, options)); })
        .and_then([&] { return report::write_html(out / "report.html", page); });
  });
}

namespace {

std::optional<double> value_of(const BatchRow& row, const std::string& name) {
  const auto values = column_of({row}, name);
  if (values.empty()) return {};
  return values.front();
}

report::Cell cell(const BatchRow& row, const std::string& name, const char* format = "{:.2f}") {
  const auto value = value_of(row, name);
  return {value ? fmt::format(fmt::runtime(format), *value) : ""};
}

Json document_of(const PalpationSummary& summary, const PalpationOptions& options) {
  Json document{{"trials", Json::array()},
                {"mean_mm", summary.mean_mm},
                {"worst_mm", summary.worst_mm},
                {"dissertation_text_mm", reported_mean_in_text_mm},
                {"dissertation_table_mm", summary.reported_mean_mm},
                {"scans", summary.simulated_scans ? "simulated" : "given"},
                {"ball_radius_mm", options.ball_radius_mm}};
  if (summary.simulated_scans) {
    document["passed"] = summary.passed();
    document["limit_percent"] = 100 * palpation_limit;
    document["held"] = {{"trials", summary.honest}, {"within_limit", summary.held}};
    document["faults"] = {{"trials", summary.faults},
                          {"beyond_limit", summary.caught},
                          {"within_clinical_limit", summary.faults_within_clinical_limit}};
  }
  for (std::size_t n = 0; n < summary.rows.size(); ++n) {
    Json json{{"trial", summary.rows[n].id}, {"phantom", summary.trials[n].phantom}};
    for (const auto& [name, value] : summary.rows[n].values) json[name] = value;
    if (!summary.rows[n].error.empty()) json["error"] = summary.rows[n].error;
    document["trials"].push_back(std::move(json));
  }
  return document;
}

std::string verdict(const PalpationSummary& summary) {
  if (!summary.simulated_scans) return "How deep the tool went is not known of these scans: nothing is judged.";
  std::string text =
      fmt::format("{} In {} of {} trials the ball lies as deep as in truth to within {:.0f} % of its depth.",
                  summary.passed() ? "The study holds." : "The study does NOT hold.", summary.held, summary.honest,
                  100 * palpation_limit);
  if (summary.faults > 0) {
    text += fmt::format(
        " Of {} faults on purpose {} lie beyond that; by the surface's {:.0f} mm alone {} of them would have passed.",
        summary.faults, summary.caught, clinical_limit_mm, summary.faults_within_clinical_limit);
  }
  return text;
}

report::Table specimens_table() {
  report::Table table{"The phantoms (table 4.2); the last two are not in the dissertation.",
                      {"Phantom", "Diameter (mm)", "Height (mm)", "Upper half (kPa)", "Lower half (kPa)", "Ball (kPa)",
                       "Ball's diameter (mm)"},
                      {}};
  for (const PalpationSpecimen& s : palpation_specimens()) {
    const bool ball = s.inclusion_radius_mm > 0;
    table.rows.push_back({{s.name},
                          {fmt::format("{:.0f}", 2 * s.radius_mm)},
                          {fmt::format("{:.0f}", s.height_mm)},
                          {fmt::format("{:.2f}", s.upper_kPa)},
                          {fmt::format("{:.2f}", s.lower_kPa)},
                          {ball ? fmt::format("{:.2f}", s.inclusion_kPa) : ""},
                          {ball ? fmt::format("{:.0f}", 2 * s.inclusion_radius_mm) : ""}});
  }
  return table;
}

report::Table compounds_table(const PalpationSummary& summary) {
  const auto by_mre = dissertation_regions();
  report::Table table{
      "The compounds (table 4.3): Young's modulus in kPa, true and as the model has it, over all cells.",
      {"Phantom", "Compound", "True", "In the model", "Off (%)", "Dissertation's MRE", "Cells measured (%)"},
      {}};
  std::map<std::string, bool> told;
  for (std::size_t n = 0; n < summary.rows.size(); ++n) {
    if (summary.trials[n].fault != PalpationFault::none || told[summary.trials[n].phantom]) continue;
    told[summary.trials[n].phantom] = summary.rows[n].error.empty();
    for (const bool soft : {true, false}) {
      const auto found = value_of(summary.rows[n], soft ? "soft_kPa" : "stiff_kPa");
      if (!found) continue;
      const double truth = soft ? machine_soft_kPa : machine_stiff_kPa;
      table.rows.push_back({{summary.trials[n].phantom},
                            {soft ? "A" : "B"},
                            {fmt::format("{:.2f}", truth)},
                            {fmt::format("{:.2f}", *found)},
                            {fmt::format("{:+.1f}", 100 * (*found / truth - 1))},
                            {fmt::format("{:.2f}", by_mre[soft ? 0 : 1].youngs_kPa)},
                            cell(summary.rows[n], "measured_percent", "{:.0f}")});
    }
  }
  return table;
}

// Within the limit or beyond it.
report::Cell off_cell(const BatchRow& row) {
  const auto off = value_of(row, "off_percent");
  if (!off) return {};
  return {fmt::format("{:+.1f}", *off),
          std::abs(*off) <= 100 * palpation_limit ? report::Cell::Emphasis::good : report::Cell::Emphasis::flag};
}

report::Table errors_table(const PalpationSummary& summary) {
  report::Table table{
      "Table 4.4: distance of the scanned from the simulated surface, and how deep the ball lies.",
      {"Phantom", "Load (N)", "Error (mm)", "Error in table 4.4 (mm)", "Near the tool (mm)", "Depth, true (mm)",
       "Depth, model (mm)", "Off (%)", "Off with the true moduli (%)", "Largest strain"},
      {}};
  for (std::size_t n = 0; n < summary.rows.size(); ++n) {
    const PalpationTrial& trial = summary.trials[n];
    const BatchRow& row = summary.rows[n];
    if (trial.fault != PalpationFault::none) continue;
    if (!row.error.empty()) {
      table.rows.push_back(
          {{trial.phantom}, {fmt::format("{:.2f}", trial.force_N)}, {row.error, report::Cell::Emphasis::flag}});
      continue;
    }
    table.rows.push_back({{trial.phantom},
                          {fmt::format("{:.2f}", trial.force_N)},
                          cell(row, "mean_mm"),
                          cell(row, "reported_mm"),
                          cell(row, "near_tool_mm"),
                          cell(row, "true_depth_mm"),
                          cell(row, "depth_mm"),
                          off_cell(row),
                          cell(row, "told_off_percent", "{:+.1f}"),
                          cell(row, "largest_strain")});
  }
  return table;
}

std::string said_of(PalpationFault fault) {
  switch (fault) {
    case PalpationFault::modulus: return "the model's moduli are 1.5 times those found";
    case PalpationFault::law: return "the gel stiffens as it is strained";
    case PalpationFault::poisson: return "the gel's Poisson's ratio is 0.49";
    case PalpationFault::none: break;
  }
  return "";
}

report::Table faults_table(const PalpationSummary& summary) {
  report::Table table{"Faults on purpose, of which the model is not told: they should lie beyond the limit.",
                      {"Trial", "Fault", "Error (mm)", "Depth, true (mm)", "Depth, model (mm)", "Off (%)"},
                      {}};
  for (std::size_t n = 0; n < summary.rows.size(); ++n) {
    const BatchRow& row = summary.rows[n];
    if (summary.trials[n].fault == PalpationFault::none) continue;
    const auto off = value_of(row, "off_percent");
    report::Cell off_by{row.error};
    if (off) {
      off_by = {fmt::format("{:+.1f}", *off),
                std::abs(*off) > 100 * palpation_limit ? report::Cell::Emphasis::good : report::Cell::Emphasis::flag};
    }
    table.rows.push_back({{row.id},
                          {said_of(summary.trials[n].fault)},
                          cell(row, "mean_mm"),
                          cell(row, "true_depth_mm"),
                          cell(row, "depth_mm"),
                          off_by});
  }
  return table;
}

std::vector<report::Block> curves(const PalpationSummary& summary) {
  std::vector<report::Block> blocks;
  for (const PalpationSpecimen& specimen : palpation_specimens()) {
    report::PlotCurve truth{"true", {{0, 0}}}, model{"model", {{0, 0}}, report::PlotCurve::Style::dashes};
    for (std::size_t n = 0; n < summary.rows.size(); ++n) {
      if (summary.trials[n].phantom != specimen.name || summary.trials[n].fault != PalpationFault::none) continue;
      const auto true_mm = value_of(summary.rows[n], "true_depth_mm"), model_mm = value_of(summary.rows[n], "depth_mm");
      if (!true_mm || !model_mm) continue;
      truth.points.emplace_back(*true_mm, summary.trials[n].force_N);
      model.points.emplace_back(*model_mm, summary.trials[n].force_N);
    }
    if (truth.points.size() < 2) continue;
    report::Plot plot{fmt::format("Phantom {}: force over depth.", specimen.name), "depth (mm)", "force (N)"};
    plot.curves = {std::move(truth), std::move(model)};
    blocks.emplace_back(std::move(plot));
  }
  return blocks;
}

}  // namespace
}  // namespace glisson::studies

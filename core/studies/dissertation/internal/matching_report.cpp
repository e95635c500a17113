// The matching study as a page, tables and one document.

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "base/files.h"
#include "base/json.h"
#include "base/write_file.h"
#include "report/html.h"
#include "studies/dissertation/matching_study.h"

namespace glisson::studies {
namespace {

report::Page page_of(const MatchingStudy& study);
Json document_of(const MatchingStudy& study);
std::string demand_csv(const MatchingStudy& study);

std::string quality_csv(const MatchingStudy& study) {
  std::string csv = "points,width,problems,mean_delta_percent,mean_signed_percent,worst_delta_percent\n";
  for (const MatchingQuality& of : study.quality) {
    csv += fmt::format("{},{},{},{:.4g},{:.4g},{:.4g}\n", of.points, name_of(of.width), of.problems,
                       100 * of.mean_delta, 100 * of.mean_signed, 100 * of.worst_delta);
  }
  return csv;
}

std::string timing_csv(const MatchingStudy& study) {
  std::string csv = "points,way,threads,seconds,watts,joules\n";
  for (const MatchingTiming& timing : study.timings) {
    csv += fmt::format("{},\"{}\",{},{:.6g},{},{}\n", timing.points, timing.name, timing.threads, timing.seconds,
                       timing.watts ? fmt::format("{:.4g}", *timing.watts) : "",
                       timing.joules ? fmt::format("{:.4g}", *timing.joules) : "");
  }
  return csv;
}

}  // namespace

Result<void> write_matching(const std::filesystem::path& out, const MatchingStudy& study) {
  return write_together([&] {
    return write_batch_csv(out / "problems.csv", study.rows)
        .and_then([&] { return write_text_file(out / "quality.csv", quality_csv(study)); })
        .and_then([&] { return write_text_file(out / "timing.csv", timing_csv(study)); })
        .and_then([&] { return write_text_file(out / "demand.csv", demand_csv(study)); })
        .and_then([&] { return write_json_file(out / "summary.json", document_of(study)); })
        .and_then([&] { return report::write_html(out / "report.html", page_of(study)); });
  });
}

namespace {

std::string demand_csv(const MatchingStudy& study) {
  std::string csv = "points,field_MB,field_GB_per_s,distances_GB_per_s,messages_GB_per_s,costs_G_per_s\n";
  for (const MatchingDemand& demand : study.demands) {
    csv += fmt::format("{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}\n", demand.points, demand.field_MB, demand.field_GB_per_s,
                       demand.distances_GB_per_s, demand.messages_GB_per_s, demand.costs_G_per_s);
  }
  return csv;
}

Json document_of(const MatchingStudy& study) {
  const auto failed = std::count_if(study.rows.begin(), study.rows.end(), [](auto& row) { return !row.error.empty(); });
  Json document{{"simulated", study.simulated},   {"problems", study.rows.size()}, {"failed", failed},
                {"passes", study.options.passes}, {"quality", Json::array()},      {"energy_by_pass", Json::object()},
                {"timings", Json::array()},       {"platforms", Json::array()},    {"demands", Json::array()},
                {"remarks", study.remarks}};
  for (const MatchingQuality& of : study.quality) {
    document["quality"].push_back({{"points", of.points},
                                   {"width", name_of(of.width)},
                                   {"problems", of.problems},
                                   {"mean_delta_percent", 100 * of.mean_delta},
                                   {"mean_signed_percent", 100 * of.mean_signed},
                                   {"worst_delta_percent", 100 * of.worst_delta}});
  }
  const char* widths[] = {"double", "bits_32", "bits_16", "bits_8"};
  for (std::size_t width = 0; width < study.energy_by_pass.size(); ++width) {
    document["energy_by_pass"][widths[width]] = study.energy_by_pass[width];
  }
  for (const MatchingTiming& timing : study.timings) {
    Json of{{"points", timing.points}, {"way", timing.name}, {"threads", timing.threads}, {"seconds", timing.seconds}};
    if (timing.watts) of["watts"] = *timing.watts;
    if (timing.joules) of["joules"] = *timing.joules;
    document["timings"].push_back(of);
  }
  for (const MatchingDevice& of : study.platforms) {
    document["platforms"].push_back({{"name", of.name},
                                     {"memory_GB_per_s", of.memory_GB_per_s},
                                     {"costs_G_per_s", of.costs_G_per_s},
                                     {"points_by_field", of.points_by_field},
                                     {"points_by_messages", of.points_by_messages},
                                     {"points_by_costs", of.points_by_costs}});
  }
  for (const MatchingDemand& of : study.demands) {
    document["demands"].push_back({{"points", of.points},
                                   {"field_MB", of.field_MB},
                                   {"field_GB_per_s", of.field_GB_per_s},
                                   {"distances_GB_per_s", of.distances_GB_per_s},
                                   {"messages_GB_per_s", of.messages_GB_per_s},
                                   {"costs_G_per_s", of.costs_G_per_s}});
  }
  return document;
}

report::Table quality_table(const MatchingStudy& study) {
  report::Table table{
      "Energy against double precision after the same passes. The dissertation's table 3.1: 1.3 to 1.9 % "
      "at 96 and 128 points.",
      {"points", "words", "problems", "mean |difference| (%)", "mean difference (%)", "largest (%)"},
      {}};
  for (const MatchingQuality& of : study.quality) {
    table.rows.push_back({{std::to_string(of.points)},
                          {name_of(of.width)},
                          {std::to_string(of.problems)},
                          {fmt::format("{:.2f}", 100 * of.mean_delta)},
                          {fmt::format("{:+.2f}", 100 * of.mean_signed)},
                          {fmt::format("{:.2f}", 100 * of.worst_delta)}});
  }
  return table;
}

report::Table timing_table(const MatchingStudy& study) {
  report::Table table{
      "One registration (table 3.2). The dissertation: 4.22 s and 294 J on one thread, 0.50 s and 55.2 J "
      "on 14, 0.05 s and 3.6 J with its accelerator.",
      {"way", "points", "threads", "time (ms)", "power (W)", "energy (J)"},
      {}};
  for (const MatchingTiming& timing : study.timings) {
    table.rows.push_back({{timing.name},
                          {std::to_string(timing.points)},
                          {std::to_string(timing.threads)},
                          {fmt::format("{:.1f}", 1e3 * timing.seconds)},
                          {timing.watts ? fmt::format("{:.1f}", *timing.watts) : "-"},
                          {timing.joules ? fmt::format("{:.2f}", *timing.joules) : "-"}});
  }
  return table;
}

report::Table platform_table(const MatchingStudy& study) {
  report::Table table{
      fmt::format("Up to how many points a platform matches {:g} scans a second.", study.options.scans_per_s),
      {"platform", "memory (GB/s)", "costs (10^9/s)", "field in memory", "messages in memory", "arithmetic"},
      {}};
  for (const MatchingDevice& of : study.platforms) {
    table.rows.push_back({{of.name},
                          {fmt::format("{:.3g}", of.memory_GB_per_s)},
                          {fmt::format("{:.3g}", of.costs_G_per_s)},
                          {std::to_string(of.points_by_field)},
                          {std::to_string(of.points_by_messages)},
                          {std::to_string(of.points_by_costs)}});
  }
  return table;
}

using Quantity = double MatchingDemand::*;

report::PlotCurve demand_curve(const MatchingStudy& study, const char* label, Quantity quantity) {
  report::PlotCurve curve{label, {}, report::PlotCurve::Style::line};
  for (const MatchingDemand& demand : study.demands) {
    curve.points.emplace_back(std::log10(demand.points), std::log10(demand.*quantity));
  }
  return curve;
}

report::Rule level(const std::string& label, double value) {
  return {report::Rule::Along::y, std::log10(value), label};
}

constexpr const char* points_title = "points, as a power of ten";
constexpr const char* memory_title = "GB/s, as a power of ten";

report::Plot field_plot(const MatchingStudy& study) {
  report::Plot plot{
      "Figure 3.3: reading the written-out field. (The lines of other accelerators there are not in its "
      "text.)",
      points_title, memory_title};
  plot.curves = {demand_curve(study, "field", &MatchingDemand::field_GB_per_s)};
  for (const MatchingDevice& of : study.platforms) plot.rules.push_back(level(of.name, of.memory_GB_per_s));
  return plot;
}

report::Plot memory_plot(const MatchingStudy& study) {
  report::Plot plot{"Figure 3.6: memory traffic with the field written out, with distances alone, and of messages.",
                    points_title, memory_title};
  plot.curves = {demand_curve(study, "field (baseline)", &MatchingDemand::field_GB_per_s),
                 demand_curve(study, "messages (ours)", &MatchingDemand::messages_GB_per_s),
                 demand_curve(study, "distances (DMRF)", &MatchingDemand::distances_GB_per_s)};
  for (const MatchingDevice& of : study.platforms) plot.rules.push_back(level(of.name, of.memory_GB_per_s));
  return plot;
}

report::Plot bounds_plot(const MatchingStudy& study) {
  report::Plot plot{
      "Figure 3.13: what memory and arithmetic have to give, in shares of what a platform gives: 0 is all "
      "of it.",
      points_title, "share, as a power of ten"};
  for (const MatchingDevice& of : study.platforms) {
    report::PlotCurve memory{of.name + ": messages", {}, report::PlotCurve::Style::dashes};
    report::PlotCurve costs{of.name + ": arithmetic", {}, report::PlotCurve::Style::line};
    for (const MatchingDemand& demand : study.demands) {
      const double place = std::log10(demand.points);
      memory.points.emplace_back(place, std::log10(demand.messages_GB_per_s / of.memory_GB_per_s));
      costs.points.emplace_back(place, std::log10(demand.costs_G_per_s / of.costs_G_per_s));
    }
    plot.curves.push_back(std::move(memory));
    plot.curves.push_back(std::move(costs));
  }
  plot.rules.push_back({report::Rule::Along::y, 0, "all of it"});
  return plot;
}

report::Plot width_plot(const MatchingStudy& study) {
  report::Plot plot{fmt::format("Figure 3.8: energy by pass on the first problem, {} points.", study.points_by_pass),
                    "pass", "energy"};
  const char* names[] = {"64-bit floating point", "32 bits", "16 bits", "8 bits"};
  for (std::size_t width = 0; width < study.energy_by_pass.size(); ++width) {
    report::PlotCurve curve{names[width], {}, report::PlotCurve::Style::line};
    for (std::size_t pass = 0; pass < study.energy_by_pass[width].size(); ++pass) {
      curve.points.emplace_back(static_cast<double>(pass + 1), study.energy_by_pass[width][pass]);
    }
    plot.curves.push_back(std::move(curve));
  }
  return plot;
}

report::Page page_of(const MatchingStudy& study) {
  report::Page page;
  page.title = "Matching shapes";
  page.subtitle = "Chapter 3 of the dissertation: tables 3.1 and 3.2, figures 3.3, 3.6, 3.8 and 3.13";
  if (study.simulated) page.warning = "SIMULATED shapes: generated livers, bent";
  page.blocks = {report::Heading{"How near few bits are to double precision"},
                 report::Paragraph{fmt::format("{} problems, {} passes each, without polish and from one start.",
                                               study.rows.size(), study.options.passes)},
                 quality_table(study),
                 width_plot(study),
                 report::Heading{"What memory and arithmetic have to give"},
                 field_plot(study),
                 memory_plot(study),
                 bounds_plot(study),
                 platform_table(study)};
  if (!study.timings.empty()) {
    page.blocks.push_back(report::Heading{"Time, power and energy"});
    page.blocks.push_back(timing_table(study));
  }
  for (const std::string& remark : study.remarks) page.blocks.push_back(report::Paragraph{remark});
  page.footer = fmt::format("Glisson {}. Not a medical device.", version());
  return page;
}

}  // namespace
}  // namespace glisson::studies

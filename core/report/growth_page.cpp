#include "report/growth_page.h"

#include <fmt/format.h>

#include "base/json.h"
#include "base/write_file.h"
#include "report/growth.h"
#include "report/html.h"
#include "vasculature/couinaud.h"

namespace glisson::report {
namespace {

using casefile::ComparedStudies;
using planning::PartGrowth;

std::string kPa_of(const planning::Tissue& tissue) {
  return tissue.mean_kPa ? fmt::format("{:.1f}", *tissue.mean_kPa) : std::string();
}

std::string change_of(const PartGrowth& part) {
  const auto change = part.change_percent();
  return change ? fmt::format("{}{:+.1f}", part.within_error ? "~ " : "", *change) : std::string("new");
}

// A row a segment, then the remnant and the liver.
Table parts_of(const ComparedStudies& compared) {
  const planning::Growth& growth = compared.growth;
  Table table{
      "Tissue without tumours; ~: the change is no more than what the same liver differs by when it is parted "
      "anew",
      {"", "before (ml)", "after (ml)", "change (ml)", "change (%)", "share before (%)", "share after (%)"},
      {}};
  const bool has_stiffness = growth.liver.before.mean_kPa || growth.liver.after.mean_kPa;
  if (has_stiffness) {
    for (const char* column : {"before (kPa)", "after (kPa)"}) table.columns.emplace_back(column);
  }
  const auto add = [&](const std::string& name, const PartGrowth& part) {
    auto& row = table.rows.emplace_back(std::vector<Cell>{{name},
                                                          {fmt::format("{:.0f}", part.before.ml)},
                                                          {fmt::format("{:.0f}", part.after.ml)},
                                                          {fmt::format("{:+.0f}", part.change_ml())},
                                                          {change_of(part)},
                                                          {fmt::format("{:.1f}", part.before_percent)},
                                                          {fmt::format("{:.1f}", part.after_percent)}});
    if (!has_stiffness) return;
    for (const planning::Tissue* tissue : {&part.before, &part.after}) row.push_back({kPa_of(*tissue)});
  };
  for (const planning::SegmentGrowth& segment : growth.segments) {
    add("segment " + std::string(vasculature::segment_name(static_cast<std::size_t>(segment.number))), segment.part);
  }
  if (growth.remnant) add("what the plan " + compared.plan + " leaves", growth.remnant->part);
  add("liver", growth.liver);
  return table;
}

Plot volumes_of(const ComparedStudies& compared) {
  Plot plot{"Volume of each segment in both studies", "Couinaud's segment", "volume (ml)"};
  PlotCurve before{"before", {}}, after{"after", {}};
  for (const planning::SegmentGrowth& segment : compared.growth.segments) {
    before.points.emplace_back(double(segment.number), segment.part.before.ml);
    after.points.emplace_back(double(segment.number), segment.part.after.ml);
  }
  plot.curves = {std::move(before), std::move(after)};
  return plot;
}

}  // namespace

Page growth_page(const ComparedStudies& compared, const std::string& origin) {
  Page page;
  page.title = "Two studies of one liver";
  page.warning = origin;
  for (const Sentence& sentence : growth_sentences(compared)) page.blocks.emplace_back(Paragraph{sentence.message()});
  page.blocks.emplace_back(parts_of(compared));
  page.blocks.emplace_back(volumes_of(compared));
  return page;
}

Result<std::vector<std::filesystem::path>> write_growth(const std::filesystem::path& folder,
                                                        const ComparedStudies& compared, const std::string& origin) {
  auto written = write_together([&] {
    return write_json_file(folder / "growth.json", growth_json(compared))
        .and_then([&] { return write_file(folder / "growth.csv", growth_table(compared)); })
        .and_then([&] { return write_html(folder / "growth.html", growth_page(compared, origin)); });
  });
  if (!written) return failure(std::move(written.error()));
  return std::vector{folder / "growth.json", folder / "growth.csv", folder / "growth.html"};
}

}  // namespace glisson::report

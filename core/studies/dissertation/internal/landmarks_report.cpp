#include "studies/dissertation/internal/landmarks_report.h"

#include <fmt/format.h>

#include "base/files.h"
#include "rehearsal/comparison.h"

namespace glisson::studies {
namespace {

using rehearsal::significant_mm;

report::Plot box_plot(const std::string& caption, const std::vector<LandmarksSpread>& spreads) {
  report::Plot plot{.caption = caption, .x_title = "", .y_title = "distance (mm)"};
  for (const LandmarksSpread& spread : spreads) {
    plot.boxes.push_back({spread.says, spread.mm.percentile_5, spread.mm.percentile_25, spread.mm.median,
                          spread.mm.percentile_75, spread.mm.percentile_95});
  }
  plot.rules.push_back({report::Rule::Along::y, significant_mm, "5 mm: matters to a surgeon"});
  plot.rules.push_back({report::Rule::Along::y, imperceptible_mm, "1.65 mm: a voxel of the dissertation's maps"});
  return plot;
}

// Figure 4.14 shows patients in whom one region agrees with the mean and the others do not; here are all of them.
report::Plot soft_against_stiff(const LandmarksSummary& summary) {
  report::Plot plot{.caption =
                        "Each patient's soft and stiff region: in the lower left corner one stiffness serves both "
                        "(fig. 4.14).",
                    .x_title = "soft region (mm)",
                    .y_title = "stiff region (mm)"};
  const auto soft = column_of(summary.rows, "soft_max_mm");
  const auto stiff = column_of(summary.rows, "stiff_max_mm");
  report::PlotCurve each{"each patient", {}, report::PlotCurve::Style::dots};
  for (std::size_t n = 0; n < soft.size(); ++n) each.points.emplace_back(soft[n], stiff[n]);
  plot.curves.push_back(std::move(each));
  plot.rules = {{report::Rule::Along::x, significant_mm, "5 mm"}, {report::Rule::Along::y, significant_mm, "5 mm"}};
  return plot;
}

report::Table shares(const LandmarksSummary& summary) {
  report::Table table{"In how many patients it matters.",
                      {"Distance", "Patients", "Mean", "Median", "Largest", "5 mm or more", "95 % interval"},
                      {}};
  for (const auto* spreads :
       {&summary.between, &summary.groups, &summary.sensitivity, &summary.engines, &summary.within}) {
    for (const LandmarksSpread& spread : *spreads) {
      table.rows.push_back(
          {{spread.says},
           {std::to_string(spread.mm.voxels)},
           {fmt::format("{:.1f} mm", spread.mm.mean)},
           {fmt::format("{:.1f} mm", spread.mm.median)},
           {fmt::format("{:.1f} mm", spread.mm.max)},
           {fmt::format("{:.0f} %", 100 * spread.significant.fraction)},
           {fmt::format("{:.0f} to {:.0f} %", 100 * spread.significant.low, 100 * spread.significant.high)}});
    }
  }
  return table;
}

std::string law_of(const LandmarksSummary& summary, const LandmarksOptions& options) {
  if (options.retraction.law == RetractionLaw::linear) {
    return "Small strain is an extrapolation where the liver is lifted far.";
  }
  return fmt::format(
      "Neo-Hookean bodies answer for {} patients, whom linear elasticity strains by more than 20 %; in {} more no "
      "equilibrium was found at large strain, and the linear one stands.",
      summary.at_large_strain, summary.beyond_linear);
}

void add_groups(const LandmarksSummary& summary, report::Page& page) {
  if (summary.groups.empty()) return;
  page.blocks.emplace_back(
      box_plot("How far landmarks are from where the atlas has them (fig. 4.10).", summary.groups));
  const std::vector<std::string>& examples = summary.groups[1].examples;
  std::string outer;
  for (std::size_t n = 1; n < examples.size(); ++n) outer += (n > 1 ? ", " : "") + examples[n];
  page.blocks.emplace_back(report::Paragraph{
      fmt::format("By the landmark that is farthest off the median patient is {}; nearest to one and more standard "
                  "deviations above the mean: {}.",
                  examples.front(), outer)});
  page.blocks.emplace_back(box_plot(
      "What moves landmarks, on average over a patient's, by linear elasticity: his mean stiffness in place of "
      "the atlas's; his map in place of his mean; an abdominal wall of 30 mm in place of 15 mm; his shape in "
      "place of all patients' mean, both with the atlas's stiffness.",
      summary.sensitivity));
}

void add_engines(const LandmarksSummary& summary, const LandmarksOptions& options, report::Page& page) {
  if (!options.retraction.meshfree) return;
  page.blocks.emplace_back(report::Heading{"The meshfree engine beside finite elements"});
  const int nodes = options.retraction.meshfree->nodes;
  page.blocks.emplace_back(report::Paragraph{fmt::format(
      "The same liver, law, supports and tool by meshfree nodes ({}). In {} of the patients they found no equilibrium "
      "that may be used.",
      nodes > 0 ? std::to_string(nodes) : "one for every 12 points of the mesh", summary.without_meshfree)});
  if (summary.engines.empty()) return;
  page.blocks.emplace_back(box_plot(
      "How far apart the two engines put the liver as measured and its landmarks; and how far off the atlas is "
      "by the meshfree engine alone.",
      summary.engines));
}

report::Table patients(const LandmarksSummary& summary) {
  report::Table table{"Each patient; distances in mm, stiffness in kPa of shear modulus.",
                      {"Patient", "Mean (kPa)", "sd (kPa)", "Lifted", "by atlas", "Apart, mean", "at the tool",
                       "Soft region", "Stiff region", "Uneven region"},
                      {}};
  for (const BatchRow& row : summary.rows) {
    if (!row.error.empty()) {
      table.rows.push_back({{row.id}, {row.error, report::Cell::Emphasis::flag}});
      continue;
    }
    std::vector<report::Cell> cells{{row.id}};
    for (const char* column : {"mean_kPa", "sd_kPa", "lifted_mm", "atlas_lifted_mm"}) {
      cells.push_back({fmt::format("{:.1f}", column_of({row}, column).front())});
    }
    for (const char* column : {"atlas_mean_mm", "atlas_near_tool_mm", "soft_max_mm", "stiff_max_mm", "uneven_max_mm"}) {
      const double mm = column_of({row}, column).front();
      cells.push_back({fmt::format("{:.1f}", mm),
                       mm >= significant_mm ? report::Cell::Emphasis::flag : report::Cell::Emphasis::none});
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

}  // namespace

report::Page landmarks_page(const LandmarksSummary& summary, const LandmarksOptions& options,
                            const LandmarksPictures& pictures) {
  const RetractionOptions& retraction = options.retraction;
  report::Page page;
  page.title = "What an atlas, or one stiffness, misplaces";
  page.subtitle = fmt::format("{} patients, {} could not be used (section 4.4)", summary.patients, summary.failed);
  page.warning = options.warning;
  page.footer = fmt::format("Glisson {}. Research software; not a medical device.", version());
  page.blocks.emplace_back(report::Heading{"Between patients"});
  page.blocks.emplace_back(report::Paragraph{fmt::format(
      "A Nathanson retractor hoists segment VI with {:.2g} N. Each liver is simulated with the stiffness that was "
      "measured in it and with the atlas's {:.2g} kPa (shear). Retractor and force are our assumption. {} At the tool "
      "the two differ by 5 mm or more in {:.0f} % of the "
      "patients; by {:.1f} mm on average over the surface.",
      retraction.force_N, retraction.reference_kPa, law_of(summary, options),
      100 * summary.between[1].significant.fraction, summary.between[0].mm.mean)});
  page.blocks.emplace_back(box_plot(
      "How far the liver as measured is from the atlas's, on average over the surface and at the tool; the "
      "same with the patient's mean alone instead of the map; and how far the map is from that mean. Boxes hold "
      "the middle half of the patients, whiskers 5 to 95 % (fig. 4.10).",
      summary.between));
  page.blocks.emplace_back(report::Paragraph{
      "The median patient, and those nearest to one, two and three standard deviations above the mean (fig. 4.12), by "
      "the landmark that is farthest off, or at the tool where none are known:"});
  page.blocks.emplace_back(report::FigureRow{pictures.between});
  add_groups(summary, page);
  add_engines(summary, options, page);
  page.blocks.emplace_back(report::Heading{"Within a liver"});
  page.blocks.emplace_back(report::Paragraph{fmt::format(
      "Beams of 50 x 10 x 10 mm from where a liver is softest, stiffest and most uneven, lifted by {:.2g} N, against a "
      "beam of the liver's mean; both ends on an abdominal wall of {:.2g} kPa/mm; where a beam is lifted by more than "
      "10 mm, small strain is an extrapolation. In {:.0f} % of the patients one of "
      "the three at least is 5 mm off.",
      options.beams.force_N, options.beams.foundation_kPa_per_mm, 100 * summary.any_region_fraction)});
  page.blocks.emplace_back(
      box_plot("How far a beam of the region is from one of the liver's mean, at most (fig. 4.13).", summary.within));
  if (!pictures.within.empty()) {
    page.blocks.emplace_back(
        report::Paragraph{"Patients in whom one region agrees with the mean and the other two do not (fig. 4.14):"});
    page.blocks.emplace_back(report::FigureRow{pictures.within});
  }
  page.blocks.emplace_back(soft_against_stiff(summary));
  page.blocks.emplace_back(shares(summary));
  page.blocks.emplace_back(patients(summary));
  return page;
}

}  // namespace glisson::studies

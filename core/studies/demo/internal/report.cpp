#include "studies/demo/internal/report.h"

#include <fmt/format.h>
#include <algorithm>

#include "base/files.h"
#include "report/html.h"
#include "studies/demo/patient.h"

namespace glisson::studies {
namespace {

report::Figure figure(const DemoSummary& summary, const std::string& name, const std::string& caption) {
  for (const auto& picture : summary.pictures) {
    if (picture.stem() == name) return {picture, caption};
  }
  GLISSON_ASSERT(false && "a picture of the report was not drawn");
  return {};
}

report::Cell millimetres(double length_mm) {
  const bool significant = length_mm >= rehearsal::significant_mm;
  return {fmt::format("{:.1f}{}", length_mm, significant ? " !" : ""),
          significant ? report::Cell::Emphasis::flag : report::Cell::Emphasis::none};
}

report::Table landmark_table(const rehearsal::Comparison& comparison) {
  report::Table table{
      "How far each landmark moves under the retractor. 5 mm or more matters to a surgeon and is marked !.",
      {"Landmark", "MRE stiffness (mm)", "Atlas stiffness (mm)", "Apart (mm)"},
      {}};
  for (const auto& landmark : comparison.landmarks) {
    table.rows.push_back({{landmark.id},
                          millimetres(landmark.displacement_a_mm),
                          millimetres(landmark.displacement_b_mm),
                          millimetres(landmark.difference_mm)});
  }
  return table;
}

report::Table quality_table(const DemoSummary& summary) {
  return {
      "How the chain did against the truth, which only a simulated patient has.",
      {"Stage", "Result"},
      {{{"Liver grown from seeds"},
        {fmt::format("{:.0f} ml of {:.0f} ml, Dice {:.3f}", summary.liver_ml, summary.true_liver_ml,
                     summary.liver_dice)}},
       {{"Mesh"},
        {fmt::format("{} cells, smallest dihedral angle {:.1f} deg, within {:.2f} mm of the labels", summary.cells,
                     summary.min_dihedral_deg, summary.hausdorff_mm)}},
       {{"Young's modulus"},
        {fmt::format("{:.2f} kPa on average (sd {:.2f}); {:.0f} % of the cells filled from inside; mean error {:.2f} "
                     "kPa",
                     summary.stiffness.mean_kPa, summary.stiffness.sd_kPa, 100 * summary.stiffness.filled_fraction,
                     summary.stiffness_error_kPa)}},
       {{"Equilibrium"}, {fmt::format("relative residual {:.1e}", summary.relative_residual)}}}};
}

// In linear elasticity everything grows with the force; so the force at which the atlas misleads by 5 mm is known.
std::string force_that_matters(const DemoSummary& summary) {
  const double largest_mm = summary.reference_against_mre.max_mm;
  std::string sentence = largest_mm > 0 ? fmt::format("The atlas misplaces some point by 5 mm from {:.1f} N on. ",
                                                      summary.force_N * rehearsal::significant_mm / largest_mm)
                                        : std::string();
  return sentence + summary.validity.sentence().message();
}

std::size_t significant_landmarks(const rehearsal::Comparison& comparison) {
  return static_cast<std::size_t>(std::count_if(comparison.landmarks.begin(), comparison.landmarks.end(),
                                                [](const auto& landmark) { return landmark.significant(); }));
}

std::string what_happened(const DemoSummary& summary) {
  const auto& comparison = summary.reference_against_mre;
  return fmt::format(
      "A {} hoists segment VI with {:.1f} N. On the patient's own stiffness the liver moves by up to {:.1f} mm. With "
      "one "
      "atlas value for all livers, points would be misplaced by {:.1f} mm on average and {:.1f} mm at most; {} of {} "
      "landmarks by 5 mm or more.",
      summary.tool, summary.force_N, summary.max_displacement_mm, comparison.mean_mm, comparison.max_mm,
      significant_landmarks(comparison), comparison.landmarks.size());
}

}  // namespace

Result<void> write_demo_report(const DemoSummary& summary) {
  const auto& comparison = summary.reference_against_mre;
  report::Page page;
  page.title = "A rehearsed retraction";
  page.subtitle = "Demo patient: from a DICOM study to moved landmarks";
  page.warning = std::string(demo_is_simulated) + " Not a medical device.";
  page.footer = fmt::format("Glisson {}. Made in {:.0f} s.", version(), summary.seconds);
  page.blocks = {
      report::Paragraph{what_happened(summary)},
      report::Paragraph{force_that_matters(summary)},
      report::FigureRow{
          {figure(summary, "displacement", "The moved liver, coloured by displacement, with the tool's force."),
           figure(summary, "comparison",
                  "Atlas in red, MRE in blue: purple where they agree, red or blue where they do not.")}},
      report::Heading{"Landmarks"},
      landmark_table(comparison),
      report::Heading{"From images to a model"},
      report::FigureRow{{figure(summary, "anatomy", "The MR series and the structures found in it."),
                         figure(summary, "stiffness", "Shear stiffness from MR elastography.")}},
      report::FigureRow{{figure(summary, "liver", "The liver with its tumour and vessels."),
                         figure(summary, "model", "Young's modulus of the cells at the surface.")}},
      report::Heading{"How far to trust it"},
      quality_table(summary),
  };
  return report::write_html(summary.report, page);
}

}  // namespace glisson::studies

#include "studies/dissertation/data_driven_study.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "anatomy/level_surface.h"
#include "anatomy/patient.h"
#include "base/files.h"
#include "base/json.h"
#include "base/noise.h"
#include "base/write_file.h"
#include "mechanics/statics/data_driven.h"
#include "mechanics/statics/static_model.h"
#include "mechanics/statics/validity.h"
#include "rehearsal/liver_supports.h"
#include "rehearsal/tool_presets.h"
#include "report/html.h"
#include "segmentation/rasterise.h"
#include "studies/dissertation/internal/stiffening_tissue.h"
#include "studies/dissertation/liver_retraction.h"

namespace glisson::studies {
namespace {

using mechanics::StaticResult;
using mechanics::StressStrain;
using Displacements = std::vector<Eigen::Vector3d>;

constexpr double linear_region =
    0.05;  // strain up to which the fitted line takes tissue as linear; chapter 5 gives no number
constexpr double tissue_density_kg_mm3 = 1e-6;

Result<void> check(const DataDrivenStudyOptions& options);
Result<geometry::TetMesh> generated_liver(int target_cells, const Progress& progress);
std::vector<StressStrain> simulated_tests(const StiffeningTissue& tissue, const DataDrivenStudyOptions& options,
                                          int count, double noise, int outliers);

struct Question {
  geometry::TetMesh liver;
  std::vector<mechanics::Support> supports;
  mechanics::Loads loads;
  double poisson_ratio;
  std::optional<Displacements> truth_mm;
};
// What a row says of these measurements; `noise` of the largest stress.
Result<DataDrivenRow> answered(const Question& question, std::vector<StressStrain> measured, double noise,
                               const Progress& progress);
report::Page page_of(const DataDrivenStudy& study);

}  // namespace

Result<DataDrivenStudy> run_data_driven(const DataDrivenStudyOptions& options, const Progress& progress) {
  if (auto sound = check(options); !sound) return failure(std::move(sound.error()));
  auto liver = generated_liver(options.target_cells, progress.part(0, 0.1));
  if (!liver) return failure(std::move(liver.error()));
  const auto placement = rehearsal::hoist_segment_vi(*liver);
  if (!placement) return failure(placement.error());
  Question question{std::move(*liver),
                    rehearsal::usual_supports(),
                    {rehearsal::tool_load(*placement, options.force_N)},
                    options.poisson_ratio,
                    {}};

  DataDrivenStudy study;
  study.cells = question.liver.cells.size();
  if (!options.measured.empty()) {
    study.simulated = false;
    auto row = answered(question, options.measured, 0, progress.part(0.1, 1));
    if (!row) return failure(std::move(row.error()));
    study.rows.push_back(std::move(*row));
    return study;
  }

  const StiffeningTissue tissue{.poisson_ratio = options.poisson_ratio};
  const double farthest = std::sqrt(1.5) * options.farthest_strain;
  const auto truth = equilibrium_of(tissue, farthest, question.liver, question.supports, question.loads);
  if (!truth) return failure(truth.error());
  if (!truth->may_be_used()) {
    return failure("not-converged", GLISSON_TEXT("The tissue's own law found no equilibrium: {0}"),
                   {mechanics::why_not_used(*truth)});
  }
  question.truth_mm = truth->displacement_mm;
  study.true_retraction_mm = truth->max_displacement_mm;
  const double rows = double(options.counts.size() * options.noises.size());
  for (const int count : options.counts) {
    for (const double noise : options.noises) {
      const int outliers = noise > 0 && options.outliers_one_in > 0 ? count / options.outliers_one_in : 0;
      const double done = double(study.rows.size()) / rows, next = double(study.rows.size() + 1) / rows;
      auto row = answered(question, simulated_tests(tissue, options, count, noise, outliers), noise,
                          progress.part(0.1 + 0.9 * done, 0.1 + 0.9 * next));
      if (!row) return failure(std::move(row.error()));
      row->outliers = outliers;
      study.rows.push_back(std::move(*row));
    }
  }
  return study;
}

Result<void> write_data_driven(const std::filesystem::path& out, const DataDrivenStudy& study) {
  std::string csv =
      "measurements,noise_percent,outliers,on_the_line,slope_kPa,slope_region_kPa,retraction_mm,data_mean_mm,"
      "data_max_mm,line_mean_mm,line_max_mm,region_line_mean_mm,region_line_max_mm,strained_beyond_percent,rounds,"
      "converged\n";
  Json document{{"simulated", study.simulated}, {"cells", study.cells}, {"rows", Json::array()}};
  if (study.true_retraction_mm) document["true_retraction_mm"] = *study.true_retraction_mm;
  for (const DataDrivenRow& row : study.rows) {
    const auto cell = [](const std::optional<PointErrors>& errors, double PointErrors::*which) {
      return errors ? fmt::format("{:.4g}", (*errors).*which) : std::string();
    };
    csv +=
        fmt::format("{},{:.4g},{},{},{:.6g},{:.6g},{:.5g},{},{},{:.4g},{:.4g},{},{},{:.3g},{},{}\n", row.measurements,
                    100 * row.noise, row.outliers, row.on_the_line, row.slope_kPa, row.slope_region_kPa,
                    row.retraction_mm, cell(row.from_data, &PointErrors::mean_mm),
                    cell(row.from_data, &PointErrors::largest_mm), row.by_line.mean_mm, row.by_line.largest_mm,
                    cell(row.by_region_line, &PointErrors::mean_mm), cell(row.by_region_line, &PointErrors::largest_mm),
                    100 * row.strained_beyond, row.rounds, row.converged ? 1 : 0);
    const auto errors = [](const PointErrors& of) {
      return Json{{"mean_mm", of.mean_mm}, {"largest_mm", of.largest_mm}};
    };
    Json line{{"measurements", row.measurements},
              {"noise_percent", 100 * row.noise},
              {"outliers", row.outliers},
              {"on_the_line", row.on_the_line},
              {"slope_kPa", row.slope_kPa},
              {"slope_region_kPa", row.slope_region_kPa},
              {"retraction_mm", row.retraction_mm},
              {"by_line", errors(row.by_line)},
              {"strained_beyond_percent", 100 * row.strained_beyond},
              {"rounds", row.rounds},
              {"converged", row.converged}};
    if (row.by_region_line) line["by_region_line"] = errors(*row.by_region_line);
    if (row.from_data) line["from_data"] = errors(*row.from_data);
    document["rows"].push_back(std::move(line));
  }
  std::string measured = "strain,stress_kPa\n";
  for (const auto& [strain, stress_kPa] : study.rows.back().measured) {
    measured += fmt::format("{:.8g},{:.8g}\n", strain, stress_kPa);
  }
  return write_together([&] {
    return write_text_file(out / "data-driven.csv", csv)
        .and_then([&] { return write_text_file(out / "measured.csv", measured); })
        .and_then([&] { return write_json_file(out / "summary.json", document); })
        .and_then([&] { return report::write_html(out / "report.html", page_of(study)); });
  });
}

namespace {

Result<void> check(const DataDrivenStudyOptions& options) {
  const bool counts = !options.counts.empty() && options.counts.size() <= 20 &&
                      std::all_of(options.counts.begin(), options.counts.end(),
                                  [](int count) { return count >= 3 && count <= 100'000; });
  const bool noises = !options.noises.empty() && options.noises.size() <= 20 &&
                      std::all_of(options.noises.begin(), options.noises.end(),
                                  [](double noise) { return noise >= 0 && noise <= 0.5; });
  if (!counts || !noises) {
    return failure("study-options",
                   GLISSON_TEXT("Measurements must be 3 to 100000, noise 0 to 50 % of the largest stress, and at most "
                                "20 of each are tried."));
  }
  if (!(options.farthest_strain > linear_region && options.farthest_strain <= 1) || options.outliers_one_in < 0 ||
      !(options.force_N > 0 && options.force_N <= 100) || options.target_cells < 200) {
    return failure("study-options",
                   GLISSON_TEXT("Tests must go to 5 % strain or farther, to 100 % at most, forces be up to 100 N, and "
                                "a liver have 200 cells or more."));
  }
  return {};
}

Result<geometry::TetMesh> generated_liver(int target_cells, const Progress& progress) {
  const auto surface = anatomy::make_liver_surface({});
  if (!surface) return failure(surface.error());
  const imaging::Grid grid = anatomy::grid_over(geometry::bounding_box(surface->points_mm), 3);
  return liver_mesh(segmentation::rasterise(*surface, grid), target_cells, progress);
}

std::vector<StressStrain> simulated_tests(const StiffeningTissue& tissue, const DataDrivenStudyOptions& options,
                                          int count, double noise, int outliers) {
  const double farthest = std::sqrt(1.5) * options.farthest_strain;
  const double largest_kPa = tissue.tested(farthest).stress_kPa;
  std::vector<StressStrain> measured;
  for (int i = 0; i < count; ++i) {
    measured.push_back(tissue.tested(farthest * (2.0 * i / (count - 1) - 1)));
    measured.back().stress_kPa += noise * largest_kPa * normal_pair(options.seed, static_cast<std::uint64_t>(i)).x();
  }
  for (int k = 0; k < outliers; ++k) {
    const auto which = static_cast<std::size_t>((k + 0.5) * count / outliers);
    measured[which].stress_kPa += (k % 2 == 0 ? 0.5 : -0.5) * largest_kPa;
  }
  return measured;
}

// Of a line through the origin, by least squares; 0 where nothing is stretched.
template <typename Takes>
double slope_of(const std::vector<StressStrain>& measured, const Takes& takes) {
  double products = 0, squares = 0;
  for (const StressStrain& point : measured) {
    if (!takes(point)) continue;
    products += point.strain * point.stress_kPa;
    squares += point.strain * point.strain;
  }
  return squares > 0 ? products / squares : 0;
}

PointErrors errors_between(const Displacements& a_mm, const Displacements& b_mm) {
  PointErrors errors;
  for (std::size_t p = 0; p < a_mm.size(); ++p) {
    const double apart_mm = (a_mm[p] - b_mm[p]).norm();
    errors.mean_mm += apart_mm / double(a_mm.size());
    errors.largest_mm = std::max(errors.largest_mm, apart_mm);
  }
  return errors;
}

Result<DataDrivenRow> answered(const Question& question, std::vector<StressStrain> measured, double noise,
                               const Progress& progress) {
  DataDrivenRow row;
  row.measurements = static_cast<int>(measured.size());
  row.noise = noise;
  double largest_kPa = 0;
  for (const StressStrain& point : measured) largest_kPa = std::max(largest_kPa, std::abs(point.stress_kPa));
  row.slope_kPa = slope_of(measured, [](const StressStrain&) { return true; });
  row.slope_region_kPa =
      slope_of(measured, [](const StressStrain& point) { return std::abs(point.strain) <= linear_region; });
  for (const StressStrain& point : measured) {
    const double off_kPa = std::abs(point.stress_kPa - row.slope_region_kPa * point.strain);
    row.on_the_line += off_kPa <= (0.05 + 3 * noise) * largest_kPa ? 1 : 0;
  }

  const auto data = mechanics::MaterialData::create(measured, {.poisson_ratio = question.poisson_ratio});
  if (!data) return failure(data.error());
  const auto found = mechanics::find_equilibrium_from_data(question.liver, *data, question.supports, question.loads,
                                                           tissue_density_kg_mm3, {}, progress);
  if (!found) return failure(found.error());
  row.retraction_mm = found->result.max_displacement_mm;
  row.rounds = found->result.iterations;
  row.converged = found->result.may_be_used();
  row.strained_beyond = found->share_beyond_data;
  const Displacements& truth_mm = question.truth_mm ? *question.truth_mm : found->result.displacement_mm;
  if (question.truth_mm) row.from_data = errors_between(found->result.displacement_mm, truth_mm);
  mechanics::StaticOptions linear;
  linear.poisson_ratio = question.poisson_ratio;
  const auto errors_by_line = [&](double slope_kPa) {
    return mechanics::solve_static(question.liver, std::vector<double>(question.liver.cells.size(), slope_kPa),
                                   question.supports, question.loads, linear)
        .map([&](const StaticResult& by_line) { return errors_between(by_line.displacement_mm, truth_mm); });
  };
  const auto by_line = errors_by_line(row.slope_kPa);
  if (!by_line) return failure(by_line.error());
  row.by_line = *by_line;
  if (row.slope_region_kPa > 0) {
    const auto by_region_line = errors_by_line(row.slope_region_kPa);
    if (!by_region_line) return failure(by_region_line.error());
    row.by_region_line = *by_region_line;
  }
  row.measured = std::move(measured);
  return row;
}

report::Page page_of(const DataDrivenStudy& study) {
  report::Page page;
  page.title = "A liver retracted straight from measurements";
  page.subtitle = "Chapter 5, figure 5.3: data in place of a law";
  if (study.simulated) page.warning = "SIMULATED liver and measurements";
  page.blocks.emplace_back(report::Paragraph{fmt::format(
      "A generated liver of {} cells on its usual supports, lifted at segment VI. {} A line is fitted to all "
      "measurements, or to those of at most 5 % strain. Small strain throughout.",
      study.cells,
      study.simulated
          ? fmt::format("The truth is the law of the tissue that was measured: it lifts the liver by up to "
                        "{:.1f} mm. Errors are of all points of the body.",
                        *study.true_retraction_mm)
          : std::string("There is no truth: lines are told by how far they are from the answer from data."))});
  const DataDrivenRow& last = study.rows.back();
  report::PlotCurve dots{"measured", {}, report::PlotCurve::Style::dots};
  double farthest = 0;
  for (const StressStrain& point : last.measured) {
    dots.points.emplace_back(100 * point.strain, point.stress_kPa);
    farthest = std::max(farthest, 100 * std::abs(point.strain));
  }
  const auto line = [&](const char* label, double slope_kPa) {
    const double end_kPa = slope_kPa * farthest / 100;
    return report::PlotCurve{label, {{-farthest, -end_kPa}, {farthest, end_kPa}}, report::PlotCurve::Style::line};
  };
  page.blocks.emplace_back(
      report::Plot{.caption = fmt::format("{} of {} measurements lie on the line of the linear region.",
                                          last.on_the_line, last.measurements),
                   .x_title = "strain (%)",
                   .y_title = "stress (kPa)",
                   .curves = {std::move(dots), line("line up to 5 % strain", last.slope_region_kPa),
                              line("line through all", last.slope_kPa)}});
  report::Table table{"Mean and largest distance (mm).",
                      {"measurements", "noise (% of the largest stress)", "outliers", "on the line", "from data",
                       "by the line up to 5 %", "by the line through all", "strained beyond the data (%)", "rounds"},
                      {}};
  const auto both = [](const PointErrors& errors) {
    return fmt::format("{:.2f} / {:.2f}", errors.mean_mm, errors.largest_mm);
  };
  for (const DataDrivenRow& row : study.rows) {
    table.rows.push_back({{std::to_string(row.measurements)},
                          {fmt::format("{:.3g}", 100 * row.noise)},
                          {std::to_string(row.outliers)},
                          {std::to_string(row.on_the_line)},
                          {row.from_data ? both(*row.from_data) : "-"},
                          {row.by_region_line ? both(*row.by_region_line) : "-"},
                          {both(row.by_line)},
                          {fmt::format("{:.2g}", 100 * row.strained_beyond)},
                          {row.converged ? std::to_string(row.rounds) : fmt::format("{}, not at rest", row.rounds)}});
  }
  page.blocks.emplace_back(std::move(table));
  page.footer = fmt::format("Glisson {}. Not a medical device.", version());
  return page;
}

}  // namespace
}  // namespace glisson::studies

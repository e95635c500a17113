#include "studies/dissertation/convergence_study.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "base/files.h"
#include "base/json.h"
#include "base/write_file.h"
#include "mechanics/meshfree/meshfree_model.h"
#include "mechanics/statics/validity.h"
#include "report/html.h"
#include "studies/dissertation/internal/beam_mesh.h"

namespace glisson::studies {
namespace {

using Eigen::Vector3d;

constexpr double beam_length_mm = 50, beam_side_mm = 10, youngs_kPa = 12, beam_density_kg_mm3 = 997e-9;
constexpr double volume_mm3 = beam_length_mm * beam_side_mm * beam_side_mm;
constexpr double inertia_mm4 = beam_side_mm * beam_side_mm * beam_side_mm * beam_side_mm / 12;
constexpr double load_mN_per_mm = beam_density_kg_mm3 * 9810.0 * beam_side_mm * beam_side_mm;
constexpr const char* held = "wall";

double rounded(double value);  // to five digits: no run repeats more of them
double eq_6_6_mm(double x_mm);
double shear_mm(double x_mm);
Result<ConvergenceRow> row_of(int nodes, const Progress& progress);
report::Table table_of(const ConvergenceStudy& study);
report::Plot plot_of(const ConvergenceStudy& study);

}  // namespace

Result<ConvergenceStudy> run_convergence(const ConvergenceOptions& options, const Progress& progress) {
  if (!(options.finest_mm3 >= 0.5 && options.coarsest_mm3 > options.finest_mm3 && options.coarsest_mm3 <= 1700) ||
      options.resolutions < 2 || options.resolutions > 100) {
    return failure("study-options", GLISSON_TEXT("Resolutions must grow from 0.5 mm3 or more to 1700 mm3 or less, in 2 "
                                                 "to 100 steps."));
  }
  ConvergenceStudy study;
  study.eq_6_6_tip_mm = eq_6_6_mm(beam_length_mm);
  study.theory_tip_mm = study.eq_6_6_tip_mm + shear_mm(beam_length_mm);
  for (int i = 0; i < options.resolutions; ++i) {
    const double along = double(i) / (options.resolutions - 1);
    const double resolution_mm3 = options.finest_mm3 * std::pow(options.coarsest_mm3 / options.finest_mm3, along);
    auto row = row_of(static_cast<int>(std::lround(volume_mm3 / resolution_mm3)),
                      progress.part(double(i) / options.resolutions, double(i + 1) / options.resolutions));
    if (!row) return failure(std::move(row.error()));
    study.rows.push_back(*row);
  }
  return study;
}

Result<void> write_convergence(const std::filesystem::path& out, const ConvergenceStudy& study) {
  std::string csv =
      "resolution_mm3,nodes,unknowns,tip_mm,error_mm,error_eq_6_6_mm,rms_error_mm,iterations,relative_residual,setup_s,"
      "solve_ms\n";
  Json document{
      {"theory_tip_mm", study.theory_tip_mm}, {"eq_6_6_tip_mm", study.eq_6_6_tip_mm}, {"rows", Json::array()}};
  Json points = Json::array();
  double before_mm = 0;
  for (const ConvergenceRow& row : study.rows) {
    csv += fmt::format("{:.6g},{},{},{:.6g},{:.6g},{:.6g},{:.6g},{},{:.3g},{:.4g},{:.4g}\n", row.resolution_mm3,
                       row.nodes, row.unknowns, row.tip_mm, row.error_mm, row.error_eq_6_6_mm, row.rms_error_mm,
                       row.iterations, row.relative_residual, row.setup_s, row.solve_ms);
    document["rows"].push_back({{"resolution_mm3", row.resolution_mm3},
                                {"nodes", row.nodes},
                                {"unknowns", row.unknowns},
                                {"tip_mm", row.tip_mm},
                                {"error_mm", row.error_mm},
                                {"error_eq_6_6_mm", row.error_eq_6_6_mm},
                                {"rms_error_mm", row.rms_error_mm},
                                {"setup_s", row.setup_s},
                                {"solve_ms", row.solve_ms}});
    if (row.error_mm > before_mm) {
      points.push_back({{"resolution_mm3", rounded(row.resolution_mm3)}, {"error_mm", rounded(row.error_mm)}});
      before_mm = row.error_mm;
    }
  }
  const Json curve{
      {"format", "glisson-convergence/1"},
      {"source", "computed"},
      {"provenance",
       fmt::format("glisson-cli study convergence (Glisson {}): what is missing of the {:.1f} mm by which the tip of "
                   "the cantilever of table 6.1 sinks under its weight (eq. 6.6 with Timoshenko's shear), meshfree "
                   "engine.",
                   version(), study.theory_tip_mm)},
      {"youngs_kPa", youngs_kPa},
      {"points", points}};
  report::Page page;
  page.title = "Convergence with resolution";
  page.subtitle = "The cantilever of table 6.1, meshfree, against beam theory";
  page.blocks = {
      report::Paragraph{fmt::format(
          "50 x 10 x 10 mm, 12 kPa, 997 kg/m3, Poisson's ratio 0, under its own weight. Theory puts the tip {:.2f} "
          "mm lower: {:.2f} mm by eq. 6.6, the rest by shear. Few nodes cannot bend as far: the error is what "
          "is missing.",
          study.theory_tip_mm, study.eq_6_6_tip_mm)},
      plot_of(study), table_of(study)};
  page.footer = fmt::format("Glisson {}. Not a medical device.", version());
  return write_together([&] {
    return write_text_file(out / "convergence.csv", csv)
        .and_then([&] { return write_json_file(out / "summary.json", document); })
        .and_then([&] { return write_json_file(out / "convergence.json", curve); })
        .and_then([&] { return report::write_html(out / "report.html", page); });
  });
}

namespace {

double rounded(double value) { return std::stod(fmt::format("{:.5g}", value)); }

double eq_6_6_mm(double x_mm) {
  return load_mN_per_mm * x_mm * x_mm *
         (6 * beam_length_mm * beam_length_mm - 4 * beam_length_mm * x_mm + x_mm * x_mm) /
         (24 * youngs_kPa * inertia_mm4);
}

// Cowper's kappa for a rectangle is 10 (1 + nu) / (12 + 11 nu), and G is E / 2 at nu = 0.
double shear_mm(double x_mm) {
  return load_mN_per_mm * (beam_length_mm * x_mm - x_mm * x_mm / 2) /
         (10.0 / 12.0 * youngs_kPa / 2 * beam_side_mm * beam_side_mm);
}

// The background mesh has a few points for every node, so that the nodes and not the mesh are what is coarse.
Result<ConvergenceRow> row_of(int nodes, const Progress& progress) {
  const int across = std::clamp(static_cast<int>(std::lround(std::cbrt(nodes))), 4, 14);
  geometry::TetMesh mesh = beam_mesh({5 * across, across, across}, {beam_length_mm, beam_side_mm, beam_side_mm});
  name_beam_end(mesh, held);
  mechanics::StaticOptions options;
  options.poisson_ratio = 0;
  options.density_kg_mm3 = beam_density_kg_mm3;
  options.memory_limit_bytes = std::uint64_t{3} << 30;
  const auto model = mechanics::MeshfreeModel::create(
      mesh, std::vector<double>(mesh.cells.size(), youngs_kPa), {{mechanics::NamedPoints{held}, mechanics::Fixed{}}},
      mechanics::MaterialLaw::linear, options, {.nodes = nodes}, {}, progress);
  if (!model) return failure(model.error());
  const auto result = model->solve({mechanics::GravityLoad{{0, 0, -9810.0}}});
  if (!result) return failure(result.error());
  if (!result->may_be_used()) {
    return failure("not-converged", GLISSON_TEXT("With {0} nodes the beam did not converge: {1}"),
                   {std::to_string(nodes), mechanics::why_not_used(*result)});
  }

  std::vector<Vector3d> axis_mm;
  for (int i = 1; i <= 20; ++i) axis_mm.emplace_back(beam_length_mm * i / 20, beam_side_mm / 2, beam_side_mm / 2);
  const auto moved = model->displacement_at(*result, mechanics::locate_points(model->mesh(), axis_mm));
  ConvergenceRow row;
  row.nodes = static_cast<int>(model->shape_functions().nodes_mm.size());
  row.resolution_mm3 = volume_mm3 / row.nodes;
  row.unknowns = model->cost().unknowns;
  row.tip_mm = -moved.back().z();
  row.error_eq_6_6_mm = std::abs(row.tip_mm - eq_6_6_mm(beam_length_mm));
  row.error_mm = std::abs(row.tip_mm - eq_6_6_mm(beam_length_mm) - shear_mm(beam_length_mm));
  for (std::size_t i = 0; i < axis_mm.size(); ++i) {
    const double theory_mm = eq_6_6_mm(axis_mm[i].x()) + shear_mm(axis_mm[i].x());
    row.rms_error_mm += std::pow(-moved[i].z() - theory_mm, 2) / double(axis_mm.size());
  }
  row.rms_error_mm = std::sqrt(row.rms_error_mm);
  row.iterations = result->iterations;
  row.relative_residual = result->relative_residual;
  row.setup_s = result->setup_s;
  row.solve_ms = result->step_ms;
  return row;
}

report::Table table_of(const ConvergenceStudy& study) {
  report::Table table{
      "Errors at the tip, and over the axis (rms).",
      {"mm3 a node", "nodes", "tip (mm)", "error (mm)", "against eq. 6.6 (mm)", "rms (mm)", "set-up (s)", "solve (ms)"},
      {}};
  for (const ConvergenceRow& row : study.rows) {
    table.rows.push_back({{fmt::format("{:.2f}", row.resolution_mm3)},
                          {std::to_string(row.nodes)},
                          {fmt::format("{:.2f}", row.tip_mm)},
                          {fmt::format("{:.2f}", row.error_mm)},
                          {fmt::format("{:.2f}", row.error_eq_6_6_mm)},
                          {fmt::format("{:.2f}", row.rms_error_mm)},
                          {fmt::format("{:.2f}", row.setup_s)},
                          {fmt::format("{:.1f}", row.solve_ms)}});
  }
  return table;
}

report::Plot plot_of(const ConvergenceStudy& study) {
  report::PlotCurve ours{"here", {}, report::PlotCurve::Style::line};
  for (const ConvergenceRow& row : study.rows) ours.points.emplace_back(row.resolution_mm3, row.error_mm);
  report::PlotCurve dissertation{"the ends of figure 6.5", {{1.65, 1}, {165, 8}}, report::PlotCurve::Style::dots};
  return {.caption = "What is missing of the tip's deflection.",
          .x_title = "volume of a node (mm3)",
          .y_title = "missing at the tip (mm)",
          .curves = {std::move(ours), std::move(dissertation)}};
}

}  // namespace
}  // namespace glisson::studies

#include "studies/dissertation/palpation.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <numbers>
#include <random>

#include "base/files.h"
#include "base/json.h"
#include "base/units.h"
#include "base/write_file.h"
#include "geometry/mesh_file.h"
#include "geometry/nearest.h"
#include "geometry/tetrahedra.h"
#include "mechanics/statics/static_model.h"
#include "mechanics/statics/validity.h"
#include "registration/rigid.h"
#include "report/html.h"

namespace glisson::studies {
namespace fs = std::filesystem;
namespace {

using Eigen::Vector3d;
using geometry::Surface;

constexpr double radius_mm = 112.5;
constexpr double height_mm = 26;

// What the testing machine found of the two compounds: the medians of table 4.5's samples.
constexpr double machine_soft_kPa = 18.163;
constexpr double machine_stiff_kPa = 35.07;

struct Scans {
  Surface rest, pressed;
};
geometry::TetMesh cylinder(int bricks_across, int bricks_high);
Result<Scans> simulated_scans(const PalpationTrial& trial, const PalpationOptions& options);
Result<Scans> scans_in(const fs::path& folder, const PalpationTrial& trial);
Result<NamedNumbers> compare(const PressedPhantom& model, const Scans& scans, const PalpationOptions& options);
Result<void> write_outcome(const fs::path& out, const PalpationSummary& summary, const PalpationOptions& options);

}  // namespace

std::string PalpationTrial::name() const { return fmt::format("{}-{:.2f}N", phantom, force_N); }

const std::vector<PalpationTrial>& dissertation_trials() {
  static const std::vector<PalpationTrial> trials{{"A", 1.69, 3.14},  {"A", 3.85, 3.24},  {"A", 7.81, 0.43},
                                                  {"B", 0.78, 2.33},  {"B", 4.02, 3.86},  {"B", 7.03, 1.48},
                                                  {"AB", 2.73, 1.66}, {"AB", 4.20, 3.10}, {"AB", 6.42, 0.98}};
  return trials;
}

Result<PalpationSummary> run_palpation(const fs::path& out, const PalpationOptions& options, const Progress& progress) {
  std::vector<PalpationTrial> trials = dissertation_trials();
  if (options.scans) {
    std::erase_if(trials, [&](const PalpationTrial& trial) {
      std::error_code problem;
      return !fs::exists(*options.scans / (trial.name() + ".ply"), problem);
    });
    if (trials.empty()) {
      return failure(Error{"palpation-no-scans",
                           GLISSON_TEXT("{0} holds none of the scans, such as A-1.69N.ply."),
                           {options.scans->string()},
                           {},
                           *options.scans});
    }
  }
  std::vector<BatchPatient> jobs;
  for (const PalpationTrial& trial : trials) {
    std::string fingerprint = fmt::format("palpation/1 {:g} {:g} {:g} {:g}", options.soft_kPa, options.stiff_kPa,
                                          options.poisson_ratio, options.tool_radius_mm);
    if (options.scans) fingerprint += sha256_of_file(*options.scans / (trial.name() + ".ply")).value_or(" unreadable");
    jobs.push_back({trial.name(), std::move(fingerprint)});
  }
  const auto compute = [&](std::size_t n) -> Result<NamedNumbers> {
    const PalpationTrial& trial = trials[n];
    const auto model = press(trial.phantom, trial.force_N, options.soft_kPa, options.stiff_kPa, options);
    if (!model) return failure(model.error());
    const auto scans = options.scans ? scans_in(*options.scans, trial) : simulated_scans(trial, options);
    if (!scans) return failure(scans.error());
    return compare(*model, *scans, options);
  };
  auto rows = run_batch(out, jobs, compute, {}, progress);
  if (!rows) return failure(rows.error());

  PalpationSummary summary;
  summary.rows = std::move(*rows);
  summary.simulated_scans = !options.scans.has_value();
  double count = 0;
  for (std::size_t n = 0; n < trials.size(); ++n) {
    if (!summary.rows[n].error.empty()) continue;
    const double mean_mm = column_of({summary.rows[n]}, "mean_mm").front();
    count += 1;
    summary.mean_mm += mean_mm;
    summary.reported_mean_mm += trials[n].reported_mm;
    summary.worst_mm = std::max(summary.worst_mm, mean_mm);
  }
  if (count == 0) {
    return failure("palpation-all-failed", GLISSON_TEXT("None of the trials could be compared; the first one: {0}"),
                   {summary.rows.front().error});
  }
  summary.mean_mm /= count;
  summary.reported_mean_mm /= count;
  if (auto written = write_outcome(out, summary, options); !written) return failure(written.error());
  return summary;
}

Result<PressedPhantom> press(const std::string& phantom, double force_N, double soft_kPa, double stiff_kPa,
                             const PalpationOptions& options) {
  geometry::TetMesh mesh = cylinder(16, 3);
  std::vector<double> youngs_kPa;
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    const bool upper = geometry::cell_centroid_mm(mesh, cell).z() > 0.5 * height_mm;
    youngs_kPa.push_back(phantom == "A" || (phantom == "AB" && upper) ? soft_kPa : stiff_kPa);
  }
  mechanics::StaticOptions statics;
  statics.poisson_ratio = options.poisson_ratio;
  const geometry::Box bottom{{-200, -200, -1}, {200, 200, 1e-6}};
  const auto model = mechanics::StaticModel::create(mesh, youngs_kPa, {{bottom, mechanics::Fixed{}}}, statics);
  if (!model) return failure(model.error());
  const Vector3d middle(0, 0, height_mm);
  const auto solved =
      model->solve({mechanics::ToolLoad{middle, options.tool_radius_mm, Vector3d(0, 0, -units::mN_from_N(force_N))}});
  if (!solved) return failure(solved.error());
  if (!solved->may_be_used()) {
    return failure("palpation-not-converged", GLISSON_TEXT("The phantom's equilibrium was not reached: {0}"),
                   {mechanics::why_not_used(*solved)});
  }
  PressedPhantom pressed{geometry::boundary_surface(mesh), {}, 0, solved->largest_strain};
  pressed.pressed = pressed.rest;
  const geometry::Field* mesh_point = geometry::find_field(pressed.rest.point_fields, "mesh_point");
  GLISSON_ASSERT(mesh_point != nullptr);
  double nearest_mm = radius_mm;
  for (std::size_t p = 0; p < pressed.rest.points_mm.size(); ++p) {
    const Vector3d& u = solved->displacement_mm[static_cast<std::size_t>(mesh_point->values[p])];
    pressed.pressed.points_mm[p] += u;
    const double away_mm = (pressed.rest.points_mm[p] - middle).norm();
    if (away_mm < nearest_mm) {
      nearest_mm = away_mm;
      pressed.depth_mm = -u.z();
    }
  }
  return pressed;
}

namespace {

// Bricks of six tetrahedra over a square, and the square bent to a disc: (u, v) to (u sqrt(1 - v2/2), v sqrt(1 -
// u2/2)).
geometry::TetMesh cylinder(int bricks_across, int bricks_high) {
  geometry::TetMesh mesh;
  const auto point = [&](int i, int j, int k) { return i + (bricks_across + 1) * (j + (bricks_across + 1) * k); };
  for (int k = 0; k <= bricks_high; ++k) {
    for (int j = 0; j <= bricks_across; ++j) {
      for (int i = 0; i <= bricks_across; ++i) {
        const double u = 2.0 * i / bricks_across - 1;
        const double v = 2.0 * j / bricks_across - 1;
        mesh.points_mm.emplace_back(radius_mm * u * std::sqrt(1 - v * v / 2), radius_mm * v * std::sqrt(1 - u * u / 2),
                                    height_mm * k / bricks_high);
      }
    }
  }
  constexpr std::array<std::array<std::size_t, 3>, 6> walks{
      {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
  for (int k = 0; k < bricks_high; ++k) {
    for (int j = 0; j < bricks_across; ++j) {
      for (int i = 0; i < bricks_across; ++i) {
        for (const auto& walk : walks) {
          std::array<int, 3> at{i, j, k};
          std::array<int, 4> cell{point(at[0], at[1], at[2])};
          for (std::size_t step = 0; step < 3; ++step) {
            ++at[walk[step]];
            cell[step + 1] = point(at[0], at[1], at[2]);
          }
          mesh.cells.push_back(cell);
          if (geometry::cell_volume_mm3(mesh, mesh.cells.size() - 1) < 0)
            std::swap(mesh.cells.back()[2], mesh.cells.back()[3]);
        }
      }
    }
  }
  return mesh;
}

// What a scanner in front of the phantom sees of it: faces turned towards it that the tool does not hide.
Surface seen(const Surface& surface, double hidden_radius_mm) {
  const Vector3d towards_scanner = Vector3d(0.2, -0.6, 0.8).normalized();
  Surface part;
  part.points_mm = surface.points_mm;
  for (const auto& triangle : surface.triangles) {
    const auto corner = [&](std::size_t n) { return surface.points_mm[static_cast<std::size_t>(triangle[n])]; };
    const Vector3d normal = (corner(1) - corner(0)).cross(corner(2) - corner(0));
    const Vector3d centre = (corner(0) + corner(1) + corner(2)) / 3;
    const bool hidden = centre.z() > 0.5 * height_mm && centre.head<2>().norm() < hidden_radius_mm;
    if (normal.dot(towards_scanner) > 0 && !hidden) part.triangles.push_back(triangle);
  }
  return part;
}

Result<Scans> simulated_scans(const PalpationTrial& trial, const PalpationOptions& options) {
  const auto truth = press(trial.phantom, trial.force_N, machine_soft_kPa, machine_stiff_kPa, options);
  if (!truth) return failure(truth.error());
  // The tool's tip hides the middle of where it presses.
  const double hidden_mm = trial.force_N > 0 ? 0.5 * options.tool_radius_mm : 0;
  Scans scans{seen(truth->rest, 0), seen(truth->pressed, hidden_mm)};
  // A person places the scan by hand to within 5 degrees and some millimetres.
  std::mt19937 random(static_cast<unsigned>(std::lround(100 * trial.force_N)));
  const Eigen::Isometry3d rough =
      Eigen::Translation3d(5, -4, 3) * Eigen::AngleAxisd(5 * std::numbers::pi / 180, Vector3d(1, 2, 0.5).normalized());
  for (Surface* scan : {&scans.rest, &scans.pressed}) {
    for (Vector3d& point : scan->points_mm) {
      for (double& coordinate : point) {
        // The sum of twelve uniform numbers: normal enough, and the same everywhere.
        double sum = -6;
        for (int n = 0; n < 12; ++n) sum += static_cast<double>(random()) / 4294967296.0;
        coordinate += 0.1 * sum;
      }
      point = rough * point;
    }
  }
  return scans;
}

Result<Scans> scans_in(const fs::path& folder, const PalpationTrial& trial) {
  auto rest = geometry::read_surface(folder / (trial.phantom + "-rest.ply"));
  if (!rest) return failure(rest.error());
  auto pressed = geometry::read_surface(folder / (trial.name() + ".ply"));
  if (!pressed) return failure(pressed.error());
  return Scans{std::move(*rest), std::move(*pressed)};
}

Result<NamedNumbers> compare(const PressedPhantom& model, const Scans& scans, const PalpationOptions& options) {
  registration::RigidIcpOptions icp;
  icp.overlap = registration::Overlap::source_is_part;
  const auto aligned = registration::rigid_icp(scans.rest, model.rest, icp);
  if (!aligned) return failure(aligned.error());
  const Surface scan = registration::moved(scans.pressed, aligned->transform);
  const geometry::SurfaceDistance distance(model.pressed);
  double sum = 0;
  double squares = 0;
  double worst = 0;
  double near = 0;
  double near_count = 0;
  std::vector<bool> used(scan.points_mm.size(), false);
  for (const auto& triangle : scan.triangles) {
    for (const int corner : triangle) used[static_cast<std::size_t>(corner)] = true;
  }
  double count = 0;
  for (std::size_t p = 0; p < scan.points_mm.size(); ++p) {
    if (!used[p]) continue;
    const double away_mm = distance.closest(scan.points_mm[p]).distance_mm;
    count += 1;
    sum += away_mm;
    squares += away_mm * away_mm;
    worst = std::max(worst, away_mm);
    const bool top = scan.points_mm[p].z() > 0.5 * height_mm;
    if (!top || scan.points_mm[p].head<2>().norm() > 2 * options.tool_radius_mm) continue;
    near += away_mm;
    near_count += 1;
  }
  return NamedNumbers{{"mean_mm", sum / count},
                      {"rms_mm", std::sqrt(squares / count)},
                      {"max_mm", worst},
                      {"near_tool_mm", near_count > 0 ? near / near_count : 0},
                      {"depth_mm", model.depth_mm},
                      {"largest_strain", model.largest_strain},
                      {"alignment_mm", aligned->rms_mm},
                      {"scan_points", count}};
}

double reported_of(const std::string& name) {
  for (const PalpationTrial& trial : dissertation_trials()) {
    if (trial.name() == name) return trial.reported_mm;
  }
  return 0;
}

Result<void> write_outcome(const fs::path& out, const PalpationSummary& summary, const PalpationOptions& options) {
  Json document{{"trials", Json::array()},
                {"mean_mm", summary.mean_mm},
                {"worst_mm", summary.worst_mm},
                {"dissertation_text_mm", reported_mean_in_text_mm},
                {"dissertation_table_mm", summary.reported_mean_mm},
                {"scans", summary.simulated_scans ? "simulated" : "given"},
                {"tool_radius_mm", options.tool_radius_mm}};
  report::Table table{"Distance of the scanned from the simulated surface.",
                      {"Trial", "Mean (mm)", "Near the tool (mm)", "Largest (mm)", "Pressed in by (mm)",
                       "Largest strain", "Table 4.4 (mm)"},
                      {}};
  report::Plot plot{"Mean distance, and what table 4.4 reports.", "force (N)", "distance (mm)", {}, {}, {}, {}};
  report::PlotCurve ours{"here", {}, report::PlotCurve::Style::dots};
  report::PlotCurve theirs{"table 4.4", {}, report::PlotCurve::Style::dots};
  for (const BatchRow& row : summary.rows) {
    Json json{{"trial", row.id}, {"reported_mm", reported_of(row.id)}};
    for (const auto& [name, value] : row.values) json[name] = value;
    if (!row.error.empty()) {
      json["error"] = row.error;
      table.rows.push_back({{row.id}, {row.error, report::Cell::Emphasis::flag}});
    } else {
      const auto cell = [&](const char* name) {
        return report::Cell{fmt::format("{:.2f}", column_of({row}, name).front())};
      };
      table.rows.push_back({{row.id},
                            cell("mean_mm"),
                            cell("near_tool_mm"),
                            cell("max_mm"),
                            cell("depth_mm"),
                            cell("largest_strain"),
                            {fmt::format("{:.2f}", reported_of(row.id))}});
      for (const PalpationTrial& trial : dissertation_trials()) {
        if (trial.name() != row.id) continue;
        ours.points.emplace_back(trial.force_N, column_of({row}, "mean_mm").front());
        theirs.points.emplace_back(trial.force_N, trial.reported_mm);
      }
    }
    document["trials"].push_back(std::move(json));
  }
  plot.curves = {std::move(ours), std::move(theirs)};
  report::Page page;
  page.title = "A phantom pressed: simulation against surface scans";
  page.subtitle = "Dissertation, section 4.5";
  if (summary.simulated_scans) page.warning = "The scans are SIMULATED: no phantom was measured here.";
  page.footer = fmt::format("Glisson {}. Research software; not a medical device.", version());
  page.blocks = {
      report::Paragraph{fmt::format(
          "On average the scanned surface lies {:.2f} mm from the simulated one ({:.2f} mm in the worst "
          "trial). The dissertation reports {:.2f} mm in its text, while the errors of table 4.4 for the "
          "same trials average {:.2f} mm. The tool is taken to press on a disc of {:.0f} mm radius, which the "
          "dissertation does not say.",
          summary.mean_mm, summary.worst_mm, reported_mean_in_text_mm, summary.reported_mean_mm,
          options.tool_radius_mm)},
      std::move(table), std::move(plot)};
  return write_together([&] {
    return write_batch_csv(out / "palpation.csv", summary.rows)
        .and_then([&] { return write_json_file(out / "summary.json", document); })
        .and_then([&] { return report::write_html(out / "report.html", page); });
  });
}

}  // namespace
}  // namespace glisson::studies

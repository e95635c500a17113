#include "studies/dissertation/beam_regions.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "base/files.h"
#include "base/json.h"
#include "base/units.h"
#include "base/write_file.h"
#include "mechanics/meshfree/compliance_distance.h"
#include "mechanics/meshfree/meshfree_model.h"
#include "mechanics/statics/static_model.h"
#include "report/html.h"
#include "studies/dissertation/internal/beam_mesh.h"

namespace glisson::studies {
namespace {

using Eigen::Vector3d;

constexpr double length_mm = 50, side_mm = 10, density_kg_mm3 = 997e-9, poisson_ratio = 0.45;
constexpr double grid_mm = beam_voxel_mm;
constexpr int along = 20, across = 4;  // voxels of a beam

std::size_t beams_voxel(const imaging::Grid& grid, const std::array<int, 3>& corner, int axis, int i, int j, int k);
// Young's modulus of a beam's cells, as the liver has it there.
std::vector<double> sampled_kPa(const geometry::TetMesh& beam, const mechanics::VoxelBody& liver,
                                const BeamPlace& place);
Result<mechanics::StaticResult> hoisted(const geometry::TetMesh& beam, const std::vector<double>& youngs_kPa,
                                        const BeamOptions& options);
double mean_by_volume(const geometry::TetMesh& mesh, const std::vector<double>& values);
report::Plot plot_of(const std::vector<BeamRow>& rows, const BeamOptions& options);
report::Table table_of(const std::vector<BeamRow>& rows, const BeamOptions& options);

}  // namespace

Result<std::array<BeamPlace, 3>> beam_places(const geometry::TetMesh& liver, const std::vector<double>& youngs_kPa) {
  return beam_places(mechanics::voxelise(liver, youngs_kPa, grid_mm));
}

Result<std::array<BeamPlace, 3>> beam_places(const mechanics::VoxelBody& tissue) {
  const imaging::Grid& grid = tissue.body.grid;
  std::array<BeamPlace, 3> best;
  bool any = false;
  for (int axis = 0; axis < 3; ++axis) {
    std::array<int, 3> size{across, across, across};
    size[static_cast<std::size_t>(axis)] = along;
    for (int z = 0; z + size[2] <= grid.size[2]; z += 2) {
      for (int y = 0; y + size[1] <= grid.size[1]; y += 2) {
        for (int x = 0; x + size[0] <= grid.size[0]; x += 2) {
          double sum = 0, squares = 0;
          bool inside = true;
          for (int k = 0; k < across && inside; ++k) {
            for (int j = 0; j < across && inside; ++j) {
              for (int i = 0; i < along && inside; ++i) {
                const std::size_t voxel = beams_voxel(grid, {x, y, z}, axis, i, j, k);
                inside = tissue.body.values[voxel] != 0;
                sum += tissue.youngs_kPa[voxel];
                squares += double(tissue.youngs_kPa[voxel]) * tissue.youngs_kPa[voxel];
              }
            }
          }
          if (!inside) continue;
          constexpr double count = along * across * across;
          const double mean = sum / count;
          const BeamPlace place{grid.position_mm(x, y, z) - Vector3d::Constant(0.5 * grid_mm), axis, mean,
                                std::sqrt(std::max(0.0, squares / count - mean * mean))};
          if (!any || place.mean_kPa < best[0].mean_kPa) best[0] = place;
          if (!any || place.mean_kPa > best[1].mean_kPa) best[1] = place;
          if (!any || place.sd_kPa > best[2].sd_kPa) best[2] = place;
          any = true;
        }
      }
    }
  }
  if (any) return best;
  return failure("liver-too-small", GLISSON_TEXT("No beam of 50 x 10 x 10 mm fits into the liver."));
}

Result<BeamRow> compare_beams(const std::string& patient, const geometry::TetMesh& liver,
                              const std::vector<double>& youngs_kPa, const BeamOptions& options,
                              const Progress& progress) {
  return compare_beams(patient, mechanics::voxelise(liver, youngs_kPa, grid_mm), mean_by_volume(liver, youngs_kPa),
                       options, progress);
}

Result<BeamRow> compare_beams(const std::string& patient, const mechanics::VoxelBody& tissue, double mean_kPa,
                              const BeamOptions& options, const Progress& progress) {
  progress.report(0.0, GLISSON_TEXT("Looking for the softest, stiffest and most uneven parts"));
  const auto places = beam_places(tissue);
  if (!places) return failure(places.error());
  geometry::TetMesh beam = beam_mesh({20, 4, 4}, {length_mm, side_mm, side_mm});
  geometry::Field ends{"ends", 1, {}};
  for (const Vector3d& p : beam.points_mm) ends.values.push_back(p.x() == 0 || p.x() == length_mm ? 1.0 : 0.0);
  geometry::set_field(beam.point_fields, std::move(ends));

  BeamRow row;
  row.patient = patient;
  row.mean_kPa = mean_kPa;
  progress.report(0.2, GLISSON_TEXT("Hoisting the beams"));
  const auto control = hoisted(beam, std::vector<double>(beam.cells.size(), row.mean_kPa), options);
  if (!control) return failure(control.error());
  row.control_displacement_mm = control->max_displacement_mm;
  const geometry::Surface at_rest = geometry::boundary_surface(beam);
  const geometry::Field surface_points = *geometry::find_field(at_rest.point_fields, "mesh_point");
  for (std::size_t r = 0; r < places->size(); ++r) {
    progress.report(0.4 + 0.2 * double(r), GLISSON_TEXT("Hoisting the beams"));
    if (progress.cancelled()) return cancelled();
    BeamComparison& region = row.regions[r];
    region.place = (*places)[r];
    const auto result = hoisted(beam, sampled_kPa(beam, tissue, region.place), options);
    if (!result) return failure(result.error());
    region.largest_displacement_mm = result->max_displacement_mm;
    region.lifted = at_rest;
    geometry::Field apart{"apart_mm", 1, {}};
    for (std::size_t s = 0; s < surface_points.values.size(); ++s) {
      const auto point = static_cast<std::size_t>(surface_points.values[s]);
      const double apart_mm = (result->displacement_mm[point] - control->displacement_mm[point]).norm();
      region.mean_mm += apart_mm / double(surface_points.values.size());
      region.max_mm = std::max(region.max_mm, apart_mm);
      region.lifted.points_mm[s] += result->displacement_mm[point];
      apart.values.push_back(apart_mm);
    }
    geometry::set_field(region.lifted.point_fields, std::move(apart));
  }
  return row;
}

Result<void> write_beams(const std::filesystem::path& out, const std::vector<BeamRow>& rows,
                         const BeamOptions& options) {
  std::string csv = "patient,mean_kPa,control_mm";
  for (const char* name : {"soft", "stiff", "uneven"}) {
    csv += fmt::format(",{0}_mean_kPa,{0}_sd_kPa,{0}_displacement_mm,{0}_apart_mean_mm,{0}_apart_max_mm", name);
  }
  csv += "\n";
  Json document{{"force_N", options.force_N},
                {"foundation_kPa_per_mm", options.foundation_kPa_per_mm},
                {"significant_mm", options.significant_mm},
                {"rows", Json::array()}};
  std::array<int, 3> significant{};
  for (const BeamRow& row : rows) {
    csv += fmt::format("{},{:.6g},{:.6g}", row.patient, row.mean_kPa, row.control_displacement_mm);
    Json json{{"patient", row.patient}, {"mean_kPa", row.mean_kPa}, {"control_mm", row.control_displacement_mm}};
    for (std::size_t r = 0; r < row.regions.size(); ++r) {
      const BeamComparison& region = row.regions[r];
      csv += fmt::format(",{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}", region.place.mean_kPa, region.place.sd_kPa,
                         region.largest_displacement_mm, region.mean_mm, region.max_mm);
      const bool matters = region.max_mm >= options.significant_mm;
      significant[r] += matters ? 1 : 0;
      const Vector3d& corner = region.place.corner_mm;
      json["regions"].push_back({{"region", region_names[r]},
                                 {"corner_mm", {corner.x(), corner.y(), corner.z()}},
                                 {"axis", std::string(1, "xyz"[region.place.axis])},
                                 {"mean_kPa", region.place.mean_kPa},
                                 {"sd_kPa", region.place.sd_kPa},
                                 {"displacement_mm", region.largest_displacement_mm},
                                 {"apart_mean_mm", region.mean_mm},
                                 {"apart_max_mm", region.max_mm},
                                 {"significant", matters}});
    }
    csv += "\n";
    document["rows"].push_back(std::move(json));
  }
  std::string sentence =
      fmt::format("Of {} patients, the beam of the liver's mean misplaces the surface by {:.0f} mm or more",
                  rows.size(), options.significant_mm);
  for (std::size_t r = 0; r < significant.size(); ++r) {
    document["significant"][region_names[r]] = significant[r];
    sentence += fmt::format("{} in {} where the liver is {}",
                            r == 0   ? ""
                            : r == 1 ? ","
                                     : " and",
                            significant[r], region_names[r]);
  }
  report::Page page;
  page.title = "Beams of soft, stiff and uneven tissue";
  page.subtitle = "Against a beam of the liver's mean stiffness (section 4.4, table 4.1)";
  page.blocks = {
      report::Paragraph{sentence + "."},
      report::Paragraph{fmt::format(
          "50 x 10 x 10 mm, lifted by {:.3g} N at the middle, both ends on an abdominal wall of 22 kPa ({:.2g} "
          "kPa/mm: a layer of 20 mm, our assumption, as is where the force acts). Meshfree, corotational.",
          options.force_N, options.foundation_kPa_per_mm)},
      plot_of(rows, options), table_of(rows, options)};
  page.footer = fmt::format("Glisson {}. Not a medical device.", version());
  return write_together([&] {
    return write_text_file(out / "beams.csv", csv)
        .and_then([&] { return write_json_file(out / "summary.json", document); })
        .and_then([&] { return report::write_html(out / "report.html", page); });
  });
}

namespace {

// The beam's own i runs along its axis, j and k along the next two.
std::size_t beams_voxel(const imaging::Grid& grid, const std::array<int, 3>& corner, int axis, int i, int j, int k) {
  std::array<int, 3> at = corner;
  at[static_cast<std::size_t>(axis)] += i;
  at[static_cast<std::size_t>((axis + 1) % 3)] += j;
  at[static_cast<std::size_t>((axis + 2) % 3)] += k;
  return grid.offset(at[0], at[1], at[2]);
}

std::vector<double> sampled_kPa(const geometry::TetMesh& beam, const mechanics::VoxelBody& liver,
                                const BeamPlace& place) {
  std::vector<double> youngs_kPa;
  for (std::size_t c = 0; c < beam.cells.size(); ++c) {
    const Vector3d own_mm = geometry::cell_centroid_mm(beam, c);
    Vector3d place_mm = place.corner_mm;
    for (int d = 0; d < 3; ++d) place_mm[(place.axis + d) % 3] += own_mm[d];
    const Eigen::Vector3i at = liver.body.grid.index_of(place_mm).array().round().cast<int>();
    youngs_kPa.push_back(liver.youngs_kPa[liver.body.grid.offset(at.x(), at.y(), at.z())]);
  }
  return youngs_kPa;
}

Result<mechanics::StaticResult> hoisted(const geometry::TetMesh& beam, const std::vector<double>& youngs_kPa,
                                        const BeamOptions& options) {
  mechanics::StaticOptions material;
  material.poisson_ratio = poisson_ratio;
  material.density_kg_mm3 = density_kg_mm3;
  const std::vector<mechanics::Support> wall{
      {mechanics::NamedPoints{"ends"}, mechanics::Foundation{options.foundation_kPa_per_mm}}};
  const mechanics::Loads hoist{
      mechanics::ToolLoad{{length_mm / 2, side_mm / 2, 0}, side_mm / 2, {0, 0, units::mN_from_N(options.force_N)}}};
  Result<mechanics::StaticResult> result = tl::unexpected(Error{});
  if (options.engine == mechanics::Engine::fem) {
    result = mechanics::solve_static(beam, youngs_kPa, wall, hoist, material);
  } else {
    result = mechanics::MeshfreeModel::create(beam, youngs_kPa, wall, mechanics::MaterialLaw::corotational, material,
                                              {.nodes = options.nodes})
                 .and_then([&](const mechanics::MeshfreeModel& model) { return model.solve(hoist); });
  }
  // Of the softest parts cells turn inside out: their answers are compared all the same, as far beyond small strain.
  if (result && !result->converged()) {
    return failure("not-converged", GLISSON_TEXT("A beam found no equilibrium: {0}"), {result->why_stopped});
  }
  return result;
}

double mean_by_volume(const geometry::TetMesh& mesh, const std::vector<double>& values) {
  double sum = 0;
  for (std::size_t c = 0; c < values.size(); ++c) sum += values[c] * geometry::cell_volume_mm3(mesh, c);
  return sum / geometry::volume_mm3(mesh);
}

// What share of the patients is at most so far from the control.
report::Plot plot_of(const std::vector<BeamRow>& rows, const BeamOptions& options) {
  report::Plot plot{.caption = "Patients whose beam is at most so far from the control.",
                    .x_title = "apart from the control at most (mm)",
                    .y_title = "patients (%)"};
  constexpr std::array<report::PlotCurve::Style, 3> styles{
      report::PlotCurve::Style::line, report::PlotCurve::Style::dashes, report::PlotCurve::Style::dots};
  for (std::size_t r = 0; r < region_names.size(); ++r) {
    std::vector<double> apart_mm;
    for (const BeamRow& row : rows) apart_mm.push_back(row.regions[r].max_mm);
    std::sort(apart_mm.begin(), apart_mm.end());
    report::PlotCurve curve{region_names[r], {{0.0, 0.0}}, styles[r]};
    for (std::size_t i = 0; i < apart_mm.size(); ++i) {
      curve.points.emplace_back(apart_mm[i], 100.0 * double(i + 1) / double(apart_mm.size()));
    }
    plot.curves.push_back(std::move(curve));
  }
  plot.rules.push_back({report::Rule::Along::x, options.significant_mm, "matters"});
  return plot;
}

report::Table table_of(const std::vector<BeamRow>& rows, const BeamOptions& options) {
  report::Table table{"Young's modulus of the beams, and how far they are from the control at most.",
                      {"Patient", "liver (kPa)", "control lifted (mm)", "soft (kPa)", "apart (mm)", "stiff (kPa)",
                       "apart (mm)", "uneven (kPa, sd)", "apart (mm)"},
                      {}};
  for (const BeamRow& row : rows) {
    std::vector<report::Cell> cells{
        {row.patient}, {fmt::format("{:.1f}", row.mean_kPa)}, {fmt::format("{:.1f}", row.control_displacement_mm)}};
    for (std::size_t r = 0; r < row.regions.size(); ++r) {
      const BeamComparison& region = row.regions[r];
      cells.push_back({r < 2 ? fmt::format("{:.1f}", region.place.mean_kPa)
                             : fmt::format("{:.1f} ({:.1f})", region.place.mean_kPa, region.place.sd_kPa)});
      const bool matters = region.max_mm >= options.significant_mm;
      cells.push_back({fmt::format("{:.1f}{}", region.max_mm, matters ? " !" : ""),
                       matters ? report::Cell::Emphasis::flag : report::Cell::Emphasis::none});
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

}  // namespace
}  // namespace glisson::studies

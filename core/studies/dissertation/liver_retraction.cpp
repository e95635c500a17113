#include "studies/dissertation/liver_retraction.h"

#include <numeric>

#include "base/units.h"
#include "elastography/cell_stiffness.h"
#include "mechanics/scenario/mesh_moduli.h"
#include "meshing/mesh_labels.h"
#include "rehearsal/liver_supports.h"
#include "rehearsal/tool_presets.h"

namespace glisson::studies {
namespace {

Result<geometry::TetMesh> mesh_of(const imaging::Mask& organ, int target_cells, const Progress& progress) {
  imaging::LabelMap labels{organ.grid, {organ.values.begin(), organ.values.end()}};
  meshing::MeshOptions options;
  options.target_cells = target_cells;
  options.names = {{1, "liver"}};
  auto meshed = meshing::mesh_labels(labels, options, progress);
  if (!meshed) return failure(meshed.error());
  if (auto marked = rehearsal::mark_attachments(meshed->body); !marked) return failure(marked.error());
  return std::move(meshed->body);
}

// Puts Young's modulus on the cells; gives its mean.
Result<double> set_measured_stiffness(geometry::TetMesh& mesh, const MeasuredLiver& liver, double poisson_ratio) {
  std::vector<Eigen::Vector3d> centroids_mm;
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    centroids_mm.push_back(geometry::cell_centroid_mm(mesh, cell));
  }
  elastography::StiffnessOptions options;
  options.poisson_ratio = poisson_ratio;
  auto stiffness = elastography::cell_stiffness(centroids_mm, liver.shear_kPa, liver.reliability(), options);
  if (!stiffness) return failure(stiffness.error());
  mechanics::set_moduli(mesh, std::move(stiffness->youngs_kPa), poisson_ratio);
  return stiffness->mean_kPa;
}

}  // namespace

Result<Retraction> retract(const MeasuredLiver& liver, const RetractionOptions& options, const Progress& progress) {
  auto mesh = mesh_of(liver.organ, options.target_cells, progress.part(0, 0.5));
  if (!mesh) return failure(mesh.error());
  const auto mean_youngs_kPa = set_measured_stiffness(*mesh, liver, options.poisson_ratio);
  if (!mean_youngs_kPa) return failure(mean_youngs_kPa.error());
  const auto placement = rehearsal::hoist_segment_vi(*mesh);
  if (!placement) return failure(placement.error());

  mechanics::Scenario scenario;
  scenario.poisson_ratio = options.poisson_ratio;
  scenario.supports = rehearsal::usual_supports();
  scenario.landmarks = liver.landmarks;
  scenario.loads = {rehearsal::tool_load(*placement, options.force_N)};
  auto measured = mechanics::simulate(*mesh, scenario, {}, progress.part(0.5, 0.65));
  if (!measured) return failure(measured.error());
  scenario.youngs_modulus = *mean_youngs_kPa;
  const auto mean = mechanics::simulate(*mesh, scenario, {}, progress.part(0.65, 0.8));
  if (!mean) return failure(mean.error());
  scenario.youngs_modulus = units::youngs_from_shear(options.atlas_kPa, options.poisson_ratio);
  auto atlas = mechanics::simulate(*mesh, scenario, {}, progress.part(0.8, 0.95));
  if (!atlas) return failure(atlas.error());

  auto measured_against_atlas = rehearsal::compare(*measured, *atlas);
  if (!measured_against_atlas) return failure(measured_against_atlas.error());
  auto mean_against_atlas = rehearsal::compare(*mean, *atlas);
  if (!mean_against_atlas) return failure(mean_against_atlas.error());
  auto measured_against_mean = rehearsal::compare(*measured, *mean);
  if (!measured_against_mean) return failure(measured_against_mean.error());
  return Retraction{std::move(*measured),
                    std::move(*atlas),
                    std::move(*measured_against_atlas),
                    std::move(*mean_against_atlas),
                    std::move(*measured_against_mean),
                    mesh->cells.size(),
                    units::ml_from_mm3(geometry::volume_mm3(*mesh))};
}

}  // namespace glisson::studies

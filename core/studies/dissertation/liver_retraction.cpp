#include "studies/dissertation/liver_retraction.h"

#include <algorithm>

#include "base/units.h"
#include "elastography/cell_stiffness.h"
#include "mechanics/scenario/mesh_moduli.h"
#include "mechanics/statics/validity.h"
#include "meshing/mesh_labels.h"
#include "rehearsal/liver_supports.h"
#include "rehearsal/tool_presets.h"

namespace glisson::studies {
namespace {

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

Result<rehearsal::Comparison> soft_against_stiff_wall(const geometry::TetMesh& mesh, mechanics::Scenario scenario);
// Puts both bodies and their comparison in place of the linear ones, where equilibria are found.
Result<void> answer_at_large_strain(const geometry::TetMesh& mesh, Retraction& retraction, const Progress& progress);
Result<void> answer_by_meshfree(const geometry::TetMesh& mesh, const mechanics::MeshfreeOptions& nodes,
                                Retraction& retraction, const Progress& progress);

}  // namespace

Result<geometry::TetMesh> liver_mesh(const imaging::Mask& organ, int target_cells, const Progress& progress) {
  imaging::LabelMap labels{organ.grid, {organ.values.begin(), organ.values.end()}};
  meshing::MeshOptions options;
  options.target_cells = target_cells;
  options.names = {{1, "liver"}};
  auto meshed = meshing::mesh_labels(labels, options, progress);
  if (!meshed) return failure(meshed.error());
  if (auto marked = rehearsal::mark_attachments(meshed->body); !marked) return failure(marked.error());
  return std::move(meshed->body);
}

Result<Retraction> retract(const MeasuredLiver& liver, const RetractionOptions& options, const Progress& progress) {
  auto mesh = liver_mesh(liver.organ, options.target_cells, progress.part(0, 0.5));
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
  mechanics::Scenario of_reference = scenario, of_mean = scenario;
  of_reference.youngs_modulus = units::youngs_from_shear(options.reference_kPa, options.poisson_ratio);
  of_mean.youngs_modulus = *mean_youngs_kPa;
  auto measured = mechanics::simulate(*mesh, scenario, {}, progress.part(0.5, 0.6));
  if (!measured) return failure(measured.error());
  const auto mean = mechanics::simulate(*mesh, of_mean, {}, progress.part(0.6, 0.65));
  if (!mean) return failure(mean.error());
  auto reference = mechanics::simulate(*mesh, of_reference, {}, progress.part(0.65, 0.7));
  if (!reference) return failure(reference.error());

  auto measured_against_reference = rehearsal::compare(*measured, *reference);
  if (!measured_against_reference) return failure(measured_against_reference.error());
  auto mean_against_reference = rehearsal::compare(*mean, *reference);
  if (!mean_against_reference) return failure(mean_against_reference.error());
  auto measured_against_mean = rehearsal::compare(*measured, *mean);
  if (!measured_against_mean) return failure(measured_against_mean.error());
  Retraction retraction{.measured = std::move(*measured),
                        .reference = std::move(*reference),
                        .measured_against_reference = *measured_against_reference,
                        .linear_measured_against_reference = std::move(*measured_against_reference),
                        .mean_against_reference = std::move(*mean_against_reference),
                        .measured_against_mean = std::move(*measured_against_mean),
                        .cells = mesh->cells.size(),
                        .volume_ml = units::ml_from_mm3(geometry::volume_mm3(*mesh))};
  if (!liver.landmarks.empty()) {
    auto walls = soft_against_stiff_wall(*mesh, scenario);
    if (!walls) return failure(walls.error());
    retraction.soft_against_stiff_wall = std::move(*walls);
  }
  retraction.linear_strain =
      std::max(retraction.measured.result.largest_strain, retraction.reference.result.largest_strain);
  if (options.law == RetractionLaw::by_strain && retraction.linear_strain > mechanics::small_strain_limit) {
    if (auto answered = answer_at_large_strain(*mesh, retraction, progress.part(0.75, 0.85)); !answered) {
      return failure(answered.error());
    }
  }
  if (options.meshfree) {
    auto answered = answer_by_meshfree(*mesh, *options.meshfree, retraction, progress.part(0.85, 1));
    if (!answered) return failure(answered.error());
  }
  return retraction;
}

namespace {

Result<rehearsal::Comparison> soft_against_stiff_wall(const geometry::TetMesh& mesh, mechanics::Scenario scenario) {
  const auto on_wall = [&](double thinner) {
    scenario.supports = rehearsal::usual_supports();
    for (mechanics::Support& support : scenario.supports) {
      if (auto* wall = std::get_if<mechanics::Foundation>(&support.how)) wall->stiffness_kPa_per_mm *= thinner;
    }
    return mechanics::simulate(mesh, scenario);
  };
  const auto soft = on_wall(20.0 / 30), stiff = on_wall(20.0 / 15);
  if (!soft) return failure(soft.error());
  if (!stiff) return failure(stiff.error());
  return rehearsal::compare(*soft, *stiff);
}

// Both bodies otherwise: as `change` makes their scenarios.
struct AnsweredAgain {
  mechanics::Simulation measured, reference;
  rehearsal::Comparison compared;
};
// Nothing where an answer is of no use.
template <typename Change>
Result<std::optional<AnsweredAgain>> answered_again(const geometry::TetMesh& mesh, const Retraction& retraction,
                                                    const Change& change, const Progress& progress) {
  const auto answer = [&](const mechanics::Simulation& before, const Progress& of) {
    mechanics::Scenario scenario = before.scenario;
    change(scenario);
    return mechanics::simulate(mesh, scenario, {}, of);
  };
  auto measured = answer(retraction.measured, progress.part(0, 0.5));
  if (!measured) return failure(measured.error());
  if (!mechanics::validity_of(*measured).usable()) return std::nullopt;
  auto reference = answer(retraction.reference, progress.part(0.5, 1));
  if (!reference) return failure(reference.error());
  if (!mechanics::validity_of(*reference).usable()) return std::nullopt;
  auto compared = rehearsal::compare(*measured, *reference);
  if (!compared) return failure(compared.error());
  return AnsweredAgain{*std::move(measured), *std::move(reference), *std::move(compared)};
}

Result<void> answer_at_large_strain(const geometry::TetMesh& mesh, Retraction& retraction, const Progress& progress) {
  retraction.answered = Retraction::Answered::linear_beyond_it;
  const auto neo_hookean = [](mechanics::Scenario& scenario) {
    scenario.material = mechanics::MaterialLaw::neo_hookean;
  };
  auto again = answered_again(mesh, retraction, neo_hookean, progress);
  if (!again) return failure(std::move(again.error()));
  if (!*again) return {};
  retraction.measured = std::move((*again)->measured);
  retraction.reference = std::move((*again)->reference);
  retraction.measured_against_reference = std::move((*again)->compared);
  retraction.answered = Retraction::Answered::neo_hookean;
  return {};
}

Result<void> answer_by_meshfree(const geometry::TetMesh& mesh, const mechanics::MeshfreeOptions& nodes,
                                Retraction& retraction, const Progress& progress) {
  const auto by_nodes = [&](mechanics::Scenario& scenario) {
    scenario.engine = mechanics::Engine::meshfree;
    scenario.meshfree = nodes;
  };
  auto again = answered_again(mesh, retraction, by_nodes, progress);
  if (!again) return failure(std::move(again.error()));
  if (!*again) return {};
  auto engines = rehearsal::compare((*again)->measured, retraction.measured);
  if (!engines) return failure(engines.error());
  retraction.meshfree = MeshfreeRetraction{std::move((*again)->measured), std::move((*again)->reference),
                                           std::move((*again)->compared), *std::move(engines)};
  return {};
}

}  // namespace
}  // namespace glisson::studies

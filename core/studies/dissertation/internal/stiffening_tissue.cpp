#include "studies/dissertation/internal/stiffening_tissue.h"

#include <fmt/format.h>
#include <cmath>

#include "base/parallel.h"
#include "mechanics/elements/load_vector.h"
#include "mechanics/elements/strain.h"
#include "mechanics/elements/strain_points.h"
#include "mechanics/statics/displacements.h"
#include "mechanics/statics/static_model.h"

namespace glisson::studies {
namespace {

using Eigen::Matrix3d;

double shear_kPa(const StiffeningTissue& tissue) { return tissue.youngs_kPa / (2 * (1 + tissue.poisson_ratio)); }
double bulk_kPa(const StiffeningTissue& tissue) { return tissue.youngs_kPa / (3 * (1 - 2 * tissue.poisson_ratio)); }
double squared_ratio(const StiffeningTissue& tissue, double deviator_length) {
  return deviator_length * deviator_length / (1.5 * tissue.doubles_at * tissue.doubles_at);
}

}  // namespace

Matrix3d StiffeningTissue::stress_kPa(const Matrix3d& strain) const {
  const Matrix3d deviator = strain - strain.trace() / 3 * Matrix3d::Identity();
  return bulk_kPa(*this) * strain.trace() * Matrix3d::Identity() +
         2 * shear_kPa(*this) * (1 + squared_ratio(*this, deviator.norm())) * deviator;
}

mechanics::StressStrain StiffeningTissue::tested(double deviator_length) const {
  const double deviator_kPa = 2 * shear_kPa(*this) * deviator_length * (1 + squared_ratio(*this, deviator_length));
  const double axial_kPa = std::sqrt(1.5) * deviator_kPa;
  return {deviator_length / std::sqrt(1.5) + axial_kPa / (9 * bulk_kPa(*this)), axial_kPa};
}

double StiffeningTissue::relative_tangent(double deviator_length) const {
  return 1 + 3 * squared_ratio(*this, deviator_length);
}

Result<mechanics::StaticResult> equilibrium_of(const StiffeningTissue& tissue, double farthest_deviator,
                                               const geometry::TetMesh& mesh,
                                               const std::vector<mechanics::Support>& supports,
                                               const mechanics::Loads& loads) {
  constexpr int max_steps = 2000;
  constexpr double tolerance = 1e-7;
  mechanics::StaticOptions options;
  options.poisson_ratio = tissue.poisson_ratio;
  const double stiff_kPa = tissue.youngs_kPa * tissue.relative_tangent(farthest_deviator);
  const auto model =
      mechanics::StaticModel::create(mesh, std::vector<double>(mesh.cells.size(), stiff_kPa), supports, options);
  if (!model) return failure(model.error());
  const mechanics::Body& body = model->body();
  const auto load_mN =
      mechanics::load_vector(body.mesh, body.layout, body.boundary, body.options.density_kg_mm3, loads);
  if (!load_mN) return failure(load_mN.error());

  const mechanics::StrainPoints points(body.mesh, body.layout);
  Eigen::VectorXd u_mm = Eigen::VectorXd::Zero(load_mN->size());
  mechanics::StaticResult result;
  result.status = mechanics::SolveStatus::not_converged;
  for (result.iterations = 0; result.iterations < max_steps && !result.converged(); ++result.iterations) {
    std::vector<Matrix3d> stresses_kPa = points.strains_of(u_mm);
    parallel_for(stresses_kPa.size(), 1024, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) stresses_kPa[i] = tissue.stress_kPa(stresses_kPa[i]);
    });
    const auto step = model->solve_nodal(
        {*load_mN + mechanics::foundation_force_mN(body, u_mm) - points.forces_of(stresses_kPa), {}});
    if (!step) return failure(step.error());
    const Eigen::VectorXd step_mm = mechanics::nodal_displacements(body.layout, *step);
    u_mm += step_mm;
    result.relative_residual = step_mm.norm() / u_mm.norm();
    if (!std::isfinite(result.relative_residual)) break;
    if (result.relative_residual <= tolerance) result.status = mechanics::SolveStatus::converged;
  }
  result.why_stopped =
      fmt::format("The last of {} steps was {:.1e} of the displacements.", result.iterations, result.relative_residual);
  mechanics::set_displacements(body, u_mm, result);
  result.inverted_cells = mechanics::strain_range(body.mesh, body.layout, u_mm).inverted_cells;
  for (const Matrix3d& strain : points.strains_of(u_mm)) {
    result.largest_strain = std::max(result.largest_strain, strain.operatorNorm());
  }
  return result;
}

}  // namespace glisson::studies

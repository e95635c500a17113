#include "mechanics/statics/data_driven.h"

#include <fmt/format.h>
#include <cmath>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <numeric>

#include "base/parallel.h"
#include "base/stopwatch.h"
#include "mechanics/elements/body.h"
#include "mechanics/elements/load_vector.h"
#include "mechanics/elements/strain_points.h"
#include "mechanics/statics/displacements.h"

namespace glisson::mechanics {
namespace {

using Eigen::Matrix3d;

// Strain and stress at one integration point.
struct PointState {
  Matrix3d strain = Matrix3d::Zero();
  Matrix3d stress_kPa = Matrix3d::Zero();
};

// Of all states that the data know, the nearest; volume change is linear.
PointState nearest(const MaterialData& data, const PointState& state);
double squared_norm_kPa(const MaterialData& data, const PointState& state);
// Half way: after some rounds states that wander between two sets of neighbours are held to their middle.
constexpr int wander = 60;
// By this share of the data's largest strain a state may pass them before it is said to: what a round leaves open.
constexpr double beyond_data = 0.02;
Matrix3d deviator(const Matrix3d& m) { return m - m.trace() / 3.0 * Matrix3d::Identity(); }
PointState between(const PointState& a, const PointState& b) {
  return {0.5 * (a.strain + b.strain), 0.5 * (a.stress_kPa + b.stress_kPa)};
}
Matrix3d metric_stress_kPa(const MaterialData& data, const Matrix3d& strain);

}  // namespace

Result<DataDrivenResult> find_equilibrium_from_data(const geometry::TetMesh& mesh, const MaterialData& data,
                                                    const std::vector<Support>& supports, const Loads& loads,
                                                    double density_kg_mm3, const DataDrivenOptions& options,
                                                    const Progress& progress) {
  StaticOptions metric;
  metric.poisson_ratio = data.options().poisson_ratio;
  metric.density_kg_mm3 = density_kg_mm3;
  const auto model = StaticModel::create(mesh, std::vector<double>(mesh.cells.size(), data.slope_kPa()), supports,
                                         metric, progress.part(0.0, 0.3));
  if (!model) return failure(model.error());
  const auto load_mN = load_vector(mesh, model->nodes(), boundary_faces(mesh, model->nodes()), density_kg_mm3, loads);
  if (!load_mN) return failure(load_mN.error());

  const Stopwatch watch;
  const StrainPoints points(mesh, model->nodes());
  const NodeLayout& layout = model->nodes();
  const auto solve = [&](const Eigen::VectorXd& force_mN) -> Result<Eigen::VectorXd> {
    return model->solve_nodal({force_mN, {}}).map([&](const StaticResult& result) {
      return nodal_displacements(layout, result);
    });
  };

  const auto spring_force_mN = [&](const Eigen::VectorXd& stretch_mm) -> Eigen::VectorXd {
    return -foundation_force_mN(model->body(), stretch_mm);
  };
  const auto spring_energy_uJ = [&](const Eigen::VectorXd& stretch_mm) {
    return 0.5 * stretch_mm.dot(spring_force_mN(stretch_mm));
  };

  // Where to start: as if the metric were a law. From rest, noise would hold states back wherever they are small.
  const auto start_mm = solve(*load_mN);
  if (!start_mm) return failure(start_mm.error());
  Eigen::VectorXd u_mm = *start_mm;
  Eigen::VectorXd spring_mm = u_mm;  // how far the foundations' springs are stretched, by their own law
  std::vector<PointState> states(points.count()), known(points.count());  // known: what the data say of each
  const std::vector<Matrix3d> first = points.strains_of(u_mm);
  parallel_for(points.count(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) known[i] = nearest(data, {first[i], metric_stress_kPa(data, first[i])});
  });

  DataDrivenResult found;
  double change = 1.0, apart = 1.0;
  const auto settled = [&] { return change <= options.relative_tolerance || apart <= options.close_enough; };
  int round = 0;
  for (; round < options.max_rounds && !settled(); ++round) {
    if (progress.cancelled()) return cancelled();
    progress.report(0.3 + 0.7 * round / options.max_rounds, GLISSON_TEXT("Looking for states that the data know"));
    std::vector<Matrix3d> pulls_kPa(points.count()), stresses_kPa(points.count());
    for (std::size_t i = 0; i < known.size(); ++i) {
      pulls_kPa[i] = metric_stress_kPa(data, known[i].strain);
      stresses_kPa[i] = known[i].stress_kPa;
    }
    // The strains nearest to the data's; and the stresses, which miss balance by what the second solve makes up for.
    const Eigen::VectorXd spring_mN = spring_force_mN(spring_mm);
    const auto next_mm = solve(points.forces_of(pulls_kPa) + spring_mN);
    if (!next_mm) return failure(next_mm.error());
    const auto missing_mm = solve(*load_mN - points.forces_of(stresses_kPa) - spring_mN);
    if (!missing_mm) return failure(missing_mm.error());
    const double size = next_mm->norm();
    change = round < 1 || size == 0 ? 1.0 : (*next_mm - u_mm).norm() / size;
    u_mm = *next_mm;

    const std::vector<Matrix3d> strains = points.strains_of(u_mm), missing = points.strains_of(*missing_mm);
    std::vector<double> away(points.count()), sizes(points.count());
    parallel_for(points.count(), 1024, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        states[i] = {strains[i], stresses_kPa[i] + metric_stress_kPa(data, missing[i])};
        const PointState there = nearest(data, states[i]);
        known[i] = round < wander ? there : between(known[i], there);
        const PointState gap{states[i].strain - there.strain, states[i].stress_kPa - there.stress_kPa};
        away[i] = points.volume_mm3(i) * squared_norm_kPa(data, gap);
        sizes[i] = points.volume_mm3(i) * squared_norm_kPa(data, states[i]);
      }
    });
    // A spring's state is its stretch, as the nodes have it, and its force, told as the stretch that its law gives it.
    const Eigen::VectorXd forced_mm = spring_mm + *missing_mm, there_mm = 0.5 * (u_mm + forced_mm);
    away.push_back(2 * spring_energy_uJ(u_mm - there_mm));
    sizes.push_back(spring_energy_uJ(u_mm) + spring_energy_uJ(forced_mm));
    spring_mm = round < wander ? there_mm : 0.5 * (spring_mm + there_mm);
    const double total = std::accumulate(sizes.begin(), sizes.end(), 0.0);
    apart = total > 0 ? std::sqrt(std::accumulate(away.begin(), away.end(), 0.0) / total) : 0.0;
    found.distances.push_back(apart);
  }

  StaticResult& result = found.result;
  result.status = settled() ? SolveStatus::converged : SolveStatus::not_converged;
  result.relative_residual = change;
  result.iterations = round;
  result.why_stopped = fmt::format(
      "In round {} the displacements changed by {:.1e} of their size (tolerance {:.1e}), and states lay {:.2g} % from "
      "the "
      "data (enough: {:.2g} %).",
      round, change, options.relative_tolerance, 100.0 * apart, 100.0 * options.close_enough);
  set_displacements(model->body(), u_mm, result);
  result.applied_force_mN = sum_of(*load_mN);
  result.external_work_uJ = u_mm.dot(*load_mN);
  result.foundation_reaction_mN = -sum_of(spring_force_mN(u_mm));
  result.foundation_energy_uJ = spring_energy_uJ(u_mm);
  double beyond_mm3 = 0, whole_mm3 = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    whole_mm3 += points.volume_mm3(i);
    if (deviator(states[i].strain).norm() > (1 + beyond_data) * data.largest_deviator_strain())
      beyond_mm3 += points.volume_mm3(i);
  }
  found.share_beyond_data = beyond_mm3 / whole_mm3;
  if (beyond_mm3 > 0) {
    result.notes.push_back(fmt::format(
        "{:.2g} % of the body is strained farther than the data go: there the answer stands on no measurement.",
        100.0 * found.share_beyond_data));
  }
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    Matrix3d mean = Matrix3d::Zero();
    for (std::size_t k = 0; k < StrainPoints::per_cell; ++k) {
      const PointState& state = states[StrainPoints::per_cell * c + k];
      mean += state.stress_kPa / double(StrainPoints::per_cell);
      result.largest_strain = std::max(result.largest_strain, state.strain.operatorNorm());
    }
    found.von_mises_kPa.push_back(von_mises(mean));
  }
  result.setup_s = model->cost().setup_s;
  result.step_ms = 1e3 * watch.seconds();
  return found;
}

namespace {

Matrix3d metric_stress_kPa(const MaterialData& data, const Matrix3d& strain) {
  return data.bulk_kPa() * strain.trace() * Matrix3d::Identity() + 2.0 * data.shear_kPa() * deviator(strain);
}

double squared_norm_kPa(const MaterialData& data, const PointState& state) {
  const double pressure_kPa = state.stress_kPa.trace() / 3.0;
  const double volume = state.strain.trace();
  return 0.5 * (data.bulk_kPa() * volume * volume + pressure_kPa * pressure_kPa / data.bulk_kPa()) +
         data.shear_kPa() * deviator(state.strain).squaredNorm() +
         deviator(state.stress_kPa).squaredNorm() / (4.0 * data.shear_kPa());
}

// An isotropic tissue's deviators point the same way. Of all common directions, the one that both together point to is
// the nearest; along it the state is two lengths, for which there are measurements. Which way a direction is stretched
// or squeezed is told by the sign of its determinant, as in a test; the curve answers for both.
PointState nearest(const MaterialData& data, const PointState& state) {
  const Matrix3d strain = deviator(state.strain), stress_kPa = deviator(state.stress_kPa);
  const Matrix3d both = 2.0 * data.shear_kPa() * strain + stress_kPa;
  const double length = both.norm();
  PointState known;
  if (length > 0) {
    const double sign = both.determinant() < 0 ? -1.0 : 1.0;
    const Matrix3d direction = sign / length * both;
    const MaterialData::State there =
        data.nearest({strain.cwiseProduct(direction).sum(), stress_kPa.cwiseProduct(direction).sum()});
    known.strain = there.strain * direction;
    known.stress_kPa = there.stress_kPa * direction;
  }
  const double bulk_kPa = data.bulk_kPa();
  const double volume = 0.5 * (state.strain.trace() + state.stress_kPa.trace() / 3.0 / bulk_kPa);
  known.strain += volume / 3.0 * Matrix3d::Identity();
  known.stress_kPa += bulk_kPa * volume * Matrix3d::Identity();
  return known;
}

}  // namespace
}  // namespace glisson::mechanics

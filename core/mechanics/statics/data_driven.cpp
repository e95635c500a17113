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
#include "mechanics/elements/quadrature.h"
#include "mechanics/elements/shape_functions.h"

namespace glisson::mechanics {
namespace {

using Eigen::Matrix3d;

// Strain and stress at one integration point.
struct PointState {
  Matrix3d strain = Matrix3d::Zero();
  Matrix3d stress_kPa = Matrix3d::Zero();
};

// The integration points of a body, four a cell.
class Points {
 public:
  Points(const geometry::TetMesh& mesh, const NodeLayout& layout) : mesh_(mesh), layout_(layout) {
    for (const TetPoint& point : tet_points_degree_2()) {
      derivatives_.push_back(tet_derivatives(ElementOrder::quadratic, point.barycentric));
    }
  }
  static constexpr std::size_t per_cell = 4;
  [[nodiscard]] std::size_t count() const { return per_cell * layout_.cells.size(); }
  [[nodiscard]] double volume_mm3(std::size_t point) const {
    return 0.25 * geometry::cell_volume_mm3(mesh_, point / per_cell);
  }

  [[nodiscard]] std::vector<Matrix3d> strains_of(const Eigen::VectorXd& u_mm) const;
  // Nodal forces (mN) of a field of stresses: the integral of B^T sigma.
  [[nodiscard]] Eigen::VectorXd forces_of(const std::vector<Matrix3d>& stresses_kPa) const;

 private:
  const geometry::TetMesh& mesh_;
  const NodeLayout& layout_;
  std::vector<TetDerivatives> derivatives_;
};

// Of all states that the data know, the nearest; volume change is linear.
PointState nearest(const MaterialData& data, const PointState& state);
double squared_norm_kPa(const MaterialData& data, const PointState& state);
// Half way: after some rounds states that wander between two sets of neighbours are held to their middle.
constexpr int wander = 60;
PointState between(const PointState& a, const PointState& b) {
  return {0.5 * (a.strain + b.strain), 0.5 * (a.stress_kPa + b.stress_kPa)};
}
Matrix3d metric_stress_kPa(const MaterialData& data, const Matrix3d& strain);

}  // namespace

Result<DataDrivenResult> find_equilibrium_from_data(const geometry::TetMesh& mesh, const MaterialData& data,
                                                    const std::vector<Support>& supports, const Loads& loads,
                                                    double density_kg_mm3, const DataDrivenOptions& options,
                                                    const Progress& progress) {
  for (const Support& support : supports) {
    if (std::holds_alternative<Foundation>(support.how)) {
      return failure("not-available",
                     GLISSON_TEXT("A body computed straight from data can be held, but not stand on a foundation."));
    }
  }
  StaticOptions metric;
  metric.poisson_ratio = data.options().poisson_ratio;
  metric.density_kg_mm3 = density_kg_mm3;
  const auto model = StaticModel::create(mesh, std::vector<double>(mesh.cells.size(), data.slope_kPa()), supports,
                                         metric, progress.part(0.0, 0.3));
  if (!model) return failure(model.error());
  const auto load_mN = load_vector(mesh, model->nodes(), boundary_faces(mesh, model->nodes()), density_kg_mm3, loads);
  if (!load_mN) return failure(load_mN.error());

  const Stopwatch watch;
  const Points points(mesh, model->nodes());
  const NodeLayout& layout = model->nodes();
  const auto solve = [&](const Eigen::VectorXd& force_mN) -> Result<Eigen::VectorXd> {
    return model->solve_nodal({force_mN, {}}).map([&](const StaticResult& result) {
      Eigen::VectorXd u_mm(force_mN.size());
      for (std::size_t p = 0; p < result.displacement_mm.size(); ++p) {
        if (layout.node_of_point[p] >= 0) u_mm.segment<3>(3 * layout.node_of_point[p]) = result.displacement_mm[p];
      }
      for (std::size_t e = 0; e < result.mid_side_displacement_mm.size(); ++e) {
        u_mm.segment<3>(3 * (layout.corner_nodes + static_cast<Eigen::Index>(e))) = result.mid_side_displacement_mm[e];
      }
      return u_mm;
    });
  };

  // Where to start: as if the metric were a law. From rest, noise would hold states back wherever they are small.
  const auto start_mm = solve(*load_mN);
  if (!start_mm) return failure(start_mm.error());
  Eigen::VectorXd u_mm = *start_mm;
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
    const auto next_mm = solve(points.forces_of(pulls_kPa));
    if (!next_mm) return failure(next_mm.error());
    const auto missing_mm = solve(*load_mN - points.forces_of(stresses_kPa));
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
  result.displacement_mm.assign(mesh.points_mm.size(), Eigen::Vector3d::Zero());
  for (std::size_t p = 0; p < mesh.points_mm.size(); ++p) {
    if (layout.node_of_point[p] >= 0) result.displacement_mm[p] = u_mm.segment<3>(3 * layout.node_of_point[p]);
    result.max_displacement_mm = std::max(result.max_displacement_mm, result.displacement_mm[p].norm());
  }
  for (std::size_t e = 0; e < layout.edges.size(); ++e) {
    result.mid_side_displacement_mm.emplace_back(
        u_mm.segment<3>(3 * (layout.corner_nodes + static_cast<Eigen::Index>(e))));
  }
  result.applied_force_mN = sum_of(*load_mN);
  result.external_work_uJ = u_mm.dot(*load_mN);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    Matrix3d mean = Matrix3d::Zero();
    for (std::size_t k = 0; k < Points::per_cell; ++k) {
      const PointState& state = states[Points::per_cell * c + k];
      mean += state.stress_kPa / double(Points::per_cell);
      result.largest_strain = std::max(result.largest_strain, state.strain.operatorNorm());
    }
    found.von_mises_kPa.push_back(von_mises(mean));
  }
  result.setup_s = model->cost().setup_s;
  result.step_ms = 1e3 * watch.seconds();
  return found;
}

namespace {

std::vector<Matrix3d> Points::strains_of(const Eigen::VectorXd& u_mm) const {
  std::vector<Matrix3d> strains(count());
  parallel_for(layout_.cells.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      const CellGeometry shape = cell_geometry(mesh_, c);
      Eigen::Matrix<double, 3, 10> moved;
      for (int i = 0; i < 10; ++i) moved.col(i) = u_mm.segment<3>(3 * layout_.cells[c][i]);
      for (std::size_t k = 0; k < per_cell; ++k) {
        strains[per_cell * c + k] = small_strain(moved * tet_gradients(derivatives_[k], shape));
      }
    }
  });
  return strains;
}

Eigen::VectorXd Points::forces_of(const std::vector<Matrix3d>& stresses_kPa) const {
  std::vector<Eigen::Matrix<double, 3, 10>> of_cell(layout_.cells.size());
  parallel_for(layout_.cells.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      const CellGeometry shape = cell_geometry(mesh_, c);
      of_cell[c].setZero();
      for (std::size_t k = 0; k < per_cell; ++k) {
        of_cell[c] += 0.25 * shape.volume_mm3 * stresses_kPa[per_cell * c + k] *
                      tet_gradients(derivatives_[k], shape).transpose();
      }
    }
  });
  Eigen::VectorXd force_mN = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(layout_.nodes()));
  for (std::size_t c = 0; c < of_cell.size(); ++c) {
    for (int i = 0; i < 10; ++i) force_mN.segment<3>(3 * layout_.cells[c][i]) += of_cell[c].col(i);
  }
  return force_mN;
}

Matrix3d deviator(const Matrix3d& m) { return m - m.trace() / 3.0 * Matrix3d::Identity(); }

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

#include "mechanics/statics/buckling.h"

#include <algorithm>
#include <array>
#include <Eigen/Eigenvalues>
#include <random>
#include <vector>

#include "base/parallel.h"
#include "mechanics/elements/quadrature.h"
#include "mechanics/elements/shape_functions.h"
#include "mechanics/elements/strain.h"
#include "mechanics/statics/displacements.h"

namespace glisson::mechanics {
namespace {

constexpr int maximum_solves = 12;

// K_sigma of each cell, the same for the three axes.
using CellMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 10, 10>;

std::vector<CellMatrix> stress_stiffness(const StaticModel& model, const Eigen::VectorXd& u_mm);
Eigen::VectorXd times_minus(const std::vector<CellMatrix>& cells, const NodeLayout& nodes, const Eigen::VectorXd& v);

}  // namespace

double load_beyond_buckling(const StaticModel& model, const StaticResult& result) {
  if (model.options().anisotropy || result.max_displacement_mm == 0) return 0;
  const Eigen::VectorXd u_mm = nodal_displacements(model.nodes(), result);
  if (!u_mm.allFinite()) return 0;
  const std::vector<CellMatrix> cells = stress_stiffness(model, u_mm);

  // What bends the body most is where to look; the answer to a load without a direction has some of everything.
  std::mt19937 random(1);
  std::uniform_real_distribution<double> even(-1, 1);
  Eigen::VectorXd start_mN = Eigen::VectorXd::NullaryExpr(u_mm.size(), [&] { return even(random); });
  std::vector<Eigen::VectorXd> directions, forces;  // q, and K q, with q_i.K q_j = 1 or 0
  Eigen::VectorXd force = std::move(start_mN);
  Eigen::MatrixXd projected = Eigen::MatrixXd::Zero(maximum_solves, maximum_solves);
  double largest = 0;
  for (int n = 0; n < maximum_solves; ++n) {
    const auto answer = model.respond(force);
    Eigen::VectorXd direction = answer.displacement_mm.col(0);
    if (!direction.allFinite()) return largest;
    for (int again = 0; again < 2; ++again) {
      for (std::size_t i = 0; i < directions.size(); ++i) {
        const double share = direction.dot(forces[i]);
        direction -= share * directions[i];
        force -= share * forces[i];
      }
    }
    const double size = direction.dot(force);
    if (!(size > 0)) return largest;
    directions.push_back(direction / std::sqrt(size));
    forces.push_back(force / std::sqrt(size));
    force = times_minus(cells, model.nodes(), directions.back());
    for (int i = 0; i <= n; ++i) {
      projected(i, n) = projected(n, i) = force.dot(directions[static_cast<std::size_t>(i)]);
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> ritz(projected.topLeftCorner(n + 1, n + 1),
                                                              Eigen::EigenvaluesOnly);
    const double before = largest;
    largest = std::max(0.0, ritz.eigenvalues().maxCoeff());
    const bool settled = n > 4 && largest - before < 1e-3 * largest;
    if (settled) break;
  }
  return largest;
}

namespace {

std::vector<CellMatrix> stress_stiffness(const StaticModel& model, const Eigen::VectorXd& u_mm) {
  const geometry::TetMesh& mesh = model.mesh();
  const NodeLayout& nodes = model.nodes();
  std::vector<CellMatrix> cells(mesh.cells.size());
  const double poisson_ratio = model.options().poisson_ratio;
  parallel_for(cells.size(), 512, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      const Lame material = lame_from_youngs(model.youngs_kPa()[c], poisson_ratio);
      const CellGeometry shape = cell_geometry(mesh, c);
      cells[c] = CellMatrix::Zero(nodes.nodes_per_cell(), nodes.nodes_per_cell());
      for (const TetPoint& point : tet_points_degree_2()) {
        const TetGradients gradients = tet_gradients(tet_derivatives(nodes.order, point.barycentric), shape);
        const Eigen::Matrix3d sigma_kPa =
            stress_kPa(material, small_strain(displacement_gradient(mesh, nodes, c, point.barycentric, u_mm)));
        cells[c] += point.weight * shape.volume_mm3 * gradients * sigma_kPa * gradients.transpose();
      }
    }
  });
  return cells;
}

Eigen::VectorXd times_minus(const std::vector<CellMatrix>& cells, const NodeLayout& nodes, const Eigen::VectorXd& v) {
  Eigen::VectorXd product = Eigen::VectorXd::Zero(v.size());
  const int count = nodes.nodes_per_cell();
  Eigen::Matrix<double, Eigen::Dynamic, 3, 0, 10, 3> values(count, 3);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    for (int a = 0; a < count; ++a) values.row(a) = v.segment<3>(3 * nodes.cells[c][static_cast<std::size_t>(a)]);
    values = (cells[c] * values).eval();
    for (int a = 0; a < count; ++a) {
      product.segment<3>(3 * nodes.cells[c][static_cast<std::size_t>(a)]) -= values.row(a).transpose();
    }
  }
  return product;
}

}  // namespace
}  // namespace glisson::mechanics

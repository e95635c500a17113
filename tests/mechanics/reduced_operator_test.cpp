// Matrices over handles in both forms, against the slow way: one column of P at a time.

#include "mechanics/meshfree/internal/reduced_solver.h"

#include <gtest/gtest.h>
#include <cmath>
#include <set>

#include "mechanics/bodies.h"
#include "mechanics/meshfree/compliance_distance.h"
#include "mechanics/meshfree/internal/meshfree_body.h"
#include "mechanics/potentials/stiffness_matrix.h"

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;

struct Mottled {
  geometry::TetMesh mesh = test::box(4, 3, 3, {30, 25, 25});
  Body body;
  ShapeFunctions shape;
  std::shared_ptr<const AffineBasis> basis;
  Eigen::SparseMatrix<double> lower;

  explicit Mottled(int nodes) {
    test::disturb_inner_points(mesh, 0.8);
    test::name_points(mesh, "wall", [](const Vector3d& p) { return p.x() == 0; });
    std::vector<double> youngs_kPa;
    for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
      youngs_kPa.push_back(std::pow(10.0, 1.0 + std::sin(0.4 * geometry::cell_centroid_mm(mesh, c).x())));
    }
    body = prepare_body(mesh, youngs_kPa, {{NamedPoints{"wall"}, Foundation{2.0}}}, {}, Holding::optional).value();
    shape = shape_functions_of(mesh, youngs_kPa, {.nodes = nodes}).value();
    basis = std::make_shared<const AffineBasis>(mesh, body.layout, shape);
    lower = assemble_stiffness(body);
  }

  // How the places follow the handles, column by column.
  [[nodiscard]] Eigen::MatrixXd followed() const {
    Eigen::MatrixXd columns(3 * Eigen::Index{body.layout.nodes()}, basis->unknowns());
    for (Eigen::Index k = 0; k < columns.cols(); ++k) {
      columns.col(k) = basis->displacement(Eigen::VectorXd::Unit(columns.cols(), k));
    }
    return columns;
  }
  [[nodiscard]] Eigen::MatrixXd slow() const {
    const Eigen::MatrixXd p = followed();
    return p.transpose() * (lower.selfadjointView<Eigen::Lower>() * p);
  }
};

TEST(AffineBasis, PlacesMoveAsTheFormulaSays) {
  // w_i is linear along an edge, so that in its middle it is the mean of the ends.
  const Mottled mottled(12);
  const Eigen::VectorXd q = Eigen::VectorXd::Random(mottled.basis->unknowns());
  const Eigen::VectorXd u_mm = mottled.basis->displacement(q);
  const auto moved_by = [&](int point, double part, const Vector3d& place_mm) {
    Vector3d sum(0, 0, 0);
    for (std::size_t k = mottled.shape.starts[point]; k < mottled.shape.starts[point + 1]; ++k) {
      const int handle = mottled.shape.nodes[k];
      const Vector3d arm = (place_mm - mottled.shape.nodes_mm[handle]) / handle_length_mm(mottled.shape, handle);
      const Eigen::Map<const Eigen::Matrix<double, 3, 4>> affine(q.data() + handle_size * handle);
      sum += part * mottled.shape.weights[k] * (affine.col(0) + affine.rightCols<3>() * arm);
    }
    return sum;
  };
  const NodeLayout& layout = mottled.body.layout;
  for (std::size_t p = 0; p < mottled.mesh.points_mm.size(); ++p) {
    const Vector3d moved = moved_by(int(p), 1.0, mottled.mesh.points_mm[p]);
    EXPECT_LT((u_mm.segment<3>(3 * layout.node_of_point[p]) - moved).norm(), 1e-12);
  }
  for (std::size_t e = 0; e < layout.edges.size(); ++e) {
    const int place = layout.corner_nodes + int(e);
    const Vector3d moved = moved_by(layout.edges[e][0], 0.5, layout.positions_mm[place]) +
                           moved_by(layout.edges[e][1], 0.5, layout.positions_mm[place]);
    EXPECT_LT((u_mm.segment<3>(3 * place) - moved).norm(), 1e-12);
  }
}

TEST(AffineBasis, ReducingIsTheTransposeOfMoving) {
  const Mottled mottled(12);
  const Eigen::VectorXd q = Eigen::VectorXd::Random(mottled.basis->unknowns());
  const Eigen::VectorXd f = Eigen::VectorXd::Random(3 * Eigen::Index{mottled.body.layout.nodes()});
  EXPECT_NEAR(mottled.basis->displacement(q).dot(f), q.dot(mottled.basis->reduce(f)), 1e-10);
}

TEST(ReducedOperator, BothFormsAreTheMatrixMadeColumnByColumn) {
  const Mottled mottled(12);
  const Lists meeting = handles_that_meet(*mottled.basis);
  const Eigen::MatrixXd slow = mottled.slow();
  for (const auto form : {ReducedOperator::Form::assembled, ReducedOperator::Form::product}) {
    const ReducedOperator matrix(form, mottled.basis, mottled.lower, meeting);
    const Eigen::VectorXd q = Eigen::VectorXd::Random(slow.cols());
    EXPECT_LT((matrix * q - slow * q).norm(), 1e-12 * (slow * q).norm());
    EXPECT_LT((matrix.rough(q) - slow * q).norm(), 1e-5 * (slow * q).norm());  // single precision
    const auto diagonal = matrix.diagonal();
    for (int handle = 0; handle < mottled.basis->handles(); ++handle) {
      const HandleBlock expected = slow.block<handle_size, handle_size>(handle_size * handle, handle_size * handle);
      EXPECT_LT((diagonal[handle] - expected).norm(), 1e-12 * expected.norm());
    }
    const ReducedOperator twice = ReducedOperator::sum(0.5, matrix, 1.5, matrix);
    EXPECT_LT((twice * q - 2 * (slow * q)).norm(), 1e-12 * (slow * q).norm());
  }
}

TEST(ReducedOperator, LeadersReduceItToTheEnginesOwnMatrixOverThem) {
  // R^T A R by columns, against the matrix of the basis that the leaders make.
  const Mottled mottled(25);
  const int handles = mottled.basis->handles();
  HandleLead lead;
  lead.leaders_mm = {{0, 12, 12}, {30, 12, 12}};
  lead.lengths_mm = {30, 20};
  lead.starts.push_back(0);
  for (int i = 0; i < handles; ++i) {
    const double along = std::clamp(mottled.basis->position_mm(i).x() / 30, 0.0, 1.0);
    lead.leaders.insert(lead.leaders.end(), {0, 1});
    lead.weights.insert(lead.weights.end(), {1 - along, along});
    lead.starts.push_back(lead.leaders.size());
  }
  Eigen::MatrixXd r(mottled.basis->unknowns(), 2 * handle_size);
  for (Eigen::Index k = 0; k < r.cols(); ++k) {
    r.col(k) = mottled.basis->follow(lead, Eigen::VectorXd::Unit(r.cols(), k));
  }
  const Eigen::VectorXd force = Eigen::VectorXd::Random(r.rows());
  EXPECT_LT((mottled.basis->gather(lead, force) - r.transpose() * force).norm(), 1e-10);
  const Eigen::MatrixXd expected = r.transpose() * mottled.slow() * r;
  const ReducedMatrix reduced_twice = reduced(both_triangles(mottled.lower), mottled.basis->led_by(lead));
  const Eigen::MatrixXd lower = Eigen::MatrixXd(reduced_twice.lower());
  EXPECT_LT((Eigen::MatrixXd(lower.selfadjointView<Eigen::Lower>()) - expected).norm(), 1e-10 * expected.norm());
}

TEST(ReducedOperator, BothFormsFindTheSameEquilibrium) {
  const Mottled mottled(40);
  const Lists meeting = handles_that_meet(*mottled.basis);
  Eigen::VectorXd force_mN = Eigen::VectorXd::Zero(3 * Eigen::Index{mottled.body.layout.nodes()});
  for (Eigen::Index i = 2; i < force_mN.size(); i += 3) force_mN[i] = 0.1;
  const Eigen::VectorXd b = mottled.basis->reduce(force_mN);
  Eigen::VectorXd by_factor;
  for (const auto form : {ReducedOperator::Form::assembled, ReducedOperator::Form::product}) {
    const ReducedOperator matrix(form, mottled.basis, mottled.lower, meeting);
    const auto preconditioner = ReducedPreconditioner::of(matrix, std::uint64_t{1} << 30);
    const ReducedSolution solution =
        conjugate_gradients(matrix, preconditioner, b, Eigen::VectorXd::Zero(b.size()), 1e-6, 5000);
    ASSERT_TRUE(solution.converged) << solution.relative_residual;
    const Eigen::VectorXd u_mm = mottled.basis->displacement(solution.x);
    if (form == ReducedOperator::Form::assembled) {
      EXPECT_LE(solution.iterations, 5);
      by_factor = u_mm;
    } else {
      EXPECT_LT((u_mm - by_factor).cwiseAbs().maxCoeff(), 1e-3 * by_factor.cwiseAbs().maxCoeff());
    }
  }
}

TEST(ComplianceDistance, WavesByBucketsAreThoseTakenStrictlyFromNearToFar) {
  // Judged by marching with a sorted set, in double precision: what buckets lose is far below a voxel.
  geometry::TetMesh mesh = test::box(8, 8, 8, {20, 20, 20});
  std::vector<double> youngs_kPa;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    youngs_kPa.push_back(geometry::cell_centroid_mm(mesh, c).x() < 8 ? 1.0 : 30.0);
  }
  const VoxelBody voxels = voxelise(mesh, youngs_kPa, 1.0);
  const ComplianceDistance distance(voxels);
  const Vector3d seed_mm = distance.center_mm(distance.voxel_at({4, 9, 11}));
  ComplianceDistance::Workspace workspace(distance.grid().voxels());

  const auto count = distance.grid().voxels();
  const double far = 1e30;
  std::vector<double> slow(count, far);
  std::vector<bool> fixed(count, false);
  std::set<std::pair<double, std::size_t>> front;
  for (const std::size_t voxel : distance.around(distance.voxel_at(seed_mm))) {
    slow[voxel] = distance.step(seed_mm, seed_mm, voxel);
    front.insert({slow[voxel], voxel});
  }
  const std::array<std::size_t, 3> stride{1, std::size_t(distance.grid().size[0]),
                                          std::size_t(distance.grid().size[0]) * distance.grid().size[1]};
  while (!front.empty()) {
    const std::size_t voxel = front.begin()->second;
    front.erase(front.begin());
    fixed[voxel] = true;
    for (const std::size_t next : distance.beside(voxel)) {
      if (fixed[next]) continue;
      std::array<double, 3> near{far, far, far};
      for (int axis = 0; axis < 3; ++axis) {
        for (const std::size_t other : {next - stride[axis], next + stride[axis]}) {
          if (fixed[other]) near[axis] = std::min(near[axis], slow[other]);
        }
      }
      std::sort(near.begin(), near.end());
      const double cost = 1.0 / voxels.youngs_kPa[next];
      double reached = near[0] + cost;
      for (int n = 2; n <= 3 && reached > near[n - 1]; ++n) {  // n d^2 - 2 d sum + squares - cost^2 = 0
        const double sum = near[0] + near[1] + (n == 3 ? near[2] : 0);
        const double squares = near[0] * near[0] + near[1] * near[1] + (n == 3 ? near[2] * near[2] : 0);
        reached = (sum + std::sqrt(std::max(0.0, sum * sum - n * (squares - cost * cost)))) / n;
      }
      if (reached < slow[next]) {
        front.erase({slow[next], next});
        slow[next] = reached;
        front.insert({reached, next});
      }
    }
  }
  const auto reached = distance.within(seed_mm, ComplianceDistance::unreached, workspace);
  EXPECT_EQ(reached.size(), 20u * 20u * 20u);
  double largest = 0, largest_of_stiff = 0;
  for (const auto& [voxel, there] : reached) {
    double& largest_here = voxels.youngs_kPa[voxel] > 2 ? largest_of_stiff : largest;
    largest_here = std::max(largest_here, std::abs(there - slow[voxel]));
  }
  EXPECT_LT(largest, 0.06);           // mm/kPa; a voxel there is 1
  EXPECT_LT(largest_of_stiff, 0.06);  // where a voxel is 1/30, and what came through the soft part is 8
}

}  // namespace
}  // namespace glisson::mechanics

// The two lattices that precondition a body at large strain: their ways down and up, and rows beside them, against the
// plain sums.

#include "mechanics/contact/internal/spline_levels.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <Eigen/LU>

#include "mechanics/bodies.h"
#include "mechanics/contact/internal/dense_product.h"
#include "mechanics/elements/body.h"
#include "mechanics/elements/shape_functions.h"
#include "mechanics/potentials/stiffness_matrix.h"

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

// Numbers between -1 and 1, always the same.
VectorXd numbers(Eigen::Index count) {
  VectorXd values(count);
  for (Eigen::Index i = 0; i < count; ++i) values[i] = std::sin(1.7 * double(i) * double(i) + 0.3);
  return values;
}

class BlockOnLattices : public testing::Test {
 protected:
  static Body block() {
    geometry::TetMesh mesh = test::box(5, 4, 3, {50, 40, 30});
    test::name_points(mesh, "ground", [](const Vector3d& p) { return p.z() < 1e-9; });
    test::disturb_inner_points(mesh, 1.0);
    StaticOptions options;
    options.poisson_ratio = 0.45;
    const std::vector<double> youngs_kPa(mesh.cells.size(), 5);
    return prepare_body(mesh, youngs_kPa, {test::fixed("ground")}, options, Holding::required).value();
  }
  BlockOnLattices() : levels_(body_.layout.positions_mm, body_.resolved.fixed, 100) {
    EXPECT_TRUE(levels_.refresh(assemble_stiffness(body_)));
  }
  Eigen::Index unknowns() const { return 3 * static_cast<Eigen::Index>(body_.layout.nodes()); }
  // Two contacts, one of a tool whose advance is an unknown, and one jaw; the last contact is open.
  std::vector<StiffRow> rows() const {
    std::vector<int> above;
    for (int node = 0; node < body_.layout.nodes(); ++node) {
      if (body_.layout.positions_mm[static_cast<std::size_t>(node)].z() > 15) above.push_back(node);
    }
    const auto at = [&](std::size_t k) { return above[k * above.size() / 5]; };
    StiffRow pushed{{{at(0), Vector3d(0.2, 0, 0.5)}, {at(0) + 1, Vector3d(0.1, 0, 0.3)}}, 0, 0.8, 50, -0.2, false};
    StiffRow still{{{at(1), Vector3d(0, 1, 0)}}, -1, 0, 50, -0.1, false};
    StiffRow jaw{{{at(2), Vector3d(1, 0, 0)}}, -1, 0, 900, 0.3, true};
    StiffRow open{{{at(3), Vector3d(0, 0, 1)}}, -1, 0, 50, 40, false};
    return {pushed, still, jaw, open};
  }

  Body body_ = block();
  SplineLevels levels_;
};

TEST_F(BlockOnLattices, TheWayDownIsTheTransposeOfTheWayUp) {
  const SplineLattice& lattice = levels_.lattice();
  const VectorXd r = numbers(unknowns());
  SplineLattice::Values down, some(static_cast<std::size_t>(lattice.points()) + 1, Eigen::Vector4f::Zero());
  lattice.down(r, down);
  for (int p = 0; p < lattice.points(); ++p) {
    some[static_cast<std::size_t>(p)].head<3>() = numbers(3).cast<float>() * (1 + 0.01F * static_cast<float>(p));
  }
  VectorXd up = VectorXd::Zero(unknowns());
  lattice.up(some, up);
  // Point by point, from what each node says is around it.
  SplineLattice::Values slow(down.size(), Eigen::Vector4f::Zero());
  double by_lattice = 0, largest = 0;
  for (int node = 0; node < body_.layout.nodes(); ++node) {
    for (const auto& [point, weight] : lattice.around(node)) {
      for (int d = 0; d < 3; ++d) {
        if (!lattice.is_fixed(node, d)) {
          slow[static_cast<std::size_t>(point)][d] += weight * static_cast<float>(r[3 * node + d]);
        }
      }
    }
  }
  for (std::size_t p = 0; p < down.size(); ++p) {
    EXPECT_LT((down[p] - slow[p]).norm(), 1e-4) << p;
    by_lattice += double{down[p].dot(some[p])};
    largest += double{down[p].norm() * some[p].norm()};
  }
  EXPECT_NEAR(r.dot(up), by_lattice, 1e-5 * largest);
  for (int node = 0; node < body_.layout.nodes(); ++node) {
    const bool is_fixed = lattice.is_fixed(node, 0);
    EXPECT_EQ(up.segment<3>(3 * node).isZero(0), is_fixed) << node;
  }
}

TEST_F(BlockOnLattices, ForcesAlongRowsAreAnsweredAsIfTheyWereAddedUpFirst) {
  const auto rows = this->rows();
  const VectorXd alone = numbers(unknowns() + 1);
  const SplineLevels::WithRows with_rows(levels_, rows, 1, alone);
  EXPECT_TRUE(with_rows.presses(0) && with_rows.presses(2));
  EXPECT_FALSE(with_rows.presses(3));
  VectorXd along_rows(4);
  along_rows << 3, -2, 40, 1;
  VectorXd sum = alone;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double force = along_rows[static_cast<Eigen::Index>(i)];
    for (const auto& [node, direction] : rows[i].on) sum.segment<3>(3 * node) += force * direction;
    if (rows[i].further >= 0) sum[unknowns() + rows[i].further] -= rows[i].along * force;
  }
  VectorXd quick, slow;
  with_rows.apply_along_rows(along_rows, quick);
  with_rows.apply(sum, slow);
  EXPECT_LT((quick - slow).norm(), 1e-4 * slow.norm());
  // Where the stiff jaw holds it moves by a twentieth, at most, of what it would move by.
  const std::vector<StiffRow> none;
  const SplineLevels::WithRows without(levels_, none, 0, alone.head(unknowns()));
  VectorXd free_answer;
  without.apply(sum.head(unknowns()), free_answer);
  const auto jaw_sees = [&](const VectorXd& z) { return std::abs(z[3 * rows[2].on[0].first]); };
  EXPECT_LT(jaw_sees(slow), 0.05 * jaw_sees(free_answer));
}

// Points of one face, as a tool with friction sees them, half of them apart; the tool's advance is an unknown.
std::vector<StiffRow> on_a_face(const BoundaryFace& face, int parts) {
  std::vector<StiffRow> rows;
  for (int i = 0; i <= parts; ++i) {
    for (int j = 0; i + j <= parts; ++j) {
      const auto weights = quadratic_triangle_values(Vector3d(i, j, parts - i - j) / parts);
      for (const Vector3d& direction : {Vector3d(0.1 * i, 0.3, 1), Vector3d(1, 0, 0), Vector3d(0, 1, 0)}) {
        StiffRow row;
        for (int n = 0; n < 6; ++n) {
          if (weights[n] != 0) row.on.emplace_back(face.nodes[n], weights[n] * direction);
        }
        row.two_sided = direction.z() == 0;
        row.further = row.two_sided ? -1 : 0;
        row.along = row.two_sided ? 0 : 0.9;
        row.stiffness = row.two_sided ? 20 : 60;
        row.gap_mm = row.two_sided ? 0.01 * j : 0.1 * (i - j);
        rows.push_back(std::move(row));
      }
    }
  }
  return rows;
}

TEST_F(BlockOnLattices, RowsAreAnsweredOneByOneOrByTheNodesOfTheirFaceWhicheverAreFewer) {
  const auto face = std::find_if(body_.boundary.begin(), body_.boundary.end(), [&](const BoundaryFace& at) {
    return body_.layout.positions_mm[static_cast<std::size_t>(at.nodes[3])].z() > 29;
  });
  ASSERT_NE(face, body_.boundary.end());
  for (const int parts : {1, 4}) {
    auto rows = on_a_face(*face, parts);
    EXPECT_EQ(condensed(rows).functionals.size(), parts == 1 ? 9U : 19U);
    const auto count = static_cast<Eigen::Index>(rows.size());
    const VectorXd alone = 0.1 * numbers(unknowns() + 1);
    const SplineLevels::WithRows with_rows(levels_, rows, 1, alone);

    // The levels' answer to nodes alone, that to the further unknown, and each row's by them.
    const std::vector<StiffRow> none;
    const SplineLevels::WithRows without(levels_, none, 0, alone.head(unknowns()));
    const auto answered = [&](const VectorXd& r) {
      VectorXd on_nodes, z(r.size());
      without.apply(r.head(unknowns()), on_nodes);
      z << on_nodes, r.tail(1) / (1e-4 * 60);
      return z;
    };
    Eigen::MatrixXd see = Eigen::MatrixXd::Zero(unknowns() + 1, count), answers(unknowns() + 1, count);
    VectorXd gap_mm(count), softness(count);
    for (Eigen::Index r = 0; r < count; ++r) {
      const StiffRow& row = rows[static_cast<std::size_t>(r)];
      for (const auto& [node, direction] : row.on) see.col(r).segment<3>(3 * node) += direction;
      if (row.further >= 0) see(unknowns(), r) -= row.along;
      answers.col(r) = answered(see.col(r));
      gap_mm[r] = row.gap_mm;
      softness[r] = 1 / row.stiffness;
    }
    std::vector<Eigen::Index> pressing;
    for (Eigen::Index r = 0; r < count; ++r) {
      if (with_rows.presses(static_cast<std::size_t>(r))) pressing.push_back(r);
    }
    ASSERT_LT(pressing.size(), rows.size());
    const Eigen::MatrixXd see_pressing = see(Eigen::all, pressing), answers_pressing = answers(Eigen::all, pressing);
    Eigen::MatrixXd compliance = see_pressing.transpose() * answers_pressing;
    compliance.diagonal() += softness(pressing);
    const VectorXd alone_sees = see.transpose() * answered(alone) + gap_mm;
    const VectorXd force_mN = compliance.partialPivLu().solve(VectorXd(-alone_sees(pressing)));
    const VectorXd after_mm = alone_sees + see.transpose() * answers_pressing * force_mN;
    for (Eigen::Index r = 0; r < count; ++r) {
      const auto row = static_cast<std::size_t>(r);
      EXPECT_EQ(with_rows.presses(row), rows[row].two_sided || after_mm[r] < 0) << r << ": " << after_mm[r];
    }

    const VectorXd r = numbers(unknowns() + 1);
    const VectorXd z = answered(r), seen = see_pressing.transpose() * z;
    const VectorXd slow = z - answers_pressing * compliance.partialPivLu().solve(seen);
    VectorXd quick;
    with_rows.apply(r, quick);
    EXPECT_LT((quick - slow).norm(), 1e-4 * slow.norm());
  }
}

TEST(DenseProduct, IsWhatEigenMultiplies) {
  for (const Eigen::Index size : {1, 3, 16, 45}) {
    const Eigen::MatrixXf matrix = numbers(size * size).cast<float>().reshaped(size, size);
    const Eigen::VectorXf x = numbers(size).cast<float>();
    Eigen::VectorXf y;
    multiply(padded_rows(matrix), x, y);
    ASSERT_EQ(y.size(), size);
    EXPECT_LT((y - matrix * x).norm(), 1e-5F * static_cast<float>(size));
  }
}

}  // namespace
}  // namespace glisson::mechanics

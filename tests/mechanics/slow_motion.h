#pragma once
// Implicit Euler the obvious way: the stiffness as one sparse matrix in double precision, from the material's own
// stress and warped tangent, solved directly. What ImplicitEuler does fast is judged by it.

#include <Eigen/SparseCholesky>

#include "mechanics/dynamics/implicit_euler.h"
#include "mechanics/elements/shape_functions.h"
#include "mechanics/potentials/elastic.h"

namespace glisson::mechanics::test {

struct SlowMotion {
  const Body& body;
  DynamicsOptions options;
  Eigen::VectorXd mass_kg;  // one a node
  Eigen::VectorXd u_mm, v_mm_s;

  SlowMotion(const Body& of, const DynamicsOptions& with, Eigen::VectorXd masses)
      : body(of),
        options(with),
        mass_kg(std::move(masses)),
        u_mm(Eigen::VectorXd::Zero(3 * mass_kg.size())),
        v_mm_s(u_mm) {}

  void step(const Eigen::VectorXd& force_mN) {
    const double h = options.step_s, alpha = options.mass_damping_per_s, beta = options.stiffness_damping_s;
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t c = 0; c < body.layout.cells.size(); ++c) {
      const CellGeometry shape = cell_geometry(body.mesh, c);
      const auto& nodes = body.layout.cells[c];
      Eigen::Matrix3d f = Eigen::Matrix3d::Identity();
      for (int i = 0; i < 4; ++i) f += u_mm.segment<3>(3 * nodes[i]) * shape.barycentric_gradients.row(i);
      const Matrix9d tangent = shape.volume_mm3 * Corotational{body.materials[c]}.warped_tangent_kPa(f);
      for (int a = 0; a < 4; ++a) {
        for (int b = 0; b < 4; ++b) {
          for (int i = 0; i < 9; ++i) {
            for (int k = 0; k < 9; ++k) {
              entries.emplace_back(
                  3 * nodes[a] + i % 3, 3 * nodes[b] + k % 3,
                  shape.barycentric_gradients(a, i / 3) * tangent(i, k) * shape.barycentric_gradients(b, k / 3));
            }
          }
        }
      }
    }
    Eigen::SparseMatrix<double> stiffness(u_mm.size(), u_mm.size());
    stiffness.setFromTriplets(entries.begin(), entries.end());
    Eigen::VectorXd masses(u_mm.size());
    for (Eigen::Index n = 0; n < mass_kg.size(); ++n) masses.segment<3>(3 * n).setConstant(mass_kg[n]);

    const auto materials = materials_of(body, MaterialLaw::corotational);
    Eigen::VectorXd b = h * (force_mN + foundation_force_mN(body, u_mm + (h + beta) * v_mm_s) -
                             internal_force_mN(body, materials, u_mm) - alpha * masses.cwiseProduct(v_mm_s) -
                             (h + beta) * (stiffness * v_mm_s));
    Eigen::SparseMatrix<double> a = h * (h + beta) * stiffness;
    a += Eigen::SparseMatrix<double>(((1 + h * alpha) * masses).asDiagonal());
    for (const FoundationFace& spring : body.resolved.foundations) {
      const BoundaryFace& face = body.boundary[spring.face];
      const FaceMass mass = face_mass_mm2(face, ElementOrder::linear);
      for (int i = 0; i < 9; ++i) {
        for (int d = 0; d < 3; ++d) {
          a.coeffRef(3 * face.nodes[i / 3] + d, 3 * face.nodes[i % 3] + d) +=
              h * (h + beta) * spring.stiffness_kPa_per_mm * mass(i / 3, i % 3);
        }
      }
    }
    for (Eigen::Index i = 0; i < b.size(); ++i) {
      if (!body.resolved.fixed[static_cast<std::size_t>(i)]) continue;
      b[i] = 0;
      a.coeffRef(i, i) += 1e12;  // held, as good as
    }
    v_mm_s += Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(a).solve(b);
    u_mm += h * v_mm_s;
  }
};

}  // namespace glisson::mechanics::test

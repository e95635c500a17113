#include "mechanics/potentials/elastic.h"

#include <numeric>

#include "mechanics/elements/strain.h"
#include "mechanics/potentials/internal/cell_samples.h"

namespace glisson::mechanics {
namespace {

Material material_of(const Lame& lame, MaterialLaw law, double strain_stiffening) {
  switch (law) {
    case MaterialLaw::linear: return SmallStrain{lame};
    case MaterialLaw::corotational: return Corotational{lame};
    case MaterialLaw::neo_hookean: return StableNeoHookean(lame);
    case MaterialLaw::veronda_westmann: return veronda_westmann_from(lame, strain_stiffening);
  }
  GLISSON_ASSERT(false);
}

Matrix9d warped_stiffness_kPa(const Lame& lame, const Eigen::Matrix3d& f) {
  const Eigen::Matrix3d rotation = polar_decomposition(f).rotation;
  Matrix9d stiffness;
  for (int i = 0; i < 9; ++i) {
    Vector9d unit = Vector9d::Zero();
    unit[i] = 1.0;
    const Eigen::Matrix3d strain = small_strain(rotation.transpose() * as_matrix(unit));
    stiffness.col(i) = as_vector(rotation * stress_kPa(lame, strain));
  }
  return stiffness;
}

}  // namespace

std::vector<Material> materials_of(const Body& body, MaterialLaw law, double strain_stiffening) {
  GLISSON_ASSERT(law != MaterialLaw::veronda_westmann || strain_stiffening > 0);
  std::vector<Material> materials;
  materials.reserve(body.materials.size());
  for (const Lame& lame : body.materials) materials.push_back(material_of(lame, law, strain_stiffening));
  return materials;
}

double strain_energy_uJ(const Body& body, const std::vector<Material>& materials, const Eigen::VectorXd& u_mm) {
  const Sampling sampling(body.options.order);
  std::vector<double> of_cell(body.layout.cells.size(), 0.0);  // summed in one order, whatever the threads did
  visit_samples(body, sampling, u_mm,
                [&](std::size_t c, std::size_t, const TetGradients&, const Eigen::Matrix3d& f, double volume_mm3) {
                  of_cell[c] += volume_mm3 * energy_density_kPa(materials[c], f);
                });
  return std::accumulate(of_cell.begin(), of_cell.end(), 0.0);
}

Eigen::VectorXd internal_force_mN(const Body& body, const std::vector<Material>& materials,
                                  const Eigen::VectorXd& u_mm) {
  return resisting_force_mN(body, u_mm, [&](std::size_t c, std::size_t, const Eigen::Matrix3d& f) {
    return first_piola_kPa(materials[c], f);
  });
}

void ElasticPotential::add_tangent(const Eigen::VectorXd& u_mm, Tangent which, TangentSum& sum) const {
  const Sampling sampling(body_.options.order);
  std::vector<Matrix9d> tangents(body_.layout.cells.size() * sampling.points());
  visit_samples(body_, sampling, u_mm,
                [&](std::size_t c, std::size_t q, const TetGradients&, const Eigen::Matrix3d& f, double volume_mm3) {
                  Matrix9d& tangent = tangents[c * sampling.points() + q];
                  if (which == Tangent::warped) {
                    tangent = volume_mm3 * warped_stiffness_kPa(body_.materials[c], f);
                    return;
                  }
                  tangent = volume_mm3 * tangent_kPa(materials_[c], f);
                  if (which == Tangent::positive) tangent = positive_part(tangent);
                });

  const auto column_of_cell = [&](std::size_t cell, int b) {
    // Moving node b by e changes F by e g_b^T: the stress follows by these 9x3, and the force on a by its g_a.
    const CellGeometry shape = cell_geometry(body_.mesh, cell);
    std::array<TetGradients, 4> gradients;
    std::array<Eigen::Matrix<double, 9, 3>, 4> stress_by_b;
    for (std::size_t q = 0; q < sampling.points(); ++q) {
      gradients[q] = tet_gradients(sampling.derivatives[q], shape);
      const Matrix9d& tangent = tangents[cell * sampling.points() + q];
      stress_by_b[q] = gradients[q](b, 0) * tangent.middleCols<3>(0) + gradients[q](b, 1) * tangent.middleCols<3>(3) +
                       gradients[q](b, 2) * tangent.middleCols<3>(6);
    }
    return [gradients, stress_by_b, points = sampling.points()](int a) {
      Eigen::Matrix3d block = Eigen::Matrix3d::Zero();
      for (std::size_t q = 0; q < points; ++q) {
        for (int d = 0; d < 3; ++d) block += gradients[q](a, d) * stress_by_b[q].middleRows<3>(3 * d);
      }
      return block;
    };
  };
  sum.add_cells(column_of_cell);
}

std::vector<double> von_mises_of_cells(const Body& body, const std::vector<Material>& materials,
                                       const Eigen::VectorXd& u_mm) {
  std::vector<double> stresses(body.layout.cells.size());
  parallel_for(stresses.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      const Eigen::Matrix3d f = Eigen::Matrix3d::Identity() +
                                displacement_gradient(body.mesh, body.layout, c, Eigen::Vector4d::Constant(0.25), u_mm);
      stresses[c] = von_mises(first_piola_kPa(materials[c], f) * f.transpose() / f.determinant());
    }
  });
  return stresses;
}

}  // namespace glisson::mechanics

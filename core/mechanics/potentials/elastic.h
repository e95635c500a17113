#pragma once
// Energy, forces and stiffness of a body at large deformation. Its material's functions of F are integrated over the
// cells, with one point in a linear cell, four in a quadratic one. `u_mm` has 3 values a node; forces are in mN, 3 a
// node.

#include <vector>

#include "mechanics/elements/body.h"
#include "mechanics/materials/material.h"
#include "mechanics/potentials/potential.h"
#include "mechanics/scenario/scenario.h"

namespace glisson::mechanics {

// One material a cell, from the body's moduli. Neo-Hookean means the one that is stable under inversion;
// `strain_stiffening` is read by Veronda and Westmann's law.
[[nodiscard]] std::vector<Material> materials_of(const Body& body, MaterialLaw law, double strain_stiffening = 0);

// uJ; infinite where a material cannot be what the displacement makes of it.
[[nodiscard]] double strain_energy_uJ(const Body& body, const std::vector<Material>& materials,
                                      const Eigen::VectorXd& u_mm);

// The slope of the energy: what the body resists with, to be balanced by the loads.
[[nodiscard]] Eigen::VectorXd internal_force_mN(const Body& body, const std::vector<Material>& materials,
                                                const Eigen::VectorXd& u_mm);

// The same as a term of the potential energy. The body and its materials must outlive it.
class ElasticPotential : public Potential {
 public:
  ElasticPotential(const Body& body, const std::vector<Material>& materials) : body_(body), materials_(materials) {}

  [[nodiscard]] double energy_uJ(const Eigen::VectorXd& u_mm) const override {
    return strain_energy_uJ(body_, materials_, u_mm);
  }
  void add_force(const Eigen::VectorXd& u_mm, Eigen::VectorXd& force_mN) const override {
    force_mN -= internal_force_mN(body_, materials_, u_mm);
  }
  void add_tangent(const Eigen::VectorXd& u_mm, Tangent which, TangentSum& sum) const override;

 private:
  const Body& body_;
  const std::vector<Material>& materials_;
};

// Von Mises' equivalent of Cauchy's stress P F^T / J (kPa) at each cell's centroid.
[[nodiscard]] std::vector<double> von_mises_of_cells(const Body& body, const std::vector<Material>& materials,
                                                     const Eigen::VectorXd& u_mm);

}  // namespace glisson::mechanics

#pragma once
// What a relaxing body remembers of its stresses from step to step (materials/relaxation.h has law and step). Within a
// step it answers as elastic tissue of `share_within` of its moduli, and besides with what is left of older stresses:
//   A = sum (decay H - share T0),   one a sample of the cells, known before the step.
// Its first Piola-Kirchhoff stress is A itself for the linear law, R A for corotational, R that of the step's start,
// and F A for the others. So the step is linear where it was, and a minimum of a potential where it was one.
//
// Free energy: (1 - sum g) W(F) + sum H : C^-1 : H / (2 g), C of small strain (Simo and Hughes 1998, ch. 10; at large
// strain as Holzapfel and Simo 1996, Int. J. Solids Struct. 33:3019-3034, have it). At small strain a body loses
// sum H : C^-1 : H / (g tau) of it per second, and the step above never gains: its loss is a positive form of H and the
// change of strain at any h.
//
// Stresses kPa, forces mN, 3 a node in the order of NodeLayout; energies uJ.

#include <Eigen/Core>
#include <vector>

#include "mechanics/elements/body.h"
#include "mechanics/materials/material.h"
#include "mechanics/materials/relaxation.h"
#include "mechanics/potentials/potential.h"

namespace glisson::mechanics {

class StressHistory {
 public:
  // Of a body at rest that was never strained. `materials`, one a cell, have their moduli at once. All bodies below are
  // this one, whose moduli are not read.
  StressHistory(const Body& body, std::vector<Material> materials, Relaxation relaxation, double step_s);

  // What older stresses push with in the next step, as dead forces. For laws of large strain F is that of its start.
  [[nodiscard]] Eigen::VectorXd force_mN(const Body& body) const;
  // The same as terms of the step's potential, in which F follows. They name the body.
  [[nodiscard]] Potentials potentials(const Body& body) const;

  // The step ended there. A cell that is crushed flat keeps the elastic stress that it had.
  void advance(const Body& body, const Eigen::VectorXd& u_mm);
  // The body is put there at once, so that nothing relaxes on the way.
  void jump(const Body& body, const Eigen::VectorXd& u_mm);

  // Where the last of these two ended: what the cells resist with, free energy, and von Mises' stress of each cell's
  // middle at that displacement.
  [[nodiscard]] Eigen::VectorXd resisting_force_mN(const Body& body) const;
  [[nodiscard]] double free_energy_uJ(const Body& body) const;
  [[nodiscard]] std::vector<double> von_mises_of_cells(const Body& body, const Eigen::VectorXd& u_mm) const;

 private:
  struct Sample {
    Eigen::Matrix3d frame = Eigen::Matrix3d::Identity();    // I, R or F: the first Piola-Kirchhoff stress is frame T
    Eigen::Matrix3d elastic_kPa = Eigen::Matrix3d::Zero();  // T0
    double elastic_energy_kPa = 0;                          // W(F)
  };
  [[nodiscard]] Eigen::Matrix3d older_kPa(std::size_t sample) const;  // A
  [[nodiscard]] Eigen::Matrix3d stress_kPa(std::size_t sample) const;
  void move(const Body& body, const Eigen::VectorXd& u_mm, const std::vector<RelaxationStep>& steps);

  std::vector<Material> materials_;
  std::vector<Lame> lame_;  // of each at small strain
  Relaxation relaxation_;
  std::vector<RelaxationStep> steps_;
  std::vector<Sample> samples_;
  std::vector<std::vector<Eigen::Matrix3d>> relaxing_kPa_;  // H, one list a term
};

}  // namespace glisson::mechanics

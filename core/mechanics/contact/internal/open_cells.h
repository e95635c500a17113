#pragma once
// Cells that a live cut has opened, at large deformation. On the side s of the cut (1 above, 0 below) the displacement
// is u + sum over corners of (s - H_i) L_i a_i. Here a_i is the jump of the corner i, and H_i is 1 where the corner
// lies above (cutting/internal/jump_functions.h). So F is the nodes' and a constant of each side. The cells' two sides
// are divided into tetrahedra and integrated there, at four points each, in double precision and on one thread.
//
// Jumps follow the nodes among the unknowns: 3 values a node, then 3 a jump (mm, mN).

#include <array>
#include <Eigen/Core>
#include <vector>

#include "mechanics/cutting/opening.h"
#include "mechanics/elements/body.h"
#include "mechanics/materials/material.h"

namespace glisson::mechanics {

class OpenCells {
 public:
  // What bridges the walls, and foundations under them, are springs beside the cells. Bridges stiffen as their tissue
  // does: in Veronda and Westmann's, L E / (6 c2) (exp(3 c2 (a/L)^2) - 1) per area, where a jump a strains the length
  // L, is what uniaxial strain of a/L stores there. Gas at `pressure_kPa` presses on
  // the walls too. Over a closed surface its energy is p times the volume inside. So it adds p cof F to the cells'
  // stress, less what the boundary's part of it counts of these cells. The body and its materials must outlive it.
  OpenCells(const Body& body, const std::vector<Material>& materials, const Opening& opening, double pressure_kPa);

  // Takes what they resist with off the forces. Back comes how many points are inside out, of sides that are more than
  // a twentieth of their cell. What is thinner has no energy to speak of.
  int add_force(const Eigen::VectorXd& x_mm, Eigen::VectorXd& force_mN) const;
  // How far the principal stretches differ from 1 at most, over the same points.
  [[nodiscard]] double largest_strain(const Eigen::VectorXd& x_mm) const;
  // The strain energy of these cells and of the bridges (uJ).
  [[nodiscard]] double energy_uJ(const Eigen::VectorXd& x_mm) const;

  // Of each jump the direction in which its walls part where they are now: the normals at rest, turned as the cells
  // around are.
  [[nodiscard]] std::vector<Eigen::Vector3d> normals(const Eigen::VectorXd& x_mm) const;

  // The stiffness at rest of each jump alone (mN/mm).
  [[nodiscard]] std::vector<Eigen::Matrix3d> own_stiffness() const;
  [[nodiscard]] std::vector<int> cells() const;
  [[nodiscard]] int jumps() const { return static_cast<int>(rest_normals_.size()); }

  // A side of a cell: for the corners that have a jump s - H_i, and 0; and where its volume lies.
  struct Side {
    std::array<double, 4> of_jump;
    double volume_mm3 = 0;
    Eigen::Vector4d centroid;
    std::size_t first = 0, last = 0;  // of the points
    bool counts = true;
  };
  struct Cell {
    std::size_t cell;
    std::array<int, 4> jump;
    Eigen::Matrix<double, 4, 3> barycentric_gradients;
    std::array<Side, 2> sides;
  };
  [[nodiscard]] const std::vector<Cell>& all() const { return cells_; }
  [[nodiscard]] const JumpSprings& springs() const { return springs_; }

 private:
  using Nodes = Eigen::Matrix<double, 3, 10>;
  struct Point {
    Eigen::Matrix<double, 10, 3> gradients;  // of the nodes' functions
    double weight_mm3;
  };
  [[nodiscard]] Nodes nodes_of(const Cell& cell, const Eigen::VectorXd& x_mm) const;
  [[nodiscard]] Eigen::Matrix3d of_jumps(const Cell& cell, const Side& side, const Eigen::VectorXd& x_mm) const;
  // A bridge of tissue that stiffens: what it adds to the springs.
  struct Stiffening {
    std::array<int, 4> jump;
    Eigen::Vector4d share;
    double k_mN_mm, by_length2;  // at rest; 3 c2 / L^2
  };
  [[nodiscard]] Eigen::Vector3d jump_at(const Stiffening& bridge, const Eigen::VectorXd& x_mm) const;
  void add_stiffening(const Eigen::VectorXd& x_mm, Eigen::VectorXd& force_mN) const;
  [[nodiscard]] Eigen::Matrix3d stress_kPa(std::size_t cell, const Eigen::Matrix3d& f) const;
  // F at every point of every side: `at(cell, side, point, F)`.
  template <typename At>
  void for_points(const Eigen::VectorXd& x_mm, const At& at) const;

  const Body& body_;
  const std::vector<Material>& materials_;
  double pressure_kPa_;
  std::vector<Cell> cells_;
  std::vector<Point> points_;
  JumpSprings springs_;
  std::vector<Stiffening> stiffening_;
  std::vector<Eigen::Vector3d> rest_normals_;
};

}  // namespace glisson::mechanics

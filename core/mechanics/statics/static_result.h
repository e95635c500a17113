#pragma once
// What looking for an equilibrium found, why it stopped, and whether it may be used.

#include <Eigen/Core>
#include <string>
#include <vector>

namespace glisson::mechanics {

enum class SolveStatus {
  not_run,
  converged,      // the relative residual reached the tolerance
  not_converged,  // stalled above the tolerance: the displacements are not the equilibrium asked for
};

struct StaticResult {
  SolveStatus status = SolveStatus::not_run;
  std::string why_stopped = "Not run.";

  std::vector<Eigen::Vector3d> displacement_mm;           // one a point of the mesh
  std::vector<Eigen::Vector3d> mid_side_displacement_mm;  // one an edge, in the model's order; empty for linear cells

  Eigen::Vector3d applied_force_mN{0, 0, 0};   // sum of all loads
  Eigen::Vector3d fixed_reaction_mN{0, 0, 0};  // what the fixed points push back with, summed
  // What the points of each fixed support push back with; zero for the other supports, empty where it was not asked
  // for. A point that several supports hold counts for the first of them.
  std::vector<Eigen::Vector3d> support_reaction_mN;
  Eigen::Vector3d foundation_reaction_mN{0, 0, 0};  // what the foundations push back with, summed
  Eigen::Vector3d ligament_reaction_mN{0, 0, 0};    // what the ligaments pull with, summed
  double relative_residual = 0;                     // |K u - f| / |f| over what is free to move (Euclidean)
  int iterations = 0;                               // refinements of a direct solve (0: it sufficed), or Newton steps
  double strain_energy_uJ = 0;                      // in the body; in linear elasticity with its capsule
  double foundation_energy_uJ = 0;                  // at large deformation: of ligaments, capsule and gas as well
  double external_work_uJ = 0;  // f.u / 2 in linear elasticity: equals the energies where nothing fixed is moved
  double max_displacement_mm = 0;
  double largest_strain = 0;       // largest principal strain in magnitude, over the corners of all cells
  int inverted_cells = 0;          // cells that the displacement turns inside out
  std::vector<std::string> notes;  // English sentences a person should know before trusting the numbers
  double setup_s = 0;              // assembly and factorisation of the model
  double step_ms = 0;              // this solve

  // It is the equilibrium asked for; what that is worth says validity.h.
  [[nodiscard]] bool converged() const { return status == SolveStatus::converged; }
  // And no cell of it is inside out.
  [[nodiscard]] bool may_be_used() const { return converged() && inverted_cells == 0; }
};

}  // namespace glisson::mechanics

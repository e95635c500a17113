#pragma once
// What an opening is made of.

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "mechanics/cutting/internal/surface_in_body.h"
#include "mechanics/cutting/internal/whole_walls.h"
#include "mechanics/cutting/opening.h"
#include "mechanics/solvers/dense_cholesky.h"

namespace glisson::mechanics {

// A function that is open.
struct OpenFunction {
  int function;
  std::shared_ptr<const SurfaceInBody> along;
  std::shared_ptr<const SolvedFunction> solved;
  Eigen::Index first;  // of its amplitudes
  [[nodiscard]] const OpeningFunctions& of() const { return *along->functions; }
  [[nodiscard]] int size() const { return along->functions->size; }
};

// A surface as far as it is cut.
struct PartlyCut {
  std::shared_ptr<const SurfaceInBody> along;
  std::vector<CutStrip> strips;
  std::vector<WholeWall> walls;  // of the crossing's cells
};

struct Opening::State {
  State(StaticModel body, Loads loads, Eigen::VectorXd force_mN, SeenPart part)
      : model(std::move(body)),
        standing_loads(std::move(loads)),
        standing_force_mN(std::move(force_mN)),
        seen(std::move(part)) {}

  StaticModel model;
  Loads standing_loads;
  Eigen::VectorXd standing_force_mN;
  SeenPart seen;

  std::vector<PartlyCut> cuts;
  std::vector<OpenFunction> open;
  Eigen::MatrixXd stiffness;                          // S without the bridges
  Eigen::VectorXd own_stiffness;                      // the diagonal of D
  std::optional<DenseCholesky> factor;                // none before anything is open
  Eigen::SparseMatrix<double> jumps;                  // of amplitudes, 3 rows a point
  std::vector<const SurfaceInBody*> surface_of_jump;  // one a point

  // For callers.
  std::vector<int> points;
  std::vector<Eigen::Vector3d> normals;
  std::vector<std::uint8_t> is_cut;
  Eigen::VectorXd standing_load;
  double relative_residual = 0;

  [[nodiscard]] std::vector<int> functions_to_open(const PartlyCut& cut) const;
  [[nodiscard]] bool meets_another_cut(const std::vector<int>& functions, const SurfaceInBody& along) const;
  // What is known of a function, solved for with its group where it was not.
  Result<std::shared_ptr<const SolvedFunction>> solved(const SurfaceInBody& along, int function) const;
  [[nodiscard]] bool knows(const SurfaceInBody& along, int function) const;
  [[nodiscard]] Result<void> solve_group(const SurfaceInBody& along, const std::vector<int>& members) const;
  [[nodiscard]] Result<void> lead_on(PartlyCut& cut, const CutStrip& strip);  // a swept line that was drawn further
  Result<void> open_functions(const std::vector<int>& functions, const std::shared_ptr<const SurfaceInBody>& along);
  void add_points(const OpenFunction& opened);
  void find_jumps();  // of amplitudes
  void find_what_is_cut();
  // Of each point of the mesh the number of its jump along that surface, -1: none.
  [[nodiscard]] std::vector<int> jumps_along(const SurfaceInBody& along) const;
  Result<void> factorise();
  [[nodiscard]] bool frees_a_part() const;
};

}  // namespace glisson::mechanics

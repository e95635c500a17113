// The mesh's error under loads that strain far: a mesh divided once says what one divided twice shows of it, and more
// of it than the error under small loads does.

#include "closedloop/palpation/internal/error_at_strain.h"

#include <gmock/gmock.h>
#include <cmath>

#include "closedloop/palpation/internal/loading.h"
#include "closedloop/palpation/internal/marker_rows.h"
#include "closedloop/palpation/internal/stiffening.h"
#include "palpation_bodies.h"

namespace glisson::closedloop {
namespace {

const Stiffening law{StiffeningLaw::ogden, 11};  // between the coefficients that the error is solved at

struct PressedPad {
  Palpation experiment =
      test::pad({.bricks = {3, 3, 2}, .size_mm = {45, 45, 30}, .forces_N = {0.7, 1.4}, .hold_on = false});
  std::vector<Eigen::Vector3d> markers_mm;
  PalpationSolver solver;
  std::vector<FaceLoad> tools;
  Eigen::Index loads = 0;  // of the solver
};
PressedPad pressed_pad();

// Of each tool those faces of a finer body whose middle lies on a face that the tool loads.
std::vector<FaceLoad> on_finer_faces(const std::vector<FaceLoad>& loads, const mechanics::Body& coarse,
                                     const mechanics::Body& fine);

Eigen::MatrixXd at_markers_mm(const PalpationSolver& solver, const Eigen::MatrixXd& amounts) {
  const auto linear = solver.solution({}).value();
  return solver.markers().at_places(
      stiffened_equilibria(solver.specimen(), *linear, law, solver.loads_mN() * amounts, linear->u_mm * amounts)
          .value());
}

TEST(ErrorAtStrain, IsWhatAMeshDividedTwiceShows) {
  const PressedPad pad = pressed_pad();
  constexpr double pressed_mN = 1400;
  const ErrorAtStrain error(pad.solver, pad.markers_mm, pad.tools,
                            std::vector<LoadRange>(pad.tools.size(), LoadRange{0, pressed_mN}));

  const PalpationSolver once = refined_solver(pad.solver, pad.markers_mm, pad.tools).value();
  const auto faces = on_finer_faces(pad.tools, pad.solver.specimen().body, once.specimen().body);
  const PalpationSolver twice = refined_solver(once, pad.markers_mm, faces).value();

  for (const double load_mN : {0.7 * pressed_mN, pressed_mN}) {
    Eigen::MatrixXd amounts = Eigen::MatrixXd::Zero(pad.loads, 1),
                    of_tools = Eigen::MatrixXd::Zero(once.loads_mN().cols(), 1);
    amounts(pad.tools.front().load, 0) = of_tools(0, 0) = load_mN;
    const Eigen::VectorXd coarse_mm = at_markers_mm(pad.solver, amounts);
    const Eigen::VectorXd truth_mm = at_markers_mm(twice, of_tools);
    const Eigen::VectorXd linear_mm = load_mN * discretisation_error_mm(pad.solver, pad.markers_mm, pad.tools).col(0);
    const Eigen::VectorXd beyond_mm = error.beyond_linear_mm(law, amounts);

    const double without = (truth_mm - coarse_mm - linear_mm).norm();
    const double with = (truth_mm - coarse_mm - linear_mm - beyond_mm).norm();
    std::printf("%.0f mN: error %.4f mm, less its linear part %.4f, less what is beyond %.4f\n", load_mN,
                (truth_mm - coarse_mm).norm(), without, with);
    EXPECT_LT(with, 0.75 * without);
    EXPECT_LT(with, 0.5 * (truth_mm - coarse_mm).norm());
  }
}

TEST(ErrorAtStrain, IsNothingWhereNothingPresses) {
  const PressedPad pad = pressed_pad();
  const ErrorAtStrain error(pad.solver, pad.markers_mm, pad.tools, std::vector<LoadRange>(pad.tools.size()));
  EXPECT_EQ(error.beyond_linear_mm(law, Eigen::MatrixXd::Ones(pad.loads, 2)).cwiseAbs().maxCoeff(), 0);
}

PressedPad pressed_pad() {
  Palpation experiment =
      test::pad({.bricks = {3, 3, 2}, .size_mm = {45, 45, 30}, .forces_N = {0.7, 1.4}, .hold_on = false});
  auto specimen = specimen_body(experiment.mesh, experiment.cell_young_kPa, experiment.supports,
                                experiment.poisson_ratio, experiment.density_kg_mm3)
                      .value();
  LoadColumns columns;
  Eigen::MatrixXd loads_mN;
  const auto histories = histories_and_loads(experiment, specimen, columns, loads_mN).value();
  std::vector<Eigen::Vector3d> markers_mm = marker_rows(experiment).value().places_mm;
  std::vector<FaceLoad> tools = tool_loads(experiment, histories, specimen.body);
  Interpolation markers(specimen.body.layout, mechanics::locate_points(specimen.body.mesh, markers_mm));
  auto solver = PalpationSolver::create(std::move(specimen), std::move(loads_mN), std::move(markers), {}).value();
  return {std::move(experiment), std::move(markers_mm), std::move(solver), std::move(tools), columns.all()};
}

std::vector<FaceLoad> on_finer_faces(const std::vector<FaceLoad>& loads, const mechanics::Body& coarse,
                                     const mechanics::Body& fine) {
  const auto corners = [](const mechanics::Body& body, std::size_t face) {
    Eigen::Matrix3d places;
    for (int i = 0; i < 3; ++i) {
      places.col(i) =
          body.mesh.points_mm[static_cast<std::size_t>(body.boundary[face].points[static_cast<std::size_t>(i)])];
    }
    return places;
  };
  std::vector<FaceLoad> finer = loads;
  for (std::size_t l = 0; l < loads.size(); ++l) {
    finer[l].faces.clear();
    for (std::size_t f = 0; f < fine.boundary.size(); ++f) {
      const Eigen::Vector3d middle = corners(fine, f).rowwise().mean();
      const bool loaded = std::any_of(loads[l].faces.begin(), loads[l].faces.end(), [&](std::size_t face) {
        // All on a plane away from the origin: barycentric coordinates are the solution of corners * b = middle.
        const Eigen::Vector3d b = corners(coarse, face).inverse() * middle;
        return b.minCoeff() > 0 && std::abs(b.sum() - 1) < 1e-9;
      });
      if (loaded) finer[l].faces.push_back(f);
    }
    finer[l].load = static_cast<Eigen::Index>(l);
  }
  return finer;
}

}  // namespace
}  // namespace glisson::closedloop

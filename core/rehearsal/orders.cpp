#include "rehearsal/orders.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Eigenvalues>
#include <limits>
#include <utility>

namespace glisson::rehearsal {
namespace {

void take(Worst& worst, double value, std::size_t step) {
  if (worst.step == 0 || value > worst.value) worst = {value, step};
}

// What a state asks of the liver, where it may be used.
void count(const SessionState& state, std::size_t step, const RehearsalSetup& setup,
           const std::vector<std::size_t>& vessels, OrderOfSteps& order) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  if (!state.refused.empty()) order.refused.push_back(step);
  if (!state.validity.usable()) {
    order.unusable.push_back(step);
    order.largest_move_mm.push_back(unknown);
    order.force_N.push_back(unknown);
    return;
  }
  double largest_mm = 0, force_N = 0;
  for (std::size_t l = 0; l < order.landmarks.size(); ++l) {
    const double moved_mm = state.patient.landmarks[l].displacement_mm;
    take(order.landmarks[l].largest_mm, moved_mm, step);
    order.landmarks[l].end_mm = moved_mm;
    largest_mm = std::max(largest_mm, moved_mm);
  }
  for (const mechanics::ToolContact& tool : state.patient_step.tools) {
    force_N = std::max(force_N, 1e-3 * tool.force_mN.norm());
  }
  order.largest_move_mm.push_back(largest_mm);
  order.force_N.push_back(force_N);
  take(order.largest_force_N, force_N, step);
  take(order.largest_strain, state.validity.largest_strain, step);
  for (const std::size_t v : vessels) {
    if (!order.vessel_strain) order.vessel_strain = Worst{};
    take(*order.vessel_strain, wall_strain(setup.structures[v], state.patient.structures_mm[v]), step);
  }
  if (state.cut) {
    order.open_mm2 = state.cut->open_mm2;
    order.bridge_mm2 = state.cut->bridge_mm2;
  }
}

}  // namespace

Result<OrderOfSteps> run_order(RehearsalSetup setup, const std::vector<std::size_t>& vessels, std::string name,
                               const Recording& recording, const Progress& progress) {
  auto engine = SessionEngine::create(setup, progress.part(0.0, 0.5), reference_in(recording));
  if (!engine) return failure(std::move(engine.error()));
  OrderOfSteps order{std::move(name), {}, {}, {}, {}, 0, 0, {}, {}, {}, {}};
  for (const mechanics::Landmark& landmark : setup.landmarks) order.landmarks.push_back({landmark.id, {}, 0});
  for (std::size_t i = 0; i < recording.size(); ++i) {
    progress.report(0.5 + 0.5 * double(i) / double(recording.size()), GLISSON_TEXT("Moving the tools"));
    if (progress.cancelled()) return cancelled();
    const SessionState& state = engine->step(recording[i].first);
    if (state.settled) {
      count(state, i + 1, setup, vessels, order);
    } else {
      const SessionState rest = engine->settled_state();
      count(rest, i + 1, setup, vessels, order);
    }
  }
  progress.report(1.0, GLISSON_TEXT("Solved"));
  return order;
}

double wall_strain(const geometry::Surface& rest, const std::vector<Eigen::Vector3d>& displaced_mm) {
  std::vector<std::pair<double, double>> strains_and_areas;
  double area_mm2 = 0;
  for (const auto& corners : rest.triangles) {
    const auto edges = [&](const std::vector<Eigen::Vector3d>& points_mm) {
      const Eigen::Vector3d &a = points_mm[corners[0]], &b = points_mm[corners[1]], &c = points_mm[corners[2]];
      return (Eigen::Matrix<double, 3, 2>() << b - a, c - a).finished();
    };
    const Eigen::Matrix<double, 3, 2> before = edges(rest.points_mm), after = edges(displaced_mm);
    const double own_mm2 = 0.5 * before.col(0).cross(before.col(1)).norm();
    if (!(own_mm2 > 1e-6)) continue;
    // Squared stretches: of Cauchy and Green's tensor within the surface.
    const Eigen::Matrix2d metric = before.transpose() * before, deformed = after.transpose() * after;
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix2d> squares(deformed, metric, Eigen::EigenvaluesOnly);
    const Eigen::Vector2d stretches = squares.eigenvalues().cwiseMax(0).cwiseSqrt();
    strains_and_areas.emplace_back((stretches.array() - 1).abs().maxCoeff(), own_mm2);
    area_mm2 += own_mm2;
  }
  std::sort(strains_and_areas.begin(), strains_and_areas.end());
  double below_mm2 = 0;
  for (const auto& [strain, own_mm2] : strains_and_areas) {
    below_mm2 += own_mm2;
    if (below_mm2 >= 0.95 * area_mm2) return strain;
  }
  return 0;
}

}  // namespace glisson::rehearsal

#include "rehearsal/orders.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Eigenvalues>
#include <limits>
#include <utility>

#include "base/json_reading.h"

namespace glisson::rehearsal {
namespace {

constexpr double most_steps = 1e6;  // of a recording, when its figures are read back

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

Result<OrderOfSteps> run_order(const RehearsalSetup& setup, const std::vector<std::size_t>& vessels, std::string name,
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

Result<std::vector<OrderOfSteps>> run_orders(RehearsalSetup setup, const std::vector<std::size_t>& vessels,
                                             const std::vector<NamedRecording>& orders, const Progress& progress) {
  auto models = rehearsal_models(setup, progress.part(0.0, 0.3));
  if (!models) return failure(std::move(models.error()));
  setup.models = *std::move(models);
  std::vector<OrderOfSteps> run;
  for (const auto& [name, recording] : orders) {
    const double begin = 0.3 + 0.7 * double(run.size()) / double(orders.size());
    auto order = run_order(setup, vessels, name, recording, progress.part(begin, begin + 0.7 / double(orders.size())));
    if (!order) return failure(std::move(order.error()));
    run.push_back(*std::move(order));
  }
  return run;
}

Json json_of(const OrderOfSteps& order) {
  const auto put = [](Json& json, const std::string& name, const Worst& worst) {
    json[name] = worst.step == 0 ? Json() : Json(worst.value);
    json[name + "_at_step"] = worst.step == 0 ? Json() : Json(worst.step);
  };
  Json json{{"name", order.name},         {"steps", order.force_N.size()},
            {"open_mm2", order.open_mm2}, {"bridge_mm2", order.bridge_mm2},
            {"refused", order.refused},   {"unusable", order.unusable},
            {"landmarks", Json::array()}};
  put(json, "largest_force_N", order.largest_force_N);
  put(json, "largest_strain", order.largest_strain);
  put(json, "vessel_strain", order.vessel_strain.value_or(Worst{}));
  for (const LandmarkMove& landmark : order.landmarks) {
    Json& entry = json["landmarks"].emplace_back(Json{{"id", landmark.id}, {"end_mm", landmark.end_mm}});
    put(entry, "largest_mm", landmark.largest_mm);
  }
  json["moves_mm"] = order.largest_move_mm;
  json["forces_N"] = order.force_N;
  return null_where_not_finite(std::move(json));
}

OrderOfSteps order_from(const Json& json, const std::string& where) {
  const auto list_in = [&](const char* key) -> const Json& {
    const Json& list = required(json, key, where);
    if (!list.is_array()) refuse_at(where + ", " + key, GLISSON_TEXT("{0} must be a list in brackets."));
    return list;
  };
  const auto step_in = [](const Json& step, const std::string& place) {
    return static_cast<std::size_t>(std::min(positive_in(step, place), most_steps));
  };
  const auto worst = [&](const Json& of, const std::string& name, const std::string& place) -> Worst {
    const Json& step = required(of, (name + "_at_step").c_str(), place);
    if (step.is_null()) return {};
    return {number_in(required(of, name.c_str(), place), place + ", " + name),
            step_in(step, place + ", " + name + "_at_step")};
  };
  OrderOfSteps order{name_in(required(json, "name", where), where + ", name"), {}, {}, {}, {}, 0, 0, {}, {}, {}, {}};
  const Json& landmarks = list_in("landmarks");
  for (std::size_t l = 0; l < landmarks.size(); ++l) {
    const std::string place = where + ", " + item("landmark", l);
    order.landmarks.push_back({name_in(required(landmarks[l], "id", place), place + ", id"),
                               worst(landmarks[l], "largest_mm", place),
                               number_in(required(landmarks[l], "end_mm", place), place + ", end_mm")});
  }
  order.largest_force_N = worst(json, "largest_force_N", where);
  order.largest_strain = worst(json, "largest_strain", where);
  if (const Worst vessels = worst(json, "vessel_strain", where); vessels.step > 0) order.vessel_strain = vessels;
  order.open_mm2 = not_negative_in(required(json, "open_mm2", where), where + ", open_mm2");
  order.bridge_mm2 = not_negative_in(required(json, "bridge_mm2", where), where + ", bridge_mm2");
  const auto steps = [&](const char* key) {
    std::vector<std::size_t> values;
    for (const Json& one : list_in(key)) values.push_back(step_in(one, where + ", " + key));
    return values;
  };
  const auto numbers = [&](const char* key) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> values;
    for (const Json& one : list_in(key)) values.push_back(one.is_null() ? unknown : number_in(one, where + ", " + key));
    return values;
  };
  order.refused = steps("refused");
  order.unusable = steps("unusable");
  order.largest_move_mm = numbers("moves_mm");
  order.force_N = numbers("forces_N");
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

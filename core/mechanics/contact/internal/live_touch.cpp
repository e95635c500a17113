// What the tools do to a live body: the places that they touch, their forces, and the rows that the preconditioner
// sees.

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>

#include "mechanics/contact/internal/live_step.h"
#include "mechanics/contact/internal/tool_contact_potential.h"

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double jaws_are_stiffer = 20;
constexpr double margin_mm = 0.5;  // that a place is near within

std::vector<std::pair<int, Vector3d>> directions_at(const ContactConstraint& place, const Vector3d& direction) {
  std::vector<std::pair<int, Vector3d>> on;
  for (int c = 0; c < 6; ++c) {
    if (place.weights[c] != 0) on.emplace_back(place.nodes[c], place.weights[c] * direction);
  }
  return on;
}

}  // namespace

Result<void> LiveStep::take_tools(const LiveState& from, Until until) {
  further_of_.assign(tools_.size(), -1);
  advance_mm_ = VectorXd::Zero(static_cast<Eigen::Index>(tools_.size()));
  for (std::size_t t = 0; t < tools_.size(); ++t) {
    if (const auto* touching = std::get_if<TouchingTool>(&tools_[t].what)) {
      if (auto taken = take_touching(t, *touching, from); !taken) return taken;
      continue;
    }
    if (const auto* patch = std::get_if<ToolLoad>(&tools_[t].what)) {
      if (auto taken = take_patch(t, *patch); !taken) return taken;
      continue;
    }
    const auto& grasp = std::get<Grasp>(tools_[t].what);
    auto gripped = grip(parts_.surface, t, grasp);
    if (!gripped) return failure(std::move(gripped.error()));
    Jaws held{{}, gripped->weights, Vector3d::Zero(), t};
    for (const int point : gripped->points) held.nodes.push_back(parts_.node_of_point[static_cast<std::size_t>(point)]);
    if (const double* pull_mN = std::get_if<double>(&grasp.drawn)) {
      for (std::size_t i = 0; i < held.nodes.size(); ++i) {
        dead_mN_.segment<3>(3 * held.nodes[i]) += held.weights[i] * *pull_mN * grasp.direction.normalized();
      }
    } else {
      held.wanted_mm = std::get<Vector3d>(grasp.drawn);
      for (std::size_t i = 0; i < held.nodes.size(); ++i) {
        held.wanted_mm += held.weights[i] * parts_.untouched.u_mm.segment<3>(3 * held.nodes[i]);
      }
      jaws_.push_back(std::move(held));
    }
    grips_.push_back(std::move(*gripped));
  }
  begin(from, until);
  if (until == Until::settled) state_.stiffer = from.stiffer;
  for (std::size_t t = 0; t < tools_.size(); ++t) {
    const auto* touching = std::get_if<TouchingTool>(&tools_[t].what);
    for (const LivePlace& place : from.places) {
      if (touching == nullptr || place.tool != tools_[t].id || place.rod >= touching->shape.size()) continue;
      add_place(t, place.rod, {place.face, place.point});
      places_.back().multiplier_mN = until == Until::shown ? place.multiplier_mN : place.settling_mN.value_or(0.0);
      const auto& anchored_mm = until == Until::shown ? place.anchor_mm : place.anchor_before_mm;
      if (anchored_mm) places_.back().from_on_tool_mm = *anchored_mm;
    }
  }
  place_rods();
  return {};
}

Result<void> LiveStep::take_touching(std::size_t tool, const TouchingTool& touching, const LiveState& from) {
  if (auto checked = check_tool(touching.shape, touching.pose); !checked) return failure(std::move(checked.error()));
  if (!touching.push_mN) return {};
  further_of_[tool] = further_++;
  double& advance_mm = advance_mm_[static_cast<Eigen::Index>(tool)];
  const auto before = from.advance_mm.find(tools_[tool].id);
  if (before != from.advance_mm.end()) {
    advance_mm = before->second;
    return {};
  }
  const auto way_mm = way_to_surface(parts_.surface, touching, parts_.surface_of(from.u_mm));
  if (!way_mm) return failure(way_mm.error());
  advance_mm = *way_mm;
  return {};
}

// A step begins where the one before ended; settling goes on with the step under way.
void LiveStep::begin(const LiveState& from, Until until) {
  LiveBegin now =
      until == Until::settled && from.began ? *from.began : LiveBegin{from.u_mm.head(parts_.unknowns()), from.poses};
  for (std::size_t t = 0; t < tools_.size(); ++t) {
    if (std::holds_alternative<TouchingTool>(tools_[t].what)) now.poses.try_emplace(tools_[t].id, pose_of(t));
  }
  began_ = std::make_shared<const LiveBegin>(std::move(now));
}

Result<void> LiveStep::take_patch(std::size_t tool, const ToolLoad& patch) {
  const auto force_mN = load_vector(parts_.body.mesh, parts_.body.layout, parts_.body.boundary,
                                    parts_.body.options.density_kg_mm3, {patch});
  if (!force_mN) return failure(force_mN.error());
  dead_mN_.head(force_mN->size()) += *force_mN;
  if (cut_ != nullptr) dead_mN_.tail(n_ - force_mN->size()) += cut_->opening.force_on_jumps_mN({patch});
  Spread spread{tool, {}};
  for (int node = 0; node < parts_.body.layout.nodes(); ++node) {
    const Vector3d on_node = force_mN->segment<3>(3 * node);
    if (!on_node.isZero(0)) spread.force_mN.emplace_back(node, on_node);
  }
  patches_.push_back(std::move(spread));
  return {};
}

// Those that come near join without a force; those that were left go.
Result<void> LiveStep::find_places() {
  std::erase_if(places_, [&](const ContactConstraint& place) {
    const Gap gap = gap_of(place, state_.u_mm);
    return gap.mm > margin_mm && normal_force_mN(place, gap) == 0;
  });
  add_near_places();
  for (std::size_t t = 0; t < tools_.size(); ++t) {
    if (further_of_[t] < 0) continue;
    if (auto met = slide_on(t); !met) return met;
  }
  place_rods();
  return {};
}

// A pushed tool that is near no place, until it is: what nothing resists would go any way. It first touches the surface
// between the places, as on an edge, and then goes by steps that no place is passed in.
Result<void> LiveStep::slide_on(std::size_t tool) {
  TouchingTool pushed = std::get<TouchingTool>(tools_[tool].what);
  const auto of_it = [&](const ContactConstraint& place) { return place.tool == tool; };
  while (*pushed.push_mN > 0 && std::none_of(places_.begin(), places_.end(), of_it)) {
    pushed.pose = pose_of(tool);
    const auto way_mm = way_to_surface(parts_.surface, pushed, parts_.surface_of(state_.u_mm));
    if (!way_mm) return failure(slides_past(tool));
    advance_mm_[static_cast<Eigen::Index>(tool)] += std::max(*way_mm, margin_mm);
    add_near_places();
  }
  return {};
}

void LiveStep::add_near_places() {
  constexpr double deepest_between_mm = 0.2;
  for (const NearPoint& near :
       points_near(parts_.body, tools_, advance_mm_, state_.u_mm, margin_mm, deepest_between_mm)) {
    const bool known = std::any_of(places_.begin(), places_.end(), [&](const ContactConstraint& other) {
      return other.tool == near.tool && other.which_rod == near.rod && other.at == near.at;
    });
    if (!known) add_place(near.tool, near.rod, near.at);
  }
}

void LiveStep::add_place(std::size_t tool, std::size_t rod, const ContactPoint& at) {
  const double friction = std::get<TouchingTool>(tools_[tool].what).friction;
  // What rubs does not slide away as multipliers move on, and stiff pressures would swing its limit to and fro.
  const bool soft = until_ == Until::shown || friction > 0;
  const double pressing_kPa_mm = soft ? parts_.pressing_kPa_mm : state_.stiffer * parts_.settling_kPa_mm;
  ContactConstraint& place =
      places_.emplace_back(constraint_at(parts_.body, tool, rod, at, pressing_kPa_mm, parts_.friction_kPa_mm));
  place.friction = friction;
  if (place.friction == 0) return;
  const Pose& before = began_->poses.at(tools_[tool].id);
  place.from_on_tool_mm = before.rotation.transpose() * (place_of(place, began_->u_mm) - before.position_mm);
}

// As what presses now allows.
void LiveStep::limit_friction() {
  for (ContactConstraint& place : places_) {
    if (place.friction == 0) continue;
    mechanics::limit_friction(place, normal_force_mN(place, gap_of(place, state_.u_mm)), state_.u_mm);
  }
}

void LiveStep::place_rods() {
  for (ContactConstraint& place : places_) {
    const auto& tool = std::get<TouchingTool>(tools_[place.tool].what);
    const Pose pose = pose_of(place.tool);
    place.rod = placed({tool.shape[place.which_rod]}, pose).front();
    place.from_mm = pose.rotation * place.from_on_tool_mm + pose.position_mm;
  }
}

Pose LiveStep::pose_of(std::size_t tool) const {
  return std::get<TouchingTool>(tools_[tool].what).pose.advanced(advance_mm_[static_cast<Eigen::Index>(tool)]);
}

VectorXd LiveStep::with_tools(const Unbalanced& balance, const VectorXd& u_mm) {
  VectorXd r_mN = alone(balance);
  tools_mN_ = 0;
  for (const ContactConstraint& place : places_) {
    const Gap gap = gap_of(place, u_mm);
    const Vector3d force_mN = normal_force_mN(place, gap) * gap.normal + friction_force_of(place, u_mm).force_mN;
    tools_mN_ += force_mN.norm();
    for (int c = 0; c < 6; ++c) r_mN.segment<3>(3 * place.nodes[c]) += place.weights[c] * force_mN;
    const std::size_t t = place.tool;
    if (further_of_[t] >= 0) r_mN[n_ + further_of_[t]] -= force_mN.dot(forward_of(t));
  }
  for (const Jaws& held : jaws_) {
    Vector3d off_mm = held.wanted_mm;
    for (std::size_t i = 0; i < held.nodes.size(); ++i) off_mm -= held.weights[i] * u_mm.segment<3>(3 * held.nodes[i]);
    const Vector3d pull_mN = jaws_are_stiffer * parts_.k_mN_mm * off_mm;
    tools_mN_ += pull_mN.norm();
    for (std::size_t i = 0; i < held.nodes.size(); ++i) {
      r_mN.segment<3>(3 * held.nodes[i]) += held.weights[i] * pull_mN;
    }
  }
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    const double press_mN = pressing_mN(w, u_mm);
    tools_mN_ += press_mN;
    r_mN.segment<3>(parts_.unknowns() + 3 * static_cast<Eigen::Index>(w)) += press_mN * walls_[w].normal;
  }
  parts_.free(r_mN);
  return r_mN;
}

// Of all that is near, as the tangent sees it.
void LiveStep::look_at_rows(const VectorXd& u_mm) {
  rows_.clear();
  bends_.clear();
  for (const ContactConstraint& place : places_) {
    const Gap gap = gap_of(place, u_mm);
    const std::size_t t = place.tool;
    const Vector3d forward = further_of_[t] >= 0 ? forward_of(t) : Vector3d::Zero();
    StiffRow row;
    row.on = directions_at(place, gap.normal);
    row.further = further_of_[t];
    row.along = gap.normal.dot(forward);
    row.stiffness = place.k_mN_mm;
    row.gap_mm = gap.mm - place.multiplier_mN / place.k_mN_mm;
    const double force = normal_force_mN(place, gap);
    if (force > 0) bends_.push_back({&place, -force * gap.bend, further_of_[t], forward});
    rows_.push_back(std::move(row));
    if (place.friction_limit_mN > 0) add_friction_rows(place, u_mm, forward);
  }
  for (const Jaws& held : jaws_) {
    Vector3d off_mm = -held.wanted_mm;
    for (std::size_t i = 0; i < held.nodes.size(); ++i) off_mm += held.weights[i] * u_mm.segment<3>(3 * held.nodes[i]);
    for (int d = 0; d < 3; ++d) {
      StiffRow row;
      for (std::size_t i = 0; i < held.nodes.size(); ++i) {
        row.on.emplace_back(held.nodes[i], held.weights[i] * Vector3d::Unit(d));
      }
      row.stiffness = jaws_are_stiffer * parts_.k_mN_mm;
      row.gap_mm = off_mm[d];
      row.two_sided = true;
      rows_.push_back(std::move(row));
    }
  }
  look_at_walls(u_mm);
}

// Along the surface. Where it slips the force grows no more: its secant never goes too far, and half of that not so far
// that the step after would be longer (over-relaxation of a majorizer).
void LiveStep::add_friction_rows(const ContactConstraint& place, const VectorXd& u_mm, const Vector3d& forward) {
  Vector3d off_mm = place_of(place, u_mm) - place.from_mm;
  off_mm -= off_mm.dot(place.normal) * place.normal;
  const double slid_mm = off_mm.norm();
  const bool slips = place.along_mN_mm * slid_mm > place.friction_limit_mN;
  const double secant_mN_mm = slips ? place.friction_limit_mN / slid_mm : place.along_mN_mm;
  const Vector3d way = slips ? Vector3d(off_mm / slid_mm) : place.normal.unitOrthogonal();
  for (const Vector3d& along : {way, Vector3d(place.normal.cross(way))}) {
    StiffRow row;
    row.on = directions_at(place, along);
    row.further = further_of_[place.tool];
    row.along = along.dot(forward);
    row.stiffness = (slips && along == way ? 0.5 : 1.0) * secant_mN_mm;
    row.gap_mm = secant_mN_mm * along.dot(off_mm) / row.stiffness;
    row.two_sided = true;
    rows_.push_back(std::move(row));
  }
}

// At rest, but too deep. Smooth tools press by a stiffer penalty, as far as conjugate gradients balance it: multipliers
// keep to the body, and what they hold slides from under a tool. The others' multipliers move on.
void LiveStep::press_harder() {
  constexpr double times = 2, most = 16;
  const bool smooth_are_too_deep = std::any_of(places_.begin(), places_.end(), [&](const ContactConstraint& place) {
    return place.friction == 0 && -gap_of(place, state_.u_mm).mm > options_.penetration_tolerance_mm;
  });
  const bool stiffens = smooth_are_too_deep && state_.stiffer < most;
  if (stiffens) {
    state_.stiffer *= times;
    for (ContactConstraint& place : places_) place.k_mN_mm *= place.friction == 0 ? times : 1.0;
  }
  move_multipliers_on(stiffens ? Moves::all_but_smooth : Moves::all);
}

void LiveStep::move_multipliers_on(Moves which) {
  for (ContactConstraint& place : places_) {
    if (which == Moves::all_but_smooth && place.friction == 0) continue;
    place.multiplier_mN = normal_force_mN(place, gap_of(place, state_.u_mm));
  }
  for (std::size_t w = 0; w < walls_.size(); ++w) walls_[w].multiplier_mN = pressing_mN(w, state_.u_mm);
}

double LiveStep::deepest_mm() const {
  double deepest = overlap_mm();
  for (const ContactConstraint& place : places_) deepest = std::max(deepest, -gap_of(place, state_.u_mm).mm);
  return deepest;
}

LiveState LiveStep::finished(const Stopwatch& watch) {
  if (!began_->poses.empty()) state_.began = began_;
  for (std::size_t t = 0; t < tools_.size(); ++t) {
    const double advance_mm = advance_mm_[static_cast<Eigen::Index>(t)];
    if (further_of_[t] >= 0) state_.advance_mm[tools_[t].id] = advance_mm;
    if (std::holds_alternative<TouchingTool>(tools_[t].what)) state_.poses[tools_[t].id] = pose_of(t);
    ToolContact contact{tools_[t].id, Vector3d::Zero(), 0, advance_mm, 0};
    state_.tools.push_back(std::move(contact));
  }
  for (ContactConstraint& place : places_) {
    const Gap gap = gap_of(place, state_.u_mm);
    const double normal_mN = until_ == Until::shown ? place.multiplier_mN : normal_force_mN(place, gap);
    ToolContact& contact = state_.tools[place.tool];
    contact.penetration_mm = std::max(contact.penetration_mm, -gap.mm);
    LivePlace kept{tools_[place.tool].id, place.which_rod, place.at.face, place.at.point, normal_mN};
    if (until_ == Until::settled) kept.settling_mN = place.multiplier_mN;
    Vector3d force_mN = normal_mN * gap.normal;
    if (place.friction > 0) {
      mechanics::limit_friction(place, normal_mN, state_.u_mm);
      const FrictionForce friction = friction_force_of(place, state_.u_mm);
      if (normal_mN > 0) ++(friction.slips ? contact.slipping : contact.sticking);
      force_mN += friction.force_mN;
      const Pose pose = pose_of(place.tool);
      kept.anchor_before_mm = place.from_on_tool_mm;
      const Vector3d drawn_mm = place_of(place, state_.u_mm) + friction.force_mN / place.along_mN_mm;
      if (normal_mN > 0) {
        kept.anchor_mm = friction.slips ? Vector3d(pose.rotation.transpose() * (drawn_mm - pose.position_mm))
                                        : place.from_on_tool_mm;
      }
    }
    if (normal_mN > 0) ++contact.contacts;
    contact.force_mN += force_mN;
    state_.moment_uJ += place_of(place, state_.u_mm).cross(force_mN);
    state_.places.push_back(std::move(kept));
  }
  for (const Gripped& gripped : grips_) {
    ToolContact& contact = state_.tools[gripped.tool];
    contact.contacts = static_cast<int>(gripped.points.size());
    const auto& grasp = std::get<Grasp>(tools_[gripped.tool].what);
    if (const double* pull_mN = std::get_if<double>(&grasp.drawn)) {
      contact.force_mN = *pull_mN * grasp.direction.normalized();
    }
    for (const Jaws& held : jaws_) {
      if (held.tool != gripped.tool) continue;
      Vector3d off_mm = held.wanted_mm;
      for (std::size_t i = 0; i < held.nodes.size(); ++i) {
        off_mm -= held.weights[i] * state_.u_mm.segment<3>(3 * held.nodes[i]);
      }
      contact.force_mN = jaws_are_stiffer * parts_.k_mN_mm * off_mm;
    }
    for (std::size_t i = 0; i < gripped.points.size(); ++i) {
      const int point = gripped.points[i];
      const Vector3d at_mm = parts_.surface.points_mm[static_cast<std::size_t>(point)] +
                             state_.u_mm.segment<3>(3 * parts_.node_of_point[static_cast<std::size_t>(point)]);
      state_.moment_uJ += at_mm.cross(gripped.weights[i] * contact.force_mN);
    }
  }
  for (const Spread& patch : patches_) {
    ToolContact& contact = state_.tools[patch.tool];
    contact.contacts = static_cast<int>(patch.force_mN.size());
    for (const auto& [node, force] : patch.force_mN) {
      const Vector3d at_mm =
          parts_.body.layout.positions_mm[static_cast<std::size_t>(node)] + state_.u_mm.segment<3>(3 * node);
      contact.force_mN += force;
      state_.moment_uJ += at_mm.cross(force);
    }
  }
  ContactReport& report = state_.report;
  report.penetration_mm = deepest_mm();
  report.movement_mm = std::isfinite(moved_mm_) ? moved_mm_ : 0.0;
  report.inverted_cells = now_.inverted_points;
  report.converged = now_.inverted_points == 0;
  if (!squared_.empty()) report.largest_strain = cells().largest_strain(parts_.body, state_.u_mm, squared_);
  state_.resisting_mN = std::move(now_.resisting_mN);
  parts_.show(state_);
  if (cut_ != nullptr) show_cut();
  report.solve_ms = 1e3 * watch.seconds();
  return std::move(state_);
}

}  // namespace glisson::mechanics

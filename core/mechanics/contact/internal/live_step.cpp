#include "mechanics/contact/internal/live_step.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>

#include "mechanics/contact/internal/tool_contact_potential.h"

namespace glisson::mechanics {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

// The bound: so many times the weighted residual and the deepest penetration, which multipliers that lag leave, and a
// tenth of a millimetre. Found on the tuning paths of docs/performance.md and not changed after.
constexpr double of_residual = 2.5, of_penetration = 1.5, beside_mm = 0.1;

constexpr double jaws_are_stiffer = 20;

}  // namespace

Result<LiveState> LiveStep::run(const LiveState& from, Until until) {
  const Stopwatch watch;
  if (auto taken = take_tools(from); !taken) return failure(std::move(taken.error()));
  const bool settling = until == Until::settled;
  const int most_rounds = settling ? options_.settling_rounds : options_.most_rounds;
  now_ = from.resisting_mN.size() == n_ ? under_loads(from.resisting_mN, from.report.inverted_cells)
                                        : unbalanced(state_.u_mm);
  for (int round = 0;; ++round) {
    find_places();
    const VectorXd r_mN = with_tools(now_, state_.u_mm);
    look_at_rows(state_.u_mm);
    const SplineLevels::WithRows levels(parts_.levels, rows_, further_, alone(now_));
    // Nobody is told how good the picture was that a step begins with.
    const double left_mm = settling || round > 0 ? estimate(levels) : 0.0;
    state_.report.relative_residual = r_mN.norm() / (dead_mN_.norm() + tools_mN_ + parts_.k_mN_mm * hair_mm);
    const double deepest = deepest_mm();
    state_.error_bound_mm = of_residual * left_mm + of_penetration * deepest + beside_mm;
    const bool at_rest =
        left_mm <= options_.settled_mm && state_.report.relative_residual <= options_.relative_residual;
    if (settling && at_rest) {
      if (deepest <= options_.penetration_tolerance_mm && (round == 0 || moved_mm_ <= options_.movement_tolerance_mm)) {
        state_.settled = true;
        state_.error_bound_mm = of_residual * left_mm + of_penetration * deepest;
        break;
      }
      move_multipliers_on();
      look_at_rows(state_.u_mm);
    }
    if (round == most_rounds || (!settling && round > 0 && state_.error_bound_mm <= options_.shown_mm)) break;
    const VectorXd again_mN = settling && at_rest ? with_tools(now_, state_.u_mm) : r_mN;
    go(direction(levels, again_mN, settling ? options_.settling_gradients : options_.gradients, settling), again_mN);
    if (progress_.cancelled()) return cancelled();
    if (now_.inverted_points > 0 && !settling) {
      return failure("not-converged",
                     GLISSON_TEXT("The step would turn cells inside out ({0}): a tool goes too far into the body."),
                     {std::to_string(now_.inverted_points)});
    }
  }
  if (!settling) move_multipliers_on();
  return finished(watch);
}

Result<void> LiveStep::take_tools(const LiveState& from) {
  further_of_.assign(tools_.size(), -1);
  advance_mm_ = VectorXd::Zero(static_cast<Eigen::Index>(tools_.size()));
  for (std::size_t t = 0; t < tools_.size(); ++t) {
    if (const auto* touching = std::get_if<TouchingTool>(&tools_[t].what)) {
      if (auto checked = check_tool(touching->shape, touching->pose); !checked) {
        return failure(std::move(checked.error()));
      }
      if (touching->push_mN) {
        further_of_[t] = further_++;
        double& advance_mm = advance_mm_[static_cast<Eigen::Index>(t)];
        const auto before = from.advance_mm.find(tools_[t].id);
        if (before != from.advance_mm.end()) {
          advance_mm = before->second;
        } else {
          const auto way_mm = way_to_surface(parts_.surface, *touching, parts_.surface_of(from.u_mm));
          if (!way_mm) return failure(way_mm.error());
          advance_mm = *way_mm;
        }
      }
      for (const LivePlace& place : from.places) {
        if (place.tool != tools_[t].id || place.rod >= touching->shape.size()) continue;
        places_.push_back(
            constraint_at({t, place.rod, place.points, place.weights}, parts_.surface, parts_.node_of_point));
        places_.back().multiplier_mN = place.multiplier_mN;
      }
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
  place_rods();
  return {};
}

Result<void> LiveStep::take_patch(std::size_t tool, const ToolLoad& patch) {
  const auto force_mN = load_vector(parts_.body.mesh, parts_.body.layout, parts_.body.boundary,
                                    parts_.body.options.density_kg_mm3, {patch});
  if (!force_mN) return failure(force_mN.error());
  dead_mN_ += *force_mN;
  Spread spread{tool, {}};
  for (int node = 0; node < parts_.body.layout.nodes(); ++node) {
    const Vector3d on_node = force_mN->segment<3>(3 * node);
    if (!on_node.isZero(0)) spread.force_mN.emplace_back(node, on_node);
  }
  patches_.push_back(std::move(spread));
  return {};
}

// Those that come near join without a force; those that were left go.
void LiveStep::find_places() {
  constexpr double margin_mm = 1.0;
  std::erase_if(places_, [&](const ContactConstraint& place) {
    const Gap gap = gap_of(place, state_.u_mm);
    return gap.mm > margin_mm && normal_force_mN(place, parts_.k_mN_mm, gap) == 0;
  });
  std::vector<TrackedContact> kept;
  for (const ContactConstraint& place : places_) kept.push_back(place.place);
  const VectorXd moved_mm = parts_.surface_of(state_.u_mm);
  for (const ContactCandidate& near : contact_candidates(parts_.surface, tools_, advance_mm_, moved_mm, margin_mm)) {
    keep({near.tool, near.rod, near.points, near.weights}, parts_.surface, kept);
  }
  for (std::size_t i = places_.size(); i < kept.size(); ++i) {
    places_.push_back(constraint_at(kept[i], parts_.surface, parts_.node_of_point));
  }
  place_rods();
}

void LiveStep::place_rods() {
  for (ContactConstraint& place : places_) {
    const auto& tool = std::get<TouchingTool>(tools_[place.place.tool].what);
    place.rod = placed({tool.shape[place.place.rod]}, pose_of(place.place.tool)).front();
  }
}

Pose LiveStep::pose_of(std::size_t tool) const {
  Pose pose = std::get<TouchingTool>(tools_[tool].what).pose;
  pose.position_mm += advance_mm_[static_cast<Eigen::Index>(tool)] * pose.forward();
  return pose;
}

Unbalanced LiveStep::unbalanced(const VectorXd& u_mm) {
  VectorXd resisting_mN = VectorXd::Zero(n_);
  for (const auto& term : parts_.around) term->add_force(u_mm, resisting_mN);
  const int inverted_points = parts_.cells.add_force(u_mm, resisting_mN, squared_).inverted_points;
  return under_loads(std::move(resisting_mN), inverted_points);
}

Unbalanced LiveStep::under_loads(VectorXd resisting_mN, int inverted_points) const {
  Unbalanced balance{std::move(resisting_mN), {}, inverted_points};
  balance.body_mN = dead_mN_ + balance.resisting_mN;
  parts_.free(balance.body_mN);
  return balance;
}

// Without what the tools push with.
VectorXd LiveStep::alone(const Unbalanced& balance) const {
  VectorXd r_mN = VectorXd::Zero(n_ + further_);
  r_mN.head(n_) = balance.body_mN;
  for (std::size_t t = 0; t < tools_.size(); ++t) {
    if (further_of_[t] >= 0) r_mN[n_ + further_of_[t]] = *std::get<TouchingTool>(tools_[t].what).push_mN;
  }
  return r_mN;
}

VectorXd LiveStep::with_tools(const Unbalanced& balance, const VectorXd& u_mm) {
  VectorXd r_mN = alone(balance);
  tools_mN_ = 0;
  for (const ContactConstraint& place : places_) {
    const Gap gap = gap_of(place, u_mm);
    const double force = normal_force_mN(place, parts_.k_mN_mm, gap);
    tools_mN_ += force;
    for (int c = 0; c < 3; ++c) r_mN.segment<3>(3 * place.nodes[c]) += force * place.place.weights[c] * gap.normal;
    const std::size_t t = place.place.tool;
    if (further_of_[t] >= 0) r_mN[n_ + further_of_[t]] -= force * gap.normal.dot(forward_of(t));
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
  parts_.free(r_mN);
  return r_mN;
}

// Of all that is near, as the tangent sees it.
void LiveStep::look_at_rows(const VectorXd& u_mm) {
  rows_.clear();
  bends_.clear();
  for (const ContactConstraint& place : places_) {
    const Gap gap = gap_of(place, u_mm);
    const std::size_t t = place.place.tool;
    const Vector3d forward = further_of_[t] >= 0 ? forward_of(t) : Vector3d::Zero();
    StiffRow row;
    for (int c = 0; c < 3; ++c) row.on.emplace_back(place.nodes[c], place.place.weights[c] * gap.normal);
    row.further = further_of_[t];
    row.along = gap.normal.dot(forward);
    row.stiffness = parts_.k_mN_mm;
    row.gap_mm = gap.mm - place.multiplier_mN / parts_.k_mN_mm;
    const double force = normal_force_mN(place, parts_.k_mN_mm, gap);
    if (force > 0) bends_.push_back({&place, -force * gap.bend, further_of_[t], forward});
    rows_.push_back(std::move(row));
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
}

// How far the judged places are from rest, by what they answered to unit forces.
double LiveStep::estimate(const SplineLevels::WithRows& levels) const {
  if (parts_.adjoints.cols() == 0) return 0;
  VectorXd pressing_mN(static_cast<Eigen::Index>(rows_.size())), rest_mN;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const double force = -rows_[i].stiffness * rows_[i].gap_mm;
    pressing_mN[static_cast<Eigen::Index>(i)] = rows_[i].two_sided ? force : std::max(0.0, force);
  }
  levels.rest_of(pressing_mN, rest_mN);
  const Eigen::VectorXf left_mm = parts_.adjoints.transpose() * rest_mN.head(n_).cast<float>();
  double farthest_mm = 0;
  for (Eigen::Index l = 0; l < left_mm.size(); l += 3) {
    farthest_mm = std::max(farthest_mm, double{left_mm.segment<3>(l).norm()});
  }
  return farthest_mm;
}

void LiveStep::add_rows_times(const SplineLevels::WithRows& levels, const VectorXd& p, VectorXd& product) const {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (!levels.presses(i)) continue;
    const StiffRow& row = rows_[i];
    double seen = row.further >= 0 ? -row.along * p[n_ + row.further] : 0.0;
    for (const auto& [node, direction] : row.on) seen += direction.dot(p.segment<3>(3 * node));
    seen *= row.stiffness;
    for (const auto& [node, direction] : row.on) product.segment<3>(3 * node) += seen * direction;
    if (row.further >= 0) product[n_ + row.further] -= seen * row.along;
  }
  for (const Bend& bend : bends_) {
    Vector3d moved = Vector3d::Zero();
    for (int c = 0; c < 3; ++c) moved += bend.place->place.weights[c] * p.segment<3>(3 * bend.place->nodes[c]);
    if (bend.further >= 0) moved -= p[n_ + bend.further] * bend.forward;
    const Vector3d answer = bend.stiffness * moved;
    for (int c = 0; c < 3; ++c) product.segment<3>(3 * bend.place->nodes[c]) += bend.place->place.weights[c] * answer;
    if (bend.further >= 0) product[n_ + bend.further] -= bend.forward.dot(answer);
  }
}

// Conjugate gradients on the tangent. Where a tool would slide off, that is left out, and they begin again.
VectorXd LiveStep::direction(const SplineLevels::WithRows& levels, const VectorXd& r_mN, int gradients, bool settling) {
  // A row that presses from now on has a gap to close first, and one that lets go keeps no force.
  VectorXd begin = r_mN, pressing_mN = VectorXd::Zero(static_cast<Eigen::Index>(rows_.size()));
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const StiffRow& row = rows_[i];
    if (levels.presses(i)) pressing_mN[static_cast<Eigen::Index>(i)] = -row.stiffness * row.gap_mm;
    if (row.two_sided || levels.presses(i) == (row.gap_mm < 0)) continue;
    const double force = (levels.presses(i) ? -1 : 1) * row.stiffness * row.gap_mm;
    for (const auto& [node, along] : row.on) begin.segment<3>(3 * node) += force * along;
    if (row.further >= 0) begin[n_ + row.further] -= force * row.along;
  }
  parts_.free(begin);
  VectorXd step = VectorXd::Zero(begin.size()), left = begin, z, p, product(begin.size());
  levels.apply_along_rows(pressing_mN, z);
  p = z;
  double rho = left.dot(z);
  const double first_rho = rho;
  for (int done = 0; done < gradients && rho > 0 && !progress_.cancelled();) {
    // Differences of the force over a thousandth of a millimetre: seven digits of it are left, and CG needs three.
    const double size = p.head(n_).cwiseAbs().maxCoeff();
    const double h = size > 0 ? 1e-3 / size : 1.0;
    const Unbalanced moved = unbalanced(state_.u_mm + h * p.head(n_));
    product.head(n_) = (now_.body_mN - moved.body_mN) / h;
    product.tail(further_).setZero();
    add_rows_times(levels, p, product);
    parts_.free(product);
    ++state_.report.rounds;
    const double curvature = p.dot(product);
    if (!(curvature > 0)) {
      if (bends_.empty()) return step.squaredNorm() > 0 ? step : p;
      bends_.clear();
      step.setZero();
      left = begin;
      levels.apply_along_rows(pressing_mN, z);
      p = z;
      rho = first_rho;
      continue;
    }
    step += rho / curvature * p;
    left -= rho / curvature * product;
    constexpr double enough = 1e-4;  // of the energy
    if (++done == gradients) break;
    levels.apply(left, z);
    const double next = left.dot(z);
    if (settling && next < enough * first_rho) break;
    p = z + next / rho * p;
    rho = next;
  }
  return step;
}

// All of the step, or less of it where it would turn cells inside out or climb far beyond the lowest place on its way.
void LiveStep::go(const VectorXd& step, const VectorXd& r_mN) {
  const VectorXd before_mm = advance_mm_;
  const double slope = r_mN.dot(step);
  double length = 1;
  for (int attempt = 0;; ++attempt) {
    VectorXd u_mm = state_.u_mm + length * step.head(n_);
    for (std::size_t t = 0; t < tools_.size(); ++t) {
      const auto at = static_cast<Eigen::Index>(t);
      if (further_of_[t] >= 0) advance_mm_[at] = before_mm[at] + length * step[n_ + further_of_[t]];
    }
    place_rods();
    Unbalanced next = unbalanced(u_mm);
    const double slope_there = with_tools(next, u_mm).dot(step);
    const bool sound = next.inverted_points <= now_.inverted_points;
    constexpr int most_attempts = 8;
    if ((sound && slope_there > -std::abs(slope)) || attempt == most_attempts) {
      moved_mm_ = (u_mm - state_.u_mm).cwiseAbs().maxCoeff();
      state_.u_mm = std::move(u_mm);
      now_ = std::move(next);
      return;
    }
    const double secant = slope > 0 && slope_there < 0 ? slope / (slope - slope_there) : 0.5;
    length *= sound ? std::clamp(2 * secant, 0.1, 0.6) : 0.5;
  }
}

void LiveStep::move_multipliers_on() {
  for (ContactConstraint& place : places_) {
    place.multiplier_mN = normal_force_mN(place, parts_.k_mN_mm, gap_of(place, state_.u_mm));
  }
}

double LiveStep::deepest_mm() const {
  double deepest = 0;
  for (const ContactConstraint& place : places_) deepest = std::max(deepest, -gap_of(place, state_.u_mm).mm);
  return deepest;
}

LiveState LiveStep::finished(const Stopwatch& watch) {
  for (std::size_t t = 0; t < tools_.size(); ++t) {
    const double advance_mm = advance_mm_[static_cast<Eigen::Index>(t)];
    if (further_of_[t] >= 0) state_.advance_mm[tools_[t].id] = advance_mm;
    ToolContact contact{tools_[t].id, Vector3d::Zero(), 0, advance_mm, 0};
    state_.tools.push_back(std::move(contact));
  }
  // What multipliers were moved on by is not yet pressed with.
  for (const ContactConstraint& place : places_) {
    const Gap gap = gap_of(place, state_.u_mm);
    const double force = state_.settled ? normal_force_mN(place, parts_.k_mN_mm, gap) : place.multiplier_mN;
    ToolContact& contact = state_.tools[place.place.tool];
    contact.penetration_mm = std::max(contact.penetration_mm, -gap.mm);
    if (force > 0) ++contact.contacts;
    contact.force_mN += force * gap.normal;
    state_.moment_uJ += place_of(place, state_.u_mm).cross(force * gap.normal);
    state_.places.push_back(
        {tools_[place.place.tool].id, place.place.rod, place.place.points, place.place.weights, place.multiplier_mN});
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
  if (!squared_.empty()) report.largest_strain = parts_.cells.largest_strain(parts_.body, state_.u_mm, squared_);
  state_.resisting_mN = std::move(now_.resisting_mN);
  parts_.show(state_);
  report.solve_ms = 1e3 * watch.seconds();
  return std::move(state_);
}

}  // namespace glisson::mechanics

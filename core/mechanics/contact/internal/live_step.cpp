#include "mechanics/contact/internal/live_step.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

// The bound: so many times the weighted residual and the deepest penetration, which multipliers that lag leave, and a
// fifth of a millimetre, by which a smooth tool slips while it comes to rest. Found on the tuning paths of
// docs/decisions/first-pictures.md and not changed after.
constexpr double of_residual = 2.5, of_penetration = 1.5, beside_mm = 0.2;
// So many times the residual's part where a cut has opened: what hangs by little answers more softly at large strain
// than the answers at small strain say, by which it is weighted.
constexpr double where_cut = 3;
// Beyond those that were asked for, where cells are inside out on the way.
constexpr int rounds_to_turn_back = 8;

// Along its longest side.
double size_mm(const ToolShape& shape) {
  Eigen::AlignedBox3d box;
  for (const Rod& rod : shape) {
    const Vector3d around = Vector3d::Constant(rod.radius_mm);
    for (const Vector3d& end : {rod.from_mm, rod.to_mm}) box.extend(end - around).extend(end + around);
  }
  return box.sizes().maxCoeff();
}

}  // namespace

Result<LiveState> LiveStep::run(const LiveState& from, Until until) {
  const Stopwatch watch;
  until_ = until;
  if (auto taken = take_tools(from, until); !taken) return failure(std::move(taken.error()));
  const bool settling = until == Until::settled;
  const int most_rounds = settling ? options_.settling_rounds : options_.most_rounds;
  if (auto taken = take_cut(from); !taken) return failure(std::move(taken.error()));
  const bool known = from.resisting_mN.size() == n_ && from.advances == state_.advances;
  now_ = known ? under_loads(from.resisting_mN, from.report.inverted_cells) : unbalanced(state_.u_mm);
  for (int round = 0;; ++round) {
    if (auto found = find_places(); !found) return failure(std::move(found.error()));
    limit_friction();
    face_walls();
    const VectorXd r_mN = with_tools(now_, state_.u_mm);
    look_at_rows(state_.u_mm);
    const SplineLevels::WithRows levels(parts_.levels, rows_, further_, alone(now_),
                                        cut_ == nullptr ? nullptr : &cut_->level);
    // Nobody is told how good the picture was that a step begins with.
    const double left_mm = settling || round > 0 ? estimate(levels) : 0.0;
    state_.report.relative_residual = r_mN.norm() / (dead_mN_.norm() + tools_mN_ + parts_.k_mN_mm * hair_mm);
    const double deepest = deepest_mm();
    const double safety = (cut_ == nullptr ? 1 : where_cut) * of_residual;
    state_.error_bound_mm = safety * left_mm + of_penetration * deepest + beside_mm;
    const bool at_rest =
        left_mm <= options_.settled_mm && state_.report.relative_residual <= options_.relative_residual;
    const bool turned = now_.inverted_points > 0;
    if (settling && at_rest && !turned) {
      if (deepest <= options_.penetration_tolerance_mm && (round == 0 || moved_mm_ <= options_.movement_tolerance_mm)) {
        state_.settled = true;
        state_.error_bound_mm = safety * left_mm + of_penetration * deepest;
        break;
      }
      press_harder();
      look_at_rows(state_.u_mm);  // as many as before: friction's limits stay those of the round
    }
    const bool shown = !settling && round > 0 && state_.error_bound_mm <= options_.shown_mm;
    if (!turned && (round >= most_rounds || shown)) break;
    if (round == most_rounds + rounds_to_turn_back) return failure(turned_inside_out());
    const VectorXd again_mN = settling && at_rest && !turned ? with_tools(now_, state_.u_mm) : r_mN;
    VectorXd step = direction(levels, again_mN, Presses::then);
    if (again_mN.dot(step) <= 0) step = direction(levels, again_mN, Presses::now);
    go(step, again_mN);
    if (progress_.cancelled()) return cancelled();
  }
  if (swallows_a_tool()) return failure(swallowed());
  if (!settling) move_multipliers_on();
  return finished(watch);
}

Error LiveStep::turned_inside_out() const {
  return Error{"not-converged",
               GLISSON_TEXT("The step would turn cells inside out ({0}): a tool goes too far into the body."),
               {std::to_string(now_.inverted_points)},
               {},
               {}};
}

// Half of a rod's radius deep: pictures are a tenth of that deep, and a tool that has come through the
// surface in one step finds no way back.
bool LiveStep::swallows_a_tool() const {
  return std::any_of(places_.begin(), places_.end(), [&](const ContactConstraint& place) {
    return -gap_of(place, state_.u_mm).mm > 0.5 * place.rod.radius_mm;
  });
}

Error LiveStep::swallowed() const {
  return Error{"not-converged",
               GLISSON_TEXT("A tool would lie {0} mm deep in the body."),
               {fmt::format("{:.1f}", deepest_mm())},
               GLISSON_TEXT("Move it there in smaller steps, or away from the body."),
               {}};
}

Error LiveStep::slides_past(std::size_t tool) const {
  const double push_mN = *std::get<TouchingTool>(tools_[tool].what).push_mN;
  return Error{"not-converged",
               GLISSON_TEXT("The tool {0} slides past the body, which gives way under {1} N."),
               {tools_[tool].id, fmt::format("{:.2f}", push_mN / 1e3)},
               GLISSON_TEXT("Push with less, or where the body holds against it."),
               {}};
}

Unbalanced LiveStep::unbalanced(const VectorXd& u_mm) {
  if (cut_ == nullptr) {
    VectorXd resisting_mN = VectorXd::Zero(n_);
    const int inverted_points = add_whole_cells(u_mm, resisting_mN);
    return under_loads(std::move(resisting_mN), inverted_points);
  }
  const Eigen::Index nodes = parts_.unknowns();
  VectorXd on_nodes_mN = VectorXd::Zero(nodes), resisting_mN(n_);
  int inverted_points = add_whole_cells(u_mm.head(nodes), on_nodes_mN);
  resisting_mN << on_nodes_mN, VectorXd::Zero(n_ - nodes);
  inverted_points += cut_->open.add_force(u_mm, resisting_mN);
  return under_loads(std::move(resisting_mN), inverted_points);
}

// And what is around the body; how many points are inside out.
int LiveStep::add_whole_cells(const VectorXd& nodes_mm, VectorXd& force_mN) {
  for (const auto& term : parts_.around) term->add_force(nodes_mm, force_mN);
  return cells().add_force(nodes_mm, force_mN, squared_).inverted_points;
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

// How far the judged places are from rest, by what they answered to unit forces.
double LiveStep::estimate(const SplineLevels::WithRows& levels) const {
  if (adjoints_->cols() == 0) return 0;
  VectorXd pressing_mN(static_cast<Eigen::Index>(rows_.size())), rest_mN;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const double force = -rows_[i].stiffness * rows_[i].gap_mm;
    pressing_mN[static_cast<Eigen::Index>(i)] = rows_[i].two_sided ? force : std::max(0.0, force);
  }
  levels.rest_of(pressing_mN, rest_mN);
  const Eigen::VectorXf left_mm = adjoints_->transpose() * rest_mN.head(n_).cast<float>();
  double farthest_mm = 0;
  for (Eigen::Index l = 0; l < left_mm.size(); l += 3) {
    farthest_mm = std::max(farthest_mm, double{left_mm.segment<3>(l).norm()});
  }
  return farthest_mm;
}

void LiveStep::add_rows_times(const std::vector<std::uint8_t>& presses, const VectorXd& p, VectorXd& product) const {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (presses[i] == 0) continue;
    const StiffRow& row = rows_[i];
    double seen = row.further >= 0 ? -row.along * p[n_ + row.further] : 0.0;
    for (const auto& [node, direction] : row.on) seen += direction.dot(p.segment<3>(3 * node));
    seen *= row.stiffness;
    for (const auto& [node, direction] : row.on) product.segment<3>(3 * node) += seen * direction;
    if (row.further >= 0) product[n_ + row.further] -= seen * row.along;
  }
  for (const Bend& bend : bends_) {
    Vector3d moved = Vector3d::Zero();
    for (int c = 0; c < 6; ++c) moved += bend.place->weights[c] * p.segment<3>(3 * bend.place->nodes[c]);
    if (bend.further >= 0) moved -= p[n_ + bend.further] * bend.forward;
    const Vector3d answer = bend.stiffness * moved;
    for (int c = 0; c < 6; ++c) product.segment<3>(3 * bend.place->nodes[c]) += bend.place->weights[c] * answer;
    if (bend.further >= 0) product[n_ + bend.further] -= bend.forward.dot(answer);
  }
}

// Conjugate gradients on the tangent. Where a tool would slide off, that is left out, and they begin again. With the
// rows that the levels expect to press the step may climb; with those that press now it never does.
VectorXd LiveStep::direction(const SplineLevels::WithRows& levels, const VectorXd& r_mN, Presses when) {
  const bool settling = until_ == Until::settled;
  const int gradients = settling ? options_.settling_gradients : options_.gradients;
  // A row that presses from now on has a gap to close first, and one that lets go keeps no force.
  std::vector<std::uint8_t> presses(rows_.size());
  VectorXd begin = r_mN, pressing_mN = VectorXd::Zero(static_cast<Eigen::Index>(rows_.size()));
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const StiffRow& row = rows_[i];
    const bool now = row.two_sided || row.gap_mm < 0;
    presses[i] = when == Presses::then ? levels.presses(i) : now;
    if (presses[i] != 0) pressing_mN[static_cast<Eigen::Index>(i)] = -row.stiffness * row.gap_mm;
    if ((presses[i] != 0) == now) continue;
    const double force = (now ? 1 : -1) * row.stiffness * row.gap_mm;
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
    add_rows_times(presses, p, product);
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

// Of a step, so much that no pushed tool goes further than it is large: it would pass what it meets on its way. Where
// nothing near resists it there is no end to the step.
double LiveStep::longest_part(const VectorXd& step) const {
  double part = 1;
  for (std::size_t t = 0; t < tools_.size(); ++t) {
    if (further_of_[t] < 0) continue;
    const double way_mm = std::abs(step[n_ + further_of_[t]]);
    part = std::min(part, size_mm(std::get<TouchingTool>(tools_[t].what).shape) / std::max(way_mm, 1e-12));
  }
  return part;
}

// That part of the step, or less of it where it would climb far beyond the lowest place on its way. A law whose energy
// is finite inside out leads through there, and back: at a cell's one point, near a place that presses, a step held
// short of it would be held short for ever. Where the energy is infinite, no step goes there.
void LiveStep::go(const VectorXd& step, const VectorXd& r_mN) {
  const VectorXd before_mm = advance_mm_;
  const double slope = r_mN.dot(step);
  double length = longest_part(step);
  for (int attempt = 0;; ++attempt) {
    VectorXd u_mm = state_.u_mm + length * step.head(n_);
    for (std::size_t t = 0; t < tools_.size(); ++t) {
      const auto at = static_cast<Eigen::Index>(t);
      if (further_of_[t] >= 0) advance_mm_[at] = before_mm[at] + length * step[n_ + further_of_[t]];
    }
    place_rods();
    Unbalanced next = unbalanced(u_mm);
    const double slope_there = with_tools(next, u_mm).dot(step);
    const bool sound = parts_.finite_inside_out || next.inverted_points <= now_.inverted_points;
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

}  // namespace glisson::mechanics

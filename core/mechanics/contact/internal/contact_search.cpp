#include "mechanics/contact/internal/contact_search.h"

#include <algorithm>
#include <cmath>

#include "base/stopwatch.h"

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

double largest_change(const VectorXd& a, const VectorXd& b);
std::vector<Vector3d> as_points(const VectorXd& values);

// Adds a share of forces to others.
void add(const PointForces& forces, double share, PointForces& sum) {
  for (const auto& [point, force] : forces) sum.try_emplace(point, Vector3d::Zero()).first->second += share * force;
}

}  // namespace

ContactSearch::ContactSearch(const SurfaceResponses& responses, CutSelfContact walls,
                             const std::vector<ContactTool>& tools, const ContactOptions& options)
    : responses_(responses),
      walls_(std::move(walls)),
      tools_(tools),
      options_(options),
      advance_mm_(VectorXd::Zero(static_cast<Eigen::Index>(tools.size()))) {}

Result<void> ContactSearch::begin_from_rest() {
  from_rest_ = true;
  return hold({});
}

Result<void> ContactSearch::begin_from(const ContactState& before) { return hold(before); }

// Takes the tools in hand, with the forces and advances of the state before for those that were there.
Result<void> ContactSearch::hold(const ContactState& before) {
  if (auto checked = check_no_patch(tools_); !checked) return checked;
  force_mN_ = before.force_mN;
  wall_mN_ = before.wall_mN;
  std::vector<int> asked;
  for (const auto& [point, force] : force_mN_) asked.push_back(point);
  for (std::size_t t = 0; t < tools_.size(); ++t) {
    if (const auto* grasp = std::get_if<Grasp>(&tools_[t].what)) {
      auto gripped = grip(responses_.surface(), t, *grasp);
      if (!gripped) return failure(std::move(gripped.error()));
      asked.insert(asked.end(), gripped->points.begin(), gripped->points.end());
      grips_.push_back(std::move(*gripped));
      continue;
    }
    const auto& touching = std::get<TouchingTool>(tools_[t].what);
    if (auto checked = check_tool(touching.shape, touching.pose); !checked) return failure(std::move(checked.error()));
  }
  const auto solves = responses_.remember(asked);
  if (!solves) return failure(solves.error());
  report_.new_solves += *solves;
  auto surface_mm = responses_.surface_under(force_mN_, wall_mN_);
  if (!surface_mm) return failure(std::move(surface_mm.error()));
  surface_mm_ = std::move(*surface_mm);
  for (std::size_t t = 0; t < tools_.size(); ++t) {
    const TouchingTool* tool = pushed(tools_[t]);
    if (tool == nullptr) continue;
    const auto known = std::find_if(before.tools.begin(), before.tools.end(),
                                    [&](const ToolContact& contact) { return contact.id == tools_[t].id; });
    if (known != before.tools.end() && known->contacts > 0) {
      advance_mm_[static_cast<Eigen::Index>(t)] = known->advance_mm;
      continue;
    }
    const auto way_mm = way_to_surface(responses_.surface(), *tool, surface_mm_);
    if (!way_mm) return failure(way_mm.error());
    advance_mm_[static_cast<Eigen::Index>(t)] = *way_mm;
  }
  for (const TouchedPlace& touched : before.touched) {
    for (std::size_t t = 0; t < tools_.size(); ++t) {
      const auto* tool = std::get_if<TouchingTool>(&tools_[t].what);
      if (tools_[t].id == touched.tool && tool != nullptr && touched.rod < tool->shape.size()) {
        keep({t, touched.rod, touched.points, touched.weights}, responses_.surface(), kept_);
      }
    }
  }
  return {};
}

Result<ContactState> ContactSearch::run() {
  const Stopwatch watch;
  for (; report_.rounds < options_.max_rounds; ++report_.rounds) {
    const auto done = round();
    if (!done) return failure(done.error());
    if (!*done) continue;
    report_.rounds += report_.converged;
    break;
  }
  auto reached = state();
  if (!reached) return failure(std::move(reached.error()));
  reached->report.solve_ms = 1e3 * watch.seconds();
  return reached;
}

Result<bool> ContactSearch::round() {
  const auto found = find_places();
  if (!found) return failure(found.error());
  if (!*found) return false;
  if (auto columns = set_up_columns(); !columns) return failure(std::move(columns.error()));
  forces_ = solve_contact(problem_of(responses_, tools_, columns_));
  if (!forces_.force.allFinite() || !forces_.advance.allFinite()) return true;

  PointForces next_mN = columns_.given_mN;
  WallForces next_wall_mN;
  for (std::size_t c = 0; c < columns_.all.size(); ++c) {
    const double force = forces_.force[static_cast<Eigen::Index>(c)];
    if (force == 0) continue;
    if (columns_.all[c].wall >= 0) next_wall_mN[columns_.all[c].wall] = force;
    for (const auto& [point, unit] : columns_.all[c].on) {
      next_mN.try_emplace(point, Vector3d::Zero()).first->second += force * unit;
    }
  }
  VectorXd next_advance_mm = VectorXd::Zero(advance_mm_.size());
  Eigen::Index drive = 0;
  for (std::size_t t = 0; t < tools_.size(); ++t) {
    if (pushed(tools_[t]) != nullptr) next_advance_mm[static_cast<Eigen::Index>(t)] = forces_.advance[drive++];
  }
  auto next_surface_mm = responses_.surface_under(next_mN, next_wall_mN);
  if (!next_surface_mm) return failure(std::move(next_surface_mm.error()));

  report_.movement_mm = std::max(largest_change(*next_surface_mm, surface_mm_),
                                 tools_.empty() ? 0.0 : (next_advance_mm - advance_mm_).cwiseAbs().maxCoeff());
  VectorXd way_mm = *next_surface_mm - surface_mm_;
  if (last_way_mm_.size() > 0) {
    const double along = way_mm.dot(last_way_mm_) / std::max(way_mm.norm() * last_way_mm_.norm(), 1e-300);
    share_ = std::clamp(along < -0.2 ? 0.5 * share_ : along > 0.2 ? 1.5 * share_ : share_, 0.05, 1.0);
  }
  const bool at_rest = report_.movement_mm <= options_.movement_tolerance_mm;
  double part = 1.0;
  if (!from_rest_) {
    last_way_mm_ = std::move(way_mm);
    if (!at_rest) part = std::min(share_, options_.largest_move_mm / std::max(report_.movement_mm, 1e-12));
  }
  from_rest_ = false;
  // Forces, displacements and advances are linear in each other: a part of the way is in equilibrium too.
  if (part < 1.0) {
    for (auto& [point, force] : force_mN_) force *= 1.0 - part;
    add(next_mN, part, force_mN_);
    for (auto& [wall, force] : wall_mN_) force *= 1.0 - part;
    for (const auto& [wall, force] : next_wall_mN) wall_mN_[wall] += part * force;
    surface_mm_ += part * (*next_surface_mm - surface_mm_);
  } else {
    force_mN_ = std::move(next_mN);
    wall_mN_ = std::move(next_wall_mN);
    surface_mm_ = std::move(*next_surface_mm);
  }
  advance_mm_ += part * (next_advance_mm - advance_mm_);
  if (!at_rest) return false;
  report_.overlap_mm = std::max(walls_.find(surface_mm_, CutSelfContact::Search::more), live_overlap_mm());
  report_.penetration_mm = std::max(report_.overlap_mm, deepest_mm());
  report_.converged = forces_.converged && report_.penetration_mm <= options_.penetration_tolerance_mm;
  return report_.converged;
}

// A jump across a wall is the sum of its points' with weights that are not negative: where none goes inwards, the walls
// do not pass through each other anywhere.
double ContactSearch::live_overlap_mm() const {
  double deepest_mm = 0;
  const VectorXd jumps_mm = responses_.jumps_under(force_mN_, wall_mN_);
  for (Eigen::Index i = 0; i < jumps_mm.size() / 3; ++i) {
    if (!responses_.opening()->is_cut(static_cast<std::size_t>(i))) continue;
    deepest_mm = std::max(
        deepest_mm, -responses_.opening()->normals()[static_cast<std::size_t>(i)].dot(jumps_mm.segment<3>(3 * i)));
  }
  return deepest_mm;
}

double ContactSearch::deepest_mm() {
  double deepest_mm = 0;
  for (const ContactCandidate& place :
       contact_candidates(responses_.surface(), tools_, advance_mm_, surface_mm_, 0.0)) {
    deepest_mm = std::max(deepest_mm, -place.gap_mm);
  }
  return deepest_mm;
}

Result<bool> ContactSearch::find_places() {
  constexpr double margin_mm = 1.0;  // what is farther is found when it comes nearer: no round moves through a tool
  constexpr int rounds_that_wander = 6;
  walls_.find(from_rest_ ? VectorXd::Zero(surface_mm_.size()) : surface_mm_,
              report_.rounds == 0                   ? CutSelfContact::Search::anew
              : report_.rounds < rounds_that_wander ? CutSelfContact::Search::again
                                                    : CutSelfContact::Search::more);
  for (const ContactCandidate& near :
       contact_candidates(responses_.surface(), tools_, advance_mm_, surface_mm_, margin_mm)) {
    keep({near.tool, near.rod, near.points, near.weights}, responses_.surface(), kept_);
  }
  places_ = tracked_candidates(responses_.surface(), kept_, tools_, advance_mm_, surface_mm_, options_.largest_move_mm);
  bool all_there = true;
  for (std::size_t t = 0; t < tools_.size(); ++t) {
    const TouchingTool* tool = pushed(tools_[t]);
    if (tool == nullptr ||
        std::any_of(places_.begin(), places_.end(), [&](const ContactCandidate& p) { return p.tool == t; })) {
      continue;
    }
    const auto way_mm = way_to_surface(responses_.surface(), *tool, surface_mm_);
    if (!way_mm) return failure(way_mm.error());
    advance_mm_[static_cast<Eigen::Index>(t)] = *way_mm;
    all_there = false;
  }
  return all_there;
}

Result<void> ContactSearch::set_up_columns() {
  std::vector<int> asked;
  for (const ContactCandidate& place : places_) asked.insert(asked.end(), place.points.begin(), place.points.end());
  const auto solves = responses_.remember(asked);
  if (!solves) return failure(solves.error());
  report_.new_solves += *solves;
  meet_live_walls();
  auto columns = columns_of(
      responses_, {tools_, places_, grips_, walls_.cut_contacts(), live_walls_met_, advance_mm_, surface_mm_});
  if (!columns) return failure(std::move(columns.error()));
  columns_ = std::move(*columns);
  return {};
}

// Those that are near each other now. One that another round brings near joins then.
void ContactSearch::meet_live_walls() {
  constexpr double near_mm = 1.0;
  const VectorXd jumps_mm = responses_.jumps_under(force_mN_, wall_mN_);
  for (Eigen::Index wall = 0; wall < jumps_mm.size() / 3; ++wall) {
    const auto number = static_cast<std::size_t>(wall);
    if (!responses_.opening()->is_cut(number)) continue;
    if (responses_.opening()->normals()[number].dot(jumps_mm.segment<3>(3 * wall)) <= near_mm) {
      live_walls_met_.insert(static_cast<int>(wall));
    }
  }
}

Result<StrainRange> show(const SurfaceResponses& responses, ContactState& state) {
  const auto seen = responses.all_under(state.force_mN, state.wall_mN);
  if (!seen) return failure(seen.error());
  state.jumps_mm = as_points(seen->jumps_mm);
  state.surface_mm = responses.surface_mm(*seen);
  state.watched_mm = responses.watched_mm(*seen);
  return responses.strain_range(responses.mesh_points_mm(*seen), seen->jumps_mm);
}

Result<ContactState> ContactSearch::state() const {
  ContactState state;
  state.force_mN = force_mN_;
  state.wall_mN = wall_mN_;
  std::erase_if(state.force_mN, [](const auto& item) { return item.second.norm() == 0; });
  std::erase_if(state.wall_mN, [](const auto& item) { return item.second == 0; });
  state.report = report_;
  if (options_.on_the_way) {
    state.surface_mm = as_points(surface_mm_);
  } else {
    const auto strains = show(responses_, state);
    if (!strains) return failure(strains.error());
    state.report.largest_strain = strains->largest_strain;
    state.report.inverted_cells = strains->inverted_cells;
  }
  for (std::size_t t = 0; t < tools_.size(); ++t) {
    state.tools.push_back({tools_[t].id, Vector3d::Zero(), 0, advance_mm_[static_cast<Eigen::Index>(t)], 0});
  }
  const bool solved = forces_.force.size() > 0;  // not where all rounds went by looking for the surface
  for (std::size_t c = 0; c < places_.size() && solved; ++c) {
    const double force = forces_.force[static_cast<Eigen::Index>(c)];
    if (!(force > 0)) continue;
    ToolContact& contact = state.tools[places_[c].tool];
    contact.force_mN += force * places_[c].normal;
    ++contact.contacts;
    state.touched.push_back({contact.id, places_[c].rod, places_[c].points, places_[c].weights});
  }
  for (const ContactCandidate& place :
       contact_candidates(responses_.surface(), tools_, advance_mm_, surface_mm_, 0.0)) {
    state.tools[place.tool].penetration_mm = std::max(state.tools[place.tool].penetration_mm, -place.gap_mm);
  }
  Eigen::Index two_sided = forces_.force.size() - columns_.two_sided;
  for (const Gripped& gripped : grips_) {
    ToolContact& contact = state.tools[gripped.tool];
    const auto& grasp = std::get<Grasp>(tools_[gripped.tool].what);
    contact.contacts = static_cast<int>(gripped.points.size());
    if (const double* pull_mN = std::get_if<double>(&grasp.drawn)) {
      contact.force_mN = *pull_mN * unit_or_zero(grasp.direction);
    } else if (solved) {
      contact.force_mN = forces_.force.segment<3>(two_sided);
      two_sided += 3;
    }
  }
  state.report.relative_residual = responses_.relative_residual();
  const VectorXd standing_mm = responses_.standing_surface_mm();
  for (const auto& [point, force] : state.force_mN) {
    state.report.energy_uJ += 0.5 * force.dot(state.surface_mm[point] - standing_mm.segment<3>(3 * point));
  }
  return state;
}

namespace {

std::vector<Vector3d> as_points(const VectorXd& values) {
  std::vector<Vector3d> points;
  for (Eigen::Index i = 0; i < values.size(); i += 3) points.emplace_back(values.segment<3>(i));
  return points;
}

double largest_change(const VectorXd& a, const VectorXd& b) {
  double squared = 0;
  for (Eigen::Index i = 0; i < a.size(); i += 3) {
    squared = std::max(squared, (a.segment<3>(i) - b.segment<3>(i)).squaredNorm());
  }
  return std::sqrt(squared);
}

}  // namespace
}  // namespace glisson::mechanics

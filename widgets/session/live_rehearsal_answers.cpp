// Where the answers of a live rehearsal come from: for a patch, solves off the UI thread that are remembered; for rigid
// tools, the states of their session.

#include "widgets/session/live_rehearsal.h"
#include "widgets/work/give_back_memory.h"
#include "widgets/work/run_in_background.h"

#include <algorithm>
#include <cmath>

namespace glisson::widgets {
namespace {

constexpr std::size_t maximum_remembered = 16;  // places, some megabytes each

// Of the patient alone, where there is a reference body to come.
bool is_a_first_answer(const rehearsal::PlacedTool& placed, const rehearsal::StaticRehearsal& body) {
  return body.has_reference() && !placed.compared();
}

Solving how_it_stands(const rehearsal::SessionState& state, rehearsal::SessionPhase phase) {
  using rehearsal::SessionPhase;
  if (phase == SessionPhase::stepping || phase == SessionPhase::comparing) return Solving::solving;
  if (state.motion && state.motion->moves) return Solving::settling;
  if (state.settled) return Solving::solved;
  return phase == SessionPhase::settling ? Solving::settling : Solving::unsettled;
}

}  // namespace

// Of a place that is known at once, else after a solve for it.
void LiveRehearsal::answer_now() {
  const PlacedTool& tool = tools_.back();
  if (const rehearsal::PlacedTool* placed = remembered(tool)) {
    to_place_.reset();
    ease(*placed);
    show_answer(*placed, tool);
    if (!is_a_first_answer(*placed, *body_)) record(nullptr);
    return;
  }
  to_place_ = tool;
  set_solving(Solving::solving);
  Q_EMIT state_changed();  // the tool is there already, the shape follows
  if (!is_placing_) solve_for(tool);
}

void LiveRehearsal::ease(const rehearsal::PlacedTool& placed) {
  constexpr double step_N = 0.1;
  if (!eases_) return;
  eases_ = false;
  PlacedTool& tool = tools_.back();
  const double within_N = placed.force_within_the_model_N(tool.direction, tool.force_N);
  if (within_N >= tool.force_N) return;
  tool.force_N = step_N * std::max(1.0, std::floor(within_N / step_N));
  force_N_ = tool.force_N;
}

std::optional<double> LiveRehearsal::force_within_the_model_N(double maximum_N) const {
  if (in_session() || !has_tool()) return {};
  const rehearsal::PlacedTool* placed = remembered(tools().back());
  if (placed == nullptr) return {};
  PlacedTool asked = tools().back();
  asked.force_N = 0;
  if (!within_ || within_->tool != asked || within_->maximum_N != maximum_N || within_->body_count != body_count_) {
    within_ = {asked, maximum_N, body_count_, placed->force_within_the_model_N(asked.direction, maximum_N)};
  }
  return within_->force_N;
}

const rehearsal::PlacedTool* LiveRehearsal::remembered(const PlacedTool& tool) const {
  const auto found = std::find_if(placed_.begin(), placed_.end(), [&](const rehearsal::PlacedTool& placed) {
    return placed.center_mm() == tool.center_mm && placed.radius_mm() == tool.radius_mm;
  });
  return found == placed_.end() ? nullptr : &*found;
}

void LiveRehearsal::solve_for(const PlacedTool& tool) {
  is_placing_ = true;
  using Outcome = Result<rehearsal::PlacedTool>;
  const auto take = [this, tool, body_count = body_count_](const Outcome& outcome) {
    is_placing_ = false;
    if (body_count == body_count_ && outcome) {
      placed_.push_back(*outcome);
      if (placed_.size() > maximum_remembered) placed_.pop_front();
      if (is_a_first_answer(*outcome, *body_)) make_reference();
    }
    if (!to_place_) return;
    const PlacedTool wanted = *to_place_;
    if (remembered(wanted) != nullptr) {
      to_place_.reset();
      if (!shown_moment_) ease(placed_.back());
      show_answer(placed_.back(), shown_moment_ ? wanted : tools_.back());
      if (is_a_first_answer(placed_.back(), *body_)) return;
      if (!shown_moment_) record(nullptr);
      Q_EMIT placed(placed_.back().solve_ms());
    } else if (body_count == body_count_ && wanted.center_mm == tool.center_mm && wanted.radius_mm == tool.radius_mm) {
      to_place_.reset();
      refuse(outcome.error());
    } else {
      // On the way there: better an answer to where it was a moment ago than none.
      if (body_count == body_count_ && outcome && !shown_moment_) show_answer(placed_.back(), wanted);
      set_solving(Solving::solving);
      solve_for(wanted);
    }
  };
  using On = rehearsal::StaticRehearsal::On;
  const On bodies = body_->reference_is_made() ? On::both : On::patient;
  run_in_background(
      this, [body = body_, tool, bodies] { return body->place_tool(tool.center_mm, tool.radius_mm, bodies); }, take);
}

// Behind what is shown; what was answered before it was there is then answered again.
void LiveRehearsal::make_reference() {
  if (is_making_reference_) return;
  is_making_reference_ = true;
  const auto take = [this, body_count = body_count_](const Result<void>& made) {
    is_making_reference_ = false;
    give_back_memory();
    const auto is_first = [this](const rehearsal::PlacedTool& placed) { return is_a_first_answer(placed, *body_); };
    if (!std::any_of(placed_.begin(), placed_.end(), is_first)) return;
    if (body_count != body_count_) return make_reference();  // another body came meanwhile
    std::erase_if(placed_, is_first);
    if (!made) return refuse(made.error());
    if (!has_tool()) return;
    to_place_ = tools().back();
    if (!is_placing_) solve_for(*to_place_);
  };
  run_in_background(
      this, [body = body_] { return body->make_reference(); }, take);
}

void LiveRehearsal::show_answer(const rehearsal::PlacedTool& placed, const PlacedTool& tool) {
  state_ = placed.answer(tool.pull_N());
  contact_.reset();
  refusal_.reset();
  set_solving(is_a_first_answer(placed, *body_) ? Solving::solving : Solving::solved);
  Q_EMIT state_changed();
}

void LiveRehearsal::look_for_contact() {
  if (auto error = session_->error()) {
    session_timer_.stop();
    refuse(*error);
    return;
  }
  // Asked before the state is taken: of a session that waits, that state is the answer to all that was posted.
  const rehearsal::SessionPhase phase = session_->phase();
  const auto state = session_->latest();
  if (!state) return;
  const std::pair number(state->number, state->on_the_way);
  const bool is_new = number != session_number_.value_or(std::pair<std::uint64_t, int>(0, 0));
  answered_ = phase != rehearsal::SessionPhase::stepping;
  if (!session_number_) Q_EMIT solving_changed();  // prepared
  session_number_ = number;
  if (is_new) {
    const int steps = state->cut ? static_cast<int>(state->cut->advances) : 0;
    if (!state->refused.empty() && cuts_since_tool_ > 0 && steps == cut_steps_) --cuts_since_tool_;
    cut_steps_ = steps;
  }
  const bool comes_back = state->motion && (state->motion->moves || !state->tools.empty());
  const bool holds_something = !tools_.empty() || state->cut || comes_back;
  if (is_new && holds_something && state->refused.empty() && state->on_the_way == 0) record(state);
  if (shown_moment_) return;
  if (!holds_something) {
    if (!state_) return;
    state_.reset();  // the cut was taken back or all has come back, and nothing holds the liver
    set_solving(Solving::no_tool);
    Q_EMIT state_changed();
    return;
  }
  const Solving now = how_it_stands(*state, phase);
  if (is_new) {
    show_contact(state, now);
  } else if (solving_ != Solving::refused && phase != rehearsal::SessionPhase::stepping && solving_ != now) {
    set_solving(now);
  }
}

std::optional<double> LiveRehearsal::error_bound_mm() const {
  const rehearsal::SessionState* shown = contact();
  return shown == nullptr || shown->patient.landmarks.empty() ? std::nullopt : shown->error_bound_mm;
}

void LiveRehearsal::show_contact(const std::shared_ptr<const rehearsal::SessionState>& state, Solving solving) {
  state_ = state_of(*state);
  contact_ = state;
  if (touch_ == Touch::rigid) solids_ = solids_of(*state);
  const bool stays_refused = state->settles > 0 && refusal_;  // it only comes nearer to rest
  if (!stays_refused) {
    refusal_.reset();
    // A cut that cannot go on says why by itself.
    if (state->refusal && state->refusal->code.starts_with("cut")) {
      refuse(*state->refusal);
      return;
    }
    if (!state->refused.empty() && state->settles == 0) {
      refuse(Error{"not-converged",
                   GLISSON_TEXT("The liver's shape with the tools there was not found: {0}"),
                   {state->refused},
                   GLISSON_TEXT("Press less, or move the tool by smaller steps."),
                   {}});
      return;
    }
    set_solving(solving);
  }
  Q_EMIT state_changed();
}

}  // namespace glisson::widgets

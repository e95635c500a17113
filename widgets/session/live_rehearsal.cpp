#include "widgets/session/live_rehearsal.h"

#include <algorithm>
#include <limits>
#include <QtConcurrentRun>
#include <QUuid>

namespace glisson::widgets {
namespace {

constexpr int look_every_ms = 15;

bool has_rigid_tools_alone(Deformations deformations) {
  return deformations == Deformations::meshfree || deformations == Deformations::moving;
}

std::string session_id(int number) { return "tool-" + std::to_string(number); }

// Near enough to be shown as it is; one that was settled to no end is not.
bool is_as_it_rests(const rehearsal::SessionState& state) {
  using rehearsal::SessionEngine;
  if (state.settled) return true;
  const bool gave_up = state.settles >= static_cast<std::uint64_t>(SessionEngine::most_settles);
  return !gave_up && !state.patient.landmarks.empty() && *state.error_bound_mm <= SessionEngine::shown_mm;
}

// A session waits for the step under way when it ends; the window does not.
void end_elsewhere(std::unique_ptr<rehearsal::LiveSession> session) {
  if (!session) return;
  auto shared = std::shared_ptr<rehearsal::LiveSession>(std::move(session));
  [[maybe_unused]] const auto ended = QtConcurrent::run([ending = std::move(shared)]() mutable { ending.reset(); });
}

}  // namespace

LiveRehearsal::LiveRehearsal(QObject* parent) : QObject(parent) {
  clock_.start();
  session_timer_.setInterval(look_every_ms);
  connect(&session_timer_, &QTimer::timeout, this, &LiveRehearsal::look_for_contact);
}

LiveRehearsal::~LiveRehearsal() { end_elsewhere(std::move(session_)); }

void LiveRehearsal::set_body(std::shared_ptr<const rehearsal::StaticRehearsal> body,
                             std::shared_ptr<const rehearsal::RehearsalSetup> setup) {
  body_ = std::move(body);
  setup_ = std::move(setup);
  placed_.clear();
  ++body_count_;
  touch_ = Touch::patch;
  deformations_ = Deformations::small;
  start_anew();
}

namespace {

// What was recorded, its landmarks in the order of those that there are now; one that was not there has no figure.
RehearsalTrack renamed_to(const std::vector<mechanics::Landmark>& now, const std::vector<mechanics::Landmark>& before,
                          const RehearsalTrack& track) {
  RehearsalTrack renamed;
  for (Moment moment : track.moments()) {
    std::vector<double> figures;
    for (const mechanics::Landmark& landmark : now) {
      const auto same =
          std::find_if(before.begin(), before.end(), [&](const auto& one) { return one.id == landmark.id; });
      const auto place = static_cast<std::size_t>(same - before.begin());
      figures.push_back(place < moment.landmarks_mm.size() ? moment.landmarks_mm[place]
                                                           : std::numeric_limits<double>::quiet_NaN());
    }
    moment.landmarks_mm = std::move(figures);
    const double time_s = moment.time_s;
    renamed.add(std::move(moment), time_s);
  }
  return renamed;
}

}  // namespace

void LiveRehearsal::exchange_body(std::shared_ptr<const rehearsal::StaticRehearsal> body,
                                  std::shared_ptr<const rehearsal::RehearsalSetup> setup) {
  const bool same_mesh = body && body_ && setup && setup_ && setup->mesh.points_mm == setup_->mesh.points_mm &&
                         setup->mesh.cells == setup_->mesh.cells;
  if (!same_mesh) return set_body(std::move(body), std::move(setup));
  const std::vector<PlacedTool> tools = tools_;
  const RehearsalTrack track = renamed_to(setup->landmarks, setup_->landmarks, track_);
  const Touch touch = touch_;
  const Deformations deformations = deformations_;
  set_body(std::move(body), std::move(setup));
  touch_ = touch;
  if (knows_other_deformations()) deformations_ = deformations;
  if (in_session()) start_anew();
  track_ = track;
  Q_EMIT track_changed();
  hold_all(tools);
}

void LiveRehearsal::set_touch(Touch touch) {
  if (touch == touch_ || (touch == Touch::rigid && !setup_)) return;
  touch_ = touch;
  if (touch == Touch::patch && has_rigid_tools_alone(deformations_)) deformations_ = Deformations::small;
  const std::optional<PlacedTool> current = tools_.empty() ? std::nullopt : std::optional(tools_.back());
  start_anew();
  if (current) hold(*current);
}

void LiveRehearsal::set_deformations(Deformations deformations) {
  if (deformations == deformations_ || (deformations != Deformations::small && !knows_other_deformations())) return;
  deformations_ = deformations;
  if (has_rigid_tools_alone(deformations)) touch_ = Touch::rigid;
  const std::vector<PlacedTool> tools = tools_;
  start_anew();
  hold_all(tools);
}

rehearsal::RehearsalSetup LiveRehearsal::session_setup() const {
  if (deformations_ == Deformations::meshfree) return rehearsal::by_meshfree(*setup_, {});
  if (deformations_ == Deformations::moving) return rehearsal::in_motion(*setup_, rehearsal::step_in_the_hand_s);
  const bool large = deformations_ == Deformations::large;
  return rehearsal::with_law(*setup_, large ? mechanics::MaterialLaw::neo_hookean : mechanics::MaterialLaw::linear);
}

void LiveRehearsal::start_anew() {
  tools_.clear();
  numbers_.clear();
  takes_another_ = false;
  frozen_ = false;
  to_place_.reset();
  state_.reset();
  eases_ = false;
  solids_.clear();
  session_timer_.stop();
  end_elsewhere(std::move(session_));
  session_.reset();
  session_number_.reset();
  contact_.reset();
  answered_ = false;
  cut_steps_ = cuts_since_tool_ = 0;
  strips_.clear();
  session_name_.clear();
  if (setup_ && in_session()) {
    session_name_ = QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString();
    session_ = std::make_unique<rehearsal::LiveSession>(session_setup());
    session_timer_.start();
  }
  clear_track();
  refusal_.reset();
  set_solving(Solving::no_tool);
  Q_EMIT state_changed();
}

void LiveRehearsal::hold(const PlacedTool& tool) {
  if (!body_ || frozen_) return;
  go_on();
  force_N_ = tool.force_N;
  direction_ = tool.direction;
  std::optional<PlacedTool> was;
  if (tools_.empty() || (takes_another_ && touch_ == Touch::rigid)) {
    tools_.push_back(tool);
    numbers_.push_back(next_number_++);
  } else {
    was = tools_.back();
    tools_.back() = tool;
  }
  takes_another_ = false;
  if (session_) {
    // A tool that jumps is another one: on its way it would go through the liver.
    constexpr double jump_mm = 20;
    if (was && touch_ == Touch::rigid &&
        (was->preset != tool.preset || (was->center_mm - tool.center_mm).norm() > jump_mm)) {
      post(rehearsal::ReleaseTool{session_id(numbers_.back())});
      numbers_.back() = next_number_++;
    }
    post_tool();
  } else {
    answer_now();
  }
}

void LiveRehearsal::hold_within_the_model(const PlacedTool& tool) {
  eases_ = !session_;
  hold(tool);
}

void LiveRehearsal::change_tool(const std::function<void(PlacedTool&)>& change) {
  if (tools_.empty() || frozen_) return;
  PlacedTool tool = tools_.back();
  change(tool);
  if (tool == tools_.back()) return;
  takes_another_ = false;
  hold(tool);
}

void LiveRehearsal::set_force_N(double force_N) {
  if (frozen_) return;
  eases_ = false;
  force_N_ = force_N;
  change_tool([&](PlacedTool& tool) { tool.force_N = force_N; });
}

void LiveRehearsal::set_direction(const Eigen::Vector3d& unit) {
  if (frozen_) return;
  direction_ = unit;
  change_tool([&](PlacedTool& tool) { tool.direction = unit; });
}

void LiveRehearsal::hold_all(const std::vector<PlacedTool>& wanted) {
  if (!body_ || frozen_) return;
  go_on();
  eases_ = false;
  const auto [differs, _] = std::mismatch(tools_.begin(), tools_.end(), wanted.begin(), wanted.end());
  const auto same = static_cast<std::size_t>(differs - tools_.begin());
  if (same == tools_.size() && same == wanted.size()) return;
  // The first that differs is moved; what came to hand after it is taken away and, if wanted, placed again.
  while (tools_.size() > std::min(same + 1, wanted.size())) take_tool_away();
  for (std::size_t k = same; k < wanted.size(); ++k) {
    takes_another_ = k == tools_.size() && k > 0;
    hold(wanted[k]);
  }
}

void LiveRehearsal::keep_tool() { takes_another_ = touch_ == Touch::rigid && !tools_.empty(); }

void LiveRehearsal::take_tool_away() {
  if (frozen_) return;
  go_on();
  to_place_.reset();
  takes_another_ = false;
  refusal_.reset();
  if (tools_.empty()) return;
  if (session_) post(rehearsal::ReleaseTool{session_id(numbers_.back())});
  cuts_since_tool_ = 0;
  tools_.pop_back();
  numbers_.pop_back();
  if (tools_.empty() && deformations_ == Deformations::moving) {
    set_solving(Solving::solving);  // what was let go comes back
  } else if (tools_.empty()) {
    state_.reset();
    set_solving(Solving::no_tool);
  } else {
    force_N_ = tools_.back().force_N;
    direction_ = tools_.back().direction;
  }
  Q_EMIT state_changed();
}

void LiveRehearsal::advance_cut(const mechanics::CutStrip& strip) {
  if (!session_ || frozen_) return;
  go_on();
  post(rehearsal::AdvanceCut{strip});
  strips_.push_back(strip);
  ++cuts_since_tool_;
  set_solving(Solving::solving);
}

void LiveRehearsal::take_cut_back() {
  if (!can_take_cut_back()) return;
  go_on();
  post(rehearsal::Undo{});
  if (!strips_.empty()) strips_.pop_back();
  --cuts_since_tool_;
  set_solving(Solving::solving);
}

// One that was refused is asked for again from the same place, so that those that are open come first.
std::vector<mechanics::CutStrip> LiveRehearsal::cut_along() const {
  const auto open = std::min(strips_.size(), static_cast<std::size_t>(cut_steps_));
  return {strips_.begin(), strips_.begin() + static_cast<std::ptrdiff_t>(open)};
}

void LiveRehearsal::cut_all(const std::vector<mechanics::CutStrip>& wanted) {
  if (!session_ || frozen_) return;
  const std::vector<mechanics::CutStrip> open = cut_along();
  if (wanted.size() < open.size()) {
    const auto fewer = static_cast<int>(open.size() - wanted.size());
    if (fewer > cuts_since_tool_) {
      const std::vector<PlacedTool> tools = tools_;
      start_anew();
      hold_all(tools);
      for (const mechanics::CutStrip& strip : wanted) advance_cut(strip);
      return;
    }
    go_on();
    for (int step = 0; step < fewer; ++step) post(rehearsal::Undo{});
    strips_ = wanted;
    cuts_since_tool_ -= fewer;
    set_solving(Solving::solving);
  }
  for (std::size_t step = open.size(); step < wanted.size(); ++step) advance_cut(wanted[step]);
}

rehearsal::Recording LiveRehearsal::recording() const {
  return session_ ? session_->recording() : rehearsal::Recording();
}

bool LiveRehearsal::can_take_cut_back() const {
  return session_ && !frozen_ && cuts_since_tool_ > 0 && solving_ != Solving::solving;
}

void LiveRehearsal::set_frozen(bool frozen) {
  if (frozen_ == frozen) return;
  frozen_ = frozen;
  Q_EMIT solving_changed();
}

const std::vector<PlacedTool>& LiveRehearsal::tools() const {
  return shown_moment_ ? track_.moments()[*shown_moment_].tools : tools_;
}

Eigen::Vector3d LiveRehearsal::tool_center_mm() const {
  return has_tool() ? tools().back().center_mm : Eigen::Vector3d::Zero();
}

void LiveRehearsal::post(rehearsal::SessionCommand command) {
  answered_ = false;
  session_->post(std::move(command));
}

void LiveRehearsal::post_tool() {
  auto hand = contact_tool(tools_.back(), session_id(numbers_.back()), touch_);
  if (!hand) {
    refuse(hand.error());
    return;
  }
  post(rehearsal::HoldTool{*std::move(hand)});
  cuts_since_tool_ = 0;
  set_solving(Solving::solving);
  Q_EMIT state_changed();
}

// What only came nearer to rest, or is compared now, takes the place of its first picture.
void LiveRehearsal::record(std::shared_ptr<const rehearsal::SessionState> contact) {
  Moment moment = moment_of(tools_, contact ? state_of(*contact) : *state_);
  const auto asked = [](const rehearsal::SessionState& state) { return state.number - state.settles; };
  const auto* last = track_.empty() ? nullptr : track_.moments().back().contact.get();
  const bool nearer_to_rest = contact && contact->settles > 0 && last != nullptr && asked(*last) == asked(*contact);
  const bool compared_now = contact && contact->reference && last != nullptr && !last->reference &&
                            track_.moments().back().tools == moment.tools &&
                            (last->cut ? last->cut->advances : 0) == (contact->cut ? contact->cut->advances : 0);
  if (nearer_to_rest || compared_now) {
    moment.tools = track_.moments().back().tools;
    moment.contact = std::move(contact);
    track_.replace_last(std::move(moment));
  } else {
    moment.contact = std::move(contact);
    const std::size_t before = track_.moments().size();
    track_.add(std::move(moment), 1e-3 * static_cast<double>(clock_.elapsed()));
    const bool oldest_went = track_.moments().size() == before;
    if (oldest_went && shown_moment_ && *shown_moment_ > 0) --*shown_moment_;
  }
  Q_EMIT track_changed();
}

void LiveRehearsal::clear_track() {
  shown_moment_.reset();
  track_.clear();
  Q_EMIT track_changed();
}

void LiveRehearsal::show_moment(std::size_t index) {
  if (index >= track_.moments().size()) return;
  shown_moment_ = index;
  const Moment& moment = track_.moments()[index];
  if (moment.contact) {
    refusal_.reset();
    show_contact(moment.contact, is_as_it_rests(*moment.contact) ? Solving::solved : Solving::unsettled);
  } else if (!moment.tools.empty()) {
    const PlacedTool& tool = moment.tools.back();
    if (const rehearsal::PlacedTool* placed = remembered(tool)) {
      to_place_.reset();
      show_answer(*placed, tool);
    } else {
      to_place_ = tool;
      set_solving(Solving::solving);
      if (!is_placing_) solve_for(tool);
    }
  }
}

void LiveRehearsal::go_on() {
  if (!shown_moment_) return;
  // The last moment is what there is now.
  if (!track_.empty()) show_moment(track_.moments().size() - 1);
  shown_moment_.reset();
  Q_EMIT state_changed();
}

void LiveRehearsal::set_solving(Solving solving) {
  solving_ = solving;
  Q_EMIT solving_changed();
}

void LiveRehearsal::refuse(const Error& error) {
  refusal_ = error;
  set_solving(Solving::refused);
  Q_EMIT state_changed();
  Q_EMIT failed(error);
}

}  // namespace glisson::widgets

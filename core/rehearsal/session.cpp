#include "rehearsal/session.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <future>
#include <mutex>

#include "base/files.h"
#include "rehearsal/internal/session_body.h"
#include "rehearsal/internal/tools_between.h"

namespace glisson::rehearsal {
namespace {

using Eigen::Vector3d;
using mechanics::ContactTool;
using Clock = std::chrono::steady_clock;

// All that a command starts from, and undo goes back to.
struct Moment {
  Tools tools;
  SessionBody patient_body;
  std::optional<SessionBody> reference_body;
  BodyState patient;
  std::optional<BodyState> reference;
  std::vector<mechanics::CutStrip> cuts = {};
};

std::string digest_of(const Moment& moment);

}  // namespace

struct SessionEngine::Impl {
  mechanics::ChosenLaw law = mechanics::MaterialLaw::linear;
  std::vector<mechanics::Landmark> landmarks;
  std::vector<mechanics::PointInMesh> landmark_places;
  std::vector<geometry::Surface> structures;
  std::vector<Moment> moments;  // the first untouched, the last the present
  std::uint64_t commands = 0, settles = 0;
  std::shared_ptr<const SessionState> latest;
  bool compares = false;  // every moment has its reference body

  // Made once, whoever asks first; the others wait.
  std::function<Result<SessionBody>(const Progress&)> reference_maker;  // none: there is no reference body
  mutable std::mutex making;
  mutable std::optional<SessionBody> reference;
  [[nodiscard]] Result<void> make_reference(const Progress& progress) const;
  // With the reference body where it is missing: cut as the patient is, then under the tools, which come to it afresh.
  [[nodiscard]] Result<Moment> compared(Moment moment) const;
  void compare_the_last();
  [[nodiscard]] std::string begin_to_compare();  // why not; empty where it does

  // What `next` makes of both bodies, the reference body beside the patient's on a thread of its own.
  using Next = std::function<Result<BodyState>(const SessionBody&, const BodyState&)>;
  [[nodiscard]] Result<Moment> both(const Moment& from, const Tools& tools, const Next& next) const;
  // The tools go from there to there, in small moves.
  [[nodiscard]] Next way_to(const Tools& from, const Tools& tools) const;
  [[nodiscard]] Result<Moment> moved(const Moment& from, const Tools& tools) const;
  [[nodiscard]] Result<Moment> nearer_to_rest(const Moment& from, const Progress& progress = {}) const;
  [[nodiscard]] Result<Moment> cut(const Moment& from, const mechanics::CutStrip& strip) const;
  void forget_the_oldest();
  [[nodiscard]] RehearsalBody shown(const SessionBody& body, const BodyState& state) const;
  [[nodiscard]] std::shared_ptr<const SessionCut> cut_of(const Moment& moment) const;
  [[nodiscard]] SessionState state_of(const Moment& moment) const;
};

Result<SessionEngine> SessionEngine::create(RehearsalSetup setup, const Progress& progress, WithReference reference) {
  auto parts = std::make_shared<Impl>();
  auto places = mechanics::locate_landmarks(setup.mesh, setup.landmarks, setup.landmark_tolerance_mm);
  if (!places) return failure(std::move(places.error()));
  std::vector<mechanics::PointInMesh> watched = *places;
  parts->landmark_places = std::move(*places);
  parts->landmarks = std::move(setup.landmarks);
  for (geometry::Surface& structure : setup.structures) {
    if (auto checked = geometry::check_surface(structure); !checked) return failure(std::move(checked.error()));
    const auto in_mesh = mechanics::locate_points(setup.mesh, structure.points_mm);
    watched.insert(watched.end(), in_mesh.begin(), in_mesh.end());
    parts->structures.push_back(std::move(structure));
  }
  const bool at_once = setup.reference_youngs_kPa && reference == WithReference::at_once;
  auto models = rehearsal_models(setup, progress.part(0.0, at_once ? 0.5 : 1.0));
  if (!models) return failure(std::move(models.error()));
  parts->law = setup.law;
  auto patient = SessionBody::create((*models)->patient, setup, watched, parts->landmarks.size());
  if (!patient) return failure(std::move(patient.error()));
  BodyState at_rest = patient->untouched();
  Moment untouched{{}, std::move(*patient), {}, std::move(at_rest), {}};
  if ((*models)->reference) {
    parts->reference_maker = [reference = *(*models)->reference, setup = std::move(setup), watched = std::move(watched),
                              judged = parts->landmarks.size()](const Progress& told) -> Result<SessionBody> {
      const auto model = reference.model(told);
      if (!model) return failure(model.error());
      return SessionBody::create(*model, setup, watched, judged);
    };
  }
  if (at_once) {
    if (auto made = parts->make_reference(progress.part(0.5, 1.0)); !made) return failure(std::move(made.error()));
    auto whole = parts->compared(std::move(untouched));
    if (!whole) return failure(std::move(whole.error()));
    untouched = std::move(*whole);
    parts->compares = true;
  }
  parts->moments.push_back(std::move(untouched));
  parts->latest = std::make_shared<SessionState>(parts->state_of(parts->moments.back()));
  return SessionEngine(std::move(parts));
}

const SessionState& SessionEngine::step(const SessionCommand& command, const Progress& progress) {
  const auto start = Clock::now();
  Impl& parts = *impl_;
  std::string refused;
  Tools tools = parts.moments.back().tools;
  const auto of_id = [&](const std::string& id) {
    return std::find_if(tools.begin(), tools.end(), [&](const ContactTool& tool) { return tool.id == id; });
  };
  if (const auto* hold = std::get_if<HoldTool>(&command)) {
    const auto held = of_id(hold->tool.id);
    if (held == tools.end()) {
      tools.push_back(hold->tool);
    } else {
      *held = hold->tool;
    }
  } else if (const auto* release = std::get_if<ReleaseTool>(&command)) {
    const auto held = of_id(release->id);
    if (held == tools.end()) {
      refused = "There is no tool " + release->id + " to let go.";
    } else {
      tools.erase(held);
    }
  } else if (std::holds_alternative<Undo>(command)) {
    if (parts.moments.size() > 1) {
      parts.moments.pop_back();
      if (parts.compares) parts.compare_the_last();
    } else {
      refused = "There is nothing to undo.";
    }
  }
  if (std::holds_alternative<Compare>(command)) {
    refused = parts.begin_to_compare();
  } else if (refused.empty() && !std::holds_alternative<Undo>(command)) {
    const bool settles = std::holds_alternative<Settle>(command);
    const auto* advance = std::get_if<AdvanceCut>(&command);
    const Moment& now = parts.moments.back();
    auto moment = settles              ? parts.nearer_to_rest(now, progress)
                  : advance != nullptr ? parts.cut(now, advance->strip)
                                       : parts.moved(now, tools);
    if (!moment && settles && progress.cancelled()) return *parts.latest;
    if (!moment) {
      refused = moment.error().message();
    } else if (settles) {
      parts.moments.back() = std::move(*moment);
    } else {
      parts.moments.push_back(std::move(*moment));
      parts.forget_the_oldest();
      if (parts.compares) parts.compare_the_last();
    }
  }
  ++parts.commands;
  parts.settles = std::holds_alternative<Settle>(command) ? parts.settles + 1 : 0;
  SessionState state = parts.state_of(parts.moments.back());
  state.number = parts.commands;
  state.settles = parts.settles;
  state.refused = std::move(refused);
  state.step_ms = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  parts.latest = std::make_shared<SessionState>(std::move(state));
  return *parts.latest;
}

SessionState SessionEngine::settled_state() const {
  const auto start = Clock::now();
  const Impl& parts = *impl_;
  Moment moment = parts.moments.back();
  std::string refused;
  SessionState state = parts.state_of(moment);
  for (int settle = 0; settle < most_settles && !state.settled && refused.empty(); ++settle) {
    auto next = parts.nearer_to_rest(moment);
    if (next) {
      moment = std::move(*next);
      state = parts.state_of(moment);
    } else {
      refused = next.error().message();
    }
  }
  state.number = parts.commands;
  state.refused = std::move(refused);
  state.step_ms = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  return state;
}

Result<void> SessionEngine::Impl::make_reference(const Progress& progress) const {
  const std::lock_guard lock(making);
  if (reference || !reference_maker) return {};
  auto made = reference_maker(progress);
  if (!made) return failure(std::move(made.error()));
  reference = std::move(*made);
  return {};
}

Result<Moment> SessionEngine::Impl::compared(Moment moment) const {
  if (moment.reference) return moment;
  SessionBody body = *reference;
  Result<BodyState> state = body.untouched();
  for (const mechanics::CutStrip& strip : moment.cuts) {
    auto opened = body.opened(strip);
    if (!opened) return failure(std::move(opened.error()));
    body = std::move(*opened);
  }
  if (!moment.tools.empty() || !moment.cuts.empty()) state = way_to({}, moment.tools)(body, *state);
  if (!state) return failure(std::move(state.error()));
  moment.reference = std::move(*state);
  moment.reference_body = std::move(body);
  return moment;
}

// Where the reference body finds no shape under the tools the patient is answered alone.
void SessionEngine::Impl::compare_the_last() {
  if (auto whole = compared(moments.back())) moments.back() = std::move(*whole);
}

std::string SessionEngine::Impl::begin_to_compare() {
  if (!reference_maker) return "There is no reference body to compare with.";
  if (auto made = make_reference({}); !made) return made.error().message();
  compares = true;
  compare_the_last();
  return {};
}

SessionEngine::Impl::Next SessionEngine::Impl::way_to(const Tools& from, const Tools& tools) const {
  // A force that grows at once carries the surface past the tool that it should meet, and at large strain farther than
  // one picture follows; a quarter of a newton moves a liver by some millimetres.
  constexpr double push_in_a_step_mN = 250.0;
  constexpr int maximum_steps = 200;
  const double steps_wanted =
      std::max(farthest_move_mm(from, tools) / mechanics::ContactOptions().largest_move_mm,
               (law.law == mechanics::MaterialLaw::linear ? largest_change_of_push_mN(from, tools)
                                                          : largest_change_of_force_mN(from, tools)) /
                   push_in_a_step_mN);
  const int steps = static_cast<int>(std::clamp(std::ceil(steps_wanted), 1.0, double{maximum_steps}));
  return [from, tools, steps](const SessionBody& body, const BodyState& before) -> Result<BodyState> {
    BodyState state = before;
    for (int step = 1; step <= steps; ++step) {
      auto next = body.moved(state, between(from, tools, double(step) / steps));
      if (!next) return next;
      state = std::move(*next);
    }
    return state;
  };
}

Result<Moment> SessionEngine::Impl::moved(const Moment& from, const Tools& tools) const {
  return both(from, tools, way_to(from.tools, tools));
}

Result<Moment> SessionEngine::Impl::nearer_to_rest(const Moment& from, const Progress& progress) const {
  return both(from, from.tools, [&](const SessionBody& body, const BodyState& before) {
    return body.settled(before, from.tools, progress);
  });
}

Result<Moment> SessionEngine::Impl::both(const Moment& from, const Tools& tools, const Next& next) const {
  std::future<Result<BodyState>> beside;
  if (from.reference)
    beside = std::async(std::launch::async, [&] { return next(*from.reference_body, *from.reference); });
  auto patient_state = next(from.patient_body, from.patient);
  Moment moment = from;
  moment.tools = tools;
  if (from.reference) {
    auto reference_state = beside.get();
    if (!reference_state) return failure(std::move(reference_state.error()));
    moment.reference = std::move(*reference_state);
  }
  if (!patient_state) return failure(std::move(patient_state.error()));
  moment.patient = std::move(*patient_state);
  return moment;
}

Result<Moment> SessionEngine::Impl::cut(const Moment& from, const mechanics::CutStrip& strip) const {
  std::future<Result<SessionBody>> beside;
  if (from.reference) beside = std::async(std::launch::async, [&] { return from.reference_body->opened(strip); });
  auto patient_body = from.patient_body.opened(strip);
  Moment opened = from;
  if (from.reference) {
    auto reference_body = beside.get();
    if (!reference_body) return failure(std::move(reference_body.error()));
    opened.reference_body = std::move(*reference_body);
  }
  if (!patient_body) return failure(std::move(patient_body.error()));
  opened.patient_body = std::move(*patient_body);
  opened.cuts.push_back(strip);
  return moved(opened, from.tools);
}

// A moment at large strain holds every node of both bodies, some 2 MB; the first, untouched, stays.
void SessionEngine::Impl::forget_the_oldest() {
  const std::size_t most = law.law == mechanics::MaterialLaw::linear ? 10001 : 101;
  if (moments.size() > most) moments.erase(moments.begin() + 1);
}

RehearsalBody SessionEngine::Impl::shown(const SessionBody& body, const BodyState& state) const {
  RehearsalBody shown;
  const auto& rest_mm = body.surface().points_mm;
  const std::vector<Vector3d>& moved_mm = surface_mm(state);
  for (std::size_t p = 0; p < rest_mm.size(); ++p) {
    shown.surface_mm.push_back(rest_mm[p] + moved_mm[p]);
    shown.max_displacement_mm = std::max(shown.max_displacement_mm, moved_mm[p].norm());
  }
  auto next = watched_mm(state).begin();
  const auto after_landmarks = next + static_cast<std::ptrdiff_t>(landmarks.size());
  shown.landmarks = mechanics::displaced_landmarks(landmarks, landmark_places, {next, after_landmarks});
  next = after_landmarks;
  for (const geometry::Surface& structure : structures) {
    std::vector<Vector3d> points_mm;
    for (const Vector3d& point : structure.points_mm) points_mm.push_back(point + *next++);
    shown.structures_mm.push_back(std::move(points_mm));
  }
  return shown;
}

std::shared_ptr<const SessionCut> SessionEngine::Impl::cut_of(const Moment& moment) const {
  auto cut = moment.patient_body.cut(moment.patient);
  if (!cut) return nullptr;
  cut->advances = moment.cuts.size();
  for (std::size_t s = 0; s < structures.size(); ++s) {
    if (std::any_of(moment.cuts.begin(), moment.cuts.end(),
                    [&](const mechanics::CutStrip& strip) { return mechanics::crosses(strip, structures[s]); })) {
      cut->crossed.push_back(s);
    }
  }
  return std::make_shared<const SessionCut>(*std::move(cut));
}

SessionState SessionEngine::Impl::state_of(const Moment& moment) const {
  SessionState state;
  state.tools = moment.tools;
  state.patient = shown(moment.patient_body, moment.patient);
  state.cut = cut_of(moment);
  state.patient_step = step_of(moment.patient, moment.tools, moment.patient_body.surface());
  const mechanics::ContactReport& report = state.patient_step.report;
  state.validity = {report.converged, report.largest_strain, report.inverted_cells, mechanics::strain_limit(law.law)};
  state.error_bound_mm = state.patient_step.error_bound_mm;
  state.settled = state.patient_step.settled;
  if (moment.reference) {
    state.reference = shown(*moment.reference_body, *moment.reference);
    state.reference_step = step_of(*moment.reference, moment.tools, moment.reference_body->surface());
    if (state.error_bound_mm)
      state.error_bound_mm = std::max(*state.error_bound_mm, *state.reference_step->error_bound_mm);
    state.settled = state.settled && state.reference_step->settled;
    state.differences = differences_between(state.patient.landmarks, state.reference->landmarks);
    for (std::size_t p = 0; p < state.patient.surface_mm.size(); ++p) {
      state.max_difference_mm =
          std::max(state.max_difference_mm, (state.patient.surface_mm[p] - state.reference->surface_mm[p]).norm());
    }
  }
  state.digest = digest_of(moment);
  return state;
}

bool SessionEngine::prepare_the_next_cut() const {
  const Moment& now = impl_->moments.back();
  if (now.cuts.empty()) return false;
  constexpr double back_mm = 15.0, ahead_mm = 20.0;  // points open a cell before the front comes to them
  const mechanics::CutStrip& last = now.cuts.back();
  const Vector3d forward = (last.to_mm - last.from_mm).normalized();
  const mechanics::CutStrip ahead{last.surface, last.to_mm - back_mm * forward, last.to_mm + ahead_mm * forward};
  std::future<Result<bool>> beside;
  if (now.reference_body) beside = std::async(std::launch::async, [&] { return now.reference_body->prepare(ahead); });
  const auto patient = now.patient_body.prepare(ahead);
  const auto reference = now.reference_body ? beside.get() : Result<bool>(false);
  return (patient && *patient) || (reference && *reference);
}

Result<void> SessionEngine::make_reference(const Progress& progress) const { return impl_->make_reference(progress); }
bool SessionEngine::has_reference() const { return impl_->reference_maker != nullptr; }
const SessionState& SessionEngine::state() const { return *impl_->latest; }
std::shared_ptr<const SessionState> SessionEngine::shared_state() const { return impl_->latest; }
const geometry::Surface& SessionEngine::surface() const { return impl_->moments.front().patient_body.surface(); }
Result<mechanics::StaticResult> SessionEngine::whole_result() const {
  const Moment& now = impl_->moments.back();
  return now.patient_body.whole_result(now.patient);
}

WithReference reference_in(const Recording& recording) {
  const auto asks = [](const auto& one) { return std::holds_alternative<Compare>(one.first); };
  return std::any_of(recording.begin(), recording.end(), asks) ? WithReference::when_asked : WithReference::at_once;
}

std::optional<std::size_t> replay(SessionEngine& engine, const Recording& recording) {
  std::optional<std::size_t> first_other;
  for (std::size_t i = 0; i < recording.size(); ++i) {
    const SessionState& state = engine.step(recording[i].first);
    if (!first_other && !recording[i].second.empty() && state.digest != recording[i].second) first_other = i;
  }
  return first_other;
}

namespace {

std::string digest_of(const Moment& moment) {
  std::string bits = bits_of(moment.patient);
  if (moment.reference) bits += bits_of(*moment.reference);
  return sha256_of_text(bits);
}

}  // namespace
}  // namespace glisson::rehearsal

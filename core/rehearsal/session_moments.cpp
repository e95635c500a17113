// What a command makes of a session's bodies: the patient, the reference body beside it on a thread of its own, and
// under a meshfree patient the same by finite elements.

#include <algorithm>
#include <cmath>
#include <future>

#include "base/files.h"
#include "base/stopwatch.h"
#include "rehearsal/internal/session_engine.h"

namespace glisson::rehearsal {
namespace {

using Eigen::Vector3d;

std::string digest_of(const Moment& moment, std::size_t judged);

}  // namespace

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
  auto came = brought_to(moment, *reference);
  if (!came) return failure(std::move(came.error()));
  moment.reference = std::move(came->second);
  moment.reference_body = std::move(came->first);
  return moment;
}

Result<std::pair<SessionBody, BodyState>> SessionEngine::Impl::brought_to(const Moment& moment,
                                                                          SessionBody body) const {
  Result<BodyState> state = body.untouched();
  for (const mechanics::CutStrip& strip : moment.cuts) {
    auto opened = body.opened(strip);
    if (!opened) return failure(std::move(opened.error()));
    body = std::move(*opened);
  }
  if (!moment.tools.empty() || !moment.cuts.empty()) state = way_to({}, moment.tools)(body, *state);
  if (!state) return failure(std::move(state.error()));
  return std::pair(std::move(body), std::move(*state));
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

int SessionEngine::Impl::small_moves(const Tools& from, const Tools& tools) const {
  // A force that grows at once carries the surface past the tool that it should meet, and at large strain farther than
  // one picture follows; a quarter of a newton moves a liver by some millimetres.
  constexpr double push_in_a_step_mN = 250.0;
  constexpr int maximum_steps = 200;
  const double steps_wanted =
      std::max(farthest_move_mm(from, tools) / mechanics::ContactOptions().largest_move_mm,
               (law.law == mechanics::MaterialLaw::linear ? largest_change_of_push_mN(from, tools)
                                                          : largest_change_of_force_mN(from, tools)) /
                   push_in_a_step_mN);
  return static_cast<int>(std::clamp(std::ceil(steps_wanted), 1.0, double{maximum_steps}));
}

SessionEngine::Impl::Next SessionEngine::Impl::way_to(const Tools& from, const Tools& tools) const {
  return [from, tools, steps = small_moves(from, tools)](const SessionBody& body,
                                                         const BodyState& before) -> Result<BodyState> {
    BodyState state = before;
    for (int step = 1; step <= steps; ++step) {
      auto next = body.moved(state, between(from, tools, double(step) / steps),
                             step == steps ? SessionBody::Shown::yes : SessionBody::Shown::no);
      if (!next) return next;
      state = std::move(*next);
    }
    return state;
  };
}

Result<Moment> SessionEngine::Impl::moved(const Moment& from, const Tools& tools, const OnTheWay& told) const {
  if (!told || (law.law == mechanics::MaterialLaw::linear && !in_motion))
    return both(from, tools, way_to(from.tools, tools));
  const int moves = small_moves(from.tools, tools);
  Moment moment = from;
  for (int move = 1; move <= moves; ++move) {
    const Tools there = between(from.tools, tools, double(move) / moves);
    auto next = both(moment, there,
                     [&](const SessionBody& body, const BodyState& before) { return body.moved(before, there); });
    if (!next) return next;
    moment = std::move(*next);
    if (move < moves) told(moment, move);
  }
  return moment;
}

Result<Moment> SessionEngine::Impl::later(const Moment& from, int steps, const Progress& progress) const {
  Moment moment = from;
  for (int step = 0; step < steps && in_motion; ++step) {
    if (progress.cancelled()) return cancelled();
    auto next = both(moment, from.tools,
                     [&](const SessionBody& body, const BodyState& before) { return body.moved(before, from.tools); });
    if (!next) return next;
    moment = std::move(*next);
  }
  return moment;
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
  const Stopwatch watch;
  auto patient_state = next(from.patient_body, from.patient);
  Moment moment = from;
  moment.tools = tools;
  moment.patient_ms = 1e3 * watch.seconds();
  if (from.reference) {
    auto reference_state = beside.get();
    if (!reference_state) return failure(std::move(reference_state.error()));
    moment.reference = std::move(*reference_state);
  }
  if (!patient_state) return failure(std::move(patient_state.error()));
  moment.patient = std::move(*patient_state);
  answer_by_elements(moment, next);
  return moment;
}

// Where finite elements found no shape before, tools come to them afresh.
void SessionEngine::Impl::answer_by_elements(Moment& moment, const Next& next) const {
  if (!moment.elements_body) return;
  const Stopwatch watch;
  const Moment& untouched = moments.front();
  if (moment.elements) {
    auto state = next(*moment.elements_body, *moment.elements);
    moment.elements.reset();
    if (state) moment.elements = std::move(*state);
  } else if (auto came = brought_to(moment, *untouched.elements_body)) {
    moment.elements_body = std::move(came->first);
    moment.elements = std::move(came->second);
  }
  moment.elements_ms = 1e3 * watch.seconds();
}

// Every body by the same strip, side by side. Where finite elements beside a meshfree patient have nothing to open,
// which is a matter of where their points lie, they stay as they are.
Result<Moment> SessionEngine::Impl::cut(const Moment& from, const mechanics::CutStrip& strip) const {
  std::future<Result<SessionBody>> of_reference, of_elements;
  if (from.reference) of_reference = std::async(std::launch::async, [&] { return from.reference_body->opened(strip); });
  if (from.elements_body) {
    of_elements = std::async(std::launch::async, [&] { return from.elements_body->opened(strip); });
  }
  auto patient_body = from.patient_body.opened(strip);
  Moment opened = from;
  if (of_reference.valid()) {
    auto reference_body = of_reference.get();
    if (!reference_body) return failure(std::move(reference_body.error()));
    opened.reference_body = std::move(*reference_body);
  }
  if (of_elements.valid()) {
    auto elements_body = of_elements.get();
    if (elements_body) {
      opened.elements_body = std::move(*elements_body);
    } else if (elements_body.error().code != "cut-misses") {
      return failure(std::move(elements_body.error()));
    }
  }
  if (!patient_body) return failure(std::move(patient_body.error()));
  opened.patient_body = std::move(*patient_body);
  opened.cuts.push_back(strip);
  for (std::size_t s = 0; s < structures.size(); ++s) {
    if (mechanics::crosses(strip, structures[s])) opened.crossed.push_back(s);
  }
  std::sort(opened.crossed.begin(), opened.crossed.end());
  opened.crossed.erase(std::unique(opened.crossed.begin(), opened.crossed.end()), opened.crossed.end());
  return moved(opened, from.tools);
}

// A moment at large strain or in motion holds every node of both bodies, some MB; the first, untouched, stays.
void SessionEngine::Impl::go_on_to(Moment moment) {
  Moment& before = moments.back();
  before.patient = SessionBody::without_shape(before.patient);
  if (before.reference) before.reference = SessionBody::without_shape(*before.reference);
  if (before.elements) before.elements = SessionBody::without_shape(*before.elements);
  moments.push_back(std::move(moment));
  const std::size_t most = law.law == mechanics::MaterialLaw::linear && !in_motion ? 10001 : 101;
  if (moments.size() > most) moments.erase(moments.begin() + 1);
}

Result<void> SessionEngine::Impl::go_back() {
  if (moments.size() == 1) return failure("nothing-to-undo", GLISSON_TEXT("There is nothing to undo."));
  Moment shown = moments[moments.size() - 2];
  const auto show = [](const SessionBody& body, BodyState& state) -> Result<void> {
    return body.with_shape(state).map([&](BodyState whole) { state = std::move(whole); });
  };
  auto found = show(shown.patient_body, shown.patient);
  if (found && shown.reference) found = show(*shown.reference_body, *shown.reference);
  if (found && shown.elements) found = show(*shown.elements_body, *shown.elements);
  if (!found) return found;
  moments.pop_back();
  moments.back() = std::move(shown);
  return {};
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
  cut->crossed = moment.crossed;
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
  state.motion = motion_of(moment.patient);
  if (state.motion && moment.reference)
    state.motion->moves = state.motion->moves || motion_of(*moment.reference)->moves;
  state.beside_elements = beside_elements(moment);
  state.digest = digest_of(moment, landmarks.size());
  return state;
}

std::optional<BesideElements> SessionEngine::Impl::beside_elements(const Moment& moment) const {
  if (!moment.elements) return {};
  // Of displacements (mm) of the same places at rest.
  const auto farthest_mm = [](const std::vector<Vector3d>& a, const std::vector<Vector3d>& b, std::size_t count) {
    double farthest = 0;
    for (std::size_t p = 0; p < count; ++p) farthest = std::max(farthest, (a[p] - b[p]).norm());
    return farthest;
  };
  const std::vector<Vector3d>& surface = surface_mm(moment.patient);
  return BesideElements{farthest_mm(watched_mm(moment.patient), watched_mm(*moment.elements), landmarks.size()),
                        farthest_mm(surface, surface_mm(*moment.elements), surface.size()),
                        moment.elements_body->largest_opening_mm(*moment.elements), moment.patient_ms,
                        moment.elements_ms};
}

namespace {

std::string digest_of(const Moment& moment, std::size_t judged) {
  std::string bits = bits_of(moment.patient, judged);
  if (moment.reference) bits += bits_of(*moment.reference, judged);
  return sha256_of_text(bits);
}

}  // namespace
}  // namespace glisson::rehearsal

#include "rehearsal/session.h"

#include <algorithm>
#include <future>

#include "base/stopwatch.h"
#include "rehearsal/internal/session_engine.h"

namespace glisson::rehearsal {

using Eigen::Vector3d;
using mechanics::ContactTool;

namespace {

Result<void> check_motion(const RehearsalSetup& setup) {
  if (!setup.motion || !setup.meshfree) return {};
  return failure(Error{"not-available",
                       GLISSON_TEXT("A session in motion is by finite elements."),
                       {},
                       GLISSON_TEXT("Take the engine \"fem\", or no motion."),
                       {}});
}

}  // namespace

Result<SessionEngine> SessionEngine::create(RehearsalSetup setup, const Progress& progress, WithReference reference) {
  if (auto checked = check_motion(setup); !checked) return failure(std::move(checked.error()));
  auto parts = std::make_shared<Impl>();
  parts->in_motion = setup.motion.has_value();
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
  const bool at_once = setup.reference_youngs_kPa && (reference == WithReference::at_once || parts->in_motion);
  auto models = rehearsal_models(setup, progress.part(0.0, at_once ? 0.5 : 1.0));
  if (!models) return failure(std::move(models.error()));
  parts->law = law_of_patient(setup);
  auto patient = SessionBody::create((*models)->patient, parts->law, setup, watched, parts->landmarks.size());
  if (!patient) return failure(std::move(patient.error()));
  BodyState at_rest = patient->untouched();
  Moment untouched{{}, std::move(*patient), {}, std::move(at_rest), {}};
  if (setup.meshfree) {
    RehearsalSetup by_elements = setup;
    by_elements.meshfree.reset();
    by_elements.models = std::move(by_elements.elements);
    auto body = rehearsal_models(by_elements).and_then([&](const auto& made) {
      return SessionBody::create(made->patient, parts->law, by_elements, watched, parts->landmarks.size());
    });
    if (!body) return failure(std::move(body.error()));
    untouched.elements = body->untouched();
    untouched.elements_body = std::move(*body);
  }
  setup.relaxation.clear();  // the reference body is elastic
  if ((*models)->reference) {
    parts->reference_maker = [reference = *(*models)->reference, setup = std::move(setup), watched = std::move(watched),
                              judged = parts->landmarks.size()](const Progress& told) -> Result<SessionBody> {
      const auto model = reference.model(told);
      if (!model) return failure(model.error());
      return SessionBody::create(*model, setup.law, setup, watched, judged);
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

const SessionState& SessionEngine::step(const SessionCommand& command, const Progress& progress, const Told& told) {
  const Stopwatch watch;
  Impl& parts = *impl_;
  std::string refused;
  std::optional<Error> refusal;
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
    if (auto back = parts.go_back(); !back) {
      refused = back.error().message();
    } else if (parts.compares) {
      parts.compare_the_last();
    }
  }
  if (std::holds_alternative<Compare>(command)) {
    refused = parts.begin_to_compare();
  } else if (refused.empty() && !std::holds_alternative<Undo>(command)) {
    const bool settles = std::holds_alternative<Settle>(command);
    const auto* wait = std::get_if<Wait>(&command);
    const auto* advance = std::get_if<AdvanceCut>(&command);
    const Moment& now = parts.moments.back();
    const auto tell = [&](const Moment& moment, int moves) {
      SessionState state = parts.state_of(moment);
      state.number = parts.commands;
      state.on_the_way = moves;
      state.step_ms = 1e3 * watch.seconds();
      told(std::make_shared<const SessionState>(std::move(state)));
    };
    const Impl::OnTheWay on_the_way = told ? Impl::OnTheWay(tell) : Impl::OnTheWay();
    auto moment = settles              ? parts.nearer_to_rest(now, progress)
                  : wait != nullptr    ? parts.later(now, wait->steps, progress)
                  : advance != nullptr ? parts.cut(now, advance->strip)
                                       : parts.moved(now, tools, on_the_way);
    const bool stays = settles || wait != nullptr;  // what undo goes back to
    if (!moment && stays && progress.cancelled()) return *parts.latest;
    if (!moment) {
      refused = moment.error().message();
      refusal = moment.error();
    } else if (stays) {
      parts.moments.back() = std::move(*moment);
    } else {
      parts.go_on_to(std::move(*moment));
      if (parts.compares) parts.compare_the_last();
    }
  }
  ++parts.commands;
  parts.settles = std::holds_alternative<Settle>(command) ? parts.settles + 1 : 0;
  SessionState state = parts.state_of(parts.moments.back());
  state.number = parts.commands;
  state.settles = parts.settles;
  state.refused = std::move(refused);
  state.refusal = std::move(refusal);
  state.step_ms = 1e3 * watch.seconds();
  parts.latest = std::make_shared<SessionState>(std::move(state));
  return *parts.latest;
}

SessionState SessionEngine::settled_state() const {
  const Stopwatch watch;
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
  state.step_ms = 1e3 * watch.seconds();
  return state;
}

bool SessionEngine::prepare() const {
  const Moment& now = impl_->moments.back();
  std::optional<mechanics::CutStrip> ahead;
  if (!now.cuts.empty()) {
    constexpr double back_mm = 15.0, ahead_mm = 20.0;  // points open a cell before the front comes to them
    const mechanics::CutStrip& last = now.cuts.back();
    const Vector3d forward = (last.to_mm - last.from_mm).normalized();
    ahead = {last.surface, last.to_mm - back_mm * forward, last.to_mm + ahead_mm * forward};
  }
  const auto next = [&](const SessionBody& body, const BodyState& state) {
    const auto of_cut = ahead ? body.prepare(*ahead) : Result<bool>(false);
    if (of_cut && *of_cut) return true;
    const auto of_touch = body.prepare_touch(state, now.tools);
    return of_touch && *of_touch;
  };
  std::future<bool> beside;
  if (now.reference) beside = std::async(std::launch::async, [&] { return next(*now.reference_body, *now.reference); });
  bool more = next(now.patient_body, now.patient);
  if (now.elements) more = next(*now.elements_body, *now.elements) || more;
  return (now.reference && beside.get()) || more;
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

}  // namespace glisson::rehearsal

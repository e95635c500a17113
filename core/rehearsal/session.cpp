#include "rehearsal/session.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <future>

#include "base/files.h"

namespace glisson::rehearsal {
namespace {

using Eigen::Vector3d;
using mechanics::ContactBody;
using mechanics::ContactState;
using mechanics::ContactTool;
using mechanics::Grasp;
using mechanics::TouchingTool;
using Clock = std::chrono::steady_clock;
using Tools = std::vector<ContactTool>;

// All that a command starts from, and undo goes back to.
struct Moment {
  Tools tools;
  ContactBody patient_body;
  std::optional<ContactBody> atlas_body;
  ContactState patient;
  std::optional<ContactState> atlas;
  std::vector<mechanics::CutStrip> cuts = {};
};

// Between two sets of tools: those of the same id go in a straight line, the others are there at once, and what pushes
// begins gently.
Tools between(const Tools& from, const Tools& to, double part);
double farthest_move_mm(const Tools& from, const Tools& to);
double largest_change_of_push_mN(const Tools& from, const Tools& to);

std::string digest_of(const Moment& moment);

}  // namespace

struct SessionEngine::Impl {
  std::vector<mechanics::Landmark> landmarks;
  std::vector<mechanics::PointInMesh> landmark_places;
  std::vector<geometry::Surface> structures;
  std::vector<Moment> moments;  // the first untouched, the last the present
  std::uint64_t commands = 0;
  std::shared_ptr<const SessionFrame> latest;

  // With the tools there; and cut further under the same tools.
  [[nodiscard]] Result<Moment> moved(const Moment& from, const Tools& tools) const;
  [[nodiscard]] Result<Moment> cut(const Moment& from, const mechanics::CutStrip& strip) const;
  [[nodiscard]] RehearsalBody shown(const ContactBody& body, const ContactState& state) const;
  [[nodiscard]] std::shared_ptr<const SessionCut> cut_of(const Moment& moment) const;
  [[nodiscard]] SessionFrame frame_of(const Moment& moment) const;
};

Result<SessionEngine> SessionEngine::create(RehearsalSetup setup, const Progress& progress) {
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
  auto models = rehearsal_models(setup, progress);
  if (!models) return failure(std::move(models.error()));
  auto patient = ContactBody::create((*models)->patient, setup.standing_loads, watched);
  if (!patient) return failure(std::move(patient.error()));
  ContactState at_rest = patient->untouched();
  Moment untouched{{}, std::move(*patient), {}, std::move(at_rest), {}};
  if ((*models)->atlas) {
    auto atlas = ContactBody::create(*(*models)->atlas, setup.standing_loads, watched);
    if (!atlas) return failure(std::move(atlas.error()));
    untouched.atlas = atlas->untouched();
    untouched.atlas_body = std::move(*atlas);
  }
  parts->moments.push_back(std::move(untouched));
  parts->latest = std::make_shared<SessionFrame>(parts->frame_of(parts->moments.back()));
  return SessionEngine(std::move(parts));
}

const SessionFrame& SessionEngine::step(const SessionCommand& command) {
  const auto start = Clock::now();
  Impl& parts = *impl_;
  ++parts.commands;
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
    } else {
      refused = "There is nothing to undo.";
    }
  }
  if (refused.empty() && !std::holds_alternative<Undo>(command)) {
    const auto* advance = std::get_if<AdvanceCut>(&command);
    auto moment =
        advance != nullptr ? parts.cut(parts.moments.back(), advance->strip) : parts.moved(parts.moments.back(), tools);
    if (moment) {
      parts.moments.push_back(std::move(*moment));
    } else {
      refused = moment.error().message();
    }
  }
  SessionFrame frame = parts.frame_of(parts.moments.back());
  frame.number = parts.commands;
  frame.refused = std::move(refused);
  frame.step_ms = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  parts.latest = std::make_shared<SessionFrame>(std::move(frame));
  return *parts.latest;
}

// The reference body is moved beside the patient, on a thread of its own.
Result<Moment> SessionEngine::Impl::moved(const Moment& from, const Tools& tools) const {
  const mechanics::ContactOptions options;
  // A force that grows at once carries the surface past the tool that it should meet; a quarter of a newton moves a
  // liver by some millimetres.
  constexpr double push_in_a_step_mN = 250.0;
  constexpr int maximum_steps = 200;
  const double steps_wanted = std::max(farthest_move_mm(from.tools, tools) / options.largest_move_mm,
                                       largest_change_of_push_mN(from.tools, tools) / push_in_a_step_mN);
  const int steps = static_cast<int>(std::clamp(std::ceil(steps_wanted), 1.0, double{maximum_steps}));
  const auto all_steps = [&](const ContactBody& body, ContactState state) -> Result<ContactState> {
    for (int step = 1; step <= steps; ++step) {
      auto next = body.solve(state, between(from.tools, tools, double(step) / steps), options);
      if (!next) return next;
      if (!next->report.converged) {
        return failure("not-converged",
                       GLISSON_TEXT("The step did not converge: after {0} rounds a tool still reaches {1} mm into the "
                                    "surface, which still moves by {2} mm."),
                       {std::to_string(next->report.rounds), std::to_string(next->report.penetration_mm),
                        std::to_string(next->report.movement_mm)});
      }
      state = std::move(*next);
    }
    return state;
  };
  std::future<Result<ContactState>> beside;
  if (from.atlas) {
    beside = std::async(std::launch::async, [&] { return all_steps(*from.atlas_body, *from.atlas); });
  }
  auto patient_state = all_steps(from.patient_body, from.patient);
  Moment moment = from;
  moment.tools = tools;
  if (from.atlas) {
    auto atlas_state = beside.get();
    if (!atlas_state) return failure(std::move(atlas_state.error()));
    moment.atlas = std::move(*atlas_state);
  }
  if (!patient_state) return failure(std::move(patient_state.error()));
  moment.patient = std::move(*patient_state);
  return moment;
}

Result<Moment> SessionEngine::Impl::cut(const Moment& from, const mechanics::CutStrip& strip) const {
  std::future<Result<ContactBody>> beside;
  if (from.atlas) beside = std::async(std::launch::async, [&] { return from.atlas_body->opened(strip); });
  auto patient_body = from.patient_body.opened(strip);
  Moment opened = from;
  if (from.atlas) {
    auto atlas_body = beside.get();
    if (!atlas_body) return failure(std::move(atlas_body.error()));
    opened.atlas_body = std::move(*atlas_body);
  }
  if (!patient_body) return failure(std::move(patient_body.error()));
  opened.patient_body = std::move(*patient_body);
  opened.cuts.push_back(strip);
  return moved(opened, from.tools);
}

RehearsalBody SessionEngine::Impl::shown(const ContactBody& body, const ContactState& state) const {
  RehearsalBody shown;
  const auto& rest_mm = body.surface().points_mm;
  for (std::size_t p = 0; p < rest_mm.size(); ++p) {
    shown.surface_mm.push_back(rest_mm[p] + state.surface_mm[p]);
    shown.max_displacement_mm = std::max(shown.max_displacement_mm, state.surface_mm[p].norm());
  }
  auto next = state.watched_mm.begin();
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
  const mechanics::Opening* opening = moment.patient_body.opening();
  if (opening == nullptr) return nullptr;
  auto surface = moment.patient_body.opened_surface(moment.patient);
  if (!surface) return nullptr;
  SessionCut cut{std::move(*surface), moment.cuts.size(), opening->open_mm2(), opening->whole_mm2(), 0, {}};
  for (const Vector3d& jump_mm : moment.patient.jumps_mm) {
    cut.largest_opening_mm = std::max(cut.largest_opening_mm, jump_mm.norm());
  }
  for (std::size_t s = 0; s < structures.size(); ++s) {
    if (std::any_of(moment.cuts.begin(), moment.cuts.end(),
                    [&](const mechanics::CutStrip& strip) { return mechanics::crosses(strip, structures[s]); })) {
      cut.crossed.push_back(s);
    }
  }
  return std::make_shared<SessionCut>(std::move(cut));
}

SessionFrame SessionEngine::Impl::frame_of(const Moment& moment) const {
  SessionFrame frame;
  frame.tools = moment.tools;
  frame.patient = shown(moment.patient_body, moment.patient);
  frame.cut = cut_of(moment);
  frame.patient_step = {moment.patient.report, moment.patient.tools};
  frame.validity = {moment.patient.report.converged, moment.patient.report.largest_strain,
                    moment.patient.report.inverted_cells};
  if (moment.atlas) {
    frame.atlas = shown(*moment.atlas_body, *moment.atlas);
    frame.atlas_step = SessionStep{moment.atlas->report, moment.atlas->tools};
    frame.differences = differences_between(frame.patient.landmarks, frame.atlas->landmarks);
    for (std::size_t p = 0; p < frame.patient.surface_mm.size(); ++p) {
      frame.max_difference_mm =
          std::max(frame.max_difference_mm, (frame.patient.surface_mm[p] - frame.atlas->surface_mm[p]).norm());
    }
  }
  frame.digest = digest_of(moment);
  return frame;
}

const SessionFrame& SessionEngine::frame() const { return *impl_->latest; }
std::shared_ptr<const SessionFrame> SessionEngine::shared_frame() const { return impl_->latest; }
const geometry::Surface& SessionEngine::surface() const { return impl_->moments.front().patient_body.surface(); }
Result<mechanics::StaticResult> SessionEngine::whole_result() const {
  const Moment& now = impl_->moments.back();
  return now.patient_body.whole_result(now.patient);
}

std::optional<std::size_t> replay(SessionEngine& engine, const Recording& recording) {
  std::optional<std::size_t> first_other;
  for (std::size_t i = 0; i < recording.size(); ++i) {
    const SessionFrame& frame = engine.step(recording[i].first);
    if (!first_other && !recording[i].second.empty() && frame.digest != recording[i].second) first_other = i;
  }
  return first_other;
}

namespace {

Tools between(const Tools& from, const Tools& to, double part) {
  Tools tools = to;
  for (ContactTool& tool : tools) {
    const auto before =
        std::find_if(from.begin(), from.end(), [&](const ContactTool& old) { return old.id == tool.id; });
    if (auto* touching = std::get_if<TouchingTool>(&tool.what)) {
      const auto* old = before == from.end() ? nullptr : std::get_if<TouchingTool>(&before->what);
      if (old == nullptr || !old->push_mN) {
        if (touching->push_mN) *touching->push_mN *= part;
      } else if (touching->push_mN) {
        *touching->push_mN = (1.0 - part) * *old->push_mN + part * *touching->push_mN;
      }
      if (old == nullptr) continue;
      touching->pose.position_mm = (1.0 - part) * old->pose.position_mm + part * touching->pose.position_mm;
    } else {
      auto& grasp = std::get<Grasp>(tool.what);
      const auto* old_grasp = before == from.end() ? nullptr : std::get_if<Grasp>(&before->what);
      auto* drawn_mm = std::get_if<Vector3d>(&grasp.drawn);
      if (drawn_mm == nullptr) continue;
      const Vector3d* old_mm = old_grasp == nullptr ? nullptr : std::get_if<Vector3d>(&old_grasp->drawn);
      *drawn_mm = (1.0 - part) * (old_mm == nullptr ? Vector3d(0, 0, 0) : *old_mm) + part * *drawn_mm;
    }
  }
  return tools;
}

double farthest_move_mm(const Tools& from, const Tools& to) {
  const Tools begin = between(from, to, 0.0);
  double farthest_mm = 0;
  for (std::size_t t = 0; t < to.size(); ++t) {
    if (const auto* touching = std::get_if<TouchingTool>(&to[t].what)) {
      const auto& old = std::get<TouchingTool>(begin[t].what);
      farthest_mm = std::max(farthest_mm, (touching->pose.position_mm - old.pose.position_mm).norm());
    } else if (const auto* drawn_mm = std::get_if<Vector3d>(&std::get<Grasp>(to[t].what).drawn)) {
      farthest_mm =
          std::max(farthest_mm, (*drawn_mm - std::get<Vector3d>(std::get<Grasp>(begin[t].what).drawn)).norm());
    }
  }
  return farthest_mm;
}

double largest_change_of_push_mN(const Tools& from, const Tools& to) {
  const Tools begin = between(from, to, 0.0);
  double largest_mN = 0;
  for (std::size_t t = 0; t < to.size(); ++t) {
    const auto* touching = std::get_if<TouchingTool>(&to[t].what);
    if (touching == nullptr || !touching->push_mN) continue;
    const double before_mN = std::get<TouchingTool>(begin[t].what).push_mN.value_or(0.0);
    largest_mN = std::max(largest_mN, std::abs(*touching->push_mN - before_mN));
  }
  return largest_mN;
}

std::string digest_of(const Moment& moment) {
  std::string bits;
  const auto add = [&](const Vector3d& v) { bits.append(reinterpret_cast<const char*>(v.data()), 3 * sizeof(double)); };
  const auto add_state = [&](const ContactState& state) {
    for (const Vector3d& u : state.surface_mm) add(u);
    for (const Vector3d& u : state.watched_mm) add(u);
    for (const auto& [point, force] : state.force_mN) add(force);
    for (const Vector3d& jump : state.jumps_mm) add(jump);
  };
  add_state(moment.patient);
  if (moment.atlas) add_state(*moment.atlas);
  return sha256_of_text(bits);
}

}  // namespace
}  // namespace glisson::rehearsal

#include <Eigen/Geometry>

#include "rehearsal/internal/session_body.h"

namespace glisson::rehearsal {
namespace {

using Eigen::Vector3d;
using mechanics::ContactBody;
using mechanics::ContactState;
using mechanics::ContactTool;
using mechanics::Grasp;
using mechanics::LiveBody;
using mechanics::LiveState;
using mechanics::MovingBody;
using mechanics::MovingLiveBody;
using mechanics::MovingLiveState;
using mechanics::MovingState;
using mechanics::TouchingTool;

using SmallState = std::shared_ptr<const ContactState>;
using LargeState = std::shared_ptr<const LiveState>;
using MovedState = std::shared_ptr<const MovingState>;
using MovedLargeState = std::shared_ptr<const MovingLiveState>;

// What live_body.h knows of a state of large strain; else nullptr.
const LiveState* live_in(const BodyState& state) {
  if (const auto* moved = std::get_if<MovedLargeState>(&state)) return moved->get();
  const auto* large = std::get_if<LargeState>(&state);
  return large == nullptr ? nullptr : large->get();
}

// What contact.h knows of a state that is not of large strain.
const ContactState& contact_in(const BodyState& state) {
  if (const auto* moved = std::get_if<MovedState>(&state)) return **moved;
  return *std::get<SmallState>(state);
}

Result<void> check_contact(const mechanics::ContactReport& report);

Vector3d moment_uJ(const BodyState& state, const geometry::Surface& surface);
Vector3d place_mm(const ContactTool& tool, double advance_mm);

}  // namespace

Result<SessionBody> SessionBody::create(const mechanics::StaticModel& model, const mechanics::ChosenLaw& law,
                                        const RehearsalSetup& setup, const std::vector<mechanics::PointInMesh>& watched,
                                        std::size_t judged) {
  if (setup.motion) {
    const mechanics::DynamicsOptions options{.step_s = setup.motion->step_s,
                                             .mass_damping_per_s = setup.motion->mass_damping_per_s,
                                             .stiffness_damping_s = setup.motion->stiffness_damping_s,
                                             .relaxation = setup.relaxation};
    if (law.law != mechanics::MaterialLaw::linear) {
      return MovingLiveBody::create(model, law, setup.supports, setup.standing_loads, watched, judged, options)
          .map([](MovingLiveBody body) { return SessionBody(std::move(body)); });
    }
    return MovingBody::create(model, setup.standing_loads, watched, judged, options).map([](MovingBody body) {
      return SessionBody(std::move(body));
    });
  }
  if (law.law == mechanics::MaterialLaw::linear) {
    return ContactBody::create(model, setup.standing_loads, watched, judged).map([](ContactBody body) {
      return SessionBody(std::move(body));
    });
  }
  return LiveBody::create(model, law, setup.supports, setup.standing_loads, watched, judged).map([](LiveBody body) {
    return SessionBody(std::move(body));
  });
}

BodyState SessionBody::untouched() const {
  if (const auto* small = std::get_if<ContactBody>(&body_)) {
    return std::make_shared<const ContactState>(small->untouched());
  }
  if (const auto* moving = std::get_if<MovingBody>(&body_)) {
    return std::make_shared<const MovingState>(moving->untouched());
  }
  if (const auto* moving = std::get_if<MovingLiveBody>(&body_)) {
    return std::make_shared<const MovingLiveState>(moving->untouched());
  }
  return std::make_shared<const LiveState>(std::get<LiveBody>(body_).untouched());
}

Result<BodyState> SessionBody::moved(const BodyState& from, const std::vector<ContactTool>& tools, Shown shown) const {
  if (const auto* large = std::get_if<LiveBody>(&body_)) {
    return large->step(*std::get<LargeState>(from), tools).map([](LiveState state) {
      return BodyState(std::make_shared<const LiveState>(std::move(state)));
    });
  }
  if (const auto* moving = std::get_if<MovingBody>(&body_)) {
    auto next = moving->step(*std::get<MovedState>(from), tools);
    if (!next) return failure(std::move(next.error()));
    if (auto checked = check_contact(next->report); !checked) return failure(std::move(checked.error()));
    return BodyState(std::make_shared<const MovingState>(std::move(*next)));
  }
  if (const auto* moving = std::get_if<MovingLiveBody>(&body_)) {
    return moving->step(*std::get<MovedLargeState>(from), tools).map([](MovingLiveState state) {
      return BodyState(std::make_shared<const MovingLiveState>(std::move(state)));
    });
  }
  mechanics::ContactOptions options;
  options.on_the_way = shown == Shown::no;
  auto next = std::get<ContactBody>(body_).solve(*std::get<SmallState>(from), tools, options);
  if (!next) return failure(std::move(next.error()));
  if (auto checked = check_contact(next->report); !checked) return failure(std::move(checked.error()));
  return BodyState(std::make_shared<const ContactState>(std::move(*next)));
}

Result<BodyState> SessionBody::settled(const BodyState& from, const std::vector<ContactTool>& tools,
                                       const Progress& progress) const {
  const auto* large = std::get_if<LiveBody>(&body_);
  if (large == nullptr || std::get<LargeState>(from)->settled) return from;
  mechanics::LiveOptions some;
  some.settling_rounds = 3;
  return large->settle(*std::get<LargeState>(from), tools, some, progress).map([](LiveState state) {
    return BodyState(std::make_shared<const LiveState>(std::move(state)));
  });
}

BodyState SessionBody::without_shape(const BodyState& state) {
  const auto* small = std::get_if<SmallState>(&state);
  if (small == nullptr) return state;
  return std::make_shared<const ContactState>(ContactBody::without_shape(**small));
}

Result<BodyState> SessionBody::with_shape(const BodyState& state) const {
  const auto* small = std::get_if<SmallState>(&state);
  if (small == nullptr) return state;
  return std::get<ContactBody>(body_).with_shape(**small).map(
      [](ContactState shown) { return BodyState(std::make_shared<const ContactState>(std::move(shown))); });
}

Result<SessionBody> SessionBody::opened(const mechanics::CutStrip& strip) const {
  const auto as_session_body = [](auto opened) { return SessionBody(std::move(opened)); };
  if (const auto* small = std::get_if<ContactBody>(&body_)) return small->opened(strip).map(as_session_body);
  if (const auto* large = std::get_if<LiveBody>(&body_)) return large->opened(strip).map(as_session_body);
  return failure(Error{"cut-in-motion",
                       GLISSON_TEXT("A cut does not advance in a session in motion."),
                       {},
                       GLISSON_TEXT("Cut in a session at rest."),
                       {}});
}

Result<bool> SessionBody::prepare(const mechanics::CutStrip& ahead) const {
  if (const auto* small = std::get_if<ContactBody>(&body_)) return small->prepare(ahead);
  const auto* large = std::get_if<LiveBody>(&body_);
  return large == nullptr ? Result<bool>(false) : large->prepare(ahead);
}

Result<bool> SessionBody::prepare_touch(const BodyState& state, const std::vector<ContactTool>& tools) const {
  if (const auto* small = std::get_if<ContactBody>(&body_)) return small->prepare_touch(contact_in(state), tools);
  const auto* moving = std::get_if<MovingBody>(&body_);
  return moving == nullptr ? Result<bool>(false) : moving->prepare_touch(contact_in(state), tools);
}

const mechanics::Opening* SessionBody::opening() const {
  if (const auto* small = std::get_if<ContactBody>(&body_)) return small->opening();
  const auto* large = std::get_if<LiveBody>(&body_);
  return large == nullptr ? nullptr : large->opening();
}

std::optional<SessionCut> SessionBody::cut(const BodyState& state) const {
  if (opening() == nullptr) return {};
  SessionCut cut{{}, 0, opening()->open_mm2(), opening()->whole_mm2(), *largest_opening_mm(state), {}};
  if (const auto* large = std::get_if<LiveBody>(&body_)) {
    cut.patient = large->opened_surface(*std::get<LargeState>(state));
  } else {
    auto surface = std::get<ContactBody>(body_).opened_surface(*std::get<SmallState>(state));
    if (!surface) return {};
    cut.patient = std::move(*surface);
  }
  return cut;
}

std::optional<double> SessionBody::largest_opening_mm(const BodyState& state) const {
  if (opening() == nullptr) return {};
  const auto* large = std::get_if<LiveBody>(&body_);
  const std::vector<Vector3d> jumps_mm =
      large != nullptr ? large->jumps_mm(*std::get<LargeState>(state)) : std::get<SmallState>(state)->jumps_mm;
  double largest_mm = 0;
  for (const mechanics::OpenCell& cell : opening()->cells()) {
    for (const Eigen::Vector4d& place : cell.wall) {
      Vector3d jump_mm = Vector3d::Zero();
      for (int i = 0; i < 4; ++i) {
        if (cell.jump[i] >= 0) jump_mm += place[i] * jumps_mm[static_cast<std::size_t>(cell.jump[i])];
      }
      largest_mm = std::max(largest_mm, jump_mm.norm());
    }
  }
  return largest_mm;
}

Result<mechanics::StaticResult> SessionBody::whole_result(const BodyState& state) const {
  if (const auto* large = std::get_if<LiveBody>(&body_)) return large->whole_result(*std::get<LargeState>(state));
  if (const auto* moving = std::get_if<MovingBody>(&body_)) return moving->whole_result(*std::get<MovedState>(state));
  if (const auto* moving = std::get_if<MovingLiveBody>(&body_)) {
    return moving->whole_result(*std::get<MovedLargeState>(state));
  }
  return std::get<ContactBody>(body_).whole_result(*std::get<SmallState>(state));
}

const geometry::Surface& SessionBody::surface() const {
  return std::visit([](const auto& body) -> const geometry::Surface& { return body.surface(); }, body_);
}

const std::vector<Vector3d>& surface_mm(const BodyState& state) {
  return std::visit([](const auto& body) -> const std::vector<Vector3d>& { return body->surface_mm; }, state);
}

const std::vector<Vector3d>& watched_mm(const BodyState& state) {
  return std::visit([](const auto& body) -> const std::vector<Vector3d>& { return body->watched_mm; }, state);
}

SessionStep step_of(const BodyState& state, const std::vector<ContactTool>& tools, const geometry::Surface& surface) {
  SessionStep step;
  std::visit(
      [&](const auto& body) {
        step.report = body->report;
        step.tools = body->tools;
      },
      state);
  step.torque_mNmm = moment_uJ(state, surface);
  for (std::size_t t = 0; t < step.tools.size() && t < tools.size(); ++t) {
    step.torque_mNmm -= place_mm(tools[t], step.tools[t].advance_mm).cross(step.tools[t].force_mN);
  }
  if (const LiveState* large = live_in(state)) {
    step.error_bound_mm = large->error_bound_mm;
    step.settled = large->settled || std::holds_alternative<MovedLargeState>(state);  // in motion time goes on
  }
  return step;
}

std::optional<SessionMotion> motion_of(const BodyState& state) {
  const mechanics::Movement* moved = nullptr;
  if (const auto* small = std::get_if<MovedState>(&state)) moved = small->get();
  if (const auto* large = std::get_if<MovedLargeState>(&state)) moved = large->get();
  if (moved == nullptr) return {};
  return SessionMotion{moved->time_s, moved->largest_speed_mm_s, moved->moves};
}

std::string bits_of(const BodyState& state, std::size_t judged) {
  std::string bits;
  const auto add = [&](const double* values, std::size_t count) {
    bits.append(reinterpret_cast<const char*>(values), count * sizeof(double));
  };
  if (const auto* moved = std::get_if<MovedLargeState>(&state)) {
    add((*moved)->v_mm_s.data(), static_cast<std::size_t>((*moved)->v_mm_s.size()));
  }
  if (const LiveState* large = live_in(state)) {
    add(large->u_mm.data(), static_cast<std::size_t>(large->u_mm.size()));
    for (const mechanics::LivePlace& place : large->places) {
      add(&place.multiplier_mN, 1);
      if (place.anchor_mm) add(place.anchor_mm->data(), 3);
    }
    add(large->wall_mN.data(), large->wall_mN.size());
    return bits;
  }
  if (const auto* moved = std::get_if<MovedState>(&state)) {
    add((*moved)->u_mm.data(), static_cast<std::size_t>((*moved)->u_mm.size()));
    add((*moved)->v_mm_s.data(), static_cast<std::size_t>((*moved)->v_mm_s.size()));
    return bits;
  }
  const ContactState& small = *std::get<SmallState>(state);
  for (const Vector3d& u : small.surface_mm) add(u.data(), 3);
  for (std::size_t w = 0; w < judged; ++w) add(small.watched_mm[w].data(), 3);
  for (const auto& [point, force] : small.force_mN) add(force.data(), 3);
  for (const Vector3d& jump : small.jumps_mm) add(jump.data(), 3);
  return bits;
}

namespace {

Result<void> check_contact(const mechanics::ContactReport& report) {
  if (report.converged) return {};
  return failure(
      "not-converged",
      GLISSON_TEXT("The step did not converge: after {0} rounds a tool still reaches {1} mm into the "
                   "surface, which still moves by {2} mm."),
      {std::to_string(report.rounds), std::to_string(report.penetration_mm), std::to_string(report.movement_mm)});
}

// Of all tools, about the origin.
Vector3d moment_uJ(const BodyState& state, const geometry::Surface& surface) {
  if (const LiveState* large = live_in(state)) return large->moment_uJ;
  const ContactState& small = contact_in(state);
  Vector3d sum = Vector3d::Zero();
  for (const auto& [point, force] : small.force_mN) {
    const auto p = static_cast<std::size_t>(point);
    sum += (surface.points_mm[p] + small.surface_mm[p]).cross(force);
  }
  return sum;
}

Vector3d place_mm(const ContactTool& tool, double advance_mm) {
  if (const auto* touching = std::get_if<TouchingTool>(&tool.what)) {
    return touching->pose.advanced(advance_mm).position_mm;
  }
  if (const auto* patch = std::get_if<mechanics::ToolLoad>(&tool.what)) return patch->center_mm;
  const auto& grasp = std::get<Grasp>(tool.what);
  const auto* drawn_mm = std::get_if<Vector3d>(&grasp.drawn);
  return grasp.at_rest_mm + (drawn_mm == nullptr ? Vector3d(0, 0, 0) : *drawn_mm);
}

}  // namespace
}  // namespace glisson::rehearsal

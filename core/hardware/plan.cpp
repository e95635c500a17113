#include "hardware/plan.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <functional>

namespace glisson::hardware {
namespace {

constexpr double hour_s = 3600;

Headroom headroom_of(const Device& device, const PlanRequest& request);
std::vector<Reason> reasons_against(const DevicePlan& answer, const Device& device, const Workload& workload,
                                    const PlanRequest& request);
Remedies remedies_for(const Device& device, const DevicePlan& answer, const Workload& workload,
                      const PlanRequest& request, const ConvergenceCurve& curve);
std::optional<std::string> least_obtrusive(const std::vector<DevicePlan>& platforms);
std::vector<Sentence> notes_on(const Plan& plan, const ConvergenceCurve& curve);
std::vector<Sentence> notes_on_headroom(const Plan& plan, std::vector<Sentence> notes);
double hours_on_battery(const Device& device, double device_W, double ambient_C);
double rounded_W(double power_W) { return std::round(power_W * 100) / 100; }

}  // namespace

Result<Plan> plan(const PlanRequest& request, const std::vector<Device>& devices, const ConvergenceCurve& curve) {
  if (const auto checked = check(request); !checked) return failure(checked.error());
  const ConvergenceCurve here = request.youngs_kPa ? in_tissue(curve, *request.youngs_kPa) : curve;
  const auto workload =
      request.task ? workload_of(*request.task)
                   : workload_for_accuracy(request.liver_volume_cm3, request.accuracy_mm, here, request.workload);
  if (!workload) return failure(workload.error());

  Plan planned;
  planned.request = request;
  planned.workload = *workload;
  for (const Device& device : devices) {
    DevicePlan answer = answer_for(device, *workload, request);
    if (!answer.feasible) answer.remedies = remedies_for(device, answer, *workload, request, here);
    answer.assumed = assumed_figures(device);
    answer.certainty = certainty_of(device, *workload, request);
    planned.platforms.push_back(std::move(answer));
  }
  planned.recommended = least_obtrusive(planned.platforms);
  planned.notes = notes_on(planned, here);
  return planned;
}

DevicePlan answer_for(const Device& device, const Workload& workload, const PlanRequest& request) {
  DevicePlan answer;
  answer.id = device.id;
  answer.name = device.name;
  answer.worn = device.worn;
  answer.idle = headroom_of(device, request);

  answer.frame_joules = product_cost(device, workload).joules * workload.products_per_frame;
  const double duration_s = request.duration_h * hour_s;
  answer.fps_by_computing = fastest_frames_per_s(device, workload);
  const auto fps_within = [&](double allowed_W) {
    const double spare_W = allowed_W - device.idle_W.value;
    if (spare_W <= 0) return 0.0;
    // A device that costs nothing above idle is bound by computing alone.
    return spare_W >= answer.frame_joules * answer.fps_by_computing ? answer.fps_by_computing
                                                                    : spare_W / answer.frame_joules;
  };
  // A governor keeps the surface where it is by computing less.
  answer.fps_by_computing =
      fps_within(largest_power_W(heat_of(device), request.ambient_C, device.throttle_C.value, duration_s));
  answer.fps_by_energy = fps_within(answer.idle.allowed_W * device.supply_efficiency.value);
  answer.fps_by_temperature =
      fps_within(largest_power_W(heat_of(device), request.ambient_C, request.limit_C, duration_s));
  answer.fps = std::min({answer.fps_by_computing, answer.fps_by_energy, answer.fps_by_temperature});

  answer.power_W = power_W(device, workload, std::min(request.frames_per_s, answer.fps_by_computing));
  answer.battery_h = hours_on_battery(device, answer.power_W, request.ambient_C);
  answer.temperature_C =
      temperature_after_C(heat_of(device), request.ambient_C, answer.power_W, request.ambient_C, duration_s);
  answer.reasons = reasons_against(answer, device, workload, request);
  answer.feasible = answer.reasons.empty();
  return answer;
}

Certainty certainty_of(const Device& device, const Workload& workload, const PlanRequest& request) {
  constexpr std::uint64_t draws = 200;
  std::vector<double> fps;
  double holding = 0;
  for (std::uint64_t draw = 0; draw < draws; ++draw) {
    const DevicePlan answer = answer_for(drawn(device, draw), workload, request);
    holding += answer.feasible ? 1 : 0;
    fps.push_back(answer.fps);
  }
  std::sort(fps.begin(), fps.end());
  return {holding / draws, fps[draws / 10], fps[draws - 1 - draws / 10]};
}

Result<void> check(const PlanRequest& request) {
  const auto refuse = [](const char* what, double value, double minimum, double maximum) {
    return failure(Error{"request-invalid",
                         GLISSON_TEXT("{0} of {1} is not between {2} and {3}."),
                         {what, fmt::format("{:g}", value), fmt::format("{:g}", minimum), fmt::format("{:g}", maximum)},
                         GLISSON_TEXT("Correct the question."),
                         {}});
  };
  struct Bound {
    const char* what;
    double value, minimum, maximum;
  };
  const Bound bounds[] = {
      {"A frame rate (1/s)", request.frames_per_s, 0.1, 240},
      {"A duration (h)", request.duration_h, 0.1, 48},
      {"An ambient temperature (C)", request.ambient_C, -20, 60},
      {"A temperature limit (C)", request.limit_C, 20, 100},
      {"A Young's modulus (kPa)", request.youngs_kPa.value_or(12), 0.1, 1000},
  };
  // Written so that NaN is refused as well.
  for (const Bound& bound : bounds) {
    if (!(bound.value >= bound.minimum && bound.value <= bound.maximum))
      return refuse(bound.what, bound.value, bound.minimum, bound.maximum);
  }
  if (request.limit_C <= request.ambient_C) {
    return failure(Error{"request-invalid",
                         GLISSON_TEXT("A room of {0} C is not cooler than the limit of {1} C."),
                         {fmt::format("{:g}", request.ambient_C), fmt::format("{:g}", request.limit_C)},
                         GLISSON_TEXT("Correct the question."),
                         {}});
  }
  return {};
}

std::string to_string(Constraint constraint) {
  switch (constraint) {
    case Constraint::idle_energy: return "idle-energy";
    case Constraint::idle_temperature: return "idle-temperature";
    case Constraint::computing: return "computing";
    case Constraint::throttling: return "throttling";
    case Constraint::energy: return "energy";
    case Constraint::temperature: return "temperature";
  }
  return "computing";
}

namespace {

double hours_on_battery(const Device& device, double device_W, double ambient_C) {
  const auto drained = drain(battery_of(device), device_W / device.supply_efficiency.value, ambient_C);
  return drained ? drained->hours : 0;
}

Headroom headroom_of(const Device& device, const PlanRequest& request) {
  Headroom idle;
  idle.idle_W = device.idle_W.value / device.supply_efficiency.value;
  idle.allowed_W = largest_load_W(battery_of(device), request.duration_h, request.ambient_C);
  idle.headroom_W = idle.allowed_W - idle.idle_W;
  idle.idle_h = hours_on_battery(device, device.idle_W.value, request.ambient_C);
  idle.idle_C = temperature_after_C(heat_of(device), request.ambient_C, device.idle_W.value, request.ambient_C,
                                    request.duration_h * hour_s);
  return idle;
}

std::vector<Reason> reasons_against(const DevicePlan& answer, const Device& device, const Workload& workload,
                                    const PlanRequest& request) {
  const auto short_number = [](double value) { return fmt::format("{:.3g}", value); };
  std::vector<Reason> reasons;
  if (answer.idle.headroom_W < 0) {
    reasons.push_back(
        {Constraint::idle_energy,
         {GLISSON_TEXT("It draws {0} W when idle; its battery allows {1} W over {2} h, and is empty after "
                       "{3} h without computing anything."),
          {short_number(answer.idle.idle_W), short_number(answer.idle.allowed_W), short_number(request.duration_h),
           short_number(answer.idle.idle_h)}}});
  } else if (answer.battery_h < request.duration_h) {
    reasons.push_back({Constraint::energy,
                       {GLISSON_TEXT("Its battery is empty after {0} h of {1} h: only {2} W of headroom over idling."),
                        {short_number(answer.battery_h), short_number(request.duration_h),
                         fmt::format("{:g}", rounded_W(answer.idle.headroom_W))}}});
  }
  if (answer.idle.idle_C > request.limit_C) {
    reasons.push_back({Constraint::idle_temperature,
                       {GLISSON_TEXT("It reaches {0} C when idle; the limit is {1} C."),
                        {short_number(answer.idle.idle_C), short_number(request.limit_C)}}});
  } else if (answer.temperature_C > request.limit_C) {
    reasons.push_back({Constraint::temperature,
                       {GLISSON_TEXT("It reaches {0} C; the limit is {1} C."),
                        {short_number(answer.temperature_C), short_number(request.limit_C)}}});
  }
  if (fastest_frames_per_s(device, workload) >= request.frames_per_s &&
      answer.fps_by_computing < request.frames_per_s) {
    reasons.push_back({Constraint::throttling,
                       {GLISSON_TEXT("It slows itself down at {0} C, and then computes {1} frames a second of {2}."),
                        {short_number(device.throttle_C.value), short_number(answer.fps_by_computing),
                         short_number(request.frames_per_s)}}});
  } else if (answer.fps_by_computing < request.frames_per_s) {
    reasons.push_back({Constraint::computing,
                       {GLISSON_TEXT("It computes {0} frames a second of {1}."),
                        {short_number(answer.fps_by_computing), short_number(request.frames_per_s)}}});
  }
  return reasons;
}

bool fails_by(const DevicePlan& answer, std::initializer_list<Constraint> constraints) {
  return std::any_of(answer.reasons.begin(), answer.reasons.end(), [&](const Reason& reason) {
    return std::find(constraints.begin(), constraints.end(), reason.constraint) != constraints.end();
  });
}

// The least (or most) value between two for which `holds`, which must hold at `good` and not at `bad`.
double last_that_holds(double good, double bad, const std::function<bool(double)>& holds) {
  for (int halving = 0; halving < 50; ++halving) {
    const double middle = (good + bad) / 2;
    (holds(middle) ? good : bad) = middle;
  }
  return good;
}

std::optional<double> coarser_accuracy_mm(const Device& device, const PlanRequest& request,
                                          const ConvergenceCurve& curve) {
  const auto holds = [&](double accuracy_mm) {
    const auto coarser = workload_for_accuracy(request.liver_volume_cm3, accuracy_mm, curve, request.workload);
    return coarser && answer_for(device, *coarser, request).feasible;
  };
  const double coarsest_mm = curve.points.back().error_mm;
  if (request.task) return {};
  if (coarsest_mm <= request.accuracy_mm || !holds(coarsest_mm)) return {};
  return last_that_holds(coarsest_mm, request.accuracy_mm, holds);
}

std::optional<double> larger_battery_Wh(const Device& device, const DevicePlan& answer, const PlanRequest& request) {
  const double load_W = answer.power_W / device.supply_efficiency.value;
  const Battery given = battery_of(device);
  const auto holds = [&](double energy_Wh) {
    Battery larger = given;
    larger.capacity_Ah = energy_Wh / given.nominal_voltage_V;
    const auto drained = drain(larger, load_W, request.ambient_C);
    return drained && drained->hours >= request.duration_h;
  };
  const double maximum_Wh = 10 * load_W * request.duration_h;  // worse than that, a larger battery is not the cure
  if (!holds(maximum_Wh)) return {};
  return last_that_holds(maximum_Wh, given.energy_Wh(), holds);
}

// Warming is in proportion to the resistance. A device that no longer throttles may empty its battery: then none.
std::optional<double> better_heat_sink_C_per_W(const Device& device, const Workload& workload,
                                               const PlanRequest& request) {
  const double warming_C = temperature_after_C(heat_of(device), 0, power_W(device, workload, request.frames_per_s), 0,
                                               request.duration_h * hour_s);
  const double allowed_C = std::min(request.limit_C, device.throttle_C.value) - request.ambient_C;
  const double found = device.thermal_resistance_C_per_W.value * allowed_C / warming_C;
  Device cooler = device;
  cooler.thermal_resistance_C_per_W.value = found * (1 - 1e-9);
  if (!answer_for(cooler, workload, request).feasible) return {};
  return found;
}

Remedies remedies_for(const Device& device, const DevicePlan& answer, const Workload& workload,
                      const PlanRequest& request, const ConvergenceCurve& curve) {
  Remedies remedies;
  const bool throttled = fails_by(answer, {Constraint::throttling});
  const bool computes = !throttled && !fails_by(answer, {Constraint::computing});
  const bool lasts = !fails_by(answer, {Constraint::energy, Constraint::idle_energy});
  const bool stays_cool = !fails_by(answer, {Constraint::temperature, Constraint::idle_temperature});

  if (answer.fps > 0) remedies.frames_per_s = answer.fps;
  if (computes) {
    const double until_hot_s =
        time_to_reach_s(heat_of(device), request.ambient_C, answer.power_W, request.ambient_C, request.limit_C);
    const double longest_h = std::min(answer.battery_h, until_hot_s / hour_s);
    if (longest_h > 0) remedies.duration_h = longest_h;
  }
  if (answer.idle.headroom_W >= 0 && answer.idle.idle_C <= request.limit_C)
    remedies.accuracy_mm = coarser_accuracy_mm(device, request, curve);
  if (computes && stays_cool) remedies.battery_Wh = larger_battery_Wh(device, answer, request);
  if (lasts && (throttled || (computes && !stays_cool)))
    remedies.thermal_resistance_C_per_W = better_heat_sink_C_per_W(device, workload, request);
  return remedies;
}

std::optional<std::string> least_obtrusive(const std::vector<DevicePlan>& platforms) {
  const DevicePlan* best = nullptr;
  for (const DevicePlan& answer : platforms) {
    if (!answer.feasible) continue;
    const bool better = best == nullptr || answer.worn < best->worn ||
                        (answer.worn == best->worn && answer.temperature_C < best->temperature_C);
    if (better) best = &answer;
  }
  if (best == nullptr) return {};
  return best->id;
}

std::vector<Sentence> notes_on(const Plan& planned, const ConvergenceCurve& curve) {
  std::vector<Sentence> notes;
  const PlanRequest& request = planned.request;
  if (request.task) {
    notes.push_back(
        {GLISSON_TEXT("A frame is this program's own: {0}. Carried over from another machine in proportion to "
                      "memory and arithmetic; nobody has run it on these platforms."),
         {request.task->what}});
    return notes_on_headroom(planned, std::move(notes));
  }
  notes.push_back({GLISSON_TEXT("The resolution for {0} mm in tissue of {1} kPa comes from this curve ({2}): {3}"),
                   {fmt::format("{:g}", request.accuracy_mm), fmt::format("{:.3g}", curve.youngs_kPa),
                    to_string(curve.source), curve.provenance}});
  if (request.accuracy_mm > curve.points.back().error_mm) {
    notes.push_back({GLISSON_TEXT("{0} mm is coarser than the convergence study reaches; planned is its coarsest "
                                  "resolution, {1} mm3 a node."),
                     {fmt::format("{:g}", request.accuracy_mm), fmt::format("{:g}", planned.workload.resolution_mm3)}});
  }
  if (request.workload.nodes_in_domain == 1) {
    WorkloadOptions coupled = request.workload;
    coupled.nodes_in_domain = 27;
    const auto work = workload_at_resolution(request.liver_volume_cm3, planned.workload.resolution_mm3, coupled);
    GLISSON_ASSERT(work.has_value());
    notes.push_back({GLISSON_TEXT("A frame is {0} block products as in the dissertation, without the vector updates of "
                                  "conjugate gradients; a simulation that couples 27 nodes moves {1} times as much."),
                     {std::to_string(request.workload.products_per_frame),
                      fmt::format("{:.0f}", work->bytes_per_node / planned.workload.bytes_per_node)}});
  }
  return notes_on_headroom(planned, std::move(notes));
}

std::vector<Sentence> notes_on_headroom(const Plan& planned, std::vector<Sentence> notes) {
  const PlanRequest& request = planned.request;
  for (const DevicePlan& answer : planned.platforms) {
    if (!answer.feasible || answer.idle.headroom_W > 0.1 * answer.idle.allowed_W) continue;
    notes.push_back({GLISSON_TEXT("{0} holds with next to no headroom: its battery allows {1} W over {2} h, and idling "
                                  "takes {3} W of them."),
                     {answer.name, fmt::format("{:.3g}", answer.idle.allowed_W),
                      fmt::format("{:g}", request.duration_h), fmt::format("{:.3g}", answer.idle.idle_W)}});
  }
  return notes;
}

}  // namespace
}  // namespace glisson::hardware

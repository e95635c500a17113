// glisson-cli platform list: the devices, with where each figure comes from.
// glisson-cli platform plan: which of them holds for a case, why the others fail, what would have to give.

#include <fmt/format.h>
#include <algorithm>

#include "base/files.h"
#include "casefile/model.h"
#include "geometry/tetrahedra.h"
#include "platform_commands.h"

namespace glisson::cli {

using namespace hardware;

void DeviceTables::add_options(CLI::App& command) {
  command.add_option("--devices", files, "Further device tables (JSON); theirs take the place of shipped ones");
  command.add_option("--convergence", convergence_file, "Convergence curve (JSON) in place of the shipped one");
}

Result<std::vector<Device>> DeviceTables::devices() const {
  const auto resources = resource_folder();
  if (!resources) return failure(resources.error());
  auto devices = read_devices(*resources / "devices" / "devices.json");
  for (const std::string& file : files) {
    if (!devices) break;
    auto more = read_devices(file);
    if (!more) return failure(more.error());
    take_in(std::move(*more), *devices);
  }
  return devices;
}

Result<ConvergenceCurve> DeviceTables::curve() const {
  if (!convergence_file.empty()) return read_convergence_curve(convergence_file);
  return resource_folder().and_then(
      [](const auto& resources) { return read_convergence_curve(resources / "devices" / "convergence.json"); });
}

Result<Device> device_with_id(const std::vector<Device>& devices, const std::string& id) {
  const auto found =
      std::find_if(devices.begin(), devices.end(), [&](const Device& device) { return device.id == id; });
  if (found != devices.end()) return *found;
  return failure(Error{"device-unknown",
                       GLISSON_TEXT("There is no device \"{0}\"."),
                       {id},
                       GLISSON_TEXT("glisson-cli platform list shows their ids."),
                       {}});
}

void add_request_options(CLI::App& command, PlanRequest& request) {
  command.add_option("--hours", request.duration_h, "How long the operation takes")->capture_default_str();
  command.add_option("--ambient-C", request.ambient_C, "Temperature of the room")->capture_default_str();
  command.add_option("--limit-C", request.limit_C, "Hottest surface a person should wear")->capture_default_str();
  command
      .add_option("--domain-nodes", request.workload.nodes_in_domain,
                  "Nodes that a block couples: 1 as the dissertation's blocks, 27 for all neighbours")
      ->capture_default_str();
  command.add_option("--iterations", request.workload.products_per_frame, "Block products a frame")
      ->capture_default_str();
}

namespace {

constexpr const char* dissertation_task = "product";

double idle_hours(const Device& device) {
  return battery_of(device).energy_Wh() * device.supply_efficiency.value / device.idle_W.value;
}

Json as_json(const Figure& figure) {
  return {{"value", figure.value}, {"source", to_string(figure.source)}, {"note", figure.note}};
}

Json as_json(const Device& device) {
  Json figures = Json::object();
  for (const NamedFigure& named : figures_of(device)) figures[named.name] = as_json(named.figure);
  return {{"id", device.id},
          {"name", device.name},
          {"worn", to_string(device.worn)},
          {"worn_how", device.worn_how},
          {"battery_Wh", battery_of(device).energy_Wh()},
          {"idle_h", idle_hours(device)},
          {"figures", figures},
          {"assumed", assumed_figures(device)}};
}

Outcome describe(const std::vector<Device>& devices) {
  Outcome outcome{{{"platforms", Json::array()}}, {}};
  outcome.text =
      fmt::format("{:20} {:5} {:>7} {:>9} {:>8}  {}\n", "id", "worn", "idle W", "battery", "at idle", "name");
  for (const Device& device : devices) {
    outcome.document["platforms"].push_back(as_json(device));
    outcome.text +=
        fmt::format("{:20} {:5} {:7.3g} {:6.3g} Wh {:6.2g} h  {} ({} of its {} figures are assumed)\n", device.id,
                    to_string(device.worn), device.idle_W.value, battery_of(device).energy_Wh(), idle_hours(device),
                    device.name, assumed_figures(device).size(), figures_of(device).size());
  }
  outcome.text += "Every figure with its source: --json, or --device ID.\n";
  return outcome;
}

Outcome describe(const Device& device) {
  Outcome outcome{{{"platforms", {as_json(device)}}}, {}};
  outcome.text = fmt::format("{}, worn on the {}: {}\n", device.name, to_string(device.worn), device.worn_how);
  for (const NamedFigure& named : figures_of(device)) {
    outcome.text += fmt::format("  {:32} {:10.5g}  {:12}  {}\n", named.name, named.figure.value,
                                to_string(named.figure.source), named.figure.note);
  }
  if (!device.kernel.measured.empty()) {
    outcome.text += fmt::format("  {} block products timed, {} to {} nodes\n", device.kernel.measured.size(),
                                device.kernel.measured.front().nodes, device.kernel.measured.back().nodes);
  }
  return outcome;
}

struct Remedy {
  const char* key;
  std::optional<double> value;
  const char* sentence;
};

std::vector<Remedy> listed(const Remedies& remedies) {
  return {{"duration_h", remedies.duration_h, "an operation of at most {:.3g} h"},
          {"fps", remedies.frames_per_s, "at most {:.3g} frames a second"},
          {"accuracy_mm", remedies.accuracy_mm, "an accuracy of {:.3g} mm"},
          {"battery_Wh", remedies.battery_Wh, "a battery of {:.3g} Wh"},
          {"thermal_resistance_C_per_W", remedies.thermal_resistance_C_per_W, "a heat sink of {:.3g} C/W"}};
}

Json as_json(const DevicePlan& answer) {
  Json reasons = Json::array();
  Json limits = Json::array();
  for (const Reason& reason : answer.reasons) {
    reasons.push_back(reason.sentence.message());
    limits.push_back(to_string(reason.constraint));
  }
  Json remedies = Json::object();
  for (const Remedy& remedy : listed(answer.remedies)) {
    if (remedy.value) remedies[remedy.key] = *remedy.value;
  }
  return {{"id", answer.id},
          {"name", answer.name},
          {"worn", to_string(answer.worn)},
          {"idle",
           {{"power_W", answer.idle.idle_W},
            {"allowed_W", answer.idle.allowed_W},
            {"headroom_W", answer.idle.headroom_W},
            {"battery_h", answer.idle.idle_h},
            {"temperature_C", answer.idle.idle_C}}},
          {"feasible", answer.feasible},
          {"holds_probability", answer.certainty.holds},
          {"fps_interval", {answer.certainty.fps_low, answer.certainty.fps_high}},
          {"fps", answer.fps},
          {"fps_by_computing", answer.fps_by_computing},
          {"fps_by_energy", answer.fps_by_energy},
          {"fps_by_temperature", answer.fps_by_temperature},
          {"power_W", answer.power_W},
          {"frame_J", answer.frame_joules},
          {"battery_h", answer.battery_h},
          {"temperature_C", answer.temperature_C},
          {"reasons", reasons},
          {"limits", limits},
          {"would_hold_with", remedies},
          {"assumed", answer.assumed}};
}

std::string sentences_on(const DevicePlan& answer) {
  std::string text;
  for (const Reason& reason : answer.reasons) text += "    " + reason.sentence.message() + "\n";
  std::string alternatives;
  for (const Remedy& remedy : listed(answer.remedies)) {
    if (remedy.value)
      alternatives += (alternatives.empty() ? "" : ", or ") + fmt::format(fmt::runtime(remedy.sentence), *remedy.value);
  }
  if (answer.feasible) return text;
  return text + "    It would hold with " + (alternatives.empty() ? "nothing that is one figure alone" : alternatives) +
         ".\n";
}

Outcome describe(const Plan& planned) {
  const Workload& work = planned.workload;
  Outcome outcome;
  outcome.document["case"] = {{"volume_cm3", planned.request.liver_volume_cm3}};
  if (planned.request.youngs_kPa) outcome.document["case"]["youngs_kPa"] = *planned.request.youngs_kPa;
  outcome.document["workload"] = {{"resolution_mm3", work.resolution_mm3},
                                  {"nodes", work.nodes},
                                  {"block", {work.block_rows, work.block_columns}},
                                  {"products_per_frame", work.products_per_frame},
                                  {"product_bytes", work.product_bytes},
                                  {"product_flops", work.product_flops},
                                  {"frame_bytes", work.frame_bytes},
                                  {"frame_flops", work.frame_flops}};
  if (planned.request.task) {
    outcome.document["workload"] = {{"task", planned.request.task->id},
                                    {"what", planned.request.task->what},
                                    {"frame_bytes", work.frame_bytes},
                                    {"frame_flops", work.frame_flops}};
  }
  const std::string asked = planned.request.task
                                ? planned.request.task->what
                                : fmt::format("{:.0f} nodes of {:.3g} mm3", work.nodes, work.resolution_mm3);
  outcome.text = fmt::format(
      "{}; a frame moves {:.3g} MB and takes {:.3g} million operations.\n\n"
      "Idle first: what the battery allows over {:g} h, and what the device draws when it does nothing.\n",
      asked, work.frame_bytes * 1e-6, work.frame_flops * 1e-6, planned.request.duration_h);
  for (const DevicePlan& answer : planned.platforms) {
    outcome.text +=
        fmt::format("  {:20} {:5} {:7.3g} W allowed, {:5.3g} W idle: {:+.2g} W\n", answer.id, to_string(answer.worn),
                    answer.idle.allowed_W, answer.idle.idle_W, answer.idle.headroom_W);
  }
  outcome.text +=
      fmt::format("\nAt {:g} frames a second (or the fastest it computes):\n", planned.request.frames_per_s);
  outcome.document["platforms"] = Json::array();
  for (const DevicePlan& answer : planned.platforms) {
    outcome.document["platforms"].push_back(as_json(answer));
    outcome.text += fmt::format(
        "  {:20} {:6} {:6.3g} W  {:6.3g} h  {:5.3g} C  up to {:.3g} frames/s ({:.3g} to {:.3g}); holds with {:.0f} %\n",
        answer.id, answer.feasible ? "holds" : "fails", answer.power_W, answer.battery_h, answer.temperature_C,
        answer.fps, answer.certainty.fps_low, answer.certainty.fps_high, 100 * answer.certainty.holds);
    outcome.text += sentences_on(answer);
  }
  outcome.document["recommended"] = planned.recommended ? Json(*planned.recommended) : Json(nullptr);
  outcome.text += planned.recommended ? fmt::format("\nThe least obtrusive that holds: {}\n", *planned.recommended)
                                      : "\nNone of them holds.\n";
  outcome.document["notes"] = Json::array();
  for (const Sentence& note : planned.notes) {
    outcome.document["notes"].push_back(note.message());
    outcome.text += "Note: " + note.message() + "\n";
  }
  outcome.text +=
      "A plan is no better than what is assumed in it; where each figure comes from: glisson-cli platform list "
      "--device ID\n";
  return outcome;
}

// Volume and mean Young's modulus of the case's model, where the person gave none.
Result<void> take_over(const std::string& case_folder, bool volume_given, PlanRequest& request) {
  const auto model = casefile::Case::open(case_folder).and_then([](const casefile::Case& patient) {
    return casefile::read_model(patient);
  });
  if (!model) return failure(model.error());
  const double volume_mm3 = geometry::volume_mm3(model->mesh);
  if (!volume_given) request.liver_volume_cm3 = volume_mm3 * 1e-3;
  if (request.youngs_kPa) return {};
  double sum = 0;
  const std::vector<double>& youngs_kPa = casefile::youngs_kPa(*model);
  for (std::size_t c = 0; c < youngs_kPa.size(); ++c) sum += youngs_kPa[c] * geometry::cell_volume_mm3(model->mesh, c);
  request.youngs_kPa = sum / volume_mm3;
  return {};
}

// Of the shipped tasks or of a file's.
Result<Task> task_with_id(const std::string& file, const std::string& id) {
  auto tasks = !file.empty() ? read_tasks(file) : resource_folder().and_then([](const auto& resources) {
    return read_tasks(resources / "devices" / "tasks.json");
  });
  if (!tasks) return failure(tasks.error());
  std::string known;
  for (Task& task : *tasks) {
    if (task.id == id) return std::move(task);
    known += (known.empty() ? "" : ", ") + task.id;
  }
  return failure(Error{"task-unknown",
                       GLISSON_TEXT("There is no task \"{0}\"."),
                       {id, known},
                       GLISSON_TEXT("Use product or one of: {1}."),
                       {}});
}

}  // namespace

void add_platform_list(CLI::App& platform, Action& chosen) {
  struct Options {
    DeviceTables tables;
    std::string device;
  };
  CLI::App* command = platform.add_subcommand("list", "The devices, with where each figure comes from");
  auto options = std::make_shared<Options>();
  command->add_option("--devices", options->tables.files, "Further device tables (JSON)");
  command->add_option("--device", options->device, "One of them, with all its figures");
  command->callback([&chosen, options] {
    chosen = [options](const Progress&) -> Result<Outcome> {
      const auto devices = options->tables.devices();
      if (!devices) return failure(devices.error());
      if (options->device.empty()) return describe(*devices);
      return device_with_id(*devices, options->device).map([](const Device& device) { return describe(device); });
    };
  });
}

void add_platform_plan(CLI::App& platform, Action& chosen) {
  struct Options {
    DeviceTables tables;
    PlanRequest request;
    std::optional<std::string> case_folder;
    std::string task = dissertation_task;
    std::string tasks_file;
  };
  CLI::App* command =
      platform.add_subcommand("plan", "The least obtrusive platform that holds for a case, and why others fail");
  auto options = std::make_shared<Options>();
  command->add_option("case", options->case_folder, "A case with a model: its liver's volume and mean stiffness");
  CLI::Option* volume =
      command->add_option("--volume-cm3", options->request.liver_volume_cm3, "Volume of the liver, or the case's");
  command->add_option("--stiffness-kPa", options->request.youngs_kPa,
                      "Mean Young's modulus of the liver; the convergence study's own where neither says");
  CLI::Option* accuracy = command->add_option("--accuracy-mm", options->request.accuracy_mm, "Wanted accuracy");
  command
      ->add_option(
          "--for", options->task,
          "What is computed: product (the dissertation's block products), or a task of this program: rehearse, "
          "rehearse-large-strain, rehearse-meshfree, guide, match")
      ->capture_default_str();
  command->add_option("--tasks", options->tasks_file, "Tasks (JSON) in place of the shipped ones: platform measure");
  command->add_option("--fps", options->request.frames_per_s, "Wanted frames a second")->capture_default_str();
  add_request_options(*command, options->request);
  options->tables.add_options(*command);
  command->callback([&chosen, options, volume, accuracy] {
    const bool volume_given = volume->count() > 0;
    const bool own_task = options->task != dissertation_task;
    if (!own_task && !options->case_folder && !volume_given) throw CLI::RequiredError("a case or --volume-cm3");
    if (!own_task && accuracy->count() == 0) throw CLI::RequiredError("--accuracy-mm");
    chosen = [options, volume_given](const Progress&) -> Result<Outcome> {
      PlanRequest request = options->request;
      if (options->case_folder) {
        const auto taken = take_over(*options->case_folder, volume_given, request);
        if (!taken) return failure(taken.error());
      }
      const auto devices = options->tables.devices();
      if (!devices) return failure(devices.error());
      const auto curve = options->tables.curve();
      if (!curve) return failure(curve.error());
      if (options->task != dissertation_task) {
        auto task = task_with_id(options->tasks_file, options->task);
        if (!task) return failure(task.error());
        request.task = std::move(*task);
      }
      return plan(request, *devices, *curve).map([](const Plan& planned) { return describe(planned); });
    };
  });
}

}  // namespace glisson::cli

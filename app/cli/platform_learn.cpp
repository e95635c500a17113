// glisson-cli platform learn: what explain found in a platform's recordings, or what one recording of its power shows,
// as a device to plan with and to share.

#include <fmt/format.h>
#include <algorithm>

#include "closedloop/learnt_device.h"
#include "hardware/measure.h"
#include "platform_commands.h"

namespace glisson::cli {
namespace {

struct PlatformLearnCommand {
  DeviceTables tables;
  std::string device;
  std::string model;
  TraceChoice trace;
  std::string id;
  std::string out;
};

// Idle and active power of a recording, in place of what was declared.
Result<closedloop::LearntDevice> learn_from(const hardware::TraceRuns& runs, const hardware::Device& declared) {
  closedloop::LearntDevice learnt{declared, {"idle_W"}, runs.warnings};
  hardware::take_power_from(runs, learnt.device);
  if (!runs.runs.empty()) learnt.changed.emplace_back("kernel.active_W");
  if (const auto checked = hardware::check(learnt.device); !checked) return failure(checked.error());
  return learnt;
}

Result<Outcome> run(const PlatformLearnCommand& options) {
  const auto devices = options.tables.devices();
  if (!devices) return failure(devices.error());
  const auto declared = device_with_id(*devices, options.device);
  if (!declared) return failure(declared.error());
  std::optional<hardware::TraceRuns> runs;
  if (!options.trace.file.empty()) {
    auto found = options.trace.runs();
    if (!found) return failure(found.error());
    runs = std::move(*found);
  }
  auto learnt = runs ? learn_from(*runs, *declared) : closedloop::learn_device(*declared, options.model);
  if (!learnt) return failure(learnt.error());
  learnt->device.id = options.id.empty() ? declared->id + "-learnt" : options.id;
  if (const auto written = hardware::write_devices(options.out, {learnt->device}); !written)
    return failure(written.error());
  Outcome outcome{
      {{"device", learnt->device.id}, {"changed", Json::object()}, {"remarks", Json::array()}, {"out", options.out}},
      {}};
  if (runs) outcome.document["trace"] = runs_json(*runs);
  const auto before = hardware::figures_of(*declared);
  const auto after = hardware::figures_of(learnt->device);
  for (std::size_t i = 0; i < after.size(); ++i) {
    if (std::find(learnt->changed.begin(), learnt->changed.end(), after[i].name) == learnt->changed.end()) continue;
    outcome.document["changed"][after[i].name] = {{"before", before[i].figure.value}, {"after", after[i].figure.value}};
    outcome.text +=
        fmt::format("  {:32} {:.4g} -> {:.4g}\n", after[i].name, before[i].figure.value, after[i].figure.value);
  }
  if (learnt->changed.empty()) outcome.text += "  Nothing was learnt that a plan could use.\n";
  for (const hardware::Sentence& remark : learnt->remarks) {
    outcome.document["remarks"].push_back(remark.message());
    outcome.text += "Note: " + remark.message() + "\n";
  }
  outcome.text += fmt::format("Written to {}; plan with it: glisson-cli platform plan --devices {} ...\n", options.out,
                              options.out);
  return outcome;
}

}  // namespace

void add_platform_learn(CLI::App& platform, Action& chosen) {
  CLI::App* command = platform.add_subcommand(
      "learn",
      "A device with what explain found in its recordings (resistance, throttling, ...), or with the power of one");
  auto options = std::make_shared<PlatformLearnCommand>();
  command->add_option("--device", options->device, "The device as it was declared: its id")->required();
  CLI::Option* model = command->add_option("--model", options->model,
                                           "model.json of glisson-cli explain, for an experiment of a platform");
  CLI::Option* trace = options->trace.add_options(*command);
  model->excludes(trace);
  command->add_option("--id", options->id, "The id of the new device; ID-learnt where it is left out");
  command->add_option("--out", options->out, "Where the device is written (JSON)")->required();
  command->add_option("--devices", options->tables.files, "Further device tables (JSON)");
  command->callback([&chosen, options] {
    if (options->model.empty() && options->trace.file.empty()) throw CLI::RequiredError("--model or --trace");
    chosen = [options](const Progress&) { return run(*options); };
  });
}

}  // namespace glisson::cli

// glisson-cli platform measure: this machine, or a recording of another, as a device to plan with and to share.

#include <fmt/format.h>

#include "base/csv.h"
#include "hardware/measure.h"
#include "hardware/opencl_product.h"
#include "platform_commands.h"
#include "shared_options.h"
#include "studies/dissertation/product_tasks.h"

namespace glisson::cli {

using namespace hardware;

namespace {

struct PlatformMeasureCommand {
  MeasureOptions measure;
  std::string out;
  std::string product_case, tasks_out;
  studies::ProductTaskOptions product;
  std::string worn = "back";
  std::optional<std::string> device;  // of OpenCL
  double largest_MB = 1024;
  TraceChoice trace;
  std::string run_log;
  std::string system_folder = "/sys";
  std::string meter;  // empty: the best there is
};

constexpr std::size_t megabyte = std::size_t{1} << 20;

Result<std::vector<RunLog>> read_run_log(const std::string& file) {
  const auto table = read_csv(file);
  if (!table) return failure(table.error());
  const auto nodes = table->column("nodes");
  if (!nodes) return failure(Error(nodes.error()).in_file(file));
  const auto products = table->column("products");
  if (!products) return failure(Error(products.error()).in_file(file));
  std::vector<RunLog> log;
  for (std::size_t row = 0; row < table->rows(); ++row)
    log.push_back({table->columns[*nodes][row], table->columns[*products][row]});
  return log;
}

Result<Measurement> measure_here(const PlatformMeasureCommand& options, const Progress& progress) {
  const MeasureOptions& measuring = options.measure;
  std::unique_ptr<ProductKernel> kernel = processor_product(measuring.nodes_in_domain, measuring.largest_bytes);
  if (options.device) {
    auto elsewhere = opencl_product(measuring.nodes_in_domain, measuring.largest_bytes, *options.device);
    if (!elsewhere) return failure(elsewhere.error());
    kernel = std::move(*elsewhere);
  }
  const MeterSurvey survey = survey_meters(options.system_folder);
  if (options.meter.empty()) {
    return measure(*kernel, survey.meters.empty() ? nullptr : &survey.meters.front(), survey.missing, measuring,
                   progress);
  }
  for (const EnergyMeter& meter : survey.meters) {
    if (to_string(meter.kind) == options.meter) return measure(*kernel, &meter, survey.missing, measuring, progress);
  }
  std::string why;
  for (const Sentence& sentence : survey.missing) why += " " + sentence.message();
  return failure("meter-missing", GLISSON_TEXT("There is no meter {0} here.{1}"), {options.meter, why});
}

Json as_json(const MeasuredPoint& point) {
  Json json{{"nodes", point.nodes},     {"bytes", point.bytes},       {"flops", point.flops},
            {"seconds", point.seconds}, {"GB_per_s", point.GB_per_s}, {"GFLOP_per_s", point.GFLOP_per_s}};
  if (point.share_of_bandwidth > 0) {
    json["share_of_bandwidth"] = point.share_of_bandwidth;
    json["in_cache"] = point.in_cache;
  }
  if (point.joules) json["joules"] = *point.joules;
  if (point.uncertain_J) json["uncertain_J"] = *point.uncertain_J;
  return json;
}

// Of the memory's bandwidth; a problem that stays in the cache is not bound by it.
std::string share_of(const MeasuredPoint& point) {
  if (point.share_of_bandwidth == 0) return "-";
  return point.in_cache ? "(cache)" : fmt::format("{:.2f}", point.share_of_bandwidth);
}

Outcome describe(const Measurement& measured, const std::optional<TraceRuns>& runs, const std::string& out) {
  Outcome outcome{{{"device", measured.device.id},
                   {"kernel", measured.kernel},
                   {"meter", measured.meter.empty() ? Json(nullptr) : Json(measured.meter)},
                   {"points", Json::array()},
                   {"remarks", messages(measured.remarks)},
                   {"assumed", assumed_figures(measured.device)},
                   {"out", out}},
                  {}};
  outcome.text =
      fmt::format("{}{}\n", measured.kernel, measured.meter.empty() ? std::string() : ", energy by " + measured.meter);
  if (!measured.meter.empty()) {
    const KernelModel& made = measured.device.kernel;
    outcome.document["idle_W"] = measured.device.idle_W.value;
    outcome.document["active_W"] = made.active_W.value;
    if (measured.idle_uncertain_W) outcome.document["idle_uncertain_W"] = *measured.idle_uncertain_W;
    if (measured.active_uncertain_W) outcome.document["active_uncertain_W"] = *measured.active_uncertain_W;
    outcome.text += fmt::format("Idle {:.3g} W ({}); above idle {:.3g} W ({})\n", measured.device.idle_W.value,
                                measured.device.idle_W.note, made.active_W.value, made.active_W.note);
  }
  if (measured.bandwidth_GB_s > 0) {
    outcome.document["memory_bandwidth_GB_s"] = measured.bandwidth_GB_s;
    outcome.text += fmt::format("The memory gives {:.3g} GB/s.\n", measured.bandwidth_GB_s);
  }
  if (!measured.points.empty()) {
    const MeasuredPoint& any = measured.points.front();
    const double flops_per_byte = any.GFLOP_per_s / any.GB_per_s;
    outcome.document["flops_per_byte"] = flops_per_byte;
    outcome.text += fmt::format(
        "A product takes {:.0f} bytes and {:.0f} operations a node, {:.2f} a byte, so that memory decides.\n",
        any.bytes / any.nodes, any.flops / any.nodes, flops_per_byte);
  }
  if (runs) {
    outcome.document["trace"] = runs_json(*runs);
    outcome.text += fmt::format("{} runs in the recording, idle {:.3g} W\n", runs->runs.size(), runs->idle_W);
  }
  outcome.text += fmt::format("{:>9} {:>11} {:>8} {:>8} {:>7} {:>10}\n", "nodes", "product us", "GB/s", "GFLOP/s",
                              "share", "energy mJ");
  for (std::size_t i = 0; i < measured.points.size(); ++i) {
    const MeasuredPoint& point = measured.points[i];
    outcome.document["points"].push_back(as_json(point));
    // Every tenth point for the eye; all of them are in the file.
    if (measured.points.size() > 20 && i % 10 != 0 && i + 1 != measured.points.size()) continue;
    outcome.text += fmt::format("{:9.0f} {:11.2f} {:8.2f} {:8.2f} {:>7} {:>10}\n", point.nodes, point.seconds * 1e6,
                                point.GB_per_s, point.GFLOP_per_s, share_of(point),
                                point.joules ? fmt::format("{:.3g}", *point.joules * 1e3) : "-");
  }
  for (const Sentence& remark : measured.remarks) outcome.text += "Note: " + remark.message() + "\n";
  outcome.text += fmt::format("Written to {}; plan with it: glisson-cli platform plan --devices {} ...\n", out, out);
  return outcome;
}

Result<Outcome> run(PlatformMeasureCommand options, const Progress& progress) {
  options.measure.largest_bytes = static_cast<std::size_t>(options.largest_MB) * megabyte;
  for (const Worn worn : {Worn::head, Worn::belt, Worn::back}) {
    if (options.worn == to_string(worn)) options.measure.device.worn = worn;
  }
  std::optional<casefile::PatientModel> model;  // read first: what follows takes a while
  if (!options.product_case.empty()) {
    auto read = casefile::Case::open(options.product_case).and_then([](const casefile::Case& patient) {
      return casefile::read_model(patient);
    });
    if (!read) return failure(read.error());
    model = std::move(*read);
  }
  std::optional<TraceRuns> runs;
  if (!options.trace.file.empty()) {
    auto found = options.trace.runs();
    if (!found) return failure(found.error());
    runs = std::move(*found);
  }
  Result<Measurement> measured = failure("nothing-measured", GLISSON_TEXT("Nothing was measured."));
  if (runs && !options.run_log.empty()) {
    const auto log = read_run_log(options.run_log);
    if (!log) return failure(log.error());
    measured = measurement_from(*runs, *log, options.measure);
  } else {
    measured = measure_here(options, progress);
    if (measured && runs) take_power_from(*runs, *measured);
  }
  if (!measured) return failure(measured.error());
  if (const auto checked = check(measured->device); !checked) return failure(checked.error());
  if (const auto written = write_devices(options.out, {measured->device}); !written) return failure(written.error());
  Outcome outcome = describe(*measured, runs, options.out);
  if (!model) return outcome;
  const auto times = studies::time_product_tasks(*model, options.product, progress.part(0.5, 1));
  if (!times) return failure(times.error());
  if (auto written = write_tasks(options.tasks_out, times->tasks); !written) return failure(written.error());
  outcome.document["tasks"] = Json::array();
  for (const Task& task : times->tasks) {
    outcome.document["tasks"].push_back({{"id", task.id},
                                         {"what", task.what},
                                         {"seconds", task.seconds},
                                         {"bytes", task.bytes},
                                         {"operations", task.operations}});
    outcome.text += fmt::format("{:22} {:9.2f} ms  {}\n", task.id, 1e3 * task.seconds, task.what);
  }
  outcome.text +=
      fmt::format("Written to {}; plan with them: glisson-cli platform plan --for rehearse --tasks {} ...\n",
                  options.tasks_out, options.tasks_out);
  for (const std::string& remark : times->remarks) {
    outcome.document["remarks"].push_back(remark);
    outcome.text += "Note: " + remark + "\n";
  }
  outcome.document["tasks_out"] = options.tasks_out;
  return outcome;
}

}  // namespace

void add_platform_measure(CLI::App& platform, Action& chosen) {
  CLI::App* command = platform.add_subcommand(
      "measure", "Measure this machine, or read a recording of another, as a device to plan with");
  auto options = std::make_shared<PlatformMeasureCommand>();
  DeviceDescription& device = options->measure.device;
  command->add_option("--out", options->out, "Where the device is written (JSON)")->required();
  command->add_option("--id", device.id, "Its id in plans")->capture_default_str();
  command->add_option("--name", device.name, "Its name")->capture_default_str();
  command->add_option("--worn", options->worn, "How it is worn")
      ->check(CLI::IsMember({"head", "belt", "back"}))
      ->capture_default_str();
  const auto number = [command](const char* name, std::optional<double>& value, const char* help) {
    command->add_option(name, value, help)->check(CLI::PositiveNumber);
  };
  number("--idle-W", device.idle_W, "Idle power, where no meter tells");
  number("--active-W", device.active_W, "Power above idle while it computes, where no meter tells");
  number("--battery-mAh", device.capacity_mAh, "Capacity of its battery");
  number("--battery-V", device.voltage_V, "Nominal voltage of its battery");
  number("--thermal-resistance", device.thermal_resistance_C_per_W, "Surface to air, C/W");
  number("--time-constant-s", device.thermal_time_constant_s, "Of its warming");
  command->add_option("--domain-nodes", options->measure.nodes_in_domain, "Nodes that a block couples")
      ->check(CLI::IsMember({1, 27, 125}))
      ->capture_default_str();
  command->add_option("--largest-MB", options->largest_MB, "Largest batch")
      ->check(CLI::Range(1, 1 << 20))
      ->capture_default_str();
  command->add_option("--seconds-per-point", options->measure.seconds_per_point, "How long each problem runs")
      ->check(CLI::Range(0.001, 600.0))
      ->capture_default_str();
  command->add_option("--meter", options->meter, "Of those there are: rapl, ina, battery; the best where left out")
      ->check(CLI::IsMember({"rapl", "ina", "battery"}));
  command->add_option("--idle-s", options->measure.idle_s, "How long a meter is listened to before anything runs")
      ->check(CLI::Range(0.01, 3600.0))
      ->capture_default_str();
  command->add_option("--system-folder", options->system_folder, "Where the kernel shows its meters")
      ->capture_default_str();
  CLI::Option* product = command->add_option("--product", options->product_case,
                                             "A case with a model: what this program does in a frame is timed with it");
  command
      ->add_option("--tasks-out", options->tasks_out, "Where its times are written (JSON), for platform plan --tasks")
      ->needs(product);
  product->needs("--tasks-out");
  command->add_option("--product-frames", options->product.frames, "How many frames of each task")
      ->needs(product)
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  add_opencl(*command, options->device);
  CLI::Option* trace = options->trace.add_options(*command);
  command
      ->add_option("--run-log", options->run_log, "What was run, in order (CSV: nodes,products); nothing is run here")
      ->needs(trace);
  command->callback(
      [&chosen, options] { chosen = [options](const Progress& progress) { return run(*options, progress); }; });
}

}  // namespace glisson::cli

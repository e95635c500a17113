#include "hardware/energy_meter.h"

#include <fmt/format.h>
#include <algorithm>
#include <charconv>
#include <chrono>
#include <condition_variable>
#include <fstream>
#include <mutex>
#include <optional>
#include <thread>

#include "base/stopwatch.h"

namespace glisson::hardware {
namespace {

namespace fs = std::filesystem;

constexpr auto sampling_interval = std::chrono::milliseconds(20);

std::optional<EnergyMeter> find_rapl(const fs::path& system_folder, std::vector<Sentence>& missing);
std::optional<EnergyMeter> find_ina(const fs::path& system_folder, std::vector<Sentence>& missing);
std::optional<EnergyMeter> find_battery(const fs::path& system_folder, std::vector<Sentence>& missing);

std::optional<std::string> first_line(const fs::path& file);
std::optional<double> number_in(const fs::path& file);
std::vector<fs::path> entries_of(const fs::path& folder);
std::optional<double> power_W(const EnergyMeter::Source& source);
std::optional<double> total_power_W(const EnergyMeter& meter);
Failure lost(const EnergyMeter& meter);

Result<EnergyUse> counted(const EnergyMeter& meter, const std::function<Result<void>()>& work);
Result<EnergyUse> sampled(const EnergyMeter& meter, const std::function<Result<void>()>& work);

}  // namespace

double EnergyMeter::shortest_useful_s() const {
  switch (kind) {
    case MeterKind::rapl: return 0.1;    // renewed every millisecond
    case MeterKind::ina: return 0.5;     // conversions of some tens of milliseconds
    case MeterKind::battery: return 60;  // gauges average over seconds
  }
  return 60;
}

MeterSurvey survey_meters(const fs::path& system_folder) {
  MeterSurvey survey;
  for (const auto find : {find_rapl, find_ina, find_battery}) {
    if (auto meter = find(system_folder, survey.missing)) survey.meters.push_back(std::move(*meter));
  }
  return survey;
}

Result<EnergyUse> energy_during(const EnergyMeter& meter, const std::function<Result<void>()>& work) {
  return meter.kind == MeterKind::rapl ? counted(meter, work) : sampled(meter, work);
}

namespace {

Result<EnergyUse> counted(const EnergyMeter& meter, const std::function<Result<void>()>& work) {
  const auto read_all = [&meter]() -> std::optional<std::vector<double>> {
    std::vector<double> counters;
    for (const EnergyMeter::Source& source : meter.sources) {
      const auto counter = number_in(source.energy_uJ);
      if (!counter) return {};
      counters.push_back(*counter);
    }
    return counters;
  };
  const auto before = read_all();
  if (!before) return lost(meter);
  const Stopwatch watch;
  if (const auto worked = work(); !worked) return failure(worked.error());
  EnergyUse use;
  use.seconds = watch.seconds();
  const auto after = read_all();
  if (!after) return lost(meter);
  for (std::size_t i = 0; i < meter.sources.size(); ++i) {
    double spent_uJ = (*after)[i] - (*before)[i];
    if (spent_uJ < 0) spent_uJ += meter.sources[i].wraps_at_uJ;
    use.joules += spent_uJ * 1e-6;
  }
  return use;
}

Result<EnergyUse> sampled(const EnergyMeter& meter, const std::function<Result<void>()>& work) {
  std::mutex mutex;
  std::condition_variable finished;
  bool done = false;
  bool answering = true;
  double joules = 0;
  const Stopwatch watch;
  double last_s = 0;
  auto last_W = total_power_W(meter);
  if (!last_W) return lost(meter);

  const auto add_sample = [&] {
    const auto now_W = total_power_W(meter);
    const double now_s = watch.seconds();
    if (now_W) {
      joules += (now_s - last_s) * (*last_W + *now_W) / 2;
      last_s = now_s;
      last_W = now_W;
    }
    answering = now_W.has_value();
  };
  std::thread sampler([&] {
    std::unique_lock lock(mutex);
    while (!finished.wait_for(lock, sampling_interval, [&] { return done; })) add_sample();
    add_sample();
  });
  const auto worked = work();
  {
    const std::scoped_lock lock(mutex);
    done = true;
  }
  finished.notify_one();
  sampler.join();
  if (!worked) return failure(worked.error());
  if (!answering) return lost(meter);
  return EnergyUse{last_s, joules};
}

Failure lost(const EnergyMeter& meter) {
  return failure("meter-lost", GLISSON_TEXT("The energy meter {0} stopped answering."), {meter.name});
}

std::optional<EnergyMeter> find_rapl(const fs::path& system_folder, std::vector<Sentence>& missing) {
  const fs::path folder = system_folder / "class" / "powercap";
  EnergyMeter meter{MeterKind::rapl, {}, {}};
  bool forbidden = false;
  for (const fs::path& zone : entries_of(folder)) {
    // Whole packages only ("intel-rapl:0", also on AMD); their parts ("intel-rapl:0:1") are contained in them.
    const std::string name = zone.filename().string();
    if (!name.starts_with("intel-rapl:") || std::count(name.begin(), name.end(), ':') != 1) continue;
    const auto domain = first_line(zone / "name");
    if (!domain || !domain->starts_with("package")) continue;
    const auto range = number_in(zone / "max_energy_range_uj");
    const bool readable = number_in(zone / "energy_uj").has_value();
    forbidden = forbidden || !readable;
    if (!readable || !range) continue;
    EnergyMeter::Source source;
    source.energy_uJ = zone / "energy_uj";
    source.wraps_at_uJ = *range;
    meter.sources.push_back(source);
  }
  if (!meter.sources.empty()) {
    meter.name = fmt::format("RAPL, {} packages", meter.sources.size());
    return meter;
  }
  missing.push_back({forbidden ? GLISSON_TEXT("The processor's energy counters (RAPL) at {0} may be read by root only.")
                               : GLISSON_TEXT("No energy counters of the processor (RAPL) at {0}."),
                     {folder.string()}});
  return {};
}

// A Jetson labels its channels; the one that feeds the whole module makes the others parts of it.
bool is_board_input(const std::string& label) {
  return label == "VDD_IN" || label == "POM_5V_IN" || label == "VIN_SYS_5V0" || label.ends_with("_IN");
}

std::optional<EnergyMeter> find_ina(const fs::path& system_folder, std::vector<Sentence>& missing) {
  const fs::path folder = system_folder / "class" / "hwmon";
  EnergyMeter meter{MeterKind::ina, {}, {}};
  std::optional<EnergyMeter::Source> input;
  for (const fs::path& chip : entries_of(folder)) {
    const auto name = first_line(chip / "name");
    if (!name || !name->starts_with("ina")) continue;
    if (number_in(chip / "power1_input")) {
      EnergyMeter::Source source;
      source.power_uW = chip / "power1_input";
      meter.sources.push_back(source);
      continue;
    }
    for (int channel = 1; channel <= 3; ++channel) {
      EnergyMeter::Source source;
      source.voltage = chip / fmt::format("in{}_input", channel);
      source.current = chip / fmt::format("curr{}_input", channel);
      source.watts_per_product = 1e-6;  // millivolts, milliamperes
      if (!number_in(source.voltage) || !number_in(source.current)) continue;
      if (is_board_input(first_line(chip / fmt::format("in{}_label", channel)).value_or(""))) input = source;
      meter.sources.push_back(source);
    }
  }
  if (input) meter.sources = {*input};
  if (!meter.sources.empty()) {
    meter.name = input ? std::string("INA sensor at the board's input")
                       : fmt::format("INA sensors, {} supplies", meter.sources.size());
    return meter;
  }
  missing.push_back({GLISSON_TEXT("No current sensors (INA) at {0}."), {folder.string()}});
  return {};
}

std::optional<EnergyMeter> find_battery(const fs::path& system_folder, std::vector<Sentence>& missing) {
  const fs::path folder = system_folder / "class" / "power_supply";
  EnergyMeter meter{MeterKind::battery, "battery gauge", {}};
  bool charging = false;
  for (const fs::path& supply : entries_of(folder)) {
    if (first_line(supply / "type") != "Battery") continue;
    if (first_line(supply / "status") != "Discharging") {
      charging = true;
      continue;
    }
    EnergyMeter::Source source;
    if (number_in(supply / "power_now")) {
      source.power_uW = supply / "power_now";
    } else if (number_in(supply / "voltage_now") && number_in(supply / "current_now")) {
      source.voltage = supply / "voltage_now";
      source.current = supply / "current_now";
      source.watts_per_product = 1e-12;  // microvolts, microamperes
    } else {
      continue;
    }
    meter.sources.push_back(source);
  }
  if (!meter.sources.empty()) return meter;
  missing.push_back({charging
                         ? GLISSON_TEXT("The battery is not discharging: unplug the machine to measure by its gauge.")
                         : GLISSON_TEXT("No battery gauge at {0}."),
                     {folder.string()}});
  return {};
}

std::optional<std::string> first_line(const fs::path& file) {
  std::ifstream stream(file);
  char line[256];
  if (!stream.getline(line, sizeof line)) return {};
  return std::string(line);
}

std::optional<double> number_in(const fs::path& file) {
  const auto line = first_line(file);
  if (!line) return {};
  double number = 0;
  const auto [end, problem] = std::from_chars(line->data(), line->data() + line->size(), number);
  if (problem != std::errc() || number - number != 0) return {};
  return number;
}

std::vector<fs::path> entries_of(const fs::path& folder) {
  std::vector<fs::path> entries;
  std::error_code problem;
  for (fs::directory_iterator entry(folder, problem), end; !problem && entry != end; entry.increment(problem))
    entries.push_back(entry->path());
  std::sort(entries.begin(), entries.end());
  return entries;
}

std::optional<double> power_W(const EnergyMeter::Source& source) {
  if (!source.power_uW.empty()) {
    const auto power_uW = number_in(source.power_uW);
    return power_uW ? std::optional(*power_uW * 1e-6) : std::nullopt;
  }
  const auto voltage = number_in(source.voltage);
  const auto current = number_in(source.current);
  if (!voltage || !current) return {};
  // Some gauges count the current out of the battery as negative.
  return std::abs(*voltage * *current) * source.watts_per_product;
}

std::optional<double> total_power_W(const EnergyMeter& meter) {
  double total = 0;
  for (const EnergyMeter::Source& source : meter.sources) {
    const auto part_W = power_W(source);
    if (!part_W) return {};
    total += *part_W;
  }
  return total;
}

}  // namespace
}  // namespace glisson::hardware

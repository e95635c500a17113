// Which meters the kernel shows, and why others are not there.

#include <fmt/format.h>
#include <algorithm>
#include <optional>

#include "base/folder_contents.h"
#include "hardware/energy_meter.h"
#include "hardware/internal/system_file.h"

namespace glisson::hardware {
namespace {

namespace fs = std::filesystem;

std::optional<EnergyMeter> find_rapl(const fs::path& system_folder, std::vector<Sentence>& missing);
std::optional<EnergyMeter> find_ina(const fs::path& system_folder, std::vector<Sentence>& missing);
std::optional<EnergyMeter> find_battery(const fs::path& system_folder, std::vector<Sentence>& missing);

}  // namespace

MeterSurvey survey_meters(const fs::path& system_folder) {
  MeterSurvey survey;
  for (const auto find : {find_rapl, find_ina, find_battery}) {
    if (auto meter = find(system_folder, survey.missing)) survey.meters.push_back(std::move(*meter));
  }
  return survey;
}

namespace {

std::optional<EnergyMeter> find_rapl(const fs::path& system_folder, std::vector<Sentence>& missing) {
  const fs::path folder = system_folder / "class" / "powercap";
  EnergyMeter meter{MeterKind::rapl, {}, {}, 0.1, 0.001};
  int packages = 0, memories = 0;
  bool forbidden = false, nonsense = false;
  for (const fs::path& zone : contents_of(folder)) {
    // "intel-rapl:0" (also on AMD) and its parts "intel-rapl:0:1"; the same counters by another way are
    // "intel-rapl-mmio".
    if (!zone.filename().string().starts_with("intel-rapl:")) continue;
    const auto domain = first_line(zone / "name");
    // A package contains its cores. "psys" would contain all, but few machines have it and fewer have it right.
    const bool package = domain && domain->starts_with("package");
    const bool memory = domain && *domain == "dram";
    if (!package && !memory) continue;
    const fs::path counter = zone / "energy_uj";
    const auto range = number_in(zone / "max_energy_range_uj");
    if (!number_in(counter) || !range || *range <= 0) {
      (is_forbidden(counter) ? forbidden : nonsense) = true;
      continue;
    }
    EnergyMeter::Source source;
    source.counter = counter;
    source.joules_per_count = 1e-6;
    source.wraps_at = *range;
    meter.sources.push_back(source);
    ++(package ? packages : memories);
  }
  if (packages > 0) {
    meter.name = memories > 0 ? fmt::format("RAPL (packages: {}, memories: {})", packages, memories)
                              : fmt::format("RAPL (packages: {}, no memory)", packages);
    return meter;
  }
  if (forbidden) {
    missing.push_back(
        {GLISSON_TEXT("The processor's energy counters (RAPL) at {0} may be read by root only, as they betray "
                      "secrets (CVE-2020-8694): run this once as root, or let yourself read energy_uj."),
         {folder.string()}});
  } else if (nonsense) {
    missing.push_back(
        {GLISSON_TEXT("The processor's energy counters (RAPL) at {0} hold no number or no range."), {folder.string()}});
  } else {
    missing.push_back({GLISSON_TEXT("No energy counters of the processor (RAPL) at {0}."), {folder.string()}});
  }
  return {};
}

// A Jetson labels its channels; the one that feeds the whole module makes the others parts of it.
bool is_board_input(const std::string& label) {
  return label == "VDD_IN" || label == "POM_5V_IN" || label == "VIN_SYS_5V0" || label.ends_with("_IN");
}

std::optional<EnergyMeter> find_ina(const fs::path& system_folder, std::vector<Sentence>& missing) {
  const fs::path folder = system_folder / "class" / "hwmon";
  EnergyMeter meter{MeterKind::ina, {}, {}, 0.5, {}};  // conversions of some tens of milliseconds
  std::optional<EnergyMeter::Source> input;
  for (const fs::path& chip : contents_of(folder)) {
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

// Power where the gauge shows it (0 is none), else voltage times current, else how what is left falls.
std::optional<EnergyMeter::Source> source_of(const fs::path& supply) {
  EnergyMeter::Source source;
  source.discharges = supply / "status";
  const auto shows = [&](const char* name) { return number_in(supply / name).value_or(0) != 0; };
  if (shows("power_now")) {
    source.power_uW = supply / "power_now";
  } else if (shows("voltage_now") && shows("current_now")) {
    source.voltage = supply / "voltage_now";
    source.current = supply / "current_now";
    source.watts_per_product = 1e-12;  // microvolts, microamperes
  } else if (shows("energy_now")) {
    source.counter = supply / "energy_now";
    source.joules_per_count = -3600e-6;  // microwatt hours
  } else if (shows("voltage_now") && shows("charge_now")) {
    source.counter = supply / "charge_now";
    source.voltage = supply / "voltage_now";
    source.joules_per_count = -3600e-12;  // microampere hours, microvolts
  } else {
    return {};
  }
  return source;
}

std::optional<EnergyMeter> find_battery(const fs::path& system_folder, std::vector<Sentence>& missing) {
  const fs::path folder = system_folder / "class" / "power_supply";
  EnergyMeter meter{MeterKind::battery, "battery gauge", {}, 60, {}};
  bool charging = false, resting = false, silent = false, falling = false;
  for (const fs::path& supply : contents_of(folder)) {
    // A mouse has a battery too: "scope" tells it apart.
    if (first_line(supply / "type") != "Battery" || first_line(supply / "scope") == "Device") continue;
    const auto status = first_line(supply / "status");
    if (status != "Discharging") {
      charging = charging || status == "Charging";
      resting = true;  // full, or not in use while another one discharges
      continue;
    }
    const auto source = source_of(supply);
    silent = silent || !source;
    if (!source) continue;
    falling = falling || !source->counter.empty();
    meter.sources.push_back(*source);
  }
  if (charging) meter.sources.clear();  // the mains may feed the machine beside a battery that discharges
  if (!meter.sources.empty()) {
    if (falling) meter.name = "battery gauge, by what is left";
    return meter;
  }
  missing.push_back({charging || (resting && !silent)
                         ? GLISSON_TEXT("The battery is not discharging: unplug the machine to measure by its gauge.")
                     : silent ? GLISSON_TEXT("The battery gauge at {0} tells neither power nor what is left.")
                              : GLISSON_TEXT("No battery gauge at {0}."),
                     {folder.string()}});
  return {};
}

}  // namespace
}  // namespace glisson::hardware

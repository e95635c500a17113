// Recordings of batteries, power and temperature from JSON and their tables.

#include <cmath>
#include <tuple>

#include "closedloop/experiment/internal/experiment_source.h"

namespace glisson::closedloop {
namespace {

void read_declared(const Json& json, Hardware& hardware);
HardwareTrial trial_from(const Json& json, const std::string& id, const Source& source, const Hardware& hardware,
                         Needs needs);

}  // namespace

Hardware hardware_from(const Json& json, const Source& source, Needs needs) {
  only_keys(json, {"format", "kind", "title", "specimen", "declared", "noise", "trials"}, "The experiment");
  Hardware hardware;
  read_declared(required(json, "declared", "The experiment"), hardware);
  const Json& noise = required(json, "noise", "The experiment");
  only_keys(noise, {"voltage_V", "temperature_C", "power_W"}, "noise");
  hardware.noise_V = optional_positive(noise, "voltage_V", "noise");
  hardware.noise_C = optional_positive(noise, "temperature_C", "noise");
  hardware.noise_W = optional_positive(noise, "power_W", "noise");
  if (!hardware.noise_V && !hardware.noise_C && !hardware.noise_W)
    refuse("experiment-invalid", GLISSON_TEXT("\"noise\" names no quantity, so that nothing can be judged."), {},
           GLISSON_TEXT("Give voltage_V, temperature_C or power_W: the standard deviation of that reading."));
  const std::vector<std::string> ids = trial_ids(json);
  for (std::size_t t = 0; t < ids.size(); ++t)
    hardware.trials.push_back(trial_from(json["trials"][t], ids[t], source, hardware, needs));
  return hardware;
}

namespace {

void read_declared(const Json& json, Hardware& hardware) {
  only_keys(json,
            {"law", "energy_Wh", "idle_W", "full_load_W", "thermal_resistance_C_per_W", "time_constant_s",
             "nominal_voltage_V", "capacity_Ah"},
            "declared");
  if (const std::string law = text_in(required(json, "law", "declared"), "declared, law"); law != "constant")
    refuse("experiment-invalid", GLISSON_TEXT("The declared law \"{0}\" is not known."), {law},
           GLISSON_TEXT("The law of platforms is constant: a battery that gives all of its energy at any load."));
  hardware.energy_Wh = optional_positive(json, "energy_Wh", "declared");
  hardware.nominal_voltage_V = optional_positive(json, "nominal_voltage_V", "declared");
  hardware.capacity_Ah = optional_positive(json, "capacity_Ah", "declared");
  hardware.full_load_W = optional_positive(json, "full_load_W", "declared");
  hardware.thermal_resistance_C_per_W = optional_positive(json, "thermal_resistance_C_per_W", "declared");
  hardware.time_constant_s = optional_positive(json, "time_constant_s", "declared");
  if (json.contains("idle_W")) hardware.idle_W = number_in(json["idle_W"], "declared, idle_W");
  if (hardware.idle_W < 0) refuse("experiment-invalid", GLISSON_TEXT("{0} must not be below zero."), {"idle_W"});
  // Two of energy, voltage and capacity give the third.
  auto [energy, voltage, capacity] = std::tie(hardware.energy_Wh, hardware.nominal_voltage_V, hardware.capacity_Ah);
  if (!energy && voltage && capacity) energy = *voltage * *capacity;
  if (energy && !voltage && capacity) voltage = *energy / *capacity;
  if (energy && voltage && !capacity) capacity = *energy / *voltage;
}

void refuse_unlikely(const Eigen::VectorXd& readings, double lowest, double highest, const char* what,
                     const char* cause, const CsvTable& table, const std::filesystem::path& file) {
  for (Eigen::Index row = 0; row < readings.size(); ++row) {
    if (readings[row] >= lowest && readings[row] <= highest) continue;
    refuse("experiment-unit", GLISSON_TEXT("Line {0} of {1} gives a {2} of {3}, which no worn computer reaches."),
           {std::to_string(table.lines[static_cast<std::size_t>(row)]), file.filename().string(), what,
            std::to_string(readings[row])},
           cause, file);
  }
}

HardwareTrial trial_from(const Json& json, const std::string& id, const Source& source, const Hardware& hardware,
                         Needs needs) {
  const std::string where = "trial " + id;
  only_keys(json, {"id", "file", "columns", "ambient_C"}, where);
  const std::filesystem::path file = source.named_file(text_in(required(json, "file", where), where + ", file"));
  const Json& columns = required(json, "columns", where);
  only_keys(columns, {"time_s", "current_A", "voltage_V", "power_W", "temperature_C", "load"}, where + ", columns");
  const CsvTable table = table_of(file);
  const auto column = [&](const char* key) -> Eigen::VectorXd {
    if (!columns.contains(key)) return {};
    return column_of(table, text_in(columns[key], where + ", " + key), file, key);
  };

  HardwareTrial trial;
  trial.id = id;
  if (json.contains("ambient_C")) trial.ambient_C = number_in(json["ambient_C"], where + ", ambient_C");
  trial.time_s = times_of(table, text_in(required(columns, "time_s", where + ", columns"), where + ", time_s"), file);
  trial.current_A = column("current_A");
  trial.voltage_V = column("voltage_V");
  trial.power_W = column("power_W");
  trial.temperature_C = column("temperature_C");
  trial.load = column("load");
  refuse_unlikely(trial.voltage_V, -100, 1000, "voltage", "Was it given in mV?", table, file);
  refuse_unlikely(trial.power_W, -1e4, 1e4, "power", "Was it given in mW?", table, file);
  refuse_unlikely(trial.temperature_C, -60, 150, "temperature", "Was it given in kelvin?", table, file);
  const bool judged = (hardware.noise_V && trial.voltage_V.size() > 0) ||
                      (hardware.noise_C && trial.temperature_C.size() > 0) ||
                      (hardware.noise_W && trial.power_W.size() > 0);
  if (needs == Needs::measurements && !judged)
    refuse("experiment-invalid", GLISSON_TEXT("{0} has no column for a quantity whose noise is given."), {where});
  return trial;
}

}  // namespace
}  // namespace glisson::closedloop

// glisson-cli platform cell: a battery cell set up from measured discharges, and what it predicts of others.

#include <fmt/format.h>

#include "hardware/cell.h"
#include "platform_commands.h"

namespace glisson::cli {

using namespace hardware;

namespace {

struct PlatformCellCommand {
  std::string slow;
  std::vector<std::string> discharges;
  std::vector<std::string> predicted;
  DischargeColumns columns;
  bool discharge_negative = false;
};

Json as_json(const CellModel& cell) {
  const Battery battery = battery_of(cell);
  return {{"capacity_Ah", cell.capacity_Ah},
          {"nominal_voltage_V", battery.nominal_voltage_V},
          {"internal_resistance_ohm", battery.internal_resistance_ohm},
          {"resistance_per_C", cell.resistance_per_C},
          {"cutoff_V", cell.cutoff_V},
          {"thermal_resistance_C_per_W", cell.heat.resistance_C_per_W},
          {"thermal_time_constant_s", cell.heat.time_constant_s}};
}

Json as_json(const Discharge& discharge) {
  return {
      {"seconds", discharge.seconds()},
      {"charge_Ah", discharge.charge_Ah()},
      {"energy_Wh", discharge.energy_Wh()},
      {"last_temperature_C", discharge.temperature_C.empty() ? discharge.ambient_C : discharge.temperature_C.back()}};
}

Result<Outcome> run(PlatformCellCommand options) {
  if (options.discharge_negative) options.columns.sign = DischargeColumns::Sign::discharge_negative;
  const auto slow = read_discharge(options.slow, options.columns);
  if (!slow) return failure(slow.error());
  std::vector<Discharge> others;
  for (const std::string& file : options.discharges) {
    auto other = read_discharge(file, options.columns);
    if (!other) return failure(other.error());
    others.push_back(std::move(*other));
  }
  const auto cell = cell_from(*slow, others);
  if (!cell) return failure(cell.error());

  const Battery battery = battery_of(*cell);
  Outcome outcome{{{"cell", as_json(*cell)}, {"predictions", Json::array()}}, {}};
  outcome.text = fmt::format("{:.3f} Ah, {:.2f} V, {:.3f} ohm at 25 C; warms by {:.3g} C/W within {:.0f} s\n",
                             cell->capacity_Ah, battery.nominal_voltage_V, battery.internal_resistance_ohm,
                             cell->heat.resistance_C_per_W, cell->heat.time_constant_s);
  for (const std::string& file : options.predicted) {
    const auto measured = read_discharge(file, options.columns);
    if (!measured) return failure(measured.error());
    const CellPrediction prediction = predict(*cell, *measured);
    const Discharge& predicted = prediction.run.discharge;
    outcome.document["predictions"].push_back({{"file", file},
                                               {"current_A", measured->mean_current_A()},
                                               {"measured", as_json(*measured)},
                                               {"predicted", as_json(predicted)},
                                               {"rms_voltage_V", prediction.rms_voltage_V},
                                               {"rms_temperature_C", prediction.rms_temperature_C}});
    outcome.text += fmt::format(
        "  {}: {:.0f} s measured, {:.0f} s predicted; {:.3f} and {:.3f} Wh; voltage within {:.3f} V, temperature "
        "within "
        "{:.1f} C (rms)\n",
        file, measured->seconds(), predicted.seconds(), measured->energy_Wh(), predicted.energy_Wh(),
        prediction.rms_voltage_V, prediction.rms_temperature_C);
  }
  return outcome;
}

}  // namespace

void add_platform_cell(CLI::App& platform, Action& chosen) {
  CLI::App* command =
      platform.add_subcommand("cell", "A battery cell set up from measured discharges, and what it predicts of others");
  auto options = std::make_shared<PlatformCellCommand>();
  command->add_option("--slow", options->slow, "A discharge at C/10 or slower (CSV)")->required();
  command->add_option("--discharge", options->discharges, "Two or more faster ones")->required()->expected(2, 100);
  command->add_option("--predict", options->predicted, "Others, to be compared with the prediction")->expected(1, 100);
  command->add_option("--time", options->columns.time_s, "Column: name or number")->capture_default_str();
  command->add_option("--current", options->columns.current_A, "Column of the current, A")->capture_default_str();
  command->add_option("--voltage", options->columns.voltage_V, "Column of the voltage, V")->capture_default_str();
  command->add_option("--temperature", options->columns.temperature_C, "Column of the cell's temperature")
      ->capture_default_str();
  command->add_option("--ambient", options->columns.ambient_C, "Column of the room's temperature")
      ->capture_default_str();
  command->add_flag("--discharge-negative", options->discharge_negative, "The current is negative while it discharges");
  command->callback([&chosen, options] { chosen = [options](const Progress&) { return run(*options); }; });
}

}  // namespace glisson::cli

#include "hardware/cell.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Dense>
#include <functional>
#include <numeric>

#include "base/csv.h"

namespace glisson::hardware {
namespace {

constexpr std::size_t knots = 51;  // every 2 % of the charge
constexpr std::size_t minimum_cell_samples = 20;
constexpr double reference_C = 25;

// The linear interpolant of values at evenly spaced places between 0 and 1.
double value_at(const std::vector<double>& values, double depth) {
  const double place = std::clamp(depth, 0.0, 1.0) * static_cast<double>(values.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), values.size() - 2);
  const double t = place - static_cast<double>(below);
  return values[below] * (1 - t) + values[below + 1] * t;
}

std::vector<double> depths_of(const Discharge& discharge, double capacity_Ah);
std::vector<double> open_circuit_from(const Discharge& slow, double capacity_Ah,
                                      const std::vector<double>& resistance_ohm);
std::vector<double> resistance_from(const std::vector<Discharge>& others, const CellModel& cell);
double squared_voltage_error(const std::vector<Discharge>& others, const CellModel& cell);
double best_between(double low, double high, const std::function<double(double)>& error);
HeatModel heat_from(const std::vector<Discharge>& others, const CellModel& cell);

double resistance_at(const CellModel& cell, double depth, double temperature_C) {
  return value_at(cell.resistance_ohm, depth) * std::exp(-cell.resistance_per_C * (temperature_C - reference_C));
}

Failure refuse_recording(const std::filesystem::path& file, std::string text) {
  return failure(Error{"discharge-invalid", std::move(text), {file.string()}, {}, file});
}

}  // namespace

double Discharge::charge_Ah() const {
  double charge_As = 0;
  for (std::size_t i = 1; i < time_s.size(); ++i)
    charge_As += (time_s[i] - time_s[i - 1]) * (current_A[i] + current_A[i - 1]) / 2;
  return charge_As / 3600;
}

double Discharge::energy_Wh() const {
  double energy_J = 0;
  for (std::size_t i = 1; i < time_s.size(); ++i) {
    energy_J += (time_s[i] - time_s[i - 1]) * (current_A[i] * voltage_V[i] + current_A[i - 1] * voltage_V[i - 1]) / 2;
  }
  return energy_J / 3600;
}

double Discharge::mean_current_A() const { return seconds() > 0 ? charge_Ah() * 3600 / seconds() : 0; }

Result<Discharge> read_discharge(const std::filesystem::path& file, const DischargeColumns& columns) {
  const auto table = read_csv(file);
  if (!table) return failure(table.error());
  const auto values_of = [&](const std::string& name) -> Result<const std::vector<double>*> {
    const auto column = table->column(name);
    if (!column) return failure(Error(column.error()).in_file(file));
    return &table->columns[*column];
  };
  const auto time = values_of(columns.time_s);
  const auto current = values_of(columns.current_A);
  const auto voltage = values_of(columns.voltage_V);
  const auto temperature = values_of(columns.temperature_C);
  for (const auto* found : {&time, &current, &voltage, &temperature}) {
    if (!*found) return failure(found->error());
  }

  const double sign = columns.sign == DischargeColumns::Sign::discharge_negative ? -1 : 1;
  double largest_A = 0;
  for (const double value : **current) largest_A = std::max(largest_A, sign * value);
  const auto flows = [&](double value) { return sign * value > largest_A / 10; };
  const auto first = std::find_if((*current)->begin(), (*current)->end(), flows) - (*current)->begin();
  const auto last = (*current)->rend() - std::find_if((*current)->rbegin(), (*current)->rend(), flows);

  Discharge discharge;
  for (auto row = static_cast<std::size_t>(first); row < static_cast<std::size_t>(last); ++row) {
    const double values[] = {(**time)[row], sign * (**current)[row], (**voltage)[row], (**temperature)[row]};
    if (!std::all_of(std::begin(values), std::end(values), [](double v) { return std::isfinite(v); }))
      return refuse_recording(file, GLISSON_TEXT("{0} lacks a reading within the discharge."));
    if (!discharge.time_s.empty() && values[0] <= discharge.time_s.back())
      return refuse_recording(file, GLISSON_TEXT("The time goes back in {0}."));
    discharge.time_s.push_back(values[0]);
    discharge.current_A.push_back(values[1]);
    discharge.voltage_V.push_back(values[2]);
    discharge.temperature_C.push_back(values[3]);
  }
  if (discharge.time_s.size() < minimum_cell_samples)
    return refuse_recording(file, GLISSON_TEXT("{0} holds no discharge."));
  discharge.ambient_C = discharge.temperature_C.front();
  if (!columns.ambient_C.empty()) {
    const auto ambient = values_of(columns.ambient_C);
    if (!ambient) return failure(ambient.error());
    discharge.ambient_C = std::accumulate((*ambient)->begin() + first, (*ambient)->begin() + last, 0.0) /
                          static_cast<double>(last - first);
    if (!std::isfinite(discharge.ambient_C))
      return refuse_recording(file, GLISSON_TEXT("{0} lacks a reading of the ambient."));
  }
  return discharge;
}

Result<CellModel> cell_from(const Discharge& slow, const std::vector<Discharge>& others) {
  const bool faster = std::all_of(others.begin(), others.end(), [&](const Discharge& other) {
    return other.mean_current_A() >= 5 * slow.mean_current_A();
  });
  if (others.size() < 2 || !faster || slow.mean_current_A() <= 0) {
    return failure(Error{"discharges-too-alike",
                         GLISSON_TEXT("A cell is set up from one slow discharge and at least two that are five times "
                                      "as fast."),
                         {},
                         {},
                         {}});
  }
  CellModel cell;
  cell.capacity_Ah = slow.charge_Ah();
  cell.cutoff_V = slow.voltage_V.back();
  cell.resistance_ohm.assign(knots, 0);
  // The slow discharge's own I R shifts U, U shifts R: three rounds settle it, each a tenth of the one before.
  for (int round = 0; round < 3; ++round) {
    cell.open_circuit_V = open_circuit_from(slow, cell.capacity_Ah, cell.resistance_ohm);
    // Resistances of lithium cells fall by 0 to 5 % a degree.
    cell.resistance_per_C = best_between(0, 0.05, [&](double per_C) {
      CellModel trial = cell;
      trial.resistance_per_C = per_C;
      trial.resistance_ohm = resistance_from(others, trial);
      return squared_voltage_error(others, trial);
    });
    cell.resistance_ohm = resistance_from(others, cell);
  }
  cell.heat = heat_from(others, cell);
  return cell;
}

CellRun run_cell(const CellModel& cell, double current_A, double ambient_C, double step_s) {
  GLISSON_ASSERT(current_A > 0 && step_s > 0);
  CellRun run;
  run.discharge.ambient_C = ambient_C;
  double temperature_C = ambient_C;
  double depth = 0;
  const double step_h = step_s / 3600;
  for (double time_s = 0; depth <= 1; time_s += step_s) {
    const double open_V = value_at(cell.open_circuit_V, depth);
    const double voltage_V = open_V - current_A * resistance_at(cell, depth, temperature_C);
    if (voltage_V < cell.cutoff_V) break;
    run.discharge.time_s.push_back(time_s);
    run.discharge.current_A.push_back(current_A);
    run.discharge.voltage_V.push_back(voltage_V);
    run.discharge.temperature_C.push_back(temperature_C);
    const double heat_W = current_A * (open_V - voltage_V);
    run.released_Wh += open_V * current_A * step_h;
    run.delivered_Wh += voltage_V * current_A * step_h;
    run.heat_Wh += heat_W * step_h;
    temperature_C = temperature_after_C(cell.heat, temperature_C, heat_W, ambient_C, step_s);
    depth += current_A * step_h / cell.capacity_Ah;
  }
  return run;
}

CellPrediction predict(const CellModel& cell, const Discharge& measured) {
  constexpr double step_s = 1;
  CellPrediction prediction;
  prediction.run = run_cell(cell, measured.mean_current_A(), measured.ambient_C, step_s);
  const Discharge& predicted = prediction.run.discharge;
  double count = 0;
  for (std::size_t i = 0; i < measured.time_s.size(); ++i) {
    const auto step = static_cast<std::size_t>((measured.time_s[i] - measured.time_s.front()) / step_s);
    if (step >= predicted.time_s.size()) break;
    prediction.rms_voltage_V += std::pow(predicted.voltage_V[step] - measured.voltage_V[i], 2);
    prediction.rms_temperature_C += std::pow(predicted.temperature_C[step] - measured.temperature_C[i], 2);
    ++count;
  }
  if (count > 0) {
    prediction.rms_voltage_V = std::sqrt(prediction.rms_voltage_V / count);
    prediction.rms_temperature_C = std::sqrt(prediction.rms_temperature_C / count);
  }
  return prediction;
}

Battery battery_of(const CellModel& cell, int in_series) {
  const auto mean = [](const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  };
  Battery battery;
  battery.capacity_Ah = cell.capacity_Ah;
  battery.nominal_voltage_V = in_series * mean(cell.open_circuit_V);
  battery.internal_resistance_ohm = in_series * mean(cell.resistance_ohm);
  return battery;
}

namespace {

std::vector<double> depths_of(const Discharge& discharge, double capacity_Ah) {
  std::vector<double> depths(discharge.time_s.size(), 0);
  for (std::size_t i = 1; i < depths.size(); ++i) {
    const double charge_As =
        (discharge.time_s[i] - discharge.time_s[i - 1]) * (discharge.current_A[i] + discharge.current_A[i - 1]) / 2;
    depths[i] = depths[i - 1] + charge_As / 3600 / capacity_Ah;
  }
  return depths;
}

std::vector<double> open_circuit_from(const Discharge& slow, double capacity_Ah,
                                      const std::vector<double>& resistance_ohm) {
  const std::vector<double> depths = depths_of(slow, capacity_Ah);
  std::vector<double> open_V(knots);
  std::size_t sample = 0;
  for (std::size_t k = 0; k < knots; ++k) {
    const double depth = static_cast<double>(k) / (knots - 1);
    while (sample + 2 < depths.size() && depths[sample + 1] < depth) ++sample;
    const double t = std::clamp((depth - depths[sample]) / (depths[sample + 1] - depths[sample]), 0.0, 1.0);
    const double voltage_V = slow.voltage_V[sample] * (1 - t) + slow.voltage_V[sample + 1] * t;
    open_V[k] = voltage_V + slow.mean_current_A() * resistance_ohm[k];
  }
  return open_V;
}

// R at the knots for which the voltages of all samples come out best: a linear least-squares problem, with a little of
// the second difference so that depths without samples (beyond the end of a fast discharge) go on straight.
std::vector<double> resistance_from(const std::vector<Discharge>& others, const CellModel& cell) {
  constexpr auto n = static_cast<Eigen::Index>(knots);
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
  double weight_sum = 0;
  for (const Discharge& other : others) {
    const std::vector<double> depths = depths_of(other, cell.capacity_Ah);
    for (std::size_t i = 0; i < depths.size(); ++i) {
      const double warmed = std::exp(-cell.resistance_per_C * (other.temperature_C[i] - reference_C));
      const double factor = other.current_A[i] * warmed;
      const double drop_V = value_at(cell.open_circuit_V, depths[i]) - other.voltage_V[i];
      const double place = std::clamp(depths[i], 0.0, 1.0) * static_cast<double>(knots - 1);
      const auto below = std::min(static_cast<Eigen::Index>(place), n - 2);
      const double t = place - static_cast<double>(below);
      const double share[] = {(1 - t) * factor, t * factor};
      for (int a = 0; a < 2; ++a) {
        for (int b = 0; b < 2; ++b) normal(below + a, below + b) += share[a] * share[b];
        right(below + a) += share[a] * drop_V;
      }
      weight_sum += factor * factor;
    }
  }
  const double smoothing = 1e-3 * weight_sum / static_cast<double>(knots);
  for (Eigen::Index k = 1; k + 1 < n; ++k) {
    const double second[] = {1, -2, 1};
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) normal(k - 1 + a, k - 1 + b) += smoothing * second[a] * second[b];
    }
  }
  const Eigen::VectorXd solved = normal.ldlt().solve(right);
  std::vector<double> resistance_ohm(knots);
  for (std::size_t k = 0; k < knots; ++k) resistance_ohm[k] = std::max(0.0, solved(static_cast<Eigen::Index>(k)));
  return resistance_ohm;
}

double squared_voltage_error(const std::vector<Discharge>& others, const CellModel& cell) {
  double sum = 0;
  for (const Discharge& other : others) {
    const std::vector<double> depths = depths_of(other, cell.capacity_Ah);
    for (std::size_t i = 0; i < depths.size(); ++i) {
      const double predicted_V = value_at(cell.open_circuit_V, depths[i]) -
                                 other.current_A[i] * resistance_at(cell, depths[i], other.temperature_C[i]);
      sum += std::pow(predicted_V - other.voltage_V[i], 2) / static_cast<double>(depths.size());
    }
  }
  return sum;
}

// Golden-section search for the smallest error; the errors here have one minimum.
double best_between(double low, double high, const std::function<double(double)>& error) {
  const double ratio = (std::sqrt(5.0) - 1) / 2;
  double left = high - ratio * (high - low);
  double right = low + ratio * (high - low);
  double left_error = error(left);
  double right_error = error(right);
  for (int step = 0; step < 40; ++step) {
    if (left_error < right_error) {
      high = right;
      right = left;
      right_error = left_error;
      left = high - ratio * (high - low);
      left_error = error(left);
    } else {
      low = left;
      left = right;
      left_error = right_error;
      right = low + ratio * (high - low);
      right_error = error(right);
    }
  }
  return (low + high) / 2;
}

// For a given time constant the warming is proportional to R_th, so that the best R_th is a quotient and only the time
// constant is searched for.
HeatModel heat_from(const std::vector<Discharge>& others, const CellModel& cell) {
  const auto fitted = [&](double time_constant_s) {
    double warming_times_unit = 0;
    double unit_squared = 0;
    double warming_squared = 0;
    for (const Discharge& other : others) {
      const std::vector<double> depths = depths_of(other, cell.capacity_Ah);
      double unit_C = 0;  // the warming for 1 C/W, beside the cooling of the start
      const double start_C = other.temperature_C.front() - other.ambient_C;
      for (std::size_t i = 1; i < depths.size(); ++i) {
        const double step_s = other.time_s[i] - other.time_s[i - 1];
        const double heat_W = other.current_A[i] * (value_at(cell.open_circuit_V, depths[i]) - other.voltage_V[i]);
        unit_C = temperature_after_C({1, time_constant_s}, unit_C, heat_W, 0, step_s);
        const double left_of_start_C = start_C * std::exp(-(other.time_s[i] - other.time_s.front()) / time_constant_s);
        const double warming_C = other.temperature_C[i] - other.ambient_C - left_of_start_C;
        const double weight = 1 / static_cast<double>(depths.size());
        warming_times_unit += weight * warming_C * unit_C;
        unit_squared += weight * unit_C * unit_C;
        warming_squared += weight * warming_C * warming_C;
      }
    }
    const double resistance_C_per_W = warming_times_unit / unit_squared;
    const double error = warming_squared - resistance_C_per_W * warming_times_unit;
    return std::pair(resistance_C_per_W, error);
  };
  // A cell alone takes minutes, a pack in a case hours; searched on a logarithmic scale.
  const double time_constant_s =
      std::exp(best_between(std::log(60), std::log(36000), [&](double x) { return fitted(std::exp(x)).second; }));
  return {fitted(time_constant_s).first, time_constant_s};
}

}  // namespace
}  // namespace glisson::hardware

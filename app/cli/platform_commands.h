#pragma once
// The parts of glisson-cli platform, and what they share.

#include <memory>
#include <string>
#include <vector>

#include "command.h"
#include "hardware/convergence_curve.h"
#include "hardware/device_file.h"
#include "hardware/plan.h"
#include "hardware/power_trace.h"

namespace glisson::cli {

void add_platform_list(CLI::App& platform, Action& chosen);
void add_platform_plan(CLI::App& platform, Action& chosen);
void add_platform_grid(CLI::App& platform, Action& chosen);
void add_platform_measure(CLI::App& platform, Action& chosen);
void add_platform_cell(CLI::App& platform, Action& chosen);
void add_platform_learn(CLI::App& platform, Action& chosen);

// The shipped table and those of the user's files; a device of theirs takes the place of a shipped one with its id.
struct DeviceTables {
  std::vector<std::string> files;
  std::string convergence_file;  // empty: the shipped curve

  void add_options(CLI::App& command);
  [[nodiscard]] Result<std::vector<hardware::Device>> devices() const;
  [[nodiscard]] Result<hardware::ConvergenceCurve> curve() const;
};

Result<hardware::Device> device_with_id(const std::vector<hardware::Device>& devices, const std::string& id);

// A recording of power: which file, which of its columns, what counts as a run.
struct TraceChoice {
  std::string file;
  std::vector<std::string> channels;  // COLUMN:AMPERES_PER_VOLT:SUPPLY_VOLTAGE[:CLIPS_AT]; none: as guessed
  hardware::TraceFormat format;
  std::string time_column;  // empty: as guessed where no channel is given, else the first
  hardware::RunOptions runs_options;

  CLI::Option* add_options(CLI::App& command);
  [[nodiscard]] Result<hardware::TraceRuns> runs() const;
};

Json runs_json(const hardware::TraceRuns& runs);

// Duration, frame rate, temperatures and the domain of influence.
void add_request_options(CLI::App& command, hardware::PlanRequest& request);

}  // namespace glisson::cli

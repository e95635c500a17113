#pragma once
// The parts of glisson-cli platform, and what they share.

#include <memory>
#include <string>
#include <vector>

#include "command.h"
#include "hardware/convergence_curve.h"
#include "hardware/device_file.h"
#include "hardware/plan.h"

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

// Duration, frame rate, temperatures and the domain of influence.
void add_request_options(CLI::App& command, hardware::PlanRequest& request);

}  // namespace glisson::cli

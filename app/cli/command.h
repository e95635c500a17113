#pragma once
// What a command of glisson-cli is: it adds itself to the parser, and when it is the one chosen it leaves an action.
// One small file a command; each is a thin call into the core.

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "base/json.h"
#include "base/progress.h"
#include "base/result.h"

namespace glisson::cli {

// What a command answers: the document for --json, and the same for a person's eyes.
struct Outcome {
  Json document;
  std::string text;
  bool passed = true;  // false: an answer all the same, but exit code 1
};

using Action = std::function<Result<Outcome>(const Progress&)>;

// Each command's file defines one of these: it declares the options on `app`, and sets `chosen` when the command line
// names the command.
void add_scan(CLI::App& app, Action& chosen);
void add_import(CLI::App& app, Action& chosen);
void add_segment(CLI::App& app, Action& chosen);
void add_vessels(CLI::App& app, Action& chosen);
void add_territories(CLI::App& app, Action& chosen);
void add_plan(CLI::App& app, Action& chosen);
void add_growth(CLI::App& app, Action& chosen);
void add_mesh(CLI::App& app, Action& chosen);
void add_stiffness(CLI::App& app, Action& chosen);
void add_invert(CLI::App& app, Action& chosen);
void add_guide(CLI::App& app, Action& chosen);
void add_simulate(CLI::App& app, Action& chosen);
void add_resect(CLI::App& app, Action& chosen);
void add_session(CLI::App& app, Action& chosen);
void add_compare(CLI::App& app, Action& chosen);
void add_export(CLI::App& app, Action& chosen);
void add_render(CLI::App& app, Action& chosen);
void add_report(CLI::App& app, Action& chosen);
void add_calibrate(CLI::App& app, Action& chosen);
void add_stereo(CLI::App& app, Action& chosen);
void add_sequence(CLI::App& app, Action& chosen);
void add_match(CLI::App& app, Action& chosen);
void add_register(CLI::App& app, Action& chosen);
void add_sirgn(CLI::App& app, Action& chosen);
void add_review(CLI::App& app, Action& chosen);
void add_gate(CLI::App& app, Action& chosen);
void add_study(CLI::App& app, Action& chosen);
void add_shapes(CLI::App& app, Action& chosen);
void add_platform(CLI::App& app, Action& chosen);
void add_deidentify(CLI::App& app, Action& chosen);
void add_explain(CLI::App& app, Action& chosen);
void add_predict(CLI::App& app, Action& chosen);
void add_accept(CLI::App& app, Action& chosen);
void add_demo(CLI::App& app, Action& chosen);

// All of them, in the order in which --help lists them.
void add_commands(CLI::App& app, Action& chosen);

}  // namespace glisson::cli

#pragma once
// What a command of glisson-cli is: it adds itself to the parser, and when it is the one chosen it leaves an action.
// One small file a command; each is a thin call into the core.

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/json.h"
#include "base/progress.h"
#include "base/result.h"

namespace glisson::cli {

// What a command answers: the document for --json, and the same for a person's eyes.
struct Outcome {
  Json document;
  std::string text;
};

using Action = std::function<Result<Outcome>(const Progress&)>;

// Each declares its options on `app` and sets `chosen` when the command line names it.
void add_scan(CLI::App& app, Action& chosen);

// Helpers that several commands share.

// "1,2,3" as three numbers; the error names the option.
Result<std::vector<double>> parse_numbers(const std::string& text, std::size_t count, const std::string& option);

}  // namespace glisson::cli

#pragma once
// Runs a program as a person would from a shell, and keeps what it said.

#include <filesystem>
#include <string>
#include <vector>

#include "base/json.h"

namespace glisson::test {

struct Finished {
  int exit_code = -1;
  std::string out;
  std::string err;

  // The one JSON document that --json promises; a test failure where stdout holds anything else.
  [[nodiscard]] Json json() const;
};

Finished run(const std::filesystem::path& program, const std::vector<std::string>& arguments);

// The glisson-cli of this build.
Finished glisson_cli(const std::vector<std::string>& arguments);

}  // namespace glisson::test

#pragma once
// What the program answers to a command, as JSON; anything but success fails the test.

#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "base/json.h"
#include "support/process.h"

namespace glisson::test {

inline Json answer(std::vector<std::string> arguments) {
  arguments.insert(arguments.end(), {"--json", "--quiet"});
  const Finished finished = glisson_cli(arguments);
  EXPECT_EQ(finished.exit_code, 0) << arguments.front() << ": " << finished.err << finished.out;
  return finished.exit_code == 0 ? finished.json() : Json::object();
}

}  // namespace glisson::test

#pragma once
// Where the tests find real data: $GLISSON_SHARED_DATA, or shared/data beside the project.

#include <gtest/gtest.h>
#include <cstdlib>
#include <filesystem>

#include "support/folders.h"

namespace glisson::test {

inline std::filesystem::path shared_data() {
  if (const char* chosen = std::getenv("GLISSON_SHARED_DATA")) return chosen;
  return glisson::test::source_folder().parent_path() / "shared" / "data";
}

}  // namespace glisson::test

// Skips the test, saying why, where the folder of real data is absent.
#define GLISSON_NEEDS_DATA(folder)                                                  \
  if (!std::filesystem::exists(::glisson::test::shared_data() / (folder)))          \
  GTEST_SKIP() << "no real data at " << (::glisson::test::shared_data() / (folder)) \
               << ": set GLISSON_SHARED_DATA to the folder that holds it"

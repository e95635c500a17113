#pragma once
// What "the same case" means: all entries with their contents.

#include <gtest/gtest.h>
#include <filesystem>
#include <map>
#include <string>

#include "base/files.h"
#include "casefile/case.h"

namespace glisson::casefile::test {

inline std::map<std::string, std::string> contents(const std::filesystem::path& folder) {
  std::map<std::string, std::string> all;
  const auto opened = Case::open(folder);
  for (const Entry& entry : opened->entries()) {
    all[entry.id] = sha256_of_file(folder / entry.file).value_or("missing");
    EXPECT_EQ(all[entry.id], entry.sha256) << entry.id;
  }
  return all;
}

}  // namespace glisson::casefile::test

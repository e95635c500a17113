#pragma once
// A reader of one file as a target of the fuzzers.

#include <utility>

#include "fuzz/target.h"

namespace glisson::fuzz {

// A refusal must say why. `beside` is called once in the folder, for the other files that the reader wants.
template <typename Reader>
Target reader_of(const std::string& name, const std::string& file, std::vector<std::string> good, Reader read,
                 std::function<void(const std::filesystem::path&)> beside = {}) {
  const auto run = [=](const std::string& bytes, const std::filesystem::path& folder) {
    if (beside && !std::filesystem::exists(folder / "beside")) {
      beside(folder);
      file_of("", folder, "beside");
    }
    const auto answer = read(file_of(bytes, folder, file));
    if (!answer) promise(!answer.error().message().empty() && !answer.error().code.empty(), "a refusal says why");
  };
  return {name, [good = std::move(good)](const std::filesystem::path&) { return good; }, run};
}

}  // namespace glisson::fuzz

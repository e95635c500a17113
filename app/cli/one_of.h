#pragma once
// An option that takes one of several words: --help shows them as {icp,geo}, and completion offers them.

#include <CLI/CLI.hpp>
#include <string>
#include <utility>
#include <vector>

namespace glisson::cli {

// In the order in which they are to be shown.
template <typename Value>
using Words = std::vector<std::pair<std::string, Value>>;

// The error names the words that there are.
template <typename Value>
CLI::Validator one_of(Words<Value> words) {
  std::string shown;
  for (const auto& [word, value] : words) shown += (shown.empty() ? "" : ",") + word;
  CLI::CheckedTransformer transformer(std::move(words));
  transformer.description("{" + shown + "}");
  return transformer;
}

}  // namespace glisson::cli

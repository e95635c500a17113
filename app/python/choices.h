#pragma once
// Words of Python for choices of the core.

#include <string>
#include <utility>
#include <vector>

#include "errors.h"

namespace glisson::python {

// Failure: "choice-unknown", with the words there are.
template <typename T>
T chosen(const std::string& argument, const std::string& word, const std::vector<std::pair<const char*, T>>& choices) {
  std::string words;
  for (const auto& [called, choice] : choices) {
    if (word == called) return choice;
    words += (words.empty() ? "" : ", ") + std::string(called);
  }
  raise("choice-unknown", "{0} cannot be \"{1}\".", {argument, word}, "There are " + words + ".");
}

}  // namespace glisson::python

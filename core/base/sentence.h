#pragma once
// Something that a person should read, with its figures apart so that it can be translated.

#include <string>
#include <vector>

#include "base/result.h"

namespace glisson {

struct Sentence {
  std::string text;  // GLISSON_TEXT, with {0}, {1}, ... for the arguments
  std::vector<std::string> arguments;

  [[nodiscard]] std::string message() const { return fill_in(text, arguments); }
};

[[nodiscard]] inline std::vector<std::string> messages(const std::vector<Sentence>& sentences) {
  std::vector<std::string> all;
  for (const Sentence& sentence : sentences) all.push_back(sentence.message());
  return all;
}

}  // namespace glisson

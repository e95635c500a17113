#pragma once
// Words of Python for choices of the core.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "errors.h"
#include "segmentation/segment_vessels.h"

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

// Absent where no word is given.
inline std::optional<segmentation::VesselBrightness> brightness_chosen(const std::optional<std::string>& word) {
  using segmentation::VesselBrightness;
  if (!word) return std::nullopt;
  return chosen<VesselBrightness>("brightness", *word,
                                  {{"bright", VesselBrightness::bright}, {"dark", VesselBrightness::dark}});
}

}  // namespace glisson::python

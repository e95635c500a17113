#pragma once
// How the page of a patient, or of what measurements showed, puts things, in whatever language: English, unless whoever
// asks for the page gives words of their own. Figures are filled in as they stand, with a dot.

#include <functional>
#include <string>
#include <vector>

#include "base/sentence.h"

namespace glisson::report {

// "portal-vein-2" -> "Portal vein 2".
[[nodiscard]] std::string plain_name(const std::string& id);

struct Words {
  std::string language = "en";  // as HTML has it
  std::function<std::string(const Sentence&)> sentence = [](const Sentence& said) { return said.message(); };
  std::function<std::string(const std::string& id)> name = plain_name;  // of a structure or landmark
  // An effect of the closed loop, or a parameter of one: "support-compliance" as it is.
  std::function<std::string(const std::string& kind)> effect = [](const std::string& kind) { return kind; };

  // `text` is a GLISSON_TEXT.
  [[nodiscard]] std::string say(const char* text, std::vector<std::string> arguments = {}) const {
    return sentence({text, std::move(arguments)});
  }
  // The same within a sentence: in quotes where it is more than a name.
  [[nodiscard]] std::string quoted_effect(const std::string& kind) const;
  // An entry of the case: "labels/portal-vein-2" -> "Outline: Portal vein 2".
  [[nodiscard]] std::string entry(const std::string& id) const;
  // What made an entry, by the command that does: "segment" -> "outlined". Any other stays.
  [[nodiscard]] std::string way(const std::string& command) const;
};

}  // namespace glisson::report

#pragma once
// A sentence in its pieces, as case.json and the history's files hold it, so that it can be told in any language.
// What is malformed throws Json::exception.

#include "base/json.h"
#include "base/sentence.h"

namespace glisson::casefile {

using glisson::json_of;  // beside those of this room

[[nodiscard]] inline Json json_of(const Sentence& sentence) {
  return Json{{"text", sentence.text}, {"arguments", sentence.arguments}};
}
[[nodiscard]] inline Sentence sentence_from(const Json& json) { return {json.at("text"), json.at("arguments")}; }

}  // namespace glisson::casefile

#include "evidence_answer.h"

#include <fmt/format.h>

namespace glisson::cli {

Json evidence_json(const casefile::Evidence& evidence) {
  Json json{{"effects", Json::array()}, {"remarks", messages(evidence.remarks)}};
  for (const closedloop::LearntEffect& effect : evidence.effects) {
    json["effects"].push_back(
        {{"kind", effect.kind}, {"carried", effect.carried}, {"sentence", effect.sentence.message()}});
  }
  return json;
}

std::string evidence_text(const casefile::Evidence& evidence) {
  std::string text;
  for (const closedloop::LearntEffect& effect : evidence.effects) {
    text += fmt::format("{:20} {}{}\n", effect.kind, effect.carried ? "" : "(not carried) ", effect.sentence.message());
  }
  for (const Sentence& remark : evidence.remarks) text += "Note: " + remark.message() + "\n";
  return text;
}

}  // namespace glisson::cli

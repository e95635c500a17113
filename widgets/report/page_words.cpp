#include "widgets/report/page_words.h"

#include "widgets/evidence/effect_words.h"
#include "widgets/words/language.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {

report::Words words_of_the_window() {
  return {.language = spoken_language().toStdString(),
          .sentence = [](const Sentence& said) { return translated(said).toStdString(); },
          .name = [](const std::string& id) { return structure_label(id).toStdString(); },
          .effect = [](const std::string& kind) { return effect_or_parameter_label(kind).toStdString(); }};
}

}  // namespace glisson::widgets

#pragma once
// What comes from the core, as a person reads it in the language of the window. The core's sentences stand there in
// English, marked GLISSON_TEXT; the translations know them under the context "errors".

#include <QString>
#include <QtGlobal>
#include <string>

#include "base/result.h"
#include "base/sentence.h"

namespace glisson::widgets {

// An error: the sentence, then what to do.
[[nodiscard]] QString translated(const Error& error);

[[nodiscard]] QString translated(const Sentence& sentence);

// A marked sentence or name; anything else stays as it is.
[[nodiscard]] QString translated(const std::string& sentence);

// A stage of a long computation: a marked sentence, or one and what it is about ("Writing: labels/liver").
[[nodiscard]] QString translated_stage(const QString& stage);

// "portal-vein-2" -> "Portal vein 2": a structure or landmark. Names that people gave stay theirs.
[[nodiscard]] QString structure_label(const std::string& name);

// A patient's name is theirs; the demo patient's is ours.
inline constexpr const char* demo_patient_name = QT_TRANSLATE_NOOP("patients", "Demo patient");
[[nodiscard]] QString patient_label(const std::string& name);

}  // namespace glisson::widgets

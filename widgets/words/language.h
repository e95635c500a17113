#pragma once
// The language of the window: the system's or the person's choice, kept between runs and switched while running.
//
// The texts stand in English in the sources; translations/ holds the others, and packaging/words keeps them
// complete.

#include <QString>
#include <vector>

namespace glisson::widgets {

struct Language {
  QString code;  // "de"; empty for whatever the system speaks
  QString name;  // in that language itself, so that it is found by whoever cannot read the others
};

// The languages that the window speaks, English first.
[[nodiscard]] const std::vector<Language>& languages();

// What was chosen the last time; empty for the system's.
[[nodiscard]] QString kept_language();

// What the window speaks now, as a code of languages(); English until one is chosen or begun in.
[[nodiscard]] QString spoken_language();

// Keeps the choice and speaks that language from now on. Every widget gets QEvent::LanguageChange (see
// keep_translated.h).
void choose_language(const QString& code);

// At the start of the program: the kept language, and numbers as below.
//
// Numbers are written and read with a dot and without group separators in every language. A figure may be read off one
// screen and typed on another, or copied into a file. It must not change by a factor of a thousand.
void begin_in_kept_language();

}  // namespace glisson::widgets

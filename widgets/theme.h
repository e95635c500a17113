#pragma once
// How the window looks: dark, as in a darkened reading room, or light. The pictures of the patient stay on black in
// both.

#include <QColor>

namespace glisson::widgets {

enum class Theme { dark, light };

// Style, palette and style sheet of the whole application; may be called again at any time.
void apply_theme(Theme theme);

// A colour of resources/themes/*.colours in the theme of now, for what a style sheet cannot reach. Asked for when
// drawing.
[[nodiscard]] QColor theme_colour(const char* name);

// What was chosen the last time, dark at first; keep_theme() keeps a choice and applies it.
[[nodiscard]] Theme kept_theme();
void keep_theme(Theme theme);

}  // namespace glisson::widgets

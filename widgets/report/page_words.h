#pragma once
// How the window puts what the core writes on pages: its language and its names.

#include "report/words.h"

namespace glisson::widgets {

[[nodiscard]] report::Words words_of_the_window();

}  // namespace glisson::widgets

#pragma once
// A small square of a structure's colour, for lists.

#include <QIcon>

#include "scene/colour.h"

namespace glisson::widgets {

[[nodiscard]] QIcon swatch(const scene::Colour& colour);

}  // namespace glisson::widgets

#pragma once
// How each structure of the liver looks, the same in every picture and in the window.

#include <string_view>

#include "scene/scene.h"

namespace glisson::scene {

struct Appearance {
  Colour colour;
  double opacity = 1;
  Finish finish = Finish::solid;
};

// By the structure's name as it stands in a case, and a calm grey-blue for a name not known. Names are "liver",
// "tumour-1", "portal-vein", "hepatic-veins", "arteries", "gallbladder", "cyst-2", "bile-ducts". Colour is never the
// only way to tell two apart: they differ in lightness too, and lists show the name.
[[nodiscard]] Appearance appearance_of(std::string_view structure);

}  // namespace glisson::scene

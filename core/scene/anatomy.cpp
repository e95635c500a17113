#include "scene/anatomy.h"

#include <array>

namespace glisson::scene {
namespace {

struct Style {
  std::string_view beginning;  // of the structure's name
  Appearance appearance;
};

// Colours near the tissue's own, veins blue and arteries red as atlases have them, the tumour in a yellow that nothing
// else in the abdomen has.
constexpr std::array<Style, 12> styles{{
    {"liver", {{0.90, 0.50, 0.42}, 0.72, Finish::glass}},
    {"tumour", {{0.98, 0.80, 0.22}, 1.0, Finish::solid}},
    {"tumor", {{0.98, 0.80, 0.22}, 1.0, Finish::solid}},
    {"portal-vein", {{0.52, 0.45, 0.86}, 1.0, Finish::solid}},
    {"hepatic-vein", {{0.25, 0.56, 0.90}, 1.0, Finish::solid}},
    {"gastric-vein", {{0.44, 0.66, 0.90}, 1.0, Finish::solid}},
    {"arter", {{0.87, 0.23, 0.24}, 1.0, Finish::solid}},
    {"hepatic-arter", {{0.87, 0.23, 0.24}, 1.0, Finish::solid}},
    {"gallbladder", {{0.36, 0.62, 0.36}, 1.0, Finish::solid}},
    {"bil", {{0.20, 0.45, 0.28}, 1.0, Finish::solid}},
    {"cyst", {{0.70, 0.88, 0.92}, 1.0, Finish::solid}},
    {"vessel", {{0.25, 0.56, 0.90}, 1.0, Finish::solid}},
}};

constexpr Appearance of_anything_else{{0.62, 0.68, 0.76}, 1.0, Finish::solid};

}  // namespace

Appearance appearance_of(std::string_view structure) {
  for (const Style& style : styles) {
    if (structure.starts_with(style.beginning)) return style.appearance;
  }
  return of_anything_else;
}

}  // namespace glisson::scene

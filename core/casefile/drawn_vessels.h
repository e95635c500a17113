#pragma once
// Vessels as pictures show them: what is too thin for the voxels as tubes (vasculature/tubes.h).

#include <optional>
#include <string>

#include "geometry/surface.h"
#include "segmentation/structures.h"

namespace glisson::casefile {

// By its name: a vein, an artery, bile ducts, or vessels without a word of whose.
[[nodiscard]] bool may_be_drawn_as_tubes(const std::string& structure);

// `outline` is the structure's smooth one. Nothing where it is drawn as it is: no vessel by its name, nothing thin, or
// no lines to be found in it.
std::optional<geometry::Surface> drawn_vessel(const segmentation::Structure& structure,
                                              const geometry::Surface& outline);

}  // namespace glisson::casefile

#pragma once
// Fields that follow their points or cells when a mesh is taken apart.

#include <string>
#include <vector>

#include "geometry/field.h"

namespace glisson::geometry {

// The values of the items named, in that order. Every item must exist in every field.
[[nodiscard]] Fields select(const Fields& fields, const std::vector<int>& items);

// "youngs_modulus_kPa, wall", for a person; "none" where there is none.
[[nodiscard]] std::string names_of(const Fields& fields);

}  // namespace glisson::geometry

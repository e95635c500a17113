#pragma once

namespace glisson::mechanics {

// How right displacements must be: to be seen and summed up, or for differences of nearly equal ones too.
enum class Digits { seen, all };

}  // namespace glisson::mechanics

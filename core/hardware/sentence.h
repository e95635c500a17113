#pragma once
// Sentences under the room's own name.

#include "base/sentence.h"

namespace glisson::hardware {

using glisson::Sentence;

}  // namespace glisson::hardware

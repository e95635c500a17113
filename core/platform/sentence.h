#pragma once
// Sentences under the room's own name.

#include "base/sentence.h"

namespace glisson::platform {

using glisson::Sentence;

}  // namespace glisson::platform

#pragma once
// A session as Python holds it.

#include "rehearsal/session.h"

namespace glisson::python {

// The engine forgets what it was told; a recording is kept here.
struct Session {
  rehearsal::SessionEngine engine;
  rehearsal::Recording recording;
};

}  // namespace glisson::python

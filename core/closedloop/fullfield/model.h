#pragma once
// A plate in plane strain as a forward model. From what the machine prescribes and a hyperelastic law follow the
// displacement of its points and the forces at its borders. Effects are laws in place of the declared one, all numbers
// free.

#include <memory>

#include "base/progress.h"
#include "closedloop/experiment/forward_model.h"

namespace glisson::closedloop {

// For an experiment that was read to be explained (Needs::measurements) the model first looks at what was measured.
// That says where fits begin, how large the noise is, and which solution the data are (reading()). It then solves on
// linear triangles and adds what quadratic ones change at a law near the best (internal/reference.h). For one that was
// read for its conditions alone it solves on quadratic triangles, whatever was measured. Fails where the declared law
// has no equilibrium.
Result<std::unique_ptr<ForwardModel>> full_field_model(FullField field, const Progress& progress = {});

}  // namespace glisson::closedloop

#pragma once
// Recordings of a worn computer and its battery as a forward model: voltage, temperature and power at every sample.

#include <memory>

#include "closedloop/experiment/forward_model.h"

namespace glisson::closedloop {

// Refused ("experiment-invalid"): recordings of which the declared figures predict nothing.
Result<std::unique_ptr<ForwardModel>> hardware_model(Hardware hardware);

}  // namespace glisson::closedloop

#pragma once
// A material test as a forward model: the stress at every sample of the prescribed stretch.

#include <memory>

#include "closedloop/experiment/forward_model.h"

namespace glisson::closedloop {

Result<std::unique_ptr<ForwardModel>> material_model(Material material);

}  // namespace glisson::closedloop

#pragma once
// What there is to say about one platform, as HTML: idle first, what limits it, what would make it hold, and where each
// of its figures comes from.

#include <QString>

#include "platform/plan.h"

namespace glisson::widgets {

[[nodiscard]] QString platform_in_full(const platform::PlatformAnswer& answer, const platform::Device& device,
                                       const platform::PlanRequest& request);

}  // namespace glisson::widgets

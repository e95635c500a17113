#pragma once
// What there is to say about one platform, as HTML. Idle comes first, then what limits it, what would make it hold, and
// where each of its figures comes from.

#include <QString>

#include "hardware/plan.h"

namespace glisson::widgets {

[[nodiscard]] QString platform_in_full(const hardware::DevicePlan& answer, const hardware::Device& device,
                                       const hardware::PlanRequest& request);

// A task that ships by its workspace; any other as its table has it.
[[nodiscard]] QString task_in_words(const hardware::Task& task);

}  // namespace glisson::widgets

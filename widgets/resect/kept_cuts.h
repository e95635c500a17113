#pragma once
// Cuts as a small value of the case's history (widgets/session/undo.h): a plan as its file has it, or null for none.

#include <QJsonValue>
#include <vector>

#include "planning/cut.h"

namespace glisson::widgets {

[[nodiscard]] QJsonValue value_of(const std::vector<planning::Cut>& cuts);
// None where the value is damaged.
[[nodiscard]] std::vector<planning::Cut> cuts_of(const QJsonValue& value);

}  // namespace glisson::widgets

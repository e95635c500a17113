#pragma once
// Which page of the manual is about what is on the screen.

#include <QString>

namespace glisson::widgets {

// A page's file name without its ending; the first page for what has none of its own.
[[nodiscard]] QString manual_page_of(const QString& workspace_id);

}  // namespace glisson::widgets

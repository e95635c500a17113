#pragma once
// How the window looks: dark by default, as in a darkened reading room.

class QApplication;

namespace glisson::widgets {

void apply_dark_theme(QApplication& application);

}  // namespace glisson::widgets

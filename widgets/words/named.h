#pragma once
// Names for whoever has the window read aloud. A control that has neither a text nor a name of its own takes that of
// what it is a part of. Else it takes the label beside or above it, or the first line of its tooltip. Called again
// after a change of language.

#include <QWidget>

namespace glisson::widgets {

void name_controls(QWidget& within);
// What name_controls looks at: buttons, sliders, boxes, lists and views that the keyboard reaches.
[[nodiscard]] bool is_control(const QWidget& widget);

}  // namespace glisson::widgets

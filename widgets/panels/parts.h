#pragma once
// The small things that panels are made of. How they look stands in resources/themes/window.qss, by their object names.

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

namespace glisson::widgets {

[[nodiscard]] QLabel* heading(QWidget* parent = nullptr);
// Breaks its lines where the panel ends.
[[nodiscard]] QLabel* wrapped_label(const char* name, QWidget* parent = nullptr);
// A label that takes no room while it has nothing to say.
void show_text(QLabel* label, const QString& text);
// A text of a whole page, in its middle, as wide as is read easily; a layout's alignment would cut wrapped lines off.
[[nodiscard]] QHBoxLayout* in_the_middle(QLabel* text);
[[nodiscard]] QPushButton* named_button(const char* name, QWidget* parent = nullptr);
// Shows a widget as wide as there is room, and scrolls up and down when it is taller.
[[nodiscard]] QScrollArea* scrolled(QWidget* widget);

// A panel beside the views, top to bottom: its title, what it still needs, its controls, which scroll.
struct SidePanel {
  QLabel* title;
  QLabel* missing;
  QWidget* controls;
  QVBoxLayout* column;  // of the controls
};
[[nodiscard]] SidePanel lay_out_side_panel(QWidget* panel);

}  // namespace glisson::widgets

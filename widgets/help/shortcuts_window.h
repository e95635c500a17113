#pragma once
// Every key of the window, read from the window itself, so that the list cannot be wrong. A key belongs to an action in
// a menu, or to a QShortcut or button that says in its whatsThis or tooltip what it does.

#include <QWidget>

namespace glisson::widgets {

class ShortcutsWindow : public QWidget {
  Q_OBJECT

 public:
  // Lists the keys of `window`, as they are now.
  explicit ShortcutsWindow(QWidget* window);
};

}  // namespace glisson::widgets

#pragma once
// What widget tests begin with: the window shown, a child of it by its object name, and a key pressed in it.

#include <memory>
#include <QApplication>
#include <QtTest>

#include "widgets/main_window.h"

namespace glisson::widgets {

[[nodiscard]] inline std::unique_ptr<MainWindow> shown_window(const QSize& size = {1400, 900}) {
  auto window = std::make_unique<MainWindow>();
  window->resize(size);
  window->show();
  if (!QTest::qWaitForWindowExposed(window.get())) qFatal("the window does not appear");
  return window;
}

// Never null: a test that asks for what is not there ends.
template <typename Widget>
[[nodiscard]] Widget* child_of(const QObject& parent, const char* name) {
  auto* found = parent.findChild<Widget*>(name);
  if (found == nullptr) qFatal("there is no %s", name);
  return found;
}

// A key of the menus and buttons. Qt gives those to the active window alone, and which window of the X server that is,
// tests that run at the same time would take from each other: so it is said here, for this key.
inline void press_key(QWidget& window, Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
  QApplication::setActiveWindow(&window);
  QTest::keyClick(&window, key, modifiers);
}

}  // namespace glisson::widgets

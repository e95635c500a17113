#pragma once
// What widget tests begin with: the window shown, and a child of it by its object name.

#include <memory>
#include <QtTest>

#include "main_window.h"

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

}  // namespace glisson::widgets

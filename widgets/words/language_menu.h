#pragma once
// The menu of languages: the system's, then those that the window speaks, each by its own name.

#include <QMenu>

namespace glisson::widgets {

class LanguageMenu : public QMenu {
  Q_OBJECT

 public:
  explicit LanguageMenu(QWidget* parent = nullptr);
};

}  // namespace glisson::widgets

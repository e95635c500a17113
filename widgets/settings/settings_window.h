#pragma once
// The settings: how the window looks and speaks, what it may take and what it may tell. Each holds at once; there is
// nothing to confirm.

#include <QDialog>

namespace glisson::widgets {

class SettingsWindow : public QDialog {
  Q_OBJECT

 public:
  explicit SettingsWindow(QWidget* parent = nullptr);
};

}  // namespace glisson::widgets

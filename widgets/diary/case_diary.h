#pragma once
// What was done to the open case, step by step as its history keeps it. It can be copied as a program that does it
// again without a window.

#include <filesystem>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QWidget>
#include <string>

#include "casefile/macro.h"
#include "widgets/session/undo.h"

namespace glisson::widgets {

class CaseDiary : public QWidget {
  Q_OBJECT

 public:
  // Stays with this case, whichever is opened later.
  CaseDiary(Undo& undo, std::filesystem::path case_folder, QWidget* parent = nullptr);

 private:
  void list();
  void copy(std::string (*written)(const casefile::Macro&));

  Undo& undo_;
  std::filesystem::path folder_;
  QLabel* about_;
  QListWidget* steps_;
  QPushButton* copy_python_;
  QPushButton* copy_command_line_;
  QLabel* said_;
};

}  // namespace glisson::widgets

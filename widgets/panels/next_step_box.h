#pragma once
// Below the patient: what is to be done next with the case, and the button that does it.

#include <filesystem>
#include <QLabel>
#include <QPushButton>

#include "widgets/session/load_patient.h"

namespace glisson::widgets {

class NextStepBox : public QWidget {
  Q_OBJECT

 public:
  explicit NextStepBox(QWidget* parent = nullptr);

  // Hidden where nothing is to be done; an empty folder is no case.
  void show_case(const std::filesystem::path& folder);

 Q_SIGNALS:
  void wanted(NextStep step);
  void waves_wanted();

 private:
  void update_text();

  NextStep next_ = NextStep::none;
  QLabel* text_;
  QPushButton* button_;
  QLabel* waves_text_;  // raw elastography that nobody has inverted yet
  QPushButton* waves_;
};

}  // namespace glisson::widgets

#pragma once
// The planned cut, led through the liver while tools hold it: a step on, the last one back, and how far it is.

#include <optional>
#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include "base/sentence.h"
#include "rehearsal/cut_course.h"
#include "widgets/session/live_rehearsal.h"

namespace glisson::widgets {

class AdvanceControls : public QWidget {
  Q_OBJECT

 public:
  explicit AdvanceControls(LiveRehearsal& rehearsal, QWidget* parent = nullptr);

  // The plan's cut through the liver, or why there is none to lead.
  void set_course(std::optional<rehearsal::CutCourse> course, std::optional<Sentence> why_not);
  void set_structure_names(std::vector<std::string> names);  // in the order of the rehearsal's

 private:
  void advance();
  void take_back();
  void show_state();

  LiveRehearsal& rehearsal_;
  std::optional<rehearsal::CutCourse> course_;
  std::optional<Sentence> why_not_;
  std::vector<std::string> names_;
  QLabel* title_;
  QPushButton* advance_;
  QPushButton* back_;
  QLabel* state_;
};

}  // namespace glisson::widgets

#pragma once
// The planned cut, led through the liver while tools hold it: a step on, the last one back, and how far it is. Beside
// it the knife for a cut drawn freehand (freehand_knife.h), and how deep that goes.

#include <optional>
#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include "base/sentence.h"
#include "rehearsal/cut_course.h"
#include "widgets/session/live_rehearsal.h"
#include "widgets/words/number_box.h"

namespace glisson::widgets {

class AdvanceControls : public QWidget {
  Q_OBJECT

 public:
  explicit AdvanceControls(LiveRehearsal& rehearsal, QWidget* parent = nullptr);

  // The plan's cut through the liver, or why there is none to lead.
  void set_course(std::optional<rehearsal::CutCourse> course, std::optional<Sentence> why_not);
  void set_structure_names(std::vector<std::string> names);  // in the order of the rehearsal's

  [[nodiscard]] bool knife_in_hand() const { return freehand_->isChecked(); }
  [[nodiscard]] double depth_mm() const { return depth_->value(); }
  void put_knife_away() { freehand_->setChecked(false); }

 Q_SIGNALS:
  void knife_changed();  // in hand or not, or how deep

 private:
  void advance();
  void take_back();
  void show_state();
  [[nodiscard]] double planned_mm() const;  // of the plan's cut, what is cut
  [[nodiscard]] QString words_of_cut(const rehearsal::SessionCut& cut) const;

  LiveRehearsal& rehearsal_;
  std::optional<rehearsal::CutCourse> course_;
  std::optional<Sentence> why_not_;
  std::vector<std::string> names_;
  QLabel* title_;
  QPushButton* advance_;
  QPushButton* back_;
  QWidget* by_hand_;
  QPushButton* freehand_;
  QLabel* depth_name_;
  NumberBox* depth_;
  QLabel* state_;
};

}  // namespace glisson::widgets

#pragma once
// What measurements showed, to be read from top to bottom. First comes the verdict, then the errors before and after
// with pictures of what is left. The candidates follow with their evidence, and at last what to measure next.

#include <memory>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSplitter>
#include <QWidget>

#include "closedloop/explain.h"
#include "widgets/evidence/evidence_record.h"
#include "widgets/evidence/evidence_tables.h"
#include "widgets/evidence/probability_bars.h"
#include "widgets/evidence/residual_scene.h"
#include "widgets/views/space_view.h"

namespace glisson::widgets {

class EvidenceAnswer : public QScrollArea {
  Q_OBJECT

 public:
  explicit EvidenceAnswer(QWidget* parent = nullptr);

  // `explained` where it was computed now: then what is left is shown in space too.
  void show_record(std::shared_ptr<const EvidenceRecord> record,
                   std::shared_ptr<const closedloop::Explained> explained = nullptr);
  // The same in another language: drawings hold words too.
  void reword(std::shared_ptr<const EvidenceRecord> record);
  [[nodiscard]] FoundTree& found() { return *found_; }
  [[nodiscard]] SpaceView& residual_space() { return *space_; }

 private:
  QWidget* make_residual();
  QWidget* make_numbers();
  void update_text();
  [[nodiscard]] static QString next_measurement(const EvidenceRecord& record);
  void show_residual();
  void show_drawings();

  std::shared_ptr<const EvidenceRecord> record_;
  std::shared_ptr<const closedloop::Explained> explained_;
  QLabel* verdict_;
  ProbabilityBars* probabilities_;
  QCheckBox* details_;  // numbers and candidates: hidden until asked for
  QLabel* shape_;
  QSplitter* across_;
  QWidget* residual_;
  SpaceView* space_;
  QComboBox* trial_;
  QPushButton* before_;
  QPushButton* after_;
  QLabel* scale_text_;
  QWidget* drawings_;
  ErrorsTable* errors_;
  FoundTree* found_;
  CandidatesTable* candidates_;
  QLabel* candidates_title_;
  VisibleTable* visible_;
  QLabel* visible_title_;
  QLabel* next_title_;
  QLabel* next_;
  QLabel* notes_;
};

}  // namespace glisson::widgets

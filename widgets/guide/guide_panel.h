#pragma once
// What can be done on the Guide page. The liver is found, placed by hand and refined, or lines of it are marked. A
// person says how its outlines are shown, and from which error on they are not to be trusted. It lists what they are,
// by name.

#include <QCheckBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSlider>
#include <QVBoxLayout>
#include <QWidget>

#include "widgets/guide/line_panel.h"
#include "widgets/guide/overlay_painter.h"
#include "widgets/guide/target_table.h"

namespace glisson::widgets {

class GuidePanel : public QWidget {
  Q_OBJECT

 public:
  enum class Work { none, placing, filming };
  struct State {
    Work work = Work::none;
    bool has_hand_pose = false;  // of this sequence
    bool has_camera = true;
    bool anything_placed = false;
  };

  explicit GuidePanel(QWidget* parent = nullptr);

  void show_state(const State& state);
  void show_progress(double fraction, const QString& stage);
  void set_by_hand(bool by_hand) { by_hand_->setChecked(by_hand); }
  [[nodiscard]] bool by_hand() const { return by_hand_->isChecked(); }
  [[nodiscard]] OverlayLook look() const;
  void turn_outlines() { shown_->toggle(); }
  [[nodiscard]] TargetTable& targets() { return *targets_; }
  [[nodiscard]] LinePanel& lines() const { return *lines_; }

 Q_SIGNALS:
  void placing_wanted();
  void refining_wanted();
  void cancel_wanted();
  void by_hand_changed(bool by_hand);
  void look_changed();
  void film_wanted();

 private:
  void add_placing(QVBoxLayout& column);
  void add_look(QVBoxLayout& column);
  void update_text();

  State state_;
  QPushButton* place_;
  QProgressBar* progress_;
  QPushButton* cancel_;
  QLabel* stage_;
  QPushButton* by_hand_;
  QPushButton* refine_;
  QLabel* hand_help_;
  LinePanel* lines_;
  QCheckBox* shown_;
  QSlider* opacity_;
  std::vector<QPushButton*> tolerances_;
  TargetTable* targets_;
  QPushButton* film_;
};

}  // namespace glisson::widgets

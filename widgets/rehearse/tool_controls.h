#pragma once
// Which tool, where, which way and how hard.

#include <QCheckBox>
#include <QComboBox>
#include <QPushButton>
#include <QWidget>

#include "widgets/rehearse/marked_slider.h"
#include "widgets/session/live_rehearsal.h"
#include "widgets/words/number_box.h"

namespace glisson::widgets {

class ToolControls : public QWidget {
  Q_OBJECT

 public:
  explicit ToolControls(LiveRehearsal& rehearsal, QWidget* parent = nullptr);

  // A place of the liver's surface at rest, with its outward normal.
  void place_at(const Eigen::Vector3d& position_mm, const Eigen::Vector3d& outward);
  // The retractor under segment VI, with its usual force.
  void hoist_segment_vi();
  // As the arrow was dragged; the force stays within what the tool may.
  void pull(const Eigen::Vector3d& direction, double force_N);
  // A tool kept elsewhere came to hand, or the state changed.
  void follow();

  [[nodiscard]] bool placing() const { return place_->isChecked(); }
  void stop_placing() { place_->setChecked(false); }

 Q_SIGNALS:
  void placing_changed(bool placing);
  void place_at_crosshair();
  void failed(const glisson::Error& error);

 private:
  enum Direction { hoist, pull_away, push, dragged };

  [[nodiscard]] const rehearsal::ToolPreset& preset() const;
  void preset_chosen();
  void apply_direction();
  [[nodiscard]] Eigen::Vector3d chosen_direction() const;
  void show_force(double force_N);
  void show_current_tool();
  void mark_where_the_model_ends();
  void set_force(double force_N);
  void hold(const Eigen::Vector3d& center_mm);
  void update_text();

  LiveRehearsal& rehearsal_;
  bool force_is_usual_ = true;         // nobody has chosen it yet
  Eigen::Vector3d outward_{0, -1, 0};  // where the tool stands
  Eigen::Vector3d hoist_direction_;
  Eigen::Vector3d dragged_direction_{0, -1, 0};
  QComboBox* tool_;
  QPushButton* place_;
  QPushButton* hoist_button_;
  QComboBox* direction_;
  MarkedSlider* force_slider_;
  NumberBox* force_;
  QCheckBox* rigid_;
  QPushButton* keep_;
  QPushButton* release_;
};

}  // namespace glisson::widgets

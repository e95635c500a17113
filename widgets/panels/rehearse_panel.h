#pragma once
// The right panel: choose a tool, place it, pull; see what moves and how far.

#include <Eigen/Core>
#include <optional>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QWidget>

#include "casefile/evidence.h"
#include "panels/comparison_choice.h"
#include "panels/landmark_table.h"
#include "rehearsal/tool_presets.h"
#include "session/live_rehearsal.h"
#include "words/number_box.h"

namespace glisson::widgets {

class RehearsePanel : public QWidget {
  Q_OBJECT

 public:
  explicit RehearsePanel(LiveRehearsal& rehearsal, QWidget* parent = nullptr);

  // With a model there is something to rehearse; without, the panel says what is missing.
  void set_ready(bool ready);
  // What measurements changed of the model that is rehearsed, and what of them it cannot hold.
  void show_evidence(const casefile::Evidence& evidence);
  // A click on the liver, while placing: the tool goes there.
  void place_at(const Eigen::Vector3d& position_mm, const Eigen::Vector3d& outward_normal);
  // The retractor under segment VI, with its usual force.
  void hoist_segment_vi();
  [[nodiscard]] bool placing() const { return place_->isChecked(); }
  void show_frame();

 Q_SIGNALS:
  void bodies_chosen(glisson::widgets::Bodies bodies);
  void liver_colour_chosen(glisson::widgets::LiverColour colour);
  void landmark_chosen(const std::string& id);
  void placing_changed(bool placing);

 private:
  enum Direction { hoist, pull, push };

  void word_evidence();
  QWidget* make_tool_group();
  QWidget* make_look_group();
  [[nodiscard]] const rehearsal::ToolPreset& preset() const;
  void preset_chosen();
  void apply_direction();
  void set_force(double force_N);

  LiveRehearsal& rehearsal_;
  Eigen::Vector3d normal_{0, -1, 0};  // outward, where the tool stands
  Eigen::Vector3d hoist_direction_{0, -1, 0};
  QLabel* missing_;
  QLabel* evidence_text_;
  casefile::Evidence evidence_;
  QWidget* controls_;
  QComboBox* tool_;
  QPushButton* place_;
  QPushButton* hoist_button_;
  QComboBox* direction_;
  QSlider* force_slider_;
  NumberBox* force_;
  QPushButton* release_;
  ComparisonChoice* comparison_;
  QCheckBox* by_displacement_;
  QLabel* summary_;
  LandmarkTable* table_;
};

}  // namespace glisson::widgets

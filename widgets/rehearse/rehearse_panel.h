#pragma once
// The right panel: choose a tool, place it, pull; see what moves and how far, now and over time.

#include <functional>
#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QWidget>

#include "casefile/evidence.h"
#include "imaging/image.h"
#include "widgets/panels/fold.h"
#include "widgets/rehearse/advance_controls.h"
#include "widgets/rehearse/comparison_choice.h"
#include "widgets/rehearse/kept_orders.h"
#include "widgets/rehearse/landmark_table.h"
#include "widgets/rehearse/solving_light.h"
#include "widgets/rehearse/tool_controls.h"
#include "widgets/rehearse/track_controls.h"
#include "widgets/session/live_rehearsal.h"
#include "widgets/workspaces/workspace.h"

namespace glisson::widgets {

class RehearsePanel : public QWidget {
  Q_OBJECT

 public:
  explicit RehearsePanel(LiveRehearsal& rehearsal, QWidget* parent = nullptr);

  // As a workspace. `keep_landmarks`: these and no others, one step of undo under that name.
  using KeepLandmarks = std::function<void(const QString& what, const std::vector<mechanics::Landmark>& landmarks)>;
  [[nodiscard]] static Workspace workspace(const WorkspaceContext& context, KeepLandmarks keep_landmarks);

  // With a model there is something to rehearse; without, the panel says what is missing.
  void set_ready(bool ready);
  // What measurements changed of the model that is rehearsed, and what of them it cannot hold.
  void show_evidence(const casefile::Evidence& evidence);
  // What stiffness was assumed, where none was measured.
  void show_assumed_stiffness(const std::optional<Sentence>& assumed);
  // What the model was outlined in: where it ends, a liver that goes on is cut off.
  void show_image(std::shared_ptr<const imaging::Volume> image);
  // Where the planned cut would run, or why it cannot be led; the rehearsal's structures by name.
  void show_plan(std::optional<rehearsal::CutCourse> course, std::optional<Sentence> why_not,
                 std::vector<std::string> structures);
  // The landmarks that were set by hand.
  void show_placed_landmarks(std::vector<mechanics::Landmark> landmarks);
  [[nodiscard]] bool placing() const { return tool_->placing(); }
  void stop_placing() { tool_->stop_placing(); }
  // A click on the liver, while placing, or the tool dragged over it: it goes there (at rest).
  void place_at(const Eigen::Vector3d& position_mm, const Eigen::Vector3d& outward) {
    tool_->place_at(position_mm, outward);
  }
  void hoist_segment_vi() { tool_->hoist_segment_vi(); }
  // A tool as it was held before; its preset is found by its radius.
  void hold_again(PlacedTool tool);
  // The arrow's free end was dragged there from the place that it acts on; then let go.
  void drag_arrow(const Eigen::Vector3d& free_end_mm, const Eigen::Vector3d& touch_mm);
  void let_arrow_go();

  // As the views draw them.
  [[nodiscard]] std::vector<ToolInView> tools_in_view() const;
  [[nodiscard]] TrackControls& track() { return *track_; }
  [[nodiscard]] KeptOrders& orders() { return *orders_; }
  [[nodiscard]] AdvanceControls& cutting() { return *advance_; }
  void show_drawing_ms(double drawing_ms) { light_->show_drawing_ms(drawing_ms); }

 Q_SIGNALS:
  void bodies_chosen(glisson::widgets::Bodies bodies);
  void liver_colour_chosen(glisson::widgets::LiverColour colour);
  void landmark_chosen(const std::string& id);
  void placing_changed(bool placing);
  void place_at_crosshair();
  // A landmark at the crosshair is wanted; or these and no others are to be kept.
  void landmark_wanted(const std::string& name);
  void landmarks_wanted(const QString& what, const std::vector<glisson::mechanics::Landmark>& landmarks);
  void failed(const glisson::Error& error);
  void said(const QString& what);
  void at_work(bool here);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void update_evidence_text();
  QWidget* make_look_group();
  void show_state();
  void show_orders_fold();
  void tell_cap();
  void save_landmarks();
  void rename_landmark(const std::string& id, const QString& typed);
  void remove_landmark();
  void allow_for_landmarks();

  LiveRehearsal& rehearsal_;
  std::optional<bool> dragged_pulls_;  // an arrow does not change sides under the hand
  QLabel* missing_;
  QLabel* evidence_text_;
  casefile::Evidence evidence_;
  QLabel* assumed_text_;
  std::optional<Sentence> assumed_;
  QWidget* controls_;
  QScrollArea* room_;  // of the controls
  ToolControls* tool_;
  SolvingLight* light_;
  AdvanceControls* advance_;
  std::shared_ptr<const imaging::Volume> image_;
  QLabel* on_cap_;
  ComparisonChoice* comparison_;
  QCheckBox* by_displacement_;
  QLabel* summary_;
  QPushButton* set_landmark_;
  QPushButton* remove_landmark_;
  std::vector<mechanics::Landmark> placed_landmarks_;
  LandmarkTable* table_;
  TrackControls* track_;
  KeptOrders* orders_;
  Fold* orders_fold_;
};

}  // namespace glisson::widgets

#pragma once
// Resect: a cutting surface is set on the patient, and what it removes, leaves, nears and crosses is answered while it
// moves. A plane, or a smooth surface through points drawn on the liver.

#include <optional>
#include <QCheckBox>
#include <QJsonValue>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QWidget>

#include "widgets/resect/cut_controls.h"
#include "widgets/resect/cut_handles.h"
#include "widgets/resect/live_resection.h"
#include "widgets/resect/plan_by_anatomy.h"
#include "widgets/resect/resection_results.h"
#include "widgets/resect/resection_scene.h"
#include "widgets/workspaces/workspace.h"

namespace glisson::widgets {

class ResectPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ResectPanel(WorkspaceContext context, QWidget* parent = nullptr);
  [[nodiscard]] static Workspace workspace(WorkspaceContext context);

  void show_patient(const Patient& patient);
  [[nodiscard]] const LiveResection& live() const { return *live_; }
  [[nodiscard]] const PlanByAnatomy& by_anatomy() const { return *by_anatomy_; }
  [[nodiscard]] const std::optional<CutPlane>& plane() const { return plane_; }
  [[nodiscard]] const std::vector<Eigen::Vector3d>& points_mm() const { return points_mm_; }

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  QWidget* make_outcome();
  [[nodiscard]] CutPlane plane_through(const Eigen::Vector3d& place_mm, const Eigen::Vector3d& normal) const;
  void take_click(const Eigen::Vector3d& position_mm);
  void cut_under(const std::vector<planning::SightLine>& line);
  void move_plane(const CutPlane& plane);
  void set_points(std::vector<Eigen::Vector3d> points_mm);
  // Plane or sheet as it has been set, none where it has not.
  [[nodiscard]] std::vector<planning::Cut> surface() const;
  // A person has set or changed the plane or sheet: a step of undo. What is typed in a row is one.
  enum class By { hand, typing };
  void note(By by = By::hand);
  void take_up_kept_plan();
  // A plan that is kept, whole: a step of undo.
  void choose(const planning::Plan& plan);
  // Its plane or sheet; what else it takes, by_anatomy_ knows.
  void take_up(const planning::Plan& plan);
  void set_drawing(bool drawing);
  // The cut has changed: plan it anew, and show where it is.
  void cut_changed();
  void show_result();
  void show_scene();
  void move_drawn_plane();
  void update_text();
  // How the tool in Rehearse holds the liver, where it does and this is asked for.
  void hold_as_rehearsed();
  void describe_holding();
  [[nodiscard]] std::optional<LiveResection::Holding> holding() const;
  [[nodiscard]] std::optional<casefile::PlannedCut> cut() const;
  // What the mesh is divided by: a plane or sheet alone.
  [[nodiscard]] std::optional<casefile::PlannedCut> cut_of_mesh() const;
  [[nodiscard]] QString why_nothing() const;
  [[nodiscard]] geometry::Box around_liver() const;  // within which the plane is drawn

  WorkspaceContext context_;
  LiveResection* live_;
  CutHandles* handles_;
  Patient patient_;
  std::optional<CutPlane> plane_;
  std::vector<Eigen::Vector3d> points_mm_;  // of the sheet
  std::vector<Eigen::Vector3d> clicks_mm_;  // of a plane, until there are three
  casefile::PlannedCut::Removed removed_ = casefile::PlannedCut::Removed::smaller;
  QJsonValue noted_ = QJsonValue::Null;  // the surface that undo knows of
  By last_noted_ = By::hand;
  std::shared_ptr<const geometry::Surface> drawn_plane_;  // within a little more than the liver
  ResectionScene pieces_;
  QWidget* controls_;
  QLabel* missing_;
  CutControls* cut_controls_;
  QCheckBox* as_held_;
  QLabel* held_text_;
  QPushButton* other_part_;
  QPushButton* no_cut_;
  ResectionResults* results_;
  PlanByAnatomy* by_anatomy_;
  QSlider* apart_;
};

}  // namespace glisson::widgets

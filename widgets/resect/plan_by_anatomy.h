#pragma once
// The part of Resect that knows the liver's anatomy. It has the segments as a list and in colours, and cuts of one
// click: segments, around a tumour, along a territory, ablation zones. It shows what a cut leaves alive, which branches
// it takes, and its surface unrolled flat. It has the plans that the case keeps, side by side, and what grew since an
// earlier study. The plan that is kept last, where it is a plane or sheet, is also what Rehearse, Guide and the report
// follow (results/resection).

#include <optional>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QWidget>
#include <vector>

#include "widgets/panels/fold.h"
#include "widgets/resect/ablation_controls.h"
#include "widgets/resect/border_by_hand.h"
#include "widgets/resect/cut_handles.h"
#include "widgets/resect/growth_controls.h"
#include "widgets/resect/live_plan.h"
#include "widgets/resect/live_resection.h"
#include "widgets/resect/plan_list.h"
#include "widgets/resect/resectogram_view.h"
#include "widgets/resect/two_stage_controls.h"
#include "widgets/resect/vessel_click.h"
#include "widgets/words/number_box.h"
#include "widgets/workspaces/workspace.h"

namespace glisson::widgets {

class PlanByAnatomy : public QWidget {
  Q_OBJECT

 public:
  enum SegmentColumn { segment_column, whole_column, stays_column, stiffness_column };
  enum BranchColumn { branch_column, width_column, beyond_column, left_column };

  PlanByAnatomy(WorkspaceContext context, QWidget* parent = nullptr);

  void show_patient(const Patient& patient);
  // The plane or sheet that is set besides.
  void set_surface(const std::optional<casefile::PlannedCut>& surface);
  // The liver divided by it, once that is known.
  void set_resection(const std::shared_ptr<const LiveResectionResult>& resection);
  // No segment and no tumour is taken any more.
  void clear();

  // What is taken besides plane or sheet; where it stands in the history.
  [[nodiscard]] const std::vector<planning::Cut>& taken() const { return taken_; }
  static constexpr const char* taken_key = "resect/taken";
  // What a plan takes besides plane or sheet; no step of undo by itself.
  void take_up(const planning::Plan& plan);
  [[nodiscard]] const LivePlan& live() const { return *live_; }
  void add_to(WorkspaceScene& scene) const;
  // Where somebody told by hand what runs there: vessels, then borders, as LivePlan has them.
  [[nodiscard]] std::vector<ToldPlace> told_places() const;
  // One of these runs there instead, or is told no more. Vessels and segments are found again by it: a step of undo.
  void move_told_place(std::size_t place, const Eigen::Vector3d& position_mm);
  void drop_told_place(std::size_t place);
  // Whether it draws the liver in its parts, so that nobody else need.
  [[nodiscard]] bool draws_liver() const;

 Q_SIGNALS:
  void taken_changed();
  void drawing_changed();
  void told_places_changed();  // or are to be shown as they were, since nothing came of a change
  void plan_chosen(const glisson::planning::Plan& plan);  // to be taken up, here too

 private:
  QWidget* make_anatomy();
  void connect_what_is_told();  // of vessels and borders at the crosshair
  QWidget* make_answer();
  QWidget* make_territory_and_ablation();
  QWidget* make_unrolled();
  void make_plans();
  QWidget* make_growth();
  void find_segments(const vasculature::Told& told);
  [[nodiscard]] vasculature::Told told_before() const;  // by which they were found before
  void take_segments();
  void take_around();
  void take_territory();
  void ablate_tumour();
  // One cut of its kind at a time, but any number of ablations; kinds add to each other. A step of undo.
  void take(const planning::Cut& cut);
  void resize_last_ablation();
  void give_back(std::size_t cut);
  enum class Step { of_its_own, joins_the_last };
  void keep_taken();
  void set_taken(const Sentence& step, std::vector<planning::Cut> taken, Step which = Step::of_its_own);
  void show_taken();
  void suggest_territory();
  void cuts_changed();
  void show_anatomy();
  void show_answer();
  void show_branches(const planning::PlanAnswer& answer);
  void show_unrolled();
  // Whether all is known of the cut as it is now set, so that it can be kept.
  [[nodiscard]] bool complete() const;
  void show_keeping();
  void keep(const QString& name);
  void copy(std::size_t plan);
  void drop(std::size_t plan);
  [[nodiscard]] std::vector<planning::Cut> cuts() const;
  // Whether the liver itself is divided by the cut: by a plane or sheet alone.
  [[nodiscard]] bool divides_liver() const { return surface_ && taken_.empty(); }
  [[nodiscard]] std::vector<int> ticked() const;

  WorkspaceContext context_;
  LivePlan* live_;
  std::filesystem::path folder_;
  std::optional<Eigen::Vector3d> looked_at_mm_;  // while segments are found again
  std::optional<casefile::PlannedCut> surface_;
  std::shared_ptr<const LiveResectionResult> resection_;
  std::vector<planning::Cut> taken_;
  QWidget* by_anatomy_;
  QLabel* text_;
  QPushButton* find_;
  QWidget* anatomy_;
  QTableWidget* segments_;
  QCheckBox* show_segments_;
  QPushButton* take_segments_;
  VesselClick* vessel_click_;
  BorderByHand* border_by_hand_;
  QWidget* around_;
  QComboBox* tumour_;
  NumberBox* margin_;
  QPushButton* take_around_;
  QWidget* along_;
  QComboBox* territory_;
  QPushButton* take_territory_;
  Fold* ablating_;
  AblationControls* ablation_;
  QLabel* taken_text_;
  Fold* staging_;
  TwoStageControls* stages_;
  QWidget* answer_;
  QLabel* alive_;
  QLabel* branches_title_;
  QTableWidget* branches_;
  Fold* unrolled_;
  ResectogramView* resectogram_;
  QLabel* nearest_;
  QLabel* resectogram_key_;
  PlanList* plans_;
  Fold* growing_;
  GrowthControls* growth_;
};

// "Portal vein, right, posterior, VI, 2" of portal/right/posterior/VI/2.
[[nodiscard]] QString branch_label(const std::string& name);

}  // namespace glisson::widgets

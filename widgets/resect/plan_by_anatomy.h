#pragma once
// The part of Resect that knows the liver's anatomy: its segments as a list and in colours, "take these segments" and
// "around this tumour" as cuts of one click, what a cut leaves alive and which branches it takes, and the plans that
// the case keeps, side by side. The one that is kept last, where it is a plane or sheet, is also what Rehearse, Guide
// and the report follow (results/resection).

#include <optional>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QWidget>
#include <vector>

#include "widgets/resect/live_plan.h"
#include "widgets/resect/live_resection.h"
#include "widgets/words/number_box.h"
#include "widgets/workspaces/workspace.h"

namespace glisson::widgets {

class PlanByAnatomy : public QWidget {
  Q_OBJECT

 public:
  enum SegmentColumn { segment_column, whole_column, stays_column, stiffness_column };
  enum BranchColumn { branch_column, width_column, beyond_column, left_column };
  enum PlanColumn { name_column, stays_percent_column, alive_column, plan_margin_column, cut_branches_column };

  PlanByAnatomy(WorkspaceContext context, QWidget* parent = nullptr);

  void show_patient(const Patient& patient);
  // The plane or sheet that is set besides.
  void set_surface(const std::optional<casefile::PlannedCut>& surface);
  // The liver divided by it, once that is known.
  void set_resection(const std::shared_ptr<const LiveResectionResult>& resection);
  // No segment and no tumour is taken any more.
  void clear();

  // What is taken besides plane or sheet.
  [[nodiscard]] const std::vector<planning::Cut>& taken() const { return taken_; }
  [[nodiscard]] const LivePlan& live() const { return *live_; }
  void add_to(WorkspaceScene& scene) const;
  // Whether it draws the liver in its parts, so that nobody else need.
  [[nodiscard]] bool draws_liver() const;

 Q_SIGNALS:
  void taken_changed();
  void drawing_changed();
  void plan_chosen(const glisson::planning::Plan& plan);

 private:
  QWidget* make_anatomy();
  QWidget* make_answer();
  QWidget* make_plans();
  void find_segments();
  void take_segments();
  void take_around();
  void take(const planning::Cut& cut);
  void cuts_changed();
  void show_anatomy();
  void show_answer();
  void show_plans();
  // Whether all is known of the cut as it is now set, so that it can be kept.
  [[nodiscard]] bool complete() const;
  void show_keeping();
  void keep();
  void drop();
  [[nodiscard]] std::vector<planning::Cut> cuts() const;
  // Whether the liver itself is divided by the cut: by a plane or sheet alone.
  [[nodiscard]] bool divides_liver() const { return surface_ && taken_.empty(); }
  [[nodiscard]] std::vector<int> ticked() const;

  WorkspaceContext context_;
  LivePlan* live_;
  std::filesystem::path folder_;
  std::optional<casefile::PlannedCut> surface_;
  std::shared_ptr<const LiveResectionResult> resection_;
  std::vector<planning::Cut> taken_;
  QWidget* by_anatomy_;
  QLabel* told_;
  QPushButton* find_;
  QWidget* anatomy_;
  QTableWidget* segments_;
  QCheckBox* show_segments_;
  QPushButton* take_segments_;
  QWidget* around_;
  QComboBox* tumour_;
  NumberBox* margin_;
  QPushButton* take_around_;
  QWidget* answer_;
  QLabel* alive_;
  QLabel* branches_title_;
  QTableWidget* branches_;
  QWidget* plans_box_;
  QTableWidget* plans_;
  QLineEdit* name_;
  QPushButton* keep_;
  QPushButton* drop_;
};

// "Portal vein, right, posterior, VI, 2" of portal/right/posterior/VI/2.
[[nodiscard]] QString branch_label(const std::string& name);

}  // namespace glisson::widgets

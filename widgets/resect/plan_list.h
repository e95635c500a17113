#pragma once
// The plans that a case keeps, side by side, in the order that the person chooses. Those that another one beats are
// said to be so. All are drawn by margin and by what stays alive. A click takes one up; they are kept, copied and
// dropped by name.

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QWidget>
#include <vector>

#include "widgets/plots/plan_plot.h"
#include "widgets/resect/live_plan.h"

namespace glisson::widgets {

class PlanList : public QWidget {
  Q_OBJECT

 public:
  enum Column { name_column, stays_percent_column, alive_column, margin_column, cut_branches_column };

  explicit PlanList(QWidget* parent = nullptr);

  void show_plans(const std::vector<KeptPlanAnswer>& kept);
  // Which of the plans shown stands in a row.
  [[nodiscard]] std::size_t plan_in(int row) const { return order_[static_cast<std::size_t>(row)]; }
  void set_name(const QString& name) { name_->setText(name); }
  // Whether the plan as it is now set can be kept, and what that does, or why not.
  void allow_keeping(bool allowed, const QString& told);

 Q_SIGNALS:
  void chosen(std::size_t plan);
  void keep_wanted(const QString& name);  // may be empty
  void copy_wanted(std::size_t plan);
  void drop_wanted(std::size_t plan);

 private:
  void update_text();
  void fill();
  void fill_row(int row, const KeptPlanAnswer& plan);
  void plot();
  void choose_row(int row);
  // The plan whose row is marked, empty where none is; it stays marked when the list is made anew.
  [[nodiscard]] std::string marked_name() const;
  void mark(const std::string& name);

  std::vector<KeptPlanAnswer> kept_;
  std::vector<std::size_t> order_;      // of the rows
  std::vector<QStringList> beaten_by_;  // names, for each plan
  QLabel* title_;
  QComboBox* rank_by_;
  QTableWidget* plans_;
  PlanPlot* plot_;
  QLabel* plot_text_;
  std::vector<std::size_t> plotted_;  // of the dots
  QLineEdit* name_;
  QPushButton* keep_;
  QPushButton* copy_;
  QPushButton* drop_;
};

}  // namespace glisson::widgets

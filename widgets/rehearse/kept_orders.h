#pragma once
// The orders of steps that a case keeps. What was done is kept under a name. All that are kept are run again from the
// liver at rest. They are put side by side by what they ask of it at their worst.

#include <optional>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QWidget>
#include <vector>

#include "casefile/orders.h"

namespace glisson::widgets {

class KeptOrders : public QWidget {
  Q_OBJECT

 public:
  enum Column { name_column, steps_column, displacement_column, force_column, strain_column };

  explicit KeptOrders(QWidget* parent = nullptr);

  // Those of the case, and how they compared last.
  void show_orders(std::vector<casefile::KeptOrder> orders, std::optional<casefile::ComparedOrders> compared);
  // Whether steps are recorded now, which can be kept.
  void allow_keeping(bool allowed);
  [[nodiscard]] bool empty() const { return orders_.empty(); }

 Q_SIGNALS:
  void keep_wanted(const QString& name);
  void drop_wanted(const QString& name);
  void compare_wanted();

 private:
  void update_text();
  void fill();
  void fill_row(int row);
  [[nodiscard]] const rehearsal::OrderOfSteps* figures_of(const casefile::KeptOrder& order) const;

  std::vector<casefile::KeptOrder> orders_;
  std::optional<casefile::ComparedOrders> compared_;
  bool allowed_ = false;
  QTableWidget* table_;
  QLabel* text_;
  QLineEdit* name_;
  QPushButton* keep_;
  QPushButton* compare_;
  QPushButton* drop_;
};

}  // namespace glisson::widgets

#pragma once
// Plans as dots: how wide the smallest margin of each is, and how much it leaves alive. Whatever lies above and to the
// right of a plan beats it in both. A plan that another one beats is a ring, not a dot.

#include <QString>
#include <QWidget>
#include <vector>

class QCustomPlot;

namespace glisson::widgets {

struct PlottedPlan {
  QString name;
  double margin_mm = 0, living_ml = 0;
  bool is_beaten = false;
};

class PlanPlot : public QWidget {
  Q_OBJECT

 public:
  explicit PlanPlot(QWidget* parent = nullptr);

  void show_plans(const std::vector<PlottedPlan>& plans);
  [[nodiscard]] const std::vector<PlottedPlan>& plans() const { return plans_; }
  // Where a plan stands in the widget.
  [[nodiscard]] QPointF drawn_at(std::size_t plan) const;

 Q_SIGNALS:
  void clicked(std::size_t plan);

 private:
  void draw();

  std::vector<PlottedPlan> plans_;
  QCustomPlot* plot_;
};

}  // namespace glisson::widgets

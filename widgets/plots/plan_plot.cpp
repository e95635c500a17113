#undef QT_NO_KEYWORDS  // qcustomplot.h is written with them
#include "widgets/plots/plan_plot.h"

#include <qcustomplot.h>
#include <algorithm>
#include <cmath>
#include <QVBoxLayout>
#include <utility>

#include "widgets/plots/themed_plot.h"
#include "widgets/theme.h"
#include "widgets/words/keep_translated.h"

namespace glisson::widgets {
namespace {

constexpr int plan_height_px = 176;
constexpr double narrow_mm = 5;  // as Resect flags it

}  // namespace

PlanPlot::PlanPlot(QWidget* parent) : QWidget(parent), plot_(new QCustomPlot(this)) {
  setObjectName("plan_plot");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(plot_);
  setFixedHeight(plan_height_px);
  QFont small = plot_->font();
  small.setPointSizeF(0.85 * small.pointSizeF());
  for (QCPAxis* axis : {plot_->xAxis, plot_->yAxis}) {
    axis->setTickLabelFont(small);
    axis->setLabelFont(small);
    axis->setLabelPadding(1);
  }
  plot_->yAxis->ticker()->setTickCount(4);
  themed(plot_);
  connect(plot_, &QCustomPlot::mouseRelease, this, [this](QMouseEvent* event) {
    constexpr double near_px = 12;
    for (std::size_t plan = 0; plan < plans_.size(); ++plan) {
      const QPointF at(plot_->xAxis->coordToPixel(plans_[plan].margin_mm),
                       plot_->yAxis->coordToPixel(plans_[plan].living_ml));
      if (QLineF(at, event->position()).length() < near_px) return Q_EMIT clicked(plan);
    }
  });
  keep_translated(this, [this] { draw(); });
}

void PlanPlot::show_plans(const std::vector<PlottedPlan>& plans) {
  plans_ = plans;
  draw();
}

QPointF PlanPlot::drawn_at(std::size_t plan) const {
  const QPoint at(static_cast<int>(plot_->xAxis->coordToPixel(plans_[plan].margin_mm)),
                  static_cast<int>(plot_->yAxis->coordToPixel(plans_[plan].living_ml)));
  return plot_->mapTo(this, at);
}

void PlanPlot::draw() {
  QCustomPlot& plot = *plot_;
  plot.clearPlottables();
  plot.clearItems();
  plot.xAxis->setLabel(tr("smallest margin, mm"));
  plot.yAxis->setLabel(tr("stays alive, ml"));
  setAccessibleName(tr("Plans by margin and by what stays alive"));
  if (plans_.empty()) return plot.replot(QCustomPlot::rpQueuedReplot);
  double widest_mm = 2 * narrow_mm, least_ml = plans_.front().living_ml, most_ml = least_ml;
  for (const PlottedPlan& plan : plans_) {
    widest_mm = std::max(widest_mm, plan.margin_mm);
    least_ml = std::min(least_ml, plan.living_ml), most_ml = std::max(most_ml, plan.living_ml);
  }
  const double spare_ml = std::max(10.0, 0.2 * (most_ml - least_ml));
  plot.xAxis->setRange(-0.05 * widest_mm, 1.3 * widest_mm);
  plot.yAxis->setRange(std::max(0.0, least_ml - spare_ml), most_ml + 1.5 * spare_ml);
  auto* narrow = new QCPItemStraightLine(&plot);
  narrow->setPen(QPen(theme_colour("warning"), 1));
  narrow->point1->setCoords(narrow_mm, 0);
  narrow->point2->setCoords(narrow_mm, 1);
  for (const PlottedPlan& plan : plans_) {
    QCPGraph* dot = plot.addGraph();
    dot->setLineStyle(QCPGraph::lsNone);
    dot->setScatterStyle(QCPScatterStyle(plan.is_beaten ? QCPScatterStyle::ssCircle : QCPScatterStyle::ssDisc,
                                         theme_colour(plan.is_beaten ? "faint" : "accent"), 9));
    dot->setData({plan.margin_mm}, {plan.living_ml});
    auto* name = new QCPItemText(&plot);
    name->setFont(plot.xAxis->tickLabelFont());
    name->setColor(theme_colour(plan.is_beaten ? "faint" : "ink_soft"));
    constexpr int widest_px = 110;
    name->setText(QFontMetrics(name->font()).elidedText(plan.name, Qt::ElideRight, widest_px));
    const bool to_the_left = plan.margin_mm > 0.65 * widest_mm;
    const bool below = std::any_of(plans_.begin(), plans_.end(), [&](const PlottedPlan& other) {
      const bool near = std::abs(other.margin_mm - plan.margin_mm) < 0.3 * widest_mm &&
                        std::abs(other.living_ml - plan.living_ml) < 0.2 * (most_ml - least_ml + spare_ml);
      return near && std::pair(other.living_ml, &other) > std::pair(plan.living_ml, &plan);  // whose name stands above
    });
    name->setPositionAlignment((to_the_left ? Qt::AlignRight : Qt::AlignLeft) |
                               (below ? Qt::AlignTop : Qt::AlignBottom));
    name->setPadding({7, 0, 7, 1});
    name->position->setCoords(plan.margin_mm, plan.living_ml);
  }
  plot.replot(QCustomPlot::rpQueuedReplot);
}

}  // namespace glisson::widgets

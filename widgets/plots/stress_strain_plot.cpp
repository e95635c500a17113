#undef QT_NO_KEYWORDS  // qcustomplot.h is written with them
#include "widgets/plots/stress_strain_plot.h"

#include <qcustomplot.h>
#include <algorithm>
#include <QVBoxLayout>

#include "widgets/plots/themed_plot.h"
#include "widgets/words/keep_translated.h"

namespace glisson::widgets {

StressStrainPlot::StressStrainPlot(QWidget* parent) : QWidget(parent), plot_(new QCustomPlot(this)) {
  constexpr int height_px = 150;
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(plot_);
  setFixedHeight(height_px);
  for (const int curve : {0, 1}) plot_->addGraph()->setPen(curve_pen(curve));
  plot_->graph(0)->setLineStyle(QCPGraph::lsNone);
  plot_->graph(0)->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, 4));
  themed(plot_);
  keep_translated(this, [this] {
    setAccessibleName(tr("Measured strain and stress"));
    plot_->xAxis->setLabel(tr("strain, %"));
    plot_->yAxis->setLabel(tr("stress, kPa"));
    plot_->replot();
  });
}

void StressStrainPlot::show_measurements(const std::vector<mechanics::StressStrain>& measured, double slope_kPa) {
  QVector<double> strains, stresses;
  for (const mechanics::StressStrain& point : measured) {
    strains.push_back(100 * point.strain);
    stresses.push_back(point.stress_kPa);
  }
  plot_->graph(0)->setData(strains, stresses);
  const auto [low, high] = std::minmax_element(strains.begin(), strains.end());
  const double from = std::min(0.0, *low), to = std::max(0.0, *high);
  plot_->graph(1)->setData({from, to}, {slope_kPa * from / 100, slope_kPa * to / 100});
  plot_->rescaleAxes();
  for (QCPAxis* axis : {plot_->xAxis, plot_->yAxis}) axis->scaleRange(1.1, axis->range().center());
  plot_->replot();
}

}  // namespace glisson::widgets

#undef QT_NO_KEYWORDS  // qcustomplot.h is written with them
#include "widgets/plots/histogram_plot.h"

#include <qcustomplot.h>
#include <algorithm>
#include <cmath>
#include <QVBoxLayout>

#include "widgets/plots/themed_plot.h"
#include "widgets/theme.h"

namespace glisson::widgets {
namespace {

constexpr int bars_wanted = 40;
constexpr int histogram_height_px = 132;

}  // namespace

HistogramPlot::HistogramPlot(QWidget* parent) : QWidget(parent), plot_(new QCustomPlot(this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(plot_);
  setFixedHeight(histogram_height_px);
  plot_->yAxis->setTickLabels(false);
  plot_->yAxis->grid()->setVisible(false);
  themed(plot_);
}

void HistogramPlot::show_values(const std::vector<double>& values, const QString& value_name) {
  QCustomPlot& plot = *plot_;
  setAccessibleName(value_name);
  plot.clearPlottables();
  plot.xAxis->setLabel(value_name);
  if (values.empty()) {
    plot.replot();
    return;
  }
  const auto [minimum, maximum] = std::minmax_element(values.begin(), values.end());
  // One value for all still has a bar.
  const double low = *minimum, width = std::max((*maximum - low) / bars_wanted, 1e-3 * std::max(1.0, std::abs(low)));
  QVector<double> middles(bars_wanted), counts(bars_wanted);
  for (int bar = 0; bar < bars_wanted; ++bar) middles[bar] = low + (bar + 0.5) * width;
  for (const double value : values) {
    counts[std::clamp(static_cast<int>((value - low) / width), 0, bars_wanted - 1)] += 1;
  }
  auto* bars = new QCPBars(plot.xAxis, plot.yAxis);
  bars->setData(middles, counts, true);
  bars->setWidth(width);
  bars->setPen(Qt::NoPen);
  bars->setBrush(theme_colour("accent"));
  plot.xAxis->setRange(low - width, low + (bars_wanted + 1) * width);
  plot.yAxis->setRange(0, 1.05 * *std::max_element(counts.begin(), counts.end()));
  plot.replot();
}

}  // namespace glisson::widgets

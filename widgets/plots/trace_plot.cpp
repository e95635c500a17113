#undef QT_NO_KEYWORDS  // qcustomplot.h is written with them
#include "widgets/plots/trace_plot.h"

#include <qcustomplot.h>

#include <algorithm>
#include <cmath>
#include <QtNumeric>
#include <QVBoxLayout>

#include "widgets/plots/themed_plot.h"
#include "widgets/theme.h"
#include "widgets/words/keep_translated.h"

namespace glisson::widgets {
namespace {

constexpr std::size_t spans_drawn = 2000;

struct Curve {
  QVector<double> time_s, power_W;
};

// Nothing is joined over a gap: a missing value stands there.
Curve drawn_of(const hardware::PowerTrace& trace) {
  Curve curve;
  const std::size_t count = trace.power_W.size();
  const std::size_t stride = std::max<std::size_t>(1, count / spans_drawn);
  const auto add = [&](std::size_t i) {
    if (!curve.time_s.isEmpty()) {
      const double step_s = trace.time_s[i] - curve.time_s.back();
      if (step_s > 5.0 * static_cast<double>(stride) * trace.sample_interval_s) {
        curve.time_s << trace.time_s[i];
        curve.power_W << qQNaN();
      }
    }
    curve.time_s << trace.time_s[i];
    curve.power_W << trace.power_W[i];
  };
  for (std::size_t begin = 0; begin < count; begin += stride) {
    const auto first = trace.power_W.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto last = trace.power_W.begin() + static_cast<std::ptrdiff_t>(std::min(count, begin + stride));
    const auto [minimum, maximum] = std::minmax_element(first, last);
    const auto minimum_at = static_cast<std::size_t>(minimum - trace.power_W.begin());
    const auto maximum_at = static_cast<std::size_t>(maximum - trace.power_W.begin());
    add(std::min(minimum_at, maximum_at));
    if (minimum_at != maximum_at) add(std::max(minimum_at, maximum_at));
  }
  return curve;
}

}  // namespace

TracePlot::TracePlot(QWidget* parent) : QWidget(parent), plot_(new QCustomPlot(this)) {
  setObjectName("trace_plot");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(plot_);
  plot_->setMinimumSize(240, 160);
  idle_ = plot_->addGraph();
  power_ = plot_->addGraph();
  QPen power = curve_pen(0);
  power.setWidthF(1.2);
  power_->setPen(power);
  idle_->setPen(curve_pen(1));
  plot_->legend->setVisible(true);
  plot_->axisRect()->insetLayout()->setInsetAlignment(0, Qt::AlignRight | Qt::AlignBottom);
  plot_->axisRect()->setRangeDrag(Qt::Horizontal);
  plot_->axisRect()->setRangeZoom(Qt::Horizontal);
  plot_->setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
  themed(plot_);
  keep_translated(this, [this] {
    plot_->xAxis->setLabel(tr("Time (s)"));
    plot_->yAxis->setLabel(tr("Power (W)"));
    power_->setName(tr("Power; shaded: a run"));
    idle_->setName(tr("Idle"));
    plot_->replot(QCustomPlot::rpQueuedReplot);
  });
}

void TracePlot::show_trace(const hardware::PowerTrace& trace, const std::optional<hardware::TraceRuns>& runs) {
  const Curve curve = drawn_of(trace);
  power_->setData(curve.time_s, curve.power_W, true);
  const double begin_s = trace.time_s.front(), end_s = trace.time_s.back();
  idle_->setVisible(runs.has_value());
  idle_->setData({begin_s, end_s}, {runs ? runs->idle_W : 0, runs ? runs->idle_W : 0}, true);
  plot_->clearItems();
  QColor band = theme_colour("accent");
  band.setAlphaF(0.15F);
  for (const hardware::TraceRun& run : runs ? runs->runs : std::vector<hardware::TraceRun>()) {
    auto* shade = new QCPItemRect(plot_);
    shade->topLeft->setTypeY(QCPItemPosition::ptAxisRectRatio);
    shade->bottomRight->setTypeY(QCPItemPosition::ptAxisRectRatio);
    shade->topLeft->setCoords(run.begin_s, 0);
    shade->bottomRight->setCoords(run.end_s, 1);
    shade->setPen(Qt::NoPen);
    shade->setBrush(band);
  }
  const auto [minimum_W, maximum_W] = std::minmax_element(trace.power_W.begin(), trace.power_W.end());
  plot_->xAxis->setRange(begin_s, std::max(end_s, begin_s + trace.sample_interval_s));
  plot_->yAxis->setRange(std::min(0.0, *minimum_W), 1.15 * std::max(*maximum_W, 1e-6));
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

}  // namespace glisson::widgets

#undef QT_NO_KEYWORDS  // qcustomplot.h is written with them
#include "widgets/plots/track_plot.h"

#include <qcustomplot.h>

#include <algorithm>
#include <QtNumeric>
#include <QVBoxLayout>

#include "rehearsal/comparison.h"
#include "widgets/plots/themed_plot.h"
#include "widgets/theme.h"
#include "widgets/words/keep_translated.h"

namespace glisson::widgets {

TrackPlot::TrackPlot(QWidget* parent) : QWidget(parent) {
  setObjectName("track_plot");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  plot_ = new QCustomPlot(this);
  plot_->setMinimumHeight(124);
  plot_->yAxis2->setVisible(true);
  plot_->xAxis->setNumberPrecision(4);
  QFont small = plot_->font();
  small.setPointSizeF(0.85 * small.pointSizeF());
  for (QCPAxis* axis : {plot_->xAxis, plot_->yAxis, plot_->yAxis2}) {
    axis->setTickLabelFont(small);
    axis->setLabelFont(small);
    axis->setLabelPadding(1);
  }
  moved_ = plot_->addGraph();
  reference_off_ = plot_->addGraph();
  force_ = plot_->addGraph(plot_->xAxis, plot_->yAxis2);
  int curve = 0;
  for (QCPGraph* graph : {moved_, reference_off_, force_}) {
    graph->setPen(curve_pen(curve++));
    graph->setLineStyle(QCPGraph::lsStepLeft);
  }
  five_mm_ = new QCPItemStraightLine(plot_);
  five_mm_label_ = new QCPItemText(plot_);
  five_mm_label_->setFont(small);
  five_mm_label_->setPositionAlignment(Qt::AlignLeft | Qt::AlignBottom);
  five_mm_label_->position->setTypeX(QCPItemPosition::ptAxisRectRatio);
  now_ = new QCPItemStraightLine(plot_);
  plot_->legend->setVisible(true);
  plot_->legend->setFont(small);
  plot_->legend->setRowSpacing(-4);
  plot_->legend->setFillOrder(QCPLegend::foColumnsFirst);
  plot_->plotLayout()->insertRow(0);
  plot_->plotLayout()->addElement(0, 0, plot_->legend);
  plot_->plotLayout()->setRowStretchFactor(0, 0.001);
  plot_->legend->setMargins({0, 2, 0, 0});
  plot_->plotLayout()->setRowSpacing(0);
  plot_->axisRect()->setMinimumMargins({0, 4, 0, 0});
  themed(plot_);
  column->addWidget(plot_);
  const auto choose = [this](QMouseEvent* event) {
    if ((event->buttons() & Qt::LeftButton) != 0) {
      Q_EMIT time_chosen(std::max(0.0, plot_->xAxis->pixelToCoord(event->position().x())));
    }
  };
  connect(plot_, &QCustomPlot::mousePress, this, choose);
  connect(plot_, &QCustomPlot::mouseMove, this, choose);
  keep_translated(this, [this] {
    plot_->xAxis->setLabel(tr("s"));
    plot_->yAxis->setLabel(tr("mm"));
    plot_->yAxis2->setLabel(tr("N"));
    reference_off_->setName(tr("Atlas off"));
    force_->setName(tr("Force"));
    five_mm_label_->setText(tr("5 mm"));
    plot_->replot(QCustomPlot::rpQueuedReplot);
  });
}

void TrackPlot::show_track(const RehearsalTrack& track, std::optional<std::size_t> landmark,
                           const QString& landmark_name) {
  QVector<double> time_s;
  QVector<double> moved_mm;
  QVector<double> off_mm;
  QVector<double> force_N;
  for (const Moment& moment : track.moments()) {
    const bool known = landmark && *landmark < moment.landmarks_mm.size();
    const bool usable = moment.validity.usable();  // else a gap
    time_s << moment.time_s;
    moved_mm << (!usable ? qQNaN() : known ? moment.landmarks_mm[*landmark] : moment.max_displacement_mm);
    off_mm << (usable ? moment.reference_off_mm.value_or(qQNaN()) : qQNaN());
    force_N << moment.force_N;
  }
  moved_->setName(landmark ? landmark_name : tr("Moves at most"));
  moved_->setData(time_s, moved_mm, true);
  reference_off_->setData(time_s, off_mm, true);
  force_->setData(time_s, force_N, true);
  const auto top_of = [](const QVector<double>& values, double minimum) {
    for (const double value : values) {
      if (value > minimum) minimum = value;
    }
    return minimum;
  };
  plot_->xAxis->setRange(0, std::max(5.0, track.length_s()));
  plot_->yAxis->setRange(0, 1.1 * std::max(top_of(moved_mm, 6), top_of(off_mm, 6)));
  plot_->yAxis2->setRange(0, 1.1 * top_of(force_N, 1));
  plot_->legend->setBorderPen(Qt::NoPen);
  const QColor amber = theme_colour("warning");
  five_mm_->setPen(QPen(amber, 1));
  five_mm_->point1->setCoords(0, rehearsal::significant_mm);
  five_mm_->point2->setCoords(1, rehearsal::significant_mm);
  five_mm_label_->setColor(amber);
  five_mm_label_->position->setCoords(0.01, rehearsal::significant_mm);
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void TrackPlot::show_time(std::optional<double> time_s) {
  now_->setVisible(time_s.has_value());
  now_->setPen(QPen(palette().color(QPalette::Text), 1));
  now_->point1->setCoords(time_s.value_or(0), 0);
  now_->point2->setCoords(time_s.value_or(0), 1);
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

}  // namespace glisson::widgets

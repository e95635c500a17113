#undef QT_NO_KEYWORDS  // qcustomplot.h is written with them
#include "widgets/plots/contour_plot.h"

#include <qcustomplot.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <QVBoxLayout>

#include "widgets/plots/themed_plot.h"
#include "widgets/words/keep_translated.h"

namespace glisson::widgets {
namespace {

// Resolutions stand in equal ratios; QCPColorMap knows no logarithmic axes.
double height_of(double resolution_mm3) { return std::log10(resolution_mm3); }

// Dark blue to yellow, as bright as it is high: readable without telling colours apart.
QCPColorGradient heights() {
  QCPColorGradient gradient;
  gradient.clearColorStops();
  const std::pair<double, QColor> stops[] = {{0.0, QColor(0x18, 0x1f, 0x5e)},
                                             {0.25, QColor(0x2d, 0x5d, 0x8c)},
                                             {0.5, QColor(0x2f, 0x8e, 0x8c)},
                                             {0.75, QColor(0x7c, 0xc4, 0x6a)},
                                             {1.0, QColor(0xfa, 0xe6, 0x4b)}};
  for (const auto& [at, colour] : stops) gradient.setColorStopAt(at, colour);
  return gradient;
}

}  // namespace

ContourPlot::ContourPlot(QWidget* parent) : QWidget(parent) {
  setObjectName("contours");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  plot_ = new QCustomPlot(this);
  plot_->setMinimumSize(360, 240);
  plot_->axisRect()->setupFullAxesBox();
  for (QCPAxis* axis : {plot_->xAxis, plot_->yAxis, plot_->xAxis2, plot_->yAxis2}) axis->grid()->setVisible(false);
  plot_->xAxis2->setTicks(false);
  plot_->xAxis2->setTickLabels(false);
  plot_->yAxis2->setTickLabels(true);
  const QSharedPointer<QCPAxisTickerText> ticks(new QCPAxisTickerText);
  for (const double resolution_mm3 : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0})
    ticks->addTick(height_of(resolution_mm3), QLocale().toString(resolution_mm3));
  plot_->yAxis->setTicker(ticks);
  map_ = new QCPColorMap(plot_->xAxis, plot_->yAxis);
  map_->setInterpolate(true);
  scale_ = new QCPColorScale(plot_);
  scale_->setBarWidth(12);
  scale_->setGradient(heights());
  scale_->axis()->grid()->setVisible(false);
  plot_->plotLayout()->addElement(0, 1, scale_);
  map_->setColorScale(scale_);
  auto* margins = new QCPMarginGroup(plot_);
  plot_->axisRect()->setMarginGroup(QCP::msTop | QCP::msBottom, margins);
  scale_->setMarginGroup(QCP::msTop | QCP::msBottom, margins);
  themed(plot_);
  column->addWidget(plot_);
  keep_translated(this, [this] {
    plot_->xAxis->setLabel(tr("Liver (cm³)"));
    plot_->yAxis->setLabel(tr("Volume of a node (mm³)"));
    plot_->yAxis2->setLabel(tr("Accuracy (mm)"));
  });
}

void ContourPlot::show_picture(const ContourPicture& picture) {
  picture_ = picture;
  const hardware::ProblemGrid& grid = picture.surface.grid;
  const auto volumes = static_cast<int>(grid.volumes_cm3.size());
  const auto resolutions = static_cast<int>(grid.resolutions_mm3.size());
  map_->data()->setSize(volumes, resolutions);
  const QCPRange heights(height_of(grid.resolutions_mm3.front()), height_of(grid.resolutions_mm3.back()));
  map_->data()->setRange({grid.volumes_cm3.front(), grid.volumes_cm3.back()}, heights);
  for (int v = 0; v < volumes; ++v) {
    for (int r = 0; r < resolutions; ++r) {
      map_->data()->setCell(v, r, picture.surface.at(static_cast<std::size_t>(v), static_cast<std::size_t>(r)));
    }
  }
  const auto [lowest, highest] = std::minmax_element(picture.surface.values.begin(), picture.surface.values.end());
  map_->setDataRange({*lowest, *highest > *lowest ? *highest : *lowest + 1});
  plot_->xAxis->setRange(grid.volumes_cm3.front(), grid.volumes_cm3.back());
  plot_->yAxis->setRange(heights);
  plot_->yAxis2->setRange(plot_->yAxis->range());
  const QSharedPointer<QCPAxisTickerText> ticks(new QCPAxisTickerText);
  for (const ContourPicture::Accuracy& accuracy : picture.accuracies)
    ticks->addTick(height_of(accuracy.resolution_mm3), QLocale().toString(accuracy.error_mm, 'g', 3));
  plot_->yAxis2->setTicker(ticks);

  for (int i = plot_->plottableCount() - 1; i >= 0; --i) {
    if (plot_->plottable(i) != map_) plot_->removePlottable(i);
  }
  plot_->clearItems();
  // Labels of neighbouring contours stand apart.
  for (std::size_t i = 0; i < picture.contours.size(); ++i)
    draw_contour(picture.contours[i], static_cast<double>(i + 1) / static_cast<double>(picture.contours.size() + 1));
  for (const hardware::HotSpot& spot : picture.hot_spots) {
    auto* mark = new QCPItemText(plot_);
    mark->setText(tr("hot spot"));
    mark->setColor(Qt::black);
    mark->setPadding({3, 1, 3, 1});
    mark->setBrush(QColor(255, 190, 80, 200));
    mark->position->setCoords(grid.volumes_cm3[spot.volume], height_of(grid.resolutions_mm3[spot.resolution]));
  }
  draw_case();
  plot_->replot();
}

void ContourPlot::draw_contour(const Contour& contour, double label_at) {
  const auto segments = hardware::contour(picture_.surface, contour.level);
  if (segments.empty()) return;
  auto* line = new QCPCurve(plot_->xAxis, plot_->yAxis);
  QPen pen(contour.wanted ? Qt::white : QColor(255, 255, 255, 150));
  pen.setWidthF(contour.wanted ? 2.6 : 1.2);
  if (!contour.wanted) pen.setStyle(Qt::DashLine);
  line->setPen(pen);
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();  // lifts the pen
  for (const hardware::ContourSegment& segment : segments) {
    line->addData(segment.from[0], height_of(segment.from[1]));
    line->addData(segment.to[0], height_of(segment.to[1]));
    line->addData(nothing, nothing);
  }
  const hardware::ContourSegment& labelled =
      segments[static_cast<std::size_t>(label_at * static_cast<double>(segments.size()))];
  auto* label = new QCPItemText(plot_);
  label->setText(contour.label);
  label->setColor(contour.wanted ? Qt::black : Qt::white);
  label->setBrush(contour.wanted ? QColor(255, 255, 255, 220) : QColor(20, 23, 28, 190));
  label->setPadding({4, 1, 4, 1});
  label->position->setCoords((labelled.from[0] + labelled.to[0]) / 2,
                             (height_of(labelled.from[1]) + height_of(labelled.to[1])) / 2);
}

void ContourPlot::draw_case() {
  auto* point = new QCPGraph(plot_->xAxis, plot_->yAxis);
  point->setLineStyle(QCPGraph::lsNone);
  point->setScatterStyle({QCPScatterStyle::ssCrossCircle, QPen(Qt::white, 2), QBrush(QColor(0, 0, 0, 120)), 15});
  point->addData(picture_.case_volume_cm3, height_of(picture_.case_resolution_mm3));
  auto* label = new QCPItemText(plot_);
  label->setText(tr("this case"));
  label->setColor(Qt::white);
  label->setBrush(QColor(0, 0, 0, 140));
  label->setPadding({3, 0, 3, 1});
  const bool right_half = picture_.case_volume_cm3 > plot_->xAxis->range().center();
  label->setPositionAlignment((right_half ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  label->position->setCoords(picture_.case_volume_cm3, height_of(picture_.case_resolution_mm3));
  label->setText(right_half ? tr("this case") + QString(5, QChar(0xa0)) : QString(5, QChar(0xa0)) + tr("this case"));
  label->setBrush(Qt::NoBrush);
}

}  // namespace glisson::widgets

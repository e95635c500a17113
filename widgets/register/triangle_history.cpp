#undef QT_NO_KEYWORDS  // qcustomplot.h is written with them
#include "widgets/register/triangle_history.h"

#include <qcustomplot.h>

#include <algorithm>
#include <cmath>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "widgets/panels/parts.h"
#include "widgets/plots/themed_plot.h"
#include "widgets/words/keep_translated.h"

namespace glisson::widgets {
namespace {

QCPAxisRect* add_rect(QCustomPlot* plot, int column) {
  auto* rect = new QCPAxisRect(plot);
  plot->plotLayout()->addElement(0, column, rect);
  for (QCPAxis* axis : rect->axes()) {
    axis->setNumberFormat("g");
    axis->setNumberPrecision(3);
  }
  // Frames are whole.
  const QSharedPointer<QCPAxisTickerFixed> frames(new QCPAxisTickerFixed);
  frames->setTickStep(1);
  frames->setScaleStrategy(QCPAxisTickerFixed::ssMultiples);
  rect->axis(QCPAxis::atBottom)->setTicker(frames);
  return rect;
}

QCPLegend* add_legend(QCustomPlot* plot, QCPAxisRect* rect) {
  auto* legend = new QCPLegend;
  rect->insetLayout()->addElement(legend, Qt::AlignTop | Qt::AlignRight);
  legend->setLayer("legend");
  QColor behind = plot->palette().color(QPalette::Base);
  behind.setAlpha(190);
  legend->setBrush(behind);
  legend->setBorderPen(Qt::NoPen);
  legend->setTextColor(plot->palette().color(QPalette::Text));
  legend->setRowSpacing(-4);
  QFont small = plot->font();
  small.setPixelSize(11);
  legend->setFont(small);
  return legend;
}

QCPItemStraightLine* add_line(QCustomPlot* plot, QCPAxisRect* rect, const QPen& pen) {
  auto* line = new QCPItemStraightLine(plot);
  line->setPen(pen);
  line->setClipAxisRect(rect);
  for (QCPItemPosition* position : line->positions()) {
    position->setAxes(rect->axis(QCPAxis::atBottom), rect->axis(QCPAxis::atLeft));
  }
  return line;
}

// NaN leaves a gap, as QCPGraph has it.
void add_course(QCustomPlot* plot, QCPAxisRect* rect, QCPLegend* legend, const std::vector<double>& mm,
                const QString& name, const QPen& pen) {
  QCPGraph* graph = plot->addGraph(rect->axis(QCPAxis::atBottom), rect->axis(QCPAxis::atLeft));
  graph->setPen(pen);
  graph->setName(name);
  graph->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, 3));  // a frame between two that are missing
  graph->removeFromLegend();
  graph->addToLegend(legend);
  for (std::size_t t = 0; t < mm.size(); ++t) graph->addData(static_cast<double>(t + 1), mm[t]);
}

double largest(const std::vector<double>& mm, double minimum) {
  for (const double value : mm) minimum = std::isfinite(value) ? std::max(minimum, value) : minimum;
  return minimum;
}

}  // namespace

TriangleHistory::TriangleHistory(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  column->addWidget(make_head());
  plot_ = new QCustomPlot(this);
  plot_->setMinimumSize(260, 150);
  plot_->plotLayout()->clear();
  plot_->plotLayout()->setColumnSpacing(4);
  errors_ = add_rect(plot_, 0);
  motions_ = add_rect(plot_, 1);
  for (std::size_t i = 0; i < 2; ++i)
    now_[i] = add_line(plot_, i == 0 ? errors_ : motions_, QPen(palette().color(QPalette::Text), 1));
  tolerance_ = add_line(plot_, errors_, QPen(QColor(0xd5, 0x5e, 0x00), 1, Qt::DashDotLine));
  show_frame(0);
  themed(plot_);
  column->addWidget(plot_, 1);
  keep_translated(this, [this] { update_text(); });
}

QWidget* TriangleHistory::make_head() {
  auto* head = new QWidget;
  auto* row = new QHBoxLayout(head);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(10);
  QLabel* title = heading();
  row->addWidget(title);
  triangle_ = whole_number("triangle", 0, 0, 0);
  triangle_->setMinimumWidth(76);
  title->setBuddy(triangle_);
  row->addWidget(triangle_);
  said_ = new QLabel;
  said_->setObjectName("place");
  said_->setWordWrap(true);
  said_->setMinimumHeight(2 * fontMetrics().height() + 4);
  said_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  row->addWidget(said_, 1);
  connect(triangle_, &NumberBox::valueChanged, this, [this](double number) {
    Q_EMIT triangle_chosen(number > 0 ? std::optional(static_cast<std::size_t>(number) - 1) : std::nullopt);
  });
  keep_translated(head, [=, this] {
    title->setText(tr("A triangle over the frames"));
    triangle_->setAccessibleName(tr("Triangle"));
    triangle_->setSpecialValueText(tr("none"));
    triangle_->setToolTip(tr("The triangle of the left picture whose history is drawn; or click one in a picture"));
  });
  return head;
}

void TriangleHistory::show_triangle(std::size_t count, std::optional<std::size_t> triangle) {
  const QSignalBlocker quiet(triangle_);
  triangle_->setRange(0, static_cast<double>(count));
  triangle_->setValue(triangle ? static_cast<double>(*triangle + 1) : 0);
}

void TriangleHistory::show_courses(const std::array<std::optional<Line>, 2>& lines, double tolerance_mm) {
  shown_ = lines;
  tolerance_mm_ = tolerance_mm;
  update_text();
}

void TriangleHistory::show_frames(const std::array<std::optional<Frames>, 2>& frames) {
  frames_ = frames;
  update_text();
}

void TriangleHistory::update_text() {
  setAccessibleName(tr("The chosen triangle over the frames"));
  for (QCPAxisRect* rect : {errors_, motions_}) rect->axis(QCPAxis::atBottom)->setLabel(tr("Frame"));
  plot_->clearGraphs();
  for (QCPAxisRect* rect : {errors_, motions_}) {
    for (int i = rect->insetLayout()->elementCount() - 1; i >= 0; --i) rect->insetLayout()->removeAt(i);
  }
  drawn_ = 0;
  tolerance_->point1->setCoords(0, tolerance_mm_);
  tolerance_->point2->setCoords(1, tolerance_mm_);
  if (shown_[0] || shown_[1]) {
    draw_triangle();
  } else {
    draw_frames();
  }
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void TriangleHistory::draw_triangle() {
  errors_->axis(QCPAxis::atLeft)->setLabel(tr("Error (mm)"));
  motions_->axis(QCPAxis::atLeft)->setLabel(tr("Motion (mm)"));
  plot_->setToolTip(
      tr("Left: how far the registered corners are from where they are on the model, mm, with the tolerance "
         "as a dash-dotted line. Right: what SIRGn's correlation compares, the motion of the landmarks "
         "and of the registration's warp, mm"));
  QCPLegend* of_errors = add_legend(plot_, errors_);
  QCPLegend* of_motions = add_legend(plot_, motions_);
  double error_mm = 1.3 * tolerance_mm_, motion_mm = 1, frames = 2;
  bool motions_drawn = false;
  for (std::size_t i = 0; i < 2; ++i) {
    if (!shown_[i]) continue;
    const auto& [algorithm, course] = *shown_[i];
    const QPen pen = curve_pen(static_cast<int>(i));
    add_course(plot_, errors_, of_errors, course.error_mm, algorithm, pen);
    ++drawn_;
    error_mm = largest(course.error_mm, error_mm);
    frames = std::max(frames, static_cast<double>(course.error_mm.size()));
    if (motions_drawn) continue;
    motions_drawn = true;
    add_course(plot_, motions_, of_motions, course.landmarks_mm, tr("Landmarks, %1").arg(algorithm),
               QPen(pen.color(), 2));
    add_course(plot_, motions_, of_motions, course.warp_mm, tr("Warp, %1").arg(algorithm),
               QPen(palette().color(QPalette::Text), 1.5, Qt::DotLine));
    motion_mm = largest(course.warp_mm, largest(course.landmarks_mm, motion_mm));
  }
  set_ranges(frames, 1.15 * error_mm, 1.3 * motion_mm);
}

void TriangleHistory::draw_frames() {
  errors_->axis(QCPAxis::atLeft)->setLabel(tr("TRE (mm)"));
  motions_->axis(QCPAxis::atLeft)->setLabel(tr("RMSE (mm)"));
  plot_->setToolTip(
      tr("Each frame of the whole registration. Left: how far registered landmarks are from where they are on the "
         "model, mm, with the tolerance as a dash-dotted line. Right: how far the registered cloud is from the model "
         "(root mean square), mm"));
  QCPLegend* of_tre = add_legend(plot_, errors_);
  QCPLegend* of_rmse = add_legend(plot_, motions_);
  double tre_mm = 1.3 * tolerance_mm_, rmse_mm = 1, frames = 2;
  for (std::size_t i = 0; i < 2; ++i) {
    if (!frames_[i]) continue;
    const QPen pen = curve_pen(static_cast<int>(i));
    add_course(plot_, errors_, of_tre, frames_[i]->tre_mm, frames_[i]->algorithm, pen);
    add_course(plot_, motions_, of_rmse, frames_[i]->rmse_mm, frames_[i]->algorithm, pen);
    ++drawn_;
    tre_mm = largest(frames_[i]->tre_mm, tre_mm);
    rmse_mm = largest(frames_[i]->rmse_mm, rmse_mm);
    frames = std::max(frames, static_cast<double>(frames_[i]->tre_mm.size()));
  }
  set_ranges(frames, 1.15 * tre_mm, 1.3 * rmse_mm);
}

void TriangleHistory::set_ranges(double frames, double left_mm, double right_mm) {
  for (QCPAxisRect* rect : {errors_, motions_}) rect->axis(QCPAxis::atBottom)->setRange(1, frames);
  errors_->axis(QCPAxis::atLeft)->setRange(0, left_mm);
  motions_->axis(QCPAxis::atLeft)->setRange(0, right_mm);
}

void TriangleHistory::show_frame(int frame) {
  for (QCPItemStraightLine* line : now_) {
    line->point1->setCoords(frame + 1, 0);
    line->point2->setCoords(frame + 1, 1);
  }
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

std::vector<std::vector<double>> TriangleHistory::drawn_mm() const {
  std::vector<std::vector<double>> curves;
  for (int i = 0; i < plot_->graphCount(); ++i) {
    auto& mm = curves.emplace_back();
    for (const QCPGraphData& point : *plot_->graph(i)->data()) mm.push_back(point.value);
  }
  return curves;
}

double TriangleHistory::frame() const { return now_[0]->point1->key() - 1; }

}  // namespace glisson::widgets

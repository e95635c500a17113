#undef QT_NO_KEYWORDS  // qcustomplot.h is written with them
#include "widgets/plots/themed_plot.h"

#include <qcustomplot.h>
#include <QEvent>

namespace glisson::widgets {
namespace {

struct Inks {
  QColor ink;
  QColor faint;
  QColor thin;
};

void dress(QCPAxis* axis, const Inks& inks) {
  axis->setBasePen(QPen(inks.faint));
  axis->setTickPen(QPen(inks.faint));
  axis->setSubTickPen(Qt::NoPen);
  axis->setTickLabelColor(inks.ink);
  axis->setLabelColor(inks.ink);
  axis->grid()->setPen(QPen(inks.thin, 1, Qt::DotLine));
  axis->grid()->setZeroLinePen(QPen(inks.thin));
}

void dress(QCustomPlot* plot) {
  const QPalette& palette = plot->palette();
  Inks inks{palette.color(QPalette::Text), palette.color(QPalette::PlaceholderText), {}};
  inks.thin = inks.faint;
  inks.thin.setAlphaF(0.3F);
  plot->setBackground(palette.base());
  for (QCPLayoutElement* element : plot->plotLayout()->elements(true)) {
    if (const auto* rect = qobject_cast<QCPAxisRect*>(element)) {
      for (QCPAxis* axis : rect->axes()) dress(axis, inks);
    } else if (const auto* scale = qobject_cast<QCPColorScale*>(element)) {
      dress(scale->axis(), inks);
    }
  }
  if (plot->legend != nullptr) {
    plot->legend->setBrush(palette.base());
    plot->legend->setBorderPen(QPen(inks.thin));
    plot->legend->setTextColor(inks.ink);
  }
  plot->replot(QCustomPlot::rpQueuedReplot);
}

class Dressing : public QObject {
 public:
  explicit Dressing(QCustomPlot* plot) : QObject(plot), plot_(plot) { plot->installEventFilter(this); }

  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::ThemeChange || event->type() == QEvent::Polish) dress(plot_);
    return QObject::eventFilter(watched, event);
  }

 private:
  QCustomPlot* plot_;
};

}  // namespace

void themed(QCustomPlot* plot) {
  new Dressing(plot);
  dress(plot);
}

QPen curve_pen(int curve) {
  static const QColor colours[] = {QColor(0x56, 0xb4, 0xe9), QColor(0xe6, 0x9f, 0x00), QColor(0x00, 0x9e, 0x73),
                                   QColor(0xcc, 0x79, 0xa7), QColor(0xd5, 0x5e, 0x00)};
  static constexpr Qt::PenStyle styles[] = {Qt::SolidLine, Qt::DashLine, Qt::DashDotLine, Qt::DotLine};
  return {QBrush(colours[curve % std::size(colours)]), 2, styles[curve % std::size(styles)]};
}

}  // namespace glisson::widgets

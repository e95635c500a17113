#include "widgets/register/heat_legend.h"

#include <QLocale>
#include <QPainter>

namespace glisson::widgets {

HeatLegend::HeatLegend(QWidget* parent) : QWidget(parent) {
  setFixedWidth(96);
  setMinimumHeight(200);
}

void HeatLegend::set_words(const QString& title, const QString& good, const QString& bad, const QString& rejected) {
  title_ = title;
  good_ = good;
  bad_ = bad;
  rejected_ = rejected;
  setAccessibleName(title);
  update();
}

void HeatLegend::show_scale(const scene::HeatScale& scale) {
  scale_ = scale;
  update();
}

void HeatLegend::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().base());
  const int line = fontMetrics().height();
  const int middle_words = static_cast<int>(Qt::AlignHCenter) | static_cast<int>(Qt::TextWordWrap);
  painter.setPen(palette().color(QPalette::Text));
  painter.drawText(QRect(2, 6, width() - 4, 2 * line), middle_words, title_);

  const QRect bar(14, 3 * line + 12, 18, height() - 8 * line - 48);
  if (bar.height() < 40) return;
  const auto [low, high] = scale_.range;
  for (int y = 0; y < bar.height(); ++y) {
    const scene::Colour colour = scene::heat_colour(scale_, high - (high - low) * y / (bar.height() - 1));
    painter.setPen(QColor::fromRgbF(static_cast<float>(colour.red), static_cast<float>(colour.green),
                                    static_cast<float>(colour.blue)));
    painter.drawLine(bar.left(), bar.top() + y, bar.right(), bar.top() + y);
  }
  painter.setPen(palette().color(QPalette::Text));
  for (const double mark : scene::round_marks(low, high, 5)) {
    if (mark < low - 1e-9 || mark > high + 1e-9) continue;
    const int y = bar.top() + static_cast<int>((high - mark) / (high - low) * (bar.height() - 1));
    painter.drawLine(bar.right() + 1, y, bar.right() + 5, y);
    painter.drawText(QRect(bar.right() + 8, y - line / 2, width() - bar.right() - 10, line),
                     Qt::AlignLeft | Qt::AlignVCenter, locale().toString(mark, 'g', 3));
  }
  const bool high_is_good = scale_.good == scene::HeatScale::Good::high;
  painter.setPen(palette().color(QPalette::PlaceholderText));
  painter.drawText(QRect(bar.left(), bar.top() - line - 6, width() - bar.left(), line), Qt::AlignLeft,
                   high_is_good ? good_ : bad_);
  painter.drawText(QRect(bar.left(), bar.bottom() + 8, width() - bar.left(), line), Qt::AlignLeft,
                   high_is_good ? bad_ : good_);

  if (rejected_.isEmpty()) return;
  const QRect swatch(bar.left(), bar.bottom() + 2 * line + 8, 34, line + 4);
  painter.fillRect(swatch, QColor(150, 150, 150));
  painter.fillRect(swatch, QBrush(QColor(20, 22, 26, 190), Qt::BDiagPattern));
  painter.setPen(palette().color(QPalette::Text));
  painter.drawText(QRect(2, swatch.bottom() + 4, width() - 4, 3 * line), middle_words, rejected_);
}

}  // namespace glisson::widgets

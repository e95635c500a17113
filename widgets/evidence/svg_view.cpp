#include "widgets/evidence/svg_view.h"

#include <QPainter>
#include <QSvgRenderer>

#include "widgets/theme.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {
namespace {

constexpr int caption_px = 40;

}  // namespace

SvgView::SvgView(EvidenceDrawing drawing, QWidget* parent) : QWidget(parent), drawing_(std::move(drawing)) {
  setMinimumSize(320, 270);
  keep_translated(this, [this] {
    caption_ = translated(drawing_.caption.toStdString());
    setAccessibleName(caption_);
    setToolTip(caption_);
    update();
  });
}

void SvgView::paintEvent(QPaintEvent*) {
  // Reports leave the colour of lines and letters to the page that they stand on.
  QByteArray svg = QByteArray::fromStdString(drawing_.svg);
  // Drawn for a page twice as wide as this.
  svg.replace("font-size=\"13\"", "font-size=\"18\"");
  svg.replace("currentColor", theme_colour("ink").name().toUtf8());
  svg.replace("<svg ", "<svg xmlns=\"http://www.w3.org/2000/svg\" ");  // not translated
  QSvgRenderer renderer(svg);
  renderer.setAspectRatioMode(Qt::KeepAspectRatio);
  QPainter painter(this);
  renderer.render(&painter, QRectF(0, 0, width(), height() - caption_px));
  painter.setPen(theme_colour("faint"));
  painter.drawText(QRectF(4, height() - caption_px, width() - 8, caption_px), Qt::AlignHCenter | Qt::TextWordWrap,
                   caption_);
}

}  // namespace glisson::widgets

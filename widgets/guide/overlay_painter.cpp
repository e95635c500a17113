#include "widgets/guide/overlay_painter.h"

#include <algorithm>
#include <cmath>
#include <QPainterPath>

namespace glisson::widgets {
namespace {

constexpr double width_px = 3;  // of a line, in a picture of up to the usual height
constexpr double usual_height_px = 640;
constexpr double rim_px = 1.6;  // of the dark rim on either side
constexpr double half_width_at_mm = 90;
const QColor rim(8, 10, 12, 190);

// A part of a line that is trusted throughout, or not at all.
struct Run {
  QPolygonF points;
  bool trusted = true;
};

// Short changes back and forth are no news: a run ends where the other kind lasts.
std::vector<Run> runs_of(const guidance::OutlinePiece& piece, const QTransform& from_frame, double tolerance_mm) {
  constexpr qsizetype shortest = 12;
  std::vector<Run> runs;
  for (std::size_t i = 0; i < piece.line_px.size(); ++i) {
    const QPointF at = from_frame.map(QPointF(piece.line_px[i].x(), piece.line_px[i].y()));
    const bool trusted = is_trusted(piece.sd_mm[i], tolerance_mm);
    if (runs.empty() || (runs.back().trusted != trusted && runs.back().points.size() >= shortest)) {
      Run next{{}, trusted};
      if (!runs.empty()) next.points << runs.back().points.back();
      runs.push_back(std::move(next));
    }
    runs.back().trusted = runs.back().trusted && trusted;
    runs.back().points << at;
  }
  return runs;
}

// What has a name beside it is what is looked for: it is as wide however deep it lies, which its words say.
double width_of(const OverlayPicture::Line& line) {
  const double deep_mm = line.label.isEmpty() ? line.outline.deep_mm.value_or(0) : 0;
  return width_px / (1 + deep_mm / half_width_at_mm);
}

QRectF room_of(const QPainter& painter) {
  return painter.hasClipping() ? painter.clipBoundingRect() : QRectF(painter.viewport());
}

void draw_run(QPainter& painter, const Run& run, const QColor& colour, double width, double rim_width) {
  QPen pen(rim, width + 2 * rim_width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
  if (!run.trusted) {
    pen.setColor(QColor(rim.red(), rim.green(), rim.blue(), 150));
  }
  painter.setPen(pen);
  painter.drawPolyline(run.points);
  pen = QPen(colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
  if (!run.trusted) {
    pen.setCapStyle(Qt::FlatCap);
    pen.setDashPattern({4, 2.5});
  }
  painter.setPen(pen);
  painter.drawPolyline(run.points);
}

// Words on a dark band beside a place, within the picture: to its upper right, or where there is no room, upper left.
void draw_words(QPainter& painter, const QRectF& beside, const QString& words, const QColor& colour) {
  const QFontMetricsF metrics(painter.font());
  const QRectF room = room_of(painter).adjusted(2, 2, -2, -2);
  QRectF band = metrics.boundingRect(words).adjusted(-5, -2, 5, 2);
  band.moveBottomLeft(beside.topRight());
  if (band.right() > room.right()) band.moveRight(std::max(room.left() + band.width(), beside.left()));
  band.moveTop(std::clamp(band.top(), room.top(), std::max(room.top(), room.bottom() - band.height())));
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(12, 14, 18, 200));
  painter.drawRoundedRect(band, 4, 4);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(colour);
  painter.drawText(band, Qt::AlignCenter, words);
}

}  // namespace

void paint_overlay(QPainter& painter, const QTransform& from_frame, const OverlayPicture& picture,
                   const OverlayLook& look) {
  if (!look.shown || look.opacity <= 0) return;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setOpacity(look.opacity);
  const double scale = std::max(1.0, room_of(painter).height() / usual_height_px);
  struct Words {
    QRectF beside;
    QString text;
    QColor colour;
  };
  std::vector<Words> words;
  for (const OverlayPicture::Line& line : picture.lines) {
    const Run* longest = nullptr;  // of the organ, where it is not trusted
    QRectF around;
    std::vector<std::vector<Run>> pieces;
    for (const guidance::OutlinePiece& piece : line.outline.pieces) {
      pieces.push_back(runs_of(piece, from_frame, look.tolerance_mm));
    }
    for (const std::vector<Run>& runs : pieces) {
      for (const Run& run : runs) {
        draw_run(painter, run, line.colour, scale * width_of(line), scale * rim_px);
        around |= run.points.boundingRect();
        const bool longer = longest == nullptr || run.points.size() > longest->points.size();
        if (line.outline.structure == 0 && !run.trusted && longer) longest = &run;
      }
    }
    if (longest != nullptr && !picture.mistrust.isEmpty()) {
      words.push_back({{longest->points[longest->points.size() / 2], QSizeF(8, 8)}, picture.mistrust, Qt::white});
    }
    if (!line.label.isEmpty() && !around.isEmpty()) {
      words.push_back({around, line.label, line.colour});
    }
  }
  for (const Words& one : words) draw_words(painter, one.beside, one.text, one.colour);
  painter.restore();
}

}  // namespace glisson::widgets

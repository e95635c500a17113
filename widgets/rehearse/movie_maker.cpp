#include "widgets/rehearse/movie_maker.h"

#include <algorithm>
#include <QPainter>

#include "widgets/words/translated.h"

namespace glisson::widgets {
namespace {

vision::Frame frame_of(const QImage& picture) {
  const QImage rgb = picture.convertToFormat(QImage::Format_RGB888);
  vision::Frame frame{rgb.width(), rgb.height(), {}};
  frame.rgb.reserve(3 * static_cast<std::size_t>(rgb.width()) * static_cast<std::size_t>(rgb.height()));
  for (int y = 0; y < rgb.height(); ++y) {
    frame.rgb.insert(frame.rgb.end(), rgb.constScanLine(y), rgb.constScanLine(y) + std::ptrdiff_t{3} * rgb.width());
  }
  return frame;
}

// The force, and what the answer is worth: whoever sees the movie sees no panel.
QString caption_of(const LiveRehearsal& rehearsal) {
  const rehearsal::RehearsalState& state = *rehearsal.state();
  QString caption =
      MovieMaker::tr("%1 N").arg(state.force_N.norm(), 0, 'f', 1) + "  ·  " + translated(state.validity.sentence());
  if (const auto bound_mm = rehearsal.error_bound_mm(); bound_mm && rehearsal.solving() != Solving::solved) {
    caption += "  ·  " + MovieMaker::tr("not at rest: landmarks within %1 mm").arg(*bound_mm, 0, 'f', 1);
  }
  return caption;
}

void write_below(QImage& picture, const QString& words) {
  picture.setDevicePixelRatio(1);
  QPainter painter(&picture);
  QFont font = painter.font();
  font.setPixelSize(std::max(10, picture.height() / 32));
  painter.setFont(font);
  const int band = 2 * font.pixelSize();
  const QRect below(0, picture.height() - band, picture.width(), band);
  painter.fillRect(below, QColor(0, 0, 0, 170));
  painter.setPen(Qt::white);
  painter.drawText(below.adjusted(band / 2, 0, -band / 2, 0), Qt::AlignLeft | Qt::AlignVCenter, words);
}

}  // namespace

MovieMaker::MovieMaker(LiveRehearsal& rehearsal, std::function<QImage()> grab, QObject* parent)
    : QObject(parent), rehearsal_(rehearsal), grab_(std::move(grab)) {
  timer_.setInterval(0);
  connect(&timer_, &QTimer::timeout, this, &MovieMaker::next_picture);
}

void MovieMaker::begin(const std::filesystem::path& file) {
  if (busy() || rehearsal_.track().empty()) return;
  auto writer = vision::MovieWriter::begin(file, frames_per_second);
  if (!writer) {
    Q_EMIT failed(writer.error());
    return;
  }
  writer_ = *std::move(writer);
  time_s_ = 0;
  rehearsal_.show_moment(0);
  timer_.start();
}

void MovieMaker::stop() {
  if (!busy()) return;
  end();
  Q_EMIT stopped();
}

void MovieMaker::next_picture() {
  if (rehearsal_.track().empty()) return stop();         // the patient was closed
  if (rehearsal_.solving() == Solving::solving) return;  // the shape of this moment is on its way
  const double length_s = rehearsal_.track().length_s();
  QImage picture = grab_();
  if (rehearsal_.state()) write_below(picture, caption_of(rehearsal_));
  auto done = writer_->add(frame_of(picture));
  time_s_ += 1 / frames_per_second;
  Q_EMIT progressed(length_s > 0 ? std::min(1.0, time_s_ / length_s) : 1.0);
  // Half a second of rest at the end, so that the outcome can be seen.
  const bool was_last = time_s_ > length_s + 0.5;
  if (done && !was_last) return rehearsal_.show_moment(rehearsal_.track().at(time_s_));
  if (done) done = writer_->finish();
  end();
  if (done) {
    Q_EMIT written();
  } else {
    Q_EMIT failed(done.error());
  }
}

void MovieMaker::end() {
  timer_.stop();
  writer_.reset();
  rehearsal_.go_on();
}

}  // namespace glisson::widgets

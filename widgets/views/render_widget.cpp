#include "widgets/views/render_widget.h"

#include <algorithm>
#include <chrono>
#include <QCoreApplication>
#include <QPainter>
#include <QSemaphore>
#include <QThreadPool>
#include <QTimer>
#include <utility>

#include "scene/painter.h"
#include "widgets/words/translated.h"
#include "widgets/work/run_in_background.h"

namespace glisson::widgets {
namespace {

const QColor empty_view(5, 6, 7);
const QColor faint_words(150, 158, 168);
const QColor caption_band(58, 44, 12);
const QColor caption_ink(255, 201, 95);

// One for all views: what draws in software uses every core for each frame anyway. It ends with the application, not
// with the program's static objects: those of the drivers, made later, go first, under the hands of a frame not
// finished.
QThreadPool* drawing_pool = nullptr;

QThreadPool& drawing_thread() {
  if (drawing_pool == nullptr) {
    drawing_pool = new QThreadPool;
    drawing_pool->setMaxThreadCount(1);
    drawing_pool->setExpiryTimeout(-1);  // painters belong to their thread
    qAddPostRoutine([] { delete std::exchange(drawing_pool, nullptr); });
  }
  return *drawing_pool;
}

QImage image_of(scene::DrawnFrame&& frame) {
  auto* kept = new scene::DrawnFrame(std::move(frame));
  return QImage(
      kept->bgrx.data(), kept->width, kept->height, 4 * kept->width, QImage::Format_RGB32,
      [](void* held) { delete static_cast<scene::DrawnFrame*>(held); }, kept);
}

QImage captioned(const QImage& frame, const QString& caption, double pixel_scale) {
  if (caption.isEmpty() || frame.isNull()) return frame;
  const QRect band(0, frame.height(), frame.width(), 2 * static_cast<int>(12 * pixel_scale));
  QImage picture(frame.width(), frame.height() + band.height(), frame.format());
  QPainter painter(&picture);
  painter.drawImage(0, 0, frame);
  painter.fillRect(band, caption_band);
  QFont font = painter.font();
  font.setPixelSize(static_cast<int>(13 * pixel_scale));
  font.setBold(true);
  painter.setFont(font);
  painter.setPen(caption_ink);
  painter.drawText(band, Qt::AlignCenter, caption);
  return picture;
}

}  // namespace

struct RenderWidget::Drawn {
  int number = 0;
  QImage image;  // null where nothing can be drawn
  double took_ms = 0;
  QString by;
  std::optional<Error> problem;
};

struct RenderWidget::Drawer {
  std::unique_ptr<scene::Painter> painter;

  Drawn draw(int number, const scene::ViewChanges& changes) {
    const auto start = std::chrono::steady_clock::now();
    if (!painter) painter = std::make_unique<scene::Painter>();
    auto frame = painter->paint(changes);
    Drawn drawn{number, {}, 0, QString::fromStdString(painter->drawn_by()), std::nullopt};
    if (frame) {
      drawn.image = image_of(*std::move(frame));
    } else {
      drawn.problem = frame.error();
    }
    drawn.took_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return drawn;
  }
};

RenderWidget::RenderWidget(QWidget* parent) : QWidget(parent), drawer_(std::make_shared<Drawer>()) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(120, 100);
  setAttribute(Qt::WA_OpaquePaintEvent);
}

RenderWidget::~RenderWidget() {
  drawing_thread().start([drawer = std::move(drawer_)] { drawer->painter.reset(); });
}

bool RenderWidget::drawing_thread_runs() { return drawing_pool != nullptr; }

double RenderWidget::mm_per_pixel() const { return view_.camera().visible_height_mm / std::max(1, height()); }

void RenderWidget::redraw() {
  out_of_date_ = true;
  if (due_ || under_way_ || !isVisible()) return;
  due_ = true;
  // Not at once: what changes in one turn of the event loop is drawn once.
  QTimer::singleShot(0, this, [this] {
    due_ = false;
    if (out_of_date_ && !under_way_ && isVisible()) begin_frame();
  });
}

std::shared_ptr<scene::ViewChanges> RenderWidget::take_changes(int oversampling) {
  out_of_date_ = false;
  ++frames_begun_;
  view_.set_pixel_scale(oversampling * devicePixelRatioF());  // another one when the window moves to another screen
  return std::make_shared<scene::ViewChanges>(view_.take_changes(
      oversampling * std::max(device_width(), 1), oversampling * std::max(device_height(), 1), shrink()));
}

void RenderWidget::begin_frame() {
  under_way_ = true;
  const auto changes = take_changes();
  run_in_background(
      this, &drawing_thread(),
      [drawer = drawer_, changes, number = frames_begun_] { return drawer->draw(number, *changes); },
      [this](const Drawn& drawn) {
        under_way_ = false;
        show_frame(drawn);
        if (out_of_date_) redraw();
      });
}

RenderWidget::Drawn RenderWidget::draw_now(const scene::ViewChanges& changes) {
  // Not QFuture::result(), which may run what has not begun yet on the thread that waits.
  Drawn drawn;
  QSemaphore done;
  drawing_thread().start([&] {
    drawn = drawer_->draw(frames_begun_, changes);
    done.release();
  });
  done.acquire();
  return drawn;
}

QImage RenderWidget::as_large_as_shown(const QImage& frame) const {
  const QSize size(device_width(), device_height());
  const bool fits = frame.isNull() || frame.size() == size;
  return captioned(fits ? frame : frame.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation), caption_,
                   devicePixelRatioF());
}

QImage RenderWidget::picture() {
  draw_finely();
  show_frame(draw_now(*take_changes()));
  return as_large_as_shown(frame_);
}

QImage RenderWidget::smooth_picture() {
  constexpr int oversampling = 2;
  draw_finely();
  const Drawn drawn = draw_now(*take_changes(oversampling));
  // The view counts in its own pixels again.
  view_.set_pixel_scale(devicePixelRatioF());
  view_.set_size(std::max(device_width(), 1), std::max(device_height(), 1));
  redraw();
  return as_large_as_shown(drawn.image);
}

void RenderWidget::show_frame(const Drawn& drawn) {
  if (drawn.number < frame_shown_) return;  // picture() has overtaken it
  frame_shown_ = drawn.number;
  frame_ = drawn.image;
  last_frame_ms_ = drawn.took_ms;
  if (!drawn.by.isEmpty()) drawn_by_ = drawn.by;
  if (drawn.problem) why_none_ = translated(*drawn.problem);
  update();
  Q_EMIT frame_drawn();
}

void RenderWidget::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  redraw();
}

void RenderWidget::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  redraw();
}

void RenderWidget::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  if (frame_.isNull()) {
    painter.fillRect(rect(), empty_view);
    painter.setPen(faint_words);
    painter.drawText(rect().marginsRemoved({12, 12, 12, 12}), Qt::AlignCenter | Qt::TextWordWrap, why_none_);
    return;
  }
  painter.setRenderHint(QPainter::SmoothPixmapTransform, frame_.width() < device_width());
  painter.drawImage(rect(), frame_);
}

}  // namespace glisson::widgets

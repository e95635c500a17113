#include "widgets/settings/window_place.h"
#include "widgets/settings/program_settings.h"

#include <algorithm>
#include <QEvent>
#include <QScreen>
#include <QTimer>
#include <QWidget>

namespace glisson::widgets {
namespace {

constexpr const char* place_key = "window_place";

}  // namespace

WindowPlace::WindowPlace(QWidget& window, const QSize& usual_size) : QObject(&window), window_(window) {
  const QByteArray kept = program_settings().value(place_key).toByteArray();
  if (!window_.restoreGeometry(kept)) window_.resize(usual_size);
  window_.resize(window_.size().boundedTo(window_.screen()->availableSize()));
  given_ = window_.size();
  window_.installEventFilter(this);
}

bool WindowPlace::eventFilter(QObject* watched, QEvent* event) {
  if (watched == &window_ && event->type() == QEvent::Show) {
    QTimer::singleShot(0, this, [this] { keep_on_screen(); });  // the frame comes with the first turn
  } else if (watched == &window_ && event->type() == QEvent::Close) {
    keep();
  }
  return QObject::eventFilter(watched, event);
}

void WindowPlace::keep_on_screen() {
  if (window_.isMaximized() || window_.isFullScreen() || window_.size() != given_) return;
  const QRect room = window_.screen()->availableGeometry();
  const QSize frame = window_.frameGeometry().size() - window_.size();
  window_.resize(window_.size().boundedTo(room.size() - frame));
  given_ = window_.size();
  const QRect now = window_.frameGeometry();
  const QPoint corner(std::clamp(now.left(), room.left(), std::max(room.left(), room.right() - now.width() + 1)),
                      std::clamp(now.top(), room.top(), std::max(room.top(), room.bottom() - now.height() + 1)));
  if (corner != now.topLeft()) window_.move(corner);
}

void WindowPlace::keep() const { program_settings().setValue(place_key, window_.saveGeometry()); }

}  // namespace glisson::widgets

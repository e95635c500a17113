#include "widgets/panels/timeline.h"

#include <algorithm>
#include <QHBoxLayout>

#include "widgets/words/keep_translated.h"

namespace glisson::widgets {
namespace {

constexpr int timeline_frame_ms = 66;  // 15 a second: a breath is seen as one, and a slow machine keeps up

}  // namespace

Timeline::Timeline(QWidget* parent) : QWidget(parent) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(8);
  play_ = new QPushButton;
  play_->setObjectName("play");
  play_->setCheckable(true);
  back_ = new QPushButton(QString::fromUtf8("\u25c0"));
  back_->setObjectName("back");
  forth_ = new QPushButton(QString::fromUtf8("\u25b6"));
  forth_->setObjectName("forth");
  slider_ = new QSlider(Qt::Horizontal);
  slider_->setObjectName("timeline_slider");
  slider_->setPageStep(10);
  number_ = new QLabel;
  number_->setObjectName("frame_number");
  number_->setMinimumWidth(110);
  number_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  for (QWidget* part : {static_cast<QWidget*>(play_), static_cast<QWidget*>(back_)}) row->addWidget(part);
  row->addWidget(slider_, 1);
  row->addWidget(forth_);
  row->addWidget(number_);

  clock_.setInterval(timeline_frame_ms);
  connect(&clock_, &QTimer::timeout, this, [this] { show_frame((frame() + 1) % frames()); });
  connect(play_, &QPushButton::toggled, this, [this](bool playing) {
    playing ? clock_.start() : clock_.stop();
    update_text();
  });
  connect(back_, &QPushButton::clicked, this, [this] { step(-1); });
  connect(forth_, &QPushButton::clicked, this, [this] { step(1); });
  connect(slider_, &QSlider::valueChanged, this, [this](int frame) {
    update_text();
    Q_EMIT moved(frame);
  });
  set_frames(0);
  keep_translated(this, [this] { update_text(); });
}

void Timeline::set_frames(int frames) {
  play(false);
  empty_ = frames <= 0;
  slider_->setRange(0, std::max(0, frames - 1));
  slider_->setValue(0);
  for (QWidget* part : {static_cast<QWidget*>(play_), static_cast<QWidget*>(back_), static_cast<QWidget*>(forth_),
                        static_cast<QWidget*>(slider_)}) {
    part->setEnabled(frames > 1);
  }
  update_text();
}

void Timeline::show_frame(int frame) { slider_->setValue(frame); }

void Timeline::step(int frames) {
  play(false);
  slider_->setValue(slider_->value() + frames);
}

void Timeline::play(bool playing) { play_->setChecked(playing && !empty_); }

void Timeline::update_text() {
  play_->setText(play_->isChecked() ? tr("Pause") : tr("Play"));
  back_->setAccessibleName(tr("One frame back"));
  forth_->setAccessibleName(tr("One frame on"));
  slider_->setAccessibleName(tr("Frame"));
  number_->setText(empty_ ? tr("No frames") : tr("Frame %1 of %2").arg(frame() + 1).arg(frames()));
  const QString lacking = tr("Open a sequence first");
  play_->setToolTip(empty_ ? lacking : tr("Plays the video at 15 frames a second, round and round (Space)"));
  back_->setToolTip(empty_ ? lacking : tr("One frame back (Left)"));
  forth_->setToolTip(empty_ ? lacking : tr("One frame on (Right)"));
  slider_->setToolTip(empty_ ? lacking : tr("The frame that is shown (Left, Right, Page Up, Page Down, Home, End)"));
}

bool Timeline::take_key(int key) {
  switch (key) {
    case Qt::Key_Space: play(!playing()); return true;
    case Qt::Key_Left: step(-1); return true;
    case Qt::Key_Right: step(1); return true;
    case Qt::Key_PageUp: step(-10); return true;
    case Qt::Key_PageDown: step(10); return true;
    case Qt::Key_Home: show_frame(0); return true;
    case Qt::Key_End: show_frame(frames() - 1); return true;
    default: return false;
  }
}

}  // namespace glisson::widgets

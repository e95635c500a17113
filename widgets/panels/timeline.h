#pragma once
// Which frame of a video is shown: a slider, play and pause, one frame back and forth, the frame's number.

#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QTimer>
#include <QWidget>

namespace glisson::widgets {

class Timeline : public QWidget {
  Q_OBJECT

 public:
  explicit Timeline(QWidget* parent = nullptr);

  // 0 for no video: then everything is disabled and says why.
  void set_frames(int frames);
  void show_frame(int frame);
  void step(int frames);
  void play(bool playing);
  // Space plays, arrows go by one frame, page up and down by ten, home and end to the ends; false for other keys.
  bool take_key(int key);

  [[nodiscard]] int frames() const { return slider_->maximum() + 1; }
  [[nodiscard]] int frame() const { return slider_->value(); }
  [[nodiscard]] bool playing() const { return clock_.isActive(); }

 Q_SIGNALS:
  void moved(int frame);

 private:
  void update_text();

  QTimer clock_;
  QPushButton* play_;
  QPushButton* back_;
  QPushButton* forth_;
  QSlider* slider_;
  QLabel* number_;
  bool empty_ = true;
};

}  // namespace glisson::widgets

#pragma once
// What a sequence is made of, asked for: the video, its calibration or pictures of a board, which frames, and where to
// keep it.

#include <QComboBox>
#include <QVBoxLayout>
#include <QWidget>

#include "widgets/sequence/path_row.h"
#include "widgets/sequence/video_order.h"
#include "widgets/words/number_box.h"

namespace glisson::widgets {

class VideoForm : public QWidget {
  Q_OBJECT

 public:
  explicit VideoForm(QWidget* parent = nullptr);

  // What is to be given still, as a sentence; empty for nothing.
  [[nodiscard]] QString missing() const;
  [[nodiscard]] VideoOrder order() const;
  // The folder that was proposed may be taken by now: another is.
  void propose_folder();

 Q_SIGNALS:
  void changed();

 private:
  void add_video(QVBoxLayout& column);
  void add_calibration(QVBoxLayout& column);
  void add_frames(QVBoxLayout& column);
  void connect_all();
  void propose_right();
  void show_choices();
  void update_text();
  [[nodiscard]] bool in_one() const { return eyes_->currentIndex() > 0; }
  [[nodiscard]] bool from_board() const { return calibrated_by_->currentIndex() > 0; }

  QString proposed_;  // folder

  QComboBox* eyes_;
  PathRow* left_;
  PathRow* right_;
  QComboBox* calibrated_by_;
  PathRow* calibration_;
  QWidget* board_;
  PathRow* board_left_;
  PathRow* board_right_;
  QComboBox* pattern_;
  QLabel* count_name_;
  NumberBox* columns_;
  NumberBox* rows_;
  QLabel* spacing_name_;
  NumberBox* spacing_;
  NumberBox* first_;
  NumberBox* every_;
  NumberBox* most_;
  PathRow* folder_;
};

}  // namespace glisson::widgets

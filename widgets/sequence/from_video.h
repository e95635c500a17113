#pragma once
// From a stereo video to a sequence, a page of any workspace that opens sequences: what it is made of is asked for, it
// is made on a worker thread, and what comes on the way is shown.

#include <filesystem>
#include <functional>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QWidget>

#include "widgets/sequence/sequence_report.h"
#include "widgets/sequence/video_form.h"
#include "widgets/work/background_work.h"

namespace glisson::widgets {

class FromVideo : public QWidget {
  Q_OBJECT

 public:
  explicit FromVideo(BackgroundWork& work, QWidget* parent = nullptr);
  // What came of opening what was made, where that failed.
  void say(std::function<QString()> words);

 Q_SIGNALS:
  // A sequence.json that is there now, and what to say of it, in the language of then.
  void made(const std::filesystem::path& sequence, const std::function<QString()>& summary);
  void left();

 private:
  QWidget* make_order();
  void connect_work();
  void make();
  void take_calibration(const CalibrationReport& told);
  void take_frame(const FrameReport& told);
  void end(const Result<registration_quality::VideoSequence>& made);
  void update_text();

  BackgroundWork& work_;
  bool working_ = false;  // for this page
  SequenceReport report_;
  std::function<QString()> said_;
  bool cancelled_ = false;

  VideoForm* form_;
  QLabel* hint_;
  QLabel* says_;
  QLabel* stage_;
  QProgressBar* progress_;
  QPushButton* cancel_;
  QPushButton* back_;
  QPushButton* make_;
  SequenceReportView* view_;
};

}  // namespace glisson::widgets

#pragma once
// Which one or two algorithms register the video, the button that lets them, and how far they are.

#include <array>
#include <optional>
#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QWidget>

#include "widgets/register/judged_sequence.h"

namespace glisson::widgets {

// "ICP: nearest points", "ICP".
[[nodiscard]] QString long_name(registration_quality::SequenceMethod method);
[[nodiscard]] QString short_name(registration_quality::SequenceMethod method);

class AlgorithmChoice : public QWidget {
  Q_OBJECT

 public:
  enum class Work { none_open, to_do, under_way, done };

  explicit AlgorithmChoice(QWidget* parent = nullptr);

  // What the sequence holds nothing for cannot be chosen, and says what it lacks.
  void offer(const OpenedSequence& sequence);
  // side 0 or 1; the second may be none.
  [[nodiscard]] std::optional<registration_quality::SequenceMethod> method(int side) const;
  void show_work(Work work);
  void show_progress(double fraction, const QString& stage);

 Q_SIGNALS:
  void chosen();
  void computing_wanted();
  void cancel_wanted();

 private:
  void update_text();

  std::array<QComboBox*, 2> methods_{};
  QPushButton* compute_;
  QProgressBar* progress_;
  QPushButton* cancel_;
  QLabel* stage_;
  Work work_ = Work::none_open;
};

}  // namespace glisson::widgets

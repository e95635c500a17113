#pragma once
// A recording of power that a person opens. It shows which of its columns is what, as guessed and to be changed, and
// the curve with the runs in it. It says what that tells of idle and active power.

#include <filesystem>
#include <memory>
#include <optional>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include "hardware/recording.h"
#include "widgets/plots/trace_plot.h"
#include "widgets/words/number_box.h"

namespace glisson::widgets {

class TraceView : public QWidget {
  Q_OBJECT

 public:
  explicit TraceView(QWidget* parent = nullptr);

  // Reads on another thread. opened() follows, or refused() with a sentence; what was shown stays then.
  void open(const std::filesystem::path& file);

  [[nodiscard]] const std::optional<hardware::TraceRuns>& runs() const { return reading_.runs; }
  [[nodiscard]] QString file_name() const;
  // How the platform is called that "Plan with it" would change.
  void set_platform(const QString& name);

 Q_SIGNALS:
  void opened();
  void refused(const glisson::Error& error);
  void plan_with_it();
  void closed();

 private:
  struct Recording {
    CsvTable table;
    std::filesystem::path file;
    hardware::TraceFormat format;
  };
  // What the chosen columns say.
  struct Reading {
    std::optional<hardware::PowerTrace> trace;
    std::optional<hardware::TraceRuns> runs;
    std::optional<Error> problem;
  };

  void take(std::shared_ptr<const Recording> recording);
  void fill_columns();
  void read_columns();
  void update_answer_text();

  std::shared_ptr<const Recording> recording_;
  Reading reading_;
  int asked_ = 0;  // an answer to an earlier question is dropped
  QString platform_;

  QLabel* name_;
  QComboBox* time_;
  QComboBox* power_;
  NumberBox* factor_;
  TracePlot* plot_;
  QLabel* answer_;
  QPushButton* use_;
};

}  // namespace glisson::widgets

#include "widgets/hardware/trace_view.h"

#include <algorithm>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "widgets/words/keep_translated.h"
#include "widgets/words/numbers.h"
#include "widgets/words/paths.h"
#include "widgets/words/translated.h"
#include "widgets/work/run_in_background.h"

namespace glisson::widgets {

TraceView::TraceView(QWidget* parent) : QWidget(parent) {
  setObjectName("trace_view");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 6, 6, 0);
  auto* top = new QHBoxLayout;
  name_ = new QLabel;
  name_->setObjectName("trace_name");
  name_->setWordWrap(true);
  top->addWidget(name_, 1);
  auto* close = new QPushButton;
  close->setObjectName("trace_close");
  top->addWidget(close);
  column->addLayout(top);
  auto* columns = new QHBoxLayout;
  const auto add = [&](QWidget* control, const char* object_name) {
    auto* label = new QLabel;
    label->setBuddy(control);
    control->setObjectName(object_name);
    columns->addWidget(label);
    columns->addWidget(control);
    return label;
  };
  power_ = new QComboBox;
  time_ = new QComboBox;
  factor_ = new NumberBox;
  factor_->setDecimals(4);
  factor_->setRange(-1e6, 1e6);
  QLabel* power_name = add(power_, "trace_power");
  QLabel* factor_name = add(factor_, "trace_factor");
  QLabel* time_name = add(time_, "trace_time");
  columns->addStretch(1);
  column->addLayout(columns);
  plot_ = new TracePlot;
  column->addWidget(plot_, 1);
  answer_ = new QLabel;
  answer_->setObjectName("trace_answer");
  answer_->setWordWrap(true);
  answer_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  column->addWidget(answer_);
  use_ = new QPushButton;
  use_->setObjectName("trace_use");
  column->addWidget(use_, 0, Qt::AlignLeft);

  connect(close, &QPushButton::clicked, this, &TraceView::closed);
  connect(use_, &QPushButton::clicked, this, &TraceView::plan_with_it);
  connect(power_, &QComboBox::activated, this, &TraceView::read_columns);
  connect(time_, &QComboBox::activated, this, &TraceView::read_columns);
  connect(factor_, &NumberBox::valueChanged, this, &TraceView::read_columns);
  keep_translated(this, [=, this] {
    close->setText(tr("Close the recording"));
    power_name->setText(tr("Power"));
    factor_name->setText(tr("Watts per unit"));
    factor_->setToolTip(
        tr("1 where the column holds watts, 0.001 for milliwatts; for a current clamp its amperes per volt "
           "times the supply's voltage. Negative turns the sign."));
    time_name->setText(tr("Time"));
    fill_columns();
    update_answer_text();
  });
}

void TraceView::open(const std::filesystem::path& file) {
  const int question = ++asked_;
  run_in_background(
      this,
      [file]() -> Result<std::shared_ptr<const Recording>> {
        return hardware::read_recording(file).and_then([&](CsvTable table) -> Result<std::shared_ptr<const Recording>> {
          const hardware::TraceFormat format = hardware::guessed_format(table);
          // What cannot be read with the columns as guessed is no recording, as far as anybody can tell.
          const auto trace = hardware::power_trace(table, format, file);
          if (!trace) return failure(trace.error());
          return std::make_shared<const Recording>(Recording{std::move(table), file, format});
        });
      },
      [this, question](Result<std::shared_ptr<const Recording>>& read) {
        if (question != asked_) return;
        if (!read) {
          Q_EMIT refused(read.error());
        } else {
          take(*read);
        }
      });
}

QString TraceView::file_name() const { return recording_ ? text_of(recording_->file.filename()) : QString(); }

void TraceView::set_platform(const QString& name) {
  platform_ = name;
  update_answer_text();
}

void TraceView::take(std::shared_ptr<const Recording> recording) {
  recording_ = std::move(recording);
  reading_ = {};
  name_->setText(text_of(recording_->file.filename()));
  name_->setToolTip(text_of(recording_->file));
  fill_columns();
  const hardware::TraceFormat& format = recording_->format;
  const QSignalBlocker quiet(factor_);
  time_->setCurrentIndex(format.time_column.empty() ? 0 : std::stoi(format.time_column));
  power_->setCurrentIndex(std::stoi(format.channels.front().column) - 1);
  factor_->setValue(format.channels.front().amperes_per_volt);
  read_columns();
  Q_EMIT opened();
}

void TraceView::fill_columns() {
  if (!recording_) return;
  const int time = time_->currentIndex(), power = power_->currentIndex();
  time_->clear();
  power_->clear();
  time_->addItem(tr("rows, one a second"));
  for (std::size_t c = 0; c < recording_->table.names.size(); ++c) {
    const QString name = QString::fromStdString(recording_->table.names[c]);
    const QString shown = name == QString::number(c + 1) ? tr("column %1").arg(name) : name;
    time_->addItem(shown);
    power_->addItem(shown);
  }
  time_->setCurrentIndex(time);
  power_->setCurrentIndex(power);
}

void TraceView::read_columns() {
  if (!recording_) return;
  hardware::TraceFormat format = recording_->format;
  format.time_column = time_->currentIndex() > 0 ? std::to_string(time_->currentIndex()) : std::string();
  format.channels = {{std::to_string(power_->currentIndex() + 1), factor_->value(), 1, {}}};
  const int question = ++asked_;
  run_in_background(
      this,
      [recording = recording_, format] {
        Reading reading;
        auto trace = hardware::power_trace(recording->table, format, recording->file);
        if (!trace) {
          reading.problem = trace.error();
          return reading;
        }
        auto runs = hardware::find_runs(*trace);
        if (runs) {
          reading.runs = std::move(*runs);
        } else {
          reading.problem = runs.error();
        }
        reading.trace = std::move(*trace);
        return reading;
      },
      [this, question](Reading& reading) {
        if (question != asked_) return;
        reading_ = std::move(reading);
        if (reading_.trace) plot_->show_trace(*reading_.trace, reading_.runs);
        update_answer_text();
      });
}

void TraceView::update_answer_text() {
  use_->setEnabled(reading_.runs && !platform_.isEmpty());
  use_->setText(platform_.isEmpty() ? tr("Plan with it") : tr("Plan with it as %1").arg(platform_));
  use_->setToolTip(tr("Adds that platform once more, with the idle and active power of this recording"));
  QStringList told;
  if (reading_.runs) {
    const hardware::TraceRuns& runs = *reading_.runs;
    told << tr("Idle %1 W, the median of the pauses. Under load %2 W more, the median of the runs (there are %3).")
                .arg(significant(runs.idle_W), significant(runs.above_idle_W()))
                .arg(runs.runs.size());
    for (const hardware::Sentence& warning : runs.warnings) told << translated(warning);
  } else if (reading_.trace) {
    const auto& power_W = reading_.trace->power_W;
    const auto [minimum, maximum] = std::minmax_element(power_W.begin(), power_W.end());
    told << tr("%1 W on average, from %2 to %3 W.")
                .arg(significant(hardware::mean_power_W(*reading_.trace)), significant(*minimum),
                     significant(*maximum));
  }
  if (reading_.problem) told << translated(*reading_.problem);
  answer_->setText(told.join(" "));
}

}  // namespace glisson::widgets

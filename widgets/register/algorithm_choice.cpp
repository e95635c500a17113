#include "widgets/register/algorithm_choice.h"

#include <algorithm>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QVBoxLayout>

#include "widgets/panels/parts.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {

using registration_quality::SequenceMethod;

namespace {

constexpr int no_column = -1;

}  // namespace

QString long_name(SequenceMethod method) {
  switch (method) {
    case SequenceMethod::icp: return AlgorithmChoice::tr("ICP: nearest points");
    case SequenceMethod::geo: return AlgorithmChoice::tr("GEO: distances along the surface");
    case SequenceMethod::gnra: return AlgorithmChoice::tr("GNRA: all frames by their landmarks");
    case SequenceMethod::given: return AlgorithmChoice::tr("Given by the sequence");
  }
  return {};
}

QString short_name(SequenceMethod method) {
  return method == SequenceMethod::given ? AlgorithmChoice::tr("Given")
                                         : QString::fromStdString(std::string(name_of(method))).toUpper();
}

AlgorithmChoice::AlgorithmChoice(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(7);
  QLabel* title = heading();
  column->addWidget(title);
  for (std::size_t side = 0; side < 2; ++side) {
    auto* box = new QComboBox;
    box->setObjectName(side == 0 ? "first_method" : "second_method");
    for (const SequenceMethod method : registration_quality::sequence_methods)
      box->addItem({}, static_cast<int>(method));
    if (side == 1) box->addItem({}, no_column);
    connect(box, &QComboBox::currentIndexChanged, this, &AlgorithmChoice::chosen);
    methods_[side] = box;
    column->addWidget(box);
  }
  compute_ = new QPushButton;
  compute_->setObjectName("primary");
  column->addWidget(compute_);
  auto* row = new QHBoxLayout;
  progress_ = new QProgressBar;
  progress_->setRange(0, 1000);
  progress_->setTextVisible(false);
  cancel_ = new QPushButton;
  cancel_->setObjectName("cancel_registering");
  row->addWidget(progress_, 1);
  row->addWidget(cancel_);
  column->addLayout(row);
  stage_ = new QLabel;
  stage_->setObjectName("faint");
  column->addWidget(stage_);
  connect(compute_, &QPushButton::clicked, this, &AlgorithmChoice::computing_wanted);
  connect(cancel_, &QPushButton::clicked, this, &AlgorithmChoice::cancel_wanted);
  keep_translated(this, [=, this] {
    title->setText(tr("Algorithms"));
    methods_[0]->setAccessibleName(tr("First algorithm"));
    methods_[1]->setAccessibleName(tr("Second algorithm"));
    methods_[0]->setToolTip(tr("What the left picture shows"));
    methods_[1]->setToolTip(tr("What the right picture shows, or nothing"));
    compute_->setText(tr("Register and judge"));
    cancel_->setText(tr("Cancel"));
    cancel_->setToolTip(tr("Stops registering; what was computed before stays"));
    progress_->setAccessibleName(tr("Progress"));
    update_text();
  });
}

void AlgorithmChoice::offer(const OpenedSequence& sequence) {
  for (std::size_t side = 0; side < 2; ++side) {
    QComboBox& box = *methods_[side];
    const QSignalBlocker quiet(&box);
    auto* items = qobject_cast<QStandardItemModel*>(box.model());
    std::vector<int> possible;
    for (int i = 0; i < box.count(); ++i) {
      const int value = box.itemData(i).toInt();
      const bool can = value == no_column || can_be_registered(sequence, static_cast<SequenceMethod>(value));
      items->item(i)->setEnabled(can);
      if (can) possible.push_back(i);
    }
    // Who brings a registration of his own wants to see that one, beside another.
    std::stable_partition(possible.begin(), possible.end(),
                          [&](int i) { return box.itemData(i).toInt() == static_cast<int>(SequenceMethod::given); });
    box.setCurrentIndex(possible[std::min(side, possible.size() - 1)]);
  }
  update_text();
}

std::optional<SequenceMethod> AlgorithmChoice::method(int side) const {
  const int value = methods_[static_cast<std::size_t>(side)]->currentData().toInt();
  return value == no_column ? std::nullopt : std::optional(static_cast<SequenceMethod>(value));
}

void AlgorithmChoice::show_work(Work work) {
  if (work != work_ && work == Work::under_way) show_progress(0, {});
  work_ = work;
  update_text();
}

void AlgorithmChoice::show_progress(double fraction, const QString& stage) {
  progress_->setValue(static_cast<int>(1000 * fraction));
  stage_->setText(translated_stage(stage));
}

void AlgorithmChoice::update_text() {
  for (QComboBox* box : methods_) {
    const auto* items = qobject_cast<QStandardItemModel*>(box->model());
    for (int i = 0; i < box->count(); ++i) {
      const int value = box->itemData(i).toInt();
      const auto method = static_cast<SequenceMethod>(value);
      box->setItemText(i, value == no_column ? tr("No second algorithm") : long_name(method));
      const QString lacking = method == SequenceMethod::given ? tr("The sequence names no registered clouds")
                                                              : tr("The sequence names no model");
      box->setItemData(i, items->item(i)->isEnabled() ? QString() : lacking, Qt::ToolTipRole);
    }
  }
  compute_->setEnabled(work_ == Work::to_do);
  switch (work_) {
    case Work::none_open: compute_->setToolTip(tr("Open a sequence first")); break;
    case Work::under_way: compute_->setToolTip(tr("It is being computed")); break;
    case Work::done: compute_->setToolTip(tr("Both algorithms are computed already")); break;
    case Work::to_do:
      compute_->setToolTip(
          tr("Registers every frame by the algorithms above and judges them by SIRGn: up to a second or so a frame"));
      break;
  }
  for (QWidget* part :
       {static_cast<QWidget*>(progress_), static_cast<QWidget*>(cancel_), static_cast<QWidget*>(stage_)})
    part->setVisible(work_ == Work::under_way);
}

}  // namespace glisson::widgets

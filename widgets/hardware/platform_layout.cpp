// What the view of platforms is made of: the question at the left, the answer at the right.

#include <QFormLayout>
#include <QPushButton>
#include <QSplitter>
#include <QVBoxLayout>

#include "widgets/hardware/platform_view.h"
#include "widgets/hardware/platform_words.h"
#include "widgets/panels/parts.h"
#include "widgets/words/keep_translated.h"

namespace glisson::widgets {
namespace {

constexpr double dissertation_kPa = 12;  // where no case says

NumberBox* number_box(double minimum, double maximum, int decimals) {
  auto* box = new NumberBox;
  box->setRange(minimum, maximum);
  box->setDecimals(decimals);
  return box;
}

}  // namespace

QWidget* PlatformView::make_question() {
  auto* panel = new QWidget;
  panel->setObjectName("panel");
  auto* column = new QVBoxLayout(panel);
  column->setContentsMargins(14, 14, 14, 14);
  column->setSpacing(8);
  const auto add_slider = [&](NumberSlider* slider, const char* object_name) {
    auto* label = new QLabel;
    label->setBuddy(slider);
    slider->setObjectName(object_name);
    column->addWidget(label);
    column->addWidget(slider);
    return label;
  };
  const auto add_heading = [&] {
    QLabel* title = heading();
    column->addWidget(title);
    return title;
  };

  QLabel* case_title = add_heading();
  case_name_ = new QLabel;
  case_name_->setObjectName("faint");
  case_name_->setWordWrap(true);
  column->addWidget(case_name_);
  auto* form = new QFormLayout;
  form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  volume_ = number_box(hardware::smallest_liver_cm3, hardware::largest_liver_cm3, 0);
  volume_->setObjectName("volume");
  volume_->setSingleStep(50);
  volume_->setValue(1500);
  auto* volume_name = new QLabel;
  form->addRow(volume_name, volume_);
  youngs_ = number_box(1, 100, 1);
  youngs_->setObjectName("youngs");
  youngs_->setValue(dissertation_kPa);
  auto* youngs_name = new QLabel;
  form->addRow(youngs_name, youngs_);
  column->addLayout(form);
  column->addSpacing(8);

  QLabel* wanted_title = add_heading();
  accuracy_ = new NumberSlider(1, 8, 0.1, 1);
  duration_ = new NumberSlider(0.5, 16, 0.25, 2);
  frames_ = new NumberSlider(1, 60, 1, 0);
  QLabel* accuracy_name = add_slider(accuracy_, "accuracy");
  QLabel* duration_name = add_slider(duration_, "duration");
  QLabel* frames_name = add_slider(frames_, "frame_rate");
  duration_->set_value(3);
  frames_->set_value(10);
  column->addSpacing(8);
  QLabel* room_title = add_heading();
  room_ = new NumberSlider(10, 35, 1, 0);
  limit_ = new NumberSlider(37, 60, 1, 0);
  QLabel* room_name = add_slider(room_, "room");
  QLabel* limit_name = add_slider(limit_, "limit");
  room_->set_value(18);
  limit_->set_value(45);
  column->addSpacing(8);
  QLabel* work_title = add_heading();
  task_ = new QComboBox;
  task_->setObjectName("task");
  task_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  task_->addItem({});
  for (const hardware::Task& task : tasks_) task_->addItem({}, QString::fromStdString(task.id));
  column->addWidget(task_);
  workload_ = new QLabel;
  workload_->setObjectName("workload");
  workload_->setWordWrap(true);
  column->addWidget(workload_);
  column->addStretch(1);
  auto* add = new QPushButton;
  connect(add, &QPushButton::clicked, this, &PlatformView::choose_devices);
  column->addWidget(add);
  auto* read = new QPushButton;
  read->setObjectName("read_trace");
  connect(read, &QPushButton::clicked, this, &PlatformView::choose_trace);
  column->addWidget(read);

  keep_translated(panel, [=, this] {
    case_title->setText(tr("The case"));
    volume_name->setText(tr("Liver"));
    volume_->setSuffix(tr(" cm³"));
    youngs_name->setText(tr("Young's modulus"));
    youngs_->setSuffix(tr(" kPa"));
    youngs_->setToolTip(
        tr("Mean Young's modulus. Softer tissue moves farther under the same load, and what a coarse model "
           "misses of it grows alike."));
    wanted_title->setText(tr("What is wanted"));
    accuracy_name->setText(tr("Accuracy"));
    accuracy_->set_suffix(tr(" mm"));
    duration_name->setText(tr("Duration of the operation"));
    duration_->set_suffix(tr(" h"));
    frames_name->setText(tr("Frame rate"));
    frames_->set_suffix(tr(" /s"));
    room_title->setText(tr("The room and the skin"));
    room_name->setText(tr("Operating room"));
    room_->set_suffix(tr(" °C"));
    limit_name->setText(tr("Hottest surface to be worn"));
    limit_->set_suffix(tr(" °C"));
    work_title->setText(tr("What is computed"));
    task_->setItemText(0, tr("The dissertation's product"));
    for (int row = 1; row < task_->count(); ++row) {
      const hardware::Task& task = tasks_.at(static_cast<std::size_t>(row - 1));
      task_->setItemText(row, task_in_words(task));
      task_->setItemData(row, QString::fromStdString(task.what + ": " + task.note), Qt::ToolTipRole);
    }
    add->setText(tr("Add devices..."));
    add->setToolTip(tr("A table of your own, or what glisson-cli platform measure wrote"));
    read->setText(tr("Read a power recording..."));
    read->setToolTip(
        tr("What an oscilloscope, a power analyser or a battery tester wrote of a platform: idle power and "
           "power under load"));
  });
  return panel;
}

QWidget* PlatformView::make_answer() {
  auto* right = new QWidget;
  auto* column = new QVBoxLayout(right);
  column->setContentsMargins(14, 14, 14, 14);
  column->setSpacing(8);
  answer_ = new QLabel;
  answer_->setObjectName("patient_name");
  answer_->setWordWrap(true);
  column->addWidget(answer_);
  refusal_ = new QLabel;
  refusal_->setObjectName("origin");
  refusal_->setWordWrap(true);
  refusal_->hide();
  column->addWidget(refusal_);

  auto* parts = new QSplitter(Qt::Vertical);
  parts->setChildrenCollapsible(false);
  table_ = new PlatformTable;
  parts->addWidget(table_);
  auto* below = new QSplitter(Qt::Horizontal);
  below->setChildrenCollapsible(false);
  plot_ = new QWidget;
  auto* plot_column = new QVBoxLayout(plot_);
  plot_column->setContentsMargins(0, 6, 6, 0);
  quantity_ = new QComboBox;
  quantity_->setObjectName("quantity");
  quantity_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  for (const Quantity quantity : {surface_C, frames, battery, power}) quantity_->addItem({}, quantity);
  quantity_text_ = new QLabel;
  quantity_text_->setObjectName("quantity_told");
  quantity_text_->setWordWrap(true);
  auto* plot_title = new QHBoxLayout;
  plot_title->addWidget(quantity_);
  plot_title->addWidget(quantity_text_, 1);
  plot_column->addLayout(plot_title);
  contours_ = new ContourPlot;
  plot_column->addWidget(contours_, 1);
  below->addWidget(plot_);
  trace_ = new TraceView;
  trace_->hide();
  below->addWidget(trace_);
  details_ = new QTextBrowser;
  details_->setObjectName("details");
  details_->setMinimumWidth(260);
  below->addWidget(details_);
  below->setSizes({620, 620, 420});
  parts->addWidget(below);
  parts->setSizes({430, 420});
  column->addWidget(parts, 1);
  notes_ = new QLabel;
  notes_->setObjectName("faint");
  notes_->setWordWrap(true);
  notes_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  column->addWidget(notes_);
  keep_translated(right, [this] {
    quantity_->setItemText(surface_C, tr("Surface temperature"));
    quantity_->setItemText(frames, tr("Frame rate that holds"));
    quantity_->setItemText(battery, tr("Battery life"));
    quantity_->setItemText(power, tr("Mean power"));
  });
  return right;
}

}  // namespace glisson::widgets

#include "widgets/resect/growth_controls.h"

#include <algorithm>
#include <QFormLayout>
#include <QLocale>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "report/growth.h"
#include "vasculature/couinaud.h"
#include "widgets/panels/ask_path.h"
#include "widgets/panels/parts.h"
#include "widgets/panels/small_table.h"
#include "widgets/theme.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/numbers.h"
#include "widgets/words/translated.h"
#include "widgets/work/run_in_background.h"

namespace glisson::widgets {
namespace {

using casefile::ComparedStudies;
using casefile::GrowthQuestion;

// "+38 %", with ~ where it may be none.
QString change_in(const planning::PartGrowth& part) {
  const auto change = part.change_percent();
  if (!change) return "–";
  return (part.within_error ? "~" : "") + QString(*change < 0 ? "" : "+") + number(*change, 0) + " %";
}

QString stiffness_in(const planning::PartGrowth& part) {
  const auto kPa = [](const planning::Tissue& tissue) {
    return tissue.mean_kPa ? number(*tissue.mean_kPa, 1) : QString("–");
  };
  return kPa(part.before) + " → " + kPa(part.after);
}

bool has_stiffness(const planning::PartGrowth& part) { return part.before.mean_kPa || part.after.mean_kPa; }

}  // namespace

GrowthControls::GrowthControls(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  choose_ = named_button("earlier_study", this);
  column->addWidget(choose_);
  chosen_ = wrapped_label("faint", this);
  column->addWidget(chosen_);
  column->addWidget(make_fields());
  one_patient_ = named_button("one_patient", this);
  column->addWidget(one_patient_);
  table_ = small_table("growth_table", 5, this);
  column->addWidget(table_);
  text_ = wrapped_label("growth_told", this);
  column->addWidget(text_);
  connect(choose_, &QPushButton::clicked, this, &GrowthControls::ask);
  connect(one_patient_, &QPushButton::clicked, this, [this] {
    patients_ = GrowthQuestion::Patients::one;
    compare();
  });
  keep_translated(this, [this] {
    choose_->setText(tr("Earlier study..."));
    choose_->setToolTip(tr("The case of this patient's earlier study, with its segments: a folder NAME.glisson"));
    one_patient_->setText(tr("They are of one patient"));
    table_->setHorizontalHeaderLabels({tr("Segment"), tr("Before"), tr("Now"), tr("Change"), tr("kPa")});
    table_->horizontalHeaderItem(before_column)->setToolTip(tr("ml without tumours, in the earlier study"));
    table_->horizontalHeaderItem(now_column)->setToolTip(tr("ml without tumours, in the open case"));
    table_->horizontalHeaderItem(change_column)
        ->setToolTip(tr("Of what it was; ~: no more than such a volume may be off by"));
    table_->horizontalHeaderItem(stiffness_column)->setToolTip(tr("Mean stiffness before and now"));
    show_result();
  });
}

QWidget* GrowthControls::make_fields() {
  fields_ = new QWidget(this);
  auto* form = new QFormLayout(fields_);
  form->setContentsMargins(0, 0, 0, 0);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  plan_ = new QComboBox(fields_);
  plan_->setObjectName("growth_plan");
  plan_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  plan_->addItem({});
  const auto box = [&](const char* name, int largest) {
    NumberBox* made = whole_number(name, 0, largest, 0, fields_);
    connect(made, &NumberBox::valueChanged, this, &GrowthControls::compare);
    return made;
  };
  days_ = box("growth_days", 36525);
  standard_ = box("standard_volume", 10000);
  auto* plan_name = new QLabel(fields_);
  auto* days_name = new QLabel(fields_);
  auto* standard_name = new QLabel(fields_);
  plan_name->setBuddy(plan_);
  days_name->setBuddy(days_);
  standard_name->setBuddy(standard_);
  form->addRow(plan_name, plan_);
  form->addRow(days_name, days_);
  form->addRow(standard_name, standard_);
  connect(plan_, &QComboBox::currentIndexChanged, this, &GrowthControls::compare);
  keep_translated(fields_, [=, this] {
    plan_name->setText(tr("Remnant of"));
    plan_->setItemText(0, tr("no plan"));
    days_name->setText(tr("Days between"));
    days_->setToolTip(tr("0: by the dates of the images. To be typed where these have none"));
    standard_name->setText(tr("Standard volume"));
    standard_->setSuffix(tr(" ml"));
    standard_->setToolTip(
        tr("The liver's volume estimated from body size, of which the per cent are in both studies: "
           "-794.41 + 1267.28 × body surface in m² (Vauthey et al. 2002). 0: of each study's own "
           "liver"));
  });
  return fields_;
}

void GrowthControls::show_case(const std::filesystem::path& folder) {
  if (folder != folder_) {
    folder_ = folder;
    earlier_.clear();
    for (NumberBox* field : {days_, standard_}) {
      const QSignalBlocker quiet(field);
      field->setValue(0);
    }
  }
  compare();
}

void GrowthControls::offer(const std::vector<KeptPlanAnswer>& plans) {
  const QString before = plan_->currentData().toString();
  {
    const QSignalBlocker quiet(plan_);
    while (plan_->count() > 1) plan_->removeItem(1);
    for (const KeptPlanAnswer& plan : plans) {
      const QString name = QString::fromStdString(plan.kept.plan.name);
      plan_->addItem(name, name);
    }
    plan_->setCurrentIndex(std::max(0, plan_->findData(before)));
  }
  compare();
}

void GrowthControls::ask() {
  const QString chosen = ask_for_folder(this, tr("The case of the earlier study"));
  if (!chosen.isEmpty()) compare_with(chosen.toStdString());
}

void GrowthControls::compare_with(const std::filesystem::path& earlier) {
  earlier_ = earlier;
  patients_ = GrowthQuestion::Patients::as_images_say;
  compare();
}

void GrowthControls::compare() {
  const int asked = ++asked_;
  result_.reset();
  problem_.reset();
  show_result();
  if (folder_.empty() || earlier_.empty()) return;
  GrowthQuestion question;
  question.patients = patients_;
  if (plan_->currentIndex() > 0) question.plan = plan_->currentData().toString().toStdString();
  if (days_->value() > 0) question.options.days = days_->value();
  if (standard_->value() > 0) question.options.standard_liver_ml = standard_->value();
  run_in_background(
      this,
      [folder = folder_, earlier = earlier_, question]() -> Result<std::shared_ptr<const ComparedStudies>> {
        const auto before = casefile::Case::open(earlier);
        if (!before) return failure(before.error());
        const auto after = casefile::Case::open(folder);
        if (!after) return failure(after.error());
        return casefile::compare_studies(*before, *after, question).map([](ComparedStudies compared) {
          return std::make_shared<const ComparedStudies>(std::move(compared));
        });
      },
      [this, asked](const Result<std::shared_ptr<const ComparedStudies>>& compared) {
        if (asked != asked_) return;
        result_ = compared.value_or(nullptr);
        problem_ = compared ? std::nullopt : std::optional(compared.error());
        show_result();
      });
}

void GrowthControls::show_result() {
  chosen_->setText(QString::fromStdString(earlier_.filename().string()));
  for (QWidget* each : std::initializer_list<QWidget*>{chosen_, fields_, text_}) each->setVisible(!earlier_.empty());
  one_patient_->setVisible(problem_ && problem_->code == "growth-not-one-patient");
  table_->setVisible(result_ != nullptr);
  if (!result_) {
    text_->setText(problem_ ? "▲ " + translated(*problem_) : tr("Comparing..."));
    return;
  }
  const planning::Growth& growth = result_->growth;
  table_->setRowCount(0);
  for (const planning::SegmentGrowth& segment : growth.segments) {
    add_row(vasculature::segment_name(static_cast<std::size_t>(segment.number)), segment.part);
  }
  if (growth.remnant) add_row(tr("Remnant"), growth.remnant->part);
  add_row(tr("Liver"), growth.liver);
  table_->setColumnHidden(stiffness_column, !has_stiffness(growth.liver));
  fit_height(*table_);
  QStringList lines;
  for (const Sentence& sentence : report::growth_sentences(*result_)) lines << translated(sentence).toHtmlEscaped();
  text_->setText(lines.join("<br>"));
}

void GrowthControls::add_row(const QString& name, const planning::PartGrowth& part) {
  const int row = table_->rowCount();
  table_->insertRow(row);
  put_text(*table_, row, part_column, name);
  const auto put = [&](Column column, const QString& text) {
    QTableWidgetItem* cell = put_text(*table_, row, column, text);
    cell->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    return cell;
  };
  put(before_column, number(part.before.ml, 0))
      ->setToolTip(tr("%1 % of the liver").arg(number(part.before_percent, 1)));
  put(now_column, number(part.after.ml, 0))->setToolTip(tr("%1 % of the liver").arg(number(part.after_percent, 1)));
  QTableWidgetItem* change = put(change_column, change_in(part));
  if (part.within_error) change->setForeground(theme_colour("faint"));
  put(stiffness_column, stiffness_in(part))
      ->setToolTip(tr("%1 % and %2 % of it were measured.")
                       .arg(number(100 * part.before.confident_share, 0), number(100 * part.after.confident_share, 0)));
}

}  // namespace glisson::widgets

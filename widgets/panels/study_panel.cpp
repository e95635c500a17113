#include "widgets/panels/study_panel.h"

#include <QHeaderView>
#include <QVBoxLayout>
#include <set>

#include "scene/anatomy.h"
#include "widgets/panels/parts.h"
#include "widgets/panels/swatch.h"
#include "widgets/words/grid_words.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {
namespace {

constexpr int fixed_role = Qt::UserRole + 1;

}  // namespace

StudyPanel::StudyPanel(QWidget* parent) : QWidget(parent) {
  setObjectName("panel");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(14, 14, 14, 14);
  column->setSpacing(8);

  name_ = new QLabel(this);
  name_->setObjectName("patient_name");
  name_->setWordWrap(true);
  column->addWidget(name_);
  facts_ = new QLabel(this);
  facts_->setObjectName("faint");
  facts_->setWordWrap(true);
  column->addWidget(facts_);

  column->addSpacing(8);
  QLabel* image_title = heading(this);
  column->addWidget(image_title);
  slice_image_ = new QComboBox(this);
  slice_image_->setObjectName("slice_image");
  slice_image_->addItem({}, static_cast<int>(SliceImage::anatomy));
  slice_image_->addItem({}, static_cast<int>(SliceImage::stiffness));
  slice_image_->setEnabled(false);
  column->addWidget(slice_image_);
  connect(slice_image_, &QComboBox::activated, this,
          [this] { Q_EMIT slice_image_chosen(static_cast<SliceImage>(slice_image_->currentData().toInt())); });

  column->addSpacing(8);
  QLabel* structures_title = heading(this);
  column->addWidget(structures_title);
  structures_ = new QTreeWidget(this);
  structures_->setObjectName("structures");
  structures_->setColumnCount(2);
  structures_->header()->setStretchLastSection(false);
  structures_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  structures_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  structures_->setRootIsDecorated(false);
  structures_->setUniformRowHeights(true);
  structures_->setSelectionMode(QAbstractItemView::NoSelection);
  structures_->setFocusPolicy(Qt::TabFocus);
  column->addWidget(structures_, 1);
  connect(structures_, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item, int col) {
    if (col != 0) return;
    Q_EMIT structure_shown(item->data(0, Qt::UserRole).toString().toStdString(), item->checkState(0) == Qt::Checked);
  });

  keep_translated(this, [=, this] {
    image_title->setText(tr("Slices show"));
    slice_image_->setItemText(0, tr("Anatomy"));
    slice_image_->setItemText(1, tr("Stiffness (MR elastography)"));
    structures_title->setText(tr("Structures"));
    structures_->setHeaderLabels({tr("Structure"), tr("ml")});
    update_patient_text();
  });
}

void StudyPanel::show_patient(const Patient& patient) {
  const bool seen = patient.completes(patient_);
  patient_ = patient;
  if (seen) return update_patient_text();
  slice_image_->setCurrentIndex(0);
  slice_image_->setEnabled(patient.stiffness != nullptr);

  const QSignalBlocker quiet(structures_);
  structures_->clear();
  list(patient.all_structures());
}

void StudyPanel::list(const std::vector<PatientStructure>& structures) {
  const QSignalBlocker quiet(structures_);
  std::set<QString> hidden;
  for (int k = 0; k < structures_->topLevelItemCount(); ++k) {
    const QTreeWidgetItem* row = structures_->topLevelItem(k);
    if (row->checkState(0) == Qt::Unchecked) hidden.insert(row->data(0, Qt::UserRole).toString());
  }
  structures_->clear();
  for (const PatientStructure& structure : structures) {
    auto* row = new QTreeWidgetItem(structures_);
    const QString name = QString::fromStdString(structure.name);
    row->setIcon(0, swatch(scene::appearance_of(structure.name).colour));
    row->setData(0, Qt::UserRole, name);
    row->setData(0, fixed_role, structure.fixed);
    row->setCheckState(0, hidden.count(name) == 0 ? Qt::Checked : Qt::Unchecked);
    row->setText(1, QLocale().toString(structure.volume_ml, 'f', structure.volume_ml < 100 ? 1 : 0));
    row->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
  }
  update_patient_text();
}

void StudyPanel::update_patient_text() {
  name_->setText(patient_.name.empty() ? tr("No patient open") : patient_label(patient_.name));
  QStringList facts;
  if (patient_.anatomy) {
    const imaging::Grid& grid = patient_.anatomy->grid;
    facts << tr("%1 voxels,\n%2 each").arg(size_words(grid), spacing_words(grid));
  }
  if (patient_.rehearsal) {
    facts << (patient_.assumed_stiffness ? tr("%1 cells\nYoung's modulus %2 kPa (assumed)")
                                         : tr("%1 cells\nYoung's modulus %2 kPa (mean)"))
                 .arg(patient_.rehearsal->patient().mesh().cells.size())
                 .arg(patient_.mean_youngs_kPa, 0, 'f', 1);
  }
  facts_->setText(facts.join("\n"));
  const QSignalBlocker quiet(structures_);
  for (int k = 0; k < structures_->topLevelItemCount(); ++k) {
    QTreeWidgetItem* row = structures_->topLevelItem(k);
    const QString label = structure_label(row->data(0, Qt::UserRole).toString().toStdString());
    const bool fixed = row->data(0, fixed_role).toBool();
    row->setText(0, fixed ? tr("%1 (fixed)").arg(label) : label);
    row->setToolTip(
        0, fixed ? label + "\n" + tr("No part of the model: drawn where it was outlined, it does not move.") : label);
  }
}

}  // namespace glisson::widgets

#include "widgets/rehearse/landmark_table.h"

#include <fmt/format.h>
#include <QHeaderView>

#include "widgets/theme.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {
namespace {

QTableWidgetItem* ensured(QTableWidget& table, int row, int column) {
  if (table.item(row, column) == nullptr) table.setItem(row, column, new QTableWidgetItem);
  return table.item(row, column);
}

}  // namespace

LandmarkTable::LandmarkTable(QWidget* parent) : QTableWidget(0, 4, parent) {
  setObjectName("landmarks");
  keep_translated(this, [this] {
    setHorizontalHeaderLabels({tr("Landmark"), tr("Moves\nmm"), tr("Atlas off\nmm"), tr("From 5 mm")});
    horizontalHeaderItem(moves_column)->setToolTip(tr("How far the landmark moves from where the scan shows it"));
    horizontalHeaderItem(apart_column)->setToolTip(tr("How far from there the atlas's stiffness puts it"));
    horizontalHeaderItem(flag_column)->setToolTip(tr("5 mm and more matters to a surgeon"));
  });
  horizontalHeader()->setSectionResizeMode(name_column, QHeaderView::Stretch);
  for (const int column : {moves_column, apart_column, flag_column}) {
    horizontalHeader()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
  }
  verticalHeader()->hide();
  verticalHeader()->setDefaultSectionSize(24);
  setEditTriggers(DoubleClicked | EditKeyPressed);  // of names that were given by hand
  setSelectionBehavior(SelectRows);
  setSelectionMode(SingleSelection);
  setShowGrid(false);
  setTextElideMode(Qt::ElideMiddle);  // the number at a name's end tells it from its neighbours
  setAlternatingRowColors(true);
  connect(this, &QTableWidget::itemChanged, this, [this](QTableWidgetItem* changed) {
    if (filling_ || changed->column() != name_column) return;
    Q_EMIT rename_wanted(changed->data(Qt::UserRole).toString().toStdString(), changed->text());
  });
  connect(this, &QTableWidget::itemSelectionChanged, this, [this] {
    const QTableWidgetItem* chosen = currentRow() >= 0 ? item(currentRow(), name_column) : nullptr;
    Q_EMIT landmark_chosen(chosen != nullptr ? chosen->data(Qt::UserRole).toString().toStdString() : std::string());
  });
}

std::string LandmarkTable::chosen_own() const {
  const QTableWidgetItem* chosen = currentRow() >= 0 ? item(currentRow(), name_column) : nullptr;
  const std::string id = chosen != nullptr ? chosen->data(Qt::UserRole).toString().toStdString() : std::string();
  return own_.count(id) != 0 ? id : std::string();
}

void LandmarkTable::show_state(const rehearsal::RehearsalState* state) {
  if (state == nullptr) {
    setRowCount(0);
    return;
  }
  setColumnHidden(apart_column, !state->reference);
  filling_ = true;
  setRowCount(static_cast<int>(state->patient.landmarks.size()));
  for (std::size_t k = 0; k < state->patient.landmarks.size(); ++k) {
    const auto row = static_cast<int>(k);
    fill_row(row, state->patient.landmarks[k], k < state->differences.size() ? &state->differences[k] : nullptr);
    if (state->validity.usable()) continue;
    for (const int column : {moves_column, apart_column}) item(row, column)->setText("–");
    item(row, flag_column)->setText({});
  }
  filling_ = false;
}

void LandmarkTable::fill_row(int row, const mechanics::DisplacedLandmark& landmark,
                             const rehearsal::LandmarkDifference* difference) {
  const bool moves_far = landmark.displacement_mm >= rehearsal::significant_mm;
  const bool reference_far = difference != nullptr && difference->significant();
  QTableWidgetItem* name = ensured(*this, row, name_column);
  name->setText(structure_label(landmark.id));
  const bool own = own_.count(landmark.id) != 0;
  name->setToolTip(own ? tr("%1: set by hand. A double click renames it.").arg(name->text()) : name->text());
  for (int column = name_column; column <= flag_column; ++column) {
    const bool renames = own && column == name_column;
    QTableWidgetItem* cell = ensured(*this, row, column);
    cell->setFlags(renames ? cell->flags() | Qt::ItemIsEditable : cell->flags() & ~Qt::ItemIsEditable);
  }
  name->setData(Qt::UserRole, QString::fromStdString(landmark.id));
  QTableWidgetItem* moves = ensured(*this, row, moves_column);
  moves->setText(QLocale().toString(landmark.displacement_mm, 'f', 1));
  QTableWidgetItem* apart = ensured(*this, row, apart_column);
  apart->setText(difference != nullptr ? QLocale().toString(difference->difference_mm, 'f', 1) : QString("–"));
  for (QTableWidgetItem* number : {moves, apart}) number->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  QTableWidgetItem* flag = ensured(*this, row, flag_column);
  flag->setText(reference_far ? tr("▲ Atlas off") : moves_far ? tr("● Moves") : QString());
  // Colour repeats what the words say.
  const QBrush plain;
  const QColor amber = theme_colour("warning");
  moves->setForeground(moves_far ? QBrush(amber) : plain);
  apart->setForeground(reference_far ? QBrush(amber) : plain);
  flag->setForeground(moves_far || reference_far ? QBrush(amber) : plain);
  QFont font = flag->font();
  font.setBold(reference_far);
  flag->setFont(font);
}

std::string landmark_csv(const rehearsal::RehearsalState& state) {
  std::string text =
      "landmark,rest_x_mm,rest_y_mm,rest_z_mm,x_mm,y_mm,z_mm,displacement_mm,atlas_off_mm,"
      "state,largest_strain,inverted_cells\n";
  const mechanics::Validity& validity = state.validity;
  for (std::size_t k = 0; k < state.patient.landmarks.size(); ++k) {
    const mechanics::DisplacedLandmark& landmark = state.patient.landmarks[k];
    const auto& rest = landmark.rest_mm;
    const auto& now = landmark.displaced_mm;
    text += fmt::format("{},{:.3f},{:.3f},{:.3f},", landmark.id, rest.x(), rest.y(), rest.z());
    if (validity.usable()) {
      text += fmt::format("{:.3f},{:.3f},{:.3f},{:.3f},", now.x(), now.y(), now.z(), landmark.displacement_mm);
      if (k < state.differences.size()) text += fmt::format("{:.3f}", state.differences[k].difference_mm);
    } else {
      text += ",,,,";
    }
    text +=
        fmt::format(",{},{:.4f},{}\n", to_string(validity.state()), validity.largest_strain, validity.inverted_cells);
  }
  return text;
}

}  // namespace glisson::widgets

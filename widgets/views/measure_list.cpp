#include "widgets/views/measure_list.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QToolButton>

#include "widgets/words/keep_translated.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {

MeasureList::MeasureList(MeasureTool& tool, LinkedViews& views, QWidget* parent)
    : QTableWidget(0, 3, parent), tool_(tool) {
  setObjectName("measurements");
  setEditTriggers(NoEditTriggers);
  setSelectionBehavior(SelectRows);
  setSelectionMode(SingleSelection);
  setShowGrid(false);
  verticalHeader()->hide();
  verticalHeader()->setDefaultSectionSize(24);
  horizontalHeader()->hide();
  horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  horizontalHeader()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  horizontalHeader()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
  connect(&tool_, &MeasureTool::changed, this, &MeasureList::show_all);
  connect(this, &QTableWidget::itemSelectionChanged, this, [this, &views] {
    const int row = currentRow();
    if (row < 0 || row >= static_cast<int>(tool_.measurements().size())) return;
    const Measurement& chosen = tool_.measurements()[static_cast<std::size_t>(row)];
    if (!chosen.points_mm.empty()) views.set_crosshair(chosen.points_mm.front());
  });
  keep_translated(this, [this] {
    setAccessibleName(tr("Measurements"));
    show_all();
  });
}

void MeasureList::show_all() {
  const auto& all = tool_.measurements();
  const QSignalBlocker quiet(this);
  setRowCount(static_cast<int>(all.size()));
  for (int row = 0; row < rowCount(); ++row) {
    const Measurement& each = all[static_cast<std::size_t>(row)];
    QString name;
    switch (each.kind) {
      case MeasureKind::distance: name = tr("Distance"); break;
      case MeasureKind::angle: name = tr("Angle"); break;
      case MeasureKind::ball: name = tr("Ball"); break;
      case MeasureKind::structure: name = tr("Volume: %1").arg(structure_label(each.structure)); break;
    }
    setItem(row, 0, new QTableWidgetItem(QString::number(row + 1) + ". " + name));
    auto* value = new QTableWidgetItem(value_text(each));
    value->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    setItem(row, 1, value);
    auto* remove = new QToolButton;
    remove->setObjectName("remove_measurement");
    remove->setAutoRaise(true);
    remove->setText("×");
    remove->setToolTip(tr("Takes this measurement away"));
    connect(
        remove, &QToolButton::clicked, &tool_, [this, row] { tool_.remove(static_cast<std::size_t>(row)); },
        Qt::QueuedConnection);
    setCellWidget(row, 2, remove);
  }
  constexpr int maximum_rows_seen = 4;
  setFixedHeight(24 * std::min(maximum_rows_seen, rowCount()) + 4);
  setVisible(rowCount() > 0);
}

void MeasureList::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Delete && currentRow() >= 0 && currentRow() < rowCount()) {
    tool_.remove(static_cast<std::size_t>(currentRow()));
    return;
  }
  QTableWidget::keyPressEvent(event);
}

}  // namespace glisson::widgets

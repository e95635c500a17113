#include "widgets/panels/small_table.h"

#include <algorithm>
#include <QHeaderView>

namespace glisson::widgets {

QTableWidget* small_table(const char* name, int columns, QWidget* parent) {
  auto* made = new QTableWidget(0, columns, parent);
  made->setObjectName(name);
  made->verticalHeader()->hide();
  made->verticalHeader()->setDefaultSectionSize(24);
  made->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  made->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  made->setEditTriggers(QAbstractItemView::NoEditTriggers);
  made->setSelectionMode(QAbstractItemView::NoSelection);
  made->setFocusPolicy(Qt::TabFocus);
  made->setShowGrid(false);
  made->setAlternatingRowColors(true);
  made->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  return made;
}

QTableWidgetItem* put_text(QTableWidget& table, int row, int column, const QString& text) {
  if (table.item(row, column) == nullptr) table.setItem(row, column, new QTableWidgetItem);
  QTableWidgetItem* cell = table.item(row, column);
  cell->setText(text);
  cell->setToolTip(text);
  cell->setForeground(QBrush());
  return cell;
}

void fit_height(QTableWidget& table, int most_rows) {
  const int rows = std::clamp(table.rowCount(), 1, most_rows);
  table.setFixedHeight(table.horizontalHeader()->sizeHint().height() + 24 * rows + 4);
}

}  // namespace glisson::widgets

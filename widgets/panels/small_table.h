#pragma once
// A table of a few rows in a panel: as tall as they are, so that the panel scrolls and not each table in it.

#include <QTableWidget>

namespace glisson::widgets {

[[nodiscard]] QTableWidget* small_table(const char* name, int columns, QWidget* parent);

// Sets the text of a cell, made where it is not there yet, in the usual colour.
QTableWidgetItem* put_text(QTableWidget& table, int row, int column, const QString& text);

// As high as its rows, or as that many, beyond which it scrolls.
void fit_height(QTableWidget& table, int most_rows = 100);

}  // namespace glisson::widgets

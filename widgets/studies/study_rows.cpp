#include "widgets/studies/study_rows.h"

#include <algorithm>
#include <cmath>
#include <QHeaderView>
#include <QLocale>

#include "base/csv.h"
#include "base/files.h"
#include "studies/dissertation/batch.h"

namespace glisson::widgets {

namespace fs = std::filesystem;

namespace {

constexpr int most_rows = 20'000;

QTableWidgetItem* number_cell(double value) {
  auto* cell = new QTableWidgetItem;
  const bool whole = value == std::round(value) && std::abs(value) < 1e9;
  cell->setText(whole ? QLocale().toString(value, 'f', 0) : QLocale().toString(value, 'g', 4));
  cell->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  return cell;
}

// The table that a study without patients writes: the first by name.
fs::path csv_in(const fs::path& folder) {
  fs::path first;
  std::error_code problem;
  for (fs::directory_iterator entry(folder, problem), end; !problem && entry != end; entry.increment(problem)) {
    if (entry->path().extension() == ".csv" && (first.empty() || entry->path() < first)) first = entry->path();
  }
  return first;
}

}  // namespace

StudyRows::StudyRows(QWidget* parent) : QTableWidget(parent) {
  setObjectName("study_rows");
  verticalHeader()->hide();
  verticalHeader()->setDefaultSectionSize(24);
  setEditTriggers(NoEditTriggers);
  setSelectionBehavior(SelectRows);
  setAlternatingRowColors(true);
  setShowGrid(false);
}

void StudyRows::follow(const fs::path& folder) {
  folder_ = folder;
  read_.clear();
  failed_ = 0;
  csv_time_ = {};
  setRowCount(0);
  setColumnCount(0);
  look_again();
}

void StudyRows::look_again() {
  if (folder_.empty()) return;
  const std::vector<studies::BatchRow> rows = studies::rows_in(folder_, read_);
  // Those that failed are tried again, and so told again.
  failed_ = static_cast<int>(
      std::count_if(rows.begin(), rows.end(), [](const studies::BatchRow& row) { return !row.error.empty(); }));
  for (const studies::BatchRow& row : rows) {
    if (!row.error.empty()) continue;
    read_.insert(row.id);
    if (rowCount() >= most_rows) continue;
    const int line = rowCount();
    setRowCount(line + 1);
    setItem(line, column("patient"), new QTableWidgetItem(QString::fromStdString(row.id)));
    for (const auto& [name, value] : row.values) {
      setItem(line, column(QString::fromStdString(name)), number_cell(value));
    }
  }
  if (!rows.empty()) resizeColumnToContents(0);
  if (read_.empty() && failed_ == 0) show_csv();
}

void StudyRows::show_csv() {
  const fs::path file = csv_in(folder_);
  std::error_code problem;
  const auto written = file.empty() ? fs::file_time_type{} : fs::last_write_time(file, problem);
  if (file.empty() || written == csv_time_) return;
  const auto text = read_text_file(file);
  if (!text) return;
  csv_time_ = written;
  setRowCount(0);
  setColumnCount(0);
  const std::vector<CsvRow> rows = csv_rows(*text);
  if (rows.empty()) return;
  QStringList names;
  for (const std::string_view cell : rows.front().cells) {
    names << QString::fromUtf8(cell.data(), static_cast<qsizetype>(cell.size()));
  }
  setColumnCount(static_cast<int>(names.size()));
  setHorizontalHeaderLabels(names);
  const int count = std::min(most_rows, static_cast<int>(rows.size()) - 1);
  setRowCount(count);
  for (int line = 0; line < count; ++line) {
    const CsvRow& row = rows[static_cast<std::size_t>(line) + 1];
    for (std::size_t cell = 0; cell < std::min(row.cells.size(), static_cast<std::size_t>(columnCount())); ++cell) {
      const double value = row.number(cell);
      const std::string_view words = row.cells[cell];
      setItem(line, static_cast<int>(cell),
              std::isfinite(value)
                  ? number_cell(value)
                  : new QTableWidgetItem(QString::fromUtf8(words.data(), static_cast<qsizetype>(words.size()))));
    }
  }
  resizeColumnsToContents();
}

// Made where there is none of that name.
int StudyRows::column(const QString& name) {
  for (int each = 0; each < columnCount(); ++each) {
    if (horizontalHeaderItem(each)->text() == name) return each;
  }
  const int made = columnCount();
  setColumnCount(made + 1);
  setHorizontalHeaderItem(made, new QTableWidgetItem(name));
  setColumnWidth(made, std::max(110, fontMetrics().horizontalAdvance(name) + 28));
  return made;
}

}  // namespace glisson::widgets

#pragma once
// What comes of the cut, in words and numbers: how much goes and stays, margins, vessels crossed.

#include <QLabel>
#include <QTableWidget>
#include <QWidget>

#include "widgets/resect/live_resection.h"

namespace glisson::widgets {

class ResectionResults : public QWidget {
  Q_OBJECT

 public:
  enum MarginColumn { structure_column, side_column, margin_column, flag_column };

  explicit ResectionResults(QWidget* parent = nullptr);

  // nullptr: nothing is cut, and `why` says so.
  void show(const LiveResectionResult* result, const QString& why);

 private:
  void tell_retraction(const rehearsal::Resection& plan);
  void fill_margins(const rehearsal::Resection& plan);
  void fill_crossings(const rehearsal::Resection& plan);

  QLabel* why_;
  QWidget* answer_;
  QLabel* specimen_;
  QLabel* remnant_;
  QLabel* retraction_;
  QTableWidget* margins_;
  QTableWidget* crossings_;
  QLabel* no_crossings_;
};

// "removed", "stays", "cut through".
[[nodiscard]] QString side_label(rehearsal::ResectionSide side);

// What a surgeon must not overlook of a tumour, with a symbol; empty for nothing.
[[nodiscard]] QString margin_flag(const rehearsal::TumourMargin& tumour);

}  // namespace glisson::widgets

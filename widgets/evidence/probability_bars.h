#pragma once
// How probable each explanation is: a line each with its name, a bar and a figure, the likeliest first.

#include <QWidget>

#include "widgets/evidence/evidence_record.h"

namespace glisson::widgets {

class ProbabilityBars : public QWidget {
  Q_OBJECT

 public:
  explicit ProbabilityBars(QWidget* parent = nullptr);

  // The four likeliest of those that have a percent or more; hidden where a report has none. In the window's language:
  // call again when that changes.
  void show_record(const EvidenceRecord& record);
};

}  // namespace glisson::widgets

#pragma once
// The numbers of a report of measurements: errors before and after, what was found, the candidates in their order, and
// what could have been found.

#include <QTableWidget>
#include <QTreeWidget>

#include "closedloop/learnt_organ.h"
#include "widgets/evidence/evidence_record.h"

namespace glisson::widgets {

class ErrorsTable : public QTableWidget {
  Q_OBJECT

 public:
  explicit ErrorsTable(QWidget* parent = nullptr);
  void show_record(const EvidenceRecord& record);
};

// An effect is a row that can be ticked, its parameters stand below it.
class FoundTree : public QTreeWidget {
  Q_OBJECT

 public:
  explicit FoundTree(QWidget* parent = nullptr);
  void show_record(const EvidenceRecord& record);
  [[nodiscard]] std::vector<std::string> ticked_kinds() const;
  // What each effect would do to the patient's organ: one that does nothing cannot be ticked and says why.
  void show_consequences(const std::vector<closedloop::LearntEffect>& effects);

 Q_SIGNALS:
  void ticked();
};

class CandidatesTable : public QTableWidget {
  Q_OBJECT

 public:
  enum Column { name, rms, held_out, delta_bic, alike };

  explicit CandidatesTable(QWidget* parent = nullptr);
  void show_record(const EvidenceRecord& record);
};

// What the trials could have shown, where they show nothing.
class VisibleTable : public QTableWidget {
  Q_OBJECT

 public:
  enum Column { effect, parameter, without, seen_from };

  explicit VisibleTable(QWidget* parent = nullptr);
  void show_record(const EvidenceRecord& record);
};

// "1.23 mm": of a record's unit.
[[nodiscard]] QString with_unit(double value, const EvidenceRecord& record);

}  // namespace glisson::widgets

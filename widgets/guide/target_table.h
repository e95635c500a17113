#pragma once
// What is drawn over a frame, by name: its colour, how far it may be off, and how deep it lies.

#include <QTableWidget>

#include "casefile/guided_sequence.h"

namespace glisson::widgets {

class TargetTable : public QTableWidget {
  Q_OBJECT

 public:
  enum Column { name, sd, within, deep, column_count };

  explicit TargetTable(QWidget* parent = nullptr);

  // A row a structure, in the order of the list, without figures where `outlines` has none.
  void show_structures(const std::vector<guidance::EmbeddedStructure>& structures,
                       const std::vector<guidance::PlacedOutline>& outlines, double tolerance_mm);
};

}  // namespace glisson::widgets

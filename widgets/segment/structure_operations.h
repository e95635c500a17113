#pragma once
// What changes the chosen structure as a whole by grey values or by another structure. There are two numbers, where
// they hold, and what to do with which other one. It says what is wanted; the workspace does it.

#include <optional>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <string>

#include "widgets/panels/number_slider.h"
#include "widgets/segment/structure_editor.h"

namespace glisson::widgets {

class StructureOperations : public QWidget {
  Q_OBJECT

 public:
  enum Combination { unite, intersect, subtract };

  explicit StructureOperations(QWidget* parent = nullptr);

  // The structures to choose from, without the chosen one where it makes no sense.
  void list(const std::vector<EditedStructure>& structures, int active);
  void set_range(const segmentation::GreyRange& range);
  [[nodiscard]] segmentation::GreyRange range() const;
  // Of the brush: only these grey values are painted, where asked for.
  [[nodiscard]] std::optional<segmentation::GreyRange> brush_range() const;
  // The structure to stay inside of; empty: anywhere.
  [[nodiscard]] std::string within() const;
  [[nodiscard]] std::string other() const;
  [[nodiscard]] Combination combination() const { return static_cast<Combination>(how_->currentIndex()); }

 Q_SIGNALS:
  void brush_range_changed();
  void range_wanted_from_crosshair();
  void take_asked();
  void combine_asked();

 private:
  void update_text();

  QLabel* title_;
  QLabel* range_title_;
  NumberBox* low_;
  NumberBox* high_;
  QPushButton* from_crosshair_;
  QCheckBox* for_brush_;
  QLabel* within_title_;
  QComboBox* within_;
  QPushButton* take_;
  QComboBox* how_;
  QComboBox* other_;
  QPushButton* combine_;
};

}  // namespace glisson::widgets

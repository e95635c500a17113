#pragma once
// The row above the views: measuring, grey values, turned slices and layouts, each by button, menu and key.

#include <QActionGroup>
#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QToolButton>
#include <QWidget>

#include "widgets/session/patient.h"
#include "widgets/views/measure_tool.h"

namespace glisson::widgets {

class ViewBar : public QWidget {
  Q_OBJECT

 public:
  ViewBar(LinkedViews& views, MeasureTool& measure, QWidget* parent = nullptr);

  // Its structures' volumes can be listed.
  void show_patient(const Patient& patient);
  // All of the row as a menu, which also tells the keys.
  void fill(QMenu& menu);

  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QAction* add_action(const char* name, const char* icon, const QKeySequence& key, std::function<void()> act);
  QToolButton* add_button(QAction* action, const char* name);
  void list_volumes();
  void tell_window();
  void fit();
  [[nodiscard]] int width_without(std::size_t dispensable) const;

  LinkedViews& views_;
  MeasureTool& measure_;
  std::vector<QAction*> measuring_;  // in the order of MeasureKind
  std::vector<QAction*> layouts_;    // in the order of ViewLayout
  QAction* surgeon_;
  QAction* straight_;
  QAction* next_window_;
  QAction* save_;
  QMenu* volumes_;
  QLabel* window_name_;
  QComboBox* window_;
  QLabel* window_text_;  // width and level
  // Where the row is too narrow for all, the first of these go first, into the menu of `more_`.
  std::vector<QWidget*> dispensable_;
  QToolButton* more_;
  std::vector<PatientStructure> structures_;
};

}  // namespace glisson::widgets

#pragma once
// What was measured, a row each: choose one and the crosshair goes there; Delete takes it away. Hidden while there is
// nothing.

#include <QTableWidget>

#include "widgets/views/measure_tool.h"

namespace glisson::widgets {

class MeasureList : public QTableWidget {
  Q_OBJECT

 public:
  MeasureList(MeasureTool& tool, LinkedViews& views, QWidget* parent = nullptr);

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void show_all();

  MeasureTool& tool_;
};

}  // namespace glisson::widgets

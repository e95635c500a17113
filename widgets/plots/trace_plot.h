#pragma once
// A recording of power over time: the curve, the runs found in it as bands, idle power as a line.

#include <optional>
#include <QWidget>

#include "hardware/power_trace.h"

class QCustomPlot;
class QCPGraph;

namespace glisson::widgets {

class TracePlot : public QWidget {
  Q_OBJECT

 public:
  explicit TracePlot(QWidget* parent = nullptr);

  // Of a long recording the minimum and the maximum of the power in each of some thousand spans are drawn. Runs: none
  // where no level could be told from another.
  void show_trace(const hardware::PowerTrace& trace, const std::optional<hardware::TraceRuns>& runs);

 private:
  QCustomPlot* plot_;
  QCPGraph* power_;
  QCPGraph* idle_;
};

}  // namespace glisson::widgets

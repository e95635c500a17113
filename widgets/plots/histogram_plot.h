#pragma once
// How often values occur, as bars over a named axis.

#include <QString>
#include <QWidget>
#include <vector>

class QCustomPlot;

namespace glisson::widgets {

class HistogramPlot : public QWidget {
  Q_OBJECT

 public:
  explicit HistogramPlot(QWidget* parent = nullptr);

  // Bars of equal width between the smallest and the largest value.
  void show_values(const std::vector<double>& values, const QString& value_name);

 private:
  QCustomPlot* plot_;
};

}  // namespace glisson::widgets

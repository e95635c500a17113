#pragma once
// Measured strain and stress as points, and a straight line through the origin.

#include <QWidget>
#include <vector>

#include "mechanics/materials/material_data.h"

class QCustomPlot;

namespace glisson::widgets {

class StressStrainPlot : public QWidget {
  Q_OBJECT

 public:
  explicit StressStrainPlot(QWidget* parent = nullptr);

  // The line has the slope.
  void show_measurements(const std::vector<mechanics::StressStrain>& measured, double slope_kPa);

 private:
  QCustomPlot* plot_;
};

}  // namespace glisson::widgets

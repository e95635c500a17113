#pragma once
// One platform over liver volume and resolution, as figures 6.7 and 6.9 draw it: colours, contours, hot spots, and a
// cross where the case stands.

#include <QWidget>

#include "hardware/grid.h"

class QCustomPlot;
class QCPColorMap;
class QCPColorScale;

namespace glisson::widgets {

struct Contour {
  double level = 0;
  QString label;
  bool wanted = false;  // drawn thick: this is what the case asks for
};

struct ContourPicture {
  hardware::GridSurface surface;  // resolutions in equal ratios
  std::vector<Contour> contours;
  std::vector<hardware::HotSpot> hot_spots;
  double case_volume_cm3 = 0;
  double case_resolution_mm3 = 0;
  // What resolutions mean: ticks on the right, by increasing resolution.
  struct Accuracy {
    double resolution_mm3;
    double error_mm;
  };
  std::vector<Accuracy> accuracies;
};

class ContourPlot : public QWidget {
  Q_OBJECT

 public:
  explicit ContourPlot(QWidget* parent = nullptr);
  void show_picture(const ContourPicture& picture);
  [[nodiscard]] const ContourPicture& picture() const { return picture_; }

 private:
  void draw_contour(const Contour& contour, double label_at);  // a share of its length
  void draw_case();

  ContourPicture picture_;
  QCustomPlot* plot_;
  QCPColorMap* map_;
  QCPColorScale* scale_;
};

}  // namespace glisson::widgets

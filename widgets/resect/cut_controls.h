#pragma once
// The controls of a cut. It is a plane by its place and two angles, or points that a smooth surface passes through. The
// points are set one by one, or lie under a line drawn freehand.

#include <optional>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QWidget>

#include "widgets/resect/cut_plane.h"
#include "widgets/words/number_box.h"

namespace glisson::widgets {

class CutControls : public QWidget {
  Q_OBJECT

 public:
  enum Kind { plane_cut, sheet_cut };

  explicit CutControls(QWidget* parent = nullptr);

  [[nodiscard]] Kind kind() const { return static_cast<Kind>(kind_->currentIndex()); }
  void choose(Kind kind);
  // The person sets places by clicks: three for a plane, or those of a sheet.
  [[nodiscard]] bool by_clicks() const { return by_clicks_->isChecked(); }
  [[nodiscard]] bool drawing() const { return by_clicks_->isChecked() || draw_->isChecked() || freehand(); }
  // The person draws a line over the liver.
  [[nodiscard]] bool freehand() const { return freehand_->isChecked(); }
  void stop_drawing();
  void show_plane(const std::optional<CutPlane>& plane);
  void show_points(std::size_t count);

 Q_SIGNALS:
  void kind_chosen();
  void through_crosshair(const Eigen::Vector3d& normal);
  void drawing_changed(bool drawing);
  void plane_typed(double shift_mm, double turn_deg, double tilt_deg);
  void last_dropped();
  void cleared();

 private:
  enum Across { across_left, across_front, across_head };

  QWidget* make_plane();
  QWidget* make_sheet();
  void update_points_text();

  QComboBox* kind_;
  QStackedWidget* kinds_;
  QComboBox* across_;
  QPushButton* through_crosshair_;
  QPushButton* by_clicks_;
  NumberBox* shift_;
  NumberBox* turn_;
  NumberBox* tilt_;
  QPushButton* draw_;
  QPushButton* freehand_;
  QPushButton* drop_last_;
  QPushButton* clear_;
  QLabel* points_text_;
  std::size_t points_ = 0;
};

}  // namespace glisson::widgets

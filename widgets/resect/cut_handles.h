#pragma once
// What a hand takes hold of in the four views while a cut is planned. In each slice a drag of the plane's line shifts
// it, and a drag of the ball at each end tilts it. In space there is a ball on the plane, and one on its normal's tip.
// The points of a sheet are set by clicks and dragged, or set by a line drawn freehand in space. Places that somebody
// told of the anatomy are marked and dragged too, and Delete takes the one that was clicked on away. Anything else in
// the views stays as it is.

#include <optional>
#include <QObject>
#include <vector>

#include "planning/freehand.h"
#include "widgets/resect/cut_plane.h"
#include "widgets/views/linked_views.h"

class QKeyEvent;
class QMouseEvent;

namespace glisson::widgets {

// Where somebody told by hand what runs there: "V-VIII", "Right hepatic vein".
struct ToldPlace {
  std::string label;
  Eigen::Vector3d position_mm{0, 0, 0};
  scene::Colour colour;
};

class CutHandles : public QObject {
  Q_OBJECT

 public:
  explicit CutHandles(LinkedViews& views, QObject* parent = nullptr);

  // Off: the views are as if this were not there.
  void set_active(bool active);
  void set_plane(const std::optional<CutPlane>& plane);
  void set_points(const std::vector<Eigen::Vector3d>& points_mm);
  // On: a click in a slice is told by point_clicked().
  void set_drawing(bool drawing);
  // Places in their order; one that is being dragged is let go.
  void set_places(const std::vector<ToldPlace>& places);
  // On: the left button draws a line in space, told by line_drawn() when it is let go.
  void set_freehand(bool freehand);
  // In the slices, where they are now.
  void draw_in_slices();
  // In space: marks and arrows for the workspace's scene.
  [[nodiscard]] std::vector<scene::LandmarkItem> marks_in_space() const;
  [[nodiscard]] std::vector<scene::ArrowItem> arrows_in_space() const;

  bool eventFilter(QObject* watched, QEvent* event) override;

 Q_SIGNALS:
  void plane_moved(const glisson::widgets::CutPlane& plane);
  void point_clicked(const Eigen::Vector3d& position_mm);
  void point_moved(std::size_t point, const Eigen::Vector3d& position_mm);
  void let_go();                                                             // what was dragged
  void place_dragged();                                                      // it is drawn elsewhere
  void place_let_go(std::size_t place, const Eigen::Vector3d& position_mm);  // after a drag
  void place_given_up(std::size_t place);                                    // by Delete
  void line_drawn(const std::vector<glisson::planning::SightLine>& line);

 private:
  enum class Part { none, line, near_end, far_end, middle, tip, point, place };
  struct Fixed {
    Part part = Part::none;
    std::size_t point = 0;              // or place
    Eigen::Vector3d from_mm{0, 0, 0};   // where the hand was last
    Eigen::Vector3d pivot_mm{0, 0, 0};  // about which a line's end turns
  };

  bool key_event(const QKeyEvent& event);
  bool slice_event(SliceView& slice, QMouseEvent& event);
  bool space_event(QMouseEvent& event);
  bool freehand_event(QMouseEvent& event);
  void draw_line_in_space();
  [[nodiscard]] Fixed under(const SliceView& slice, const QPointF& pixel) const;
  [[nodiscard]] Fixed under_in_space(const QPointF& pixel) const;
  void drag_in_slice(const SliceView& slice, const Eigen::Vector3d& to_mm);
  void drag_in_space(const Eigen::Vector3d& to_mm);
  void take_hold(const Fixed& held);
  void drag_place(const Eigen::Vector3d& to_mm);
  void end_drag();
  [[nodiscard]] LineInSlice line_in(const SliceView& slice) const;
  [[nodiscard]] Eigen::Vector3d tip_mm() const;

  LinkedViews& views_;
  bool active_ = false;
  bool drawing_ = false;
  bool freehand_ = false;
  bool line_begun_ = false;
  std::vector<planning::SightLine> line_;
  std::vector<Eigen::Vector3d> line_mm_;  // on the liver, as it is drawn
  std::optional<CutPlane> plane_;
  std::vector<Eigen::Vector3d> points_mm_;
  std::vector<ToldPlace> places_;
  std::optional<std::size_t> chosen_place_;
  bool place_moved_ = false;  // since it is held
  Fixed held_;
};

}  // namespace glisson::widgets

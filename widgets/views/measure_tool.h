#pragma once
// Measuring in the four views: a kind is chosen, its points are set by clicks (or Enter: at the crosshair), and it
// joins the list. Points are dragged in the slices. Escape gives up. As long as no kind is chosen and no point is under
// the mouse, the views are as if this were not there.

#include <optional>
#include <QObject>
#include <vector>

#include "widgets/views/linked_views.h"
#include "widgets/views/measurement.h"

class QKeyEvent;
class QMouseEvent;

namespace glisson::widgets {

class MeasureTool : public QObject {
  Q_OBJECT

 public:
  explicit MeasureTool(LinkedViews& views, QObject* parent = nullptr);

  void begin(std::optional<MeasureKind> kind);
  [[nodiscard]] std::optional<MeasureKind> kind() const { return kind_; }

  [[nodiscard]] const std::vector<Measurement>& measurements() const { return measurements_; }
  void add(Measurement measurement);
  void remove(std::size_t measurement);
  void clear();

  bool eventFilter(QObject* watched, QEvent* event) override;

 Q_SIGNALS:
  void kind_changed();
  void changed();

 private:
  struct Fixed {
    std::size_t measurement;
    std::size_t point;
  };

  bool slice_event(SliceView& slice, QMouseEvent& event);
  bool space_event(SpaceView& space, QMouseEvent& event);
  bool key_event(QKeyEvent& event);
  void set_point(const Eigen::Vector3d& position_mm);
  // The last point follows the mouse until it is set.
  void preview(const Eigen::Vector3d& position_mm);
  [[nodiscard]] std::optional<Fixed> under(const SliceView& slice, const QPointF& position) const;
  void draw();

  LinkedViews& views_;
  std::optional<MeasureKind> kind_;
  std::vector<Eigen::Vector3d> set_mm_;  // of the one that is being made
  std::optional<Eigen::Vector3d> next_mm_;
  std::vector<Measurement> measurements_;
  std::optional<Fixed> held_;
  QPointF pressed_at_;
};

}  // namespace glisson::widgets

#pragma once
// The tools that draw in the slices: left button to use one, Ctrl and left for its opposite, Shift and wheel for the
// brush's radius. Whatever a tool has no use for goes on to the slice: crosshair, zoom, brightness.

#include <QObject>
#include <QPointF>
#include <vector>

#include "segmentation/edit.h"
#include "segmentation/taken_off.h"
#include "widgets/segment/slice_overlay.h"

namespace glisson::widgets {

enum class Tool { none, brush, eraser, smart_brush, scissors, seeds, piece };

struct ToolOptions {
  enum class Shape { disc, ball };
  // Of the scissors; along the line of sight.
  enum class Depth { this_slice, all_slices, both_sides, towards_viewer, away_from_viewer };
  double radius_mm = 6;
  Shape shape = Shape::disc;
  std::optional<segmentation::GreyRange> only = {};  // of brush and eraser: nothing else is changed
  double likeness = 2.5;                             // spreads around the grey value under the click
  segmentation::CutSide cut = segmentation::CutSide::inside;
  Depth depth = Depth::all_slices;
  double depth_mm = 10;  // of both_sides: so far to each
};

inline constexpr double minimum_radius_mm = 0.5, maximum_radius_mm = 60;

class SliceTools : public QObject {
  Q_OBJECT

 public:
  SliceTools(LinkedViews& views, StructureEditor& editor, SliceOverlay& overlay, QObject* parent = nullptr);

  void set_tool(Tool tool);
  [[nodiscard]] Tool tool() const { return tool_; }
  [[nodiscard]] ToolOptions& options() { return options_; }
  // Clicks inside, by Ctrl outside; a click on one takes it away.
  [[nodiscard]] const segmentation::GivenPoints& points() const { return points_; }
  void clear_points();

 Q_SIGNALS:
  void radius_changed(double radius_mm);  // by the wheel
  void points_changed();
  void refused(const QString& why);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool press(SliceView* view, const QPointF& at, bool opposite);
  void drag(SliceView* view, const QPointF& at);
  void release(SliceView* view);
  void dab(SliceView* view, const Eigen::Vector3d& to_mm);
  void cut(SliceView* view);
  [[nodiscard]] segmentation::Outline outline_in(const SliceView& view) const;
  void sketch(SliceView* view, const QPointF& at);
  void click(const SliceView& view, const Eigen::Vector3d& place_mm, bool outside);
  [[nodiscard]] bool is_brush() const;

  LinkedViews& views_;
  StructureEditor& editor_;
  SliceOverlay& overlay_;
  Tool tool_ = Tool::none;
  ToolOptions options_;
  SliceView* drawing_in_ = nullptr;
  segmentation::Paint paint_ = segmentation::Paint::add;
  std::optional<segmentation::GreyRange> only_;
  Eigen::Vector3d last_mm_{0, 0, 0};
  std::vector<Eigen::Vector3d> outline_mm_;
  segmentation::GivenPoints points_;
};

}  // namespace glisson::widgets

#pragma once
// The structures in the slices while they are drawn: each one's outline, filled faintly, and what a tool sketches.
// Only what changed is made anew: the layers that a stroke touched, in the views that show them.

#include <array>
#include <vector>

#include "widgets/segment/structure_editor.h"
#include "widgets/views/linked_views.h"

namespace glisson::widgets {

// Pairs of ends of lines along a circle.
void add_circle(std::vector<Eigen::Vector3d>& ends_mm, const Eigen::Vector3d& center_mm, const Eigen::Vector3d& normal,
                double radius_mm);

class SliceOverlay : public QObject {
  Q_OBJECT

 public:
  SliceOverlay(LinkedViews& views, const StructureEditor& editor, QObject* parent = nullptr);

  void set_on(bool on);
  void refresh();
  // Lines of a tool over one view, or none.
  void set_sketch(SliceView* view, std::vector<scene::DrawnLines> lines);
  // Balls around places (patient LPS, mm), as rings where a slice goes through them.
  void set_rings(std::vector<Eigen::Vector3d> places_mm);
  // The layer of the image that a view shows; absent where it is turned and shows none.
  struct Layer {
    int axis = 2;
    int index = 0;
  };
  [[nodiscard]] std::optional<Layer> layer_of(const SliceView& view, const imaging::Grid& grid) const;

 private:
  struct Shown {
    SliceView* view = nullptr;
    std::optional<Layer> layer;
    // Where the slice is tilted against the image: its plane as a grid of one layer, and the structures on that.
    std::optional<imaging::Grid> tilted;
    std::vector<std::optional<imaging::Mask>> sampled;
    scene::DrawnCells cells;
    std::vector<scene::DrawnLines> outlines;  // one a structure
    std::vector<scene::DrawnLines> sketch;
  };
  void refresh(Shown& shown);
  void refresh_part(int structure, const segmentation::IndexBox& box);
  void refresh_tilted(Shown& shown);
  void sample(Shown& shown, std::size_t structure);
  void colour_tilted_cells(Shown& shown);
  void colour_cells(Shown& shown, const segmentation::IndexBox& box);
  void outline(Shown& shown, std::size_t structure);
  void hand_over(const Shown& shown);

  LinkedViews& views_;
  const StructureEditor& editor_;
  std::array<Shown, 3> shown_;
  std::vector<Eigen::Vector3d> rings_mm_;
  bool on_ = false;
};

}  // namespace glisson::widgets

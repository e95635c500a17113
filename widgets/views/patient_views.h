#pragma once
// A patient in the four views, moving with the rehearsal. A person chooses which of the two bodies is shown, with the
// patient's own stiffness, the atlas, or both in red and blue. The tool and the landmarks are shown with it.

#include <map>
#include <QObject>
#include <QTimer>
#include <set>
#include <string>

#include "rehearsal/static_rehearsal.h"
#include "widgets/session/patient.h"
#include "widgets/views/linked_views.h"
#include "widgets/views/tool_in_view.h"
#include "widgets/views/vessel_tubes.h"

namespace glisson::widgets {

enum class Bodies { patient, reference, both, side_by_side };
enum class LiverColour { tissue, displacement };
enum class SliceImage { anatomy, stiffness };

// What a workspace shows in the views besides the patient, or in its place, as long as it is at work.
struct WorkspaceScene {
  enum class Patient { as_rehearsed, at_rest, at_rest_in_slices_only, hidden };
  Patient patient = Patient::as_rehearsed;
  std::vector<scene::SurfaceItem> surfaces;  // in space
  std::vector<scene::LandmarkItem> marks;    // in space
  std::vector<scene::ArrowItem> arrows;      // in space
  std::vector<scene::CutLine> cuts;          // in the slices
  std::vector<scene::KeyEntry> key;          // of the view in space
};

class PatientViews : public QObject {
  Q_OBJECT

 public:
  explicit PatientViews(LinkedViews& views, QObject* parent = nullptr);
  ~PatientViews() override;

  void show_patient(const Patient& patient);
  // At rest without a state. Tools are drawn where the tissue under them is now; the last one is in hand.
  void show_state(const rehearsal::RehearsalState* state, const std::vector<ToolInView>& tools);
  // Whether the tool in hand can be dragged by its arrow.
  void set_tool_movable(bool movable);

  struct PlaceOnLiver {
    Eigen::Vector3d at_rest_mm{0, 0, 0};
    Eigen::Vector3d outward{0, -1, 0};                             // unit, at rest
    Eigen::Matrix3d turned_to_rest = Eigen::Matrix3d::Identity();  // a way of the tissue as it lies now
  };
  // What was picked, where it is at rest; nothing where it is not the liver, or a wall of its cut.
  [[nodiscard]] std::optional<PlaceOnLiver> place_on_liver(const scene::View::Pick& pick) const;
  [[nodiscard]] bool on_wall(const scene::View::Pick& pick) const;
  // The place of the liver's surface that is nearest to a position; nothing without a liver.
  [[nodiscard]] std::optional<PlaceOnLiver> nearest_on_liver(const Eigen::Vector3d& position_mm) const;

  void set_bodies(Bodies bodies);
  void set_liver_colour(LiverColour colour);
  void set_slice_image(SliceImage image);
  void set_structure_shown(const std::string& name, bool shown);
  // Its name is written beside it.
  void set_marked_landmark(const std::string& id);
  // The words in the pictures, in the language of now.
  void reword();
  // Nothing: the patient alone, as rehearsed.
  void set_workspace_scene(std::optional<WorkspaceScene> scene);
  [[nodiscard]] const VesselTubes& vessel_tubes() const { return vessel_tubes_; }

 Q_SIGNALS:
  // What somebody changed straight in those views (View::move_surface, set_landmarks) is gone.
  void slices_rebuilt();
  void space_rebuilt();

 private:
  // One body's surfaces, which move; the structures' order.
  using Body = std::vector<std::shared_ptr<const geometry::Surface>>;

  // What is drawn of the vessels that were found thin, in the places of the bodies.
  void take_tubes();
  void move_tubes(const Body& tubes, const rehearsal::RehearsalBody* displaced);
  void rebuild_space();
  [[nodiscard]] scene::Scene space_scene(Bodies bodies) const;
  void draw_marks(SpaceView& space, const rehearsal::RehearsalBody* shown);
  void rebuild_slices();
  void apply_state();
  // Of an answer that is not to be used no length is told: neither beside a landmark nor by a colour bar.
  [[nodiscard]] bool has_figures() const { return !state_ || state_->validity.usable(); }
  void keep_window_now();
  void move_body(const Body& body, const rehearsal::RehearsalBody* displaced);
  [[nodiscard]] scene::SurfaceItem item(std::size_t structure, const Body& body, Bodies bodies) const;
  [[nodiscard]] bool at_rest() const;
  // What is drawn in the place of the liver while a cut opens it: its outside and the cut's walls. Made anew where the
  // cut has advanced, moved otherwise.
  void draw_cut(const rehearsal::SessionCut* cut);
  [[nodiscard]] bool cuts(Bodies body) const { return bodies_ == body || has_both(); }
  [[nodiscard]] bool has_both() const { return bodies_ == Bodies::both || bodies_ == Bodies::side_by_side; }

  LinkedViews& views_;
  Patient patient_;
  Body patient_body_;
  Body reference_body_;
  std::vector<std::shared_ptr<const geometry::Surface>> cut_body_;  // empty: nothing is cut
  std::vector<std::size_t> crossed_;                                // structures that the cut has reached
  std::optional<rehearsal::RehearsalState> state_;
  std::vector<ToolInView> tools_;
  bool tool_movable_ = false;
  Bodies bodies_ = Bodies::patient;
  LiverColour liver_colour_ = LiverColour::tissue;
  SliceImage slice_image_ = SliceImage::anatomy;
  std::optional<SliceImage> in_slices_;       // what they show now
  std::map<SliceImage, GreyWindow> windows_;  // of what they have shown of this patient
  GreyWindow chosen_window_;                  // of the anatomy, by a person; kept when the timer ends
  QTimer keep_window_;
  std::optional<WorkspaceScene> workspace_;
  std::set<std::string> hidden_;
  std::string marked_landmark_;
  double colour_range_mm_ = 20;
  VesselTubes vessel_tubes_;
  Body patient_tubes_, reference_tubes_;                   // null where a structure has none
  std::vector<Eigen::Vector3d> cut_rest_mm_, cut_now_mm_;  // of the cut body's outside
};

}  // namespace glisson::widgets

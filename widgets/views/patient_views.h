#pragma once
// A patient in the four views, moving with the rehearsal: which of the two bodies is shown (with the patient's own
// stiffness, the atlas, or both in red and blue), the tool, and the landmarks.

#include <QObject>
#include <set>
#include <string>

#include "rehearsal/static_rehearsal.h"
#include "session/patient.h"
#include "views/linked_views.h"

namespace glisson::widgets {

enum class Bodies { patient, atlas, both };
enum class LiverColour { tissue, displacement };
enum class SliceImage { anatomy, stiffness };

struct ToolInView {
  Eigen::Vector3d center_mm{0, 0, 0};
  Eigen::Vector3d direction{0, -1, 0};
  double force_N = 0;
};

// What a workspace shows in the views besides the patient, or in its place, as long as it is at work.
struct WorkspaceScene {
  enum class Patient { as_rehearsed, at_rest, at_rest_in_slices_only };
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

  void show_patient(const Patient& patient);
  // At rest without a frame. The tool is drawn where the tissue under it is now.
  void show_frame(const rehearsal::RehearsalFrame* frame, const ToolInView* tool);

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

 Q_SIGNALS:
  // What somebody put straight into the slice views (View::set_landmarks) is gone.
  void slices_rebuilt();

 private:
  // One body's surfaces, which move; the structures' order.
  using Body = std::vector<std::shared_ptr<const geometry::Surface>>;

  void rebuild_space();
  void rebuild_slices();
  void apply_frame();
  void move_body(const Body& body, const rehearsal::RehearsalBody* displaced);
  [[nodiscard]] scene::SurfaceItem item(std::size_t structure, const Body& body) const;
  [[nodiscard]] bool at_rest() const;
  [[nodiscard]] bool shows(Bodies body) const { return bodies_ == Bodies::both || bodies_ == body; }

  LinkedViews& views_;
  Patient patient_;
  Body patient_body_;
  Body atlas_body_;
  std::optional<rehearsal::RehearsalFrame> frame_;
  std::optional<ToolInView> tool_;
  Bodies bodies_ = Bodies::patient;
  LiverColour liver_colour_ = LiverColour::tissue;
  SliceImage slice_image_ = SliceImage::anatomy;
  std::optional<WorkspaceScene> workspace_;
  std::set<std::string> hidden_;
  std::string marked_landmark_;
  double colour_range_mm_ = 20;
};

}  // namespace glisson::widgets

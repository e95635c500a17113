#pragma once
// The Guide workspace: the open case's liver on a laparoscope's frames, found or laid there by hand. It has outlines of
// the liver and of what lies inside it, and says how far each may be off.

#include <filesystem>
#include <functional>
#include <memory>
#include <QHBoxLayout>
#include <QLabel>
#include <QStackedWidget>
#include <QTimer>
#include <QWidget>

#include "casefile/marked_lines.h"
#include "widgets/guide/guide_panel.h"
#include "widgets/guide/guide_welcome.h"
#include "widgets/guide/guided_video.h"
#include "widgets/guide/overlay_view.h"
#include "widgets/panels/frame_images.h"
#include "widgets/panels/timeline.h"
#include "widgets/sequence/from_video.h"
#include "widgets/views/space_view.h"
#include "widgets/workspaces/workspace.h"

namespace glisson::widgets {

class GuidePage : public QWidget {
  Q_OBJECT

 public:
  explicit GuidePage(WorkspaceContext context, QWidget* parent = nullptr);
  [[nodiscard]] static Workspace workspace(WorkspaceContext context);

  void show_patient(const Patient& patient);
  // A sequence.json. On a worker thread, as everything here that takes time. `then_said` stands beside it then.
  void open(const std::filesystem::path& file, const std::function<QString()>& then_said = {});
  // The simulated sequence of the demo patient, made the first time.
  void open_example();
  // In all frames, without a guess but by the lines that are marked; or from where it was laid by hand.
  void place() { run(std::nullopt, answers_.size()); }
  // The first frames alone, for who only looks round.
  void place_some() { run(std::nullopt, 4); }
  void refine();
  // All frames as they are shown now.
  void film(const std::filesystem::path& file);

  [[nodiscard]] bool has_video() const { return video_ != nullptr; }
  // Null where it is not answered yet.
  [[nodiscard]] const GuidedFrame* answered(std::size_t frame) const;
  [[nodiscard]] const std::optional<HandPose>& hand_pose() const { return hand_; }
  [[nodiscard]] const casefile::MarkedLines& lines() const { return lines_; }

 Q_SIGNALS:
  void opened();
  void placed();
  void filmed();

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QWidget* make_pictures();
  void connect_work();
  void connect_parts();
  void connect_hand();
  void connect_lines();

  void choose_video();
  void choose_file();
  void choose_film();
  enum class Task { none, opening, placing, filming };
  void start(Task task, const QString& title, BackgroundWork::Work work);
  void take(std::shared_ptr<const GuidedVideo> video);
  void run(const std::optional<HandPose>& from, std::size_t frames);
  void take_frame(std::size_t frame, std::shared_ptr<const GuidedFrame> answer);
  void close_video();

  void set_by_hand(bool by_hand);
  void move_by_hand(const Eigen::Isometry3d& pose);
  void keep_hand_pose();
  void read_kept_pose();
  void take_kept_pose(const QJsonValue& kept);
  [[nodiscard]] Eigen::Vector3d middle_mm() const;  // of the liver at rest

  void set_marking(bool on);
  void mark_on_frame(const QPointF& at_px);
  void mark_on_model(const scene::View::Pick& pick);
  void change_lines(const std::function<void(casefile::MarkedLines&)>& change);
  void read_kept_lines();
  void take_kept_lines(const QJsonValue& kept);
  void show_marks();

  void show_frame();
  void show_overlay();
  void show_in_space();
  void update_text();
  [[nodiscard]] OverlayPicture picture_of(const std::vector<guidance::PlacedOutline>& outlines) const;
  [[nodiscard]] QString label_of(const guidance::PlacedOutline& outline) const;
  [[nodiscard]] QString remark() const;   // over the frame
  [[nodiscard]] QString reading() const;  // what to conclude of this frame
  [[nodiscard]] std::size_t frame() const { return static_cast<std::size_t>(timeline_->frame()); }
  // The words are asked for again when the language changes.
  void say(std::function<QString()> words);
  void say_error(const Error& error);

  WorkspaceContext context_;
  Task task_ = Task::none;
  std::filesystem::path case_folder_;
  std::shared_ptr<const GuidedVideo> video_;
  std::shared_ptr<const guidance::ForceModes> modes_;
  std::vector<std::shared_ptr<const GuidedFrame>> answers_;  // one a frame; null: not answered yet
  bool follows_answers_ = false;                             // until somebody moves the timeline
  std::optional<HandPose> hand_;
  QJsonValue kept_ = QJsonValue::Null;  // of the hand's pose, in the case
  std::vector<guidance::PlacedOutline> hand_outlines_;
  QTimer hand_due_;
  casefile::MarkedLines lines_;  // of this sequence
  QJsonValue kept_lines_ = QJsonValue::Null;
  scene::SurfaceId liver_in_space_;
  std::function<QString()> said_;
  FrameImages images_;
  QSize size_px_;
  bool looked_in_space_ = false;

  QStackedWidget* pages_;
  GuideWelcome* welcome_;
  FromVideo* from_video_;
  QLabel* file_;
  QLabel* origin_;
  QLabel* reading_;
  QHBoxLayout* pictures_;
  OverlayView* view_;
  SpaceView* space_;
  Timeline* timeline_;
  GuidePanel* panel_;
};

}  // namespace glisson::widgets

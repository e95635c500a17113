#pragma once
// The Register workspace: a stereo video's sequence, registered by one or two algorithms and judged by SIRGn. The video
// with its heat mesh, one algorithm beside the other on one colour scale, a timeline, the tolerance, the figures, and
// any place's history.

#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <QLabel>
#include <QStackedWidget>
#include <QWidget>

#include "widgets/panels/frame_images.h"
#include "widgets/panels/timeline.h"
#include "widgets/register/algorithm_choice.h"
#include "widgets/register/heat_legend.h"
#include "widgets/register/heat_video.h"
#include "widgets/register/judged_sequence.h"
#include "widgets/register/reading_panel.h"
#include "widgets/register/register_welcome.h"
#include "widgets/register/triangle_history.h"
#include "widgets/sequence/from_video.h"
#include "widgets/work/background_work.h"
#include "widgets/workspaces/workspace.h"

namespace glisson::widgets {

class RegisterPage : public QWidget {
  Q_OBJECT

 public:
  explicit RegisterPage(BackgroundWork& work, QWidget* parent = nullptr);
  [[nodiscard]] static Workspace workspace(const WorkspaceContext& context);

  // A sequence.json. On a worker thread, as everything here that takes time.
  // `then_said` stands beside it then.
  void open(const std::filesystem::path& file, const std::function<QString()>& then_said = {});
  // The simulated sequence in `folder`, made there unless it is there already.
  void open_example();
  // Registers by the chosen algorithms what is not registered yet, and judges it.
  void compute();

  [[nodiscard]] bool has_sequence() const { return sequence_ != nullptr; }
  // What a side shows; null where nothing was computed for it.
  [[nodiscard]] const Judged* judged(int side) const;
  [[nodiscard]] double tolerance_mm() const { return reading_->tolerance_mm(); }
  [[nodiscard]] const std::array<std::optional<std::size_t>, 2>& chosen() const { return chosen_; }

 Q_SIGNALS:
  void opened();
  void computed();

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QWidget* make_review();
  QWidget* make_pictures();
  void connect_work();
  void connect_parts();

  void choose_video() { pages_->setCurrentWidget(from_video_); }
  void choose_file();
  void start(const QString& title, BackgroundWork::Work work);
  void take(std::shared_ptr<const OpenedSequence> sequence);
  [[nodiscard]] QString side_name(int side) const;

  void show_frame();
  void show_meshes();
  void show_figures();
  void show_history();
  void say_of_place();
  void choose_at(const QPointF& pixel);
  void choose_triangle(std::optional<std::size_t> triangle);
  void choose(std::optional<std::size_t> first, std::optional<std::size_t> second);
  void choose_none() { choose(std::nullopt, std::nullopt); }
  void update_text();
  void update_view_text();
  [[nodiscard]] QString hint(int side, std::size_t triangle) const;
  // The words are asked for again when the language changes.
  void say(std::function<QString()> words);

  BackgroundWork& work_;
  bool working_ = false;  // for this page
  std::shared_ptr<const OpenedSequence> sequence_;
  std::map<registration_quality::SequenceMethod, std::shared_ptr<const Judged>> judged_;
  std::array<std::optional<std::size_t>, 2> chosen_;
  std::function<QString()> said_;
  FrameImages images_;
  QSize size_px_;

  QStackedWidget* pages_;
  RegisterWelcome* welcome_;
  FromVideo* from_video_;
  QLabel* file_;
  QLabel* origin_;
  QLabel* reading_text_;  // what to conclude
  std::array<HeatVideo*, 2> videos_{};
  HeatLegend* legend_;
  Timeline* timeline_;
  TriangleHistory* history_;
  QLabel* notes_;
  AlgorithmChoice* algorithms_;
  ReadingPanel* reading_;
};

}  // namespace glisson::widgets

#include "widgets/guide/guide_page.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QPointer>
#include <QVBoxLayout>

#include "studies/review/example_sequence.h"
#include "widgets/guide/guide_film.h"
#include "widgets/panels/ask_path.h"
#include "widgets/panels/parts.h"
#include "widgets/settings/settings.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/paths.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {

namespace fs = std::filesystem;

namespace {

constexpr const char* proposed_film = "guidance.mp4";
constexpr double film_frames_per_second = 15;  // as the timeline plays

}  // namespace

GuidePage::GuidePage(WorkspaceContext context, QWidget* parent) : QWidget(parent), context_(std::move(context)) {
  setObjectName("guide_page");
  setFocusPolicy(Qt::StrongFocus);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  pages_ = new QStackedWidget;
  welcome_ = new GuideWelcome;
  welcome_->setObjectName("guide_welcome");
  welcome_->show_missing(model_missing({}));
  pages_->addWidget(welcome_);
  auto* review = new QWidget;
  auto* across = new QHBoxLayout(review);
  across->setContentsMargins(0, 0, 0, 0);
  across->setSpacing(0);
  across->addWidget(make_pictures(), 1);
  panel_ = new GuidePanel;
  QScrollArea* scroll = scrolled(panel_);
  scroll->setFixedWidth(340);
  across->addWidget(scroll);
  pages_->addWidget(review);
  from_video_ = new FromVideo(context_.work);
  pages_->addWidget(from_video_);
  column->addWidget(pages_);
  hand_due_.setSingleShot(true);
  hand_due_.setInterval(0);
  connect_work();
  connect_parts();
  connect_hand();
  connect_lines();
  keep_translated(this, [this] {
    show_overlay();
    update_text();
  });
}

Workspace GuidePage::workspace(WorkspaceContext context) {
  auto* page = new GuidePage(std::move(context));
  return {
      .id = "guide",
      .name = [] { return tr("Guide"); },
      .about =
          [] { return tr("See on a laparoscope's frames where tumours and vessels lie, and how far to trust it."); },
      .widget = page,
      .place = Workspace::Place::whole_window,
      .show_patient = [page](const Patient& patient) { page->show_patient(patient); },
      .missing = model_missing};
}

QWidget* GuidePage::make_pictures() {
  auto* pictures = new QWidget;
  auto* column = new QVBoxLayout(pictures);
  column->setContentsMargins(14, 12, 14, 12);
  column->setSpacing(8);
  auto* head = new QHBoxLayout;
  file_ = new QLabel;
  file_->setObjectName("patient_name");
  auto* open = named_button("open_another_video");
  auto* video = named_button("another_from_video");
  head->addWidget(file_, 1);
  head->addWidget(video);
  head->addWidget(open);
  column->addLayout(head);
  origin_ = wrapped_label("origin");
  column->addWidget(origin_);
  reading_ = wrapped_label("guide_reading");
  column->addWidget(reading_);
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  view_ = new OverlayView;
  view_->setObjectName("guide_frame");
  space_ = new SpaceView;
  space_->setObjectName("guide_space");
  space_->setMinimumSize(220, 200);
  pictures_ = row;
  row->addWidget(view_, 5);
  row->addWidget(space_, 2);
  column->addLayout(row, 1);
  timeline_ = new Timeline;
  timeline_->setObjectName("guide_timeline");
  column->addWidget(timeline_);
  connect(open, &QPushButton::clicked, this, &GuidePage::choose_file);
  connect(video, &QPushButton::clicked, this, &GuidePage::choose_video);
  keep_translated(pictures, [this, open, video] {
    video->setText(tr("From a video..."));
    video->setToolTip(tr("Two videos, or one that shows both eyes, become a sequence"));
    space_->setAccessibleName(tr("The liver in space, with what was seen of it"));
    open->setText(tr("Open another..."));
    open->setToolTip(tr("Another sequence.json in place of this one"));
  });
  return pictures;
}

void GuidePage::connect_parts() {
  connect(welcome_, &GuideWelcome::video_wanted, this, &GuidePage::choose_video);
  connect(from_video_, &FromVideo::left, this, [this] { pages_->setCurrentIndex(has_video() ? 1 : 0); });
  connect(from_video_, &FromVideo::made, this, &GuidePage::open);
  connect(welcome_, &GuideWelcome::file_wanted, this, &GuidePage::choose_file);
  connect(welcome_, &GuideWelcome::example_wanted, this, &GuidePage::open_example);
  connect(panel_, &GuidePanel::placing_wanted, this, &GuidePage::place);
  connect(panel_, &GuidePanel::refining_wanted, this, &GuidePage::refine);
  connect(panel_, &GuidePanel::cancel_wanted, &context_.work, &BackgroundWork::cancel);
  connect(panel_, &GuidePanel::film_wanted, this, &GuidePage::choose_film);
  connect(panel_, &GuidePanel::look_changed, this, [this] {
    view_->set_look(panel_->look());
    show_overlay();
  });
  connect(timeline_, &Timeline::moved, this, [this] {
    follows_answers_ = false;
    show_frame();
  });
}

// ---- Long work ----

void GuidePage::start(Task task, const QString& title, BackgroundWork::Work work) {
  said_ = {};
  if (context_.work.start(title, std::move(work))) task_ = task;  // refused, what is under way may still be this page's
  update_text();
}

void GuidePage::connect_work() {
  connect(&context_.work, &BackgroundWork::progressed, this, [this](double fraction, const QString& stage) {
    if (task_ == Task::placing || task_ == Task::filming) panel_->show_progress(fraction, stage);
  });
  connect(&context_.work, &BackgroundWork::finished, this, [this] {
    task_ = Task::none;
    follows_answers_ = false;
    update_text();
  });
}

void GuidePage::open(const fs::path& file, const std::function<QString()>& then_said) {
  start(Task::opening, tr("Opening the sequence"),
        [page = QPointer(this), folder = case_folder_, file,
         then_said](const Progress& progress) -> BackgroundWork::Then {
          auto opened = open_guided_video(folder, file, progress);
          return [page, opened = std::move(opened), then_said] {
            if (page.isNull()) return;
            if (!opened) return page->say_error(opened.error());
            page->take(*opened);
            if (then_said) page->say(then_said);
          };
        });
}

void GuidePage::open_example() {
  start(Task::opening, tr("Making an example sequence"),
        [page = QPointer(this), case_folder = case_folder_,
         folder = own_folder() / "example-sequence"](const Progress& progress) -> BackgroundWork::Then {
          const fs::path file = folder / "sequence.json";
          std::error_code ignored;
          const auto made = fs::exists(file, ignored)
                                ? Result<fs::path>(file)
                                : studies::write_example_sequence(folder, {}, progress.part(0, 0.6));
          auto opened = made.and_then(
              [&](const fs::path& there) { return open_guided_video(case_folder, there, progress.part(0.6, 1)); });
          return [page, opened = std::move(opened)] {
            if (page.isNull()) return;
            if (opened) return page->take(*opened);
            page->say_error(opened.error());
          };
        });
}

void GuidePage::refine() {
  if (!hand_) return;
  keep_hand_pose();
  panel_->set_by_hand(false);
  run(hand_, answers_.size());
}

void GuidePage::run(const std::optional<HandPose>& from, std::size_t frames) {
  if (!has_video()) return;
  timeline_->play(false);
  panel_->set_by_hand(false);
  panel_->lines().set_on(false);
  start(Task::placing, tr("Placing the liver"),
        [page = QPointer(this), video = video_, modes = modes_, from, lines = lines_,
         frames](const Progress& progress) -> BackgroundWork::Then {
          // Handed to the window as soon as it is known.
          const auto heard = [page, video](std::size_t frame, std::shared_ptr<const GuidedFrame> answer) {
            const auto take = [page, video, frame, answer = std::move(answer)] {
              if (!page.isNull() && page->video_ == video) page->take_frame(frame, answer);
            };
            QMetaObject::invokeMethod(QCoreApplication::instance(), take, Qt::QueuedConnection);
          };
          auto made = place_liver(*video, modes, from, lines, frames, progress, heard);
          return [page, video, made = std::move(made)] {
            if (page.isNull() || page->video_ != video) return;
            if (made) {
              page->modes_ = *made;
              Q_EMIT page->placed();
            } else if (made.error().code != "cancelled") {
              page->say([error = made.error()] { return translated(error); });
            }
          };
        });
  if (task_ != Task::placing) return;
  follows_answers_ = true;
  answers_.assign(answers_.size(), nullptr);  // what is shown is the answer from here, or nothing
  show_frame();
}

void GuidePage::film(const fs::path& file) {
  std::vector<FilmedFrame> frames;
  const QString origin = video_->sequence.simulated.empty() ? QString() : tr("SIMULATED");
  for (std::size_t f = 0; f < answers_.size(); ++f) {
    const bool is_placed = answered(f) != nullptr && answered(f)->placement.converged;
    QStringList caption{tr("Frame %1").arg(f + 1)};
    caption << (is_placed ? tr("dashed: may be off by more than %1 mm").arg(panel_->look().tolerance_mm)
                          : tr("not placed"));
    if (!origin.isEmpty()) caption.prepend(origin);
    frames.push_back({video_->sequence.images[f], size_px_,
                      is_placed ? picture_of(answered(f)->overlay.outlines) : OverlayPicture{},
                      caption.join(QString::fromUtf8("  \u00b7  "))});
  }
  start(Task::filming, tr("Writing the video"),
        [page = QPointer(this), file, frames = std::move(frames),
         look = panel_->look()](const Progress& progress) -> BackgroundWork::Then {
          const auto written = write_film(file, frames, look, film_frames_per_second, progress);
          return [page, file, written] {
            if (page.isNull()) return;
            if (written) {
              page->say([file] { return tr("Written: %1").arg(text_of(file)); });
              Q_EMIT page->filmed();
            } else {
              page->say_error(written.error());
            }
          };
        });
}

void GuidePage::choose_video() { pages_->setCurrentWidget(from_video_); }

void GuidePage::choose_file() {
  const QString file = ask_for_file(this, tr("Open a sequence"), tr("Sequences (*.json)"));
  if (!file.isEmpty()) open(path_of(file));
}

void GuidePage::choose_film() {
  const QString file = ask_where_to_save(this, tr("Save a video of the frames"), proposed_film,
                                         tr("Movies (*.mp4);;Folder of pictures (*)"));
  if (!file.isEmpty()) film(path_of(file));
}

// ---- What comes of it ----

void GuidePage::show_patient(const Patient& patient) {
  const bool same = patient.folder == case_folder_;
  case_folder_ = patient.folder;
  welcome_->show_missing(model_missing(patient));
  if (has_video() && (!same || model_content(case_folder_) != video_->model_content)) close_video();
}

void GuidePage::close_video() {
  if (task_ != Task::none) context_.work.cancel();
  video_.reset();
  modes_.reset();
  answers_.clear();
  hand_.reset();
  lines_ = {};
  panel_->set_by_hand(false);
  panel_->lines().set_on(false);
  pages_->setCurrentIndex(0);
  update_text();
}

void GuidePage::take(std::shared_ptr<const GuidedVideo> video) {
  if (video->case_folder != case_folder_) return;  // another was opened meanwhile
  if (has_video() && video_->model_content != video->model_content) modes_.reset();
  video_ = std::move(video);
  answers_.assign(video_->sequence.clouds.size(), nullptr);
  images_.clear();
  size_px_ = {};
  looked_in_space_ = false;
  panel_->set_by_hand(false);
  panel_->lines().set_on(false);
  read_kept_pose();
  read_kept_lines();
  timeline_->set_frames(static_cast<int>(answers_.size()));
  pages_->setCurrentIndex(1);
  show_frame();
  setFocus();
  Q_EMIT opened();
}

void GuidePage::take_frame(std::size_t frame, std::shared_ptr<const GuidedFrame> answer) {
  answers_[frame] = std::move(answer);
  if (follows_answers_ && frame != this->frame()) {
    timeline_->show_frame(static_cast<int>(frame));  // as if somebody had
    follows_answers_ = true;
  } else if (frame == this->frame()) {
    show_frame();
  } else {
    update_text();
  }
}

const GuidedFrame* GuidePage::answered(std::size_t frame) const {
  return frame < answers_.size() ? answers_[frame].get() : nullptr;
}

void GuidePage::say_error(const Error& error) {
  if (error.code == "cancelled") return;
  say([error] { return translated(error); });
  if (pages_->currentWidget() == from_video_) from_video_->say(said_);
}

void GuidePage::say(std::function<QString()> words) {
  said_ = std::move(words);
  update_text();
}

void GuidePage::keyPressEvent(QKeyEvent* event) {
  if (!has_video()) return QWidget::keyPressEvent(event);
  if (event->key() == Qt::Key_O) {
    panel_->turn_outlines();
  } else if (!timeline_->take_key(event->key())) {
    QWidget::keyPressEvent(event);
  }
}

}  // namespace glisson::widgets

#include "widgets/register/register_page.h"

#include <algorithm>
#include <QKeyEvent>
#include <QPointer>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "studies/review/example_sequence.h"
#include "widgets/panels/ask_path.h"
#include "widgets/panels/parts.h"
#include "widgets/settings/settings.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/paths.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {

using registration_quality::SequenceMethod;

namespace {

namespace fs = std::filesystem;

Result<std::shared_ptr<const OpenedSequence>> read(const fs::path& file) {
  return registration_quality::read_sequence(file).map([&](registration_quality::SequenceFiles files) {
    return std::make_shared<const OpenedSequence>(OpenedSequence{file, std::move(files)});
  });
}

}  // namespace

RegisterPage::RegisterPage(BackgroundWork& work, QWidget* parent) : QWidget(parent), work_(work) {
  setObjectName("register_page");
  setFocusPolicy(Qt::StrongFocus);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  pages_ = new QStackedWidget;
  welcome_ = new RegisterWelcome;
  welcome_->setObjectName("register_welcome");
  pages_->addWidget(welcome_);
  pages_->addWidget(make_review());
  from_video_ = new FromVideo(work_);
  pages_->addWidget(from_video_);
  column->addWidget(pages_);
  connect_work();
  connect_parts();
  keep_translated(this, [this] { update_text(); });
}

Workspace RegisterPage::workspace(const WorkspaceContext& context) {
  return {.id = "register",
          .name = [] { return tr("Register"); },
          .about = [] { return tr("See how good a registration of a video is, place by place."); },
          .widget = new RegisterPage(context.work),
          .place = Workspace::Place::whole_window,
          .group = Workspace::Group::research};
}

const Judged* RegisterPage::judged(int side) const {
  const auto chosen = algorithms_->method(side);
  const auto found = chosen ? judged_.find(*chosen) : judged_.end();
  return found != judged_.end() ? found->second.get() : nullptr;
}

// ---- Long work ----

void RegisterPage::start(const QString& title, BackgroundWork::Work work) {
  say({});
  if (work_.start(title, std::move(work))) working_ = true;  // refused, what is under way may still be this page's
}

void RegisterPage::open(const fs::path& file, const std::function<QString()>& then_said) {
  start(tr("Opening the sequence"), [page = QPointer(this), file, then_said](const Progress&) -> BackgroundWork::Then {
    auto opened = read(file);
    return [page, opened = std::move(opened), then_said] {
      if (page.isNull()) return;
      if (opened) page->take(*opened);
      page->say(opened ? then_said : [error = opened.error()] { return translated(error); });
    };
  });
}

void RegisterPage::open_example() {
  start(tr("Making an example sequence"),
        [page = QPointer(this),
         folder = own_folder() / "example-sequence"](const Progress& progress) -> BackgroundWork::Then {
          const fs::path file = folder / "sequence.json";
          std::error_code ignored;
          const auto made = fs::exists(file, ignored) ? Result<fs::path>(file)
                                                      : studies::write_example_sequence(folder, {}, progress);
          auto opened = made.and_then(read);
          return [page, opened = std::move(opened)] {
            if (page.isNull()) return;
            if (opened) return page->take(*opened);
            page->say([error = opened.error()] { return translated(error); });
          };
        });
}

void RegisterPage::compute() {
  if (!has_sequence()) return;
  std::vector<SequenceMethod> wanted;
  for (const int side : {0, 1}) {
    const auto chosen = algorithms_->method(side);
    const bool known = !chosen || judged_.contains(*chosen);
    if (!known && std::find(wanted.begin(), wanted.end(), *chosen) == wanted.end()) wanted.push_back(*chosen);
  }
  if (wanted.empty()) return;
  timeline_->play(false);
  start(tr("Registering the video"),
        [page = QPointer(this), sequence = sequence_, wanted](const Progress& progress) -> BackgroundWork::Then {
          std::vector<std::shared_ptr<const Judged>> done;
          std::optional<Error> problem;
          for (std::size_t i = 0; i < wanted.size() && !problem; ++i) {
            const auto share = static_cast<double>(wanted.size());
            auto judged = judge(*sequence, wanted[i],
                                progress.part(static_cast<double>(i) / share, static_cast<double>(i + 1) / share));
            if (judged) {
              done.push_back(std::make_shared<const Judged>(*std::move(judged)));
            } else {
              problem = judged.error();
            }
          }
          return [page, sequence, done, problem] {
            if (page.isNull() || page->sequence_ != sequence) return;
            for (const auto& one : done) page->judged_[one->method] = one;
            if (problem) page->say([error = *problem] { return translated(error); });
            page->choose_none();
            page->show_meshes();
            page->update_text();
            if (!problem) Q_EMIT page->computed();
          };
        });
}

void RegisterPage::connect_work() {
  connect(&work_, &BackgroundWork::progressed, this, [this](double fraction, const QString& stage) {
    if (!working_) return;
    algorithms_->show_progress(fraction, stage);
  });
  connect(&work_, &BackgroundWork::started, this, [this] {
    // Not known yet whether it is for this page: see start(), which returns later in this turn of the event loop.
    QMetaObject::invokeMethod(this, &RegisterPage::update_text, Qt::QueuedConnection);
  });
  connect(&work_, &BackgroundWork::finished, this, [this] {
    working_ = false;
    update_text();
  });
}

// ---- What there is to see ----

QWidget* RegisterPage::make_review() {
  auto* review = new QWidget;
  auto* across = new QHBoxLayout(review);
  across->setContentsMargins(0, 0, 0, 0);
  across->setSpacing(0);
  across->addWidget(make_pictures(), 1);
  auto* panel = new QWidget;
  panel->setObjectName("panel");
  auto* column = new QVBoxLayout(panel);
  column->setContentsMargins(14, 14, 14, 14);
  algorithms_ = new AlgorithmChoice;
  algorithms_->setObjectName("algorithms");
  reading_ = new ReadingPanel;
  column->addWidget(algorithms_);
  column->addSpacing(6);
  column->addWidget(reading_, 1);
  QScrollArea* scroll = scrolled(panel);
  scroll->setFixedWidth(360);
  across->addWidget(scroll);
  return review;
}

QWidget* RegisterPage::make_pictures() {
  auto* pictures = new QWidget;
  auto* column = new QVBoxLayout(pictures);
  column->setContentsMargins(14, 12, 14, 12);
  column->setSpacing(8);
  auto* head = new QHBoxLayout;
  file_ = new QLabel;
  file_->setObjectName("patient_name");
  auto* open = new QPushButton;
  open->setObjectName("open_another");
  auto* video = named_button("another_from_video");
  head->addWidget(file_, 1);
  head->addWidget(video);
  head->addWidget(open);
  column->addLayout(head);
  origin_ = new QLabel;
  origin_->setObjectName("origin");
  origin_->setWordWrap(true);
  origin_->hide();
  column->addWidget(origin_);
  reading_text_ = wrapped_label("register_reading");
  column->addWidget(reading_text_);
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  for (std::size_t side = 0; side < 2; ++side) {
    videos_[side] = new HeatVideo;
    videos_[side]->setObjectName(side == 0 ? "first_video" : "second_video");
    row->addWidget(videos_[side], 1);
  }
  legend_ = new HeatLegend;
  legend_->setObjectName("heat_legend");
  row->addWidget(legend_);
  column->addLayout(row, 3);
  timeline_ = new Timeline;
  timeline_->setObjectName("timeline");
  column->addWidget(timeline_);
  history_ = new TriangleHistory;
  history_->setObjectName("history");
  column->addWidget(history_, 2);
  notes_ = new QLabel;
  notes_->setObjectName("register_notes");
  notes_->setWordWrap(true);
  notes_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  column->addWidget(notes_);
  connect(open, &QPushButton::clicked, this, &RegisterPage::choose_file);
  connect(video, &QPushButton::clicked, this, &RegisterPage::choose_video);
  keep_translated(pictures, [open, video] {
    video->setText(tr("From a video..."));
    video->setToolTip(tr("Two videos, or one that shows both eyes, become a sequence"));
    open->setText(tr("Open another..."));
    open->setToolTip(tr("Another sequence.json in place of this one"));
  });
  return pictures;
}

void RegisterPage::connect_parts() {
  connect(welcome_, &RegisterWelcome::video_wanted, this, &RegisterPage::choose_video);
  connect(from_video_, &FromVideo::left, this, [this] { pages_->setCurrentIndex(has_sequence() ? 1 : 0); });
  connect(from_video_, &FromVideo::made, this, &RegisterPage::open);
  connect(welcome_, &RegisterWelcome::file_wanted, this, &RegisterPage::choose_file);
  connect(welcome_, &RegisterWelcome::example_wanted, this, &RegisterPage::open_example);
  connect(algorithms_, &AlgorithmChoice::computing_wanted, this, &RegisterPage::compute);
  connect(algorithms_, &AlgorithmChoice::cancel_wanted, &work_, &BackgroundWork::cancel);
  connect(algorithms_, &AlgorithmChoice::chosen, this, [this] {
    choose_none();
    show_meshes();
    update_text();
  });
  connect(reading_, &ReadingPanel::value_chosen, this, [this] {
    show_meshes();
    update_view_text();
  });
  connect(reading_, &ReadingPanel::tolerance_changed, this, [this] {
    show_meshes();
    update_view_text();
    show_figures();
    show_history();
  });
  connect(history_, &TriangleHistory::triangle_chosen, this, &RegisterPage::choose_triangle);
  connect(timeline_, &Timeline::moved, this, [this](int frame) {
    show_frame();
    show_meshes();
    show_figures();
    history_->show_frame(frame);
    say_of_place();
  });
  for (const int side : {0, 1}) {
    HeatVideo* video = videos_[static_cast<std::size_t>(side)];
    connect(video, &HeatVideo::clicked, this, &RegisterPage::choose_at);
    video->set_hint([this, side](std::size_t triangle) { return hint(side, triangle); });
  }
}

void RegisterPage::choose_file() {
  const QString file = ask_for_file(this, tr("Open a sequence"), tr("Sequences (*.json)"));
  if (!file.isEmpty()) open(path_of(file));
}

void RegisterPage::take(std::shared_ptr<const OpenedSequence> sequence) {
  sequence_ = std::move(sequence);
  judged_.clear();
  images_.clear();
  size_px_ = {};
  choose_none();
  algorithms_->offer(*sequence_);
  const QSignalBlocker quiet(timeline_);
  timeline_->set_frames(static_cast<int>(sequence_->files.clouds.size()));
  pages_->setCurrentIndex(1);
  update_text();
  show_frame();
  show_meshes();
  setFocus();
  Q_EMIT opened();
}

void RegisterPage::say(std::function<QString()> words) {
  said_ = std::move(words);
  update_text();
}

void RegisterPage::keyPressEvent(QKeyEvent* event) {
  if (!has_sequence() || !timeline_->take_key(event->key())) QWidget::keyPressEvent(event);
}

}  // namespace glisson::widgets

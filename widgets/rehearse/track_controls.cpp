#include "widgets/rehearse/track_controls.h"

#include <algorithm>
#include <cmath>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "base/files.h"
#include "widgets/panels/ask_path.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/paths.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {
namespace {

constexpr const char* proposed_movie = "rehearsal.mp4";
constexpr const char* proposed_table = "rehearsal.csv";
constexpr double ticks_per_s = 100;
constexpr int play_every_ms = 40;

}  // namespace

TrackControls::TrackControls(LiveRehearsal& rehearsal, QWidget* parent) : QWidget(parent), rehearsal_(rehearsal) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  auto* row = new QHBoxLayout;
  row->setSpacing(6);
  freeze_ = new QPushButton(this);
  freeze_->setObjectName("freeze");
  freeze_->setCheckable(true);
  play_ = new QPushButton(this);
  play_->setObjectName("play_track");
  play_->setCheckable(true);
  time_ = new QSlider(Qt::Horizontal, this);
  time_->setObjectName("track_time");
  clock_ = new QLabel(this);
  clock_->setObjectName("track_clock");
  row->addWidget(freeze_);
  row->addWidget(play_);
  row->addWidget(time_, 1);
  row->addWidget(clock_);
  column->addLayout(row);
  plot_ = new TrackPlot(this);
  column->addWidget(plot_, 1);
  auto* files = new QHBoxLayout;
  files->setSpacing(6);
  movie_button_ = new QPushButton(this);
  movie_button_->setObjectName("track_movie");
  table_ = new QPushButton(this);
  table_->setObjectName("save_track");
  clear_ = new QPushButton(this);
  clear_->setObjectName("clear_track");
  for (QPushButton* button : {movie_button_, table_, clear_}) files->addWidget(button);
  column->addLayout(files);

  connect(freeze_, &QPushButton::clicked, this, [this](bool on) { rehearsal_.set_frozen(on); });
  connect(play_, &QPushButton::toggled, this, [this](bool on) {
    if (!on) return playing_.stop();
    const auto shown = rehearsal_.shown_moment();
    const bool at_end = !shown || *shown + 1 >= rehearsal_.track().moments().size();
    played_from_s_ = at_end ? 0 : rehearsal_.track().moments()[*shown].time_s;
    played_.start();
    playing_.start(play_every_ms);
    play_on();
  });
  connect(&playing_, &QTimer::timeout, this, &TrackControls::play_on);
  connect(time_, &QSlider::valueChanged, this, [this](int ticks) {
    play_->setChecked(false);
    show_time(ticks / ticks_per_s);
  });
  connect(plot_, &TrackPlot::time_chosen, this, [this](double time_s) {
    play_->setChecked(false);
    show_time(std::min(time_s, rehearsal_.track().length_s()));
  });
  connect(movie_button_, &QPushButton::clicked, this, &TrackControls::choose_movie);
  connect(table_, &QPushButton::clicked, this, &TrackControls::save_table);
  connect(clear_, &QPushButton::clicked, this, [this] {
    play_->setChecked(false);
    rehearsal_.go_on();
    rehearsal_.clear_track();
  });
  connect(&rehearsal, &LiveRehearsal::track_changed, this, &TrackControls::show_track);
  connect(&rehearsal, &LiveRehearsal::solving_changed, this, &TrackControls::show_state);
  connect(&rehearsal, &LiveRehearsal::state_changed, this, &TrackControls::show_state);
  keep_translated(this, [this] {
    freeze_->setText(tr("❚❚ Freeze"));
    freeze_->setToolTip(tr("Nothing moves the tool while you look around"));
    play_->setText(tr("▶ Play"));
    play_->setToolTip(tr("Shows again what was done, from where the time stands; rests are cut to 1 s"));
    time_->setToolTip(tr("Any moment of this rehearsal, in seconds"));
    time_->setAccessibleName(tr("Time"));
    table_->setText(tr("Table..."));
    table_->setToolTip(tr("Saves every moment as CSV: tools, forces (N), landmarks (mm)"));
    clear_->setText(tr("Forget"));
    clear_->setToolTip(tr("Forgets what was done so far; the tool stays"));
    show_track();
  });
}

void TrackControls::set_camera(std::function<QImage()> grab) {
  movie_ = new MovieMaker(rehearsal_, std::move(grab), this);
  connect(movie_, &MovieMaker::progressed, this,
          [this](double fraction) { movie_button_->setText(tr("Stop (%1 %)").arg(100 * fraction, 0, 'f', 0)); });
  connect(movie_, &MovieMaker::written, this, [this] {
    show_state();
    Q_EMIT said(tr("Written: %1").arg(movie_file_));
  });
  connect(movie_, &MovieMaker::stopped, this, [this] {
    show_state();
    Q_EMIT said(tr("Stopped. No movie was written."));
  });
  connect(movie_, &MovieMaker::failed, this, [this](const Error& error) {
    show_state();
    Q_EMIT failed(error);
  });
}

void TrackControls::follow_landmark(const std::string& id) {
  landmark_ = id;
  show_track();
}

void TrackControls::choose_movie() {
  if (movie_ == nullptr) return;
  if (movie_->busy()) {
    movie_->stop();
    return;
  }
  const QString file = ask_where_to_save(this, tr("Save a movie of the rehearsal"), proposed_movie,
                                         tr("Movies (*.mp4);;Folder of pictures (*)"));
  if (!file.isEmpty()) make_movie(path_of(file));
}

void TrackControls::make_movie(const std::filesystem::path& file) {
  play_->setChecked(false);
  movie_file_ = text_of(file);
  movie_->begin(file);
}

void TrackControls::save_table() {
  const QString file =
      ask_where_to_save(this, tr("Save the rehearsal as a table"), proposed_table, tr("Tables (*.csv)"));
  if (file.isEmpty()) return;
  std::vector<std::string> ids;
  if (rehearsal_.state()) {
    for (const auto& landmark : rehearsal_.state()->patient.landmarks) ids.push_back(landmark.id);
  }
  if (auto written = write_text_file(path_of(file), rehearsal_.track().csv(ids)); !written) {
    Q_EMIT failed(written.error());
  } else {
    Q_EMIT said(tr("Written: %1").arg(file));
  }
}

void TrackControls::play_on() {
  const double time_s = played_from_s_ + 1e-3 * static_cast<double>(played_.elapsed());
  if (rehearsal_.track().empty() || time_s >= rehearsal_.track().length_s()) {
    play_->setChecked(false);
    rehearsal_.go_on();
    return;
  }
  show_time(time_s);
}

void TrackControls::show_time(double time_s) {
  if (rehearsal_.track().empty()) return;
  const std::size_t moment = rehearsal_.track().at(time_s);
  const bool is_last = moment + 1 == rehearsal_.track().moments().size();
  if (is_last && !playing_.isActive()) {
    rehearsal_.go_on();
  } else if (rehearsal_.shown_moment() != moment) {
    rehearsal_.show_moment(moment);
  }
  show_state();
}

void TrackControls::show_track() {
  std::optional<std::size_t> row;
  if (rehearsal_.state()) {
    const auto& landmarks = rehearsal_.state()->patient.landmarks;
    for (std::size_t k = 0; k < landmarks.size(); ++k) {
      if (landmarks[k].id == landmark_) row = k;
    }
  }
  plot_->show_track(rehearsal_.track(), row, structure_label(landmark_));
  show_state();
}

void TrackControls::show_state() {
  const RehearsalTrack& track = rehearsal_.track();
  const auto shown = rehearsal_.shown_moment();
  const double now_s = shown ? track.moments()[*shown].time_s : track.length_s();
  const QSignalBlocker quiet(time_);
  time_->setRange(0, static_cast<int>(std::ceil(ticks_per_s * track.length_s())));
  time_->setValue(static_cast<int>(std::ceil(ticks_per_s * now_s)));
  clock_->setText(shown ? tr("%1 of %2 s").arg(now_s, 0, 'f', 1).arg(track.length_s(), 0, 'f', 1)
                        : tr("%1 s").arg(track.length_s(), 0, 'f', 1));
  plot_->show_time(shown ? std::optional(now_s) : std::nullopt);
  const bool any = track.moments().size() > 1;
  const bool filming = movie_ != nullptr && movie_->busy();
  for (QWidget* control : {static_cast<QWidget*>(play_), static_cast<QWidget*>(time_), static_cast<QWidget*>(table_),
                           static_cast<QWidget*>(clear_)}) {
    control->setEnabled(any && !filming);
  }
  freeze_->setChecked(rehearsal_.frozen());
  freeze_->setEnabled(rehearsal_.has_tool() || rehearsal_.frozen());
  movie_button_->setEnabled(movie_ != nullptr && any);
  movie_button_->setToolTip(any ? tr("A movie of what the 3D view shows, MP4 or pictures")
                                : tr("Move a tool first: there is nothing to show yet"));
  if (!filming) movie_button_->setText(tr("Movie..."));
}

}  // namespace glisson::widgets

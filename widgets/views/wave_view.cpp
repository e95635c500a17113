#include "widgets/views/wave_view.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "widgets/views/map_picture.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {
namespace {

namespace fs = std::filesystem;

constexpr int wave_frame_ms = 60;
constexpr int frames_of_a_period = 32;

// The value below which that share of the positive ones lies.
double upper_range(const std::vector<float>& values, double share) {
  std::vector<float> positive;
  std::copy_if(values.begin(), values.end(), std::back_inserter(positive), [](float value) { return value > 0; });
  if (positive.empty()) return 1;
  const auto at = positive.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(positive.size() - 1));
  std::nth_element(positive.begin(), at, positive.end());
  return static_cast<double>(*at);
}

// The voxels in a slice that hold all of the region, in whichever slice, with some room around.
QRect surroundings_of(const imaging::Mask& region) {
  QRect part;
  for (int k = 0; k < region.grid.size[2]; ++k) {
    for (int j = 0; j < region.grid.size[1]; ++j) {
      for (int i = 0; i < region.grid.size[0]; ++i) {
        if (region.at(i, j, k) != 0) part |= QRect(i, j, 1, 1);
      }
    }
  }
  constexpr int room = 3;
  return part.adjusted(-room, -room, room, room);
}

template <typename Value>
std::vector<Value> slice_of(const std::vector<Value>& values, const imaging::Grid& grid, int slice) {
  const std::ptrdiff_t voxels = static_cast<std::ptrdiff_t>(grid.size[0]) * grid.size[1];
  return {values.begin() + slice * voxels, values.begin() + (slice + 1) * voxels};
}

}  // namespace

WaveView::WaveView(fs::path case_folder, QWidget* parent) : QWidget(parent), folder_(std::move(case_folder)) {
  resize(1280, 720);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(14, 12, 14, 12);
  column->setSpacing(10);
  column->addWidget(make_controls());
  column->addWidget(make_pictures(), 1);
  column->addWidget(make_foot());

  clock_.setInterval(wave_frame_ms);
  connect(&clock_, &QTimer::timeout, this, &WaveView::step);
  connect(invert_, &QPushButton::clicked, this, &WaveView::invert);
  connect(accept_, &QPushButton::clicked, this, &WaveView::accept);
  connect(slice_, &QSlider::valueChanged, this, &WaveView::show_slice);
  connect(play_, &QPushButton::toggled, this, [this](bool playing) {
    playing ? clock_.start() : clock_.stop();
    update_result_text();
  });
  connect(&work_, &BackgroundWork::started, this, [this] {
    invert_->setEnabled(false);
    accept_->setEnabled(false);
    progress_->show();
  });
  connect(&work_, &BackgroundWork::progressed, this,
          [this](double fraction, const QString&) { progress_->setValue(static_cast<int>(1000 * fraction)); });
  connect(&work_, &BackgroundWork::finished, this, [this] {
    invert_->setEnabled(true);
    accept_->setEnabled(has_result());
    progress_->hide();
  });
  connect(&work_, &BackgroundWork::broke, this, [this](const QString& what) {
    say([what] { return tr("A defect in Glisson stopped this: %1").arg(what); });
  });
  keep_translated(this, [this] {
    setWindowTitle(tr("Elastography waves"));
    update_result_text();
  });
}

bool WaveView::has_waves(const fs::path& case_folder) {
  const auto opened = casefile::Case::open(case_folder);
  return opened && casefile::has_waves(*opened);
}

void WaveView::invert() {
  elastography::AskedFor asked;
  if (frequency_->value() > 0) asked.frequency_Hz = frequency_->value();
  elastography::InversionOptions options;
  options.method = static_cast<elastography::InversionMethod>(method_->currentData().toInt());
  options.long_waves = static_cast<elastography::LongWaves>(long_waves_->currentData().toInt());
  say({});
  work_.start(tr("Inverting the waves"),
              [this, folder = folder_, asked, options](const Progress& progress) -> BackgroundWork::Then {
                auto found = std::make_shared<Result<casefile::InvertedWaves>>(
                    casefile::Case::open(folder).and_then([&](const casefile::Case& patient) {
                      return casefile::inverted_waves(patient, asked, options, progress);
                    }));
                return [this, found] {
                  if (!*found) {
                    say([found] { return translated(found->error()); });
                    return;
                  }
                  inverted_ = std::make_shared<casefile::InvertedWaves>(std::move(**found));
                  show_result();
                  Q_EMIT inverted();
                };
              });
}

void WaveView::accept() {
  if (!has_result() || !may_change_()) return;
  work_.start(tr("Saving the maps"), [this, folder = folder_, result = inverted_](const Progress&) {
    auto saved = std::make_shared<Result<void>>(recorded_([&] {
      return casefile::Case::open(folder).and_then(
          [&](casefile::Case patient) { return casefile::accept_waves(patient, *result); });
    }));
    return BackgroundWork::Then([this, saved] {
      say([saved] {
        return *saved ? tr("The case now holds this stiffness. Build its model anew to use it.")
                      : translated(saved->error());
      });
      if (*saved) Q_EMIT accepted();
    });
  });
}

QWidget* WaveView::make_controls() {
  auto* bar = new QWidget;
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(10);
  const auto add = [&](QWidget* control) {
    auto* name = new QLabel;
    name->setBuddy(control);
    row->addWidget(name);
    row->addWidget(control);
    row->addSpacing(8);
    return name;
  };
  frequency_ = new NumberBox;
  frequency_->setObjectName("wave_frequency");
  frequency_->setRange(0, 2000);
  frequency_->setDecimals(1);
  QLabel* frequency_name = add(frequency_);
  method_ = new QComboBox;
  method_->setObjectName("wave_method");
  method_->addItem({}, static_cast<int>(elastography::InversionMethod::direct));
  method_->addItem({}, static_cast<int>(elastography::InversionMethod::local_frequency));
  QLabel* method_name = add(method_);
  long_waves_ = new QComboBox;
  long_waves_->setObjectName("wave_long_waves");
  long_waves_->addItem({}, static_cast<int>(elastography::LongWaves::high_pass));
  long_waves_->addItem({}, static_cast<int>(elastography::LongWaves::curl));
  long_waves_->addItem({}, static_cast<int>(elastography::LongWaves::keep));
  QLabel* long_waves_name = add(long_waves_);
  invert_ = new QPushButton;
  invert_->setObjectName("primary");
  row->addWidget(invert_);
  progress_ = new QProgressBar;
  progress_->setRange(0, 1000);
  progress_->setTextVisible(false);
  progress_->setFixedWidth(160);
  progress_->hide();
  row->addWidget(progress_);
  row->addStretch();
  keep_translated(bar, [=, this] {
    frequency_name->setText(tr("&Vibration"));
    frequency_->setSuffix(tr(" Hz"));
    frequency_->setSpecialValueText(tr("as the images say"));
    method_name->setText(tr("&Method"));
    method_->setItemText(0, tr("Complex modulus"));
    method_->setItemText(1, tr("Local wavelength"));
    long_waves_name->setText(tr("&Long waves"));
    long_waves_->setItemText(0, tr("High-pass"));
    long_waves_->setItemText(1, tr("Curl"));
    long_waves_->setItemText(2, tr("Keep"));
    invert_->setText(tr("Compute the stiffness"));
  });
  return bar;
}

QWidget* WaveView::make_pictures() {
  auto* pictures = new QWidget;
  auto* row = new QHBoxLayout(pictures);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(10);
  wave_ = new MapPicture(Scale::both_ways);
  modulus_ = new MapPicture(Scale::from_zero);
  confidence_ = new MapPicture(Scale::from_zero);
  wave_->setObjectName("wave_picture");
  modulus_->setObjectName("modulus_picture");
  confidence_->setObjectName("confidence_picture");
  for (MapPicture* picture : {wave_, modulus_, confidence_}) row->addWidget(picture, 1);
  keep_translated(pictures, [this] {
    wave_->set_words(tr("Shear waves"), tr("rad"));
    modulus_->set_words(tr("Shear stiffness"), tr("kPa"));
    confidence_->set_words(tr("Confidence"), {});
  });
  return pictures;
}

QWidget* WaveView::make_foot() {
  auto* foot = new QWidget;
  auto* column = new QVBoxLayout(foot);
  column->setContentsMargins(0, 0, 0, 0);
  auto* row = new QHBoxLayout;
  play_ = new QPushButton;
  play_->setObjectName("wave_play");
  play_->setCheckable(true);
  play_->setEnabled(false);
  row->addWidget(play_);
  slice_text_ = new QLabel;
  row->addWidget(slice_text_);
  slice_ = new QSlider(Qt::Horizontal);
  slice_->setObjectName("wave_slice");
  slice_->setEnabled(false);
  row->addWidget(slice_, 1);
  accept_ = new QPushButton;
  accept_->setObjectName("wave_accept");
  accept_->setEnabled(false);
  row->addWidget(accept_);
  column->addLayout(row);
  summary_ = new QLabel;
  summary_->setObjectName("wave_summary");
  summary_->setWordWrap(true);
  column->addWidget(summary_);
  notes_ = new QLabel;
  notes_->setObjectName("faint");
  notes_->setWordWrap(true);
  column->addWidget(notes_);
  keep_translated(foot, [this] { accept_->setText(tr("Accept into the case")); });
  return foot;
}

void WaveView::show_result() {
  const elastography::ModulusMap& map = inverted_->map;
  const int slices = map.magnitude_kPa.grid.size[2];
  // What is noise must not decide on the colours of the rest.
  std::vector<float> amplitude, modulus;
  for (std::size_t v = 0; v < map.confidence.values.size(); ++v) {
    if (map.confidence.values[v] < 0.5F) continue;
    amplitude.push_back(std::abs(map.moving_wave_rad[v]));
    modulus.push_back(map.magnitude_kPa.values[v]);
  }
  wave_range_rad_ = upper_range(amplitude, 0.98);
  modulus_range_kPa_ = 1.2 * upper_range(modulus, 0.98);
  for (MapPicture* picture : {wave_, modulus_, confidence_}) picture->look_at(surroundings_of(map.region));
  slice_->setRange(0, slices - 1);
  slice_->setEnabled(slices > 1);
  slice_->setValue(slices / 2);
  show_slice();
  accept_->setEnabled(true);
  play_->setEnabled(true);
  play_->setChecked(true);
  say([notes = map.notes] {
    QStringList sentences;
    for (const Sentence& note : notes) sentences << translated(note);
    return sentences.join(" ");
  });
  update_result_text();
}

void WaveView::update_result_text() {
  play_->setText(play_->isChecked() ? tr("Pause") : tr("Play"));
  if (said_) notes_->setText(said_());
  if (!has_result()) {
    slice_text_->setText(tr("Slice"));
    summary_->setText(tr("Compute the stiffness from the waves that the case holds."));
    return;
  }
  const elastography::ModulusMap& map = inverted_->map;
  summary_->setText(tr("Shear stiffness %1 kPa on average over %2 confident voxels, %3 % of the region; middle half %4 "
                       "to %5 kPa; vibration %6 Hz, wavelength %7 mm")
                        .arg(map.mean_kPa, 0, 'f', 2)
                        .arg(map.confident.voxels)
                        .arg(100 * map.confident_fraction, 0, 'f', 0)
                        .arg(map.confident.percentile_25, 0, 'f', 2)
                        .arg(map.confident.percentile_75, 0, 'f', 2)
                        .arg(map.frequencies_Hz.front(), 0, 'g', 4)
                        .arg(map.typical_wavelength_mm, 0, 'f', 0));
  show_slice();
}

void WaveView::show_slice() {
  if (!has_result()) return;
  const elastography::ModulusMap& map = inverted_->map;
  const imaging::Grid& grid = map.magnitude_kPa.grid;
  const int slice = slice_->value();
  slice_text_->setText(tr("Slice %1 of %2").arg(slice + 1).arg(grid.size[2]));
  const auto known = slice_of(map.region.values, grid, slice);
  // What is not to be believed is not shown as stiffness.
  std::vector<std::uint8_t> believed;
  for (const float confidence : slice_of(map.confidence.values, grid, slice)) {
    believed.push_back(confidence >= 0.5F ? 1 : 0);
  }
  modulus_->show_slice(grid, slice_of(map.magnitude_kPa.values, grid, slice), believed, modulus_range_kPa_);
  confidence_->show_slice(grid, slice_of(map.confidence.values, grid, slice), known, 1);
  std::vector<float> now;
  const auto turn = std::complex<float>(std::polar(1.0, 2 * std::numbers::pi * instant_));
  for (const std::complex<float>& u : slice_of(map.moving_wave_rad, grid, slice)) now.push_back((u * turn).real());
  wave_->show_slice(grid, now, known, wave_range_rad_);
}

void WaveView::step() {
  instant_ = std::fmod(instant_ + 1.0 / frames_of_a_period, 1.0);
  show_slice();
}

void WaveView::say(std::function<QString()> words) {
  said_ = std::move(words);
  notes_->setText(said_ ? said_() : QString());
}

}  // namespace glisson::widgets

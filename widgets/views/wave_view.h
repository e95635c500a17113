#pragma once
// Raw elastography in the window: the waves as they run, and the modulus that they give. It says how far that is to be
// believed, and whether the case is to take it.

#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSlider>
#include <QTimer>
#include <QWidget>

#include "casefile/waves.h"
#include "widgets/words/number_box.h"
#include "widgets/work/background_work.h"

namespace glisson::widgets {

class MapPicture;

// The step of the history that takes them into the case.
inline const Sentence maps_of_waves{GLISSON_TEXT("Stiffness from the waves"), {}};

class WaveView : public QWidget {
  Q_OBJECT

 public:
  explicit WaveView(std::filesystem::path case_folder, QWidget* parent = nullptr);

  // Whether a case holds wave or phase images at all.
  [[nodiscard]] static bool has_waves(const std::filesystem::path& case_folder);

  // On a worker thread, with what the controls say.
  void invert();
  void accept();
  // Asked before the case is changed; it says itself why not.
  void set_guard(std::function<bool()> may_change) { may_change_ = std::move(may_change); }
  // Runs a change of the case as one step of its history, on any thread.
  using Change = std::function<Result<void>()>;
  void set_recorder(std::function<Result<void>(const Change&)> recorded) { recorded_ = std::move(recorded); }
  [[nodiscard]] bool has_result() const { return inverted_ != nullptr; }
  // How far the animation is through a period, 0 to 1.
  [[nodiscard]] double instant() const { return instant_; }

 Q_SIGNALS:
  void inverted();
  void accepted();  // the case's stiffness is now the one shown

 private:
  QWidget* make_controls();
  QWidget* make_pictures();
  QWidget* make_foot();
  void show_result();
  void show_slice();
  void step();
  void update_result_text();
  // The words are asked for again when the language changes.
  void say(std::function<QString()> words);

  std::filesystem::path folder_;
  std::shared_ptr<const casefile::InvertedWaves> inverted_;
  std::function<bool()> may_change_ = [] { return true; };
  std::function<Result<void>(const Change&)> recorded_ = [](const Change& change) { return change(); };
  std::function<QString()> said_;
  double instant_ = 0;
  double wave_range_rad_ = 1, modulus_range_kPa_ = 1;
  BackgroundWork work_;
  QTimer clock_;

  NumberBox* frequency_ = nullptr;
  QComboBox* method_ = nullptr;
  QComboBox* long_waves_ = nullptr;
  QPushButton* invert_ = nullptr;
  MapPicture* wave_ = nullptr;
  MapPicture* modulus_ = nullptr;
  MapPicture* confidence_ = nullptr;
  QPushButton* play_ = nullptr;
  QSlider* slice_ = nullptr;
  QLabel* slice_text_ = nullptr;
  QLabel* summary_ = nullptr;
  QLabel* notes_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QPushButton* accept_ = nullptr;
};

}  // namespace glisson::widgets

// From a stereo video to a sequence in the window, by its buttons: two videos with a calibration to the liver placed on
// them, one video of both eyes with pictures of a board to a sequence that is judged; cancelled, and refused.

#include <QtTest>

#include "base/files.h"
#include "base/json.h"
#include "fits.h"
#include "guided_case.h"
#include "kept_pictures.h"
#include "run_test.h"
#include "shown.h"
#include "support/folders.h"
#include "vision/calibration.h"
#include "widgets/guide/guide_page.h"
#include "widgets/register/register_page.h"
#include "widgets/words/language.h"
#include "widgets/words/paths.h"

namespace glisson::widgets {
namespace {

namespace fs = std::filesystem;

constexpr int patience_ms = 240'000;
constexpr int frames = 6;  // no landmark is believed that was seen in fewer than five
constexpr const char* tumour_at = "hidden-2";

// A chessboard of 10 x 7 squares of 5 mm around the board's origin, as a lens without distortion sees it.
vision::Frame photograph(const vision::Camera& camera, const Eigen::Isometry3d& board_to_camera) {
  constexpr int width = 640, height = 480;
  const Eigen::Isometry3d to_board = board_to_camera.inverse();
  const Eigen::Matrix3d to_ray = camera.matrix.inverse();
  vision::Frame frame{width, height, std::vector<std::uint8_t>(3 * width * height)};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      double light = 0;
      for (int quarter = 0; quarter < 4; ++quarter) {
        const Eigen::Vector3d ray = to_board.linear() * to_ray *
                                    Eigen::Vector3d(x - 0.25 + 0.5 * (quarter % 2), y - 0.25 + 0.5 * (quarter / 2), 1);
        const Eigen::Vector3d at = to_board.translation() - to_board.translation().z() / ray.z() * ray;
        const int column = static_cast<int>(std::floor(at.x() / 5)), row = static_cast<int>(std::floor(at.y() / 5));
        const bool is_black = column >= -5 && column < 5 && row >= -3 && row < 4 && (column + row) % 2 == 0;
        light += is_black ? 20 : 230;
      }
      std::fill_n(frame.at(x, y), 3, static_cast<std::uint8_t>(light / 4));
    }
  }
  return frame;
}

vision::Frame side_by_side(const vision::Frame& left, const vision::Frame& right) {
  vision::Frame both{2 * left.width, left.height, std::vector<std::uint8_t>(2 * left.rgb.size())};
  for (int y = 0; y < left.height; ++y) {
    std::copy_n(left.at(0, y), 3 * left.width, both.at(0, y));
    std::copy_n(right.at(0, y), 3 * left.width, both.at(left.width, y));
  }
  return both;
}

class FromVideoTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    studies::ExampleSequenceOptions options;
    options.frames = frames;
    options.stereo = true;
    sequence_ = test::needed(studies::write_example_sequence(folder_.path() / "example", options));
    video_ = sequence_.parent_path() / "video";
    truth_mm_ = glisson::test::places_in(sequence_.parent_path() / "hidden-truth.csv", std::string(tumour_at) + ",");
    case_ = test::guided_case(folder_.path(), sequence_, tumour_at);
    make_both_in_one();
    window_ = shown_window({1280, 720});
    window_->go_to("guide");
    page_ = child_of<QWidget>(*window_, "guide_page");
  }

  void without_a_case_nothing_is_placed() { QVERIFY(!button("guide_from_video")->isEnabled()); }

  void says_what_is_missing_step_by_step() {
    window_->open_path(case_);
    QTRY_VERIFY_WITH_TIMEOUT(window_->rehearsal().body() != nullptr && !window_->work().busy(), patience_ms);
    window_->go_to("guide");
    click(button("guide_from_video"));
    QVERIFY(page_->findChild<QWidget*>("from_video")->isVisible());
    keep_picture("from_video_empty");
    QVERIFY(!make()->isEnabled());
    QVERIFY(says().contains("left eye"));
    type("left_video", video_ / "left");
    QCOMPARE(line("right_video")->text(), text_of(video_ / "right"));  // it lies beside
    QVERIFY(says().contains("calibration"));
    type("calibration_file", video_ / "camera.json");
    QVERIFY(says().isEmpty());
    QCOMPARE(line("sequence_folder")->text(), text_of(video_ / "left-sequence"));
    QVERIFY(make()->isEnabled());
  }

  void leaves_nothing_when_it_is_cancelled() {
    click(make());
    QTRY_VERIFY(button("cancel_sequence")->isVisible());
    QVERIFY(!make()->isEnabled() && !line("left_video")->isEnabled());
    QTRY_VERIFY_WITH_TIMEOUT(told("told_first").contains("First pair"), patience_ms);
    click(button("cancel_sequence"));
    QTRY_VERIFY_WITH_TIMEOUT(!window_->work().busy(), patience_ms);
    QVERIFY2(says().startsWith("Cancelled"), qPrintable(says()));
    QCOMPARE(names_in(video_), (QStringList{"camera.json", "left", "right"}));
    QVERIFY(make()->isEnabled());
  }

  void refuses_videos_of_different_length() {
    fs::create_directories(folder_.path() / "short");
    fs::copy(video_ / "right" / "f000.png", folder_.path() / "short" / "f000.png");
    type("right_video", folder_.path() / "short");
    QVERIFY2(refused().contains("differ in length"), qPrintable(says()));
    keep_picture("from_video_refused");
    type("right_video", video_ / "right");
    QVERIFY(says().isEmpty());  // that was of the order before
  }

  void refuses_a_calibration_of_another_size() {
    auto other = test::needed(vision::read_stereo_calibration(video_ / "camera.json"));
    other.width = 1280;
    other.height = 960;
    const fs::path file = folder_.path() / "larger.json";
    QVERIFY(vision::write_stereo_calibration(file, other).has_value());
    type("calibration_file", file);
    QVERIFY2(refused().contains("1280 x 960"), qPrintable(says()));
    type("calibration_file", video_ / "camera.json");
  }

  void refuses_pictures_that_show_no_board() {
    combo("calibrated_by")->setCurrentIndex(1);
    QVERIFY(says().contains("board"));
    type("left_board", video_ / "left");
    type("right_board", video_ / "right");
    QVERIFY2(refused().contains("0 of 6 pairs"), qPrintable(says()));
    combo("calibrated_by")->setCurrentIndex(0);
  }

  void goes_from_two_videos_to_the_placed_liver() {
    auto* guide = qobject_cast<GuidePage*>(page_);
    QSignalSpy opened(guide, &GuidePage::opened);
    click(make());
    QTRY_VERIFY_WITH_TIMEOUT(told("told_first").contains("First pair"), patience_ms);
    keep_picture("from_video_working");
    QTRY_VERIFY_WITH_TIMEOUT(!opened.isEmpty() && !window_->work().busy(), patience_ms);
    const QString summary = child_of<QLabel>(*page_, "guide_reading")->text();
    QVERIFY2(summary.contains("Landmarks tracked"), qPrintable(summary));
    QVERIFY(summary.contains("5.5 mm apart"));
    QVERIFY(fs::exists(video_ / "left-sequence" / "sequence.json"));
    keep_picture("from_video_opened");

    QSignalSpy placed(guide, &GuidePage::placed);
    click(page_->findChild<GuidePanel*>()->findChild<QPushButton*>("primary"));
    QTRY_VERIFY_WITH_TIMEOUT(!placed.isEmpty() && !window_->work().busy(), patience_ms);
    const auto landmarks = test::needed(casefile::read_model(test::needed(casefile::Case::open(case_)))).landmarks;
    for (std::size_t f = 0; f < frames; ++f) {
      const GuidedFrame* answer = guide->answered(f);
      QVERIFY(answer != nullptr);
      QVERIFY2(answer->placement.converged, answer->placement.why_not.message().c_str());
      for (std::size_t k = 0; k < landmarks.size(); ++k) {
        if (landmarks[k].id != "tumour-1") continue;
        const double off_mm = (answer->placement.target_mm[k] - truth_mm_[f]).norm();
        qInfo("frame %zu: the tumour is off by %.1f mm, sd %.1f mm, residual %.2f mm", f + 1, off_mm,
              answer->placement.target_sd_mm[k], answer->placement.residual_rms_mm);
        QVERIFY2(off_mm < 6, qPrintable(QString::number(off_mm)));
      }
    }
    keep_picture("from_video_placed");
    // What came on the way is still there, and another folder is proposed.
    click(button("another_from_video"));
    QVERIFY(told("told_landmarks").contains("Landmarks tracked"));
    QCOMPARE(line("sequence_folder")->text(), text_of(video_ / "left-sequence-2"));
    keep_picture("from_video_done");
    click(button("leave_from_video"));
    QVERIFY(child_of<QWidget>(*page_, "guide_frame")->isVisible());
  }

  void goes_from_one_video_and_a_board_to_a_sequence_to_judge() {
    window_->go_to("register");
    page_ = child_of<QWidget>(*window_, "register_page");
    auto* judging = qobject_cast<RegisterPage*>(page_);
    click(button("register_from_video"));
    combo("video_eyes")->setCurrentIndex(1);
    combo("calibrated_by")->setCurrentIndex(1);
    QVERIFY(!line("right_video")->isVisible() && !line("right_board")->isVisible());
    type("left_video", folder_.path() / "both");
    type("left_board", folder_.path() / "board");
    child_of<NumberBox>(*page_, "every_frame")->setValue(1);
    QSignalSpy opened(judging, &RegisterPage::opened);
    click(make());
    QTRY_VERIFY_WITH_TIMEOUT(!opened.isEmpty() && !window_->work().busy(), patience_ms);
    QVERIFY(judging->has_sequence());
    const QString calibration = told("told_calibration");
    QVERIFY2(calibration.contains("6 of 6 pairs"), qPrintable(calibration));
    const auto made = test::needed(vision::read_stereo_calibration(folder_.path() / "both-sequence" / "camera.json"));
    const auto known = test::needed(vision::read_stereo_calibration(video_ / "camera.json"));
    QVERIFY(std::abs(made.baseline_mm() - known.baseline_mm()) < 0.1);
    QVERIFY(std::abs(made.left.matrix(0, 0) / known.left.matrix(0, 0) - 1) < 0.01);
    const QString notes = child_of<QLabel>(*page_, "register_notes")->text();
    QVERIFY2(notes.contains("reprojection error"), qPrintable(notes));
    keep_picture("from_video_register");
  }

  void fits_a_small_screen_in_the_longest_language() {
    click(button("another_from_video"));
    for (const char* language : {"de", "en"}) {
      choose_language(language);
      for (const int eyes : {0, 1}) {
        combo("video_eyes")->setCurrentIndex(eyes);
        keep_picture(qPrintable(QString("from_video_%1_%2").arg(language).arg(eyes)));
        const QStringList problems = test::what_does_not_fit(*window_);
        QVERIFY2(problems.isEmpty(), qPrintable(problems.join("; ")));
      }
    }
    QCOMPARE(window_->size(), QSize(1280, 720));
  }

  void every_control_has_a_name_and_says_what_it_does() {
    for (auto* control : page_->findChild<QWidget*>("from_video")->findChildren<QWidget*>()) {
      const auto* button = qobject_cast<QAbstractButton*>(control);
      const auto* combo = qobject_cast<QComboBox*>(control);
      const auto* line = qobject_cast<QLineEdit*>(control);
      const bool is_part = line != nullptr && qobject_cast<QAbstractSpinBox*>(control->parentWidget()) != nullptr;
      if ((button == nullptr && combo == nullptr && line == nullptr) || is_part || !control->isVisible()) continue;
      const QString which = control->objectName() + " (" + control->metaObject()->className() + ")";
      const bool has_name = !control->accessibleName().isEmpty() || (button != nullptr && !button->text().isEmpty());
      QVERIFY2(has_name, qPrintable(which + " has no name"));
      QVERIFY2(!control->toolTip().isEmpty(), qPrintable(which + " has no tooltip"));
    }
  }

  void shuts_down_cleanly() { window_.reset(); }

 private:
  QPushButton* button(const char* name) { return child_of<QPushButton>(*page_, name); }
  QLineEdit* line(const char* name) { return child_of<QLineEdit>(*page_, name); }
  QComboBox* combo(const char* name) { return child_of<QComboBox>(*page_, name); }
  QPushButton* make() { return child_of<QPushButton>(*child_of<QWidget>(*page_, "from_video"), "primary"); }
  QString told(const char* name) { return child_of<QLabel>(*page_, name)->text(); }
  // What is wrong, or what is missing or done.
  QString says() {
    const QString wrong = child_of<QLabel>(*page_, "from_video_says")->text();
    return wrong.isEmpty() ? child_of<QLabel>(*page_, "from_video_hint")->text() : wrong;
  }
  static void click(QWidget* widget) { QTest::mouseClick(widget, Qt::LeftButton); }
  void type(const char* name, const fs::path& path) {
    line(name)->selectAll();
    QTest::keyClicks(line(name), text_of(path));
  }
  // What is said of the order once it is made; nothing is left of it.
  QString refused() {
    click(make());
    if (!QTest::qWaitFor([&] { return !window_->work().busy(); }, patience_ms)) qFatal("it does not end");
    if (fs::exists(path_of(line("sequence_folder")->text()))) qFatal("something was left");
    return says();
  }
  static QStringList names_in(const fs::path& folder) {
    QStringList names;
    for (const auto& entry : fs::directory_iterator(folder)) names << text_of(entry.path().filename());
    names.sort();
    return names;
  }
  void keep_picture(const char* name) {
    QTest::qWait(400);
    QVERIFY(window_->grab().save(glisson::test::kept_pictures() + "/" + name + ".png"));
  }

  // The same video with both eyes side by side, and a board before the same camera.
  void make_both_in_one() {
    for (const char* name : {"both", "board"}) fs::create_directories(folder_.path() / name);
    for (int f = 0; f < frames; ++f) {
      const std::string name = "f00" + std::to_string(f) + ".png";
      const auto left = test::needed(vision::read_frame(video_ / "left" / name));
      const auto right = test::needed(vision::read_frame(video_ / "right" / name));
      if (!vision::write_frame(side_by_side(left, right), folder_.path() / "both" / name)) qFatal("no pictures");
    }
    const auto camera = test::needed(vision::read_stereo_calibration(video_ / "camera.json"));
    for (int pose = 0; pose < 6; ++pose) {
      Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
      place.linear() = (Eigen::AngleAxisd(0.5 * ((pose % 3) - 1), Eigen::Vector3d::UnitX()) *
                        Eigen::AngleAxisd(pose < 3 ? 0.45 : -0.4, Eigen::Vector3d::UnitY()) *
                        Eigen::AngleAxisd(0.1 * pose, Eigen::Vector3d::UnitZ()))
                           .toRotationMatrix();
      place.translation() = Eigen::Vector3d(2 + pose, 3 - pose, 85 + 4 * pose);
      const vision::Frame both =
          side_by_side(photograph(camera.left, place), photograph(camera.right, camera.left_to_right * place));
      if (!vision::write_frame(both, folder_.path() / "board" / (std::to_string(pose) + ".png"))) qFatal("no board");
    }
  }

  TemporaryFolder folder_;
  fs::path sequence_, video_, case_;
  std::vector<Eigen::Vector3d> truth_mm_;
  std::unique_ptr<MainWindow> window_;
  QWidget* page_ = nullptr;
};

}  // namespace
}  // namespace glisson::widgets

int main(int argc, char** argv) { return glisson::widgets::run_test<glisson::widgets::FromVideoTest>(argc, argv); }

#include "from_video_test.moc"

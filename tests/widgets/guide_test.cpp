// The Guide workspace, driven as a person drives it: the demo patient's liver is found on the frames of a simulated
// laparoscopy, laid by hand and refined, looked at, and filmed. Where its tumour truly is in each frame is known.

#include <QJsonArray>
#include <QJsonObject>
#include <QProcess>
#include <QtTest>

#include "base/files.h"
#include "base/json.h"
#include "casefile/macro.h"
#include "drag_in_view.h"
#include "fits.h"
#include "geometry/mesh_file.h"
#include "guided_case.h"
#include "kept_pictures.h"
#include "run_test.h"
#include "shown.h"
#include "support/folders.h"
#include "widgets/guide/guide_page.h"
#include "widgets/words/language.h"

namespace glisson::widgets {
namespace {

namespace fs = std::filesystem;

constexpr int patience_ms = 120'000;
constexpr int frames = 5;
constexpr const char* tumour_at = "hidden-2";

class GuideTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    sequence_ = test::guided_sequence(folder_.path() / "video", frames);
    truth_mm_ = glisson::test::places_in(sequence_.parent_path() / "hidden-truth.csv", std::string(tumour_at) + ",");
    QCOMPARE(truth_mm_.size(), std::size_t{frames});
    case_ = test::guided_case(folder_.path(), sequence_, tumour_at);
    window_ = shown_window({1600, 1000});
    window_->go_to("guide");
    page_ = child<GuidePage>("guide_page");
  }

  void without_a_case_says_what_it_needs() {
    auto* open = child<QPushButton>("open_guide_sequence");
    QVERIFY(open->isVisible() && !open->isEnabled());
    QVERIFY(open->toolTip().contains("model"));
  }

  void opens_a_sequence_of_the_open_case() {
    window_->open_path(case_);
    QTRY_VERIFY_WITH_TIMEOUT(window_->rehearsal().body() != nullptr && !window_->work().busy(), patience_ms);
    window_->go_to("guide");
    keep_picture("guide_welcome");
    QVERIFY(child<QPushButton>("open_guide_sequence")->isEnabled());
    open(sequence_);
    QVERIFY(view()->overlay().lines.empty());
    QVERIFY(view()->said().contains("Place the liver"));
    QVERIFY(child<QLabel>("origin", page_)->text().startsWith("SIMULATED"));
    QVERIFY(!child<QPushButton>("refine")->isEnabled());
    QVERIFY(!child<QPushButton>("guide_film")->isEnabled());
    // Lines can be marked before it is placed anywhere.
    QVERIFY(!space()->isVisible());
    click(child<QPushButton>("mark_lines"));
    QVERIFY(space()->isVisible());
    QTest::qWait(300);
    keep_picture("guide_lines_first");
    click(child<QPushButton>("mark_lines"));
    QVERIFY(!space()->isVisible());
  }

  void finds_the_liver_and_says_where_the_tumour_is() {
    QSignalSpy placed(page_, &GuidePage::placed);
    click(place_button());
    QTRY_VERIFY(child<QPushButton>("cancel_guiding")->isVisible());
    QVERIFY(!place_button()->isEnabled());
    // Frames are shown as they come, the first long before the last.
    QTRY_VERIFY_WITH_TIMEOUT(page_->answered(0) != nullptr, patience_ms);
    QVERIFY(page_->answered(frames - 1) == nullptr);
    QTRY_VERIFY_WITH_TIMEOUT(!placed.isEmpty() && !window_->work().busy(), patience_ms);
    for (std::size_t f = 0; f < frames; ++f) {
      const GuidedFrame* answer = page_->answered(f);
      QVERIFY(answer != nullptr);
      QVERIFY2(answer->placement.converged, answer->placement.why_not.message().c_str());
      const double off_mm = (tumour_mm(*answer) - truth_mm_[f]).norm();
      qInfo("frame %zu: the tumour is off by %.1f mm", f + 1, off_mm);
      QVERIFY2(off_mm < 6, qPrintable(QString::number(off_mm)));
    }
    child<Timeline>("guide_timeline")->show_frame(3);
    QVERIFY(view()->said().isEmpty());
    // Its outline lies around where the camera truly shows the tumour.
    const auto& outline = line_of("tumour-1").outline;
    const auto truly = vision::project(camera(), {truth_mm_[3]}).front().value();
    Eigen::AlignedBox2d around;
    for (const auto& piece : outline.pieces) {
      for (const auto& pixel : piece.line_px) around.extend(pixel);
    }
    QVERIFY2((around.center() - truly).norm() < 25, qPrintable(QString::number((around.center() - truly).norm())));
    QCOMPARE(targets()->rowCount(), 4);  // liver, vein, tumour, and the planned cut
    QVERIFY(!line_of("planned-cut").outline.pieces.empty());
    QVERIFY(outline.deep_mm.value() > 0);
    keep_picture("guide_page");
    window_->resize(1280, 800);
    keep_picture("guide_page_small");
    window_->resize(1600, 1000);
  }

  void fits_a_small_screen_in_the_longest_language() {
    choose_language("de");
    window_->resize(1280, 720);
    click(child<QPushButton>("by_hand"));  // with all that it says
    keep_picture("guide_page_de");
    const QStringList problems = test::what_does_not_fit(*window_);
    QVERIFY2(problems.isEmpty(), qPrintable(problems.join("; ")));
    QCOMPARE(window_->size(), QSize(1280, 720));
    click(child<QPushButton>("by_hand"));
    QVERIFY(child<QLabel>("frame_number", page_)->text().startsWith("Bild"));
    choose_language("en");
    window_->resize(1600, 1000);
  }

  void doubts_more_at_a_smaller_tolerance() {
    click(child<QPushButton>("guide_tolerance_10"));
    const int trusted_at_10 = doubted_rows();
    click(child<QPushButton>("guide_tolerance_3"));
    QVERIFY(doubted_rows() > trusted_at_10);
    const OverlayPicture::Line& tumour = line_of("tumour-1");
    QCOMPARE(tumour.label.contains("do not trust"), !is_trusted(tumour.outline.sd_mm, 3));
    QVERIFY(line_of("liver").outline.sd_mm > 1.2);
    QVERIFY(view()->overlay().mistrust.contains("do not trust"));
    QVERIFY(child<QLabel>("guide_reading")->text().contains("3 mm"));
    keep_picture("guide_page_3_mm");
    click(child<QPushButton>("guide_tolerance_5"));
  }

  void hides_the_outlines_under_a_key() {
    page_->setFocus();
    const QImage with = view()->grab().toImage();
    QTest::keyClick(page_, Qt::Key_O);
    QVERIFY(!view()->look().shown);
    const QImage without = view()->grab().toImage();
    QVERIFY(with != without);
    QTest::keyClick(page_, Qt::Key_O);
    QCOMPARE(view()->grab().toImage(), with);
    child<QSlider>("outlines_opacity")->setValue(40);
    QCOMPARE(view()->look().opacity, 0.4);
    QVERIFY(view()->grab().toImage() != with);
    child<QSlider>("outlines_opacity")->setValue(100);
  }

  void steps_through_the_frames_by_keys() {
    auto* timeline = child<Timeline>("guide_timeline");
    timeline->show_frame(0);
    page_->setFocus();
    QTest::keyClick(page_, Qt::Key_Right);
    QCOMPARE(timeline->frame(), 1);
    const Eigen::Vector2d before = line_of("tumour-1").outline.pieces.front().line_px.front();
    QTest::keyClick(page_, Qt::Key_End);
    QCOMPARE(timeline->frame(), frames - 1);
    QVERIFY((line_of("tumour-1").outline.pieces.front().line_px.front() - before).norm() > 1);  // it breathes
  }

  void is_laid_by_hand_undone_and_refined() {
    child<Timeline>("guide_timeline")->show_frame(2);
    auto* by_hand = child<QPushButton>("by_hand");
    click(by_hand);
    QVERIFY(by_hand->isChecked());
    QVERIFY(view()->said().startsWith("By hand"));
    const Eigen::Isometry3d fitted = page_->hand_pose()->pose;
    drag({60, 0}, Qt::LeftButton);
    QTRY_VERIFY(!window_->undo().busy());
    const Eigen::Isometry3d moved = page_->hand_pose()->pose;
    QVERIFY(moved.translation().x() - fitted.translation().x() > 3);
    QVERIFY(moved.linear().isApprox(fitted.linear()));
    drag({0, 40}, Qt::RightButton);
    QTRY_VERIFY(!window_->undo().busy());
    QVERIFY(!page_->hand_pose()->pose.linear().isApprox(moved.linear(), 1e-3));
    keep_picture("guide_by_hand");
    // One step back: the turn; another: the shift.
    press_key(*window_, Qt::Key_Z, Qt::ControlModifier);
    QTRY_VERIFY(page_->hand_pose() && page_->hand_pose()->pose.isApprox(moved, 1e-9));
    press_key(*window_, Qt::Key_Z, Qt::ControlModifier);
    QTRY_VERIFY(!page_->hand_pose());
    QVERIFY(!by_hand->isChecked());
    press_key(*window_, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_VERIFY(page_->hand_pose() && page_->hand_pose()->pose.isApprox(moved, 1e-9));
    QVERIFY(by_hand->isChecked());  // what was done again is shown
    QTRY_VERIFY(!window_->undo().busy());

    QSignalSpy placed(page_, &GuidePage::placed);
    click(child<QPushButton>("refine"));
    QTRY_VERIFY_WITH_TIMEOUT(page_->answered(2) != nullptr, patience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(!placed.isEmpty() && !window_->work().busy(), patience_ms);
    QVERIFY(!by_hand->isChecked());
    for (std::size_t f = 0; f < frames; ++f) {
      QVERIFY(page_->answered(f) != nullptr && page_->answered(f)->placement.converged);
      QVERIFY((tumour_mm(*page_->answered(f)) - truth_mm_[f]).norm() < 6);
    }
  }

  // The diary's command begins where the hand left it, and comes to what the window shows, to the bit.
  void is_told_as_a_command_that_refines_it_alike() {
    QStringList words = told_command();
    comes_to_what_is_shown(words);
    QCOMPARE(words[4], QString("--sequence-sha256"));
    words[5] = QString(64, '0');  // of another video
    QCOMPARE(QProcess::execute(cli(), words), 1);
  }

  // On a frame that is placed: what is marked on it, and beside it on the liver at rest.
  void marks_a_line_on_the_frame_and_on_the_model() {
    child<Timeline>("guide_timeline")->show_frame(1);
    auto* mark = child<QPushButton>("mark_lines");
    click(mark);
    QVERIFY(mark->isChecked());
    QVERIFY(child<QComboBox>("marked_line")->isVisible());
    QVERIFY(view()->said().startsWith("Click along a line"));
    QTRY_VERIFY(space()->width() > 300);
    const auto answer = page_->answered(1)->placement;
    const auto places_mm = along_the_front(answer.pose);
    QVERIFY(places_mm.size() >= 4);
    for (const Eigen::Vector3d& place : places_mm) {
      const auto at = vision::project(camera(), {answer.pose * place}).front().value();
      const QPointF on_widget = view()->from_frame().map(QPointF(at.x(), at.y()));
      QTest::mouseClick(view(), Qt::LeftButton, Qt::NoModifier, on_widget.toPoint());
      QTRY_VERIFY(!window_->undo().busy());
    }
    for (const Eigen::Vector3d& place : places_mm) {
      QTest::mouseClick(space(), Qt::LeftButton, Qt::NoModifier, pixel_in(*space(), place));
      QTRY_VERIFY(!window_->undo().busy());
    }
    QCOMPARE(page_->lines().lines.size(), std::size_t{1});
    const casefile::MarkedLine& line = page_->lines().lines.front();
    QCOMPARE(line.id, std::string("falciform"));
    QCOMPARE(line.at_rest_mm.size(), places_mm.size());
    QCOMPARE(line.seen_mm.at(1).size(), places_mm.size());
    for (std::size_t p = 0; p < places_mm.size(); ++p) {
      QVERIFY((line.at_rest_mm[p] - places_mm[p]).norm() < 4);  // a pixel on a slanted surface
      QVERIFY((line.seen_mm.at(1)[p] - answer.pose * places_mm[p]).norm() < 15);
    }
    QVERIFY(child<QLabel>("line_places")->text().contains("It counts when"));
    keep_picture("guide_lines");
    // A click is a step.
    press_key(*window_, Qt::Key_Z, Qt::ControlModifier);
    QTRY_COMPARE(page_->lines().lines.front().at_rest_mm.size(), places_mm.size() - 1);
    press_key(*window_, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_COMPARE(page_->lines().lines.front().at_rest_mm.size(), places_mm.size());
    QTRY_VERIFY(!window_->undo().busy());
    // Where nothing was seen, nothing is marked.
    QTest::mouseClick(view(), Qt::LeftButton, Qt::NoModifier, view()->from_frame().map(QPointF(3, 3)).toPoint());
    QVERIFY(child<QLabel>("guide_reading")->text().startsWith("Nothing was seen"));
    QCOMPARE(page_->lines().lines.front().seen_mm.at(1).size(), places_mm.size());
    choose_language("de");
    window_->resize(1280, 720);
    const QStringList problems = test::what_does_not_fit(*window_);
    keep_picture("guide_lines_de");
    QVERIFY2(problems.isEmpty(), qPrintable(problems.join("; ")));
    choose_language("en");
    window_->resize(1600, 1000);

    // Laid by hand or marked: not both at once.
    click(child<QPushButton>("by_hand"));
    QVERIFY(!mark->isChecked());
    click(mark);
    QVERIFY(!child<QPushButton>("by_hand")->isChecked());
    click(place_button());
    QTRY_VERIFY_WITH_TIMEOUT(page_->answered(frames - 1) != nullptr && !window_->work().busy(), patience_ms);
    QVERIFY(!mark->isChecked());
    for (std::size_t f = 0; f < frames; ++f) {
      QVERIFY(page_->answered(f) != nullptr && page_->answered(f)->placement.converged);
      QVERIFY((tumour_mm(*page_->answered(f)) - truth_mm_[f]).norm() < 6);
    }
    // From where the hand laid it before, with the line.
    QSignalSpy placed(page_, &GuidePage::placed);
    click(child<QPushButton>("refine"));
    QTRY_VERIFY_WITH_TIMEOUT(!placed.isEmpty() && !window_->work().busy(), patience_ms);
    const QStringList words = told_command();
    QVERIFY(words.contains("--lines") && words[6] == "--frame");
    comes_to_what_is_shown(words);
  }

  void takes_a_line_away() {
    auto* mark = child<QPushButton>("mark_lines");
    click(mark);
    click(child<QPushButton>("remove_line"));
    QTRY_VERIFY(!window_->undo().busy());
    QVERIFY(page_->lines().lines.empty());
    QVERIFY(view()->marks().empty());
    QVERIFY(!child<QPushButton>("remove_line")->isEnabled());
    press_key(*window_, Qt::Key_Z, Qt::ControlModifier);
    QTRY_COMPARE(page_->lines().lines.size(), std::size_t{1});
    press_key(*window_, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_VERIFY(page_->lines().lines.empty());
    QTRY_VERIFY(!window_->undo().busy());
    click(mark);
  }

  void films_what_is_shown() {
    const fs::path pictures = folder_.path() / "film";
    QSignalSpy filmed(page_, &GuidePage::filmed);
    page_->film(pictures);
    QTRY_VERIFY_WITH_TIMEOUT(!filmed.isEmpty() && !window_->work().busy(), patience_ms);
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(pictures)) count += entry.is_regular_file() ? 1 : 0;
    QCOMPARE(count, std::size_t{frames});
    const QImage film(QString::fromStdString((pictures / "00003.png").string()));
    const QImage frame(QString::fromStdString((sequence_.parent_path() / "f002.jpg").string()));
    QCOMPARE(film.width(), 2 * frame.width());
    QVERIFY(film.height() > 2 * frame.height());
    QVERIFY(film.save(glisson::test::kept_pictures() + "/guide_film.png"));
    QVERIFY(child<QLabel>("guide_reading")->text().startsWith("Written"));
    QSignalSpy again(page_, &GuidePage::filmed);
    page_->film(folder_.path() / "film.mp4");
    QTRY_VERIFY_WITH_TIMEOUT(!again.isEmpty() && !window_->work().busy(), patience_ms);
    QVERIFY(fs::file_size(folder_.path() / "film.mp4") > 10'000);
  }

  void keeps_what_was_placed_when_it_is_cancelled() {
    click(place_button());
    QTRY_VERIFY_WITH_TIMEOUT(page_->answered(0) != nullptr, patience_ms);
    click(child<QPushButton>("cancel_guiding"));
    QTRY_VERIFY_WITH_TIMEOUT(!window_->work().busy(), patience_ms);
    QVERIFY(page_->answered(0)->placement.converged);
    QVERIFY(page_->answered(frames - 1) == nullptr);
    QVERIFY(place_button()->isEnabled());
  }

  void draws_nothing_that_is_not_the_answer() {
    // The same clouds in metres, and another patient's.
    const fs::path metres = folder_.path() / "metres";
    fs::copy(sequence_.parent_path(), metres);
    for (int f = 0; f < frames; ++f) {
      const fs::path file = metres / ("f00" + std::to_string(f) + ".ply");
      auto cloud = test::needed(registration_quality::read_cloud(file));
      for (auto& point : cloud.points_mm) point *= 1e-3;
      QVERIFY(geometry::write_surface(file, cloud));
    }
    open(metres / "sequence.json");
    QVERIFY(page_->answered(0) == nullptr);
    QVERIFY(view()->overlay().lines.empty());
    place_all();
    for (std::size_t f = 0; f < frames; ++f) QVERIFY(!page_->answered(f)->placement.converged);
    QVERIFY(view()->overlay().lines.empty());
    QVERIFY2(view()->said().contains("metres"), qPrintable(view()->said()));
    keep_picture("guide_refused");

    open(test::guided_sequence(folder_.path() / "other", 1, 4));
    place_all();
    const auto& other = page_->answered(0)->placement;
    qInfo("another patient: %s residual %.2f mm, deformed by %.1f mm",
          other.converged ? "taken for this one" : other.why_not.message().c_str(), other.residual_rms_mm,
          other.elastic_rms_mm);
    QCOMPARE(view()->overlay().lines.empty(), !other.converged);
  }

  void knows_again_where_it_was_laid() {
    window_->close();
    window_ = shown_window({1600, 1000});
    page_ = child<GuidePage>("guide_page");
    window_->open_path(case_);
    QTRY_VERIFY_WITH_TIMEOUT(window_->rehearsal().body() != nullptr && !window_->work().busy(), patience_ms);
    window_->go_to("guide");
    open(sequence_);
    QVERIFY(page_->hand_pose().has_value());
    QCOMPARE(page_->hand_pose()->frame, std::size_t{2});
    QVERIFY(child<QPushButton>("refine")->isEnabled());
    // It is of that sequence alone.
    open(folder_.path() / "other" / "sequence.json");
    QVERIFY(!page_->hand_pose());
  }

  void every_control_has_a_name_and_says_what_it_does() {
    open(sequence_);
    for (auto* control : page_->findChildren<QWidget*>()) {
      const bool is_control =
          qobject_cast<QAbstractButton*>(control) != nullptr || qobject_cast<QAbstractSlider*>(control) != nullptr;
      if (!is_control || !control->isVisible() || control->inherits("QTableCornerButton") ||
          control->inherits("QScrollBar"))
        continue;
      const auto* button = qobject_cast<QAbstractButton*>(control);
      const QString which = control->objectName() + " (" + control->metaObject()->className() + ")";
      QVERIFY2(!control->accessibleName().isEmpty() || (button != nullptr && !button->text().isEmpty()),
               qPrintable(which + " has no name"));
      QVERIFY2(!control->toolTip().isEmpty(), qPrintable(which + " has no tooltip"));
    }
  }

  void shuts_down_cleanly() { window_.reset(); }

 private:
  template <typename Widget>
  Widget* child(const char* name, const QObject* parent = nullptr) {
    return child_of<Widget>(parent != nullptr ? *parent : *window_, name);
  }
  static QString cli() { return QCoreApplication::applicationDirPath() + "/glisson-cli"; }
  // The last step's, for this case and sequence, with its file written.
  QStringList told_command() {
    const auto macro = test::needed(casefile::macro_of(case_));
    const auto step = std::find_if(macro.steps.rbegin(), macro.steps.rend(),
                                   [](const casefile::MacroStep& each) { return !each.commands.empty(); });
    if (macro.sequences.size() != 1 || step == macro.steps.rend()) qFatal("nothing is told");
    const casefile::Command& command = step->commands.front();
    const fs::path file = folder_.path() / command.file;
    if (!command.file.empty()) test::needed(write_text_file(file, command.document).map([] { return 0; }));
    QStringList words;
    for (const std::string& word : command.words) {
      words << QString::fromStdString(word == casefile::the_case ? case_.string()
                                      : word == "{sequence-1}"   ? sequence_.string()
                                      : word == command.file     ? file.string()
                                                                 : word);
    }
    words.back() = QString::fromStdString((folder_.path() / "told").string());
    return words;
  }
  void comes_to_what_is_shown(const QStringList& words) {
    QCOMPARE(words.front(), QString("guide"));
    QCOMPARE(QProcess::execute(cli(), words), 0);
    const Json answer = test::needed(read_json_file(fs::path(words.back().toStdString()) / "guidance.json"));
    QCOMPARE(answer.at("frames").size(), std::size_t{frames});
    for (const Json& frame : answer.at("frames")) {
      const auto f = static_cast<std::size_t>(std::stoi(frame.at("id").get<std::string>().substr(1)));
      const guidance::ElasticPlacement& shown = page_->answered(f)->placement;
      for (int k = 0; k < 16; ++k) QCOMPARE(frame.at("pose").at(k).get<double>(), shown.pose.matrix()(k / 4, k % 4));
      for (std::size_t t = 0; t < shown.target_mm.size(); ++t) {
        const Json& position_mm = frame.at("targets").at(t).at("position_mm");
        for (int axis = 0; axis < 3; ++axis) QVERIFY(position_mm.at(axis).get<double>() == shown.target_mm[t][axis]);
      }
    }
  }
  OverlayView* view() { return child<OverlayView>("guide_frame"); }
  SpaceView* space() { return child<SpaceView>("guide_space"); }
  // Points of the liver at rest that the camera and the view in space both show, and around which a cloud was seen.
  std::vector<Eigen::Vector3d> along_the_front(const Eigen::Isometry3d& pose) {
    std::vector<Eigen::Vector3d> along;
    const auto cloud = test::needed(registration_quality::read_cloud(sequence_.parent_path() / "f001.ply")).points_mm;
    for (const Eigen::Vector3d& seen : cloud) {
      const Eigen::Vector3d at_rest_mm = pose.inverse() * seen;
      const auto at = vision::project(camera(), {seen}).front();
      const QPoint pixel = pixel_in(*space(), at_rest_mm);
      const double ratio = space()->devicePixelRatioF();
      const auto pick = space()->view().pick(ratio * pixel.x(), ratio * pixel.y());
      if (!at || !space()->rect().contains(pixel) || !pick) continue;
      const bool is_shown = (pick->position_mm - at_rest_mm).norm() < 4 && std::abs(pick->normal.y()) > 0.5;
      const bool is_apart = along.empty() || (along.back() - pick->position_mm).norm() > 18;
      if (is_shown && is_apart) along.push_back(pick->position_mm);
      if (along.size() == 5) break;
    }
    std::sort(along.begin(), along.end(), [](const auto& a, const auto& b) { return a.x() < b.x(); });
    return along;
  }
  TargetTable* targets() { return child<TargetTable>("guide_targets"); }
  QPushButton* place_button() { return page_->findChild<GuidePanel*>()->findChild<QPushButton*>("primary"); }
  static void click(QWidget* widget) { QTest::mouseClick(widget, Qt::LeftButton); }
  vision::Camera camera() const { return *test::needed(registration_quality::read_sequence(sequence_)).camera; }
  Eigen::Vector3d tumour_mm(const GuidedFrame& frame) {
    const auto landmarks = test::needed(casefile::read_model(test::needed(casefile::Case::open(case_)))).landmarks;
    for (std::size_t k = 0; k < landmarks.size(); ++k) {
      if (landmarks[k].id == "tumour-1") return frame.placement.target_mm[k];
    }
    qFatal("no tumour among the landmarks");
  }
  void open(const fs::path& file) {
    QSignalSpy opened(page_, &GuidePage::opened);
    page_->open(file);
    QTRY_VERIFY_WITH_TIMEOUT(!opened.isEmpty() && !window_->work().busy(), patience_ms);
  }
  void place_all() {
    QSignalSpy placed(page_, &GuidePage::placed);
    click(place_button());
    QTRY_VERIFY_WITH_TIMEOUT(!placed.isEmpty() && !window_->work().busy(), patience_ms);
  }
  const OverlayPicture::Line& line_of(const char* structure) {
    for (const OverlayPicture::Line& line : view()->overlay().lines) {
      if (targets()->item(static_cast<int>(line.outline.structure), 0)->text().contains(structure_label(structure))) {
        return line;
      }
    }
    qFatal("no outline of %s", structure);
  }
  int doubted_rows() {
    int doubted = 0;
    for (int row = 0; row < targets()->rowCount(); ++row) doubted += targets()->item(row, 0)->font().bold() ? 1 : 0;
    return doubted;
  }
  void drag(const QPoint& by, Qt::MouseButton button) {
    const QPoint from = view()->rect().center();
    QTest::mousePress(view(), button, {}, from);
    for (int step = 1; step <= 4; ++step) {
      QMouseEvent move(QEvent::MouseMove, from + by * step / 4, view()->mapToGlobal(from + by * step / 4), Qt::NoButton,
                       button, Qt::NoModifier);
      QApplication::sendEvent(view(), &move);
    }
    QTest::mouseRelease(view(), button, {}, from + by);
    QTest::qWait(50);
  }
  void keep_picture(const char* name) {
    QTest::qWait(600);  // the view in space is drawn beside
    QVERIFY(window_->grab().save(glisson::test::kept_pictures() + "/" + name + ".png"));
  }

  TemporaryFolder folder_;
  fs::path sequence_, case_;
  std::vector<Eigen::Vector3d> truth_mm_;
  std::unique_ptr<MainWindow> window_;
  GuidePage* page_ = nullptr;
};

}  // namespace
}  // namespace glisson::widgets

int main(int argc, char** argv) { return glisson::widgets::run_test<glisson::widgets::GuideTest>(argc, argv); }

#include "guide_test.moc"

// The Rehearse workspace under the hand: the tool dragged in space by its ends, frozen, seen again, filmed; two bodies
// beside each other. Rigid tools: rehearse_rigid_test.cpp.

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QtTest>

#include "base/files.h"
#include "kept_pictures.h"
#include "probe_on_block.h"
#include "run_test.h"
#include "shown.h"
#include "support/shapes.h"
#include "vision/frame.h"
#include "widgets/main_window.h"
#include "widgets/rehearse/rehearse_panel.h"

namespace glisson::widgets {
namespace {

namespace fs = std::filesystem;

class RehearseTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { window_ = shown_window({1400, 950}); }

  // Each begins with a probe in the middle of the free end, pushing with 1 N.
  void init() {
    show_probe_on_block(*window_);
    look_at_free_end();
    QTest::qWait(50);
  }

  // The reference body is made for the first tool. Until it is there the patient's answer is on screen, to the bit the
  // one that is then compared, and the light says that more is being solved for.
  void the_first_tool_shows_the_patient_and_then_compares() {
    window_->show_patient(
        block_patient({6, 4, 4}, {{"tumour-1", {100, 40, 40}}},
                      {{"tumour-1", std::make_shared<geometry::Surface>(test::sphere_surface(10, 2, {100, 40, 40}))}}));
    QVERIFY(!rehearsal().body()->reference_is_made());
    struct Seen {
      rehearsal::RehearsalState state;
      Solving solving;
    };
    std::vector<Seen> seen;
    const auto watching = connect(&rehearsal(), &LiveRehearsal::state_changed, this, [&] {
      if (rehearsal().state()) seen.push_back({*rehearsal().state(), rehearsal().solving()});
    });
    QSignalSpy placed(&rehearsal(), &LiveRehearsal::placed);
    rehearsal().hold({"palpation-probe", {120, 40, 40}, {1, 0, 0}, 15, {-1, 0, 0}, 1.0});
    QVERIFY(placed.wait(patience_ms));
    disconnect(watching);
    QCOMPARE(seen.size(), std::size_t{2});
    QVERIFY(!seen[0].state.reference && seen[0].solving == Solving::solving);
    QVERIFY(seen[1].state.reference && seen[1].solving == Solving::solved);
    QVERIFY(seen[0].state.patient.surface_mm == seen[1].state.patient.surface_mm);
    // Recorded is what was compared, once; the next force is compared at once.
    QCOMPARE(rehearsal().track().moments().size(), std::size_t{1});
    QVERIFY(rehearsal().track().moments()[0].reference_off_mm.has_value());
    rehearsal().set_force_N(0.5);
    QCOMPARE(rehearsal().solving(), Solving::solved);
    QVERIFY(rehearsal().state()->reference.has_value());
  }

  // A force that is changed before the reference body is there changes what is shown, and is what is compared then.
  void a_force_changed_meanwhile_is_the_one_compared() {
    window_->show_patient(block_patient({8, 6, 6}, {{"tumour-1", {100, 40, 40}}}, {}));
    QSignalSpy placed(&rehearsal(), &LiveRehearsal::placed);
    rehearsal().hold({"palpation-probe", {120, 40, 40}, {1, 0, 0}, 15, {-1, 0, 0}, 1.0});
    QTRY_VERIFY_WITH_TIMEOUT(rehearsal().state().has_value(), patience_ms);
    rehearsal().set_force_N(2.0);
    QVERIFY(placed.count() > 0 || placed.wait(patience_ms));
    QCOMPARE(rehearsal().solving(), Solving::solved);
    QVERIFY(rehearsal().state()->reference.has_value());
    QCOMPARE(rehearsal().state()->force_N.norm(), 2.0);
  }

  void the_tool_follows_the_surface_under_the_mouse() {
    rehearsal().set_force_N(0.05);  // so that the place under the mouse is hardly elsewhere than at rest
    drag(pixel_of(touched_mm()), pixel_of({120, 55, 50}));
    QTRY_COMPARE_WITH_TIMEOUT(rehearsal().solving(), Solving::solved, patience_ms);
    const Eigen::Vector3d at_mm = rehearsal().tool_center_mm();
    QVERIFY(std::abs(at_mm.x() - 120) < 1e-6);
    QVERIFY((at_mm - Eigen::Vector3d(120, 55, 50)).norm() < 2.5);
    QVERIFY(rehearsal().state().has_value());
  }

  void dragging_the_arrow_changes_force_and_direction() {
    // The push comes from the left of the patient; its free end is out there.
    const double length_mm = arrow_length_mm(1.0);
    const Eigen::Vector3d touch_mm = touched_mm();
    const Eigen::Vector3d free_end_mm = touch_mm + length_mm * Eigen::Vector3d(1, 0, 0);
    const Eigen::Vector3d wanted_mm = touch_mm + arrow_length_mm(2.0) * Eigen::Vector3d(0.8, 0, 0.6);
    // In parallel with the picture: look along y, so that x and z are what the drag changes.
    space().look_from(scene::PatientView::anterior);
    QTest::qWait(50);
    drag(pixel_of(free_end_mm), pixel_of(wanted_mm));
    QVERIFY2(std::abs(rehearsal().force_N() - 2.0) < 0.25, qPrintable(QString::number(rehearsal().force_N())));
    QVERIFY((rehearsal().direction() - Eigen::Vector3d(-0.8, 0, -0.6)).norm() < 0.12);
    QVERIFY(std::abs(child<QDoubleSpinBox>("force")->value() - rehearsal().force_N()) < 0.051);
    QCOMPARE(child<QComboBox>("direction")->currentText(), "As the arrow was dragged");
  }

  void nothing_moves_the_tool_while_it_is_frozen() {
    QTest::mouseClick(child<QPushButton>("freeze"), Qt::LeftButton);
    QVERIFY(rehearsal().frozen());
    const Eigen::Vector3d before_mm = rehearsal().tool_center_mm();
    drag(pixel_of({120, 40, 40}), pixel_of({120, 60, 50}));
    QVERIFY((rehearsal().tool_center_mm() - before_mm).norm() < 1e-12);
    QVERIFY(!child<QDoubleSpinBox>("force")->isEnabled());
    QTest::mouseClick(child<QPushButton>("freeze"), Qt::LeftButton);
    QVERIFY(child<QDoubleSpinBox>("force")->isEnabled());
  }

  void any_moment_is_seen_again_to_the_bit() {
    std::vector<std::vector<Eigen::Vector3d>> shapes;
    for (const double force_N : {1.0, 1.5, 2.5}) {
      rehearsal().set_force_N(force_N);
      shapes.push_back(rehearsal().state()->patient.surface_mm);
      QTest::qWait(120);
    }
    const auto& moments = rehearsal().track().moments();
    QCOMPARE(moments.size(), std::size_t{3});
    QVERIFY(moments[2].time_s > moments[1].time_s);
    // By keys on the slider, back to the beginning.
    auto* time = child<QSlider>("track_time");
    time->setFocus();
    QTest::keyClick(time, Qt::Key_Home);
    QCOMPARE(rehearsal().shown_moment(), std::optional<std::size_t>(0));
    QVERIFY(rehearsal().state()->patient.surface_mm == shapes[0]);
    QVERIFY(child<QLabel>("track_clock")->text().startsWith("0.0 of"));
    QTest::keyClick(time, Qt::Key_End);
    QVERIFY(!rehearsal().shown_moment());
    QVERIFY(rehearsal().state()->patient.surface_mm == shapes[2]);
    // Play runs through it in its own time and ends with now.
    bool played = false;
    const auto watching = connect(&rehearsal(), &LiveRehearsal::state_changed, this,
                                  [&] { played = played || rehearsal().shown_moment().has_value(); });
    QTest::mouseClick(child<QPushButton>("play_track"), Qt::LeftButton);
    QTRY_VERIFY(played);
    disconnect(watching);
    QTRY_VERIFY_WITH_TIMEOUT(!rehearsal().shown_moment(), patience_ms);
    QVERIFY(!child<QPushButton>("play_track")->isChecked());
  }

  void films_what_the_view_shows() {
    for (const double force_N : {1.0, 2.0, 3.0}) {
      rehearsal().set_force_N(force_N);
      QTest::qWait(100);
    }
    const TemporaryFolder folder;
    const double length_s = rehearsal().track().length_s();
    auto* panel = window_->findChild<RehearsePanel*>();
    QSignalSpy told(panel, &RehearsePanel::said);
    panel->track().make_movie(folder.path() / "rehearsal.mp4");
    QVERIFY(told.wait(patience_ms));
    auto movie = vision::FrameSource::open(folder.path() / "rehearsal.mp4").value();
    int frames = 0;
    std::optional<vision::Frame> first, last;
    while (auto frame = movie.next().value()) {
      if (frames++ == 0) first = frame;
      last = frame;
    }
    QVERIFY(std::abs(frames - MovieMaker::frames_per_second * (length_s + 0.5)) < 2.5);
    QVERIFY(first->rgb != last->rgb);
    QVERIFY(std::abs(last->width - space().width()) <= 1);
    QVERIFY(told.last().first().toString().startsWith("Written:"));
    // Below it stands what the answer is worth: white on a dark band.
    const auto brightest_below = [](const vision::Frame& frame) {
      const auto band = static_cast<std::size_t>(3 * frame.width * (frame.height / 20));
      return *std::max_element(frame.rgb.end() - static_cast<std::ptrdiff_t>(band), frame.rgb.end());
    };
    QVERIFY(brightest_below(*last) > 180);
    // Stopped, it leaves nothing and says so.
    panel->track().make_movie(folder.path() / "stopped.mp4");
    QTest::mouseClick(child<QPushButton>("track_movie"), Qt::LeftButton);
    QVERIFY(told.last().first().toString().startsWith("Stopped."));
    QVERIFY(!fs::exists(folder.path() / "stopped.mp4"));
  }

  void two_bodies_turn_together() {
    QPushButton* beside = nullptr;
    for (QPushButton* button : window_->findChildren<QPushButton*>()) {
      if (button->text() == "Side by side") beside = button;
    }
    QVERIFY(beside != nullptr);
    QTest::mouseClick(beside, Qt::LeftButton);
    SpaceView& second = window_->views().second_space();
    QTRY_VERIFY(second.isVisible());
    QTest::qWait(100);
    for (SpaceView* by_hand : {&space(), &second}) {
      const QPoint corner(20, 60);
      drag_in(*by_hand, corner, corner + QPoint(50, 20));
      QVERIFY((space().view().camera().sight - second.view().camera().sight).norm() < 1e-12);
    }
    // The atlas is twice as stiff, so the two pictures differ.
    QTest::qWait(100);
    QVERIFY(space().picture() != second.picture());
    for (QPushButton* button : window_->findChildren<QPushButton*>()) {
      if (button->text() == "Patient") QTest::mouseClick(button, Qt::LeftButton);
    }
    QVERIFY(!second.isVisible());
    QCOMPARE(window_->views().view_layout(), ViewLayout::square);
  }

  void the_table_of_a_rehearsal_names_its_units() {
    rehearsal().set_force_N(2.0);
    const std::string csv = rehearsal().track().csv({"tumour-1", "hilum"});
    const QStringList lines = QString::fromStdString(csv).trimmed().split('\n');
    QCOMPARE(lines.front(),
             "time_s,tools,force_N,max_displacement_mm,atlas_off_mm,tumour-1_mm,hilum_mm,state,largest_strain,"
             "inverted_cells,error_bound_mm");
    QCOMPARE(lines.size(), 3);
    QCOMPARE(lines.back().split(',').at(2), "2.0000");
    QCOMPARE(lines.back().split(',').size(), 11);
    QVERIFY(lines.back().endsWith(','));  // small deformations have no bound
  }

  void says_what_an_answer_is_worth_and_prints_none_that_may_not_be_used() {
    auto* sign = child<QLabel>("solving_sign");
    auto* trouble = child<QLabel>("solving_trouble");
    const auto table_text = [this](int column) {
      return window_->findChild<LandmarkTable*>()->item(0, column)->text();
    };
    const double within_N = *rehearsal().force_within_the_model_N(20);
    // The colour bar's upper end, which has numbers beside it.
    const auto bar_pixels = [this] {
      QTest::qWait(400);
      const QImage picture = space().picture();
      int count = 0;
      for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
          const QColor at(picture.pixel(x, y));
          count += std::abs(at.red() - 253) + std::abs(at.green() - 231) + std::abs(at.blue() - 37) < 30 ? 1 : 0;
        }
      }
      return count;
    };
    child<QCheckBox>("by_displacement")->setChecked(true);
    rehearsal().set_force_N(0.9 * within_N);
    QVERIFY(bar_pixels() > 20);
    QVERIFY(sign->text().contains("Solved"));
    QVERIFY(!trouble->isVisible());
    rehearsal().set_force_N(1.2 * within_N);
    QVERIFY(sign->text().contains("Outside of the model"));
    QVERIFY(trouble->text().contains("beyond 20 %"));
    QVERIFY(table_text(LandmarkTable::moves_column).toDouble() > 0);
    rehearsal().set_force_N(40 * within_N);
    QVERIFY(rehearsal().state()->validity.inverted_cells > 0);
    QVERIFY(sign->text().contains("Not to be used"));
    QCOMPARE(bar_pixels(), 0);
    child<QCheckBox>("by_displacement")->setChecked(false);
    QVERIFY(child<QLabel>("summary")->text().startsWith("– Not to be used: cells turned inside out"));
    QCOMPARE(table_text(LandmarkTable::moves_column), "–");
    QCOMPARE(table_text(LandmarkTable::apart_column), "–");
    const QStringList lines =
        QString::fromStdString(rehearsal().track().csv({"tumour-1", "hilum"})).trimmed().split('\n');
    QCOMPARE(lines.back().split(',').mid(3, 5), (QStringList{"", "", "", "", "unusable"}));
    QVERIFY(lines[lines.size() - 2].contains(",outside-of-the-model,0.2"));
    const std::string landmarks = landmark_csv(*rehearsal().state());
    QVERIFY(landmarks.find("tumour-1,100.000,40.000,40.000,,,,,,unusable,") != std::string::npos);
  }

  void begins_with_a_force_that_the_model_bears_and_marks_where_it_ends() {
    rehearsal().take_tool_away();
    auto* tool = child<QComboBox>("tool");
    tool->setFocus();
    for (const Qt::Key key : {Qt::Key_End, Qt::Key_Home}) QTest::keyClick(tool, key);
    QCOMPARE(tool->currentText(), "Nathanson liver retractor");
    window_->findChild<ToolControls*>()->place_at({120, 40, 40}, {1, 0, 0});
    QTRY_COMPARE_WITH_TIMEOUT(rehearsal().solving(), Solving::solved, patience_ms);
    QCOMPARE(rehearsal().state()->validity.state(), mechanics::AnswerState::within);
    QVERIFY(rehearsal().force_N() > 0 && rehearsal().force_N() <= 2.0);
    auto* slider = child<MarkedSlider>("force_slider");
    QVERIFY(slider->mark().has_value());
    slider->setValue(static_cast<int>(*slider->mark()) + 2);
    QVERIFY(child<QLabel>("solving_sign")->text().contains("Outside of the model"));
    // A force that nobody chose gives way to what the model bears, to a tenth of a newton.
    PlacedTool strong = rehearsal().tools().back();
    strong.force_N = 9;
    rehearsal().hold_within_the_model(strong);
    QTRY_COMPARE_WITH_TIMEOUT(rehearsal().solving(), Solving::solved, patience_ms);
    QCOMPARE(rehearsal().state()->validity.state(), mechanics::AnswerState::within);
    QVERIFY(std::abs(child<QDoubleSpinBox>("force")->value() - rehearsal().force_N()) < 1e-9);
    QVERIFY2(std::abs(*slider->mark() - slider->value()) <= 1.0,
             qPrintable(QString("mark %1, value %2").arg(*slider->mark()).arg(slider->value())));
  }

  void places_the_tool_at_the_crosshair_by_key() {
    window_->views().set_crosshair({60, -5, 40});
    press_key(*window_, Qt::Key_T, Qt::ControlModifier);
    QTRY_COMPARE_WITH_TIMEOUT(rehearsal().solving(), Solving::solved, patience_ms);
    // The nearest triangle's middle; bricks are 20 mm wide.
    QVERIFY(std::abs(rehearsal().tool_center_mm().y()) < 1e-9);
    QVERIFY((rehearsal().tool_center_mm() - Eigen::Vector3d(60, 0, 40)).norm() < 15);
  }

  // With no force nothing moves: what differs in the picture is the instrument.
  void each_tool_looks_like_itself() {
    rehearsal().set_touch(Touch::patch);
    space().look_from(scene::PatientView::surgeon);
    scene::Camera from_afar = space().view().camera();
    from_afar.visible_height_mm = 450;
    space().view().set_camera(from_afar);
    std::vector<QImage> pictures;
    for (const char* preset : {"palpation-probe", "grasper", "nathanson-retractor"}) {
      rehearsal().hold_all({});
      rehearsal().hold({preset, {60, 0, 40}, {0, -1, 0}, 10, {0, 1, 0}, 0.0});
      QTRY_COMPARE_WITH_TIMEOUT(rehearsal().solving(), Solving::solved, patience_ms);
      pictures.push_back(space().picture());
      QVERIFY(pictures.back().save(glisson::test::kept_picture((std::string("tool-") + preset + ".png").c_str())));
    }
    QVERIFY(pictures[0] != pictures[1]);
    QVERIFY(pictures[1] != pictures[2]);
    QVERIFY(pictures[0] != pictures[2]);
  }

  void cleanupTestCase() { window_.reset(); }

 private:
  SpaceView& space() { return window_->views().space(); }
  LiveRehearsal& rehearsal() { return window_->rehearsal(); }

  template <typename Widget>
  Widget* child(const char* name) {
    return child_of<Widget>(*window_, name);
  }

  // A little from above and the front, so that the arrow's two ends are seen apart.
  void look_at_free_end() {
    space().look_from(scene::PatientView::left);
    space().view().set_camera(scene::turned(space().view().camera(), 35, 10));
    space().redraw();
  }

  QPoint pixel_of(const Eigen::Vector3d& place_mm) {
    const Eigen::Vector2d at = space().view().pixel_of(place_mm) / space().devicePixelRatioF();
    return {static_cast<int>(std::lround(at.x())), static_cast<int>(std::lround(at.y()))};
  }

  // Where the tissue under the tool is now: the surface's point nearest to it at rest has gone that far.
  Eigen::Vector3d touched_mm() {
    const auto& rest_mm = rehearsal().body()->surface().points_mm;
    const auto& now_mm = rehearsal().state()->patient.surface_mm;
    const Eigen::Vector3d at_mm = rehearsal().tool_center_mm();
    std::size_t nearest = 0;
    for (std::size_t p = 1; p < rest_mm.size(); ++p) {
      if ((rest_mm[p] - at_mm).norm() < (rest_mm[nearest] - at_mm).norm()) nearest = p;
    }
    return at_mm + now_mm[nearest] - rest_mm[nearest];
  }

  static void drag_in(SpaceView& view, const QPoint& from, const QPoint& to) {
    QTest::mousePress(&view, Qt::LeftButton, Qt::NoModifier, from);
    for (int step = 1; step <= 5; ++step) QTest::mouseMove(&view, from + (to - from) * step / 5, 20);
    QTest::mouseRelease(&view, Qt::LeftButton, Qt::NoModifier, to);
  }
  void drag(const QPoint& from, const QPoint& to) { drag_in(space(), from, to); }

  std::unique_ptr<MainWindow> window_;
};

}  // namespace
}  // namespace glisson::widgets

int main(int argc, char** argv) { return glisson::widgets::run_test<glisson::widgets::RehearseTest>(argc, argv); }

#include "rehearse_test.moc"

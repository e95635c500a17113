// The tools of the views under the hand: measuring, grey values, turned slices, layouts, by mouse and by keys.
//
// The volume is 40 x 32 x 32 voxels of 4 mm, its grey a slope along x, in Hounsfield units or in none.

#include <QComboBox>
#include <QSignalSpy>
#include <QTableWidget>
#include <QToolButton>
#include <QtTest>

#include "base/files.h"
#include "block_patient.h"
#include "kept_pictures.h"
#include "modelled_case.h"
#include "run_test.h"
#include "shown.h"
#include "support/shapes.h"
#include "widgets/main_window.h"
#include "widgets/views/measure_list.h"

namespace glisson::widgets {
namespace {

std::shared_ptr<imaging::Volume> slope(const std::string& unit) {
  auto volume = std::make_shared<imaging::Volume>();
  volume->grid.size = {40, 32, 32};
  volume->grid.spacing_mm = {4, 4, 4};
  volume->grid.origin_mm = {-20, -24, -24};
  volume->unit = unit;
  volume->values.resize(volume->grid.voxels());
  for (std::size_t k = 0; k < volume->values.size(); ++k) volume->values[k] = static_cast<float>(k % 40);
  return volume;
}

class ViewsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { window_ = shown_window({1500, 950}); }

  void init() {
    static int patients = 0;
    Patient patient = block_patient({3, 2, 2}, {{"hilum", {8, 40, 40}}}, {});
    patient.name = "Block " + std::to_string(++patients);  // another patient: nothing is left of the one before
    patient.anatomy = slope("HU");
    window_->show_patient(patient);
    views().set_layout(ViewLayout::square);
    views().straighten();
    views().set_crosshair({60, 40, 40});
    slice().setFocus();
    QTest::qWait(50);
  }

  // Labels that were just imported come into space after the view was asked to frame them; a turned view stays.
  void frames_the_first_that_comes_into_an_empty_space() {
    SpaceView& space = views().space();
    space.show_scene({});
    space.frame_all();
    QVERIFY(space.view().camera().visible_height_mm < 10);
    scene::Scene block;
    block.surfaces.emplace_back();
    block.surfaces.back().name = "liver";
    block.surfaces.back().surface = block_patient({3, 2, 2}, {}, {}).structures.front().surface;
    space.show_scene(block);
    const geometry::Box box = geometry::bounding_box(block.surfaces.back().surface->points_mm);
    QVERIFY(space.view().camera().visible_height_mm > (box.max_mm - box.min_mm).minCoeff());
    QTest::keyClick(&space, Qt::Key_Left);
    const scene::Camera turned = space.view().camera();
    space.show_scene({});
    space.show_scene(block);
    QVERIFY(space.view().camera().sight == turned.sight);
  }

  // Off until somebody asks for it, and gone again with a second click.
  void shows_the_scan_behind_the_patient() {
    Patient patient = block_patient({3, 2, 2}, {{"hilum", {8, 40, 40}}}, {});
    patient.name = "Block with a spine";
    auto scan = slope("HU");
    for (std::size_t k = 0; k < scan->values.size(); ++k) {
      if (k / 40 % 32 > 24) scan->values[k] = 700;  // behind the block
    }
    patient.anatomy = scan;
    window_->show_patient(patient);
    auto* button = child<QToolButton>("scan_behind");
    QVERIFY(button->isEnabled() && !button->isChecked());
    SpaceView& space = views().space();
    const QImage before = space.picture();
    const scene::Camera camera = space.view().camera();
    button->click();
    const QImage with = space.picture();
    QVERIFY(with != before);
    QVERIFY(space.view().camera().focus_mm == camera.focus_mm);
    qInfo("a frame of %d x %d with the scan behind: %.1f ms, by %s", space.width(), space.height(),
          space.last_frame_ms(), qPrintable(space.drawn_by()));
    QVERIFY(window_->grab().save(glisson::test::kept_picture("views-scan-behind.png")));
    button->click();
    QVERIFY(space.picture() == before);
    patient.anatomy = nullptr;
    patient.name = "Block without images";
    window_->show_patient(patient);
    QVERIFY(!button->isEnabled());
  }

  // However coarse it was drawn while it moved.
  void a_shape_that_came_to_rest_is_drawn_finely() {
    views().set_layout(ViewLayout::one);
    views().space().setFocus();
    views().set_layout(ViewLayout::one);
    QTest::qWait(50);
    SpaceView& space = views().space();
    const QImage before = space.picture();
    for (int k = 0; k < 5; ++k) {
      space.shape_moved();
      space.redraw();
      QTest::qWait(20);
    }
    space.shape_moved();
    QVERIFY(space.picture() == before);  // nor does haste show in what leaves the screen, as a film's pictures do
    QTest::qWait(600);
    QVERIFY(space.picture() == before);
  }

  void measures_a_distance_in_a_slice_by_two_clicks() {
    key(Qt::Key_D);
    click_at({40, 20, 40});
    click_at({70, 60, 40});
    QCOMPARE(list().rowCount(), 1);
    QVERIFY(list().isVisible());
    // 30 and 40 mm across: 50 mm, within what a pixel spans each way.
    const double value_mm = value(0, " mm");
    QVERIFY2(std::abs(value_mm - 50) < 2 * slice().view().camera().visible_height_mm / slice().height(),
             qPrintable(list().item(0, 1)->text()));
    // The crosshair was not moved by these clicks.
    QVERIFY((slice().crosshair_mm() - Eigen::Vector3d(60, 40, 40)).norm() < 1e-9);
  }

  void measures_an_angle_and_a_ball_by_keys_at_the_crosshair() {
    const auto point = [this](const Eigen::Vector3d& at_mm) {
      views().set_crosshair(at_mm);
      QTest::keyClick(&slice(), Qt::Key_Return);
    };
    key(Qt::Key_A);
    point({80, 40, 40});
    point({60, 40, 40});
    point({60, 60, 60});
    key(Qt::Key_B);
    point({60, 40, 40});
    point({60, 40, 50});
    QCOMPARE(list().rowCount(), 2);
    QVERIFY(std::abs(value(0, "°") - 90) < 0.05);
    QVERIFY(std::abs(value(1, " ml") - 4.19) < 0.05);  // 4/3 pi 1 cm^3
    // Escape gives up one that was begun; Delete takes a finished one away.
    key(Qt::Key_D);
    point({60, 40, 40});
    QTest::keyClick(&slice(), Qt::Key_Escape);
    QCOMPARE(list().rowCount(), 2);
    list().setFocus();
    list().selectRow(0);
    QTest::keyClick(&list(), Qt::Key_Delete);
    QCOMPARE(list().rowCount(), 1);
    QVERIFY(list().item(0, 0)->text().contains("Ball"));
  }

  void a_point_is_dragged_elsewhere() {
    key(Qt::Key_D);
    click_at({40, 20, 40});
    click_at({70, 60, 40});
    drag(pixel_of({70, 60, 40}), pixel_of({70, 20, 40}));
    QVERIFY(std::abs(value(0, " mm") - 30) < 2);
  }

  void lists_the_volume_of_a_structure() {
    auto* menu = child<QToolButton>("measure_structure")->menu();
    menu->actions().front()->trigger();
    QCOMPARE(list().rowCount(), 1);
    QCOMPARE(list().item(0, 1)->text(), "768.0 ml");
  }

  void grey_values_have_presets_where_they_are_hounsfield_units() {
    auto* choice = child<QComboBox>("grey_window");
    const auto* told = child<QLabel>("window_told");
    QCOMPARE(choice->currentText(), "Liver");  // what a CT opens with
    QCOMPARE(told->text(), "W 160  L 60");
    choice->setFocus();
    QTest::keyClick(choice, Qt::Key_Up);
    QCOMPARE(choice->currentText(), "Abdomen");
    QCOMPARE(told->text(), "W 400  L 40");
    for (SliceView* each : views().slices()) {
      QCOMPARE(each->window_center(), 40.0);
      QCOMPARE(each->window_width(), 400.0);
    }
    // By key, on to the next; what a person chose outlives a change of what is shown.
    key(Qt::Key_W);
    QCOMPARE(choice->currentText(), "Liver");
    window_->findChild<StudyPanel*>();
    Q_EMIT window_->findChild<StudyPanel*>()->structure_shown("liver", false);
    QCOMPARE(slice().window_width(), 160.0);
    // A drag with the right button: wider to the right.
    QTest::mousePress(&slice(), Qt::RightButton, Qt::NoModifier, {60, 60});
    move_pressed({120, 60}, Qt::RightButton);
    QTest::mouseRelease(&slice(), Qt::RightButton, Qt::NoModifier, {120, 60});
    QVERIFY(slice().window_width() > 200);
    QCOMPARE(choice->currentText(), "Own");
    QCOMPARE(told->text(),
             QString("W %1  L %2").arg(slice().window_width(), 0, 'f', 0).arg(slice().window_center(), 0, 'f', 0));
    // Without units there is the automatic window alone.
    Patient other = block_patient({3, 2, 2}, {}, {});
    other.name = "MR";
    other.anatomy = slope("");
    window_->show_patient(other);
    key(Qt::Key_W);
    QCOMPARE(choice->currentText(), "Automatic");
  }

  void grey_values_are_kept_when_the_case_is_read_again_and_for_each_image() {
    Patient patient = block_patient({3, 2, 2}, {{"hilum", {8, 40, 40}}}, {});
    patient.name = "Read twice";
    patient.anatomy = slope("HU");
    patient.stiffness = slope("kPa");
    window_->show_patient(patient);
    views().set_window(17, 9);
    auto* image = child<QComboBox>("slice_image");
    image->setFocus();
    QTest::keyClick(image, Qt::Key_Down);
    QVERIFY(slice().window_width() != 9.0);  // an image of its own
    views().set_window(3, 4);
    QTest::keyClick(image, Qt::Key_Up);
    QCOMPARE(slice().window_center(), 17.0);
    QCOMPARE(slice().window_width(), 9.0);
    QTest::keyClick(image, Qt::Key_Down);
    QCOMPARE(slice().window_width(), 4.0);
    patient.anatomy = slope("HU");  // the same patient after a change
    window_->show_patient(patient);
    QCOMPARE(slice().window_width(), 9.0);
    patient.name = "Another";
    window_->show_patient(patient);
    QVERIFY(slice().window_width() != 9.0);
  }

  // NIfTI names no unit: air and soft tissue tell a CT.
  void a_ct_without_a_unit_is_known_by_its_values() {
    const auto ct = slope("");
    for (std::size_t k = 0; k < ct->values.size(); ++k)
      ct->values[k] = k % 3 == 0 ? -1000.0F : 40.0F + static_cast<float>(k % 50);
    Patient patient = block_patient({3, 2, 2}, {}, {});
    patient.name = "CT as NIfTI";
    patient.anatomy = ct;
    window_->show_patient(patient);
    QCOMPARE(child<QComboBox>("grey_window")->currentText(), "Liver");
    QCOMPARE(slice().window_width(), 160.0);
    const auto mr = slope("");
    for (float& value : mr->values) value *= 30;
    QVERIFY(!in_hounsfield_units(*mr));
  }

  // Also by a window that opens the case another day.
  void grey_values_are_kept_for_the_case() {
    const TemporaryFolder folder;
    const auto of_case = [&](const char* name) {
      Patient patient = block_patient({3, 2, 2}, {}, {});
      patient.name = name;
      patient.folder = folder.path() / name;
      std::filesystem::create_directories(patient.folder);
      patient.anatomy = slope("HU");
      return patient;
    };
    window_->show_patient(of_case("kept"));
    QCOMPARE(slice().window_width(), 160.0);
    views().set_window(17, 9);
    window_->show_patient(of_case("other"));
    QCOMPARE(slice().window_width(), 160.0);
    const auto another_day = shown_window();
    another_day->show_patient(of_case("kept"));
    QCOMPARE(another_day->views().window().center, 17.0);
    QCOMPARE(another_day->views().window().width, 9.0);
    QCOMPARE(child_of<QComboBox>(*another_day, "grey_window")->currentText(), "Own");
  }

  void a_picture_for_paper_has_smooth_edges_and_the_view_stays_as_it_is() {
    SpaceView& space = views().space();
    const QImage shown = space.picture();
    const Eigen::Vector2d before = space.view().pixel_of({120, 40, 40});
    const QImage smooth = space.smooth_picture();
    QCOMPARE(smooth.size(), shown.size());
    QVERIFY(smooth != shown);
    QVERIFY((space.view().pixel_of({120, 40, 40}) - before).norm() < 1e-9);
    QTest::qWait(100);
    QVERIFY(space.picture() == shown);
  }

  // A gall bladder beside the liver: in every workspace, in its list as fixed, and gone when it is unticked.
  void structures_outside_of_the_model_are_drawn() {
    Patient patient = block_patient({3, 2, 2}, {}, {});
    patient.name = "With a gall bladder";
    patient.around = {{"gallbladder",
                       std::make_shared<geometry::Surface>(glisson::test::sphere_surface(14, 2, {60, -30, 40})), 11.5,
                       true}};
    window_->show_patient(patient);
    auto* structures = child<QTreeWidget>("structures");
    QCOMPARE(structures->topLevelItemCount(), 2);
    QTreeWidgetItem* row = structures->topLevelItem(1);
    QCOMPARE(row->text(0), "Gallbladder (fixed)");
    QVERIFY(row->toolTip(0).contains("does not move"));
    views().space().look_from(scene::PatientView::anterior);
    for (const char* workspace : {"model", "rehearse", "resect"}) {
      window_->go_to(workspace);
      row->setCheckState(0, Qt::Checked);
      const int with = greenish(views().space().picture());
      QVERIFY2(with > 500, qPrintable(QString("%1: %2").arg(workspace).arg(with)));
      row->setCheckState(0, Qt::Unchecked);
      QVERIFY(greenish(views().space().picture()) < with / 10);
    }
    QTest::mouseClick(child<QPushButton>("cut_through_crosshair"), Qt::LeftButton);
    row->setCheckState(0, Qt::Checked);
    QVERIFY(greenish(views().space().picture()) > 500);
    window_->go_to("rehearse");
  }

  void structures_outside_of_the_model_come_with_the_case() {
    const TemporaryFolder parent;
    const auto folder = test::modelled_case(parent.path());
    QVERIFY(test::save_ball(folder, "gallbladder", 4).has_value());
    const auto loaded = load_patient(folder, {});
    QVERIFY(loaded.has_value());
    QCOMPARE(loaded->structures.size(), std::size_t{2});  // liver and tumour, of the model
    QCOMPARE(loaded->around.size(), std::size_t{1});
    QCOMPARE(loaded->around.front().name, std::string("gallbladder"));
    QVERIFY(loaded->around.front().fixed);
    QVERIFY(std::abs(loaded->around.front().volume_ml - 0.27) < 0.1);  // a ball of 4 mm
  }

  // As much is seen after two views stood side by side as before, though the camera was turned in between.
  void the_patient_is_as_large_after_side_by_side_as_before() {
    SpaceView& space = views().space();
    space.frame_all();
    QTest::qWait(50);
    const double before_mm = space.view().camera().visible_height_mm;
    views().show_second_space(true);
    QTRY_VERIFY(space.width() < space.height());
    space.setFocus();
    QTest::keyClick(&space, Qt::Key_Left);
    const double beside_mm = space.view().camera().visible_height_mm;
    QVERIFY(beside_mm > 1.2 * before_mm);
    views().show_second_space(false);
    QTRY_VERIFY(space.width() > space.height());
    QTest::qWait(50);
    QVERIFY2(std::abs(space.view().camera().visible_height_mm / before_mm - 1) < 0.25,
             qPrintable(QString("%1 %2").arg(space.view().camera().visible_height_mm).arg(before_mm)));
  }

  void knobs_tilt_the_other_slices_and_letters_follow() {
    // The knobs of the coronal slice turn the transverse and the sagittal one about the line of sight.
    SliceView& coronal = views().slice(SliceDirection::coronal);
    const scene::Camera before = coronal.view().camera();
    const QPointF center = pixel_in(coronal, {60, 40, 40});
    const double reach = 0.34 * std::min(coronal.width(), coronal.height());
    QTest::mouseMove(&coronal, QPoint(20, 20));
    const double quarter = EIGEN_PI / 6;
    const QPointF from = center + QPointF(reach, 0);
    const QPointF to = center + reach * QPointF(std::cos(quarter), std::sin(quarter));
    drag_in(coronal, from.toPoint(), to.toPoint());
    SliceView& transverse = views().slice(SliceDirection::transverse);
    const double tilt_deg = std::acos(std::abs(transverse.normal().z())) * 180 / EIGEN_PI;
    QVERIFY2(std::abs(tilt_deg - 30) < 2, qPrintable(QString::number(tilt_deg)));
    QVERIFY(std::abs(transverse.normal().y()) < 1e-9);
    QVERIFY((coronal.normal() - Eigen::Vector3d::UnitY()).norm() < 1e-9);
    // This picture stayed; the line on the screen went with the hand: clockwise, the patient's left end down.
    QVERIFY((coronal.view().camera().up - before.up).norm() < 1e-9);
    const Eigen::Vector3d along = transverse.normal().cross(coronal.view().camera().sight).normalized();
    QVERIFY(along.x() * along.z() < 0);
    // All three stand at right angles to each other.
    QVERIFY((transverse.axes().transpose() * transverse.axes() - Eigen::Matrix3d::Identity()).norm() < 1e-9);
    child<QAction>("straight")->trigger();
    QVERIFY((transverse.normal() - Eigen::Vector3d::UnitZ()).norm() < 1e-12);
  }

  void turns_to_the_surgeons_side_and_back() {
    key(Qt::Key_R);
    const scene::Camera surgeon = scene::look_from(scene::PatientView::surgeon, {{0, 0, 0}, {1, 1, 1}}, 1);
    const scene::Camera coronal = views().slice(SliceDirection::coronal).view().camera();
    QVERIFY((coronal.sight - surgeon.sight).norm() < 1e-9);
    QVERIFY((coronal.up - surgeon.up).norm() < 1e-9);
    QTest::qWait(50);
    QVERIFY(views().slice(SliceDirection::coronal).picture().width() > 0);
    key(Qt::Key_0);
    QVERIFY((views().slice(SliceDirection::coronal).normal() - Eigen::Vector3d::UnitY()).norm() < 1e-12);
  }

  void a_picture_turns_in_its_plane_by_mouse_and_by_keys() {
    QTest::keyClick(&slice(), Qt::Key_BracketRight);
    QCOMPARE(slice().roll_deg(), 5.0);
    QTest::keyClick(&slice(), Qt::Key_Home);
    QCOMPARE(slice().roll_deg(), 0.0);
    const QPointF center = pixel_in(slice(), {60, 40, 40});
    QTest::mousePress(&slice(), Qt::LeftButton, Qt::ControlModifier, (center + QPointF(80, 0)).toPoint());
    move_pressed((center + QPointF(0, 80)).toPoint(), Qt::LeftButton, Qt::ControlModifier);
    QTest::mouseRelease(&slice(), Qt::LeftButton, Qt::ControlModifier, (center + QPointF(0, 80)).toPoint());
    QVERIFY(std::abs(slice().roll_deg() - 90) < 2);
    // The slice itself did not move, and what was under the crosshair still is.
    QVERIFY((slice().normal() - Eigen::Vector3d::UnitZ()).norm() < 1e-12);
    QVERIFY((pixel_in(slice(), {60, 40, 40}) - center).manhattanLength() < 1e-6);
  }

  void layouts_are_changed_by_keys() {
    press_key(*window_, Qt::Key_F6);
    QCOMPARE(views().view_layout(), ViewLayout::space_large);
    QTRY_VERIFY(views().space().width() > 2 * slice().width());
    press_key(*window_, Qt::Key_F7);
    QVERIFY(!views().space().isVisible());
    QVERIFY(views().slice(SliceDirection::sagittal).isVisible());
    press_key(*window_, Qt::Key_F5);
    views().space().setFocus();
    press_key(*window_, Qt::Key_F8);
    QVERIFY(views().space().isVisible());
    QVERIFY(!slice().isVisible());
    QVERIFY(child<QAction>("layout_one")->isChecked());
  }

  void the_patient_turns_by_keys() {
    SpaceView& space = views().space();
    const Eigen::Vector3d before = space.view().camera().sight;
    space.setFocus();
    QTest::keyClick(&space, Qt::Key_Left);
    const double turned_deg = std::acos(before.dot(space.view().camera().sight)) * 180 / EIGEN_PI;
    QVERIFY(turned_deg > 2 && turned_deg < 6);
    QTest::keyClick(&space, Qt::Key_Home);
    QVERIFY((space.view().camera().sight - before).norm() < 1e-9);
  }

  void cleanupTestCase() { window_.reset(); }

 private:
  // Pixels of a gall bladder's colour.
  static int greenish(const QImage& picture) {
    int count = 0;
    for (int y = 0; y < picture.height(); ++y) {
      for (int x = 0; x < picture.width(); ++x) {
        const QColor colour = picture.pixelColor(x, y);
        if (colour.green() > colour.red() + 25 && colour.green() > colour.blue() + 25) ++count;
      }
    }
    return count;
  }

  LinkedViews& views() { return window_->views(); }
  SliceView& slice() { return views().slice(SliceDirection::transverse); }
  MeasureList& list() { return *window_->findChild<MeasureList*>(); }

  template <typename Object>
  Object* child(const char* name) {
    auto* found = window_->findChild<Object*>(name);
    if (found == nullptr) qFatal("the window has no %s", name);
    return found;
  }

  void key(Qt::Key letter) { press_key(*window_, letter, Qt::ControlModifier | Qt::ShiftModifier); }

  double value(int row, const QString& unit) {
    const QString text = list().item(row, 1)->text();
    return text.endsWith(unit) ? text.chopped(unit.size()).toDouble() : -1;
  }

  static QPointF pixel_in(const SliceView& view, const Eigen::Vector3d& place_mm) {
    const Eigen::Vector2d at = view.view().pixel_of(place_mm) / view.devicePixelRatioF();
    return {at.x(), at.y()};
  }
  QPoint pixel_of(const Eigen::Vector3d& place_mm) { return pixel_in(slice(), place_mm).toPoint(); }

  void click_at(const Eigen::Vector3d& place_mm) {
    QTest::mouseClick(&slice(), Qt::LeftButton, Qt::NoModifier, pixel_of(place_mm));
  }

  // QTest's moves carry no modifiers.
  void move_pressed(const QPoint& to, Qt::MouseButton button, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QMouseEvent event(QEvent::MouseMove, to, slice().mapToGlobal(QPointF(to)), Qt::NoButton, button, modifiers);
    QCoreApplication::sendEvent(&slice(), &event);
  }

  static void drag_in(QWidget& view, const QPoint& from, const QPoint& to) {
    QTest::mousePress(&view, Qt::LeftButton, Qt::NoModifier, from);
    for (int step = 1; step <= 6; ++step) QTest::mouseMove(&view, from + (to - from) * step / 6, 10);
    QTest::mouseRelease(&view, Qt::LeftButton, Qt::NoModifier, to);
  }
  void drag(const QPoint& from, const QPoint& to) { drag_in(slice(), from, to); }

  std::unique_ptr<MainWindow> window_;
};

}  // namespace
}  // namespace glisson::widgets

int main(int argc, char** argv) { return glisson::widgets::run_test<glisson::widgets::ViewsTest>(argc, argv); }

#include "views_test.moc"

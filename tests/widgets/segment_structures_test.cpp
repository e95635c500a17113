// What the Segment workspace does to whole structures: they are added, named, filled, filtered, found by grey values
// and combined.

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QtTest>

#include "kept_pictures.h"
#include "run_test.h"
#include "segment_workspace.h"
#include "widgets/segment/unsure_places.h"
#include "widgets/settings/settings_window.h"

namespace glisson::widgets {
namespace {

class SegmentStructuresTest : public SegmentWorkspace {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { open(); }

  void a_structure_is_added_drawn_filled_between_slices_and_renamed() {
    auto* add = child<QPushButton>("add_structure");
    Q_EMIT add->menu()->aboutToShow();
    add->menu()->findChild<QAction*>("tumour")->trigger();
    settle();
    QCOMPARE(panel_->editor().active_structure()->name, std::string("tumour-1"));
    key(Qt::Key_B);
    stroke({-8, 0}, {-6, 0});
    const Eigen::Vector3d middle = transverse().crosshair_mm();
    window_->views().set_crosshair(middle + Eigen::Vector3d(0, 0, 12));
    stroke({-8, 0}, {-6, 0});
    window_->views().set_crosshair(middle);
    const std::size_t in_two = test::voxels_of(folder_, "tumour-1");
    key(Qt::Key_F);
    settle();
    const std::size_t filled = test::voxels_of(folder_, "tumour-1");
    QVERIFY(filled > 2 * in_two && filled < 3 * in_two);  // three more slices between the two

    auto* rename = child<QPushButton>("rename_structure");
    Q_EMIT rename->menu()->aboutToShow();
    rename->menu()->findChild<QAction*>("cyst")->trigger();
    settle();
    QCOMPARE(test::voxels_of(folder_, "cyst-1"), filled);
    QCOMPARE(test::voxels_of(folder_, "tumour-1"), std::size_t(0));
    for (int n = 0; n < 5; ++n) undo();
    QCOMPARE(panel_->editor().structures().size(), std::size_t(1));
    QCOMPARE(test::voxels_of(folder_, "liver"), start_);
  }

  void filters_change_the_whole_structure() {
    key(Qt::Key_Plus);
    settle();
    const std::size_t grown = test::voxels_of(folder_, "liver");
    QVERIFY(grown > start_);
    key(Qt::Key_Minus);
    settle();
    QVERIFY(test::voxels_of(folder_, "liver") < grown);
    undo();
    undo();
    key(Qt::Key_H);  // nothing to fill: no step
    settle();
    QVERIFY(!window_->undo().undo_action()->isEnabled());
  }

  // The bright ball of 16 mm: by its grey values, and what the drawn one and it have in common.
  void grey_values_and_other_structures_make_a_structure() {
    auto* low = child<QDoubleSpinBox>("grey_low");
    auto* high = child<QDoubleSpinBox>("grey_high");
    child<QPushButton>("range_from_crosshair")->click();
    QVERIFY(low->value() < high->value());
    auto* add = child<QPushButton>("add_structure");
    Q_EMIT add->menu()->aboutToShow();
    add->menu()->findChild<QAction*>("tumour")->trigger();
    settle();
    child<QPushButton>("take_range")->click();
    settle();
    const std::size_t everywhere = test::voxels_of(folder_, "tumour-1");
    QVERIFY(everywhere > start_);
    auto* within = child<QComboBox>("within");
    within->setCurrentIndex(within->findData("liver"));
    child<QPushButton>("take_range")->click();
    settle();
    const std::size_t inside = test::voxels_of(folder_, "tumour-1");
    QVERIFY2(inside > start_ / 2 && inside <= start_, qPrintable(QString::number(inside)));
    undo();
    QCOMPARE(test::voxels_of(folder_, "tumour-1"), everywhere);

    auto* how = child<QComboBox>("combine_how");
    auto* other = child<QComboBox>("combine_with");
    QCOMPARE(other->count(), 1);  // itself is not offered
    how->setCurrentIndex(StructureOperations::subtract);
    child<QPushButton>("combine")->click();
    settle();
    QCOMPARE(test::voxels_of(folder_, "tumour-1"), everywhere - inside);
    how->setCurrentIndex(StructureOperations::unite);
    child<QPushButton>("combine")->click();
    settle();
    QCOMPARE(test::voxels_of(folder_, "tumour-1"), everywhere - inside + start_);
    how->setCurrentIndex(StructureOperations::intersect);
    child<QPushButton>("combine")->click();
    settle();
    QCOMPARE(test::voxels_of(folder_, "tumour-1"), start_);
    within->setCurrentIndex(0);
    for (int n = 0; n < 5; ++n) undo();
    QCOMPARE(panel_->editor().structures().size(), std::size_t(1));
  }

  // A tumour amid tissue that looks like it has a border that nobody can see; the liver's, where it lies at the step of
  // brightness, has none such.
  void goes_to_where_a_border_is_unsure() {
    auto* ask = child<QPushButton>("unsure_places");
    auto* told = panel_->findChild<UnsurePlaces*>()->findChild<QLabel*>();
    QVERIFY(!told->isVisible());
    auto* margin = child<QDoubleSpinBox>("margin_mm");
    const double before_mm = margin->value();
    margin->setValue(4);
    key(Qt::Key_Plus);
    settle();
    ask->click();
    QTRY_VERIFY_WITH_TIMEOUT(told->text().contains("No larger part"), patience_ms);
    undo();
    margin->setValue(before_mm);
    auto* add = child<QPushButton>("add_structure");
    Q_EMIT add->menu()->aboutToShow();
    add->menu()->findChild<QAction*>("tumour")->trigger();
    settle();
    QVERIFY(!told->isVisible());
    key(Qt::Key_B);
    child<QComboBox>("brush_shape")->setCurrentIndex(1);
    stroke({0, 0}, {1, 0});
    const Eigen::Vector3d middle_mm = transverse().crosshair_mm();
    ask->click();
    QTRY_VERIFY_WITH_TIMEOUT(told->text().contains("Place 1 of"), patience_ms);
    const double off_mm = (transverse().crosshair_mm() - middle_mm).norm();
    QVERIFY2(off_mm > 3 && off_mm < 10, qPrintable(QString::number(off_mm)));
    window_->views().set_crosshair(middle_mm);
    stroke({0, 0}, {1, 0});  // what was said is said of an outline of before
    QVERIFY(!told->isVisible());
    child<QComboBox>("brush_shape")->setCurrentIndex(0);
    for (int n = 0; n < 3 && panel_->editor().structures().size() > 1; ++n) undo();
    QCOMPARE(panel_->editor().structures().size(), std::size_t(1));
  }

  // A stand-in for a network, told in Settings, that outlines two structures; then one that is not installed.
  void another_program_outlines_structures() {
    const std::filesystem::path outlines = temporary_.path() / "outlines";
    std::filesystem::create_directories(outlines);
    QVERIFY(imaging::write_mask_file(outlines / "liver.nrrd", test::ball_mask(15), {"liver", 1, {1, 0, 0}}));
    QVERIFY(imaging::write_mask_file(outlines / "spleen.nrrd", test::ball_mask(5), {"spleen", 1, {0, 1, 0}}));
    SettingsWindow settings;
    auto* program = settings.findChild<QLineEdit*>("outlining_program");
    program->setText(
        QString::fromStdString("sh -c 'cp " + outlines.string() + "/*.nrrd \"$2\"' network {image} {folder}"));
    const auto outline = [&] {
      auto* add = child<QPushButton>("add_structure");
      Q_EMIT add->menu()->aboutToShow();
      add->menu()->findChild<QAction*>("outline_with_program")->trigger();
      settle();
    };
    settings.show();
    QVERIFY(settings.grab().save(glisson::test::kept_picture("settings-program.png")));
    settings.hide();
    outline();
    QCOMPARE(panel_->editor().structures().size(), std::size_t(2));
    QCOMPARE(test::voxels_of(folder_, "liver"), segmentation::voxel_count(test::ball_mask(15)));
    QCOMPARE(test::voxels_of(folder_, "spleen"), segmentation::voxel_count(test::ball_mask(5)));
    undo();
    QCOMPARE(panel_->editor().structures().size(), std::size_t(1));
    QCOMPARE(test::voxels_of(folder_, "liver"), start_);

    program->setText("no-such-network {image} {folder}");
    outline();
    QVERIFY(child<QLabel>("notice_text")->text().contains("no-such-network"));
    QCOMPARE(test::voxels_of(folder_, "liver"), start_);
    program->setText({});
  }

  // A bright tube of 3 mm radius through the ball: nobody clicks on it, and no other structure offers it.
  void vessels_are_found_by_their_shape() {
    const std::filesystem::path folder = test::small_case(temporary_.path() / "with-a-vessel");
    auto opened = casefile::Case::open(folder);
    imaging::Volume image = opened->volume("volumes/anatomy").value();
    std::size_t in_tube = 0;
    for (int k = 0; k < 24; ++k) {
      for (int j = 0; j < 56; ++j) {
        for (int i = 0; i < 64; ++i) {
          const Eigen::Vector3d off_mm = image.grid.position_mm(i, j, k) - test::small_middle_mm();
          if (std::hypot(off_mm.y(), off_mm.z()) > 3) continue;
          image.at(i, j, k) += 80;
          if (off_mm.norm() < 12) ++in_tube;
        }
      }
    }
    QVERIFY(opened->add("volumes/anatomy", ".nrrd", {"import", {}, {}, {}, {}},
                        [&](const std::filesystem::path& file) { return imaging::write_volume_file(file, image); }));
    window_->open_path(folder);
    settle();
    auto* add = child<QPushButton>("add_structure");
    auto* find = panel_->findChild<QPushButton*>("find");
    key(Qt::Key_G);
    QVERIFY(find->isVisible() && find->isEnabled());  // the liver, too, without a point
    Q_EMIT add->menu()->aboutToShow();
    add->menu()->findChild<QAction*>("portal-vein")->trigger();
    settle();
    QVERIFY(find->isVisible() && find->isEnabled());
    QTest::mouseClick(find, Qt::LeftButton);
    settle();
    const std::size_t found = test::voxels_of(folder, "portal-vein");
    QVERIFY2(found > in_tube / 2 && found < 2 * in_tube, qPrintable(QString("%1 of %2").arg(found).arg(in_tube)));
    QVERIFY(child<QLabel>("notice_text")->text().contains("brighter"));
    undo();
    QCOMPARE(test::voxels_of(folder, "portal-vein"), std::size_t(0));
  }

  void points_outside_count_for_the_liver_and_stay_until_taken_away() {
    panel_->editor().set_active(0);
    settle();
    QCOMPARE(panel_->editor().active_structure()->name, std::string("liver"));
    key(Qt::Key_G);
    const auto click = [&](const QPointF& place_mm, Qt::KeyboardModifiers with) {
      QTest::mouseClick(&transverse(), Qt::LeftButton, with, at(place_mm).toPoint());
    };
    const segmentation::GivenPoints& points = panel_->tools().points();
    auto* grow = child<QPushButton>("grow");
    click({0, 0}, Qt::NoModifier);
    QVERIFY(grow->isEnabled());
    click({12, 0}, Qt::ControlModifier);
    QCOMPARE(points.inside_mm.size(), std::size_t(1));
    QCOMPARE(points.outside_mm.size(), std::size_t(1));
    QVERIFY(!grow->isEnabled());
    QTest::qWait(1500);  // until the views have drawn
    QVERIFY(window_->grab().save(glisson::test::kept_picture("segment-not-liver.png")));
    click({12, 0}, Qt::NoModifier);
    QVERIFY(points.outside_mm.empty() && points.inside_mm.size() == 1);
    QVERIFY(grow->isEnabled());
    grow->click();
    settle();
    QCOMPARE(points.inside_mm.size(), std::size_t(1));  // so that another point mends what has grown
    undo();
    panel_->editor().add("tumour-9");
    settle();
    QVERIFY(points.inside_mm.empty());
    click({12, 0}, Qt::ControlModifier);
    QVERIFY(points.outside_mm.empty());
    undo();
    key(Qt::Key_N);
  }

  void cleanupTestCase() { close(); }
};

}  // namespace
}  // namespace glisson::widgets

int main(int argc, char** argv) {
  return glisson::widgets::run_test<glisson::widgets::SegmentStructuresTest>(argc, argv);
}

#include "segment_structures_test.moc"

// The Segment workspace, driven as a person drives it: strokes with the mouse in a slice, keys for tools, undo. Whole
// structures: segment_structures_test.cpp.

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTreeWidget>
#include <QtTest>

#include "run_test.h"
#include "segment_workspace.h"

namespace glisson::widgets {
namespace {

class SegmentTest : public SegmentWorkspace {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { open(); }

  void lists_the_structures_with_their_volumes() {
    QCOMPARE(child<QTreeWidget>("segment_structures")->topLevelItemCount(), 1);
    QCOMPARE(child<QTreeWidget>("segment_structures")->topLevelItem(0)->text(0), "Liver");
    QVERIFY(child<QTreeWidget>("segment_structures")->topLevelItem(0)->text(1).toDouble() > 5);
  }

  void a_key_takes_the_brush_and_a_stroke_draws_and_is_saved() {
    key(Qt::Key_B);
    QVERIFY(child<QPushButton>("tool_brush")->isChecked());
    stroke({0, 16}, {9, 16});
    const std::size_t drawn = test::voxels_of(folder_, "liver");
    QVERIFY(drawn > start_ + 20);
    QVERIFY(window_->undo().undo_action()->text().contains("Brush on Liver"));
    // A disc stays in the slice that it was drawn in.
    const imaging::Mask& mask = *panel_->editor().structures().front().mask;
    const int layer = segmentation::layer_at(mask.grid, 2, transverse().crosshair_mm());
    std::size_t elsewhere = 0;
    const imaging::Mask before = test::ball_mask(12);
    for (std::size_t voxel = 0; voxel < mask.values.size(); ++voxel) {
      if (mask.values[voxel] == before.values[voxel]) continue;
      if (static_cast<int>(voxel / (64U * 56U)) != layer) ++elsewhere;
    }
    QCOMPARE(elsewhere, std::size_t(0));
  }

  void undo_takes_the_stroke_back_and_redo_draws_it_again() {
    const std::size_t drawn = test::voxels_of(folder_, "liver");
    press_key(*window_, Qt::Key_Z, Qt::ControlModifier);
    settle();
    QCOMPARE(test::voxels_of(folder_, "liver"), start_);
    QCOMPARE(segmentation::voxel_count(*panel_->editor().structures().front().mask), start_);
    press_key(*window_, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    settle();
    QCOMPARE(test::voxels_of(folder_, "liver"), drawn);
    window_->undo().undo();
    settle();
  }

  void the_eraser_takes_away_and_the_wheel_changes_its_radius() {
    key(Qt::Key_E);
    const double before_mm = panel_->tools().options().radius_mm;
    QWheelEvent larger(at({0, 0}), transverse().mapToGlobal(at({0, 0})), {}, {0, 240}, Qt::NoButton, Qt::ShiftModifier,
                       Qt::NoScrollPhase, false);
    QApplication::sendEvent(&transverse(), &larger);
    QVERIFY(panel_->tools().options().radius_mm > 1.2 * before_mm);
    stroke({0, 0}, {4, 0});
    QVERIFY(test::voxels_of(folder_, "liver") < start_ - 20);
    undo();
  }

  void the_smart_brush_keeps_to_the_tissue() {
    key(Qt::Key_M);
    // Along the edge of the bright ball of 16 mm: the brush reaches beyond it, the tissue does not.
    stroke({13, 0}, {15, 0});
    const imaging::Mask& mask = *panel_->editor().structures().front().mask;
    const imaging::Mask bright = test::ball_mask(16);
    std::size_t outside = 0;
    for (std::size_t voxel = 0; voxel < mask.values.size(); ++voxel) {
      outside += mask.values[voxel] != 0 && bright.values[voxel] == 0 ? 1U : 0U;
    }
    QCOMPARE(outside, std::size_t(0));
    QVERIFY(segmentation::voxel_count(mask) > start_);
    undo();
  }

  void scissors_cut_through_all_slices() {
    key(Qt::Key_S);
    cut_away_half();
    const auto left = static_cast<double>(test::voxels_of(folder_, "liver")) / static_cast<double>(start_);
    QVERIFY2(left > 0.4 && left < 0.6, qPrintable(QString::number(left)));
    undo();
  }

  // Straight or tilted: what is cut lies as deep along the line of sight as was chosen. A slice is as thick as the
  // voxels that its plane goes through.
  void scissors_cut_as_deep_as_chosen() {
    auto* depth = child<QComboBox>("cut_depth");
    auto* depth_mm = child<QWidget>("cut_depth_mm");
    const Eigen::Matrix3d straight = Eigen::Matrix3d::Identity();
    const Eigen::Matrix3d tilted = Eigen::AngleAxisd(EIGEN_PI / 6, Eigen::Vector3d::UnitX()).toRotationMatrix();
    const std::vector<std::pair<double, double>> reaches_mm{{0, 0}, {-1e3, 1e3}, {-7, 7}, {-1e3, 0}, {0, 1e3}};
    for (const Eigen::Matrix3d& axes : {straight, tilted}) {
      window_->views().set_axes(axes);
      for (int choice = 0; choice < depth->count(); ++choice) {
        key(Qt::Key_S);
        depth->setCurrentIndex(choice);
        QCOMPARE(depth_mm->isVisible(), choice == 2);
        depth_mm->findChild<QDoubleSpinBox*>()->setValue(7);
        cut_away_half();
        const imaging::Mask& mask = *panel_->editor().structures().front().mask;
        const Eigen::Vector3d sight = transverse().view().camera().sight;
        const double half_mm = segmentation::half_extent_mm(mask.grid, sight);
        const auto [from_mm, to_mm] = reaches_mm[static_cast<std::size_t>(choice)];
        const auto [shallowest_mm, deepest_mm] = depths_of_cut_mm(mask, sight);
        const double thickest_mm = axes.isIdentity() ? 3 : 2 * half_mm;  // one layer of voxels more or less
        const QString told = QString("%1: %2 to %3 mm").arg(choice).arg(shallowest_mm).arg(deepest_mm);
        QVERIFY2(shallowest_mm >= std::min(from_mm, -half_mm) - 1e-9, qPrintable(told));
        QVERIFY2(deepest_mm <= std::max(to_mm, half_mm) + 1e-9, qPrintable(told));
        // The ball of 12 mm, less what is cut off with it: it is cut as far as it reaches, or as was chosen.
        QVERIFY2(shallowest_mm < std::max(from_mm, -9.0) + thickest_mm, qPrintable(told));
        QVERIFY2(deepest_mm > std::min(to_mm, 9.0) - thickest_mm, qPrintable(told));
        undo();
      }
    }
    depth->setCurrentIndex(1);
    window_->views().straighten();
  }

  void the_brush_keeps_to_the_grey_values_when_asked() {
    child<QPushButton>("range_from_crosshair")->click();
    auto* only = child<QCheckBox>("range_for_brush");
    only->setChecked(true);
    key(Qt::Key_B);
    stroke({13, 0}, {15, 0});  // beyond the edge of the bright ball
    const imaging::Mask& mask = *panel_->editor().structures().front().mask;
    const imaging::Mask bright = test::ball_mask(16);
    std::size_t outside = 0;
    for (std::size_t voxel = 0; voxel < mask.values.size(); ++voxel) {
      outside += mask.values[voxel] != 0 && bright.values[voxel] == 0 ? 1U : 0U;
    }
    QCOMPARE(outside, std::size_t(0));
    QVERIFY(segmentation::voxel_count(mask) > start_);
    undo();
    only->setChecked(false);
  }

  void a_stroke_is_seen_while_it_is_drawn() {
    key(Qt::Key_B);
    press({-10, -10});
    QElapsedTimer clock;
    qint64 longest_ms = 0;
    for (int n = 0; n < 40; ++n) {
      clock.restart();
      move({-10 + 0.5 * n, -10});
      QCoreApplication::processEvents();
      longest_ms = std::max(longest_ms, clock.elapsed());
    }
    QVERIFY(segmentation::voxel_count(*panel_->editor().structures().front().mask) > start_);
    QCOMPARE(test::voxels_of(folder_, "liver"), start_);  // the case has it once the button is let go
    release({10, -10});
    settle();
    QVERIFY(test::voxels_of(folder_, "liver") > start_);
    qInfo("longest event while drawing: %lld ms", longest_ms);
    undo();
  }

  void draws_in_a_tilted_slice_what_its_plane_goes_through() {
    const Eigen::Matrix3d tilt = Eigen::AngleAxisd(EIGEN_PI / 6, Eigen::Vector3d::UnitX()).toRotationMatrix();
    window_->views().set_axes(tilt);
    key(Qt::Key_B);
    press({-10, -10});
    move({10, -10});
    release({10, -10});
    settle();
    QVERIFY(test::voxels_of(folder_, "liver") > start_);
    const imaging::Mask& mask = *panel_->editor().structures().front().mask;
    const imaging::Mask before = test::ball_mask(12);
    const Eigen::Vector3d normal = transverse().normal();
    const double reach_mm = segmentation::half_extent_mm(mask.grid, normal);
    for (std::size_t voxel = 0; voxel < mask.values.size(); ++voxel) {
      if (mask.values[voxel] == before.values[voxel]) continue;
      const auto v = static_cast<int>(voxel);
      const Eigen::Vector3d at_mm = mask.grid.position_mm(v % 64, v / 64 % 56, v / (64 * 56));
      QVERIFY(std::abs(normal.dot(at_mm - transverse().crosshair_mm())) <= reach_mm + 1e-9);
    }
    // The list beside the views has the volume of what is drawn.
    auto* beside = child<QTreeWidget>("structures");
    QCOMPARE(beside->topLevelItem(0)->text(1), child<QTreeWidget>("segment_structures")->topLevelItem(0)->text(1));
    undo();
    QCOMPARE(beside->topLevelItem(0)->text(1), child<QTreeWidget>("segment_structures")->topLevelItem(0)->text(1));
    window_->views().straighten();
  }

  // A leak: a ball that hangs on the liver by a bar.
  void a_part_that_hangs_by_a_neck_goes_with_one_click() {
    key(Qt::Key_B);
    child<QComboBox>("brush_shape")->setCurrentIndex(1);
    auto* radius = child<QWidget>("brush_radius")->findChild<QDoubleSpinBox*>();
    const double before_mm = radius->value();
    radius->setValue(2.5);
    stroke({11, 0}, {24, 0});
    radius->setValue(6);
    stroke({24, 0}, {24.5, 0});
    const std::size_t leaked = test::voxels_of(folder_, "liver");
    key(Qt::Key_I);
    QTest::mouseClick(&transverse(), Qt::LeftButton, Qt::ControlModifier, at({25, 1}).toPoint());
    settle();
    const std::size_t left = test::voxels_of(folder_, "liver");
    QVERIFY2(left >= start_ && left < start_ + (leaked - start_) / 4, qPrintable(QString::number(left)));
    QVERIFY(window_->undo().undo_action()->text().contains("Take a part off Liver"));
    // Within the liver nothing hangs on it: that is said, and nothing is taken.
    QTest::mouseClick(&transverse(), Qt::LeftButton, Qt::ControlModifier, at({0, 0}).toPoint());
    settle();
    QVERIFY(child<QLabel>("notice_text")->text().contains("Nothing narrower"));
    QCOMPARE(test::voxels_of(folder_, "liver"), left);
    for (int n = 0; n < 3; ++n) undo();
    QCOMPARE(test::voxels_of(folder_, "liver"), start_);
    radius->setValue(before_mm);
    child<QComboBox>("brush_shape")->setCurrentIndex(0);
  }

  void what_was_drawn_is_what_others_show_afterwards() {
    key(Qt::Key_B);
    stroke({0, 16}, {9, 16});
    const double before_ml = panel_->editor().structures().front().volume_ml;
    window_->go_to("rehearse");
    settle();
    QVERIFY(!child<QPushButton>("tool_brush")->isVisible());
    window_->go_to("segment");
    settle();
    QCOMPARE(panel_->editor().structures().front().volume_ml, before_ml);
  }

  void cleanupTestCase() { close(); }

 private:
  // With the scissors: the half on the picture's right.
  void cut_away_half() {
    const std::vector<QPointF> around{{0, -20}, {20, -20}, {20, 20}, {0, 20}};
    press(around.front());
    for (const QPointF& corner : around) move(corner);
    release(around.back());
    settle();
  }
  // Where the voxels that are gone from the ball lie along a direction, from the crosshair.
  std::pair<double, double> depths_of_cut_mm(const imaging::Mask& mask, const Eigen::Vector3d& direction) {
    const imaging::Mask before = test::ball_mask(12);
    std::pair<double, double> range{1e9, -1e9};
    for (std::size_t voxel = 0; voxel < mask.values.size(); ++voxel) {
      if (mask.values[voxel] == before.values[voxel]) continue;
      const auto v = static_cast<int>(voxel);
      const Eigen::Vector3d at_mm = mask.grid.position_mm(v % 64, v / 64 % 56, v / (64 * 56));
      const double depth_mm = direction.dot(at_mm - transverse().crosshair_mm());
      range = {std::min(range.first, depth_mm), std::max(range.second, depth_mm)};
    }
    return range;
  }
};

}  // namespace
}  // namespace glisson::widgets

int main(int argc, char** argv) { return glisson::widgets::run_test<glisson::widgets::SegmentTest>(argc, argv); }

#include "segment_test.moc"

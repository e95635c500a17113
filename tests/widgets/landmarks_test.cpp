// Landmarks set by hand: where somebody clicked, with a name, kept in the case, followed as the liver moves, and
// undone.

#include <QPushButton>
#include <QSignalSpy>
#include <QtTest>

#include "base/files.h"
#include "casefile/placed_landmarks.h"
#include "modelled_case.h"
#include "run_test.h"
#include "shown.h"
#include "widgets/main_window.h"
#include "widgets/rehearse/landmark_table.h"

namespace glisson::widgets {
namespace {

constexpr int patience_ms = 30000;

class LandmarksTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    folder_ = test::modelled_case(temporary_.path());
    window_ = shown_window({1600, 1000});
    window_->open_path(folder_);
    QTRY_VERIFY_WITH_TIMEOUT(window_->rehearsal().body() != nullptr && !window_->work().busy(), patience_ms);
    window_->go_to("rehearse");
    const Eigen::Vector3d on_top_mm = test::small_middle_mm() + Eigen::Vector3d(0, 0, 12);
    QSignalSpy placed(&window_->rehearsal(), &LiveRehearsal::placed);
    window_->rehearsal().hold({"palpation-probe", on_top_mm, {0, 0, 1}, 8, {0, 0, -1}, 0.2});
    QVERIFY(placed.wait(patience_ms));
    QTRY_VERIFY_WITH_TIMEOUT(window_->rehearsal().state().has_value(), patience_ms);
    rows_ = table().rowCount();
  }

  void one_is_set_where_the_crosshair_was_clicked() {
    QVERIFY(!child<QPushButton>("remove_landmark")->isEnabled());
    SliceView& view = window_->views().slice(SliceDirection::transverse);
    QTest::mouseClick(&view, Qt::LeftButton, Qt::NoModifier, view.rect().center() + QPoint(6, 4));
    clicked_mm_ = window_->views().crosshair_mm();
    QVERIFY((clicked_mm_ - test::small_middle_mm()).norm() < 12);
    press("set_landmark");
    QCOMPARE(table().rowCount(), rows_ + 1);
    const auto kept = kept_landmarks();
    QCOMPARE(kept.size(), std::size_t(1));
    QCOMPARE(kept[0].id, std::string("landmark-1"));
    QVERIFY((kept[0].position_mm - clicked_mm_).norm() < 1e-9);
    // It moves with the liver, under the tool that stayed.
    const auto& frame = window_->rehearsal().state();
    QTRY_VERIFY_WITH_TIMEOUT(frame.has_value(), patience_ms);
    QCOMPARE(frame->patient.landmarks.back().id, std::string("landmark-1"));
    QVERIFY(frame->patient.landmarks.back().displacement_mm > 0);
  }

  void a_second_gets_another_name_and_is_renamed_in_the_table() {
    press("set_landmark");
    QCOMPARE(table().rowCount(), rows_ + 2);
    const int row = row_of("landmark-2");
    QVERIFY(row >= 0);
    table().item(row, LandmarkTable::name_column)->setText("Cantlie front");
    settle();
    QVERIFY(row_of("cantlie-front") >= 0);
    QCOMPARE(kept_landmarks()[1].id, std::string("cantlie-front"));
    // A name that is there already is refused, and the old one stays.
    table().item(row_of("cantlie-front"), LandmarkTable::name_column)->setText("landmark 1");
    settle();
    QVERIFY(row_of("cantlie-front") >= 0);
    QCOMPARE(kept_landmarks()[1].id, std::string("cantlie-front"));
  }

  void renaming_is_undone_and_done_again() {
    window_->undo().undo();
    settle();
    QVERIFY(row_of("landmark-2") >= 0);
    QVERIFY(row_of("cantlie-front") < 0);
    window_->undo().redo();
    settle();
    QVERIFY(row_of("cantlie-front") >= 0);
  }

  void the_chosen_one_is_removed_and_comes_back() {
    table().setCurrentCell(row_of("landmark-1"), 0);
    press("remove_landmark");
    QCOMPARE(table().rowCount(), rows_ + 1);
    QCOMPARE(kept_landmarks().size(), std::size_t(1));
    window_->undo().undo();
    settle();
    QCOMPARE(table().rowCount(), rows_ + 2);
    // Those of the structures are not taken away.
    table().setCurrentCell(0, 0);
    QVERIFY(!child<QPushButton>("remove_landmark")->isEnabled());
  }

  void outside_of_the_liver_none_is_set() {
    window_->views().set_crosshair(test::small_middle_mm() + Eigen::Vector3d(40, 0, 0));
    press("set_landmark");
    QCOMPARE(kept_landmarks().size(), std::size_t(2));
    QCOMPARE(table().rowCount(), rows_ + 2);
  }

  void the_table_of_the_rehearsal_has_them() {
    QVERIFY(landmark_csv(*window_->rehearsal().state()).find("cantlie-front") != std::string::npos);
  }

  void a_case_opened_again_has_them() {
    window_.reset();
    window_ = shown_window({1600, 1000});
    window_->open_path(folder_);
    QTRY_VERIFY_WITH_TIMEOUT(window_->rehearsal().body() != nullptr && !window_->work().busy(), patience_ms);
    window_->rehearsal().hold(
        {"palpation-probe", test::small_middle_mm() + Eigen::Vector3d(0, 0, 12), {0, 0, 1}, 8, {0, 0, -1}, 0.2});
    QTRY_VERIFY_WITH_TIMEOUT(window_->rehearsal().state().has_value(), patience_ms);
    QVERIFY(row_of("cantlie-front") >= 0 && row_of("landmark-1") >= 0);
  }

  void a_damaged_file_is_told_of() {
    window_.reset();
    const auto opened = casefile::Case::open(folder_);
    const auto file = opened->file_of("landmarks/placed");
    QVERIFY(write_text_file(*file, R"({"format": "glisson-landmarks/1", "landmarks": [{"name": "a"}]})").has_value());
    const auto read = casefile::placed_landmarks(*casefile::Case::open(folder_));
    QVERIFY(!read);
    QCOMPARE(read.error().code, std::string("landmarks-invalid"));
    QVERIFY(!read.error().hint.empty());
  }

 private:
  template <typename Widget>
  Widget* child(const char* name) {
    return child_of<Widget>(*window_, name);
  }
  LandmarkTable& table() { return *child<LandmarkTable>("landmarks"); }
  int row_of(const char* id) {
    for (int row = 0; row < table().rowCount(); ++row) {
      if (table().item(row, 0)->data(Qt::UserRole).toString() == id) return row;
    }
    return -1;
  }
  std::vector<mechanics::Landmark> kept_landmarks() const {
    return casefile::placed_landmarks(*casefile::Case::open(folder_)).value();
  }
  void press(const char* button) {
    QTest::mouseClick(child<QPushButton>(button), Qt::LeftButton);
    settle();
  }
  void settle() {
    QCoreApplication::processEvents();
    QTRY_VERIFY_WITH_TIMEOUT(!window_->undo().busy() && !window_->work().busy(), patience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(window_->rehearsal().solving() == Solving::solved, patience_ms);
  }

  TemporaryFolder temporary_;
  std::filesystem::path folder_;
  std::unique_ptr<MainWindow> window_;
  Eigen::Vector3d clicked_mm_{0, 0, 0};
  int rows_ = 0;
};

}  // namespace
}  // namespace glisson::widgets

int main(int argc, char** argv) { return glisson::widgets::run_test<glisson::widgets::LandmarksTest>(argc, argv); }

#include "landmarks_test.moc"

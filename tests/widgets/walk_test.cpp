// From a folder to a report on real images, as a person goes: every control is clicked where it is drawn, and after
// each step the window must show what the next one needs. See walk.h. One test of CTest a walk, so that the memory
// printed is its own.

#include <QComboBox>
#include <QTextBrowser>
#include <QTreeWidget>

#include "base/files.h"
#include "base/json.h"
#include "imaging/volume_file.h"
#include "run_test.h"
#include "segmentation/structures.h"
#include "support/data.h"
#include "walk.h"
#include "widgets/views/wave_view.h"

namespace glisson::widgets {
namespace {

namespace fs = std::filesystem;

class WalkTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  // TotalSegmentator's labels beside the CT. The scan ends within the liver.
  void ct_with_labels() {
    if (!copied_to_study({"totalseg_abdomen_mr_ct/example_ct.nii.gz",
                          "totalseg_abdomen_mr_ct/example_seg_fast_force_split.nii.gz"})) {
      QSKIP(absent);
    }
    Walk walk("ct-with-labels");
    make_a_case(walk, 2);
    walk.step(
        "labels are there", [] {},
        [&] {
          return rows(walk, "structures") > 5 && walk.can_press("primary") && walk.window().workspace() == "segment";
        });
    build_the_model(walk);
    const Eigen::Vector3d on_the_cap_mm(-66.5, -185.3, 427);
    walk.step(
        "point at the scan's end", [&] { walk.point_at(on_the_cap_mm); },
        [&] { return (walk.window().views().crosshair_mm() - on_the_cap_mm).norm() < 5; });
    walk.step(
        "tool on the cap", [&] { walk.press(Qt::Key_T, Qt::ControlModifier); },
        [&] { return walk.text("tool_on_cap").contains("towards the head"); });
    rehearse_and_report(walk, {-66.5, -185.3, 392.2});
  }

  // 20 slices of a Siemens CT in JPEG 2000, which nobody has outlined: one click in the liver does.
  void ct_of_jpeg_2000() {
    if (!copied_to_study({"totalseg_abdomen_mr_ct/example_ct_dicom"})) QSKIP(absent);
    Walk walk("ct-jpeg-2000");
    make_a_case(walk, 1);
    outline_from(walk, {-76, -166, -785});
    build_the_model(walk);
    rehearse_and_report(walk, {-76, -166, -785});
  }

  // Three slices of CT with a DICOM SEG: hardly a liver, and no dead end.
  void ct_with_dicom_seg() {
    if (!copied_to_study({"dcmqi_liver_seg_ct3/ct-3slice", "dcmqi_liver_seg_ct3/liver.dcm"})) QSKIP(absent);
    Walk walk("dicom-seg");
    drop_the_study(walk, 2);
    const auto picture = [&](int series) {
      const auto* table = walk.seen<QTreeWidget>("series");
      return table->topLevelItem(series)->icon(0).pixmap(92, 92).toImage();
    };
    walk.step(
        "both have their picture", [] {}, [&] { return coloured(picture(0)) > 200 || coloured(picture(1)) > 200; });
    keep_it(walk);
    walk.step(
        "labels are there", [] {}, [&] { return rows(walk, "structures") == 1 && walk.can_press("primary"); });
    build_the_model(walk);
    rehearse_and_report(walk, {-90, -20, -127.7});
  }

  void mr_with_labels() {
    if (!copied_to_study(
            {"totalseg_abdomen_mr_ct/example_mr_sm.nii.gz", "totalseg_abdomen_mr_ct/example_seg_mr.nii.gz"}))
      QSKIP(absent);
    Walk walk("mr-with-labels");
    make_a_case(walk, 2);
    walk.step(
        "labels are there", [] {}, [&] { return rows(walk, "structures") > 5 && walk.can_press("primary"); });
    build_the_model(walk);
    rehearse_and_report(walk, {-90.9, -36.2, 65});
  }

  void mouse_mr() {
    if (!copied_to_study({"mouse_abdomen_mr_dicom"})) QSKIP(absent);
    Walk walk("mouse-mr");
    make_a_case(walk, 1);
    const Eigen::Vector3d inside_mm(-32, 7.4, -0.9);
    walk.step(
        "point into the liver", [&] { walk.point_at(inside_mm); },
        [&] { return (walk.window().views().crosshair_mm() - inside_mm).norm() < 1; });
    walk.step(
        "outline the liver", [&] { walk.click("next_step", "primary"); },
        [&] { return rows(walk, "structures") == 1 || !walk.text("notice_text").isEmpty(); });
    walk.look("outlined");
    walk.same_as_before();
  }

  // A brain: waves to be inverted, and no liver.
  void raw_elastography() {
    if (!copied_to_study({"mre_brain_ir_charite/volunteer_A"})) QSKIP(absent);
    Walk walk("raw-elastography");
    make_a_case(walk, 4);
    const auto waves = [&] { return walk.window().findChild<WaveView*>(); };
    walk.step(
        "waves", [&] { walk.click("next_waves"); }, [&] { return waves() != nullptr && waves()->has_result(); });
    walk.look("waves");
    walk.step(
        "accept", [&] { walk.click("wave_accept"); },
        [&] { return fs::exists(hers() / "volumes/stiffness.nrrd") && walk.seen<QWidget>("next_waves") == nullptr; });
    walk.look("stiffness");
    walk.same_as_before();
  }

 private:
  static constexpr const char* absent = "no real data: set GLISSON_SHARED_DATA to the folder that holds it";

  bool copied_to_study(const std::vector<std::string>& names) {
    folder_ = std::make_unique<TemporaryFolder>();
    fs::create_directories(study());
    for (const std::string& name : names) {
      const fs::path from = glisson::test::shared_data() / name;
      if (!fs::exists(from)) return false;
      fs::copy(from, study() / from.filename(), fs::copy_options::recursive);
    }
    return true;
  }

  static int coloured(const QImage& picture) {
    int count = 0;
    for (int y = 0; y < picture.height(); ++y) {
      for (int x = 0; x < picture.width(); ++x) count += QColor(picture.pixel(x, y)).saturation() > 60 ? 1 : 0;
    }
    return count;
  }

  void make_a_case(Walk& walk, int series) {
    drop_the_study(walk, series);
    keep_it(walk);
  }
  void drop_the_study(Walk& walk, int series) {
    walk.step(
        "drop the folder", [&] { walk.drop(study()); }, [&] { return rows(walk, "series") == series; });
    walk.look("series");
  }
  void keep_it(Walk& walk) {
    walk.step(
        "keep as", [&] { walk.type("keep_as", QString::fromStdString(hers().string())); },
        [&] { return walk.can_press("make_case"); });
    walk.step(
        "make a case", [&] { walk.click("make_case"); }, [&] { return fs::exists(hers() / "case.json"); });
  }

  void outline_from(Walk& walk, const Eigen::Vector3d& inside_mm) {
    walk.step(
        "point into the liver", [&] { walk.point_at(inside_mm); },
        [&] { return (walk.window().views().crosshair_mm() - inside_mm).norm() < 5; });
    walk.step(
        "outline the liver", [&] { walk.click("next_step", "primary"); },
        [&] { return rows(walk, "structures") == 1; });
  }

  static void build_the_model(Walk& walk) {
    walk.step(
        "build the model", [&] { walk.click("next_step", "primary"); }, [&] { return walk.can_press("hoist"); });
    walk.look("model");
  }

  void rehearse_and_report(Walk& walk, const Eigen::Vector3d& inside_mm) {
    walk.step(
        "hoist", [&] { walk.click("hoist"); }, [&] { return walk.text("summary").contains("moves by up to"); });
    walk.step(
        "pull harder", [&] { walk.type("force", "3"); },
        [&] { return walk.window().rehearsal().tools().back().force_N == 3; });
    walk.look("retracted");
    walk.step(
        "to resect", [&] { walk.click("workspace_resect"); }, [&] { return walk.can_press("cut_through_crosshair"); });
    walk.step(
        "point into the liver again", [&] { walk.point_at(inside_mm); },
        [&] { return (walk.window().views().crosshair_mm() - inside_mm).norm() < 5; });
    walk.step(
        "cut", [&] { walk.click("cut_through_crosshair"); },
        [&] { return walk.text("remnant_volume").contains("ml") && walk.can_press("keep_plan"); });
    walk.look("resected");
    walk.step(
        "keep the plan", [&] { walk.click("keep_plan"); },
        [&] { return fs::exists(hers() / "results/resection/resection.json"); });
    walk.step(
        "report", [&] { walk.click("workspace_report"); }, [&] { return walk.can_press("report_html"); });
    walk.look("report");
    const fs::path html = folder_->path() / "report.html";
    walk.step(
        "save the page",
        [&] {
          walk.name_the_file(html);
          walk.click("report_html");
        },
        [&] { return fs::exists(html); });
    if (QTest::currentTestFailed()) return;
    const QString page = walk.seen<QTextBrowser>("paper")->toPlainText();
    for (const char* told : {"Planned resection", "The cut removes", "assumed"}) {
      QVERIFY2(page.contains(told), qPrintable(QString("\"%1\" is not in: %2").arg(told, page)));
    }
    // Three newtons are too many for a slab of three millimetres.
    QVERIFY(page.contains("The liver moves by up to") || page.contains("Not to be used"));
    // The parts that the cut makes are the one liver whose volume stands in the list.
    const Json plan = read_json_file(hers() / "results/resection/resection.json").value();
    const double parts_ml = plan.at("specimen_ml").get<double>() + plan.at("remnant_ml").get<double>();
    const auto outline = imaging::read_mask_file(hers() / "labels/liver.nrrd");
    QVERIFY(std::abs(parts_ml - segmentation::volume_ml(outline->mask)) < 0.01);
    walk.same_as_before();
  }

  static int rows(const Walk& walk, const char* tree) {
    const auto* found = walk.seen<QTreeWidget>(tree);
    return found != nullptr ? found->topLevelItemCount() : 0;
  }
  [[nodiscard]] fs::path hers() const { return folder_->path() / "hers.glisson"; }
  [[nodiscard]] fs::path study() const { return folder_->path() / "study"; }

  std::unique_ptr<TemporaryFolder> folder_;
};

}  // namespace
}  // namespace glisson::widgets

int main(int argc, char** argv) { return glisson::widgets::run_test<glisson::widgets::WalkTest>(argc, argv); }

#include "walk_test.moc"

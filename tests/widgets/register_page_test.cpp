// The Register workspace, driven as a person drives it: an example is made, registered by two algorithms, looked
// through, and asked about one place. The registration that the example gives is wrong in a place that is known.

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>

#include "base/files.h"
#include "kept_pictures.h"
#include "run_test.h"
#include "shown.h"
#include "studies/review/example_sequence.h"
#include "support/folders.h"
#include "widgets/register/register_page.h"
#include "widgets/words/number_box.h"

namespace glisson::widgets {
namespace {

namespace fs = std::filesystem;
using registration_quality::SequenceMethod;

class RegisterPageTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    studies::ExampleSequenceOptions options;
    options.frames = 20;
    options.landmarks = 50;
    options.step_px = 14;
    options.outlier_share = 0;
    const auto made = studies::write_example_sequence(folder_.path() / "example", options);
    QVERIFY2(made.has_value(), made ? "" : made.error().message().c_str());
    file_ = *made;
  }

  void init() {
    page_ = std::make_unique<RegisterPage>(work_);
    page_->resize(1440, 900);
    page_->show();
    QVERIFY(QTest::qWaitForWindowExposed(page_.get()));
  }

  void without_a_sequence_says_what_it_needs() {
    QVERIFY(!page_->has_sequence());
    auto* make = child<RegisterWelcome>("register_welcome")->findChild<QPushButton*>("primary");
    QVERIFY(make->isVisible() && make->isEnabled() && !make->toolTip().isEmpty());
    QVERIFY(!child<QWidget>("first_video")->isVisible());
    keep_picture("register_welcome");
  }

  void makes_an_example_by_a_click_and_finds_it_again() {
    auto* make = child<RegisterWelcome>("register_welcome")->findChild<QPushButton*>("primary");
    click(make);
    QTRY_VERIFY_WITH_TIMEOUT(page_->has_sequence(), 120000);
    QTRY_VERIFY(!work_.busy());
    QCOMPARE(child<QLabel>("frame_number")->text(), QString("Frame 1 of 40"));
    QVERIFY(child<QLabel>("origin")->isVisible());
    // The second time it is there already.
    page_ = std::make_unique<RegisterPage>(work_);
    page_->show();
    click(child<RegisterWelcome>("register_welcome")->findChild<QPushButton*>("primary"));
    QTRY_VERIFY_WITH_TIMEOUT(page_->has_sequence(), 120000);
    QCOMPARE(child<Timeline>("timeline")->frames(), 40);
  }

  void a_sequence_without_a_camera_is_judged_but_not_drawn() {
    const fs::path folder = folder_.path() / "blind";
    fs::copy(file_.parent_path(), folder);
    auto document = read_text_file(folder / "sequence.json").value();
    const auto from = document.find("\"camera\"");
    const auto to = document.find("\"registered\"");
    QVERIFY(from < to && to != std::string::npos);
    document.erase(from, to - from);
    QVERIFY(write_text_file(folder / "sequence.json", document).has_value());
    page_->open(folder / "sequence.json");
    QTRY_VERIFY_WITH_TIMEOUT(page_->has_sequence(), 10000);
    QTRY_VERIFY(!work_.busy());
    judge(SequenceMethod::given, std::nullopt);
    QVERIFY(child<HeatVideo>("first_video")->seen().empty());
    QVERIFY(child<HeatVideo>("first_video")->accessibleDescription().contains("no camera"));
    QVERIFY(number(child<FiguresTable>("figures"), FiguresTable::tre, 0) > 0);
  }

  void refuses_what_is_no_sequence_with_a_sentence() {
    const fs::path file = folder_.path() / "no.json";
    QVERIFY(write_text_file(file, "{\"frames\": 3}").has_value());
    page_->open(file);
    QTRY_VERIFY(child<QLabel>("register_says")->text().contains("no list of frames"));
    QVERIFY(!page_->has_sequence());
  }

  void judges_two_algorithms_on_one_scale() {
    open();
    QVERIFY(child<QLabel>("origin")->isVisible());
    QVERIFY(child<QLabel>("origin")->text().startsWith("SIMULATED"));
    QVERIFY(child<HeatVideo>("first_video")->seen().empty());
    judge(SequenceMethod::given, SequenceMethod::icp);
    QVERIFY(!child<HeatVideo>("first_video")->seen().empty());
    QVERIFY(!child<HeatVideo>("second_video")->seen().empty());
    const auto* legend = child<HeatLegend>("heat_legend");
    const auto& [low, high] = legend->scale().range;
    QCOMPARE(high, 1.0);
    for (const int side : {0, 1}) {
      const auto& values = page_->judged(side)->quality.correlation;
      std::vector<double> sorted = values;
      std::sort(sorted.begin(), sorted.end());
      QVERIFY(low <= sorted[sorted.size() / 10]);
    }
    // What the sequence gives leaves the model where its fault is; nearest points lie on it, wherever they slide.
    const auto* figures = child<FiguresTable>("figures");
    QCOMPARE(figures->horizontalHeaderItem(0)->text(), QString("Given"));
    QVERIFY(number(figures, FiguresTable::rmse, 1) < 0.5 * number(figures, FiguresTable::rmse, 0));
    // What to conclude stands in one sentence: where the fault lies, as the sequence's truth has it, on the left.
    const auto* reading = child<QLabel>("register_reading");
    QVERIFY2(reading->isVisible() && reading->text().contains("Of Given do not trust the left edge"),
             qPrintable(reading->text()));
    const QString at_5_mm = reading->text();
    click(child<QPushButton>("tolerance_3"));
    QVERIFY(reading->text() != at_5_mm && reading->text().contains("3.0 mm"));
    click(child<QPushButton>("tolerance_5"));
    // A picture has one meaning: hatched by mm only where the colours are mm.
    const auto hatched = [this](HeatValue value) {
      const scene::HeatMesh mesh = heat_mesh(page_->judged(0)->quality, value, 0, 0.5);
      return std::count(mesh.verdicts.begin(), mesh.verdicts.end(), scene::HeatMesh::Verdict::rejected);
    };
    QCOMPARE(hatched(HeatValue::correlation), 0);
    QVERIFY(hatched(HeatValue::error) > 0);
    child<Timeline>("timeline")->show_frame(7);
    auto* video = child<HeatVideo>("first_video");
    QTest::mouseClick(video, Qt::LeftButton, {}, video->on_widget({161, 234}).toPoint());
    keep_picture("register_page");
  }

  void the_worst_triangles_lie_where_the_fault_is() {
    open();
    judge(SequenceMethod::given, std::nullopt);
    QVERIFY(!child<HeatVideo>("second_video")->isVisible());
    QFile truth(QString::fromStdString((file_.parent_path() / "truth.json").string()));
    QVERIFY(truth.open(QIODevice::ReadOnly));
    const QJsonArray center = QJsonDocument::fromJson(truth.readAll()).object()["fault_center_mm"].toArray();
    const Eigen::Vector3d fault_mm(center[0].toDouble(), center[1].toDouble(), center[2].toDouble());
    const registration_quality::Quality& quality = page_->judged(0)->quality;
    double near = 0, far = 0;
    int near_count = 0, far_count = 0;
    for (std::size_t k = 0; k < quality.correlation.size(); ++k) {
      const auto& corner = quality.mesh.points_mm[static_cast<std::size_t>(quality.mesh.triangles[k][0])];
      const double distance_mm = (corner - fault_mm).norm();
      if (distance_mm < 32) near += quality.correlation[k], ++near_count;
      if (distance_mm > 64) far += quality.correlation[k], ++far_count;
    }
    QVERIFY(near_count > 5 && far_count > 5);
    QVERIFY2(near / near_count < far / far_count - 0.2,
             qPrintable(QString("%1 %2").arg(near / near_count).arg(far / far_count)));
  }

  void the_tolerance_rejects_more_as_it_falls() {
    open();
    judge(SequenceMethod::given, std::nullopt);
    const auto* figures = child<FiguresTable>("figures");
    click(child<QPushButton>("tolerance_10"));
    QCOMPARE(page_->tolerance_mm(), 10.0);
    const double at_10 = number(figures, FiguresTable::rejected, 0);
    QSlider* slider = child<NumberSlider>("tolerance")->findChild<QSlider*>();
    slider->setFocus();
    for (int i = 0; i < 14; ++i) QTest::keyClick(slider, Qt::Key_Left);
    QCOMPARE(page_->tolerance_mm(), 3.0);
    const double at_3 = number(figures, FiguresTable::rejected, 0);
    QVERIFY(at_3 > at_10);
    QCOMPARE(at_3, std::round(1000 * rejected_fraction(page_->judged(0)->quality, 3)) / 10);
    QVERIFY(child<HeatVideo>("first_video")->title().contains("3.0 mm"));
  }

  void plays_and_steps_through_the_frames() {
    open();
    judge(SequenceMethod::given, std::nullopt);
    auto* timeline = child<Timeline>("timeline");
    page_->setFocus();
    QTest::keyClick(page_.get(), Qt::Key_Right);
    QTest::keyClick(page_.get(), Qt::Key_Right);
    QCOMPARE(timeline->frame(), 2);
    QCOMPARE(child<QLabel>("frame_number")->text(), QString("Frame 3 of 20"));
    QTest::keyClick(page_.get(), Qt::Key_Left);
    QCOMPARE(timeline->frame(), 1);
    QTest::keyClick(page_.get(), Qt::Key_End);
    QCOMPARE(timeline->frame(), 19);
    QTest::keyClick(page_.get(), Qt::Key_Home);
    const std::size_t triangle = some_triangle();
    const QPointF before = *child<HeatVideo>("first_video")->middle_of(triangle);
    QTest::keyClick(page_.get(), Qt::Key_Space);
    QVERIFY(timeline->playing());
    QTRY_VERIFY(timeline->frame() > 2);
    click(child<QPushButton>("play"));
    QVERIFY(!timeline->playing());
    timeline->show_frame(10);
    const QPointF after = *child<HeatVideo>("first_video")->middle_of(triangle);
    const double moved = QLineF(before, after).length();
    QVERIFY2(moved > 5, qPrintable(QString::number(moved)));  // the mesh goes with the breath
  }

  void a_click_on_a_triangle_shows_its_history() {
    open();
    judge(SequenceMethod::given, SequenceMethod::gnra);
    auto* video = child<HeatVideo>("first_video");
    const std::size_t triangle = some_triangle();
    QTest::mouseClick(video, Qt::LeftButton, {}, video->on_widget(*video->middle_of(triangle)).toPoint());
    QVERIFY(page_->chosen()[0].has_value());
    QCOMPARE(child<NumberBox>("triangle")->value(), static_cast<double>(*page_->chosen()[0] + 1));
    auto* history = child<TriangleHistory>("history");
    QCOMPARE(history->lines(), page_->chosen()[1] ? 2 : 1);
    QVERIFY(child<QLabel>("place")->text().contains("correlation"));
    QTest::keyClick(page_.get(), Qt::Key_Right);
    QCOMPARE(history->frame(), 1.0);
    keep_picture("register_history");
    // By its number, for whoever has no mouse; and beside the mesh, nothing is chosen.
    child<NumberBox>("triangle")->setValue(1);
    QCOMPARE(*page_->chosen()[0], std::size_t{0});
    QTest::mouseClick(video, Qt::LeftButton, {}, video->on_widget({2, 2}).toPoint());
    QVERIFY(!page_->chosen()[0].has_value());
    // Then the plots are of the whole registration, frame by frame: TRE and RMSE.
    QCOMPARE(history->lines(), 2);
    const auto drawn = history->drawn_mm();
    QCOMPARE(drawn.size(), std::size_t{4});
    for (const int side : {0, 1}) {
      const auto& quality = page_->judged(side)->quality;
      const auto first = static_cast<std::size_t>(2 * side);
      QCOMPARE(drawn[first].size(), std::size_t{20});
      QVERIFY(drawn[first] == quality.tre_mm);
      QVERIFY(drawn[first + 1] == quality.rmse_mm);
    }
    keep_picture("register_frames");
  }

  void can_be_cancelled_and_goes_on_afterwards() {
    open();
    choose(SequenceMethod::icp, std::nullopt);
    click(compute_button());
    auto* cancel = child<QPushButton>("cancel_registering");
    QTRY_VERIFY(cancel->isVisible());
    QVERIFY(!compute_button()->isEnabled());
    click(cancel);
    QTRY_VERIFY_WITH_TIMEOUT(!work_.busy(), 30000);
    QVERIFY(page_->judged(0) == nullptr);
    QVERIFY(compute_button()->isEnabled());
    judge(SequenceMethod::given, std::nullopt);
    QVERIFY(page_->judged(0) != nullptr);
  }

  void every_control_has_a_name_and_says_what_it_does() {
    open();
    for (auto* control : page_->findChildren<QWidget*>()) {
      const bool is_control = qobject_cast<QAbstractButton*>(control) != nullptr ||
                              qobject_cast<QComboBox*>(control) != nullptr ||
                              qobject_cast<QAbstractSpinBox*>(control) != nullptr;
      if (!is_control || !control->isVisible() || control->inherits("QTableCornerButton")) continue;
      const auto* button = qobject_cast<QAbstractButton*>(control);
      const QString which = control->objectName() + " (" + control->metaObject()->className() + ")";
      const bool named = !control->accessibleName().isEmpty() || (button != nullptr && !button->text().isEmpty());
      QVERIFY2(named, qPrintable(which + " has no name"));
      QVERIFY2(!control->toolTip().isEmpty(), qPrintable(which + " has no tooltip"));
    }
  }

  void speaks_other_languages_while_it_runs() {
    open();
    choose_language("de");
    QCoreApplication::processEvents();
    QCOMPARE(child<QLabel>("frame_number")->text(), QString("Bild 1 von 20"));
    QVERIFY(child<QLabel>("origin")->text().startsWith("SIMULIERT"));
    keep_picture("register_page_de");
    choose_language("en");
  }

 private:
  template <typename Widget>
  Widget* child(const char* name) {
    return child_of<Widget>(*page_, name);
  }
  QPushButton* compute_button() { return child<AlgorithmChoice>("algorithms")->findChild<QPushButton*>("primary"); }
  static void click(QWidget* widget) { QTest::mouseClick(widget, Qt::LeftButton); }
  void open() {
    page_->open(file_);
    QTRY_VERIFY_WITH_TIMEOUT(page_->has_sequence(), 10000);
    QTRY_VERIFY(!work_.busy());
  }
  void choose(SequenceMethod first, std::optional<SequenceMethod> second) {
    for (const auto& [box, method] : {std::pair{"first_method", std::optional(first)}, {"second_method", second}}) {
      auto* combo = child<QComboBox>(box);
      combo->setCurrentIndex(combo->findData(method ? static_cast<int>(*method) : -1));
    }
  }
  void judge(SequenceMethod first, std::optional<SequenceMethod> second) {
    choose(first, second);
    const QSignalSpy done(page_.get(), &RegisterPage::computed);
    click(compute_button());
    QTRY_VERIFY_WITH_TIMEOUT(!done.isEmpty(), 120000);
    QVERIFY(!compute_button()->isEnabled() && compute_button()->toolTip().contains("already"));
    QTRY_VERIFY(!work_.busy());
  }
  // In the middle of the mesh.
  std::size_t some_triangle() {
    const auto* video = child<HeatVideo>("first_video");
    return video->triangle_at({300, 200}).value_or(video->seen().front().triangle);
  }
  static double number(const FiguresTable* table, int row, int column) {
    return table->item(row, column)->text().section(' ', 0, 0).toDouble();
  }
  void keep_picture(const char* name) {
    QTest::qWait(100);
    const QString pictures = glisson::test::kept_pictures();
    QVERIFY(QDir().mkpath(pictures));
    QVERIFY(page_->grab().save(pictures + "/" + name + ".png"));
  }

  TemporaryFolder folder_;
  fs::path file_;
  BackgroundWork work_;
  std::unique_ptr<RegisterPage> page_;
};

}  // namespace
}  // namespace glisson::widgets

int main(int argc, char** argv) { return glisson::widgets::run_test<glisson::widgets::RegisterPageTest>(argc, argv); }

#include "register_page_test.moc"

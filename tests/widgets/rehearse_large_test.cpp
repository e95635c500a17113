// Large deformations in the Rehearse workspace: offered where strains pass those of a linear liver, the shape that of
// the session without a window, its bound shown until it is at rest, and small ones to be had again.

#include <QComboBox>
#include <QPushButton>
#include <QtTest>

#include "kept_pictures.h"
#include "probe_on_block.h"
#include "run_test.h"
#include "shown.h"
#include "widgets/rehearse/rehearse_panel.h"
#include "widgets/words/language.h"

namespace glisson::widgets {
namespace {

class RehearseLargeTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { window_ = shown_window({1400, 950}); }
  void init() { show_probe_on_block(*window_); }

  // The block's free end is drawn to the side, by a force that strains it beyond 20 %.
  void are_offered_where_the_linear_answer_ends_and_give_the_shape_of_the_session() {
    auto* offer = child<QPushButton>("use_large");
    QVERIFY(!offer->isVisible());
    QCOMPARE(child<QComboBox>("tool")->currentText(), "Palpation probe");
    QVERIFY(why().contains("Small deformations: enough"));
    bend();
    QVERIFY(rehearsal().state()->validity.largest_strain > mechanics::small_strain_limit);
    QVERIFY(child<QLabel>("solving_sign")->text().contains("Outside of the model"));
    QVERIFY(why().contains("beyond 20 %"));
    QVERIFY(offer->isVisible());
    QVERIFY(!child<QLabel>("error_bound")->isVisible());
    const rehearsal::RehearsalState linear = *rehearsal().state();
    const PlacedTool tool = rehearsal().tools().back();
    QTest::qWait(200);
    window_->grab().save(test::kept_picture("rehearse-offers-large.png"));

    QTest::mouseClick(offer, Qt::LeftButton);
    QCOMPARE(rehearsal().deformations(), Deformations::large);
    QCOMPARE(rehearsal().tools(), std::vector{tool});
    QCOMPARE(rehearsal().force_N(), tool.force_N);
    come_to_rest();
    QVERIFY(!offer->isVisible());
    QCOMPARE(child<QComboBox>("deformations")->currentIndex(), 2);
    QVERIFY(why().contains("as you chose"));
    QVERIFY(child<QLabel>("solving_sign")->text().contains("Solved"));
    QVERIFY(child<QLabel>("error_bound")->isVisible());
    QVERIFY(*rehearsal().error_bound_mm() <= 0.5);
    QVERIFY(child<QLabel>("error_bound")->text().contains("mm of rest"));
    QCOMPARE(rehearsal().state()->validity.state(), mechanics::AnswerState::within);
    QVERIFY(!rehearsal().force_within_the_model_N(3).has_value());
    window_->grab().save(test::kept_picture("rehearse-large.png"));
    choose_language("de");
    QTest::qWait(200);
    const QString in_german = child<QLabel>("error_bound")->text();
    window_->grab().save(test::kept_picture("rehearse-large-de.png"));
    choose_language("en");
    QTest::qWait(200);
    QVERIFY2(in_german.contains("von der Ruhelage"), qPrintable(in_german));

    // A bent beam keeps its length: its end does not only go to the side, as small rotations have it, but comes back
    // towards what holds it. What the linear answer adds in length is gone.
    const auto end_mm = [](const rehearsal::RehearsalState& state) { return state.patient.landmarks[0].displaced_mm; };
    const Eigen::Vector3d rest_mm(100, 40, 40);
    QVERIFY(end_mm(linear).y() < rest_mm.y() - 10 && end_mm(*rehearsal().state()).y() < rest_mm.y() - 10);
    QVERIFY2(end_mm(*rehearsal().state()).x() < end_mm(linear).x() - 1,
             qPrintable(QString("%1 %2").arg(end_mm(*rehearsal().state()).x()).arg(end_mm(linear).x())));

    // The same to the bit as without a window, by the same commands.
    rehearsal::RehearsalSetup setup = *own_setup();
    auto engine =
        rehearsal::SessionEngine::create(rehearsal::with_law(setup, mechanics::MaterialLaw::neo_hookean)).value();
    engine.step(rehearsal::HoldTool{contact_tool(tool, "tool", Touch::patch).value()});
    for (std::uint64_t k = 0; k < rehearsal().contact()->settles; ++k) engine.step(rehearsal::Settle{});
    QCOMPARE(engine.state().digest, rehearsal().contact()->digest);
    QVERIFY((engine.state().patient.landmarks[0].displaced_mm - end_mm(*rehearsal().state())).norm() < 1e-12);

    // One moment was recorded, with what it came to.
    QCOMPARE(rehearsal().track().moments().size(), std::size_t{1});
    QVERIFY(rehearsal().track().moments().front().contact->settled);

    // Small ones again, by the keys of the box: the shape that was.
    auto* choice = child<QComboBox>("deformations");
    choice->setFocus();
    QTest::keyClick(choice, Qt::Key_Home);
    QCOMPARE(rehearsal().deformations(), Deformations::small);
    QTRY_COMPARE_WITH_TIMEOUT(rehearsal().solving(), Solving::solved, patience_ms);
    QVERIFY(rehearsal().state()->patient.surface_mm == linear.patient.surface_mm);
    QVERIFY(!child<QLabel>("error_bound")->isVisible());
    QVERIFY(offer->isVisible());
  }

  void a_first_picture_says_that_it_settles_until_it_rests() {
    bend();
    std::vector<std::pair<QString, std::optional<double>>> seen;
    QObject here;  // nobody writes into `seen` after a failure
    const auto watched = connect(&rehearsal(), &LiveRehearsal::state_changed, &here, [&] {
      if (rehearsal().contact() == nullptr) return;
      seen.emplace_back(child<QLabel>("solving_sign")->text(), rehearsal().error_bound_mm());
    });
    QTest::mouseClick(child<QPushButton>("use_large"), Qt::LeftButton);
    QVERIFY(child<QLabel>("solving_sign")->text().contains("Preparing"));
    come_to_rest();
    disconnect(watched);
    QVERIFY(!seen.empty());
    // Never shown as solved while the bound passes half a millimetre.
    for (const auto& [sign, bound_mm] : seen) {
      QVERIFY(bound_mm.has_value());
      QVERIFY2(*bound_mm <= 0.5 || !sign.contains("Solved"), qPrintable(sign));
    }
    QVERIFY(*seen.back().second <= 0.5);
    // A moment seen again stands as it was recorded, also while the present goes on.
    rehearsal().set_force_N(1.2);
    come_to_rest();
    QVERIFY(rehearsal().track().moments().size() >= 2);
    const double now_mm = rehearsal().state()->patient.max_displacement_mm;
    rehearsal().show_moment(0);
    QVERIFY(rehearsal().state()->patient.max_displacement_mm > now_mm + 1);
    QCOMPARE(rehearsal().solving(), Solving::solved);
    rehearsal().go_on();
    QCOMPARE(rehearsal().state()->patient.max_displacement_mm, now_mm);
    const QString table = QString::fromStdString(rehearsal().track().csv({"tumour-1", "hilum"})).trimmed();
    QVERIFY(table.split('\n').last().split(',').last().toDouble() <= 0.5);
    QVERIFY(!table.split('\n').last().split(',').last().isEmpty());
  }

  // A probe and a grasper, both kept from small deformations to large ones and back.
  void rigid_tools_touch_the_liver_at_large_deformations() {
    rehearsal().set_touch(Touch::rigid);
    QTRY_COMPARE_WITH_TIMEOUT(rehearsal().solving(), Solving::solved, patience_ms);
    QTest::mouseClick(child<QPushButton>("keep"), Qt::LeftButton);
    rehearsal().hold({"grasper", {90, 0, 40}, {0, -1, 0}, 12, {0, -1, 0}, 0.5});
    QTRY_VERIFY_WITH_TIMEOUT(rehearsal().solving() == Solving::solved && rehearsal().solids().size() == 2, patience_ms);
    const std::vector<PlacedTool> tools = rehearsal().tools();
    auto* choice = child<QComboBox>("deformations");
    choice->setFocus();
    QTest::keyClick(choice, Qt::Key_L);  // the one entry that begins with it
    QCOMPARE(rehearsal().deformations(), Deformations::large);
    QCOMPARE(rehearsal().touch(), Touch::rigid);
    QCOMPARE(rehearsal().tools(), tools);
    come_to_rest();
    QCOMPARE(rehearsal().solids().size(), std::size_t{2});
    QVERIFY(*rehearsal().error_bound_mm() <= 0.5);
    const auto& contacts = rehearsal().contact()->patient_step.tools;
    QVERIFY(std::abs(contacts[0].force_mN.norm() - 1000) < 50);
    QVERIFY(std::abs(contacts[1].force_mN.norm() - 500) < 1e-6);
    QVERIFY(rehearsal().state()->reference.has_value());
    // The planned cut is led on at large ones too, and each step comes to rest.
    const auto plane = geometry::CutSurface::plane({63, 0, 0}, {1, 0, 0}).value();
    window_->findChild<RehearsePanel*>()->show_plan(
        rehearsal::course_of(test::box_of_tetrahedra({6, 4, 4}, {120, 80, 80}), plane).value(), {},
        {"liver", "tumour-1"});
    for (int step = 1; step <= 3; ++step) {
      QTRY_VERIFY_WITH_TIMEOUT(child<QPushButton>("advance_cut")->isEnabled(), patience_ms);
      QTest::mouseClick(child<QPushButton>("advance_cut"), Qt::LeftButton);
      QTRY_COMPARE_WITH_TIMEOUT(rehearsal().cut_steps(), step, patience_ms);
      come_to_rest();
      QVERIFY(*rehearsal().error_bound_mm() <= 0.5);
    }
    QVERIFY(rehearsal().state()->cut->open_mm2 > 0);
    QVERIFY(child<QLabel>("cut_state")->text().contains("% of the section is open"));
    window_->grab().save(test::kept_picture("rehearse-large-cut.png"));
    QTest::mouseClick(child<QPushButton>("take_cut_back"), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(rehearsal().cut_steps(), 2, patience_ms);
    QTest::keyClick(choice, Qt::Key_Home);
    QCOMPARE(rehearsal().tools(), tools);
    QTRY_COMPARE_WITH_TIMEOUT(rehearsal().solving(), Solving::solved, patience_ms);
    QVERIFY(child<QPushButton>("advance_cut")->isEnabled());
  }

  void begin_small_with_every_patient_and_stay_as_chosen_when_it_is_read_anew() {
    rehearsal().set_deformations(Deformations::large);
    const auto setup = own_setup();
    auto body = rehearsal::StaticRehearsal::create(*setup).value();
    rehearsal().exchange_body(std::make_shared<rehearsal::StaticRehearsal>(std::move(body)), setup);
    QCOMPARE(rehearsal().deformations(), Deformations::large);
    QVERIFY(rehearsal().has_tool());
    come_to_rest();
    show_probe_on_block(*window_);
    QCOMPARE(rehearsal().deformations(), Deformations::small);
    QCOMPARE(child<QComboBox>("deformations")->currentIndex(), 0);
  }

  void tissue_with_a_grain_stays_with_small_ones() {
    rehearsal::RehearsalSetup setup = *own_setup();
    setup.options.anisotropy = mechanics::TransverseIsotropy{};
    rehearsal().set_body(rehearsal_of(*own_setup()), std::make_shared<rehearsal::RehearsalSetup>(setup));
    QVERIFY(!child<QComboBox>("deformations")->isEnabled());
    QVERIFY(why().contains("grain"));
    rehearsal().set_deformations(Deformations::large);
    QCOMPARE(rehearsal().deformations(), Deformations::small);
  }

  void cleanupTestCase() { window_.reset(); }

 private:
  LiveRehearsal& rehearsal() { return window_->rehearsal(); }

  void bend() {
    rehearsal().set_direction({0, -1, 0});
    rehearsal().set_force_N(2.5);
    QTRY_COMPARE_WITH_TIMEOUT(rehearsal().solving(), Solving::solved, patience_ms);
  }
  void come_to_rest() {
    QTRY_VERIFY2_WITH_TIMEOUT(rehearsal().solving() == Solving::solved || rehearsal().solving() == Solving::refused,
                              "no rest", 4 * patience_ms);
    QVERIFY2(rehearsal().solving() == Solving::solved, qPrintable(child<QLabel>("solving_trouble")->text()));
  }
  static std::shared_ptr<rehearsal::RehearsalSetup> own_setup() {
    return std::make_shared<rehearsal::RehearsalSetup>(*block_with_a_tumour().rehearsal_setup);
  }
  static std::shared_ptr<const rehearsal::StaticRehearsal> rehearsal_of(rehearsal::RehearsalSetup setup) {
    return std::make_shared<rehearsal::StaticRehearsal>(rehearsal::StaticRehearsal::create(std::move(setup)).value());
  }
  QString why() { return child<QLabel>("deformations_why")->text(); }

  template <typename Widget>
  Widget* child(const char* name) {
    return child_of<Widget>(*window_, name);
  }

  std::unique_ptr<MainWindow> window_;
};

}  // namespace
}  // namespace glisson::widgets

int main(int argc, char** argv) { return glisson::widgets::run_test<glisson::widgets::RehearseLargeTest>(argc, argv); }

#include "rehearse_large_test.moc"

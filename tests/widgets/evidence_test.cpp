// Evidence, driven as a person drives it: the example that ships, a palpation whose missing effect is known, a report
// opened again, other trials predicted, and evidence accepted for a patient and taken back.

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTimer>
#include <QtTest>
#include <set>

#include "base/files.h"
#include "base/json.h"
#include "casefile/case.h"
#include "closedloop/explain.h"
#include "closedloop/hardware/model.h"
#include "closedloop/palpation/model.h"
#include "closedloop/palpation_bodies.h"
#include "geometry/mesh_file.h"
#include "kept_pictures.h"
#include "modelled_case.h"
#include "run_test.h"
#include "shown.h"
#include "support/folders.h"
#include "widgets/evidence/effect_words.h"
#include "widgets/evidence/evidence_view.h"
#include "widgets/evidence/svg_view.h"
#include "widgets/main_window.h"
#include "widgets/words/language.h"
#include "widgets/words/paths.h"

namespace glisson::widgets {
namespace {

namespace fs = std::filesystem;

constexpr int patience_ms = 120000;  // a palpation is traced on a machine that does other work too
constexpr double true_factor = 0.5;

// A pad that is half as stiff as declared, written as the files that a laboratory would write.
fs::path soft_pad(const fs::path& folder) {
  using namespace closedloop;
  Palpation declared = closedloop::test::pad({.bricks = {4, 4, 2}, .markers = 24, .hold_on = false});
  const auto model = palpation_model(declared);
  if (!model) qFatal("%s", model.error().message().c_str());
  const Settings truth{{"stiffness-scale", "", Eigen::VectorXd::Constant(1, true_factor)}};
  const Palpation seen = closedloop::test::measured_as(declared, (*model)->predict(truth).value(), declared.noise_mm);
  geometry::TetMesh mesh = seen.mesh;
  if (!geometry::write_tetrahedra(folder / "pad.vtu", mesh)) qFatal("the mesh could not be written");
  Json json{{"format", "glisson-experiment/1"},
            {"kind", "palpation"},
            {"title", "Pad cut of Small, table 1"},
            {"specimen",
             {{"mesh", "pad.vtu"}, {"youngs_modulus_kPa", 17.5}, {"poisson_ratio", 0.45}, {"density_kg_m3", 1000}}},
            {"supports", Json::array({{{"point_array", "fixed"}}})},
            {"noise_mm", seen.noise_mm},
            {"trials", Json::array()}};
  for (const PalpationTrial& trial : seen.trials) {
    Json one{{"id", trial.id},
             {"tool",
              {{"center_mm", json_of(trial.tool.center_mm)},
               {"radius_mm", trial.tool.radius_mm},
               {"direction", json_of(trial.tool.direction)}}},
             {"samples", Json::array()}};
    int number = 0;
    for (const PalpationSample& sample : trial.samples) {
      Json state{{"time_s", sample.time_s}, {"force_N", units::N_from_mN(sample.force_mN)}};
      if (!sample.markers.empty()) {
        const std::string name = trial.id + "_" + std::to_string(number++) + ".csv";
        std::string table = "id,rest_x_mm,rest_y_mm,rest_z_mm,x_mm,y_mm,z_mm\n";
        for (const Marker& marker : sample.markers) {
          table += marker.id;
          for (const Eigen::Vector3d& at : {marker.rest_mm, marker.position_mm}) {
            for (int axis = 0; axis < 3; ++axis) table += "," + QString::number(at[axis], 'f', 6).toStdString();
          }
          table += "\n";
        }
        if (!write_text_file(folder / name, table)) qFatal("no table");
        state["markers"] = name;
      }
      one["samples"].push_back(std::move(state));
    }
    json["trials"].push_back(std::move(one));
  }
  const fs::path file = folder / "pad.json";
  if (!write_json_file(file, json)) qFatal("no experiment");
  return file;
}

class EvidenceTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    window_ = shown_window({1500, 950});
    window_->go_to("evidence");
    view_ = window_->findChild<EvidenceView*>();
    QVERIFY(view_->isVisible());
    QVERIFY(QDir().mkpath(pictures_));
    folder_ = fs::path(temporary_.path().toStdString());
  }

  void says_what_each_button_waits_for() {
    QVERIFY(!child<QPushButton>("evidence_accept")->isEnabled());
    QVERIFY(child<QPushButton>("evidence_accept")->toolTip().contains("Open measurements first"));
    QVERIFY(!child<QPushButton>("evidence_take_back")->isEnabled());
    QVERIFY(!child<QPushButton>("evidence_save")->isEnabled());
  }

  void explains_the_example_that_ships() {
    finish([this] { QTest::mouseClick(child<QPushButton>("evidence_example"), Qt::LeftButton); });
    QVERIFY(view_->record() != nullptr);
    // The sample stiffens and gives way while it is held, which its file does not declare.
    QCOMPARE(view_->record()->verdict, std::string("explained"));
    QCOMPARE(view_->record()->effects.size(), std::size_t{2});
    QCOMPARE(view_->record()->effects[0].kind, std::string("strain-stiffening"));
    QCOMPARE(view_->record()->effects[1].kind, std::string("viscoelastic-creep"));
    // In plain words first: whose, what, and how much of the error it takes away; numbers are asked for.
    const QString verdict = child<QLabel>("patient_name")->text();
    QVERIFY2(verdict.contains("SIMULATED: a sample of liver tissue in compression") &&
                 verdict.contains("Stiffens as it deforms") &&
                 QRegularExpression("takes away 9\\d %").match(verdict).hasMatch(),
             qPrintable(verdict));
    const auto* candidates = child<QTableWidget>("evidence_candidates");
    QVERIFY(!candidates->isVisible());
    child<QCheckBox>("evidence_details")->click();
    QVERIFY(candidates->isVisible());
    QCOMPARE(candidates->item(0, CandidatesTable::delta_bic)->text(), QString("very strong"));
    QCOMPARE(candidates->rowCount(), int(view_->record()->ranking.size()));
    QCOMPARE(candidates->item(0, CandidatesTable::name)->text().section(" (", 0, 0), QString("Stiffens as it deforms"));
    // By how well they predict what they were not fitted to.
    QVERIFY(candidates->item(0, CandidatesTable::held_out)->text().toDouble() <
            candidates->item(1, CandidatesTable::held_out)->text().toDouble());
    QVERIFY(child<QPushButton>("evidence_save")->isEnabled());
    QVERIFY(child<QPushButton>("evidence_accept")->toolTip().contains("case"));
    QTest::qWait(200);
    QVERIFY(window_->grab().save(pictures_ + "/evidence_example.png"));
  }

  void predicts_trials_that_it_was_not_fitted_to() {
    const auto resources = resource_folder();
    QVERIFY(bool(resources));
    finish([&] { view_->compare_trials(*resources / "examples" / "tissue" / "heldout.json"); });
    const auto* table = child<QTableWidget>("evidence_comparison");
    QVERIFY(table->isVisible());
    QCOMPARE(table->rowCount(), 2);
    for (int row = 0; row < 2; ++row) {
      QVERIFY(table->item(row, 2)->text().toDouble() < 0.2 * table->item(row, 1)->text().toDouble());
    }
  }

  void finds_what_a_palpation_lacks_and_shows_it_in_space() {
    const fs::path experiment = soft_pad(folder_);
    finish([&] { view_->open(experiment); });
    QCOMPARE(view_->record()->verdict, std::string("explained"));
    QCOMPARE(view_->record()->effects.front().kind, std::string("stiffness-scale"));
    auto* found = child<FoundTree>("evidence_found");
    const QString value = found->topLevelItem(0)->child(0)->text(1);
    QVERIFY2(std::abs(value.section(" ", 0, 0).toDouble() - true_factor) < 0.03, qPrintable(value));
    SpaceView& space = view_->answer().residual_space();
    QVERIFY(space.isVisible());
    QTest::qWait(200);
    const QImage before = space.picture();
    QVERIFY(window_->grab().save(pictures_ + "/evidence_before.png"));
    QTest::mouseClick(child<QPushButton>("evidence_after"), Qt::LeftButton);
    QTest::qWait(100);
    QVERIFY(space.picture() != before);
    QVERIFY(window_->grab().save(pictures_ + "/evidence_after.png"));
    auto* trial = child<QComboBox>("evidence_trial");
    QCOMPARE(trial->count(), 4);
    trial->setFocus();
    QTest::keyClick(trial, trial->currentIndex() == 0 ? Qt::Key_Down : Qt::Key_Up);
  }

  void cancels_and_says_so() {
    QSignalSpy finished(&window_->work(), &BackgroundWork::finished);
    view_->open(folder_ / "pad.json");
    QVERIFY(!child<QPushButton>("evidence_example")->isEnabled());
    QTest::mouseClick(window_->findChild<QPushButton*>("cancel"), Qt::LeftButton);
    QVERIFY(finished.wait(patience_ms));
    QTRY_VERIFY(child<QPushButton>("evidence_example")->isEnabled());
    QVERIFY(view_->record() != nullptr);  // what was there stays
  }

  void accepts_evidence_for_the_patient_and_takes_it_back() {
    const fs::path folder = test::modelled_case(folder_);
    window_->open_path(folder);
    QTRY_VERIFY_WITH_TIMEOUT(child<QPushButton>("evidence_accept")->isEnabled(), patience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(!window_->work().busy(), patience_ms);
    // A tool is in hand, and what it did is recorded.
    LiveRehearsal& rehearsal = window_->rehearsal();
    QSignalSpy placed(&rehearsal, &LiveRehearsal::placed);
    const Eigen::Vector3d top = test::small_middle_mm() + Eigen::Vector3d(0, -12, 0);
    rehearsal.hold({.preset = {},
                    .center_mm = top,
                    .outward = {0, -1, 0},
                    .radius_mm = 8,
                    .direction = {0, -1, 0},
                    .force_N = 0.1});
    QVERIFY(placed.wait(patience_ms));
    const std::size_t moments = rehearsal.track().moments().size();
    QVERIFY(moments > 0);
    const double before_mm = rehearsal.state()->patient.max_displacement_mm;
    const QString title = window_->windowTitle();

    answer_question("evidence_accept", nullptr);
    QVERIFY2(asked_.contains("Pad cut of Small, table 1") && asked_.contains("small"), qPrintable(asked_));
    QVERIFY(casefile::Case::open(folder)->find("evidence/model") == nullptr);  // thought better of it

    answer_question("evidence_accept", "accept_go");
    QTRY_VERIFY_WITH_TIMEOUT(child<QPushButton>("evidence_take_back")->isEnabled(), patience_ms);
    QVERIFY(casefile::Case::open(folder)->find("evidence/model") != nullptr);
    QTRY_VERIFY_WITH_TIMEOUT(rehearsal.has_tool() && rehearsal.solving() == Solving::solved, patience_ms);
    QVERIFY(rehearsal.tool_center_mm() == top);
    QVERIFY(rehearsal.track().moments().size() >= moments);
    QCOMPARE(window_->windowTitle(), title);
    // Half as stiff; springs beneath do not soften, so that it moves by less than twice as far.
    const double after_mm = rehearsal.state()->patient.max_displacement_mm;
    QVERIFY2(after_mm > 1.2 * before_mm && after_mm < 2.1 * before_mm, qPrintable(QString::number(after_mm)));
    QTest::mouseClick(child<QPushButton>("evidence_take_back"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(!child<QPushButton>("evidence_take_back")->isEnabled(), patience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(!window_->work().busy(), patience_ms);
    QVERIFY(casefile::Case::open(folder)->find("evidence/model") == nullptr);
  }

  // The sample that ships is nobody's liver; and how tissue stiffens at large strain changes nothing in a linear
  // rehearsal.
  void refuses_what_is_not_of_this_patient_or_changes_nothing() {
    const fs::path kept = view_->record()->folder;
    finish([this] { QTest::mouseClick(child<QPushButton>("evidence_example"), Qt::LeftButton); });
    auto* accept = child<QPushButton>("evidence_accept");
    QVERIFY(!accept->isEnabled());
    QVERIFY2(accept->toolTip().contains("SIMULATED: a sample") && accept->toolTip().contains("tissue of small"),
             qPrintable(accept->toolTip()));
    const fs::path stiffening = folder_ / "stiffening";
    fs::copy(view_->record()->folder, stiffening);
    for (const char* file : {"model.json", "report.json"}) {
      Json document = read_json_file(stiffening / file).value();
      document["effects"] = Json::array({document["effects"][0]});
      QVERIFY(bool(write_json_file(stiffening / file, document)));
    }
    view_->open(stiffening);
    QVERIFY(!accept->isEnabled());
    QVERIFY2(accept->toolTip().contains("change nothing"), qPrintable(accept->toolTip()));
    const auto* found = child<FoundTree>("evidence_found");
    QVERIFY(found->ticked_kinds().empty());
    QVERIFY(!(found->topLevelItem(0)->flags() & Qt::ItemIsUserCheckable));

    const fs::path strange = folder_ / "strange";
    fs::copy(kept, strange);
    Json model = read_json_file(strange / "model.json").value();
    model["title"] = "Silicone pad";
    QVERIFY(bool(write_json_file(strange / "model.json", model)));
    view_->open(strange);
    QVERIFY(!accept->isEnabled());
    QVERIFY2(accept->toolTip().contains("Silicone pad") && accept->toolTip().contains("tissue"),
             qPrintable(accept->toolTip()));
    view_->open(kept);
    QVERIFY(accept->isEnabled());
  }

  void nothing_ticked_is_nothing_accepted() {
    auto* found = child<FoundTree>("evidence_found");
    found->topLevelItem(0)->setCheckState(0, Qt::Unchecked);
    QVERIFY(!child<QPushButton>("evidence_accept")->isEnabled());
    QVERIFY(child<QPushButton>("evidence_accept")->toolTip().contains("Tick an effect"));
    found->topLevelItem(0)->setCheckState(0, Qt::Checked);
    QVERIFY(child<QPushButton>("evidence_accept")->isEnabled());
  }

  void opens_a_report_that_was_kept() {
    const fs::path kept = folder_ / "kept";
    fs::copy(view_->record()->folder, kept);
    finish([this] { QTest::mouseClick(child<QPushButton>("evidence_example"), Qt::LeftButton); });
    QCOMPARE(view_->record()->experiment_kind, std::string("material"));
    view_->open(kept / "report.json");
    QCOMPARE(view_->record()->experiment_kind, std::string("palpation"));
    QVERIFY(!view_->answer().residual_space().isVisible());  // the markers are not in a report, the drawings are
    QVERIFY(view_->record()->drawings.size() == 3);
    QTest::qWait(100);
    QVERIFY(window_->grab().save(pictures_ + "/evidence_report.png"));
  }

  // What the search found is told in English in files, and in the window's language on screen, the effects by the names
  // that the window gives them.
  void speaks_of_what_it_found_in_the_language_of_the_window() {
    // One trial that was over before anything crept: it says little, and that is said.
    const fs::path tissue = *resource_folder() / "examples" / "tissue";
    Json experiment = read_json_file(tissue / "experiment.json").value();
    const auto quick = std::find_if(experiment["trials"].begin(), experiment["trials"].end(),
                                    [](const Json& trial) { return trial.at("id") == "quick"; });
    QVERIFY(quick != experiment["trials"].end());
    experiment["trials"] = Json::array({*quick});
    fs::create_directories(folder_ / "one-trial");
    fs::copy(tissue / "quick.csv", folder_ / "one-trial" / "quick.csv");
    QVERIFY(bool(write_json_file(folder_ / "one-trial" / "experiment.json", experiment)));
    finish([&] { view_->open(folder_ / "one-trial" / "experiment.json"); });
    const EvidenceRecord record = *view_->record();
    QVERIFY(record.notes.size() > 1);
    const QString first = QString::fromStdString(record.notes.front().text).section("{", -1).section("}", -1);
    const QLabel* said = nullptr;
    for (const auto* each : view_->findChildren<QLabel*>()) said = each->text().contains(first) ? each : said;
    QVERIFY2(said != nullptr, qPrintable(first));
    const QString english_notes = said->text(), english_next = child<QLabel>("next_measurement")->text();
    for (const char* language : {"de", "es", "fr"}) {
      choose_language(language);
      QTest::qWait(50);
      const QString notes = said->text(), next = child<QLabel>("next_measurement")->text();
      for (const Sentence& note : record.notes) {
        QVERIFY2(!notes.contains(QString::fromStdString(note.text).section(" {", 0, 0)), qPrintable(notes));
        for (const std::string& named : note.arguments) {
          if (named.find('-') != std::string::npos || named.find('_') != std::string::npos) {
            QVERIFY2(!notes.contains(QString::fromStdString(named)), qPrintable(notes));
          }
        }
      }
      QVERIFY2(next != english_next && notes != english_notes, qPrintable(next));
      QVERIFY2(!next.contains("It would tell"), qPrintable(next));
      for (const EvidenceNextTrial& trial : record.next)
        for (const std::string& kind : trial.tells_apart) QVERIFY2(next.contains(effect_label(kind)), qPrintable(next));
      for (const auto* drawing : view_->answer().findChildren<SvgView*>()) {
        QVERIFY2(!drawing->toolTip().contains("before"), qPrintable(drawing->toolTip()));
      }
    }
    QVERIFY(window_->grab().save(pictures_ + "/evidence_french.png"));
    choose_language("en");
    QTest::qWait(50);
    QCOMPARE(said->text(), english_notes);
    QCOMPARE(child<QLabel>("next_measurement")->text(), english_next);
  }

  // The page that the window saves: its words, those of its drawings and the names of effects are the window's, and
  // nothing of it is English. The title is the experiment's own, and parameters keep the names that files give them.
  void saves_the_page_in_the_language_of_the_window() {
    finish([this] { QTest::mouseClick(child<QPushButton>("evidence_example"), Qt::LeftButton); });
    const auto page = [this] {
      return QString::fromStdString(read_text_file(view_->record()->folder / "report.html").value());
    };
    const auto words_of = [this](QString html) {
      html.remove(QRegularExpression("<style>.*?</style>", QRegularExpression::DotMatchesEverythingOption));
      html.replace(QRegularExpression("<[^>]*>"), "\n");
      QString title = QString::fromStdString(view_->record()->title);
      return html.remove(title);
    };
    QVERIFY(page().contains("lang=\"en\""));
    QVERIFY(page().contains("Stiffens as it deforms") && !page().contains("strain-stiffening"));
    static const QRegularExpression english(
        "\\b(the|and|with|of|what|before|after|noise|left|effect|value|stress|strain|next|trial|trials|remark)"
        "\\b",
        QRegularExpression::CaseInsensitiveOption);
    for (const char* language : {"de", "es", "fr"}) {
      choose_language(language);
      QTRY_VERIFY(page().contains(QString("lang=\"%1\"").arg(language)));
      QVERIFY(bool(
          write_text_file(path_of(pictures_) / (std::string("evidence_") + language + ".html"), page().toStdString())));
      const QString words = words_of(page());
      QVERIFY2(words.contains(effect_label("strain-stiffening")), qPrintable(words));
      const auto found = english.match(words);
      QVERIFY2(!found.hasMatch(), qPrintable(words.mid(found.capturedStart() - 60, 120)));
    }
    choose_language("en");
    QTRY_VERIFY(page().contains("lang=\"en\""));
  }

  // Whatever trial Glisson proposes next, of tissue in a machine, under a finger or of a battery, is told in German
  // too: its figures as they are, its words not in English, and what it would tell apart by the names in the window.
  void proposes_every_next_trial_in_german() {
    const auto tissue = closedloop::read_experiment(*resource_folder() / "examples" / "tissue" / "experiment.json");
    QVERIFY(bool(tissue));
    std::vector<Sentence> proposals;
    for (const auto& trial : closedloop::forward_model(*tissue).value()->further_trials())
      proposals.push_back(trial.sentence);
    const auto palpation = closedloop::palpation_model(closedloop::test::pad({.bricks = {4, 4, 2}, .markers = 24}));
    for (const auto& trial : (*palpation)->further_trials()) proposals.push_back(trial.sentence);
    const auto hardware = closedloop::hardware_model(cell_at_2_A());
    for (const auto& trial : (*hardware)->further_trials()) proposals.push_back(trial.sentence);
    QCOMPARE(proposals.size(), std::size_t{22});

    const fs::path kept = folder_ / "next";
    fs::copy(view_->record()->folder, kept, fs::copy_options::recursive);
    const Json report = read_json_file(kept / "report.json").value();
    const std::vector<std::string> rivals{"support-compliance", "preload"};
    std::set<QString> told;
    for (const Sentence& proposal : proposals) {
      Json with_proposal = report;
      with_proposal["next_trials"] = Json::array({{{"text", proposal.text},
                                                   {"arguments", proposal.arguments},
                                                   {"alternatives", rivals},
                                                   {"doubt_removed", 0.8}}});
      QVERIFY(bool(write_json_file(kept / "report.json", with_proposal)));
      choose_language("en");
      view_->open(kept / "report.json");
      const auto* label = child<QLabel>("next_measurement");
      const QString message = QString::fromStdString(proposal.message());
      QVERIFY2(label->text().startsWith(message + " It would tell"), qPrintable(label->text()));
      choose_language("de");
      QTest::qWait(20);
      const QString german = label->text();
      for (const char* word : {"Press", "Pull", "hold", "Deform", "Load", "Repeat", "trial", "It would", "with"}) {
        QVERIFY2(!german.contains(word), qPrintable(german));
      }
      for (const std::string& figure : proposal.arguments) {
        QVERIFY2(german.contains(QString::fromStdString(figure)), qPrintable(german));
      }
      QVERIFY2(german.contains("Das würde das Wahrscheinlichste unterscheiden von"), qPrintable(german));
      for (const std::string& rival : rivals) QVERIFY2(german.contains(effect_label(rival)), qPrintable(german));
      told.insert(german);
    }
    QCOMPARE(told.size(), proposals.size());
    choose_language("en");
    QTest::qWait(20);
  }

  // Waves that are as declared: what would have been seen, with units, and no promise of a further trial.
  void says_what_waves_could_have_shown() {
    const fs::path folder = folder_ / "waves";
    fs::create_directories(folder);
    const Json errors{{"rms", 0.99}, {"mean", 1.6}, {"p95", 2.7}, {"noise", 1}};
    const Json visible = Json::array({{{"kind", "viscosity"},
                                       {"law", "kelvin-voigt"},
                                       {"parameter", "viscosity_Pa_s"},
                                       {"no_effect", 0},
                                       {"value", 0.21}},
                                      {{"kind", "stiff-inclusion"},
                                       {"parameter", "center_mm"},
                                       {"component", 2},
                                       {"no_effect", 30},
                                       {"value", nullptr}}});
    QVERIFY(write_json_file(folder / "report.json", {{"verdict", "nothing-missing"},
                                                     {"unit", "noise"},
                                                     {"before", errors},
                                                     {"after", errors},
                                                     {"effects", Json::array()},
                                                     {"ranking", Json::array()},
                                                     {"smallest_visible", visible}}));
    QVERIFY(write_json_file(folder / "model.json", {{"kind", "elastography"}, {"title", "a block"}}));
    view_->open(folder);
    const auto* table = child<QTableWidget>("evidence_visible");
    QVERIFY(table->isVisible());
    const auto cell = [&](int row, int column) { return table->item(row, column)->text(); };
    QCOMPARE(cell(0, 0), QString("Waves lose energy on their way (kelvin-voigt)"));
    QCOMPARE(cell(0, 1), QString("viscosity, Pa s"));
    QCOMPARE(cell(0, 3), QString("0.21"));
    QCOMPARE(cell(1, 1), QString("center, mm (2)"));
    QCOMPARE(cell(1, 3), QString("at no size"));
    QVERIFY(child<QLabel>("next_measurement")->text().contains("no further trial is proposed"));
    choose_language("de");
    QTRY_COMPARE(cell(0, 1), QString::fromUtf8("Viskosität, Pa s"));
    choose_language("en");
    QTRY_COMPARE(cell(0, 1), QString("viscosity, Pa s"));
  }

  void says_that_a_folder_holds_no_report() {
    view_->open(folder_ / "small.glisson");
    const auto* notice = window_->findChild<QLabel*>("notice_text");
    QTRY_VERIFY(notice->isVisible());
    QVERIFY(notice->text().contains("does not hold a report"));
  }

  void shuts_down_cleanly() { window_.reset(); }

 private:
  // A cell of 3.6 V and 3 Ah, emptied for a minute.
  static closedloop::Hardware cell_at_2_A() {
    closedloop::Hardware platform;
    platform.nominal_voltage_V = 3.6;
    platform.capacity_Ah = 3;
    platform.noise_V = 0.01;
    closedloop::HardwareTrial trial;
    trial.id = "2 A";
    trial.time_s = Eigen::VectorXd::LinSpaced(61, 0, 60);
    trial.current_A = Eigen::VectorXd::Constant(61, 2);
    trial.voltage_V = Eigen::VectorXd::Constant(61, 3.5);
    platform.trials.push_back(trial);
    return platform;
  }
  template <typename Widget>
  Widget* child(const char* name) {
    return child_of<Widget>(*view_, name);
  }
  // Presses a button, reads what it asks, and presses that answer; without one, Escape.
  void answer_question(const char* button, const char* answer) {
    asked_.clear();
    QTimer::singleShot(200, this, [this, answer] {
      auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (question == nullptr) return;
      asked_ = question->text();
      auto* go = answer == nullptr ? nullptr : question->findChild<QPushButton*>(answer);
      go != nullptr ? QTest::mouseClick(go, Qt::LeftButton) : QTest::keyClick(question, Qt::Key_Escape);
    });
    QTest::mouseClick(child<QPushButton>(button), Qt::LeftButton);
  }
  void finish(const std::function<void()>& begin) {
    QSignalSpy finished(&window_->work(), &BackgroundWork::finished);
    begin();
    QVERIFY(finished.count() > 0 || finished.wait(patience_ms));
    QTest::qWait(20);
  }

  QString asked_;
  std::unique_ptr<MainWindow> window_;
  EvidenceView* view_ = nullptr;
  const QString pictures_ = glisson::test::kept_pictures();
  QTemporaryDir temporary_;
  fs::path folder_;
};

}  // namespace
}  // namespace glisson::widgets

int main(int argc, char** argv) { return glisson::widgets::run_test<glisson::widgets::EvidenceTest>(argc, argv); }

#include "evidence_test.moc"

// The window changes its language while it runs: every text that has a translation is in the language chosen, and all
// are back as they were when English is chosen again.

#include <map>
#include <QAbstractButton>
#include <QComboBox>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QTreeWidget>
#include <QtTest>
#include <QXmlStreamReader>
#include <set>

#include "block_patient.h"
#include "run_test.h"
#include "shown.h"
#include "support/folders.h"
#include "support/shapes.h"
#include "widgets/hardware/platform_view.h"
#include "widgets/help/manual_window.h"
#include "widgets/main_window.h"
#include "widgets/views/wave_view.h"
#include "widgets/words/number_box.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {
namespace {

// What translations/ has for an English text, in whatever context.
std::map<QString, std::set<QString>> translations(const QString& language) {
  QFile file(
      QString::fromStdString((glisson::test::source_folder() / "translations/glisson_%1.ts").string()).arg(language));
  if (!file.open(QIODevice::ReadOnly)) qFatal("there is no %s", qPrintable(file.fileName()));
  std::map<QString, std::set<QString>> found;
  QXmlStreamReader reader(&file);
  for (QString source; !reader.atEnd(); reader.readNext()) {
    if (!reader.isStartElement()) continue;
    if (reader.name() == u"source") source = reader.readElementText();
    if (reader.name() == u"translation") found[source].insert(reader.readElementText());
  }
  return found;
}

// Every text that a window holds, shown or not.
void gather_texts(const QWidget& window, std::vector<QString>& texts) {
  texts.push_back(window.windowTitle());
  for (const auto* label : window.findChildren<QLabel*>()) texts.push_back(label->text());
  for (const auto* button : window.findChildren<QAbstractButton*>()) texts.push_back(button->text());
  for (const auto* group : window.findChildren<QGroupBox*>()) texts.push_back(group->title());
  for (const auto* action : window.findChildren<QAction*>()) texts.push_back(action->text());
  for (const auto* box : window.findChildren<QComboBox*>()) {
    for (int n = 0; n < box->count(); ++n) texts.push_back(box->itemText(n));
  }
  for (const auto* tabs : window.findChildren<QTabBar*>()) {
    for (int n = 0; n < tabs->count(); ++n) texts.push_back(tabs->tabText(n));
  }
  for (const auto* items : window.findChildren<QAbstractItemView*>()) {
    const QAbstractItemModel* model = items->model();
    if (model == nullptr || qobject_cast<QComboBox*>(items->window()) != nullptr) continue;
    for (int column = 0; column < model->columnCount(); ++column) {
      texts.push_back(model->headerData(column, Qt::Horizontal).toString());
      for (int row = 0; row < model->rowCount(); ++row) texts.push_back(model->index(row, column).data().toString());
    }
  }
  for (const auto* widget : window.findChildren<QWidget*>()) texts.push_back(widget->toolTip());
  for (const auto* widget : window.findChildren<QWidget*>()) texts.push_back(widget->accessibleName());
  for (const auto* line : window.findChildren<QLineEdit*>()) texts.push_back(line->placeholderText());
}

std::vector<QString> texts_of(const std::vector<const QWidget*>& windows) {
  std::vector<QString> texts;
  for (const QWidget* window : windows) gather_texts(*window, texts);
  return texts;
}

Patient named_block() {
  return block_patient(
      {4, 3, 3}, {{"tumour-1", {100, 40, 40}}, {"portal-vein-2", {8, 40, 40}}},
      {{"somebody's-own", std::make_shared<geometry::Surface>(test::sphere_surface(10, 2, {100, 40, 40})), 7}});
}

class LanguageTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    window_ = shown_window();
    window_->show_patient(named_block());
    QSignalSpy placed(&window_->rehearsal(), &LiveRehearsal::placed);
    QTest::mouseClick(window_->findChild<QPushButton*>("hoist"), Qt::LeftButton);
    QVERIFY(placed.wait(20000));
    QTest::qWait(100);
  }

  void speaks_the_language_chosen_in_the_menu_data() {
    QTest::addColumn<QString>("language");
    for (const char* language : {"de", "fr", "es"}) QTest::newRow(language) << QString(language);
  }

  void speaks_the_language_chosen_in_the_menu() {
    QFETCH(QString, language);
    WaveView waves("/nowhere");
    ManualWindow manual("/nowhere");
    const std::unique_ptr<QWidget> worn(PlatformView::workspace().widget);
    choose("en");
    const std::vector<QString> english = texts_of({window_.get(), &waves, &manual, worn.get()});
    choose(language);
    const std::vector<QString> now = texts_of({window_.get(), &waves, &manual, worn.get()});
    QCOMPARE(now.size(), english.size());
    const auto known = translations(language);
    int changed = 0;
    for (std::size_t n = 0; n < now.size(); ++n) {
      const auto translated = known.find(english[n]);
      if (translated == known.end()) continue;
      QVERIFY2(translated->second.count(now[n]) == 1,
               qPrintable(QString("\"%1\" became \"%2\"").arg(english[n], now[n])));
      changed += now[n] != english[n] ? 1 : 0;
    }
    QVERIFY2(changed > 40, qPrintable(QString::number(changed)));
    choose("en");
    QVERIFY(texts_of({window_.get(), &waves, &manual, worn.get()}) == english);
  }

  void names_menus_structures_and_landmarks_in_german() {
    choose("de");
    QCOMPARE(window_->menuBar()->actions().front()->text(), QString("&Datei"));
    const auto* structures = window_->findChild<QTreeWidget*>("structures");
    QCOMPARE(structures->topLevelItem(0)->text(0), QString("Leber"));
    QCOMPARE(structures->topLevelItem(1)->text(0), QString("Somebody's own"));
    const auto* landmarks = window_->findChild<LandmarkTable*>();
    QCOMPARE(landmarks->item(1, LandmarkTable::name_column)->text(), QString("Pfortader 2"));
    choose("en");
  }

  void tells_the_errors_of_the_core_in_german() {
    choose("de");
    const Error error{"mesh-file-invalid",
                      GLISSON_TEXT("{0} cannot be read as a mesh: {1}."),
                      {"liver.vtu", GLISSON_TEXT("it holds no tetrahedra")},
                      GLISSON_TEXT("Open it in ParaView to see whether it is damaged."),
                      {}};
    QCOMPARE(translated(error),
             QString("liver.vtu kann nicht als Netz gelesen werden: es enthält keine Tetraeder. Öffnen Sie "
                     "es in ParaView, um zu sehen, ob es beschädigt ist."));
    QCOMPARE(translated_stage("Writing: labels/liver"), QString("Schreiben: Leber"));
    choose("en");
  }

  // What the core fills into its sentences is called as in the lists of the window.
  void names_structures_and_files_of_the_case_within_sentences() {
    choose("de");
    const auto changed = [](const std::string& what) {
      return translated(Sentence{GLISSON_TEXT("Another program has changed {0} since it was saved."), {what}});
    };
    QCOMPARE(changed("labels/portal-vein-2"), changed("Pfortader 2"));
    QCOMPARE(changed("tumour-1"), changed("Tumor 1"));
    QCOMPARE(changed("tumour-1 (label 3)"), changed("Tumor 1 (Label 3)"));
    QCOMPARE(changed("liver, cyst-2"), changed("Leber, Zyste 2"));
    QVERIFY(changed("meshes/model").contains("das Modell"));
    QVERIFY(changed("labels/somebodys-own").contains("labels/somebodys-own"));
    QVERIFY(changed("/home/liver/scan.nrrd").contains("/home/liver/scan.nrrd"));
    QVERIFY(changed("liver.vtu").contains("liver.vtu"));
    choose("en");
    QVERIFY(changed("labels/portal-vein-2").contains("Portal vein 2"));
  }

  void keeps_an_open_notice_in_step() {
    const QTemporaryDir empty;
    QSignalSpy finished(&window_->work(), &BackgroundWork::finished);
    window_->open_path(empty.path().toStdString());
    QVERIFY(finished.wait(20000));
    const auto* notice = window_->findChild<QLabel*>("notice_text");
    QTRY_VERIFY(notice->text().startsWith("No images were found in"));
    choose("de");
    QCOMPARE(notice->text(), QString("In %1 wurden keine Bilder gefunden.").arg(empty.path()));
    choose("en");
  }

  void keeps_the_choice_for_the_next_time() {
    choose("es");
    QCOMPARE(kept_language(), QString("es"));
    choose("en");
    begin_in_kept_language();
    QCOMPARE(kept_language(), QString("en"));
  }

  void writes_numbers_with_a_dot_and_takes_a_comma_for_one() {
    choose("de");
    QCOMPARE(QLocale().toString(12345.5, 'f', 1), QString("12345.5"));
    NumberBox box;
    box.setRange(0, 10);
    box.setDecimals(1);
    for (const char* typed : {"2,5", "2.5"}) {
      box.setValue(0);
      box.selectAll();
      QTest::keyClicks(&box, typed);
      QTest::keyClick(&box, Qt::Key_Return);
      QCOMPARE(box.value(), 2.5);
    }
    QCOMPARE(box.text(), QString("2.5"));
    choose("en");
  }

  void shuts_down_cleanly() { window_.reset(); }

 private:
  void choose(const QString& language) {
    for (QAction* choice : window_->findChild<QMenu*>("language")->actions()) {
      if (choice->data().toString() == language && choice->isCheckable()) choice->trigger();
    }
    QCoreApplication::sendPostedEvents();
    QTest::qWait(20);
  }

  std::unique_ptr<MainWindow> window_;
};

}  // namespace
}  // namespace glisson::widgets

int main(int argc, char** argv) { return glisson::widgets::run_test<glisson::widgets::LanguageTest>(argc, argv); }

#include "language_test.moc"

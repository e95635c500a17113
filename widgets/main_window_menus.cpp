// The window's menus, and what they do at once.

#include <QMenuBar>
#include <QMessageBox>

#include "base/files.h"
#include "widgets/diary/case_diary.h"
#include "widgets/diary/diary_window.h"
#include "widgets/help/manual_pages.h"
#include "widgets/help/shortcuts_window.h"
#include "widgets/main_window.h"
#include "widgets/panels/ask_path.h"
#include "widgets/panels/write_picture.h"
#include "widgets/settings/settings.h"
#include "widgets/settings/settings_window.h"
#include "widgets/study/study_page.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/language_menu.h"
#include "widgets/words/paths.h"

namespace glisson::widgets {

namespace fs = std::filesystem;

void MainWindow::make_menus() {
  QMenu* file = menuBar()->addMenu(QString());
  QAction* open_case =
      file->addAction(QIcon(":/icons/open.svg"), {}, QKeySequence::Open, this, &MainWindow::choose_case);
  QAction* open_images = file->addAction({}, QKeySequence("Ctrl+Shift+O"), this, &MainWindow::choose_study);
  QAction* open_demo = file->addAction({}, QKeySequence("Ctrl+D"), this, &MainWindow::open_demo);
  QMenu* recent = file->addMenu(QString());
  connect(recent, &QMenu::aboutToShow, this, [this, recent] { list_recent(*recent); });
  add_labels_ = file->addAction({}, this, &MainWindow::choose_labels);
  add_labels_->setObjectName("add_labels");
  file->addSeparator();
  export_ = new ExportMenu(context(), this);
  file->addMenu(export_);
  save_picture_ = file->addAction({}, QKeySequence::Save, this, &MainWindow::save_picture);
  show_waves_ = file->addAction({}, QKeySequence("Ctrl+W"), this, &MainWindow::show_waves);
  close_case_ = file->addAction({}, this, &MainWindow::close_case);
  close_case_->setObjectName("close_case");
  export_->addSeparator();
  export_->addAction(save_picture_);
  allow_for_case();
  file->addSeparator();
  QAction* settings = file->addAction({}, QKeySequence("Ctrl+,"), this, [this] { SettingsWindow(this).exec(); });
  settings->setObjectName("settings");
  file->addSeparator();
  QAction* quit = file->addAction({}, QKeySequence::Quit, this, &QWidget::close);
  QMenu* edit = menuBar()->addMenu(QString());
  edit->addActions({undo_.undo_action(), undo_.redo_action()});
  edit->addSeparator();
  QAction* case_diary = edit->addAction({}, this, [this] {
    auto* window = new CaseDiary(undo_, patient_.folder, this);
    window->setAttribute(Qt::WA_DeleteOnClose);
    window->show();
  });
  case_diary->setObjectName("show_case_diary");
  connect(edit, &QMenu::aboutToShow, this, [this, case_diary] { case_diary->setEnabled(!patient_.folder.empty()); });
  QMenu* view_menu = menuBar()->addMenu(QString());
  view_bar_->fill(*view_menu);
  go_menu_ = menuBar()->addMenu(QString());
  menuBar()->addMenu(new LanguageMenu(this));
  QMenu* help = menuBar()->addMenu(QString());
  QAction* manual = help->addAction({}, QKeySequence::HelpContents, this, &MainWindow::show_manual);
  QAction* tour = help->addAction({}, this, &MainWindow::take_tour);
  tour->setObjectName("take_tour");
  QAction* keys = help->addAction({}, QKeySequence("Ctrl+F1"), this, [this] { (new ShortcutsWindow(this))->show(); });
  keys->setObjectName("keys");
  QAction* diary = help->addAction({}, this, &MainWindow::show_diary);
  diary->setObjectName("log");
  help->addSeparator();
  QAction* about = help->addAction({}, this, &MainWindow::about);
  keep_translated(this, [=, this] {
    file->setTitle(tr("&File"));
    open_case->setText(tr("&Open a case..."));
    open_images->setText(tr("Open &images..."));
    open_demo->setText(tr("Open the &demo patient"));
    recent->setTitle(tr("Open &recent"));
    add_labels_->setText(tr("&Add labels..."));
    export_->setTitle(tr("&Export"));
    close_case_->setText(tr("&Close the case"));
    settings->setText(tr("Se&ttings..."));
    tour->setText(tr("&Tour on the demo patient"));
    keys->setText(tr("&Keys..."));
    diary->setText(tr("&Log and problems..."));
    save_picture_->setText(tr("&Save the picture..."));
    show_waves_->setText(tr("Elastography &waves..."));
    quit->setText(tr("&Quit"));
    edit->setTitle(tr("&Edit"));
    case_diary->setText(tr("&Diary of the case..."));
    view_menu->setTitle(tr("&View"));
    undo_.name_actions();
    go_menu_->setTitle(tr("&Go"));
    help->setTitle(tr("&Help"));
    manual->setText(tr("&Manual"));
    about->setText(tr("&About Glisson"));
  });
}

void MainWindow::choose_case() {
  const QString chosen = ask_for_file_or_folder(this, tr("Open a case (a folder NAME.glisson)"));
  if (!chosen.isEmpty()) open_path(path_of(chosen));
}

void MainWindow::choose_study() {
  const QString chosen = ask_for_file_or_folder(this, tr("Open images: a folder, or a file of them"));
  if (!chosen.isEmpty()) open_path(path_of(chosen));
}

void MainWindow::choose_labels() {
  const QString file = ask_for_file(this, tr("Add labels"),
                                    tr("Label maps and DICOM SEG (*.nii *.nii.gz *.nrrd *.mha *.mhd *.nhdr *.dcm);;"
                                       "All files (*)"));
  if (!file.isEmpty()) study_page_->add_labels(path_of(file));
}

void MainWindow::save_picture() {
  const QString name = "glisson.png";
  const QString file = ask_where_to_save(this, tr("Save the picture"), name, tr("Pictures (*.png)"));
  if (file.isEmpty()) return;
  if (auto written = write_picture(views_->space().smooth_picture(), path_of(file)); !written) {
    show_error(written.error());
  }
}

void MainWindow::show_manual() {
  if (!manual_) {
    const auto resources = resource_folder();
    if (!resources) return show_error(resources.error());
    manual_ = new ManualWindow(*resources / "manual", this);
  }
  const bool begins = patient_.name.empty() && pages_->currentIndex() == 0;
  manual_->open(manual_page_of(begins ? QString() : workspace()));
  manual_->show();
  manual_->raise();
  manual_->activateWindow();
}

void MainWindow::show_diary() {
  auto* window = new DiaryWindow(diary_, views_->space().drawn_by(), this);
  window->setAttribute(Qt::WA_DeleteOnClose);
  window->show();
}

void MainWindow::list_recent(QMenu& menu) {
  menu.clear();
  for (const fs::path& folder : recent_cases()) {
    QAction* open = menu.addAction(text_of(folder.stem()), this, [this, folder] { open_path(folder); });
    open->setToolTip(text_of(folder));
  }
  if (menu.isEmpty()) menu.addAction(tr("None yet"))->setEnabled(false);
  menu.addSeparator();
  menu.addAction(tr("Forget them"), this, [] { forget_recent_cases(); });
}

void MainWindow::about() {
  QMessageBox::about(this, tr("About Glisson"),
                     tr("<h3>Glisson %1</h3><p>Planning and reviewing liver surgery.</p>"
                        "<p><b>Not a medical device.</b> Not for diagnosis or treatment.</p>"
                        "<p>Free software under the GNU General Public License, version 3 or later.</p>")
                         .arg(QString::fromStdString(version())));
}

}  // namespace glisson::widgets

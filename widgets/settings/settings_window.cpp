#include "widgets/settings/settings_window.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QThread>

#include "widgets/settings/settings.h"
#include "widgets/theme.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/language.h"
#include "widgets/words/number_box.h"

namespace glisson::widgets {
namespace {

QLabel* explanation() {
  auto* label = new QLabel;
  label->setObjectName("faint");
  label->setWordWrap(true);
  return label;
}

}  // namespace

SettingsWindow::SettingsWindow(QWidget* parent) : QDialog(parent) {
  auto* form = new QFormLayout(this);
  form->setContentsMargins(20, 20, 20, 16);
  form->setVerticalSpacing(10);
  form->setHorizontalSpacing(16);

  auto* theme = new QComboBox;
  theme->setObjectName("theme");
  theme->addItems({QString(), QString()});
  theme->setCurrentIndex(kept_theme() == Theme::light ? 1 : 0);
  connect(theme, &QComboBox::activated, this, [](int index) { keep_theme(index == 1 ? Theme::light : Theme::dark); });

  auto* language = new QComboBox;
  language->setObjectName("language_choice");
  language->addItem(QString(), QString());
  for (const Language& each : languages()) language->addItem(each.name, each.code);
  language->setCurrentIndex(std::max(0, language->findData(kept_language())));
  connect(language, &QComboBox::activated, this, [language] { choose_language(language->currentData().toString()); });

  auto* names = new QCheckBox;
  names->setObjectName("names_outside");
  names->setChecked(names_shown_outside());
  connect(names, &QCheckBox::toggled, this, &show_names_outside);
  QLabel* names_why = explanation();

  NumberBox* threads = whole_number("threads", 0, QThread::idealThreadCount(), kept_threads());
  connect(threads, &NumberBox::valueChanged, this, [](double chosen) { keep_threads(static_cast<int>(chosen)); });

  auto* program = new QLineEdit(kept_program().command);
  program->setObjectName("outlining_program");
  auto* values = new QLineEdit(kept_program().values);
  values->setObjectName("outlining_program_values");
  for (QLineEdit* line : {program, values}) {
    connect(line, &QLineEdit::textChanged, this, [=] { keep_program({program->text(), values->text()}); });
  }
  QLabel* program_why = explanation();
  auto* shapes = new QLineEdit(kept_shapes());
  shapes->setObjectName("shape_model");
  connect(shapes, &QLineEdit::textChanged, this, &keep_shapes);

  auto* theme_label = new QLabel;
  auto* language_label = new QLabel;
  auto* threads_label = new QLabel;
  auto* program_label = new QLabel;
  auto* values_label = new QLabel;
  auto* shapes_label = new QLabel;
  form->addRow(theme_label, theme);
  form->addRow(language_label, language);
  form->addRow(threads_label, threads);
  form->addRow(names);
  form->addRow(names_why);
  form->addRow(program_label, program);
  form->addRow(values_label, values);
  form->addRow(program_why);
  form->addRow(shapes_label, shapes);
  auto* close = new QPushButton;
  connect(close, &QPushButton::clicked, this, &QDialog::accept);
  form->addRow(close);
  theme_label->setBuddy(theme);
  language_label->setBuddy(language);
  threads_label->setBuddy(threads);
  program_label->setBuddy(program);
  values_label->setBuddy(values);
  shapes_label->setBuddy(shapes);
  setMinimumWidth(460);

  keep_translated(this, [=, this] {
    setWindowTitle(tr("Settings - Glisson"));
    theme_label->setText(tr("&Appearance"));
    theme->setItemText(0, tr("Dark"));
    theme->setItemText(1, tr("Light"));
    language_label->setText(tr("&Language"));
    language->setItemText(0, tr("System language"));
    threads_label->setText(tr("&Processors"));
    threads->setSpecialValueText(tr("All %1").arg(QThread::idealThreadCount()));
    threads->setToolTip(tr("How many processors long computations may take"));
    names->setText(tr("&Patients' names in what leaves this window"));
    names_why->setText(tr("Pictures, movies and reports name a patient only then. The log never does."));
    program_label->setText(tr("&Outlining program"));
    values_label->setText(tr("Its &values"));
    program->setPlaceholderText(tr("As in: %1").arg("TotalSegmentator -i {image} -o {folder}"));
    values->setPlaceholderText(tr("As in: %1").arg("1=liver, 2=tumour-1"));
    program_why->setText(
        tr("A program of yours that outlines organs, for Segment (Add). {image} stands for the images of the case and "
           "{folder} for where its label maps go. Values are named only where its files do not say what they are."));
    shapes_label->setText(tr("Livers' &shapes"));
    shapes->setPlaceholderText(tr("As in: %1").arg("shapes/model.vtp"));
    shapes->setToolTip(
        tr("A shape model's file, by which Segment finds the liver; without one, a simulated liver's shape"));
    close->setText(tr("Close"));
  });
}

}  // namespace glisson::widgets

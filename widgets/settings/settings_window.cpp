#include "widgets/settings/settings_window.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
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

  auto* threads = new NumberBox;
  threads->setDecimals(0);
  threads->setObjectName("threads");
  threads->setRange(0, QThread::idealThreadCount());
  threads->setValue(kept_threads());
  connect(threads, &NumberBox::valueChanged, this, [](double chosen) { keep_threads(static_cast<int>(chosen)); });

  auto* theme_label = new QLabel;
  auto* language_label = new QLabel;
  auto* threads_label = new QLabel;
  form->addRow(theme_label, theme);
  form->addRow(language_label, language);
  form->addRow(threads_label, threads);
  form->addRow(names);
  form->addRow(names_why);
  auto* close = new QPushButton;
  connect(close, &QPushButton::clicked, this, &QDialog::accept);
  form->addRow(close);
  theme_label->setBuddy(theme);
  language_label->setBuddy(language);
  threads_label->setBuddy(threads);
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
    close->setText(tr("Close"));
  });
}

}  // namespace glisson::widgets

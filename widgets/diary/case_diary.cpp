#include "widgets/diary/case_diary.h"

#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "widgets/panels/parts.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/paths.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {

CaseDiary::CaseDiary(Undo& undo, std::filesystem::path case_folder, QWidget* parent)
    : QWidget(parent, Qt::Window), undo_(undo), folder_(std::move(case_folder)) {
  setObjectName("case_diary");
  resize(560, 520);
  auto* column = new QVBoxLayout(this);
  column->addWidget(about_ = new QLabel);
  about_->setObjectName("faint");
  about_->setWordWrap(true);
  column->addWidget(steps_ = new QListWidget, 1);
  steps_->setObjectName("case_steps");
  column->addWidget(said_ = new QLabel);
  said_->setObjectName("case_diary_said");
  said_->setWordWrap(true);
  auto* row = new QHBoxLayout;
  row->addStretch();
  row->addWidget(copy_python_ = named_button("copy_python"));
  row->addWidget(copy_command_line_ = named_button("copy_command_line"));
  column->addLayout(row);

  connect(copy_python_, &QPushButton::clicked, this, [this] { copy(casefile::as_python); });
  connect(copy_command_line_, &QPushButton::clicked, this, [this] { copy(casefile::as_command_line); });
  connect(&undo_, &Undo::settled, this, &CaseDiary::list);
  keep_translated(this, [this] {
    setWindowTitle(tr("Diary of %1 - Glisson").arg(text_of(folder_.stem())));
    about_->setText(
        tr("What was done to this case, as far as it can be undone. Copied, it is a program that does the same without "
           "a window, on the case as it was before."));
    steps_->setAccessibleName(tr("The steps"));
    copy_python_->setText(tr("Copy as Python"));
    copy_command_line_->setText(tr("Copy as command line"));
    list();
  });
}

void CaseDiary::list() {
  steps_->clear();
  const auto macro = casefile::macro_of(folder_);
  if (macro) {
    for (const casefile::MacroStep& step : macro->steps) {
      steps_->addItem(QString("%1. %2").arg(step.number).arg(translated(step.name)));
    }
    steps_->scrollToBottom();
  } else {
    said_->setText(translated(macro.error()));
  }
  copy_python_->setEnabled(steps_->count() > 0);
  copy_command_line_->setEnabled(steps_->count() > 0);
}

void CaseDiary::copy(std::string (*written)(const casefile::Macro&)) {
  undo_.wait();  // what was drawn last is written too
  const auto macro = casefile::macro_of(folder_);
  if (!macro) return said_->setText(translated(macro.error()));
  QApplication::clipboard()->setText(QString::fromStdString(written(*macro)));
  said_->setText(tr("Steps copied: %1").arg(macro->steps.size()));
}

}  // namespace glisson::widgets

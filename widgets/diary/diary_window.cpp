#include "widgets/diary/diary_window.h"

#include <QApplication>
#include <QClipboard>
#include <QFontDatabase>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QVBoxLayout>

#include "base/files.h"
#include "widgets/panels/ask_path.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/paths.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {

DiaryWindow::DiaryWindow(const Diary& diary, QString graphics, QWidget* parent)
    : QWidget(parent, Qt::Window), diary_(diary), graphics_(std::move(graphics)) {
  setObjectName("diary");
  resize(900, 560);
  auto* column = new QVBoxLayout(this);
  auto* about = new QLabel;
  about->setObjectName("faint");
  about->setWordWrap(true);
  column->addWidget(about);
  lines_ = new QPlainTextEdit;
  lines_->setObjectName("diary_lines");
  lines_->setReadOnly(true);
  lines_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  lines_->setLineWrapMode(QPlainTextEdit::NoWrap);
  column->addWidget(lines_, 1);
  auto* row = new QHBoxLayout;
  auto* copy = new QPushButton;
  auto* save_report = new QPushButton;
  save_report->setObjectName("save_report");
  row->addStretch();
  row->addWidget(copy);
  row->addWidget(save_report);
  column->addLayout(row);

  const auto show = [this] { lines_->setPlainText(problem_report(diary_, graphics_)); };
  show();
  connect(&diary_, &Diary::added, this, show);
  connect(copy, &QPushButton::clicked, this,
          [this] { QApplication::clipboard()->setText(problem_report(diary_, graphics_)); });
  connect(save_report, &QPushButton::clicked, this, &DiaryWindow::save);
  keep_translated(this, [=, this] {
    setWindowTitle(tr("Log - Glisson"));
    about->setText(
        tr("What Glisson did, in English, for those who mend it. It holds nothing about a patient: no names, "
           "no paths, no values. Nothing is sent anywhere; you decide who gets it."));
    lines_->setAccessibleName(tr("The log"));
    copy->setText(tr("Copy"));
    save_report->setText(tr("Save a report of the problem..."));
  });
}

void DiaryWindow::save() {
  const QString file =
      ask_where_to_save(this, tr("Save a report of the problem"), "glisson-report.txt",  // not translated
                        tr("Text (*.txt)"));
  if (file.isEmpty()) return;
  const auto written = write_text_file(path_of(file), problem_report(diary_, graphics_).toStdString());
  if (!written) QMessageBox::warning(this, windowTitle(), translated(written.error()));
}

}  // namespace glisson::widgets

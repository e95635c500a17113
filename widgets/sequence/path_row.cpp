#include "widgets/sequence/path_row.h"

#include <QDir>
#include <QHBoxLayout>

#include "widgets/panels/ask_path.h"
#include "widgets/panels/parts.h"
#include "widgets/words/keep_translated.h"

namespace glisson::widgets {

PathRow::PathRow(const char* name, Asks asks, QWidget* parent) : QWidget(parent), asks_(asks) {
  constexpr int label_px = 96;
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  label_ = new QLabel;
  label_->setMinimumWidth(label_px);
  path_ = new QLineEdit;
  path_->setObjectName(name);
  label_->setBuddy(path_);
  choose_ = named_button(qPrintable(QString("choose_%1").arg(name)));
  row->addWidget(label_);
  row->addWidget(path_, 1);
  row->addWidget(choose_);
  connect(path_, &QLineEdit::textChanged, this, &PathRow::changed);
  connect(choose_, &QPushButton::clicked, this, &PathRow::ask);
  keep_translated(choose_, [this] { choose_->setText(tr("Choose...")); });
}

void PathRow::set_words(const QString& label, const QString& tooltip) {
  label_->setText(label);
  path_->setToolTip(tooltip);
  path_->setAccessibleName(label);
  choose_->setToolTip(tooltip);
}

void PathRow::ask() {
  const QString chosen = asks_ == Asks::file_or_folder
                             ? ask_for_file_or_folder(this, label_->text())
                             : ask_where_to_save(this, label_->text(), QDir(path()).dirName(), tr("Folders (*)"));
  if (!chosen.isEmpty()) set_path(QDir::toNativeSeparators(chosen));
}

}  // namespace glisson::widgets

#include "panels/notices.h"

#include <QHBoxLayout>

#include "panels/parts.h"
#include "words/told.h"
#include "words/worded.h"

namespace glisson::widgets {

Notices::Notices(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);

  notice_ = new QWidget;
  notice_->setObjectName("notice");
  notice_->setAttribute(Qt::WA_StyledBackground);
  auto* row = new QHBoxLayout(notice_);
  row->setContentsMargins(12, 8, 8, 8);
  text_ = wrapped_label("notice_text");
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  row->addWidget(text_, 1);
  auto* dismiss = new QPushButton;
  row->addWidget(dismiss);
  connect(dismiss, &QPushButton::clicked, notice_, &QWidget::hide);
  notice_->hide();
  column->addWidget(notice_);

  origin_text_ = wrapped_label("origin");
  origin_text_->hide();
  column->addWidget(origin_text_);
  worded(this, [=, this] {
    dismiss->setText(tr("Close"));
    if (words_) text_->setText(words_());
    origin_text_->setText(told(origin_));
  });
}

void Notices::say(std::function<QString()> words) {
  words_ = std::move(words);
  text_->setText(words_());
  notice_->show();
}

void Notices::show_origin(const std::string& origin) {
  origin_ = origin;
  origin_text_->setText(told(origin_));
  origin_text_->setVisible(!origin_.empty());
}

}  // namespace glisson::widgets

#include "widgets/panels/notices.h"

#include <algorithm>
#include <QEvent>
#include <QHBoxLayout>
#include <QStyle>

#include "widgets/panels/parts.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {

Notices::Notices(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);

  notice_ = new QWidget(this);
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

  origin_text_ = wrapped_label("origin");
  origin_text_->hide();
  column->addWidget(origin_text_);
  keep_translated(this, [=, this] {
    dismiss->setText(tr("Close"));
    if (words_) text_->setText(words_());
    put_in_place();
    origin_text_->setText(translated(origin_));
  });
}

void Notices::float_over(QWidget& area) {
  area_ = &area;
  notice_->setParent(area.parentWidget());
  area.installEventFilter(this);
}

bool Notices::eventFilter(QObject* watched, QEvent* event) {
  if (watched == area_ && (event->type() == QEvent::Resize || event->type() == QEvent::Move)) put_in_place();
  return QWidget::eventFilter(watched, event);
}

void Notices::show_notice(const char* kind, std::function<QString()> words) {
  words_ = std::move(words);
  text_->setText(words_());
  notice_->setProperty("kind", kind);
  for (QWidget* each : {notice_, static_cast<QWidget*>(text_)}) {
    each->style()->unpolish(each);  // a style sheet looks at a property only when it polishes
    each->style()->polish(each);
  }
  put_in_place();
  notice_->show();
  notice_->raise();
}

void Notices::put_in_place() {
  if (area_ == nullptr) return;
  constexpr int widest_px = 760, gap_px = 14;
  const QRect room = area_->geometry();
  const int width = std::min(widest_px, room.width() - 2 * gap_px);
  const int height = std::max(notice_->layout()->totalHeightForWidth(width), notice_->minimumSizeHint().height());
  notice_->setGeometry(room.center().x() - width / 2, room.bottom() - gap_px - height, width, height);
}

void Notices::show_origin(const std::string& origin) {
  origin_ = origin;
  origin_text_->setText(translated(origin_));
  origin_text_->setVisible(origin_shown_ && !origin_.empty());
}

void Notices::set_origin_shown(bool shown) {
  origin_shown_ = shown;
  origin_text_->setVisible(origin_shown_ && !origin_.empty());
}

}  // namespace glisson::widgets

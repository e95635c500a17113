#include "widgets/views/view_frame.h"

#include <QMenu>
#include <QMouseEvent>
#include <QTimer>
#include <QVBoxLayout>

#include "widgets/views/render_widget.h"
#include "widgets/words/keep_translated.h"

namespace glisson::widgets {

ViewFrame::ViewFrame(const QColor& accent, QWidget* view, QWidget* parent) : QFrame(parent) {
  setObjectName("view_frame");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(1, 1, 1, 1);
  column->setSpacing(0);
  auto* bar = new QWidget(this);
  bar->setObjectName("view_header");
  bar->setFixedHeight(28);
  bar->setMinimumWidth(1);  // the views share their room evenly, whatever stands in their headers
  header_ = new QHBoxLayout(bar);
  header_->setContentsMargins(10, 0, 4, 0);
  header_->setSpacing(2);
  if (accent.isValid()) {
    auto* mark = new QLabel(bar);
    mark->setFixedSize(10, 10);
    mark->setStyleSheet(QString("background: %1; border-radius: 2px;").arg(accent.name()));
    header_->addWidget(mark);
    header_->addSpacing(6);
  }
  name_ = new QLabel(bar);
  name_->setObjectName("view_name");
  header_->addWidget(name_);
  header_->addStretch();
  more_ = new QToolButton(bar);
  more_->setObjectName("more");
  more_->setText("»");
  more_->setAutoRaise(true);
  more_->setPopupMode(QToolButton::InstantPopup);
  more_->setMenu(new QMenu(more_));
  more_->hide();
  header_->addWidget(more_);
  connect(more_->menu(), &QMenu::aboutToShow, this, [this] {
    more_->menu()->clear();
    for (QToolButton* button : buttons_) {
      QAction* entry = more_->menu()->addAction(button->text(), button, &QToolButton::click);
      entry->setToolTip(button->toolTip());
      entry->setCheckable(button->isCheckable());
      entry->setChecked(button->isChecked());
      entry->setEnabled(button->isEnabled());
    }
  });
  picture_ = new QToolButton(bar);
  picture_->setObjectName("save_picture");
  picture_->setAutoRaise(true);
  picture_->setIcon(QIcon(":/icons/camera.svg"));
  header_->addWidget(picture_);
  connect(picture_, &QToolButton::clicked, this, &ViewFrame::picture_requested);
  maximise_ = new QToolButton(bar);
  maximise_->setObjectName("maximise");
  maximise_->setAutoRaise(true);
  header_->addWidget(maximise_);
  connect(maximise_, &QToolButton::clicked, this, &ViewFrame::maximise_requested);
  column->addWidget(bar);
  column->addWidget(view, 1);
  keep_translated(this, [this] {
    more_->setToolTip(tr("What there is no room for here"));
    QTimer::singleShot(0, this, [this] { fold_buttons(); });  // once all of them have their words
    picture_->setToolTip(tr("Save the picture of this view"));
    show_maximised(maximised_);
  });
}

void ViewFrame::set_name(const QString& name) {
  name_->setText(name);
  findChild<RenderWidget*>()->setAccessibleName(name);
}

QToolButton* ViewFrame::add_button() {
  auto* button = new QToolButton(this);
  button->setAutoRaise(true);
  header_->insertWidget(header_->count() - 3, button);
  buttons_.push_back(button);
  return button;
}

void ViewFrame::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  fold_buttons();
}

void ViewFrame::fold_buttons() {
  if (buttons_.empty()) return;
  int wanted = header_->contentsMargins().left() + header_->contentsMargins().right() + name_->sizeHint().width() +
               picture_->sizeHint().width() + maximise_->sizeHint().width() + 6 * header_->spacing();
  for (const QToolButton* button : buttons_) wanted += button->sizeHint().width() + header_->spacing();
  const bool folded = wanted > width();
  more_->setVisible(folded);
  for (QToolButton* button : buttons_) button->setVisible(!folded);
}

void ViewFrame::show_maximised(bool maximised) {
  maximised_ = maximised;
  maximise_->setIcon(QIcon(maximised ? ":/icons/restore.svg" : ":/icons/maximise.svg"));
  maximise_->setToolTip(maximised ? tr("Show all four views") : tr("Fill the window with this view"));
}

void ViewFrame::mouseDoubleClickEvent(QMouseEvent* event) {
  // In the header only: the views keep double clicks to themselves.
  if (event->position().y() <= 28) Q_EMIT maximise_requested();
}

}  // namespace glisson::widgets

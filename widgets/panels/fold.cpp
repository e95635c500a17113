#include "widgets/panels/fold.h"

#include <QVBoxLayout>

namespace glisson::widgets {

Fold::Fold(const char* name, QWidget* held, At at, QWidget* parent) : QWidget(parent), title_(new QToolButton(this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  title_->setObjectName(name);
  title_->setCheckable(true);
  title_->setAutoRaise(true);
  title_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  column->addWidget(title_, 0, Qt::AlignLeft);
  column->addWidget(held);
  const auto show = [this, held](bool open) {
    title_->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
    held->setVisible(open);
  };
  connect(title_, &QToolButton::toggled, this, [this, show](bool open) {
    show(open);
    Q_EMIT toggled(open);
  });
  title_->setChecked(at == At::open);
  show(at == At::open);
}

}  // namespace glisson::widgets

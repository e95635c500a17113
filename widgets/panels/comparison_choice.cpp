#include "panels/comparison_choice.h"

#include <QHBoxLayout>
#include <QPushButton>

namespace glisson::widgets {

ComparisonChoice::ComparisonChoice(QWidget* parent) : QWidget(parent), group_(new QButtonGroup(this)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  const auto add = [&](Bodies bodies, const QString& text, const QString& tip, const char* place) {
    auto* button = new QPushButton(text, this);
    button->setCheckable(true);
    button->setToolTip(tip);
    button->setProperty("segment", place);  // the theme joins the three
    group_->addButton(button, static_cast<int>(bodies));
    row->addWidget(button, 1);
  };
  add(Bodies::patient, tr("Patient"), tr("With this patient's own stiffness, from MR elastography"), "first");
  add(Bodies::atlas, tr("Atlas"), tr("With one stiffness for the whole liver, as an atlas gives it"), "middle");
  add(Bodies::both, tr("Both"), tr("Atlas in red, patient in blue: purple where they agree"), "last");
  choose(Bodies::patient);
  connect(group_, &QButtonGroup::idClicked, this, [this](int id) { Q_EMIT changed(static_cast<Bodies>(id)); });
}

void ComparisonChoice::choose(Bodies bodies) { group_->button(static_cast<int>(bodies))->setChecked(true); }

}  // namespace glisson::widgets

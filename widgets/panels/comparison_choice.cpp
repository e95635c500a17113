#include "panels/comparison_choice.h"

#include <QHBoxLayout>
#include <QPushButton>

#include "words/worded.h"

namespace glisson::widgets {

ComparisonChoice::ComparisonChoice(QWidget* parent) : QWidget(parent), group_(new QButtonGroup(this)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  const auto add = [&](Bodies bodies, const char* place) {
    auto* button = new QPushButton(this);
    button->setCheckable(true);
    button->setProperty("segment", place);  // the theme joins them
    group_->addButton(button, static_cast<int>(bodies));
    row->addWidget(button, 1);
    return button;
  };
  QPushButton* patient = add(Bodies::patient, "first");
  QPushButton* atlas = add(Bodies::atlas, "middle");
  QPushButton* both = add(Bodies::both, "middle");
  QPushButton* beside = add(Bodies::side_by_side, "last");
  worded(this, [=] {
    patient->setText(tr("Patient"));
    patient->setToolTip(tr("With this patient's own stiffness, from MR elastography"));
    atlas->setText(tr("Atlas"));
    atlas->setToolTip(tr("With one stiffness for the whole liver, as an atlas gives it"));
    both->setText(tr("Both"));
    both->setToolTip(tr("Atlas in red, patient in blue: purple where they agree"));
    beside->setText(tr("Side by side"));
    beside->setToolTip(tr("Two 3D views that turn together: the patient on the left, the atlas on the right"));
  });
  choose(Bodies::patient);
  connect(group_, &QButtonGroup::idClicked, this, [this](int id) { Q_EMIT changed(static_cast<Bodies>(id)); });
}

void ComparisonChoice::choose(Bodies bodies) { group_->button(static_cast<int>(bodies))->setChecked(true); }

}  // namespace glisson::widgets

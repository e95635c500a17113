#include "widgets/rehearse/comparison_choice.h"

#include <QHBoxLayout>
#include <QPushButton>

#include "widgets/words/keep_translated.h"

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
  };
  add(Bodies::patient, "first");
  add(Bodies::reference, "middle");
  add(Bodies::both, "middle");
  add(Bodies::side_by_side, "last");
  keep_translated(this, [this] { update_text(); });
  choose(Bodies::patient);
  connect(group_, &QButtonGroup::idClicked, this, [this](int id) { Q_EMIT changed(static_cast<Bodies>(id)); });
}

void ComparisonChoice::choose(Bodies bodies) { group_->button(static_cast<int>(bodies))->setChecked(true); }

void ComparisonChoice::set_comparable(bool comparable) {
  comparable_ = comparable;
  for (const Bodies bodies : {Bodies::reference, Bodies::both, Bodies::side_by_side}) {
    group_->button(static_cast<int>(bodies))->setEnabled(comparable);
  }
  update_text();
}

void ComparisonChoice::update_text() {
  const auto say = [this](Bodies bodies, const QString& name, const QString& tip) {
    QAbstractButton* button = group_->button(static_cast<int>(bodies));
    button->setText(name);
    button->setToolTip(tip);
  };
  const QString alone = tr("No stiffness was measured: there is nothing to compare with the atlas");
  say(Bodies::patient, tr("Patient"),
      comparable_ ? tr("With this patient's own stiffness, as it was measured") : tr("With the assumed stiffness"));
  say(Bodies::reference, tr("Atlas"),
      comparable_ ? tr("With one stiffness for the whole liver, as an atlas gives it") : alone);
  say(Bodies::both, tr("Both"), comparable_ ? tr("Atlas in red, patient in blue: purple where they agree") : alone);
  say(Bodies::side_by_side, tr("Side by side"),
      comparable_ ? tr("Two 3D views that turn together: the patient on the left, the atlas on the right") : alone);
}

}  // namespace glisson::widgets

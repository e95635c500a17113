#include "widgets/workspaces/workspace_bar.h"

#include <QHBoxLayout>
#include <QStyle>

#include "widgets/words/keep_translated.h"

namespace glisson::widgets {

WorkspaceBar::WorkspaceBar(QWidget* parent) : QWidget(parent) {
  setObjectName("workspace_bar");
  setAttribute(Qt::WA_StyledBackground);
  row_ = new QHBoxLayout(this);
  row_->setContentsMargins(8, 0, 8, 0);
  row_->setSpacing(0);
  row_->addStretch();
  group_ = new QButtonGroup(this);
  connect(group_, &QButtonGroup::idToggled, this, [this](int index, bool on) {
    if (on) Q_EMIT chosen(index);
  });
  keep_translated(this, [this] { update_text(); });
}

void WorkspaceBar::add(const Workspace& workspace) {
  auto* button = new QToolButton;
  button->setObjectName("workspace_" + workspace.id);
  button->setCheckable(true);
  button->setAutoRaise(true);
  button->setFocusPolicy(Qt::TabFocus);
  if (workspace.group == Workspace::Group::research && research_ == nullptr) {
    research_ = new QLabel;
    research_->setObjectName("research_group");
    row_->insertWidget(row_->count() - 1, research_);
  }
  row_->insertWidget(row_->count() - 1, button);
  group_->addButton(button, static_cast<int>(buttons_.size()));
  buttons_.push_back(button);
  workspaces_.push_back(workspace);
  update_text();
}

void WorkspaceBar::choose(int index) { buttons_.at(static_cast<std::size_t>(index))->setChecked(true); }

void WorkspaceBar::show_patient(const Patient& patient) {
  patient_ = patient;
  update_text();
}

void WorkspaceBar::update_text() {
  if (research_ != nullptr) research_->setText(tr("Research"));
  for (std::size_t k = 0; k < buttons_.size(); ++k) {
    const Workspace& workspace = workspaces_[k];
    QToolButton* button = buttons_[k];
    const QString missing = workspace.missing(patient_);
    button->setText(workspace.name());
    // The first ten have a key (MainWindow::add_workspace).
    const QString about = k < 10 ? tr("%1 (Ctrl+%2)").arg(workspace.about()).arg((k + 1) % 10) : workspace.about();
    button->setToolTip(missing.isEmpty() ? about : missing);
    button->setAccessibleDescription(missing.isEmpty() ? workspace.about() : missing);
    if (button->property("waiting").toBool() == !missing.isEmpty()) continue;
    button->setProperty("waiting", !missing.isEmpty());
    button->style()->unpolish(button);  // a style sheet looks at a property only when it polishes
    button->style()->polish(button);
  }
}

}  // namespace glisson::widgets

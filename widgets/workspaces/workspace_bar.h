#pragma once
// The row of workspaces at the top of the window, in the order of the work, those of research apart behind it. What is
// not ready yet is dimmed, can be entered all the same (it says there what it needs), and says so in its tooltip.

#include <QBoxLayout>
#include <QButtonGroup>
#include <QLabel>
#include <QToolButton>
#include <vector>

#include "widgets/workspaces/workspace.h"

namespace glisson::widgets {

class WorkspaceBar : public QWidget {
  Q_OBJECT

 public:
  explicit WorkspaceBar(QWidget* parent = nullptr);

  void add(const Workspace& workspace);
  void choose(int index);  // says so by chosen()
  void show_patient(const Patient& patient);
  [[nodiscard]] int current() const { return group_->checkedId(); }

 Q_SIGNALS:
  void chosen(int index);

 private:
  void update_text();

  QHBoxLayout* row_;
  QLabel* research_ = nullptr;  // before the first of that group
  QButtonGroup* group_;
  std::vector<Workspace> workspaces_;
  std::vector<QToolButton*> buttons_;
  Patient patient_;
};

}  // namespace glisson::widgets

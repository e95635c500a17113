#pragma once
// How far the liver may be strained: small deformations (at once, up to 20 % strain) or large ones (beyond that too,
// and settling); at rest, or in motion. Says which is at work and why, and offers the large ones where strains ask for
// them.

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include "widgets/session/live_rehearsal.h"

namespace glisson::widgets {

class DeformationChoice : public QWidget {
  Q_OBJECT

 public:
  explicit DeformationChoice(LiveRehearsal& rehearsal, QWidget* parent = nullptr);

 private:
  void update_text();
  void show_state();
  [[nodiscard]] QString what_is_at_work() const;
  [[nodiscard]] QString what_meshfree_costs() const;
  [[nodiscard]] QString how_it_moves() const;

  LiveRehearsal& rehearsal_;
  QLabel* name_;
  QComboBox* choice_;
  QLabel* why_;
  QPushButton* offer_;
};

}  // namespace glisson::widgets

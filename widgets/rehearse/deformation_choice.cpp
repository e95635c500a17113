#include "widgets/rehearse/deformation_choice.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "widgets/panels/parts.h"
#include "widgets/words/keep_translated.h"

namespace glisson::widgets {
namespace {

// Of the strain that a linear answer bears.
bool is_beyond_small(const rehearsal::RehearsalState& state) {
  return state.validity.largest_strain > mechanics::small_strain_limit || state.validity.inverted_cells > 0;
}

}  // namespace

DeformationChoice::DeformationChoice(LiveRehearsal& rehearsal, QWidget* parent)
    : QWidget(parent), rehearsal_(rehearsal) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  auto* row = new QHBoxLayout;
  name_ = new QLabel(this);
  row->addWidget(name_);
  choice_ = new QComboBox(this);
  choice_->setObjectName("deformations");
  for (const Deformations kind :
       {Deformations::small, Deformations::meshfree, Deformations::large, Deformations::moving}) {
    choice_->addItem({}, static_cast<int>(kind));
  }
  row->addWidget(choice_, 1);
  column->addLayout(row);
  why_ = wrapped_label("deformations_why", this);
  column->addWidget(why_);
  offer_ = named_button("use_large", this);
  column->addWidget(offer_);
  connect(choice_, &QComboBox::activated, this,
          [this] { rehearsal_.set_deformations(static_cast<Deformations>(choice_->currentData().toInt())); });
  connect(offer_, &QPushButton::clicked, this, [this] { rehearsal_.set_deformations(Deformations::large); });
  connect(&rehearsal_, &LiveRehearsal::state_changed, this, &DeformationChoice::show_state);
  connect(&rehearsal_, &LiveRehearsal::solving_changed, this, &DeformationChoice::show_state);
  keep_translated(this, [this] { update_text(); });
}

void DeformationChoice::update_text() {
  name_->setText(tr("Deformations"));
  choice_->setAccessibleName(name_->text());
  choice_->setItemText(0, tr("Small (at once)"));
  choice_->setItemData(0, tr("A linear liver: made for strains up to 20 %"), Qt::ToolTipRole);
  choice_->setItemText(1, tr("Small, meshfree"));
  choice_->setItemData(1,
                       tr("A linear liver by a few hundred meshfree nodes in place of finite elements, under rigid "
                          "tools. Finite elements answer beside it, so that you see what it costs and what it misses."),
                       Qt::ToolTipRole);
  choice_->setItemText(2, tr("Large (settles)"));
  choice_->setItemData(2,
                       tr("A hyperelastic (neo-Hookean) liver of the same stiffness: made for larger strains too. A "
                          "first picture says how far its landmarks may be from rest, and is brought to rest in the "
                          "background."),
                       Qt::ToolTipRole);
  choice_->setItemText(3, tr("Small, in motion"));
  choice_->setItemData(3,
                       tr("A linear liver that takes its time, under rigid tools: what is let go swings and comes to "
                          "rest, and tissue that creeps gives way under a held tool and comes back slowly. It is not "
                          "cut."),
                       Qt::ToolTipRole);
  offer_->setText(tr("Use large deformations"));
  offer_->setToolTip(tr("The tools stay where they are; what was recorded begins anew"));
  show_state();
}

void DeformationChoice::show_state() {
  const bool large = rehearsal_.deformations() == Deformations::large;
  choice_->setCurrentIndex(choice_->findData(static_cast<int>(rehearsal_.deformations())));
  choice_->setEnabled(!rehearsal_.frozen() && rehearsal_.knows_other_deformations());
  const auto& state = rehearsal_.state();
  offer_->setVisible(!large && state && is_beyond_small(*state) && choice_->isEnabled());
  show_text(why_, what_is_at_work());
}

QString DeformationChoice::what_is_at_work() const {
  const auto& state = rehearsal_.state();
  const bool known = state && state->validity.converged;
  const QString strain = known ? QString::number(100 * state->validity.largest_strain, 'f', 0) : QString();
  if (rehearsal_.deformations() == Deformations::large) {
    if (rehearsal_.preparing()) return tr("The liver is being prepared for large deformations.");
    if (!known) return tr("Large deformations, as you chose.");
    return is_beyond_small(*state)
               ? tr("Large deformations, as you chose: strains reach %1 %, small ones would only extrapolate.")
                     .arg(strain)
               : tr("Large deformations, as you chose. Strains reach %1 %: small ones would do.").arg(strain);
  }
  if (rehearsal_.deformations() == Deformations::meshfree) return what_meshfree_costs();
  if (rehearsal_.deformations() == Deformations::moving) return how_it_moves();
  if (rehearsal_.body() != nullptr && rehearsal_.knows_rigid_tools() && !rehearsal_.knows_other_deformations()) {
    return tr("Small deformations: evidence gave this liver a grain, which large ones do not know.");
  }
  if (!known) return tr("Small deformations: made for strains up to 20 %.");
  return is_beyond_small(*state)
             ? tr("Small deformations, but strains reach %1 %: beyond 20 % take large ones.").arg(strain)
             : tr("Small deformations: enough, since strains reach %1 % only.").arg(strain);
}

QString DeformationChoice::how_it_moves() const {
  if (rehearsal_.preparing()) return tr("The liver is being prepared to move.");
  const QString tissue = rehearsal_.creeps() ? tr("Its tissue creeps, as evidence showed.")
                                             : tr("Its tissue is elastic: no accepted evidence shows that it creeps.");
  const rehearsal::SessionState* contact = rehearsal_.contact();
  if (contact == nullptr || !contact->motion) return tr("In motion, as you chose.") + ' ' + tissue;
  return (contact->motion->moves
              ? tr("In motion, as you chose: %1 mm/s at most.").arg(contact->motion->largest_speed_mm_s, 0, 'f', 1)
              : tr("In motion, as you chose: it has come to rest.")) +
         ' ' + tissue;
}

QString DeformationChoice::what_meshfree_costs() const {
  if (rehearsal_.preparing()) return tr("The liver is being prepared for the meshfree engine.");
  const rehearsal::SessionState* contact = rehearsal_.contact();
  if (contact == nullptr) return tr("Meshfree, as you chose. Finite elements will answer beside it.");
  if (!contact->beside_elements) return tr("Meshfree, as you chose. Finite elements found no shape under these tools.");
  const rehearsal::BesideElements& beside = *contact->beside_elements;
  const auto mm = [](double value) { return QString::number(value, 'f', 1); };
  const auto ms = [](double value) { return QString::number(value, 'f', 0); };
  return tr("Meshfree, as you chose: %1 ms, finite elements %2 ms. Landmarks are %3 mm apart at most, the surface %4 "
            "mm.")
      .arg(ms(beside.meshfree_ms), ms(beside.elements_ms), mm(beside.landmarks_mm), mm(beside.surface_mm));
}

}  // namespace glisson::widgets

#include "widgets/rehearse/advance_controls.h"

#include <algorithm>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "widgets/panels/parts.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {
namespace {

constexpr double step_mm = 5.0;

}  // namespace

AdvanceControls::AdvanceControls(LiveRehearsal& rehearsal, QWidget* parent) : QWidget(parent), rehearsal_(rehearsal) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  title_ = heading(this);
  column->addWidget(title_);
  auto* row = new QHBoxLayout;
  advance_ = named_button("advance_cut", this);
  row->addWidget(advance_);
  back_ = named_button("take_cut_back", this);
  row->addWidget(back_);
  row->addStretch(1);
  column->addLayout(row);
  state_ = wrapped_label("cut_state", this);
  column->addWidget(state_);
  connect(advance_, &QPushButton::clicked, this, &AdvanceControls::advance);
  connect(back_, &QPushButton::clicked, this, &AdvanceControls::take_back);
  connect(&rehearsal_, &LiveRehearsal::state_changed, this, &AdvanceControls::show_state);
  connect(&rehearsal_, &LiveRehearsal::solving_changed, this, &AdvanceControls::show_state);
  keep_translated(this, [this] {
    title_->setText(tr("Cut along the plan"));
    advance_->setText(tr("Cut 5 mm further"));
    advance_->setToolTip(
        tr("Leads the planned cut on, from the lower front edge to the upper back, while rigid tools "
           "hold the liver. Energy devices and bleeding are not simulated."));
    back_->setText(tr("Take back"));
    back_->setToolTip(tr("Closes the last 5 mm, as long as no tool was moved since"));
    show_state();
  });
}

void AdvanceControls::set_course(std::optional<rehearsal::CutCourse> course, std::optional<Sentence> why_not) {
  course_ = std::move(course);
  why_not_ = std::move(why_not);
  show_state();
}

void AdvanceControls::set_structure_names(std::vector<std::string> names) { names_ = std::move(names); }

void AdvanceControls::advance() {
  const double done_mm = step_mm * rehearsal_.cut_steps();
  rehearsal_.advance_cut(course_->strip(done_mm, std::min(done_mm + step_mm, course_->length_mm)));
}

void AdvanceControls::take_back() { rehearsal_.take_cut_back(); }

void AdvanceControls::show_state() {
  const bool rigid = rehearsal_.touch() == Touch::rigid;
  const bool more = course_ && step_mm * rehearsal_.cut_steps() < course_->length_mm;
  advance_->setEnabled(more && rigid && !rehearsal_.frozen());
  back_->setEnabled(rehearsal_.can_take_cut_back());
  const auto& state = rehearsal_.state();
  QString text;
  if (!course_) {
    text = why_not_ ? translated(*why_not_)
                    : tr("Plan a plane or a sheet in Resect and keep the plan, to cut along it here.");
  } else if (!rigid) {
    text = tr("Tick the rigid tool above, to cut while tools hold the liver.");
  } else if (state && state->cut) {
    text = tr("%1 % of the section is open, by up to %2 mm.")
               .arg(100 * state->cut->open_share(), 0, 'f', 0)
               .arg(state->cut->largest_opening_mm, 0, 'f', 1);
    const rehearsal::SessionState* contact = rehearsal_.contact();
    if (contact != nullptr && contact->beside_elements && contact->beside_elements->largest_opening_mm) {
      text += " " + tr("By finite elements: %1 mm.").arg(*contact->beside_elements->largest_opening_mm, 0, 'f', 1);
    }
    QStringList crossed;
    for (const std::size_t k : state->cut->crossed) {
      if (k > 0 && k < names_.size()) crossed << structure_label(names_[k]);  // the first is the liver
    }
    if (!crossed.isEmpty()) text += " " + tr("Crossed: %1.").arg(crossed.join(", "));
  } else {
    text = tr("The plan's cut is %1 mm long. Nothing is cut yet.").arg(course_->length_mm, 0, 'f', 0);
  }
  state_->setText(text);
}

}  // namespace glisson::widgets

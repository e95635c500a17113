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
constexpr double default_depth_mm = 15;  // the first layers of a transection, well below the capsule

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
  by_hand_ = new QWidget(this);
  auto* by_hand = new QHBoxLayout(by_hand_);
  by_hand->setContentsMargins(0, 0, 0, 0);
  freehand_ = named_button("knife", by_hand_);
  freehand_->setCheckable(true);
  by_hand->addWidget(freehand_);
  depth_name_ = new QLabel(by_hand_);
  by_hand->addWidget(depth_name_);
  depth_ = new NumberBox(by_hand_);
  depth_->setObjectName("knife_depth");
  depth_->setDecimals(0);
  depth_->setRange(5, 150);
  depth_->setSingleStep(5);
  depth_->setValue(default_depth_mm);
  by_hand->addWidget(depth_);
  by_hand->addStretch(1);
  column->addWidget(by_hand_);
  state_ = wrapped_label("cut_state", this);
  column->addWidget(state_);
  connect(advance_, &QPushButton::clicked, this, &AdvanceControls::advance);
  connect(back_, &QPushButton::clicked, this, &AdvanceControls::take_back);
  connect(freehand_, &QPushButton::toggled, this, &AdvanceControls::knife_changed);
  connect(depth_, &NumberBox::valueChanged, this, &AdvanceControls::knife_changed);
  connect(&rehearsal_, &LiveRehearsal::state_changed, this, &AdvanceControls::show_state);
  connect(&rehearsal_, &LiveRehearsal::solving_changed, this, &AdvanceControls::show_state);
  keep_translated(this, [this] {
    title_->setText(tr("Cut"));
    advance_->setText(tr("Cut 5 mm further"));
    advance_->setToolTip(
        tr("Leads the planned cut on, from the lower front edge to the upper back, while rigid tools "
           "hold the liver. Energy devices and bleeding are not simulated."));
    back_->setText(tr("Take back"));
    back_->setToolTip(tr("Closes the last advance, as long as no tool was moved since"));
    freehand_->setText(tr("Cut freehand"));
    freehand_->setToolTip(
        tr("Then draw over the liver in the 3D view with the left button held: it parts behind the pointer, straight "
           "away from you, as deep as is said here. From the end of the last line the cut goes on."));
    depth_name_->setText(tr("Depth"));
    depth_->setSuffix(tr(" mm"));
    depth_->setToolTip(tr("How deep the knife goes from the surface, away from you"));
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
  const double done_mm = planned_mm();
  rehearsal_.advance_cut(course_->strip(done_mm, std::min(done_mm + step_mm, course_->length_mm)));
}

void AdvanceControls::take_back() { rehearsal_.take_cut_back(); }

double AdvanceControls::planned_mm() const {
  const auto strips = rehearsal_.cut_along();
  return step_mm * static_cast<double>(std::count_if(strips.begin(), strips.end(), [&](const auto& strip) {
           return strip.surface.is_same(course_->surface);
         }));
}

QString AdvanceControls::words_of_cut(const rehearsal::SessionCut& cut) const {
  const auto strips = rehearsal_.cut_along();
  const bool by_hand =
      std::any_of(strips.begin(), strips.end(), [](const auto& strip) { return strip.surface.is_swept(); });
  QString text = by_hand ? tr("%1 cm² are cut, open by up to %2 mm.").arg(1e-2 * cut.open_mm2, 0, 'f', 1)
                         : tr("%1 % of the section is open, by up to %2 mm.").arg(100 * cut.open_share(), 0, 'f', 0);
  text = text.arg(cut.largest_opening_mm, 0, 'f', 1);
  const rehearsal::SessionState* contact = rehearsal_.contact();
  if (contact != nullptr && contact->beside_elements && contact->beside_elements->largest_opening_mm) {
    text += " " + tr("By finite elements: %1 mm.").arg(*contact->beside_elements->largest_opening_mm, 0, 'f', 1);
  }
  QStringList crossed;
  for (const std::size_t k : cut.crossed) {
    if (k > 0 && k < names_.size()) crossed << structure_label(names_[k]);  // the first is the liver
  }
  if (!crossed.isEmpty()) text += " " + tr("Crossed: %1.").arg(crossed.join(", "));
  return text;
}

void AdvanceControls::show_state() {
  const bool rigid = rehearsal_.touch() == Touch::rigid;
  const bool more = course_ && planned_mm() < course_->length_mm;
  advance_->setEnabled(more && rigid && !rehearsal_.frozen());
  back_->setEnabled(rehearsal_.can_take_cut_back());
  by_hand_->setVisible(rigid);
  freehand_->setEnabled(rigid && !rehearsal_.frozen());
  if (!freehand_->isEnabled()) freehand_->setChecked(false);
  const auto& state = rehearsal_.state();
  QString text;
  if (rigid && state && state->cut) {
    text = words_of_cut(*state->cut);
  } else if (!course_) {
    text = why_not_ ? translated(*why_not_)
           : rigid  ? tr("Cut freehand, or plan a plane or a sheet in Resect and keep the plan, to cut along it here.")
                    : tr("Plan a plane or a sheet in Resect and keep the plan, to cut along it here.");
  } else if (!rigid) {
    text = tr("Tick the rigid tool above, to cut while tools hold the liver.");
  } else {
    text = tr("The plan's cut is %1 mm long. Nothing is cut yet.").arg(course_->length_mm, 0, 'f', 0);
  }
  state_->setText(text);
}

}  // namespace glisson::widgets

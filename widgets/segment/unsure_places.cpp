#include "widgets/segment/unsure_places.h"

#include <QLocale>
#include <QVBoxLayout>

#include "segmentation/resample.h"
#include "widgets/panels/parts.h"
#include "widgets/words/keep_translated.h"
#include "widgets/work/run_in_background.h"

namespace glisson::widgets {

UnsurePlaces::UnsurePlaces(LinkedViews& views, const StructureEditor& editor, SliceOverlay& overlay, QWidget* parent)
    : QWidget(parent),
      views_(views),
      editor_(editor),
      overlay_(overlay),
      button_(named_button("unsure_places")),
      text_(wrapped_label("faint")) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  column->addWidget(button_);
  column->addWidget(text_);
  connect(button_, &QPushButton::clicked, this, [this] {
    if (state_ == State::found && !found_.places_mm.empty()) return go_to_next();
    look();
  });
  connect(&editor_, &StructureEditor::opened, this, &UnsurePlaces::forget);
  connect(&editor_, &StructureEditor::changed, this, [this](int structure) {
    if (editor_.structures()[static_cast<std::size_t>(structure)].name == of_) forget();
  });
  connect(&editor_, &StructureEditor::listed, this, [this] {
    const EditedStructure* active = editor_.active_structure();
    if (active == nullptr || active->name != of_) forget();
  });
  connect(&editor_, &StructureEditor::working, this, &UnsurePlaces::tell);
  keep_translated(this, [this] { tell(); });
}

void UnsurePlaces::look() {
  const EditedStructure* active = editor_.active_structure();
  const auto image = editor_.shared_anatomy();
  if (active == nullptr || !image || !editor_.can_edit()) return;
  of_ = active->name;
  state_ = State::looking;
  tell();
  // A copy: it may be drawn on while this one is looked at.
  run_in_background(
      this,
      [image, mask = imaging::Mask(*active->mask)] {
        const bool as_image = imaging::same_grid(mask.grid, image->grid);
        return segmentation::unsure_border(as_image ? mask : segmentation::resample(mask, image->grid), *image);
      },
      [this, asked = ++asked_](const segmentation::UnsureBorder& found) {
        if (asked == asked_ && state_ == State::looking) take(found);
      });
}

void UnsurePlaces::take(const segmentation::UnsureBorder& found) {
  found_ = found;
  state_ = State::found;
  at_ = found_.places_mm.size();
  overlay_.set_rings(found_.places_mm);
  if (found_.places_mm.empty()) return tell();
  go_to_next();
}

void UnsurePlaces::go_to_next() {
  at_ = at_ + 1 < found_.places_mm.size() ? at_ + 1 : 0;
  views_.set_crosshair(found_.places_mm[at_]);
  tell();
}

void UnsurePlaces::forget() {
  of_.clear();
  state_ = State::not_asked;
  overlay_.set_rings({});
  tell();
}

void UnsurePlaces::tell() {
  const bool has_any = state_ == State::found && !found_.places_mm.empty();
  button_->setEnabled(state_ != State::looking && editor_.active_structure() != nullptr && editor_.can_edit());
  button_->setText(has_any && found_.places_mm.size() > 1 ? tr("Next unsure place") : tr("Where is it unsure?"));
  button_->setToolTip(
      tr("Goes to where the chosen outline lies on tissue that looks alike on both sides, as towards the heart"));
  const QString percent = QLocale().toString(100 * found_.share, 'f', 0);
  text_->setVisible(state_ != State::not_asked);
  text_->setText(state_ == State::looking ? tr("Looking along the border...")
                 : has_any
                     ? tr("%1 % of the border looks alike on both sides. Place %2 of %3 lies under the crosshair: "
                          "draw it as you see it.")
                           .arg(percent)
                           .arg(at_ + 1)
                           .arg(found_.places_mm.size())
                     : tr("No larger part of the border is unsure (%1 % in all).").arg(percent));
}

}  // namespace glisson::widgets

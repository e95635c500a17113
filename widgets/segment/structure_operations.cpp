#include "widgets/segment/structure_operations.h"

#include <QGridLayout>

#include "scene/anatomy.h"
#include "widgets/panels/parts.h"
#include "widgets/panels/swatch.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {
namespace {

// Refills a list of structures and keeps what was chosen, if it is still there.
void refill(QComboBox& list, const std::vector<EditedStructure>& structures, int without, bool with_anywhere) {
  const QSignalBlocker quiet(&list);
  const QVariant chosen = list.currentData();
  const QString anywhere = with_anywhere ? list.itemText(0) : QString();
  list.clear();
  if (with_anywhere) list.addItem(anywhere, QString());
  for (int k = 0; k < static_cast<int>(structures.size()); ++k) {
    if (k == without) continue;
    const std::string& name = structures[static_cast<std::size_t>(k)].name;
    list.addItem(swatch(scene::appearance_of(name).colour), structure_label(name), QString::fromStdString(name));
  }
  list.setCurrentIndex(std::max(list.findData(chosen), list.count() > 0 ? 0 : -1));
}

NumberBox* grey_value(const char* name, int value) {
  NumberBox* box = whole_number(name, -100000, 100000, value);
  box->setSingleStep(5);
  return box;
}

}  // namespace

StructureOperations::StructureOperations(QWidget* parent) : QWidget(parent) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(6);
  grid->addWidget(title_ = heading(), 0, 0, 1, 3);
  grid->addWidget(range_title_ = new QLabel, 1, 0, 1, 2);
  grid->addWidget(from_crosshair_ = named_button("range_from_crosshair"), 1, 2);
  grid->addWidget(low_ = grey_value("grey_low", 100), 2, 0);
  grid->addWidget(high_ = grey_value("grey_high", 200), 2, 1);
  grid->addWidget(take_ = named_button("take_range"), 2, 2);
  for_brush_ = new QCheckBox;
  for_brush_->setObjectName("range_for_brush");
  grid->addWidget(for_brush_, 3, 0, 1, 3);
  grid->addWidget(within_title_ = new QLabel, 4, 0);
  within_ = new QComboBox;
  within_->setObjectName("within");
  within_->addItem({}, QString());
  grid->addWidget(within_, 4, 1, 1, 2);
  how_ = new QComboBox;
  how_->setObjectName("combine_how");
  how_->addItems({{}, {}, {}});
  other_ = new QComboBox;
  other_->setObjectName("combine_with");
  grid->addWidget(how_, 5, 0);
  grid->addWidget(other_, 5, 1);
  grid->addWidget(combine_ = named_button("combine"), 5, 2);
  for (int column = 0; column < 3; ++column) grid->setColumnStretch(column, 1);
  for (QComboBox* list : {within_, how_, other_}) {
    list->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    list->setMinimumContentsLength(6);
  }

  connect(low_, &NumberBox::valueChanged, this, &StructureOperations::brush_range_changed);
  connect(high_, &NumberBox::valueChanged, this, &StructureOperations::brush_range_changed);
  connect(for_brush_, &QCheckBox::toggled, this, &StructureOperations::brush_range_changed);
  connect(from_crosshair_, &QPushButton::clicked, this, &StructureOperations::range_wanted_from_crosshair);
  connect(take_, &QPushButton::clicked, this, &StructureOperations::take_asked);
  connect(combine_, &QPushButton::clicked, this, &StructureOperations::combine_asked);
  keep_translated(this, [this] { update_text(); });
}

void StructureOperations::list(const std::vector<EditedStructure>& structures, int active) {
  refill(*within_, structures, -1, true);
  refill(*other_, structures, active, false);
  const bool has_active = active >= 0;
  const QString why = has_active ? QString() : tr("Choose a structure first, or add one.");
  take_->setEnabled(has_active);
  take_->setToolTip(has_active ? tr("Replaces the structure by the voxels of these grey values") : why);
  combine_->setEnabled(has_active && other_->count() > 0);
  combine_->setToolTip(!has_active            ? why
                       : other_->count() == 0 ? tr("There is no other structure.")
                                              : tr("Changes the chosen structure; the other one stays as it is"));
}

void StructureOperations::set_range(const segmentation::GreyRange& range) {
  low_->setValue(range.low);
  high_->setValue(range.high);
}

segmentation::GreyRange StructureOperations::range() const {
  return {std::min(low_->value(), high_->value()), std::max(low_->value(), high_->value())};
}

std::optional<segmentation::GreyRange> StructureOperations::brush_range() const {
  return for_brush_->isChecked() ? std::optional(range()) : std::nullopt;
}

std::string StructureOperations::within() const { return within_->currentData().toString().toStdString(); }

std::string StructureOperations::other() const { return other_->currentData().toString().toStdString(); }

void StructureOperations::update_text() {
  title_->setText(tr("Grey values and other structures"));
  range_title_->setText(tr("Grey values from, to"));
  low_->setAccessibleName(tr("Lowest grey value"));
  high_->setAccessibleName(tr("Highest grey value"));
  from_crosshair_->setText(tr("As here"));
  from_crosshair_->setToolTip(tr("Takes the grey values that are like those under the crosshair"));
  take_->setText(tr("Take these"));
  for_brush_->setText(tr("The brush draws on these only"));
  within_title_->setText(tr("Inside of"));
  within_->setItemText(0, tr("the whole image"));
  within_->setAccessibleName(tr("Structure to stay inside of"));
  within_->setToolTip(tr("Grow and Take these stay inside of this structure"));
  how_->setItemText(unite, tr("Add"));
  how_->setItemText(intersect, tr("Keep what is also in"));
  how_->setItemText(subtract, tr("Take away"));
  how_->setAccessibleName(tr("What to do with the other structure"));
  other_->setAccessibleName(tr("The other structure"));
  combine_->setText(tr("Do it"));
}

}  // namespace glisson::widgets

#include "widgets/rehearse/tool_controls.h"

#include <algorithm>
#include <cmath>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QShortcut>

#include "widgets/words/keep_translated.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {
namespace {

constexpr double force_step_N = 0.1;

// Towards the front and the head in equal parts, as rehearsal/tool_presets.h hoists.
const Eigen::Vector3d front_and_head = Eigen::Vector3d(0, -1, 1).normalized();

}  // namespace

ToolControls::ToolControls(LiveRehearsal& rehearsal, QWidget* parent)
    : QWidget(parent), rehearsal_(rehearsal), hoist_direction_(front_and_head) {
  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);

  tool_ = new QComboBox(this);
  tool_->setObjectName("tool");
  for (const rehearsal::ToolPreset& preset : rehearsal::tool_presets()) {
    tool_->addItem(QString(), QVariant(QString::fromStdString(preset.id)));  // {} would be an icon, the id its text
  }
  auto* tool_name = new QLabel(this);
  form->addRow(tool_name, tool_);
  connect(tool_, &QComboBox::activated, this, &ToolControls::preset_chosen);

  auto* places = new QHBoxLayout;
  place_ = new QPushButton(QIcon(":/icons/place.svg"), {}, this);
  place_->setObjectName("place");
  place_->setCheckable(true);
  hoist_button_ = new QPushButton(this);
  hoist_button_->setObjectName("hoist");
  places->addWidget(place_);
  places->addWidget(hoist_button_);
  form->addRow(places);
  connect(place_, &QPushButton::toggled, this, &ToolControls::placing_changed);
  connect(hoist_button_, &QPushButton::clicked, this, &ToolControls::hoist_segment_vi);
  auto* by_key = new QShortcut(QKeySequence("Ctrl+T"), this);
  connect(by_key, &QShortcut::activated, this, &ToolControls::place_at_crosshair);

  direction_ = new QComboBox(this);
  direction_->setObjectName("direction");
  for (const Direction direction : {hoist, pull_away, push, dragged}) direction_->addItem({}, direction);
  auto* direction_name = new QLabel(this);
  form->addRow(direction_name, direction_);
  connect(direction_, &QComboBox::activated, this, &ToolControls::apply_direction);

  auto* forces = new QHBoxLayout;
  force_slider_ = new MarkedSlider(Qt::Horizontal, this);
  force_slider_->setObjectName("force_slider");
  force_ = new NumberBox(this);
  force_->setObjectName("force");
  force_->setDecimals(1);
  force_->setSingleStep(force_step_N);
  forces->addWidget(force_slider_, 1);
  forces->addWidget(force_);
  auto* force_name = new QLabel(this);
  form->addRow(force_name, forces);
  connect(force_slider_, &QSlider::valueChanged, this, [this](int steps) { set_force(steps * force_step_N); });
  connect(force_, &NumberBox::valueChanged, this, &ToolControls::set_force);

  rigid_ = new QCheckBox(this);
  rigid_->setObjectName("rigid");
  form->addRow(rigid_);
  connect(rigid_, &QCheckBox::clicked, this,
          [this](bool on) { rehearsal_.set_touch(on ? Touch::rigid : Touch::patch); });

  auto* ends = new QHBoxLayout;
  keep_ = new QPushButton(this);
  keep_->setObjectName("keep");
  release_ = new QPushButton(this);
  release_->setObjectName("release");
  ends->addWidget(keep_);
  ends->addWidget(release_);
  form->addRow(ends);
  connect(keep_, &QPushButton::clicked, this, [this] {
    rehearsal_.keep_tool();
    place_->setChecked(true);
  });
  connect(release_, &QPushButton::clicked, &rehearsal_, &LiveRehearsal::take_tool_away);

  keep_translated(this, [=, this] {
    tool_name->setText(tr("Tool"));
    direction_name->setText(tr("Direction"));
    force_name->setText(tr("Force"));
    force_slider_->setAccessibleName(tr("Force"));
    update_text();
  });
  preset_chosen();
  follow();
}

void ToolControls::update_text() {
  for (int k = 0; k < tool_->count(); ++k) {
    const rehearsal::ToolPreset& preset = rehearsal::tool_presets()[static_cast<std::size_t>(k)];
    tool_->setItemText(k, translated(preset.name));
    tool_->setItemData(k, translated(preset.source), Qt::ToolTipRole);
  }
  place_->setText(tr("Place by click"));
  place_->setToolTip(tr("Then click on the liver where the tool is to touch it. By key: Ctrl+T, at the crosshair"));
  hoist_button_->setText(tr("Hoist segment VI"));
  hoist_button_->setToolTip(
      tr("Puts the tool under the right, lower, rear part of the liver, lifting it to the front and the head"));
  direction_->setItemText(hoist, tr("Hoist to front and head"));
  direction_->setItemText(pull_away, tr("Pull away from the surface"));
  direction_->setItemText(push, tr("Push into the surface"));
  direction_->setItemText(dragged, tr("As the arrow was dragged"));
  force_->setSuffix(tr(" N"));
  rigid_->setText(tr("Touch with the rigid tool itself"));
  rigid_->setToolTip(
      tr("The tool's solid in contact with the liver, and several tools at once. Otherwise the force is spread over a "
         "patch."));
  keep_->setText(tr("Add another tool"));
  keep_->setToolTip(tr("Several tools at once need rigid tools"));
  release_->setText(tr("Take the tool away"));
}

const rehearsal::ToolPreset& ToolControls::preset() const {
  return rehearsal::tool_presets()[static_cast<std::size_t>(std::max(0, tool_->currentIndex()))];
}

void ToolControls::preset_chosen() {
  const rehearsal::ToolPreset& chosen = preset();
  force_is_usual_ = true;
  show_force(chosen.usual_force_N);
  if (rehearsal_.has_tool()) {
    hold(rehearsal_.tool_center_mm());
  } else {
    rehearsal_.set_force_N(chosen.usual_force_N);
  }
}

void ToolControls::hold(const Eigen::Vector3d& center_mm) {
  const PlacedTool tool{preset().id, center_mm, outward_, preset().radius_mm, chosen_direction(), force_->value()};
  if (force_is_usual_) {
    rehearsal_.hold_within_the_model(tool);
  } else {
    rehearsal_.hold(tool);
  }
}

void ToolControls::place_at(const Eigen::Vector3d& position_mm, const Eigen::Vector3d& outward) {
  outward_ = outward;
  place_->setChecked(false);
  hold(position_mm);
}

void ToolControls::hoist_segment_vi() {
  if (rehearsal_.body() == nullptr) return;
  const auto placement = rehearsal::hoist_segment_vi(rehearsal_.body()->patient().mesh());
  if (!placement) {
    Q_EMIT failed(placement.error());
    return;
  }
  rehearsal_.take_tool_away();
  tool_->setCurrentIndex(std::max(0, tool_->findData(QString::fromStdString(placement->preset.id))));
  direction_->setCurrentIndex(direction_->findData(hoist));
  hoist_direction_ = placement->direction;
  outward_ = -placement->direction;  // it lies under the liver
  preset_chosen();
  hold(placement->center_mm);
}

void ToolControls::pull(const Eigen::Vector3d& direction, double force_N) {
  dragged_direction_ = direction;
  direction_->setCurrentIndex(direction_->findData(dragged));
  apply_direction();
  set_force(std::clamp(force_N, 0.0, preset().largest_force_N));
}

void ToolControls::apply_direction() { rehearsal_.set_direction(chosen_direction()); }

Eigen::Vector3d ToolControls::chosen_direction() const {
  switch (direction_->currentData().toInt()) {
    case pull_away: return outward_;
    case push: return -outward_;
    case dragged: return dragged_direction_;
    default: return hoist_direction_;
  }
}

void ToolControls::set_force(double force_N) {
  force_is_usual_ = false;
  show_force(force_N);
  rehearsal_.set_force_N(force_N);
}

void ToolControls::show_force(double force_N) {
  const QSignalBlocker quiet_slider(force_slider_);
  const QSignalBlocker quiet_box(force_);
  const double largest_N = std::max(preset().largest_force_N, force_N);
  force_slider_->setRange(0, static_cast<int>(std::lround(largest_N / force_step_N)));
  force_->setRange(0, largest_N);
  force_slider_->setValue(static_cast<int>(std::lround(force_N / force_step_N)));
  force_->setValue(force_N);
}

// Where another hand than this panel's took or moved the tool.
void ToolControls::show_current_tool() {
  const PlacedTool& tool = rehearsal_.tools().back();
  const int index = tool_->findData(QString::fromStdString(tool.preset));
  if (index >= 0) tool_->setCurrentIndex(index);
  outward_ = tool.outward;
  if (std::abs(tool.force_N - force_->value()) > 0.5 * force_step_N) show_force(tool.force_N);
  if ((tool.direction - chosen_direction()).norm() > 1e-9) {
    dragged_direction_ = tool.direction;
    direction_->setCurrentIndex(direction_->findData(dragged));
  }
}

void ToolControls::mark_where_the_model_ends() {
  const double maximum_N = force_->maximum();
  const auto within_N = rehearsal_.force_within_the_model_N(maximum_N);
  const bool ends = within_N && *within_N < maximum_N;
  force_slider_->set_mark(ends ? std::optional(*within_N / force_step_N) : std::nullopt);
  force_slider_->setToolTip(ends ? tr("From %1 N on, strains are outside of the model").arg(*within_N, 0, 'f', 1)
                                 : QString());
}

void ToolControls::follow() {
  if (rehearsal_.has_tool()) show_current_tool();
  mark_where_the_model_ends();
  setEnabled(!rehearsal_.frozen());
  rigid_->setEnabled(rehearsal_.knows_rigid_tools());
  rigid_->setChecked(rehearsal_.touch() == Touch::rigid);
  keep_->setEnabled(rehearsal_.touch() == Touch::rigid && rehearsal_.has_tool());
  release_->setEnabled(rehearsal_.has_tool());
}

}  // namespace glisson::widgets

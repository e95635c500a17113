#include "panels/rehearse_panel.h"

#include <algorithm>
#include <cmath>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "words/told.h"
#include "words/worded.h"

namespace glisson::widgets {
namespace {

constexpr double force_step_N = 0.1;

// Towards the front and the head in equal parts, as rehearsal/tool_presets.h hoists.
const Eigen::Vector3d front_and_head = Eigen::Vector3d(0, -1, 1).normalized();

QLabel* heading(QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setObjectName("heading");
  return label;
}

}  // namespace

RehearsePanel::RehearsePanel(LiveRehearsal& rehearsal, QWidget* parent)
    : QWidget(parent), rehearsal_(rehearsal), hoist_direction_(front_and_head) {
  setObjectName("panel");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(14, 14, 14, 14);
  column->setSpacing(8);
  QLabel* title = heading(this);
  column->addWidget(title);
  missing_ = new QLabel(this);
  missing_->setObjectName("faint");
  missing_->setWordWrap(true);
  column->addWidget(missing_);
  evidence_text_ = new QLabel(this);
  evidence_text_->setObjectName("evidence");
  evidence_text_->setWordWrap(true);
  evidence_text_->hide();
  column->addWidget(evidence_text_);
  controls_ = new QWidget(this);
  auto* inner = new QVBoxLayout(controls_);
  inner->setContentsMargins(0, 0, 0, 0);
  inner->setSpacing(8);
  inner->addWidget(make_tool_group());
  inner->addSpacing(6);
  QLabel* look_title = heading(this);
  inner->addWidget(look_title);
  inner->addWidget(make_look_group());
  inner->addSpacing(6);
  QLabel* landmarks_title = heading(this);
  inner->addWidget(landmarks_title);
  summary_ = new QLabel(this);
  summary_->setObjectName("summary");
  summary_->setWordWrap(true);
  inner->addWidget(summary_);
  table_ = new LandmarkTable(this);
  inner->addWidget(table_, 1);
  column->addWidget(controls_, 1);
  column->addStretch(0);
  connect(table_, &LandmarkTable::landmark_chosen, this, &RehearsePanel::landmark_chosen);
  connect(&rehearsal_, &LiveRehearsal::frame_changed, this, &RehearsePanel::show_frame);
  preset_chosen();
  set_ready(false);
  worded(this, [=, this] {
    title->setText(tr("Rehearse"));
    missing_->setText(tr("Open a case with a model of the liver, or the demo patient, to rehearse a retraction."));
    look_title->setText(tr("Show the liver with the stiffness of"));
    landmarks_title->setText(tr("Landmarks"));
    word_evidence();
    show_frame();
  });
}

void RehearsePanel::show_evidence(const casefile::Evidence& evidence) {
  evidence_ = evidence;
  evidence_text_->setVisible(!evidence.effects.empty());
  word_evidence();
}

void RehearsePanel::word_evidence() {
  QStringList changed, left_out;
  for (const closedloop::LearntEffect& effect : evidence_.effects) {
    (effect.carried ? changed : left_out) << told(effect.sentence);
  }
  for (const Sentence& remark : evidence_.remarks) left_out << told(remark);
  QStringList paragraphs;
  if (!changed.isEmpty()) paragraphs << tr("Changed by evidence: %1").arg(changed.join(" "));
  if (!left_out.isEmpty()) paragraphs << tr("Evidence to bear in mind: %1").arg(left_out.join(" "));
  evidence_text_->setText(paragraphs.join("\n"));
}

QWidget* RehearsePanel::make_tool_group() {
  auto* group = new QWidget(this);
  auto* form = new QFormLayout(group);
  form->setContentsMargins(0, 0, 0, 0);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);

  tool_ = new QComboBox(group);
  tool_->setObjectName("tool");
  for (const rehearsal::ToolPreset& preset : rehearsal::tool_presets()) {
    tool_->addItem({}, QString::fromStdString(preset.id));
  }
  auto* tool_name = new QLabel(group);
  form->addRow(tool_name, tool_);
  connect(tool_, &QComboBox::activated, this, &RehearsePanel::preset_chosen);

  auto* places = new QHBoxLayout;
  place_ = new QPushButton(QIcon(":/icons/place.svg"), {}, group);
  place_->setObjectName("place");
  place_->setCheckable(true);
  hoist_button_ = new QPushButton(group);
  hoist_button_->setObjectName("hoist");
  places->addWidget(place_);
  places->addWidget(hoist_button_);
  form->addRow(places);
  connect(place_, &QPushButton::toggled, this, &RehearsePanel::placing_changed);
  connect(hoist_button_, &QPushButton::clicked, this, &RehearsePanel::hoist_segment_vi);

  direction_ = new QComboBox(group);
  direction_->setObjectName("direction");
  for (const Direction direction : {hoist, pull, push}) direction_->addItem({}, direction);
  auto* direction_name = new QLabel(group);
  form->addRow(direction_name, direction_);
  connect(direction_, &QComboBox::activated, this, &RehearsePanel::apply_direction);

  auto* forces = new QHBoxLayout;
  force_slider_ = new QSlider(Qt::Horizontal, group);
  force_slider_->setObjectName("force_slider");
  force_ = new NumberBox(group);
  force_->setObjectName("force");
  force_->setDecimals(1);
  force_->setSingleStep(force_step_N);
  force_->setKeyboardTracking(false);
  forces->addWidget(force_slider_, 1);
  forces->addWidget(force_);
  auto* force_name = new QLabel(group);
  form->addRow(force_name, forces);
  connect(force_slider_, &QSlider::valueChanged, this, [this](int steps) { set_force(steps * force_step_N); });
  connect(force_, &QDoubleSpinBox::valueChanged, this, &RehearsePanel::set_force);

  release_ = new QPushButton(group);
  release_->setObjectName("release");
  release_->setEnabled(false);
  form->addRow(release_);
  connect(release_, &QPushButton::clicked, &rehearsal_, &LiveRehearsal::take_tool_away);

  worded(group, [=, this] {
    tool_name->setText(tr("Tool"));
    for (int k = 0; k < tool_->count(); ++k) {
      const rehearsal::ToolPreset& preset = rehearsal::tool_presets()[static_cast<std::size_t>(k)];
      tool_->setItemText(k, told(preset.name));
      tool_->setItemData(k, told(preset.source), Qt::ToolTipRole);
    }
    place_->setText(tr("Place by click"));
    place_->setToolTip(tr("Then click on the liver where the tool is to touch it"));
    hoist_button_->setText(tr("Hoist segment VI"));
    hoist_button_->setToolTip(
        tr("Puts the tool under the right, lower, rear part of the liver, lifting it to the front and the head"));
    direction_name->setText(tr("Direction"));
    direction_->setItemText(hoist, tr("Hoist to front and head"));
    direction_->setItemText(pull, tr("Pull away from the surface"));
    direction_->setItemText(push, tr("Push into the surface"));
    force_name->setText(tr("Force"));
    force_->setSuffix(tr(" N"));
    release_->setText(tr("Take the tool away"));
  });
  return group;
}

QWidget* RehearsePanel::make_look_group() {
  auto* group = new QWidget(this);
  auto* column = new QVBoxLayout(group);
  column->setContentsMargins(0, 0, 0, 0);
  comparison_ = new ComparisonChoice(group);
  column->addWidget(comparison_);
  by_displacement_ = new QCheckBox(group);
  by_displacement_->setObjectName("by_displacement");
  column->addWidget(by_displacement_);
  worded(group, [this] { by_displacement_->setText(tr("Colour the liver by how far it moves")); });
  connect(comparison_, &ComparisonChoice::changed, this, &RehearsePanel::bodies_chosen);
  connect(by_displacement_, &QCheckBox::toggled, this,
          [this](bool on) { Q_EMIT liver_colour_chosen(on ? LiverColour::displacement : LiverColour::tissue); });
  return group;
}

void RehearsePanel::set_ready(bool ready) {
  missing_->setVisible(!ready);
  controls_->setVisible(ready);
  place_->setChecked(false);
  comparison_->choose(Bodies::patient);
  by_displacement_->setChecked(false);
  show_frame();
}

const rehearsal::ToolPreset& RehearsePanel::preset() const {
  return rehearsal::tool_presets()[static_cast<std::size_t>(std::max(0, tool_->currentIndex()))];
}

void RehearsePanel::preset_chosen() {
  const rehearsal::ToolPreset& chosen = preset();
  const QSignalBlocker quiet_slider(force_slider_);
  const QSignalBlocker quiet_box(force_);
  force_slider_->setRange(0, static_cast<int>(std::lround(chosen.largest_force_N / force_step_N)));
  force_->setRange(0, chosen.largest_force_N);
  set_force(chosen.usual_force_N);
  if (rehearsal_.has_tool()) rehearsal_.place_tool(rehearsal_.tool_center_mm(), chosen.radius_mm);
}

void RehearsePanel::place_at(const Eigen::Vector3d& position_mm, const Eigen::Vector3d& outward_normal) {
  normal_ = outward_normal;
  place_->setChecked(false);
  apply_direction();
  rehearsal_.place_tool(position_mm, preset().radius_mm);
}

void RehearsePanel::hoist_segment_vi() {
  if (rehearsal_.body() == nullptr) return;
  const auto placement = rehearsal::hoist_segment_vi(rehearsal_.body()->patient().mesh());
  if (!placement) {
    Q_EMIT rehearsal_.failed(placement.error());
    return;
  }
  tool_->setCurrentIndex(std::max(0, tool_->findData(QString::fromStdString(placement->preset.id))));
  direction_->setCurrentIndex(direction_->findData(hoist));
  hoist_direction_ = placement->direction;
  preset_chosen();
  apply_direction();
  rehearsal_.place_tool(placement->center_mm, placement->preset.radius_mm);
}

void RehearsePanel::apply_direction() {
  switch (direction_->currentData().toInt()) {
    case pull: rehearsal_.set_direction(normal_); break;
    case push: rehearsal_.set_direction(-normal_); break;
    default: rehearsal_.set_direction(hoist_direction_); break;
  }
}

void RehearsePanel::set_force(double force_N) {
  const QSignalBlocker quiet_slider(force_slider_);
  const QSignalBlocker quiet_box(force_);
  force_slider_->setValue(static_cast<int>(std::lround(force_N / force_step_N)));
  force_->setValue(force_N);
  rehearsal_.set_force_N(force_N);
}

void RehearsePanel::show_frame() {
  const auto& frame = rehearsal_.frame();
  table_->show_frame(frame ? &*frame : nullptr);
  release_->setEnabled(rehearsal_.has_tool());
  if (!frame) {
    summary_->setText(tr("Place the tool to see what moves."));
    return;
  }
  QString text = tr("The liver moves by up to %1 mm.").arg(frame->patient.max_displacement_mm, 0, 'f', 1);
  if (frame->atlas) text += " " + tr("The atlas is off by up to %1 mm.").arg(frame->max_difference_mm, 0, 'f', 1);
  // Small-strain theory is the model's; say where it is stretched.
  constexpr double strain_worth_a_word = 0.2;
  if (frame->strain_bound > strain_worth_a_word) {
    text += "\n" + tr("Strains may reach %1 %, more than this linear model is made for.")
                       .arg(100 * frame->strain_bound, 0, 'f', 0);
  }
  summary_->setText(text);
}

}  // namespace glisson::widgets

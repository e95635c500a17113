#include "widgets/rehearse/rehearse_panel.h"

#include <algorithm>
#include <QHBoxLayout>
#include <QPushButton>
#include <QSplitter>
#include <QVBoxLayout>

#include "base/files.h"
#include "casefile/placed_landmarks.h"
#include "meshing/image_end.h"
#include "widgets/panels/ask_path.h"
#include "widgets/panels/parts.h"
#include "widgets/rehearse/deformation_choice.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/paths.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {
namespace {

constexpr const char* proposed_file = "landmarks.csv";

}  // namespace

RehearsePanel::RehearsePanel(LiveRehearsal& rehearsal, QWidget* parent) : QWidget(parent), rehearsal_(rehearsal) {
  setObjectName("panel");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(14, 12, 14, 12);
  column->setSpacing(8);
  QLabel* title = heading(this);
  column->addWidget(title);
  missing_ = wrapped_label("faint", this);
  column->addWidget(missing_);
  evidence_text_ = wrapped_label("evidence", this);
  evidence_text_->hide();
  column->addWidget(evidence_text_);
  controls_ = new QWidget(this);
  auto* inner = new QVBoxLayout(controls_);
  inner->setContentsMargins(0, 0, 0, 0);
  inner->setSpacing(7);
  tool_ = new ToolControls(rehearsal, this);
  inner->addWidget(tool_);
  inner->addWidget(new DeformationChoice(rehearsal, this));
  light_ = new SolvingLight(rehearsal, this);
  inner->addWidget(light_);
  on_cap_ = wrapped_label("tool_on_cap", this);
  on_cap_->hide();
  inner->addWidget(on_cap_);
  advance_ = new AdvanceControls(rehearsal, this);
  inner->addWidget(advance_);
  QLabel* look_title = heading(this);
  inner->addWidget(look_title);
  inner->addWidget(make_look_group());
  // Who watches the numbers makes the table taller, who watches the curves the plot.
  auto* answers = new QSplitter(Qt::Vertical);
  answers->setChildrenCollapsible(false);
  auto* landmarks = new QWidget;
  auto* landmarks_column = new QVBoxLayout(landmarks);
  landmarks_column->setContentsMargins(0, 0, 0, 4);
  auto* landmarks_row = new QHBoxLayout;
  QLabel* landmarks_title = heading(this);
  landmarks_row->addWidget(landmarks_title, 1);
  set_landmark_ = named_button("set_landmark", this);
  landmarks_row->addWidget(set_landmark_);
  remove_landmark_ = named_button("remove_landmark", this);
  landmarks_row->addWidget(remove_landmark_);
  auto* save = named_button("save_landmarks", this);
  landmarks_row->addWidget(save);
  landmarks_column->addLayout(landmarks_row);
  summary_ = wrapped_label("summary", this);
  landmarks_column->addWidget(summary_);
  table_ = new LandmarkTable(this);
  table_->setMinimumHeight(104);  // two rows; on a small screen the panel scrolls
  landmarks_column->addWidget(table_, 1);
  answers->addWidget(landmarks);
  auto* over_time = new QWidget;
  auto* time_column = new QVBoxLayout(over_time);
  time_column->setContentsMargins(0, 4, 0, 0);
  QLabel* time_title = heading(this);
  time_column->addWidget(time_title);
  track_ = new TrackControls(rehearsal, this);
  time_column->addWidget(track_, 1);
  answers->addWidget(over_time);
  answers->setStretchFactor(0, 1);
  answers->setSizes({1000, 1});  // the plot as small as it can be read
  inner->addWidget(answers, 1);
  orders_ = new KeptOrders(this);
  orders_fold_ = new Fold("orders_fold", orders_, Fold::At::closed, this);
  inner->addWidget(orders_fold_);
  // On a small screen the panel scrolls, so that nothing in it is cut off.
  controls_->setObjectName("panel");
  room_ = scrolled(controls_);
  column->addWidget(room_, 1);

  connect(tool_, &ToolControls::placing_changed, this, &RehearsePanel::placing_changed);
  connect(tool_, &ToolControls::place_at_crosshair, this, &RehearsePanel::place_at_crosshair);
  connect(tool_, &ToolControls::failed, this, &RehearsePanel::failed);
  connect(table_, &LandmarkTable::landmark_chosen, this, &RehearsePanel::landmark_chosen);
  connect(table_, &LandmarkTable::landmark_chosen, track_, &TrackControls::follow_landmark);
  connect(save, &QPushButton::clicked, this, &RehearsePanel::save_landmarks);
  connect(table_, &LandmarkTable::landmark_chosen, this, &RehearsePanel::allow_for_landmarks);
  connect(table_, &LandmarkTable::rename_wanted, this, &RehearsePanel::rename_landmark);
  connect(remove_landmark_, &QPushButton::clicked, this, &RehearsePanel::remove_landmark);
  connect(set_landmark_, &QPushButton::clicked, this, [this] {
    const auto taken = [this](const std::string& name) {
      return std::any_of(placed_landmarks_.begin(), placed_landmarks_.end(),
                         [&](const mechanics::Landmark& one) { return one.id == name; });
    };
    int number = 1;
    while (taken("landmark-" + std::to_string(number))) ++number;
    Q_EMIT landmark_wanted("landmark-" + std::to_string(number));
  });
  connect(track_, &TrackControls::failed, this, &RehearsePanel::failed);
  connect(track_, &TrackControls::said, this, &RehearsePanel::said);
  connect(&rehearsal_, &LiveRehearsal::state_changed, this, &RehearsePanel::show_state);
  connect(&rehearsal_, &LiveRehearsal::solving_changed, tool_, &ToolControls::follow);
  set_ready(false);
  keep_translated(this, [=, this] {
    title->setText(tr("Rehearse"));
    missing_->setText(tr("Open a case with a model of the liver, or the demo patient, to rehearse a retraction."));
    look_title->setText(tr("Show the liver with the stiffness of"));
    landmarks_title->setText(tr("Landmarks"));
    update_evidence_text();
    set_landmark_->setText(tr("Set"));
    set_landmark_->setToolTip(tr("Sets a landmark where the crosshair is: click in a slice or in 3D first"));
    remove_landmark_->setText(tr("Remove"));
    remove_landmark_->setToolTip(tr("Takes the chosen landmark away, if it was set by hand; Ctrl+Z brings it back"));
    save->setText(tr("Save..."));
    save->setToolTip(tr("Saves the landmarks as CSV, in mm"));
    time_title->setText(tr("Over time"));
    orders_fold_->set_title(tr("Orders of steps"));
    show_state();
  });
}

void RehearsePanel::show_evidence(const casefile::Evidence& evidence) {
  evidence_ = evidence;
  evidence_text_->setVisible(!evidence.effects.empty());
  update_evidence_text();
}

void RehearsePanel::show_plan(std::optional<rehearsal::CutCourse> course, std::optional<Sentence> why_not,
                              std::vector<std::string> structures) {
  advance_->set_structure_names(std::move(structures));
  advance_->set_course(std::move(course), std::move(why_not));
}

void RehearsePanel::update_evidence_text() {
  QStringList changed, left_out;
  for (const closedloop::LearntEffect& effect : evidence_.effects) {
    (effect.carried ? changed : left_out) << translated(effect.sentence);
  }
  for (const Sentence& remark : evidence_.remarks) left_out << translated(remark);
  QStringList paragraphs;
  if (!changed.isEmpty()) paragraphs << tr("Changed by evidence: %1").arg(changed.join(" "));
  if (!left_out.isEmpty()) paragraphs << tr("Evidence to bear in mind: %1").arg(left_out.join(" "));
  evidence_text_->setText(paragraphs.join("\n"));
}

void RehearsePanel::show_placed_landmarks(std::vector<mechanics::Landmark> landmarks) {
  placed_landmarks_ = std::move(landmarks);
  std::set<std::string> own;
  for (const mechanics::Landmark& landmark : placed_landmarks_) own.insert(landmark.id);
  table_->set_own(std::move(own));
  show_state();
}

void RehearsePanel::allow_for_landmarks() { remove_landmark_->setEnabled(!table_->chosen_own().empty()); }

void RehearsePanel::rename_landmark(const std::string& id, const QString& typed) {
  const std::string name = casefile::landmark_name(typed.trimmed().toLower().toStdString());
  std::vector<mechanics::Landmark> landmarks = placed_landmarks_;
  const auto of_name = [&](const std::string& wanted) {
    return std::find_if(landmarks.begin(), landmarks.end(), [&](const auto& one) { return one.id == wanted; });
  };
  const auto renamed = of_name(id);
  const auto& shown = rehearsal_.state();
  const bool taken = shown && std::any_of(shown->patient.landmarks.begin(), shown->patient.landmarks.end(),
                                          [&](const auto& one) { return one.id == name; });
  if (name == id || name.empty() || taken || renamed == landmarks.end()) {
    if (name != id) Q_EMIT said(name.empty() ? tr("A name has letters or digits.") : tr("This name is taken."));
    show_state();
    return;
  }
  renamed->id = name;
  Q_EMIT landmarks_wanted(tr("Rename landmark"), landmarks);
}

void RehearsePanel::remove_landmark() {
  std::vector<mechanics::Landmark> landmarks = placed_landmarks_;
  const std::string gone = table_->chosen_own();
  std::erase_if(landmarks, [&](const mechanics::Landmark& one) { return one.id == gone; });
  if (landmarks.size() != placed_landmarks_.size()) Q_EMIT landmarks_wanted(tr("Remove landmark"), landmarks);
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
  assumed_text_ = wrapped_label("assumed_stiffness", group);
  assumed_text_->hide();
  column->addWidget(assumed_text_);
  keep_translated(group, [this] {
    show_assumed_stiffness(assumed_);
    by_displacement_->setText(tr("Colour the liver by how far it moves"));
  });
  connect(comparison_, &ComparisonChoice::changed, this, &RehearsePanel::bodies_chosen);
  connect(by_displacement_, &QCheckBox::toggled, this,
          [this](bool on) { Q_EMIT liver_colour_chosen(on ? LiverColour::displacement : LiverColour::tissue); });
  return group;
}

void RehearsePanel::show_assumed_stiffness(const std::optional<Sentence>& assumed) {
  assumed_ = assumed;
  assumed_text_->setVisible(assumed_.has_value());
  assumed_text_->setText(assumed_ ? translated(*assumed_) : QString());
  comparison_->set_comparable(!assumed_);
}

void RehearsePanel::set_ready(bool ready) {
  missing_->setVisible(!ready);
  controls_->setVisible(ready);
  room_->setVerticalScrollBarPolicy(ready ? Qt::ScrollBarAsNeeded : Qt::ScrollBarAlwaysOff);  // nothing to scroll to
  tool_->stop_placing();
  advance_->put_knife_away();
  comparison_->choose(Bodies::patient);
  by_displacement_->setChecked(false);
  show_state();
}

void RehearsePanel::drag_arrow(const Eigen::Vector3d& free_end_mm, const Eigen::Vector3d& touch_mm) {
  if (!rehearsal_.has_tool() || rehearsal_.frozen()) return;
  if (!dragged_pulls_) dragged_pulls_ = rehearsal_.tools().back().pulls();
  const Eigen::Vector3d way_mm =
      *dragged_pulls_ ? Eigen::Vector3d(free_end_mm - touch_mm) : Eigen::Vector3d(touch_mm - free_end_mm);
  if (!(way_mm.norm() > 1)) return;
  tool_->pull(way_mm.normalized(), arrow_force_N(way_mm.norm()));
}

void RehearsePanel::hold_again(PlacedTool tool) {
  for (const rehearsal::ToolPreset& preset : rehearsal::tool_presets()) {
    if (preset.radius_mm == tool.radius_mm) tool.preset = preset.id;
  }
  rehearsal_.hold(tool);
}

void RehearsePanel::let_arrow_go() {
  if (!dragged_pulls_) return;
  dragged_pulls_.reset();
  Q_EMIT rehearsal_.state_changed();
}

std::vector<ToolInView> RehearsePanel::tools_in_view() const {
  std::vector<ToolInView> shown;
  for (const PlacedTool& tool : rehearsal_.tools()) {
    shown.push_back({tool.center_mm, tool.direction, tool.force_N, tool.pulls(), {}, tool.preset});
  }
  const auto& solids = rehearsal_.solids();
  if (solids.size() == shown.size()) {
    for (std::size_t k = 0; k < shown.size(); ++k) shown[k].rods = solids[k];
  }
  if (!shown.empty() && dragged_pulls_) shown.back().pulls = *dragged_pulls_;
  return shown;
}

void RehearsePanel::show_image(std::shared_ptr<const imaging::Volume> image) {
  image_ = std::move(image);
  show_state();
}

// What a tool does where the liver only seems to end, no liver does.
void RehearsePanel::tell_cap() {
  const char* side = nullptr;
  if (image_ && rehearsal_.body() != nullptr && rehearsal_.has_tool()) {
    const PlacedTool& tool = rehearsal_.tools().back();
    side = meshing::cut_off_under(rehearsal_.body()->surface(), image_->grid, tool.center_mm, tool.radius_mm);
  }
  on_cap_->setVisible(side != nullptr);
  if (side == nullptr) return;
  on_cap_->setText(
      tr("▲ The image cuts the liver off here, towards %1. The tool touches a cap where the liver goes on: "
         "place it elsewhere.")
          .arg(translated(side)));
}

// There where steps are recorded, or some are kept.
void RehearsePanel::show_orders_fold() {
  const bool recorded = !rehearsal_.session_name().empty();
  const Deformations kind = rehearsal_.deformations();
  orders_->allow_keeping(recorded && kind != Deformations::meshfree && kind != Deformations::moving);
  orders_fold_->setVisible(recorded || !orders_->empty());
}

void RehearsePanel::show_state() {
  const auto& state = rehearsal_.state();
  tell_cap();
  show_orders_fold();
  table_->show_state(state ? &*state : nullptr);
  tool_->follow();
  allow_for_landmarks();
  if (!state) {
    summary_->setText(tr("Place the tool to see what moves."));
    return;
  }
  if (!state->validity.usable()) {
    summary_->setText(QString("– ") + translated(state->validity.sentence()));
    return;
  }
  QString text = tr("The liver moves by up to %1 mm.").arg(state->patient.max_displacement_mm, 0, 'f', 1);
  if (state->patient.landmarks.empty()) {
    text += " " + tr("There are no landmarks: put the crosshair where one is to be, then press Set.");
  }
  if (state->reference) text += " " + tr("The atlas is off by up to %1 mm.").arg(state->max_difference_mm, 0, 'f', 1);
  summary_->setText(text);
}

void RehearsePanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  Q_EMIT at_work(true);
}

void RehearsePanel::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  Q_EMIT at_work(false);
}

void RehearsePanel::save_landmarks() {
  if (!rehearsal_.state()) {
    Q_EMIT said(tr("Place the tool to see what moves."));
    return;
  }
  const QString file =
      ask_where_to_save(this, tr("Save the landmarks as a table"), proposed_file, tr("Tables (*.csv)"));
  if (file.isEmpty()) return;
  if (auto written = write_text_file(path_of(file), landmark_csv(*rehearsal_.state())); !written) {
    Q_EMIT failed(written.error());
  } else {
    Q_EMIT said(tr("Written: %1").arg(file));
  }
}

}  // namespace glisson::widgets

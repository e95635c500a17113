#include "widgets/model/model_panel.h"

#include <algorithm>
#include <QFormLayout>
#include <QFutureWatcher>
#include <QHBoxLayout>
#include <QtConcurrentRun>
#include <QVBoxLayout>

#include "mechanics/scenario/scenario.h"
#include "widgets/panels/parts.h"
#include "widgets/session/load_patient.h"
#include "widgets/views/wave_view.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/paths.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {
namespace {

using casefile::StiffnessChoice;

constexpr scene::Colour held_colour{0.95, 0.45, 0.20};
constexpr scene::Colour springs_colour{0.30, 0.75, 0.95};

// A little off the liver, so that neither hides the other.
std::shared_ptr<const geometry::Surface> lifted(const geometry::Surface& patch) {
  constexpr double lift_mm = 1.0;
  auto copy = std::make_shared<geometry::Surface>(patch);
  const auto normals = geometry::point_normals(patch);
  for (std::size_t p = 0; p < normals.size(); ++p) copy->points_mm[p] += lift_mm * normals[p];
  return copy;
}

// A part of the panel under its title, top to bottom.
struct Part {
  QWidget* group = new QWidget;
  QVBoxLayout* column = new QVBoxLayout(group);
  QLabel* title = heading(group);

  Part(int room_above, int spacing) {
    column->setContentsMargins(0, room_above, 0, 0);
    column->setSpacing(spacing);
    column->addWidget(title);
  }
  QLabel* label(const char* name) const {
    auto* made = wrapped_label(name, group);
    column->addWidget(made);
    return made;
  }
};

struct Reading {
  casefile::ModelState state;
  std::shared_ptr<const casefile::ModelFacts> facts;
  StiffnessChoice choice;
  bool has_map = false, has_liver = false;
  std::optional<Error> problem;
};

Reading read_case(const std::filesystem::path& folder) {
  Reading reading;
  const auto opened = casefile::Case::open(folder);
  if (!opened) {
    reading.problem = opened.error();
    return reading;
  }
  reading.has_map = opened->find("volumes/stiffness") != nullptr;
  reading.has_liver = opened->find("labels/liver") != nullptr;
  reading.choice = casefile::stiffness_choice_of(*opened);
  reading.state = casefile::model_state(*opened);
  if (!reading.state.built) return reading;
  auto facts = casefile::model_facts(*opened);
  if (facts) {
    reading.facts = std::make_shared<casefile::ModelFacts>(*std::move(facts));
  } else {
    reading.problem = facts.error();
  }
  return reading;
}

}  // namespace

ModelPanel::ModelPanel(WorkspaceContext context, QWidget* parent) : QWidget(parent), context_(std::move(context)) {
  const auto [title, missing, controls, column] = lay_out_side_panel(this);
  missing_ = missing;
  controls_ = controls;
  state_told_ = wrapped_label("model_state", controls_);
  column->addWidget(state_told_);
  update_ = named_button("primary", controls_);
  column->addWidget(update_);
  for (QWidget* each : {make_shown(), make_facts(), make_stiffness(), make_building()}) column->addWidget(each);
  notes_ = wrapped_label("faint", controls_);
  column->addWidget(notes_);
  column->addStretch(1);
  connect(update_, &QPushButton::clicked, this, [this] { rebuild({}); });
  keep_translated(this, [this, title = title] {
    title->setText(tr("Model"));
    update_->setText(tr("Bring it up to date"));
    word_state();
  });
}

Workspace ModelPanel::workspace(WorkspaceContext context) {
  auto* panel = new ModelPanel(std::move(context));
  return {.id = "model",
          .name = [] { return tr("Model"); },
          .about = [] { return tr("Cells, stiffness and supports of the liver, and building them anew."); },
          .widget = panel,
          .show_patient = [panel](const Patient& patient) { panel->show_patient(patient); },
          .missing =
              [](const Patient& patient) {
                return patient.liver() != nullptr ? QString()
                                                  : tr("Needs an outline of the liver: make it in Segment.");
              }};
}

QWidget* ModelPanel::make_shown() {
  const Part part(0, 6);
  auto* row = new QHBoxLayout;
  row->setSpacing(0);
  show_ = new QButtonGroup(part.group);
  std::array<QPushButton*, 3> choices{};
  constexpr std::array<const char*, 3> names{"show_stiffness", "show_supports", "show_patient"};
  constexpr std::array<const char*, 3> segments{"first", "middle", "last"};
  constexpr std::array<Shown, 3> meant{Shown::stiffness, Shown::supports, Shown::patient};
  for (std::size_t k = 0; k < choices.size(); ++k) {
    choices[k] = named_button(names[k], part.group);
    choices[k]->setCheckable(true);
    choices[k]->setProperty("segment", segments[k]);
    show_->addButton(choices[k], static_cast<int>(meant[k]));
    row->addWidget(choices[k]);
  }
  choices[0]->setChecked(true);
  part.column->addLayout(row);
  supports_told_ = part.label("faint");
  connect(show_, &QButtonGroup::idClicked, this, [this](int shown) {
    shown_ = static_cast<Shown>(shown);
    word_state();
    show_scene();
  });
  keep_translated(part.group, [=, title = part.title] {
    title->setText(tr("The 3D view shows"));
    choices[0]->setText(tr("Stiffness"));
    choices[1]->setText(tr("Attachments"));
    choices[2]->setText(tr("The patient"));
  });
  return part.group;
}

QWidget* ModelPanel::make_facts() {
  const Part part(0, 4);
  cells_ = part.label("model_cells");
  volume_ = part.label("model_volume");
  quality_ = part.label("model_quality");
  dihedrals_ = new HistogramPlot(part.group);
  part.column->addWidget(dihedrals_);
  keep_translated(part.group, [title = part.title] { title->setText(tr("Cells")); });
  return part.group;
}

QWidget* ModelPanel::make_stiffness() {
  const Part part(6, 6);
  stiffness_ = part.label("model_stiffness");
  moduli_ = new HistogramPlot(part.group);
  part.column->addWidget(moduli_);
  source_ = new QComboBox(part.group);
  source_->setObjectName("model_source");
  for (const Source source : {mre, atlas_own_cohort, atlas_published, one_value}) source_->addItem({}, source);
  part.column->addWidget(source_);
  auto* row = new QHBoxLayout;
  value_ = new NumberBox(part.group);
  value_->setObjectName("model_value");
  value_->setRange(0.1, 200);
  value_->setDecimals(1);
  value_->setValue(6);
  give_ = named_button("model_give", part.group);
  row->addWidget(value_);
  row->addWidget(give_, 1);
  part.column->addLayout(row);
  waves_ = named_button("model_waves", part.group);
  part.column->addWidget(waves_);
  connect(source_, &QComboBox::currentIndexChanged, this, &ModelPanel::word_state);
  connect(give_, &QPushButton::clicked, this, [this] { rebuild({}); });
  connect(waves_, &QPushButton::clicked, this, &ModelPanel::show_waves);
  keep_translated(part.group, [=, this, title = part.title] {
    title->setText(tr("Young's modulus"));
    source_->setItemText(mre, tr("From MR elastography"));
    source_->setItemText(atlas_own_cohort, tr("Assumed: the atlas's 2.1 kPa in shear"));
    source_->setItemText(atlas_published, tr("Assumed: the atlas's 2.6 kPa in shear"));
    source_->setItemText(one_value, tr("Assumed: one value for all cells"));
    value_->setSuffix(tr(" kPa"));
    value_->setToolTip(tr("Young's modulus, about three times the shear modulus"));
    give_->setText(tr("Give it this stiffness"));
    waves_->setText(tr("Elastography waves..."));
  });
  return part.group;
}

QWidget* ModelPanel::make_building() {
  const Part part(6, 6);
  auto* row = new QHBoxLayout;
  target_ = new NumberBox(part.group);
  target_->setDecimals(0);
  target_->setObjectName("model_target");
  target_->setRange(500, 200000);
  target_->setSingleStep(5000);
  target_->setValue(meshing::MeshOptions{}.target_cells);
  build_ = named_button("model_build", part.group);
  row->addWidget(target_);
  row->addWidget(build_, 1);
  part.column->addLayout(row);
  connect(build_, &QPushButton::clicked, this, [this] { rebuild(static_cast<int>(target_->value())); });
  keep_translated(part.group, [=, this, title = part.title] {
    title->setText(tr("Build"));
    target_->setSuffix(tr(" cells"));
    target_->setToolTip(tr("Wanted number of cells: more are finer and slower. 20 000 answer at once."));
  });
  return part.group;
}

void ModelPanel::show_patient(const Patient& patient) {
  const bool completed = patient.completes(patient_);
  patient_ = patient;
  if (completed) {  // its facts are there already, or on their way
    word_state();
    if (isVisible()) show_scene();
    return;
  }
  facts_.reset();
  state_ = {};
  has_waves_ = !patient.folder.empty() && WaveView::has_waves(patient.folder);
  read();
  word_state();
}

void ModelPanel::read() {
  const int asked = ++asked_;
  if (patient_.folder.empty()) return;
  auto* watcher = new QFutureWatcher<std::shared_ptr<Reading>>(this);
  connect(watcher, &QFutureWatcherBase::finished, this, [this, watcher, asked] {
    watcher->deleteLater();
    if (asked != asked_) return;
    const std::shared_ptr<Reading> reading = watcher->result();
    if (reading->problem) context_.tell_error(*reading->problem);
    facts_ = reading->facts;
    state_ = reading->state;
    has_map_ = reading->has_map;
    has_liver_ = reading->has_liver;
    take_choice(reading->choice);
    if (facts_) target_->setValue(facts_->target_cells);
    word_state();
    show_scene();
  });
  watcher->setFuture(
      QtConcurrent::run([folder = patient_.folder] { return std::make_shared<Reading>(read_case(folder)); }));
}

void ModelPanel::take_choice(const StiffnessChoice& choice) {
  const QSignalBlocker quiet(source_);
  if (const auto* uniform = std::get_if<casefile::Uniform>(&choice)) {
    source_->setCurrentIndex(one_value);
    value_->setValue(uniform->youngs_kPa);
  } else if (const auto* atlas = std::get_if<casefile::FromAtlas>(&choice)) {
    source_->setCurrentIndex(atlas->atlas == elastography::Atlas::published_cohort ? atlas_published
                                                                                   : atlas_own_cohort);
  } else {
    source_->setCurrentIndex(mre);
  }
}

StiffnessChoice ModelPanel::choice() const {
  switch (source_->currentData().toInt()) {
    case mre: return casefile::FromMre{};
    case atlas_published: return casefile::FromAtlas{elastography::Atlas::published_cohort};
    case one_value: return casefile::Uniform{value_->value()};
    default: return casefile::FromAtlas{};
  }
}

void ModelPanel::rebuild(const std::optional<int>& target_cells) {
  context_.change(tr("Building the model"),
                  [folder = patient_.folder,
                   upkeep = casefile::Upkeep{target_cells, choice()}](const Progress& progress) -> Result<Patient> {
                    auto patient = casefile::Case::open(folder);
                    if (!patient) return failure(patient.error());
                    auto made = casefile::bring_model_up_to_date(*patient, upkeep, progress.part(0, 0.22));
                    if (!made) return failure(std::move(made.error()));
                    return load_patient(folder, progress.part(0.22, 1));
                  });
}

void ModelPanel::show_waves() {
  auto* view = new WaveView(patient_.folder, window());
  view->setWindowFlag(Qt::Window);
  view->setAttribute(Qt::WA_DeleteOnClose);
  view->set_guard(context_.may_change);
  connect(view, &WaveView::accepted, this, [this] {
    context_.change(tr("Opening %1").arg(text_of(patient_.folder.filename())),
                    [folder = patient_.folder](const Progress& progress) { return load_patient(folder, progress); });
  });
  view->show();
  view->invert();
}

void ModelPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  show_scene();
}

void ModelPanel::hideEvent(QHideEvent* event) {
  context_.patient_views.set_workspace_scene({});
  QWidget::hideEvent(event);
}

void ModelPanel::show_scene() {
  if (!isVisible()) return;
  if (!facts_ || shown_ == Shown::patient) {
    context_.patient_views.set_workspace_scene({});
    return;
  }
  WorkspaceScene scene;
  scene.patient = WorkspaceScene::Patient::at_rest;
  if (shown_ == Shown::supports) {
    const auto add = [&](const geometry::Surface& patch, const scene::Colour& colour, const QString& words) {
      if (patch.triangles.empty()) return;
      scene.surfaces.push_back({"support", lifted(patch), colour, 1, scene::Finish::solid, {}});
      scene.key.push_back({colour, words.toStdString()});
    };
    add(facts_->held, held_colour, tr("Held"));
    add(facts_->on_springs, springs_colour, tr("On springs"));
  } else if (!facts_->youngs_kPa.empty()) {
    scene.patient = WorkspaceScene::Patient::at_rest_in_slices_only;
    // A few stiff cells must not take all colours to themselves.
    std::vector<double> sorted = facts_->youngs_kPa;
    std::sort(sorted.begin(), sorted.end());
    const double low = sorted[sorted.size() / 50], high = std::max(sorted[sorted.size() * 49 / 50], low + 0.1);
    scene.surfaces.push_back({"liver",
                              std::make_shared<geometry::Surface>(facts_->surface),
                              {},
                              1,
                              scene::Finish::solid,
                              scene::Colouring{mechanics::youngs_modulus_field,
                                               scene::ColourMap::viridis,
                                               {low, high},
                                               tr("Young's modulus (kPa)").toStdString()}});
  }
  context_.patient_views.set_workspace_scene(std::move(scene));
}

void ModelPanel::word_state() {
  const bool outlined = patient_.liver() != nullptr;
  missing_->setVisible(patient_.folder.empty() || !outlined);
  missing_->setText(patient_.folder.empty() ? tr("Needs a case: open one, or the demo patient.")
                                            : tr("Needs an outline of the liver: make it in Segment."));
  controls_->setVisible(!patient_.folder.empty() && outlined);
  QStringList changed;
  for (const std::string& id : state_.changed) {
    changed << structure_label(id.substr(id.find('/') + 1));
  }
  state_told_->setText(!state_.built && facts_ == nullptr ? tr("There is no model yet. Build it from the outline.")
                       : state_.current                   ? tr("✓ The model is up to date.")
                       : state_.missing_file              ? tr("▲ A file of the model is gone.")
                       : state_.changed_outside           ? tr("▲ Another program has changed a file of the model.")
                       : changed.isEmpty()
                           ? tr("▲ The model is out of date.")
                           : tr("▲ Out of date: %1 changed since it was built.").arg(changed.join(", ")));
  update_->setVisible(state_.built && !state_.current);
  build_->setText(state_.built ? tr("Build it anew") : tr("Build the model"));
  for (QWidget* each : std::initializer_list<QWidget*>{cells_, volume_, quality_, stiffness_, dihedrals_, moduli_}) {
    each->setVisible(facts_ != nullptr);
  }
  const bool no_map = source_->currentData().toInt() == mre && !has_map_;
  value_->setEnabled(source_->currentData().toInt() == one_value);
  give_->setEnabled(state_.built && !no_map);
  give_->setToolTip(no_map         ? tr("This case has no stiffness map: import one, or invert its waves")
                    : state_.built ? tr("Keeps the cells and gives each this stiffness")
                                   : tr("Needs cells: build the model first"));
  build_->setEnabled(!no_map);
  build_->setToolTip(no_map ? give_->toolTip() : tr("Makes the cells anew and gives them the stiffness chosen above"));
  waves_->setEnabled(has_waves_);
  waves_->setToolTip(has_waves_ ? tr("See the waves and invert them") : tr("This case has no raw waves"));
  supports_told_->setText(shown_ == Shown::supports
                              ? tr("Assumed from the liver's shape: the bare area at the vena cava is held, the dome "
                                   "below the diaphragm rests on springs of 1.1 kPa/mm.")
                              : QString());
  supports_told_->setVisible(shown_ == Shown::supports);
  notes_->setVisible(facts_ != nullptr && !facts_->notes.empty());
  if (!facts_) return;
  const casefile::ModelFacts& facts = *facts_;
  cells_->setText(tr("%1 cells, %2 points").arg(facts.cells).arg(facts.points));
  volume_->setText(tr("%1 ml outlined; the cells hold %2 % of it")
                       .arg(facts.label_ml, 0, 'f', 0)
                       .arg(facts.label_ml > 0 ? 100 * facts.mesh_ml / facts.label_ml : 0, 0, 'f', 1));
  quality_->setText(
      tr("Smallest dihedral angle %1°")
          .arg(*std::min_element(facts.min_dihedral_deg.begin(), facts.min_dihedral_deg.end()), 0, 'f', 1));
  dihedrals_->show_values(facts.min_dihedral_deg, tr("smallest dihedral angle of a cell, °"));
  stiffness_->setText(
      (facts.assumed ? tr("Assumed: %1 kPa for all cells").arg(facts.mean_kPa, 0, 'f', 1)
                     : tr("%1 kPa on average, sd %2").arg(facts.mean_kPa, 0, 'f', 1).arg(facts.sd_kPa, 0, 'f', 1)) +
      (facts.filled_cells > 0 ? "\n" + tr("%1 % of the cells without data of their own, filled from inside")
                                           .arg(100.0 * static_cast<double>(facts.filled_cells) /
                                                    static_cast<double>(std::max<std::size_t>(1, facts.cells)),
                                                0, 'f', 0)
                              : QString()));
  moduli_->show_values(facts.youngs_kPa, tr("Young's modulus of a cell, kPa"));
  QStringList notes;
  for (const Sentence& note : facts.notes) notes << translated(note);
  notes_->setText(notes.join("\n"));
}

}  // namespace glisson::widgets

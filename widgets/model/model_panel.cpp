#include "widgets/model/model_panel.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "widgets/panels/parts.h"
#include "widgets/session/load_patient.h"
#include "widgets/views/wave_view.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/paths.h"
#include "widgets/work/run_in_background.h"

namespace glisson::widgets {
namespace {

using casefile::StiffnessChoice;

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
  state_text_ = wrapped_label("model_state", controls_);
  column->addWidget(state_text_);
  update_ = named_button("primary", controls_);
  column->addWidget(update_);
  measured_ = new FromMeasurements(context_, controls_);
  for (QWidget* each : {make_shown(), make_facts(), make_stiffness(), make_building()}) column->addWidget(each);
  column->addWidget(measured_);
  notes_ = wrapped_label("faint", controls_);
  column->addWidget(notes_);
  column->addStretch(1);
  connect(update_, &QPushButton::clicked, this, [this] { rebuild({}); });
  connect(measured_, &FromMeasurements::scene_changed, this, &ModelPanel::show_scene);
  keep_translated(this, [this, title = title] {
    title->setText(tr("Model"));
    update_->setText(tr("Bring it up to date"));
    update_text();
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
  supports_text_ = part.label("faint");
  connect(show_, &QButtonGroup::idClicked, this, [this](int shown) {
    shown_ = static_cast<Shown>(shown);
    measured_->hide_scene();
    update_text();
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
  for (const Source source : {mre, own_cohort_mean, published_mean, one_value}) source_->addItem({}, source);
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
  connect(source_, &QComboBox::currentIndexChanged, this, &ModelPanel::update_text);
  connect(give_, &QPushButton::clicked, this, [this] { rebuild({}); });
  connect(waves_, &QPushButton::clicked, this, &ModelPanel::show_waves);
  keep_translated(part.group, [=, this, title = part.title] {
    title->setText(tr("Young's modulus"));
    source_->setItemText(mre, tr("From MR elastography"));
    source_->setItemText(own_cohort_mean, tr("Assumed: the atlas's 2.1 kPa in shear"));
    source_->setItemText(published_mean, tr("Assumed: the atlas's 2.6 kPa in shear"));
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
  target_ = whole_number("model_target", 500, 200000, meshing::MeshOptions{}.target_cells, part.group);
  target_->setSingleStep(5000);
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
    update_text();
    if (isVisible()) show_scene();
    return;
  }
  facts_.reset();
  measured_->show_model(patient.folder, false);
  state_ = {};
  has_waves_ = !patient.folder.empty() && WaveView::has_waves(patient.folder);
  read();
  update_text();
}

void ModelPanel::read() {
  const int asked = ++asked_;
  if (patient_.folder.empty()) return;
  const auto show = [this, asked](const Reading& reading) {
    if (asked != asked_) return;
    if (reading.problem) context_.tell_error(*reading.problem);
    facts_ = reading.facts;
    state_ = reading.state;
    has_map_ = reading.has_map;
    has_liver_ = reading.has_liver;
    take_choice(reading.choice);
    if (facts_) target_->setValue(facts_->target_cells);
    measured_->show_model(patient_.folder, facts_ != nullptr);
    update_text();
    show_scene();
  };
  run_in_background(
      this, [folder = patient_.folder] { return read_case(folder); }, show);
}

void ModelPanel::take_choice(const StiffnessChoice& choice) {
  const QSignalBlocker quiet(source_);
  if (const auto* uniform = std::get_if<casefile::Uniform>(&choice)) {
    source_->setCurrentIndex(one_value);
    value_->setValue(uniform->youngs_kPa);
  } else if (const auto* mean = std::get_if<casefile::FromPopulationMean>(&choice)) {
    source_->setCurrentIndex(mean->mean == elastography::PopulationMean::published_cohort ? published_mean
                                                                                          : own_cohort_mean);
  } else {
    source_->setCurrentIndex(mre);
  }
}

StiffnessChoice ModelPanel::choice() const {
  switch (source_->currentData().toInt()) {
    case mre: return casefile::FromMre{};
    case published_mean: return casefile::FromPopulationMean{elastography::PopulationMean::published_cohort};
    case one_value: return casefile::Uniform{value_->value()};
    default: return casefile::FromPopulationMean{};
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
  view->set_recorder([undo = &context_.undo](const auto& change) { return undo->recorded(maps_of_waves, change); });
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

}  // namespace glisson::widgets

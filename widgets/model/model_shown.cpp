// What the workspace Model shows: its picture in the 3D view, and its figures in words.

#include <algorithm>

#include "mechanics/scenario/scenario.h"
#include "widgets/model/model_panel.h"
#include "widgets/words/paths.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {
namespace {

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

}  // namespace

void ModelPanel::show_scene() {
  if (!isVisible()) return;
  if (auto retracted = measured_->scene()) {
    context_.patient_views.set_workspace_scene(*std::move(retracted));
    return;
  }
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

void ModelPanel::update_text() {
  const bool outlined = patient_.liver() != nullptr;
  missing_->setVisible(patient_.folder.empty() || !outlined);
  missing_->setText(patient_.folder.empty() ? tr("Needs a case: open one, or the demo patient.")
                                            : tr("Needs an outline of the liver: make it in Segment."));
  controls_->setVisible(!patient_.folder.empty() && outlined);
  QStringList changed;
  for (const std::string& id : state_.changed) {
    changed << structure_label(id.substr(id.find('/') + 1));
  }
  state_text_->setText(!state_.built && facts_ == nullptr ? tr("There is no model yet. Build it from the outline.")
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
  supports_text_->setText(shown_ == Shown::supports
                              ? tr("Assumed from the liver's shape: the bare area at the vena cava is held, the dome "
                                   "below the diaphragm rests on springs of 1.1 kPa/mm.")
                              : QString());
  supports_text_->setVisible(shown_ == Shown::supports);
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

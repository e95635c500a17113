#pragma once
// Model: the cells, their stiffness and what holds them, whether all that is still what the case's outlines and maps
// make, building it anew, and the liver retracted by measurements in place of that stiffness.

#include <memory>
#include <QButtonGroup>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include "casefile/model_upkeep.h"
#include "widgets/model/from_measurements.h"
#include "widgets/plots/histogram_plot.h"
#include "widgets/words/number_box.h"
#include "widgets/workspaces/workspace.h"

namespace glisson::widgets {

class ModelPanel : public QWidget {
  Q_OBJECT

 public:
  enum class Shown { patient, stiffness, supports };

  explicit ModelPanel(WorkspaceContext context, QWidget* parent = nullptr);
  [[nodiscard]] static Workspace workspace(WorkspaceContext context);

  void show_patient(const Patient& patient);
  [[nodiscard]] const casefile::ModelFacts* facts() const { return facts_.get(); }
  [[nodiscard]] const casefile::ModelState& state() const { return state_; }

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  enum Source { mre, own_cohort_mean, published_mean, one_value };

  QWidget* make_facts();
  QWidget* make_stiffness();
  QWidget* make_building();
  QWidget* make_shown();
  void read();  // the case's model, on a worker
  void take_choice(const casefile::StiffnessChoice& choice);
  void rebuild(const std::optional<int>& target_cells);
  void show_waves();
  void show_scene();
  void update_text();
  [[nodiscard]] casefile::StiffnessChoice choice() const;

  WorkspaceContext context_;
  Patient patient_;
  std::shared_ptr<const casefile::ModelFacts> facts_;
  casefile::ModelState state_;
  bool has_map_ = false;
  bool has_liver_ = false;
  bool has_waves_ = false;
  int asked_ = 0;  // counts readings, so that one of another patient is known when it arrives
  Shown shown_ = Shown::stiffness;
  QLabel* missing_;
  QWidget* controls_;
  QLabel* state_text_;
  QPushButton* update_;
  QLabel* cells_;
  QLabel* volume_;
  QLabel* quality_;
  HistogramPlot* dihedrals_;
  QLabel* stiffness_;
  HistogramPlot* moduli_;
  QComboBox* source_;
  NumberBox* value_;
  QPushButton* give_;
  QPushButton* waves_;
  NumberBox* target_;
  QPushButton* build_;
  FromMeasurements* measured_;
  QButtonGroup* show_;
  QLabel* supports_text_;
  QLabel* notes_;
};

}  // namespace glisson::widgets

#pragma once
// Model, straight from measurements: the liver retracted by a table of strain and stress in place of its stiffness, and
// how far that is from what the model says (casefile/retraction_from_data.h).

#include <memory>
#include <optional>
#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include "casefile/retraction_from_data.h"
#include "widgets/plots/stress_strain_plot.h"
#include "widgets/words/number_box.h"
#include "widgets/workspaces/workspace.h"

namespace glisson::widgets {

class FromMeasurements : public QWidget {
  Q_OBJECT

 public:
  explicit FromMeasurements(WorkspaceContext context, QWidget* parent = nullptr);

  // Forgets the answer where the model may be another one.
  void show_model(const std::filesystem::path& case_folder, bool built);
  void retract_by(const std::filesystem::path& file);

  // The retracted liver, where it is to be seen in space.
  [[nodiscard]] std::optional<WorkspaceScene> scene() const;
  void hide_scene() { see_->setChecked(false); }

 Q_SIGNALS:
  void scene_changed();

 private:
  void ask();
  void show_answer(bool seen = false);  // seen: in the 3D view from now on
  [[nodiscard]] QString told() const;

  WorkspaceContext context_;
  std::filesystem::path folder_, file_;
  std::shared_ptr<const casefile::RetractionFromData> answer_;
  double force_N_ = 0;  // of the answer
  NumberBox* force_;
  QPushButton* choose_;
  QLabel* text_;
  StressStrainPlot* plot_;
  QPushButton* see_;
};

}  // namespace glisson::widgets

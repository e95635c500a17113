#include "widgets/model/from_measurements.h"

#include <algorithm>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "rehearsal/comparison.h"
#include "widgets/panels/ask_path.h"
#include "widgets/panels/parts.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/numbers.h"
#include "widgets/words/paths.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {

FromMeasurements::FromMeasurements(WorkspaceContext context, QWidget* parent)
    : QWidget(parent), context_(std::move(context)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 6, 0, 0);
  column->setSpacing(6);
  QLabel* title = heading(this);
  column->addWidget(title);
  QLabel* about = wrapped_label("faint", this);
  column->addWidget(about);
  auto* row = new QHBoxLayout;
  force_ = new NumberBox(this);
  force_->setObjectName("measured_force");
  force_->setRange(0.1, 10);
  force_->setDecimals(1);
  force_->setSingleStep(0.5);
  force_->setValue(1);
  choose_ = named_button("measurements", this);
  row->addWidget(force_);
  row->addWidget(choose_, 1);
  column->addLayout(row);
  text_ = wrapped_label("measured_told", this);
  column->addWidget(text_);
  plot_ = new StressStrainPlot(this);
  column->addWidget(plot_);
  see_ = named_button("see_measured", this);
  see_->setCheckable(true);
  column->addWidget(see_);
  connect(choose_, &QPushButton::clicked, this, &FromMeasurements::ask);
  connect(see_, &QPushButton::toggled, this, &FromMeasurements::scene_changed);
  keep_translated(this, [=, this] {
    title->setText(tr("Straight from measurements"));
    about->setText(tr("The liver lifted at segment VI by what was measured of the tissue, without a law."));
    force_->setSuffix(tr(" N"));
    force_->setToolTip(tr("Force of the retractor at segment VI"));
    choose_->setText(tr("Strain and stress..."));
    choose_->setToolTip(
        tr("A table with the columns strain and stress_kPa, or a material experiment; compression is "
           "negative"));
    see_->setText(tr("Show it in 3D"));
    show_answer();
  });
}

void FromMeasurements::show_model(const std::filesystem::path& case_folder, bool built) {
  folder_ = case_folder;
  answer_.reset();
  choose_->setEnabled(built);
  show_answer();
}

void FromMeasurements::ask() {
  const QString chosen =
      ask_for_file(this, tr("Measured strain and stress"), tr("Tables and experiments (*.csv *.json)"));
  if (!chosen.isEmpty()) retract_by(path_of(chosen));
}

void FromMeasurements::retract_by(const std::filesystem::path& file) {
  context_.work.start(
      tr("Retracting by %1").arg(text_of(file.filename())),
      [this, folder = folder_, file, force_N = force_->value()](const Progress& progress) -> BackgroundWork::Then {
        auto answer = casefile::Case::open(folder).and_then([&](const casefile::Case& patient) {
          return casefile::retract_from_data(patient, file, force_N, progress);
        });
        return [this, folder, file, force_N, answer = std::move(answer)]() mutable {
          if (!answer) return context_.tell_error(answer.error());
          if (folder != folder_) return;
          answer_ = std::make_shared<const casefile::RetractionFromData>(*std::move(answer));
          file_ = file;
          force_N_ = force_N;
          show_answer(true);
        };
      });
}

void FromMeasurements::show_answer(bool seen) {
  const bool usable = answer_ != nullptr && answer_->validity.usable();
  {
    const QSignalBlocker quiet(see_);  // the scene is told of once, below
    see_->setChecked(usable && (seen || see_->isChecked()));
  }
  show_text(text_, answer_ == nullptr ? QString() : told());
  plot_->setVisible(answer_ != nullptr);
  if (answer_) plot_->show_measurements(answer_->measured, answer_->slope_kPa);
  see_->setVisible(usable);
  Q_EMIT scene_changed();
}

QString FromMeasurements::told() const {
  const casefile::RetractionFromData& answer = *answer_;
  QStringList lines{tr("%1: %2 measurements, %3 N")
                        .arg(text_of(file_.filename()))
                        .arg(answer.measured.size())
                        .arg(number(force_N_, 1))};
  if (!answer.validity.usable()) return lines.front() + "\n▲ " + translated(answer.validity.sentence());
  lines << tr("Lifted by up to %1 mm; by the model's stiffness %2 mm.")
               .arg(number(answer.from_data_mm, 1), number(answer.by_model_mm, 1));
  lines << tr("Apart by %1 mm on average, %2 mm at most.")
               .arg(number(answer.apart_mean_mm, 1), number(answer.apart_largest_mm, 1));
  const auto far = std::max_element(answer.landmarks.begin(), answer.landmarks.end(),
                                    [](const auto& a, const auto& b) { return a.apart_mm < b.apart_mm; });
  if (far != answer.landmarks.end()) {
    lines << tr("Landmark %1: %2 mm apart, the most of all.").arg(structure_label(far->id), number(far->apart_mm, 1));
  }
  if (answer.beyond_data > 0) {
    lines << tr("▲ %1 % of the liver is strained farther than was measured.").arg(number(100 * answer.beyond_data, 1));
  }
  if (answer.validity.state() != mechanics::AnswerState::within) lines << "▲ " + translated(answer.validity.sentence());
  return lines.join("\n");
}

std::optional<WorkspaceScene> FromMeasurements::scene() const {
  if (answer_ == nullptr || !see_->isChecked()) return {};
  WorkspaceScene scene;
  scene.patient = WorkspaceScene::Patient::at_rest_in_slices_only;
  scene.surfaces.push_back({"liver",
                            std::shared_ptr<const geometry::Surface>(answer_, &answer_->surface),
                            {},
                            1,
                            scene::Finish::solid,
                            scene::Colouring{casefile::apart_field,
                                             scene::ColourMap::viridis,
                                             {0, std::max(rehearsal::significant_mm, answer_->apart_largest_mm)},
                                             tr("From the model's answer (mm)").toStdString()}});
  return scene;
}

}  // namespace glisson::widgets

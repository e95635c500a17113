#include "widgets/panels/export_menu.h"

#include <QRegularExpression>

#include "casefile/plans.h"
#include "widgets/panels/ask_path.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/paths.h"

namespace glisson::widgets {

using casefile::ExportFormat;

ExportMenu::ExportMenu(const WorkspaceContext& context, QWidget* parent) : QMenu(parent), context_(context) {
  with_plan_ = new QMenu(this);
  with_plan_->setObjectName("export_plan");
  struct Listed {
    const char* name;
    ExportFormat format;
  };
  for (const Listed& one : {Listed{"export_nifti", ExportFormat::nifti}, Listed{"export_nrrd", ExportFormat::nrrd},
                            Listed{"export_dicom_seg", ExportFormat::dicom_seg},
                            Listed{"export_stl", ExportFormat::stl}, Listed{"export_obj", ExportFormat::obj},
                            Listed{"export_vtp", ExportFormat::vtp}, Listed{"export_vtu", ExportFormat::vtu}}) {
    QAction* action = addAction(QString(), this, [this, format = one.format] { ask(format); });
    action->setObjectName(one.name);
    formats_.emplace_back(action, one.format);
    if (one.format == ExportFormat::dicom_seg) addMenu(with_plan_);
    if (one.format == ExportFormat::dicom_seg || one.format == ExportFormat::vtp) addSeparator();
  }
  connect(with_plan_, &QMenu::aboutToShow, this, &ExportMenu::list_plans);
  keep_translated(this, [this] { update_text(); });
}

void ExportMenu::update_text() {
  with_plan_->setTitle(tr("Outlines, remnant and specimen as DICOM SEG"));
  for (const auto& [action, format] : formats_) {
    switch (format) {
      case ExportFormat::nifti: action->setText(tr("Images and outlines as NIfTI...")); break;
      case ExportFormat::nrrd: action->setText(tr("Images and outlines as NRRD (3D Slicer)...")); break;
      case ExportFormat::dicom_seg: action->setText(tr("Outlines as DICOM SEG...")); break;
      case ExportFormat::stl: action->setText(tr("Surfaces as STL...")); break;
      case ExportFormat::obj: action->setText(tr("Surfaces as OBJ...")); break;
      case ExportFormat::vtp: action->setText(tr("Surfaces as VTP (ParaView)...")); break;
      case ExportFormat::vtu: action->setText(tr("The model's tetrahedra as VTU...")); break;
    }
  }
}

void ExportMenu::list_plans() {
  with_plan_->clear();
  const auto plans = casefile::Case::open(context_.patient().folder).and_then([](const casefile::Case& patient) {
    return casefile::kept_plans(patient);
  });
  for (const casefile::KeptPlan& kept : plans.value_or(std::vector<casefile::KeptPlan>())) {
    QString name = QString::fromStdString(kept.plan.name);
    with_plan_->addAction(name.replace("&", "&&"), this, [this, plan = kept.plan.name] {
      ask(ExportFormat::dicom_seg, {{}, plan});
    });
  }
  if (with_plan_->isEmpty()) with_plan_->addAction(tr("No plan is kept: keep one in Resect"))->setEnabled(false);
}

void ExportMenu::ask(ExportFormat format, const casefile::SegmentationExport& with) {
  QString name = text_of(context_.patient().folder.stem());
  if (with.plan) name += " - " + QString::fromStdString(*with.plan).replace(QRegularExpression(R"([/\\:*?"<>|])"), "_");
  const QString dicom_name = name + ".dcm", mesh_name = name + ".vtu";
  QString out;
  if (format == ExportFormat::dicom_seg) {
    out = ask_where_to_save(parentWidget(), tr("Save the outlines"), dicom_name, tr("DICOM (*.dcm)"));
  } else if (format == ExportFormat::vtu) {
    out = ask_where_to_save(parentWidget(), tr("Save the model"), mesh_name, tr("VTK meshes (*.vtu)"));
  } else {
    out = ask_for_folder(parentWidget(), tr("Write the files into this folder"));
  }
  if (!out.isEmpty()) write(format, path_of(out), with);
}

void ExportMenu::write(ExportFormat format, const std::filesystem::path& out,
                       const casefile::SegmentationExport& with) {
  context_.work.start(
      tr("Exporting"),
      [this, folder = context_.patient().folder, format, out, with](const Progress& progress) -> BackgroundWork::Then {
        const auto written = casefile::Case::open(folder).and_then(
            [&](const casefile::Case& patient) { return casefile::export_case(patient, format, out, progress, with); });
        return [this, written, out] {
          if (!written) return context_.tell_error(written.error());
          context_.tell_status(tr("Files written: %1, in %2").arg(written->size()).arg(text_of(out)));
        };
      });
}

}  // namespace glisson::widgets

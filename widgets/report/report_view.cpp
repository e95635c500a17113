#include "widgets/report/report_view.h"

#include <array>
#include <QDateTime>
#include <QHBoxLayout>
#include <QPrinter>
#include <QVBoxLayout>

#include "base/files.h"
#include "geometry/mesh_file.h"
#include "report/html.h"
#include "report/patient_page.h"
#include "widgets/panels/ask_path.h"
#include "widgets/panels/parts.h"
#include "widgets/report/page_document.h"
#include "widgets/report/page_words.h"
#include "widgets/resect/resection_scene.h"
#include "widgets/settings/settings.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/language.h"
#include "widgets/words/paths.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {
namespace {

namespace fs = std::filesystem;

// Proposed names say nothing of the patient.
const QString html_name = "report.html", pdf_name = "report.pdf";

std::optional<report::RehearsedRetraction> retraction_of(const LiveRehearsal& rehearsal) {
  const auto& state = rehearsal.state();
  if (!state) return {};
  report::RehearsedRetraction made{{}, state->patient.max_displacement_mm, {}, state->validity};
  made.large_deformations = rehearsal.deformations() == Deformations::large;
  if (rehearsal.solving() != Solving::solved) made.error_bound_mm = rehearsal.error_bound_mm();
  for (const PlacedTool& tool : rehearsal.tools()) made.tools.push_back({tool.preset, tool.force_N, tool.radius_mm});
  for (std::size_t k = 0; k < state->patient.landmarks.size(); ++k) {
    const auto& landmark = state->patient.landmarks[k];
    made.landmarks.push_back({landmark.id, landmark.displacement_mm, {}});
    if (k < state->differences.size()) made.landmarks.back().reference_off_mm = state->differences[k].difference_mm;
  }
  return made;
}

}  // namespace

ReportView::ReportView(WorkspaceContext context, PlanOfNow plan, QWidget* parent)
    : QWidget(parent), context_(std::move(context)), plan_(std::move(plan)) {
  setObjectName("report_view");
  auto* across = new QHBoxLayout(this);
  across->setContentsMargins(0, 0, 0, 0);
  across->setSpacing(0);
  auto* panel = new QWidget(this);
  panel->setObjectName("panel");
  panel->setFixedWidth(280);
  auto* column = new QVBoxLayout(panel);
  column->setContentsMargins(14, 14, 14, 14);
  column->setSpacing(8);
  QLabel* title = heading(panel);
  column->addWidget(title);
  state_ = new QLabel(panel);
  state_->setObjectName("report_state");
  state_->setWordWrap(true);
  column->addWidget(state_);
  name_ = new QCheckBox(panel);
  name_->setObjectName("report_name");
  column->addWidget(name_);
  boards_ = new QCheckBox(panel);
  boards_->setObjectName("report_boards");
  column->addWidget(boards_);
  refresh_ = named_button("report_refresh", panel);
  column->addWidget(refresh_);
  column->addSpacing(10);
  html_ = named_button("report_html", panel);
  pdf_ = named_button("primary", panel);
  column->addWidget(pdf_);
  column->addWidget(html_);
  column->addStretch(1);
  across->addWidget(panel);
  paper_ = new QTextBrowser(this);
  paper_->setObjectName("paper");
  paper_->setOpenLinks(false);
  paper_->setMaximumWidth(860);
  across->addStretch(1);
  across->addWidget(paper_, 30);
  across->addStretch(1);
  connect(name_, &QCheckBox::toggled, this, &ReportView::refresh);
  connect(boards_, &QCheckBox::toggled, this, &ReportView::refresh);
  // What was under way when the page was asked for is over.
  connect(
      &context_.work, &BackgroundWork::finished, this,
      [this] {
        if (waiting_ && isVisible()) refresh();
      },
      Qt::QueuedConnection);
  connect(refresh_, &QPushButton::clicked, this, &ReportView::refresh);
  connect(html_, &QPushButton::clicked, this, &ReportView::choose_html);
  connect(pdf_, &QPushButton::clicked, this, &ReportView::choose_pdf);
  keep_translated(this, [=, this] {
    title->setText(tr("Report"));
    name_->setText(tr("Show the patient's name"));
    name_->setToolTip(tr("Without it the page names neither the patient nor the case; see the settings too"));
    boards_->setText(tr("With what can be worn"));
    boards_->setToolTip(tr("Adds which wearable computers can do this case, as planned in Platform"));
    refresh_->setText(tr("Collect again"));
    refresh_->setToolTip(tr("Reads the case and the present rehearsal anew"));
    html_->setText(tr("Save as a web page..."));
    pdf_->setText(tr("Print to PDF..."));
    paper_->setAccessibleName(tr("Report"));
    update_text();
    if (page_ && page_->language != spoken_language().toStdString()) {
      stale_ = true;
      if (isVisible()) refresh();
    }
  });
}

Workspace ReportView::workspace(WorkspaceContext context, PlanOfNow plan) {
  auto* view = new ReportView(std::move(context), std::move(plan));
  return {.id = "report",
          .name = [] { return tr("Report"); },
          .about = [] { return tr("All that was done for this patient on one page."); },
          .widget = view,
          .place = Workspace::Place::whole_window,
          .show_patient = [view](const Patient& patient) { view->show_patient(patient); },
          .missing =
              [](const Patient& patient) {
                return patient.folder.empty() ? tr("Needs a case: open one, or the demo patient.") : QString();
              }};
}

void ReportView::show_patient(const Patient& patient) {
  if (patient.folder != patient_.folder) {
    page_.reset();
    document_.reset();
    paper_->setDocument(nullptr);
    const QSignalBlocker quiet(name_);
    name_->setChecked(names_shown_outside());
  }
  patient_ = patient;
  stale_ = true;
  update_text();
  if (isVisible()) refresh();
}

// The rehearsal goes on while this is hidden, so the page is collected each time that it is looked at.
void ReportView::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  refresh();
}

void ReportView::refresh() {
  waiting_ = context_.work.busy();
  if (patient_.folder.empty() || waiting_) {
    update_text();
    return;
  }
  report::PatientPageContent content;
  if (name_->isChecked()) content.name = patient_label(patient_.name).toStdString();
  content.when = QDateTime::currentDateTime().toString(Qt::ISODate).replace('T', ' ').left(16).toStdString();
  content.words = words_of_the_window();
  content.retraction = retraction_of(context_.rehearsal);
  if (boards_->isChecked()) content.plan = plan_();
  std::vector<Taken> taken;
  if (!patient_.structures.empty() && scratch_) taken = pictures();
  context_.work.start(
      tr("Collecting the report"),
      [this, content, taken, folder = patient_.folder](const Progress& progress) mutable -> BackgroundWork::Then {
        for (const Taken& each : taken) {
          if (each.image.save(text_of(each.figure.png))) content.figures.push_back(each.figure);
        }
        auto page = std::make_shared<Result<report::Page>>(casefile::Case::open(folder).and_then(
            [&](const casefile::Case& patient) { return report::patient_page(patient, content, progress); }));
        return [this, page] {
          if (!*page) return context_.tell_error(page->error());
          show_page(**page);
        };
      });
}

std::vector<ReportView::Taken> ReportView::pictures() {
  const auto cut = geometry::read_surface(patient_.folder / "results" / "resection" / "cut.vtp");
  if (cut) {
    const auto sheet = std::make_shared<geometry::Surface>(*cut);
    WorkspaceScene scene;
    scene.patient = WorkspaceScene::Patient::at_rest;
    scene.surfaces.push_back({"cut", sheet, specimen_colour(), 0.9, scene::Finish::solid, {}});
    scene.cuts.push_back({sheet, specimen_colour(), 2});
    context_.patient_views.set_workspace_scene(std::move(scene));
  }
  std::vector<Taken> taken;
  const auto keep = [&](RenderWidget& view, const QString& name, const QString& caption) {
    taken.push_back({view.smooth_picture(), {scratch_->path() / path_of(name), caption.toStdString()}});
  };
  keep(context_.views.space(), "space.png", cut ? tr("The planned cut.") : tr("The patient as shown in the window."));
  const std::array<QString, 3> slices{tr("Transverse"), tr("Coronal"), tr("Sagittal")};
  for (std::size_t k = 0; patient_.anatomy && k < slices.size(); ++k) {
    keep(context_.views.slice(static_cast<SliceDirection>(k)), QString("slice-%1.png").arg(k), slices[k]);
  }
  if (cut) context_.patient_views.set_workspace_scene({});
  return taken;
}

void ReportView::show_page(const report::Page& page) {
  page_ = page;
  stale_ = false;
  auto document = document_of(page);
  paper_->setDocument(document.get());
  document_ = std::move(document);
  update_text();
}

void ReportView::update_text() {
  const bool ready = page_.has_value();
  state_->setText(patient_.folder.empty() ? tr("Open a case, or the demo patient, to see its page.")
                  : !ready                ? tr("The page is being collected.")
                  : stale_                ? tr("Something has changed since this page was collected.")
                                          : tr("Collected from the case and from what is being rehearsed now."));
  refresh_->setEnabled(!patient_.folder.empty());
  for (QPushButton* each : {html_, pdf_}) {
    each->setEnabled(ready);
    each->setToolTip(ready ? QString() : tr("Needs a case: open one, or the demo patient."));
  }
}

Result<void> ReportView::save_html(const fs::path& file) const {
  GLISSON_ASSERT(page_.has_value());
  return report::write_html(file, *page_);
}

// Qt does not notice a full disk.
Result<void> ReportView::print_pdf(const fs::path& file) const {
  GLISSON_ASSERT(document_ != nullptr);
  return write_atomically(file, [this](const fs::path& beside) -> Result<void> {
    QPrinter printer(QPrinter::HighResolution);
    printer.setOutputFormat(QPrinter::PdfFormat);
    printer.setOutputFileName(text_of(beside));
    printer.setPageSize(QPageSize(QPageSize::A4));
    printer.setDocName(tr("Report"));
    document_->print(&printer);
    return {};
  });
}

void ReportView::choose_html() {
  const QString file = ask_where_to_save(this, tr("Save the report"), html_name, tr("Web pages (*.html)"));
  if (file.isEmpty()) return;
  if (auto written = save_html(path_of(file)); !written) {
    context_.tell_error(written.error());
  } else {
    context_.tell_status(tr("The report is in %1").arg(file));
  }
}

void ReportView::choose_pdf() {
  const QString file = ask_where_to_save(this, tr("Print the report"), pdf_name, tr("PDF (*.pdf)"));
  if (file.isEmpty()) return;
  if (auto written = print_pdf(path_of(file)); !written) {
    context_.tell_error(written.error());
  } else {
    context_.tell_status(tr("The report is in %1").arg(file));
  }
}

}  // namespace glisson::widgets

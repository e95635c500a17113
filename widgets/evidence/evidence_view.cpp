#include "widgets/evidence/evidence_view.h"

#include <algorithm>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QMessageBox>
#include <QVBoxLayout>

#include "base/files.h"
#include "casefile/evidence.h"
#include "report/explanation_folder.h"
#include "widgets/evidence/effect_words.h"
#include "widgets/panels/ask_path.h"
#include "widgets/panels/parts.h"
#include "widgets/report/page_words.h"
#include "widgets/session/load_patient.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/language.h"
#include "widgets/words/paths.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {
namespace {

namespace fs = std::filesystem;

// What a path that was chosen holds: the folder of a report, or an experiment.
std::optional<fs::path> report_folder(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return path;
  const fs::path name = path.filename();
  if (name == "report.json" || name == "report.html" || name == "model.json") return path.parent_path();
  return {};
}

}  // namespace

EvidenceView::EvidenceView(WorkspaceContext context, QWidget* parent) : QWidget(parent), context_(std::move(context)) {
  setObjectName("evidence_view");
  auto* across = new QHBoxLayout(this);
  across->setContentsMargins(0, 0, 0, 0);
  across->setSpacing(0);
  across->addWidget(make_panel());
  right_ = new QStackedWidget(this);
  right_->addWidget(make_beginning());
  answer_ = new EvidenceAnswer(this);
  right_->addWidget(answer_);
  across->addWidget(right_, 1);
  connect(&answer_->found(), &FoundTree::ticked, this, &EvidenceView::update_text);
  connect(&context_.work, &BackgroundWork::progressed, this, [this](double fraction) { tell_time_left(fraction); });
  connect(&context_.work, &BackgroundWork::finished, this, [this] {
    explaining_ = false;
    time_left_->clear();
    update_text();
  });
  keep_translated(this, [this] {
    update_text();
    reword_page();
  });
}

Workspace EvidenceView::workspace(WorkspaceContext context) {
  auto* view = new EvidenceView(std::move(context));
  return {.id = "evidence",
          .name = [] { return tr("Evidence"); },
          .about = [] { return tr("Hold measurements against the model, and find what it lacks."); },
          .widget = view,
          .place = Workspace::Place::whole_window,
          .group = Workspace::Group::research,
          .show_patient = [view](const Patient& patient) { view->show_patient(patient); }};
}

QWidget* EvidenceView::make_panel() {
  auto* panel = new QWidget;
  panel->setObjectName("panel");
  panel->setFixedWidth(330);
  auto* column = new QVBoxLayout(panel);
  column->setContentsMargins(14, 14, 14, 14);
  column->setSpacing(8);
  QLabel* measurements_title = heading(panel);
  open_ = named_button("primary", panel);
  example_ = named_button("evidence_example", panel);
  open_report_ = named_button("evidence_open_report", panel);
  opened_ = wrapped_label("evidence_opened", panel);
  time_left_ = wrapped_label("evidence_time_left", panel);
  QLabel* use_title = heading(panel);
  accept_ = named_button("evidence_accept", panel);
  take_back_ = named_button("evidence_take_back", panel);
  accepted_ = wrapped_label("faint", panel);
  QLabel* others_title = heading(panel);
  compare_ = named_button("evidence_compare", panel);
  comparison_ = new QTableWidget(0, 3, panel);
  comparison_->setObjectName("evidence_comparison");
  comparison_->verticalHeader()->hide();
  comparison_->verticalHeader()->setDefaultSectionSize(24);
  comparison_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  comparison_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  comparison_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  comparison_->setSelectionMode(QAbstractItemView::NoSelection);
  comparison_->setShowGrid(false);
  comparison_->setAlternatingRowColors(true);
  comparison_->hide();
  save_ = named_button("evidence_save", panel);
  for (QWidget* each :
       std::initializer_list<QWidget*>{measurements_title, open_, example_, open_report_, opened_, time_left_}) {
    column->addWidget(each);
  }
  column->addSpacing(10);
  for (QWidget* each : std::initializer_list<QWidget*>{use_title, accept_, take_back_, accepted_})
    column->addWidget(each);
  column->addSpacing(10);
  for (QWidget* each : std::initializer_list<QWidget*>{others_title, compare_, comparison_}) column->addWidget(each);
  column->addStretch(1);
  column->addWidget(save_);
  connect(open_, &QPushButton::clicked, this, &EvidenceView::choose_experiment);
  connect(example_, &QPushButton::clicked, this, &EvidenceView::open_example);
  connect(open_report_, &QPushButton::clicked, this, &EvidenceView::choose_report);
  connect(accept_, &QPushButton::clicked, this, &EvidenceView::accept);
  connect(take_back_, &QPushButton::clicked, this, &EvidenceView::take_back);
  connect(compare_, &QPushButton::clicked, this, &EvidenceView::choose_trials);
  connect(save_, &QPushButton::clicked, this, &EvidenceView::save_report);
  keep_translated(panel, [=, this] {
    measurements_title->setText(tr("Measurements"));
    open_->setText(tr("Open an experiment..."));
    open_->setToolTip(tr("A file that says what was measured and which model was assumed (Help, Closing the loop)"));
    example_->setText(tr("Try the example"));
    example_->setToolTip(
        tr("A sample of tissue, compressed: simulated, and it does something that its file does not declare"));
    open_report_->setText(tr("Open a report..."));
    open_report_->setToolTip(tr("A folder with report.json and model.json, written here or by glisson-cli explain"));
    use_title->setText(tr("For the patient"));
    accept_->setText(tr("Accept for this patient"));
    take_back_->setText(tr("Take back"));
    others_title->setText(tr("Other trials"));
    compare_->setText(tr("Predict other trials..."));
    compare_->setToolTip(tr("An experiment of the same kind; where it was measured, both models are compared with it"));
    save_->setText(tr("Save the report..."));
  });
  return panel;
}

QWidget* EvidenceView::make_beginning() {
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  beginning_ = new QLabel(page);
  beginning_->setWordWrap(true);
  beginning_->setAlignment(Qt::AlignCenter);
  beginning_->setObjectName("faint");
  column->addStretch(2);
  column->addWidget(beginning_);
  column->addStretch(3);
  keep_translated(page, [this] {
    beginning_->setText(tr(
        "Open measurements of a palpation, a material test, a plate in full field, waves of an elastography, a guided "
        "sequence or a wearable computer.\n"
        "Glisson says how far the declared model is off, what it lacks, and how sure that is.\n\n"
        "No measurements at hand? Try the example: a simulated sample of tissue that does something undeclared."));
  });
  return page;
}

void EvidenceView::open(const fs::path& path) {
  if (const auto folder = report_folder(path)) {
    show_report(*folder, nullptr);
  } else {
    explain(path);
  }
}

void EvidenceView::open_example() {
  const auto resources = resource_folder();
  if (!resources) return context_.tell_error(resources.error());
  explain(*resources / "examples" / "tissue" / "experiment.json");
}

void EvidenceView::explain(const fs::path& experiment) {
  if (!scratch_) return context_.tell_error(scratch_.error());
  const fs::path to = scratch_->path() / std::to_string(++made_here_);
  const bool begun = context_.work.start(tr("Explaining %1").arg(text_of(experiment.filename())),
                                         [this, experiment, to](const Progress& progress) -> BackgroundWork::Then {
                                           QString language;
                                           auto explained = closedloop::explain(experiment, progress);
                                           Result<void> written;
                                           std::shared_ptr<const closedloop::Explained> shared;
                                           if (explained) {
                                             shared = std::make_shared<closedloop::Explained>(*std::move(explained));
                                             language = spoken_language();
                                             written = report::write_explanation(to, *shared, words_of_the_window());
                                           } else {
                                             written = failure(std::move(explained.error()));
                                           }
                                           return [this, to, shared, written, language] {
                                             if (!written) return context_.tell_error(written.error());
                                             page_language_ = language;
                                             show_report(to, shared);
                                           };
                                         });
  if (!begun) return;
  explaining_ = true;
  since_.start();
  update_text();
}

void EvidenceView::show_report(const fs::path& folder, std::shared_ptr<const closedloop::Explained> explained) {
  auto read = read_evidence(folder);
  if (!read) return context_.tell_error(read.error());
  record_ = std::make_shared<EvidenceRecord>(*std::move(read));
  explained_ = explained;
  right_->setCurrentWidget(answer_);
  answer_->show_record(record_, std::move(explained));
  comparison_->hide();
  weigh();
  update_text();
  reword_page();
}

void EvidenceView::reword_page() {
  if (!explained_ || page_language_ == spoken_language()) return;
  page_language_ = spoken_language();
  if (auto written = report::write_explanation(record_->folder, *explained_, words_of_the_window()); !written) {
    return context_.tell_error(written.error());
  }
  auto read = read_evidence(record_->folder);
  if (!read) return context_.tell_error(read.error());
  record_ = std::make_shared<EvidenceRecord>(*std::move(read));
  answer_->reword(record_);
}

void EvidenceView::show_patient(const Patient& patient) {
  patient_ = patient;
  weigh();
  update_text();
}

void EvidenceView::weigh() {
  weighed_.reset();
  if (!record_ || !patient_.rehearsal_setup || record_->experiment_kind == "platform" ||
      record_->experiment_kind == "full-field" || record_->experiment_kind == "elastography")
    return;
  const rehearsal::RehearsalSetup& setup = *patient_.rehearsal_setup;
  closedloop::OrganModel organ;
  organ.youngs_kPa = setup.patient_youngs_kPa;
  organ.supports = setup.supports;
  auto learnt = closedloop::learn_organ(std::move(organ), setup.mesh, record_->folder / "model.json");
  if (learnt) weighed_ = *std::move(learnt);
}

QString EvidenceView::why_not_accept() const {
  if (!record_) return tr("Open measurements first.");
  if (record_->effects.empty()) return tr("Nothing was found missing that could be accepted.");
  if (record_->experiment_kind == "platform") return tr("What was found is of a computer, not of a patient.");
  if (record_->experiment_kind == "full-field") return tr("What was found is of a plate, not of a patient.");
  if (record_->experiment_kind == "elastography") return tr("What was found is of waves, not of how an organ is held.");
  if (patient_.folder.empty()) return tr("Open the patient's case first.");
  if (const QString missing = model_missing(patient_); !missing.isEmpty()) return missing;
  if (weighed_) {
    const auto& effects = weighed_->effects;
    if (std::none_of(effects.begin(), effects.end(), [](const auto& effect) { return effect.carried; })) {
      return tr("What was found would change nothing in the rehearsal: %1").arg(translated(effects.front().sentence));
    }
    if (!casefile::is_of_patient(weighed_->specimen, patient_.folder.stem().string())) {
      return tr("This was measured on \"%1\", and nothing shows that it is tissue of %2.")
          .arg(QString::fromStdString(weighed_->specimen.title), patient_label(patient_.name));
    }
  }
  if (answer_->found().ticked_kinds().empty()) return tr("Tick an effect among what was found.");
  return {};
}

void EvidenceView::update_text() {
  const bool busy = explaining_;
  if (weighed_) answer_->found().show_consequences(weighed_->effects);
  for (QPushButton* each : {open_, example_, open_report_}) each->setEnabled(!busy);
  opened_->setText(record_ ? tr("%1, learnt from %2")
                                 .arg(record_->experiment_kind == "palpation"      ? tr("A palpation")
                                      : record_->experiment_kind == "material"     ? tr("A material test")
                                      : record_->experiment_kind == "guidance"     ? tr("A guided sequence")
                                      : record_->experiment_kind == "full-field"   ? tr("A plate in full field")
                                      : record_->experiment_kind == "elastography" ? tr("Waves of an elastography")
                                                                                   : tr("A wearable computer"),
                                      QString::fromStdString(record_->learnt_from))
                           : tr("Nothing is open."));
  const QString why_not = why_not_accept();
  accept_->setEnabled(why_not.isEmpty() && !busy);
  accept_->setToolTip(why_not.isEmpty() ? tr("The ticked effects change the organ that is rehearsed") : why_not);
  const auto& effects = patient_.evidence.effects;
  take_back_->setEnabled(!effects.empty() && !busy);
  take_back_->setToolTip(effects.empty() ? tr("Nothing was accepted for this patient.")
                                         : tr("The organ is again what it was before"));
  QStringList lines;
  if (!why_not.isEmpty()) lines << why_not;
  for (const closedloop::LearntEffect& effect : effects) {
    lines << (effect.carried ? tr("Accepted: %1") : tr("Accepted, but left out: %1")).arg(translated(effect.sentence));
  }
  accepted_->setText(lines.join("\n"));
  compare_->setEnabled(record_ != nullptr && !busy);
  save_->setEnabled(record_ != nullptr && !busy);
  for (QPushButton* each : {compare_, save_}) {
    if (!record_) each->setToolTip(tr("Open measurements first."));
  }
}

// A search does not know beforehand how far it must go, so this is a rough estimate and says so.
void EvidenceView::tell_time_left(double fraction) {
  constexpr double worth_telling = 0.03;
  if (!explaining_ || fraction < worth_telling) return;
  const double left_s = 1e-3 * static_cast<double>(since_.elapsed()) * (1 - fraction) / fraction;
  time_left_->setText(left_s < 90 ? tr("About %1 s left").arg(left_s, 0, 'f', 0)
                                  : tr("About %1 min left").arg(left_s / 60, 0, 'f', 0));
}

void EvidenceView::accept() {
  if (!why_not_accept().isEmpty() || !weighed_) return;
  QStringList what;
  for (const closedloop::LearntEffect& effect : weighed_->effects) {
    const auto kinds = answer_->found().ticked_kinds();
    if (std::find(kinds.begin(), kinds.end(), effect.kind) != kinds.end()) what << "- " + translated(effect.sentence);
  }
  QMessageBox question(
      QMessageBox::Question, tr("Accept for this patient?"),
      tr("Specimen: %1\nPatient: %2\n\nThe organ that is rehearsed changes:\n%3")
          .arg(QString::fromStdString(weighed_->specimen.title), patient_label(patient_.name), what.join("\n")),
      QMessageBox::Cancel, this);
  question.setObjectName("accept_question");
  QPushButton* go = question.addButton(tr("Accept"), QMessageBox::AcceptRole);
  go->setObjectName("accept_go");
  question.setDefaultButton(QMessageBox::Cancel);
  question.exec();
  if (question.clickedButton() != go) return;
  context_.change(tr("Accepting the evidence"),
                  [folder = patient_.folder, model = record_->folder / "model.json",
                   kinds = answer_->found().ticked_kinds()](const Progress& progress) -> Result<Patient> {
                    auto patient = casefile::Case::open(folder);
                    if (!patient) return failure(patient.error());
                    auto accepted = casefile::accept_evidence(*patient, model, kinds);
                    if (!accepted) return failure(std::move(accepted.error()));
                    return load_patient(folder, progress);
                  });
}

void EvidenceView::take_back() {
  context_.change(tr("Taking the evidence back"),
                  [folder = patient_.folder](const Progress& progress) -> Result<Patient> {
                    auto patient = casefile::Case::open(folder);
                    if (!patient) return failure(patient.error());
                    auto left = casefile::take_back_evidence(*patient);
                    if (!left) return failure(std::move(left.error()));
                    return load_patient(folder, progress);
                  });
}

void EvidenceView::compare_trials(const fs::path& experiment) {
  if (!record_) return;
  context_.work.start(
      tr("Predicting the trials of %1").arg(text_of(experiment.filename())),
      [this, experiment, model = record_->folder / "model.json"](const Progress& progress) -> BackgroundWork::Then {
        auto declared = closedloop::predict(experiment, {}, progress.part(0, 0.5));
        auto better = declared ? closedloop::predict(experiment, model, progress.part(0.5, 1))
                               : Result<closedloop::Prediction>(tl::unexpected(declared.error()));
        return [this, declared = std::move(declared), better = std::move(better)] {
          if (!better) return context_.tell_error(better.error());
          show_comparison(*declared, *better);
        };
      });
}

void EvidenceView::show_comparison(const closedloop::Prediction& declared, const closedloop::Prediction& better) {
  const auto figure = [](const std::optional<closedloop::ErrorFigures>& error) {
    return error ? QLocale().toString(error->rms, 'g', 3) : tr("not measured");
  };
  comparison_->setHorizontalHeaderLabels({tr("Trial"), tr("Declared"), tr("Better")});
  for (const int column : {1, 2}) {
    comparison_->horizontalHeaderItem(column)->setToolTip(
        tr("Root mean square error, %1").arg(QString::fromStdString(declared.unit)));
  }
  comparison_->setRowCount(static_cast<int>(declared.trials.size()));
  for (std::size_t k = 0; k < declared.trials.size(); ++k) {
    const auto row = static_cast<int>(k);
    comparison_->setItem(row, 0, new QTableWidgetItem(QString::fromStdString(declared.trials[k].id)));
    const std::array<QString, 2> texts{figure(declared.trials[k].error), figure(better.trials[k].error)};
    for (std::size_t side = 0; side < 2; ++side) {
      auto* cell = new QTableWidgetItem(texts[side]);
      cell->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      comparison_->setItem(row, static_cast<int>(side) + 1, cell);
    }
  }
  constexpr int maximum_rows = 10;
  comparison_->setFixedHeight(comparison_->horizontalHeader()->sizeHint().height() +
                              24 * std::min(maximum_rows, comparison_->rowCount()) + 4);
  comparison_->show();
}

void EvidenceView::choose_experiment() {
  const QString file = ask_for_file(this, tr("Open an experiment"), tr("Experiments (*.json)"));
  if (!file.isEmpty()) open(path_of(file));
}

void EvidenceView::choose_report() {
  const QString folder = ask_for_folder(this, tr("Open a report (a folder with report.json)"));
  if (!folder.isEmpty()) open(path_of(folder));
}

void EvidenceView::choose_trials() {
  const QString file = ask_for_file(this, tr("Predict other trials"), tr("Experiments (*.json)"));
  if (!file.isEmpty()) compare_trials(path_of(file));
}

void EvidenceView::save_report() {
  const QString chosen = ask_for_folder(this, tr("Save the report in this folder"));
  if (chosen.isEmpty() || !record_) return;
  for (const char* name : {"report.json", "report.html", "model.json", "next_trials.json", "residual_before.nrrd",
                           "residual_after.nrrd"}) {
    std::error_code ignored;
    if (!fs::exists(record_->folder / name, ignored)) continue;
    const auto bytes = read_text_file(record_->folder / name, std::uint64_t{64} << 20);
    if (!bytes) return context_.tell_error(bytes.error());
    if (auto written = write_text_file(path_of(chosen) / name, *bytes); !written) {
      return context_.tell_error(written.error());
    }
  }
  context_.tell_status(tr("The report is in %1").arg(chosen));
}

}  // namespace glisson::widgets

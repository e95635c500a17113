// The patient in the window: opened, shown, changed, closed, and found again after a fall.

#include <algorithm>
#include <QTimer>

#include "base/result.h"
#include "widgets/main_window.h"
#include "widgets/session/load_patient.h"
#include "widgets/session/placed_landmarks.h"
#include "widgets/settings/settings.h"
#include "widgets/study/study_page.h"
#include "widgets/views/wave_view.h"
#include "widgets/words/paths.h"
#include "widgets/words/translated.h"
#include "widgets/work/give_back_memory.h"

namespace glisson::widgets {
namespace {

namespace fs = std::filesystem;

// The demo patient has its name however it was opened, and whatever was done to it.
Patient named(Patient patient) {
  if (patient.folder == own_folder() / "demo" / "demo.glisson") patient.name = demo_patient_name;
  return patient;
}

}  // namespace

void MainWindow::open_path(const fs::path& opened) {
  // A file manager hands over the file that stands for the case.
  const fs::path path = opened.filename() == "case.json" ? opened.parent_path() : opened;
  if (kind_of(path) == OpenedThing::case_folder) {
    load(tr("Opening %1").arg(text_of(path.filename())), [path](const Progress& progress, const FirstLook& first_look) {
      return load_patient(path, progress, first_look);
    });
    return;
  }
  go_to("study");
  study_page_->browse(path);
}

void MainWindow::open_demo_then(std::function<void()> once_shown) {
  const fs::path folder = own_folder() / "demo";
  load(
      tr("Opening the demo patient"),
      [folder](const Progress& progress, const FirstLook& first_look) -> Result<Patient> {
        std::error_code problem;
        fs::create_directories(folder, problem);
        return load_demo(folder, progress, first_look);
      },
      std::move(once_shown));
}

void MainWindow::load(const QString& title, Loader loader, std::function<void()> once_shown) {
  if (patient_.preparing && work_.busy()) {  // a model that nobody will use: what is asked for now comes instead
    constexpr auto once_later = static_cast<Qt::ConnectionType>(Qt::QueuedConnection | Qt::SingleShotConnection);
    connect(
        &work_, &BackgroundWork::finished, this,
        [this, title, loader = std::move(loader), once_shown = std::move(once_shown)] {
          load(title, loader, once_shown);
        },
        once_later);
    work_.cancel();
    return;
  }
  work_.start(title, [this, loader = std::move(loader), once_shown = std::move(once_shown)](const Progress& progress) {
    const FirstLook first_look = [this](const Patient& patient) {
      QMetaObject::invokeMethod(
          this, [this, patient] { show_patient(named(patient)); }, Qt::QueuedConnection);
    };
    auto patient = std::make_shared<Result<Patient>>(loader(progress, first_look));
    return BackgroundWork::Then([this, patient, once_shown] {
      if (!*patient) {
        if (patient_.preparing) {  // shown, and its model will not come
          Patient without_model = patient_;
          without_model.preparing = false;
          show_patient(without_model);
        }
        show_error(patient->error());
        return;
      }
      show_patient(named(**patient));
      if (once_shown) once_shown();
    });
  });
}

void MainWindow::show_patient(const Patient& patient) {
  if (patient.folder != patient_.folder || patient.name != patient_.name) measure_->clear();
  const bool same_case = !patient.folder.empty() && patient.folder == patient_.folder;
  patient_ = patient;
  welcome_->hide();
  viewing_->show();
  notices_->close_notice();
  notices_->show_origin(patient.origin);
  if (!patient.remarks.empty()) {
    notices_->note([remarks = patient.remarks] {
      QStringList sentences;
      for (const Sentence& remark : remarks) sentences << translated(remark);
      return sentences.join(" ");
    });
  }
  hold_.take(patient.folder);
  study_panel_->show_patient(patient);
  view_bar_->show_patient(patient);
  patient_views_->show_patient(patient);
  landmarks_ = kept_landmarks(patient.folder);
  rehearse_panel_->show_placed_landmarks(landmarks_);
  if (same_case) {
    rehearsal_.exchange_body(patient.rehearsal, patient.rehearsal_setup);
  } else {
    rehearsal_.set_body(patient.rehearsal, patient.rehearsal_setup);
  }
  rehearsal_undo_.begin();
  undo_.refuse(hold_.refusal());
  undo_.open_case(hold_.refusal() ? fs::path() : patient.folder);
  for (const Workspace& workspace : workspaces_) workspace.show_patient(patient);
  bar_->show_patient(patient);
  allow_for_case();
  next_step_->show_case(patient.folder);
  update_patient_text();
  if (!patient.folder.empty()) remember_case(patient.folder);
  keep_open_work();
  diary_.note("A patient is shown.");
}

// What of the menu has something to do.
void MainWindow::allow_for_case() {
  const bool has_case = !patient_.folder.empty();
  save_picture_->setEnabled(!viewing_->isHidden());
  show_waves_->setEnabled(has_case && WaveView::has_waves(patient_.folder));
  add_labels_->setEnabled(has_case);
  export_->setEnabled(has_case);
  close_case_->setEnabled(has_case);
}

void MainWindow::update_patient_text() {
  setWindowTitle(patient_.name.empty() ? tr("Glisson") : tr("%1 - Glisson").arg(patient_label(patient_.name)));
}

void MainWindow::change(const QString& title, std::function<Result<Patient>(const Progress&)> loader,
                        std::function<void()> once_shown) {
  if (!may_change()) return;
  last_change_ = title;  // it may have to wait for other work to give up
  auto change_recorded = [this, name = Sentence{title.toStdString(), {}}, loader = std::move(loader)](
                             const Progress& progress, const FirstLook& /*first_look*/) {
    Result<Patient> patient = failure("cancelled", {});
    undo_.wait();  // what was drawn before belongs to what is worked on now
    const auto recorded = undo_.recorded(name, [&]() -> Result<void> {
      patient = loader(progress);
      return patient ? Result<void>() : failure(patient.error());
    });
    if (patient && !recorded) patient->remarks.push_back({recorded.error().message(), {}});
    return patient;
  };
  load(title, std::move(change_recorded), std::move(once_shown));
}

bool MainWindow::may_change() {
  if (hold_.refusal()) show_error(*hold_.refusal());
  return !hold_.refusal();
}

// Undone or done again. What a workspace shows of its own it reads itself; the patient is read anew.
void MainWindow::show_moved_entries(const QStringList& ids) {
  const bool outlines_alone =
      std::all_of(ids.begin(), ids.end(), [](const QString& id) { return id.startsWith("labels/"); });
  if (outlines_alone && workspace() == "segment") return;
  // Nothing of the patient that is shown rests on them; Resect reads its list anew.
  const bool plans_alone = std::all_of(
      ids.begin(), ids.end(), [](const QString& id) { return id.startsWith("plans/") || id.startsWith("results/"); });
  if (plans_alone) return;
  const bool landmarks_alone =
      std::all_of(ids.begin(), ids.end(), [](const QString& id) { return id.startsWith("landmarks/"); });
  load(tr("Opening %1").arg(text_of(patient_.folder.filename())), [patient = patient_, shown = landmarks_,
                                                                   landmarks_alone](const Progress& progress,
                                                                                    const FirstLook& /*first_look*/) {
    return landmarks_alone ? with_kept_landmarks(patient, shown, progress) : load_patient(patient.folder, progress);
  });
}

void MainWindow::keep_landmarks(const QString& what, const std::vector<mechanics::Landmark>& landmarks) {
  if (patient_.folder.empty() || patient_.preparing) return;
  change(what, [patient = patient_, shown = landmarks_, landmarks](const Progress& progress) {
    return with_landmarks(patient, shown, landmarks, progress);
  });
}

void MainWindow::take_next_step(NextStep step) {
  const fs::path folder = patient_.folder;
  if (step == NextStep::outline_liver) {
    change(tr("Outlining the liver"), [folder, inside_mm = views_->crosshair_mm()](const Progress& progress) {
      return outline_liver(folder, inside_mm, progress);
    });
  } else {
    change(
        tr("Building the model"), [folder](const Progress& progress) { return build_model(folder, progress); },
        [this] { go_to("rehearse"); });
  }
}

void MainWindow::close_case() {
  if (work_.busy()) {
    notices_->note([] { return tr("Something else is still under way. Wait for it, or cancel it first."); });
    return;
  }
  show_patient({});
  viewing_->hide();
  welcome_->show();
  allow_for_case();
  open_work_.forget();
  constexpr int until_threads_let_go_ms = 1000;
  QTimer::singleShot(until_threads_let_go_ms, this, give_back_memory);
  diary_.note("The case is closed.");
}

void MainWindow::offer_lost_work() {
  lost_work_ = open_work_.take_lost();
  if (lost_work_) welcome_->offer_lost(lost_work_->case_folder);
}

void MainWindow::open_lost_work() {
  const OpenWork work = *lost_work_;
  load(
      tr("Opening %1").arg(text_of(work.case_folder.filename())),
      [folder = work.case_folder](const Progress& progress, const FirstLook& first_look) {
        return load_patient(folder, progress, first_look);
      },
      [this, work] {
        for (const Workspace& workspace : workspaces_) {
          if (workspace.id.toStdString() == work.workspace) go_to(workspace.id);
        }
        if (work.tool && patient_.rehearsal) {
          rehearse_panel_->hold_again({.preset = {},
                                       .center_mm = work.tool->center_mm,
                                       .outward = -work.tool->direction,
                                       .radius_mm = work.tool->radius_mm,
                                       .direction = work.tool->direction,
                                       .force_N = work.tool->force_N});
        }
      });
}

void MainWindow::keep_open_work() {
  if (patient_.folder.empty()) return;
  OpenWork work{.case_folder = patient_.folder, .workspace = workspace().toStdString(), .tool = {}};
  if (rehearsal_.has_tool()) {
    const PlacedTool& tool = rehearsal_.tools().back();
    work.tool = {tool.center_mm, tool.radius_mm, tool.force_N, tool.direction};
  }
  if (const auto kept = open_work_.keep(work); !kept) diary_.note(kept.error());
}

}  // namespace glisson::widgets

#pragma once
// A workspace is one stop of the work, left to right: Study, Segment, Model, Rehearse, Resect, Report, Guide; then, in
// a group of their own, those of research: Register, Platform, Evidence, Studies. Any widget can be one; it says by
// showEvent() and hideEvent() when it is at work.

#include <functional>
#include <QString>
#include <QWidget>

#include "widgets/session/live_rehearsal.h"
#include "widgets/session/patient.h"
#include "widgets/session/undo.h"
#include "widgets/views/patient_views.h"
#include "widgets/work/background_work.h"

namespace glisson::widgets {

struct Workspace {
  enum class Place { beside_views, whole_window };
  enum class Group { surgery, research };

  QString id;                      // "rehearse": for code, never seen
  std::function<QString()> name;   // in the language of now
  std::function<QString()> about;  // one sentence: what is done here
  QWidget* widget = nullptr;
  Place place = Place::beside_views;
  Group group = Group::surgery;
  // A patient was opened, or what is known of this one has changed.
  std::function<void(const Patient&)> show_patient = [](const Patient&) {};
  // What it needs before anything can be done here, and how to get it; empty when it is ready.
  std::function<QString(const Patient&)> missing = [](const Patient&) { return QString(); };
};

// For Workspace::missing: what needs a model of the liver says this until there is one.
[[nodiscard]] QString model_missing(const Patient& patient);

// What workspaces share; the window owns it and outlives them.
struct WorkspaceContext {
  BackgroundWork& work;
  LinkedViews& views;
  PatientViews& patient_views;
  LiveRehearsal& rehearsal;
  Undo& undo;
  std::function<const Patient&()> patient;
  // Changes the case on a worker thread and shows the patient that comes of it, or says what went wrong. What it did
  // to the case is one step of undo, under its title.
  std::function<void(const QString& title, std::function<Result<Patient>(const Progress&)>)> change;
  // The same for another case than the open one: no step of undo.
  std::function<void(const QString& title, std::function<Result<Patient>(const Progress&)>)> open;
  // Whether what is written into the case's folder may be; says why not.
  std::function<bool()> may_change;
  std::function<void(const Error&)> tell_error;
  std::function<void(const QString&)> tell_status;
  std::function<void(const QString& workspace_id)> go_to;
  // In the list on the left, with their volumes: these in the place of the patient's, or the patient's own again.
  std::function<void(const std::optional<std::vector<PatientStructure>>&)> list_structures;
};

}  // namespace glisson::widgets

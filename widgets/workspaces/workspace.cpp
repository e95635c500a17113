#include "widgets/workspaces/workspace.h"

#include <QCoreApplication>

namespace glisson::widgets {

QString model_missing(const Patient& patient) {
  if (patient.rehearsal) return {};
  return patient.preparing ? QCoreApplication::translate("Workspace", "The model is being prepared.")
                           : QCoreApplication::translate("Workspace", "Needs a model of the liver: build it first.");
}

}  // namespace glisson::widgets

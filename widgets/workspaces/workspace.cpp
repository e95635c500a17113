#include "workspaces/workspace.h"

#include <QCoreApplication>

namespace glisson::widgets {

QString model_missing(const Patient& patient) {
  return patient.rehearsal ? QString()
                           : QCoreApplication::translate("Workspace", "Needs a model of the liver: build it first.");
}

}  // namespace glisson::widgets

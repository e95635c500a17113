#pragma once
// Takes series of a study into a case. What the files do not say is asked: the names of labels. Images of another
// patient, or another anatomy, may come into a case that holds one. Before they do, that is said and asked too.

#include <filesystem>
#include <QObject>
#include <vector>

#include "casefile/belonging.h"
#include "imaging/study.h"
#include "widgets/workspaces/workspace.h"

namespace glisson::widgets {

class TakingIn : public QObject {
  Q_OBJECT

 public:
  TakingIn(const WorkspaceContext& context, QWidget* parent);

  // Into the case in that folder, which is made where there is none.
  void take(const imaging::Study& study, std::vector<casefile::SeriesRole> roles, const std::filesystem::path& folder);

 Q_SIGNALS:
  void begun(const std::filesystem::path& folder);  // all was answered, and the import runs

 private:
  struct Asked;
  void ask(Asked asked);

  WorkspaceContext context_;
  QWidget* window_;
};

}  // namespace glisson::widgets

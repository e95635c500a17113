#pragma once
// File, Export: what of the open case goes to other programs, a line each. The files are written by a worker; where
// they are stands in the status line.

#include <QMenu>

#include "casefile/export.h"
#include "widgets/workspaces/workspace.h"

namespace glisson::widgets {

class ExportMenu : public QMenu {
  Q_OBJECT

 public:
  ExportMenu(const WorkspaceContext& context, QWidget* parent);

  // Without a question, for who knows where to.
  void write(casefile::ExportFormat format, const std::filesystem::path& out,
             const casefile::SegmentationExport& with = {});

 private:
  void ask(casefile::ExportFormat format, const casefile::SegmentationExport& with = {});
  void list_plans();
  void update_text();

  WorkspaceContext context_;
  std::vector<std::pair<QAction*, casefile::ExportFormat>> formats_;
  QMenu* with_plan_;  // the plans of the case, each exported with the outlines and segments
};

}  // namespace glisson::widgets

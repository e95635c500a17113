#pragma once
// The Study workspace. It has the images found under a folder, what each series is for, and the case that is made of
// them. Beside it stands what the open case holds. Patients' names are neither shown nor kept.

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "widgets/study/case_overview.h"
#include "widgets/study/series_table.h"
#include "widgets/study/taking_in.h"

namespace glisson::widgets {

class StudyPage : public QWidget {
  Q_OBJECT

 public:
  static Workspace workspace(const WorkspaceContext& context);

  explicit StudyPage(const WorkspaceContext& context, QWidget* parent = nullptr);

  // Looks for images there, on a worker, and lists them.
  void browse(const std::filesystem::path& path);
  // Takes a label map or DICOM SEG straight into the open case.
  void add_labels(const std::filesystem::path& file);
  void show_patient(const Patient& patient);

 Q_SIGNALS:
  void listed();

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void update_text();
  void show_state();
  void choose_folder();
  void list(const std::filesystem::path& path, const imaging::Study& study);
  void look(const std::filesystem::path& path, const std::function<void(const imaging::Study&)>& then);

  WorkspaceContext context_;
  TakingIn* taking_in_;
  std::filesystem::path browsed_;
  std::filesystem::path case_;
  std::filesystem::path importing_into_;  // until the patient of it is shown
  QLabel* title_ = nullptr;
  QLabel* found_ = nullptr;
  QPushButton* open_ = nullptr;
  SeriesTable* series_ = nullptr;
  QLabel* privacy_ = nullptr;
  QLabel* keep_title_ = nullptr;
  QLineEdit* keep_as_ = nullptr;
  QPushButton* make_ = nullptr;
  QPushButton* add_ = nullptr;
  CaseOverview* overview_ = nullptr;
};

}  // namespace glisson::widgets

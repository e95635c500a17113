#pragma once
// The Studies workspace: the dissertation's studies over many patients or loads are started, watched, stopped and taken
// up again, and their pages opened. A folder that another program or a cluster fills is followed alike.

#include <filesystem>
#include <QComboBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>
#include <QWidget>

#include "widgets/studies/study_rows.h"
#include "widgets/studies/study_run.h"
#include "widgets/words/number_box.h"
#include "widgets/workspaces/workspace.h"

namespace glisson::widgets {

class StudiesPage : public QWidget {
  Q_OBJECT

 public:
  explicit StudiesPage(QWidget* parent = nullptr);
  [[nodiscard]] static Workspace workspace();

  // Where a study of one liver begins; without a folder there is no case.
  void show_case(const std::filesystem::path& folder);
  // Shows what comes into that folder, whoever computes it.
  void follow(const std::filesystem::path& folder);

  [[nodiscard]] const StudyRun& run() const { return run_; }

 private:
  QWidget* make_question();
  QWidget* make_answer();
  void choose_kind();
  void choose_input();
  void choose_results();
  void choose_followed();
  void start();
  void end(bool done, const QString& trouble);
  void look_again();
  void open_page();
  void update_text();

  StudyRun run_;
  QString case_folder_;
  QString input_;  // a folder that a person chose
  std::filesystem::path followed_;
  double fraction_ = 0;
  QString stage_;
  QString trouble_;
  enum class State { nothing, running, stopping, done, stopped, failed } state_ = State::nothing;
  QElapsedTimer since_;
  QTimer every_second_;

  QComboBox* kind_;
  QLabel* about_;
  QWidget* simulated_row_;
  NumberBox* simulated_;
  QWidget* input_row_;
  QLabel* input_name_;
  QLabel* input_text_;
  QPushButton* choose_input_;
  QPushButton* drop_input_;
  QLineEdit* results_;
  QPushButton* start_;
  QPushButton* stop_;
  QLabel* text_;
  QLabel* stage_text_;
  QProgressBar* progress_;
  StudyRows* rows_;
  QPushButton* open_page_;
};

}  // namespace glisson::widgets

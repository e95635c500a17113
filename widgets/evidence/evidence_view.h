#pragma once
// Evidence: measurements are held against a model, and what it lacks is traced to a cause. The cause can be accepted
// for the patient whose case is open, and taken back.

#include <memory>
#include <QElapsedTimer>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QTableWidget>
#include <QWidget>

#include "base/files.h"
#include "closedloop/predict.h"
#include "widgets/evidence/evidence_answer.h"
#include "widgets/workspaces/workspace.h"

namespace glisson::widgets {

class EvidenceView : public QWidget {
  Q_OBJECT

 public:
  explicit EvidenceView(WorkspaceContext context, QWidget* parent = nullptr);
  [[nodiscard]] static Workspace workspace(WorkspaceContext context);

  // An experiment is explained, a report's folder or one of its files is shown.
  void open(const std::filesystem::path& path);
  void open_example();
  void show_patient(const Patient& patient);
  // Other trials, by the declared model and by the better one.
  void compare_trials(const std::filesystem::path& experiment);

  [[nodiscard]] const std::shared_ptr<const EvidenceRecord>& record() const { return record_; }
  [[nodiscard]] EvidenceAnswer& answer() { return *answer_; }

 private:
  QWidget* make_panel();
  QWidget* make_beginning();
  void explain(const std::filesystem::path& experiment);
  void show_report(const std::filesystem::path& folder, std::shared_ptr<const closedloop::Explained> explained);
  // What was explained here puts its page into the window's language anew.
  void reword_page();
  void show_comparison(const closedloop::Prediction& declared, const closedloop::Prediction& better);
  // What the record would do to the patient's organ, and whether it is of this patient.
  void weigh();
  void accept();
  void take_back();
  void save_report();
  void choose_experiment();
  void choose_report();
  void choose_trials();
  void update_text();
  void tell_time_left(double fraction);
  // Why what was found cannot be accepted; empty where it can.
  [[nodiscard]] QString why_not_accept() const;

  WorkspaceContext context_;
  Patient patient_;
  std::shared_ptr<const EvidenceRecord> record_;
  std::shared_ptr<const closedloop::Explained> explained_;  // absent for a report that was opened
  QString page_language_;                                   // of what was explained here
  std::optional<closedloop::LearntOrgan> weighed_;  // absent without a patient's model, or where nothing was learnt
  const Result<TemporaryFolder> scratch_ = TemporaryFolder::make();  // reports made here until they are saved
  int made_here_ = 0;
  bool explaining_ = false;
  QElapsedTimer since_;
  QStackedWidget* right_;
  EvidenceAnswer* answer_;
  QLabel* beginning_;
  QLabel* opened_;
  QLabel* time_left_;
  QPushButton* open_;
  QPushButton* open_report_;
  QPushButton* example_;
  QPushButton* save_;
  QPushButton* accept_;
  QPushButton* take_back_;
  QLabel* accepted_;
  QPushButton* compare_;
  QTableWidget* comparison_;
};

}  // namespace glisson::widgets

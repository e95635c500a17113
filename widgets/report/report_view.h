#pragma once
// Report: one page of what was done for the patient who is open, to read, save and print. The name is withheld unless
// it is asked for.

#include <functional>
#include <memory>
#include <QCheckBox>
#include <QImage>
#include <QLabel>
#include <QPushButton>
#include <QTextBrowser>
#include <QTextDocument>
#include <QWidget>

#include "base/files.h"
#include "hardware/plan.h"
#include "report/page.h"
#include "widgets/workspaces/workspace.h"

namespace glisson::widgets {

class ReportView : public QWidget {
  Q_OBJECT

 public:
  // What was planned to be worn, where it was planned for this patient.
  using PlanOfNow = std::function<std::optional<hardware::Plan>()>;

  explicit ReportView(WorkspaceContext context, PlanOfNow plan, QWidget* parent = nullptr);
  [[nodiscard]] static Workspace workspace(WorkspaceContext context, PlanOfNow plan);

  void show_patient(const Patient& patient);
  // Collects everything anew, on a worker.
  void refresh();
  Result<void> save_html(const std::filesystem::path& file) const;
  Result<void> print_pdf(const std::filesystem::path& file) const;

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void show_page(const report::Page& page);
  void choose_html();
  void choose_pdf();
  void update_text();
  // What the views show, with the saved cut where there is one: in space, then the three slices.
  struct Taken {
    QImage image;
    report::Figure figure;  // its file is yet to be written
  };
  [[nodiscard]] std::vector<Taken> pictures();

  WorkspaceContext context_;
  PlanOfNow plan_;
  Patient patient_;
  const Result<TemporaryFolder> scratch_ = TemporaryFolder::make();  // the page's pictures
  std::optional<report::Page> page_;
  std::unique_ptr<QTextDocument> document_;
  bool stale_ = true;
  bool waiting_ = false;  // for other work to be over
  QTextBrowser* paper_;
  QLabel* state_;
  QCheckBox* name_;
  QCheckBox* boards_;
  QPushButton* refresh_;
  QPushButton* html_;
  QPushButton* pdf_;
};

}  // namespace glisson::widgets

#pragma once
// What is in the open case, what of it is stale and can be made anew on one click, and what is missing.

#include <filesystem>
#include <QLabel>
#include <QPushButton>
#include <QThreadPool>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "casefile/case.h"
#include "widgets/workspaces/workspace.h"

namespace glisson::widgets {

// One entry of a case with how it stands.
struct EntryState {
  casefile::Entry entry;
  casefile::Freshness freshness = casefile::Freshness::current;
};

class CaseOverview : public QWidget {
  Q_OBJECT

 public:
  explicit CaseOverview(const WorkspaceContext& context, QWidget* parent = nullptr);
  ~CaseOverview() override;

  // Reads the case on a worker (it compares contents) and lists it.
  void show_case(const std::filesystem::path& folder);
  [[nodiscard]] const std::vector<EntryState>& entries() const { return entries_; }
  // "labels/portal-vein" as a person reads it.
  [[nodiscard]] static QString entry_name(const std::string& id);
  // "mesh" as a person reads it.
  [[nodiscard]] static QString stage_name(const std::string& stage);

 private:
  void list();
  void list_missing();
  void add_step(const QString& words, const QString& button, const std::function<void()>& act, const char* name);
  void recompute();

  WorkspaceContext context_;
  std::filesystem::path folder_;
  std::vector<EntryState> entries_;
  QLabel* title_ = nullptr;
  QLabel* summary_ = nullptr;
  QTreeWidget* table_ = nullptr;
  QPushButton* recompute_ = nullptr;
  QLabel* missing_title_ = nullptr;
  QVBoxLayout* missing_ = nullptr;
  QThreadPool readers_;
  int turn_ = 0;
};

}  // namespace glisson::widgets

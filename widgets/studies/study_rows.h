#pragma once
// What a study's folder holds so far, as a table. It has a line a patient, in the order in which they come, whoever
// computes them. Where a study has no patients, it has the lines of its table in CSV once that is written.

#include <filesystem>
#include <QTableWidget>
#include <set>
#include <string>

namespace glisson::widgets {

class StudyRows : public QTableWidget {
  Q_OBJECT

 public:
  explicit StudyRows(QWidget* parent = nullptr);

  // Another folder, from its beginning.
  void follow(const std::filesystem::path& folder);
  // What has come since.
  void look_again();

  [[nodiscard]] int done() const { return static_cast<int>(read_.size()); }
  [[nodiscard]] int failed() const { return failed_; }

 private:
  void show_csv();
  int column(const QString& name);

  std::filesystem::path folder_;
  std::set<std::string> read_;  // those that did not fail: these do not change any more
  int failed_ = 0;
  std::filesystem::file_time_type csv_time_{};
};

}  // namespace glisson::widgets

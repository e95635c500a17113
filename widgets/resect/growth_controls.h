#pragma once
// The open case beside an earlier one of the same patient. A table and sentences say what each segment, and what a plan
// leaves, grew or shrank by in between.

#include <filesystem>
#include <memory>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QWidget>

#include "casefile/growth.h"
#include "widgets/resect/live_plan.h"
#include "widgets/words/number_box.h"

namespace glisson::widgets {

class GrowthControls : public QWidget {
  Q_OBJECT

 public:
  enum Column { part_column, before_column, now_column, change_column, stiffness_column };

  explicit GrowthControls(QWidget* parent = nullptr);

  // The later study. The same folder again: something of it may have changed.
  void show_case(const std::filesystem::path& folder);
  void offer(const std::vector<KeptPlanAnswer>& plans);
  // With that case as the earlier study.
  void compare_with(const std::filesystem::path& earlier);
  [[nodiscard]] const std::shared_ptr<const casefile::ComparedStudies>& result() const { return result_; }

 private:
  QWidget* make_fields();
  void ask();
  void compare();
  void show_result();
  void add_row(const QString& name, const planning::PartGrowth& part);

  std::filesystem::path folder_, earlier_;
  casefile::GrowthQuestion::Patients patients_ = casefile::GrowthQuestion::Patients::as_images_say;
  std::shared_ptr<const casefile::ComparedStudies> result_;
  std::optional<Error> problem_;
  int asked_ = 0;  // counts the questions, so that an answer to an older one is known when it arrives
  QPushButton* choose_;
  QLabel* chosen_;
  QWidget* fields_;
  QComboBox* plan_;  // the first: none
  NumberBox* days_;
  NumberBox* standard_;
  QPushButton* one_patient_;
  QTableWidget* table_;
  QLabel* text_;
};

}  // namespace glisson::widgets

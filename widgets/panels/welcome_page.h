#pragma once
// What the window shows before a patient is open: ways to begin, what was open before, and how far opening has come.

#include <filesystem>
#include <functional>
#include <optional>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <QWidget>

namespace glisson::widgets {

class WelcomePage : public QWidget {
  Q_OBJECT

 public:
  explicit WelcomePage(QWidget* parent = nullptr);

  void show_stage(const QString& words) { stage_->setText(words); }
  // A case that stood open when Glisson ended without saying so.
  void offer_lost(const std::filesystem::path& case_folder);

 Q_SIGNALS:
  void demo_wanted();
  void case_wanted();
  void images_wanted();
  void recent_wanted(const std::filesystem::path& case_folder);
  void lost_wanted();

 private:
  void list_recent();

  QPushButton* lost_;
  std::filesystem::path lost_case_;
  QWidget* recent_;
  QVBoxLayout* recent_column_;
  QLabel* recent_title_;
  QLabel* stage_;
};

}  // namespace glisson::widgets

#pragma once
// A walk through the workspaces on the demo patient: a card below the views with a few words, Back and Next. Each stop
// goes to its workspace and does there what its words say.

#include <functional>
#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <QString>
#include <vector>

namespace glisson::widgets {

struct TourStop {
  QString workspace;               // its id
  std::function<QString()> title;  // in the language of now
  std::function<QString()> words;
  std::function<void()> act = [] {};
};

class TourCard : public QFrame {
  Q_OBJECT

 public:
  explicit TourCard(QWidget* parent = nullptr);

  void start(std::vector<TourStop> stops);
  void end();
  [[nodiscard]] int stop() const { return stop_; }
  [[nodiscard]] int stops() const { return static_cast<int>(stops_.size()); }

 Q_SIGNALS:
  void arrived(const QString& workspace);  // before the stop acts
  void ended();

 private:
  void go(int stop);
  void update_text();

  std::vector<TourStop> stops_;
  int stop_ = 0;
  QLabel* title_;
  QLabel* words_;
  QLabel* where_;
  QPushButton* back_;
  QPushButton* next_;
};

}  // namespace glisson::widgets

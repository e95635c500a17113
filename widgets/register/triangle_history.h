#pragma once
// A chosen place over the frames. It shows how far each algorithm's registration is off there, and the two motions that
// SIRGn's correlation compares for one of them. With no place chosen, the whole registration over the frames: TRE and
// RMSE.

#include <array>
#include <optional>
#include <QLabel>
#include <QWidget>

#include "registration_quality/sirgn.h"
#include "widgets/words/number_box.h"

class QCustomPlot;
class QCPAxisRect;
class QCPItemStraightLine;

namespace glisson::widgets {

class TriangleHistory : public QWidget {
  Q_OBJECT

 public:
  explicit TriangleHistory(QWidget* parent = nullptr);

  struct Line {
    QString algorithm;
    registration_quality::TriangleCourse course;
  };
  // Of all of a registration, one value a frame; no RMSE without a model.
  struct Frames {
    QString algorithm;
    std::vector<double> tre_mm, rmse_mm;
  };
  // Drawn while no course is.
  void show_frames(const std::array<std::optional<Frames>, 2>& frames);
  // The first algorithm solid, the second dashed; the motions are those of the first that is there.
  void show_courses(const std::array<std::optional<Line>, 2>& lines, double tolerance_mm);
  void show_frame(int frame);
  // Of so many triangles of the first algorithm, the chosen one, counted from 0.
  void show_triangle(std::size_t count, std::optional<std::size_t> triangle);
  // What the lines come to, in words.
  void say(const QString& words) { said_->setText(words); }

  [[nodiscard]] int lines() const { return static_cast<int>(drawn_); }
  [[nodiscard]] std::vector<std::vector<double>> drawn_mm() const;  // a curve each, left and right in turn
  [[nodiscard]] double frame() const;

 Q_SIGNALS:
  void triangle_chosen(std::optional<std::size_t> triangle);

 private:
  QWidget* make_head();
  void update_text();
  void draw_triangle();
  void draw_frames();
  void set_ranges(double frames, double left_mm, double right_mm);

  NumberBox* triangle_;
  QLabel* said_;
  QCustomPlot* plot_;
  QCPAxisRect* errors_;
  QCPAxisRect* motions_;
  std::array<QCPItemStraightLine*, 2> now_;
  QCPItemStraightLine* tolerance_;
  std::size_t drawn_ = 0;
  double tolerance_mm_ = 5;
  std::array<std::optional<Line>, 2> shown_;
  std::array<std::optional<Frames>, 2> frames_;
};

}  // namespace glisson::widgets

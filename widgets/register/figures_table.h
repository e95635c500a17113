#pragma once
// What is known of one or two registrations of a video: the figures of the field beside SIRGn's.

#include <array>
#include <QTableWidget>

#include "widgets/register/judged_sequence.h"

namespace glisson::widgets {

class FiguresTable : public QTableWidget {
  Q_OBJECT

 public:
  enum Row { correlation, rejected, tre, tre_here, rmse, rmse_here, landmarks, triangles, time, row_count };

  explicit FiguresTable(QWidget* parent = nullptr);

  // A column each; a null pointer leaves its column empty.
  void show_figures(const std::array<const Judged*, 2>& judged, const std::array<QString, 2>& names,
                    double tolerance_mm, int frame);
};

}  // namespace glisson::widgets

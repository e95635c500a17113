#pragma once
// Outlines over a frame, as the window and the film show them, each on a dark rim. They are solid where they may be
// trusted at the surgeon's tolerance, dashed where not. Vessels are thinner where they lie deeper.

#include <QColor>
#include <QPainter>
#include <QSize>
#include <QString>
#include <QTransform>
#include <vector>

#include "guidance/overlay.h"

namespace glisson::widgets {

struct OverlayLook {
  bool shown = true;
  double opacity = 1;       // 0..1
  double tolerance_mm = 5;  // 90 % of the places lie within 2.5 standard deviations
};

// All that stands over one frame, with its words.
struct OverlayPicture {
  struct Line {
    guidance::PlacedOutline outline;
    QColor colour;
    QString label;  // beside it; empty for none
  };
  std::vector<Line> lines;  // later ones over earlier ones
  QString mistrust;         // beside what is dashed of the organ's own outline; empty for nothing
};

// How far 90 % of such places are off at most.
inline constexpr double ninety_percent_in_sd = 2.5;
[[nodiscard]] inline bool is_trusted(double sd_mm, double tolerance_mm) {
  return ninety_percent_in_sd * sd_mm <= tolerance_mm;
}

// `from_frame` takes pixels of the frame to the painter's.
void paint_overlay(QPainter& painter, const QTransform& from_frame, const OverlayPicture& picture,
                   const OverlayLook& look);

}  // namespace glisson::widgets

#pragma once
// Gives a plot the colours of the window, now and whenever the theme changes: page, axes, grid, ticks and legend.
// Curves keep what their owner gave them; curve_pen() offers pens that can be told apart without their colours.

#include <QPen>

class QCustomPlot;

namespace glisson::widgets {

void themed(QCustomPlot* plot);

// Pens of curve 0, 1, ...: colours that colour-blind people tell apart (Okabe and Ito 2008), and a dash of their own.
[[nodiscard]] QPen curve_pen(int curve);

}  // namespace glisson::widgets

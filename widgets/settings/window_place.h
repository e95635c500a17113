#pragma once
// Where the window was and how large, kept by QSettings from one run to the next. All of it, its frame included, is on
// the screen when it opens: the line at its bottom tells how long work goes on.

#include <QObject>
#include <QSize>

class QWidget;

namespace glisson::widgets {

class WindowPlace : public QObject {
 public:
  // Gives the window, not yet shown, its size and place: those kept, else this size, or the screen's where that is
  // less.
  WindowPlace(QWidget& window, const QSize& usual_size);

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void keep_on_screen();
  void keep() const;

  QWidget& window_;
  QSize given_;  // a size that somebody else gave stays
};

}  // namespace glisson::widgets

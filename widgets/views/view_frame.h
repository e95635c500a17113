#pragma once
// A view with its name, its few buttons, and a button that makes it fill the window and back.

#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace glisson::widgets {

class ViewFrame : public QFrame {
  Q_OBJECT

 public:
  // `accent` marks the view in the crosshairs of the others; an invalid colour for none.
  ViewFrame(const QColor& accent, QWidget* view, QWidget* parent = nullptr);

  void set_name(const QString& name);
  // A small button in the header, for a text.
  QToolButton* add_button();
  void show_maximised(bool maximised);

 Q_SIGNALS:
  void maximise_requested();
  void picture_requested();

 protected:
  void mouseDoubleClickEvent(QMouseEvent* event) override;

 private:
  QHBoxLayout* header_;
  QLabel* name_;
  bool maximised_ = false;
  QToolButton* picture_;
  QToolButton* maximise_;
};

}  // namespace glisson::widgets

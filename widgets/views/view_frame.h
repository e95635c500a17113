#pragma once
// A view with its name, its few buttons, and a button that makes it fill the window and back.

#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <vector>

namespace glisson::widgets {

class ViewFrame : public QFrame {
  Q_OBJECT

 public:
  // `accent` marks the view in the crosshairs of the others; an invalid colour for none.
  ViewFrame(const QColor& accent, QWidget* view, QWidget* parent = nullptr);

  void set_name(const QString& name);
  // A small button in the header, for a text. Where the view is too narrow for all of them, they stand in a menu.
  QToolButton* add_button();
  void show_maximised(bool maximised);

 Q_SIGNALS:
  void maximise_requested();
  void picture_requested();

 protected:
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fold_buttons();

  QHBoxLayout* header_;
  QLabel* name_;
  bool maximised_ = false;
  std::vector<QToolButton*> buttons_;
  QToolButton* more_;
  QToolButton* picture_;
  QToolButton* maximise_;
};

}  // namespace glisson::widgets

#include "widgets/panels/parts.h"

#include <QEvent>
#include <QScrollBar>

namespace glisson::widgets {
namespace {

template <class Widget>
Widget* named(const char* name, Widget* widget) {
  widget->setObjectName(name);
  return widget;
}

// As wide as what it holds, at least: sideways nothing scrolls, and nothing is cut off.
class UprightScrollArea : public QScrollArea {
 public:
  [[nodiscard]] QSize minimumSizeHint() const override {
    const int bar = verticalScrollBar()->sizeHint().width();
    return {widget()->minimumSizeHint().width() + bar, QScrollArea::minimumSizeHint().height()};
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (watched == widget() && event->type() == QEvent::LayoutRequest) updateGeometry();
    return QScrollArea::eventFilter(watched, event);
  }
};

}  // namespace

SidePanel lay_out_side_panel(QWidget* panel) {
  panel->setObjectName("panel");
  auto* column = new QVBoxLayout(panel);
  column->setContentsMargins(14, 14, 4, 14);
  column->setSpacing(8);
  SidePanel made{heading(panel), wrapped_label("faint", panel), named("panel", new QWidget), nullptr};
  column->addWidget(made.title);
  column->addWidget(made.missing);
  column->addWidget(scrolled(made.controls), 1);
  made.column = new QVBoxLayout(made.controls);
  made.column->setContentsMargins(0, 0, 10, 0);
  made.column->setSpacing(8);
  return made;
}

void show_text(QLabel* label, const QString& text) {
  label->setText(text);
  label->setVisible(!text.isEmpty());
}

QHBoxLayout* in_the_middle(QLabel* text) {
  constexpr int widest = 640;
  text->setFixedWidth(widest);
  text->setAlignment(Qt::AlignCenter);
  auto* row = new QHBoxLayout;
  row->addStretch();
  row->addWidget(text);
  row->addStretch();
  return row;
}

QLabel* heading(QWidget* parent) { return named("heading", new QLabel(parent)); }

QLabel* wrapped_label(const char* name, QWidget* parent) {
  auto* made = named(name, new QLabel(parent));
  made->setWordWrap(true);
  return made;
}

QPushButton* named_button(const char* name, QWidget* parent) { return named(name, new QPushButton(parent)); }

QScrollArea* scrolled(QWidget* widget) {
  auto* scroll = new UprightScrollArea;
  scroll->setWidget(widget);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  return scroll;
}

}  // namespace glisson::widgets

#include "widgets/words/named.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QLabel>
#include <QLayout>
#include <QScrollBar>
#include <QSlider>

#include "widgets/views/render_widget.h"

namespace glisson::widgets {
namespace {

constexpr const char* named_here = "named_here";  // so that a name in another language takes its place

QString plain(QString text) { return text.remove('&').section('\n', 0, 0).trimmed(); }

// The last label in it with a text.
const QLabel* last_label(QLayoutItem* item) {
  if (item == nullptr) return nullptr;
  if (const auto* label = qobject_cast<const QLabel*>(item->widget())) return label->text().isEmpty() ? nullptr : label;
  QLayout* inner = item->layout();
  for (int k = inner == nullptr ? -1 : inner->count() - 1; k >= 0; --k) {
    if (const QLabel* label = last_label(inner->itemAt(k))) return label;
  }
  return nullptr;
}

// The layout within that holds the widget itself.
QLayout* layout_of(QLayout* within, QWidget* widget) {
  if (within == nullptr) return nullptr;
  for (int k = 0; k < within->count(); ++k) {
    if (within->itemAt(k)->widget() == widget) return within;
    if (QLayout* found = layout_of(within->itemAt(k)->layout(), widget)) return found;
  }
  return nullptr;
}

// The nearest label before the widget: in its row, then in the rows above, then around what it stands in.
QString label_before(QWidget* widget) {
  for (QWidget* parent = widget->parentWidget(); parent != nullptr; widget = parent, parent = parent->parentWidget()) {
    QLayout* layout = layout_of(parent->layout(), widget);
    const QWidget* item_widget = widget;
    const QLayout* item_layout = nullptr;
    while (layout != nullptr) {
      int at = layout->count() - 1;
      while (at >= 0 && layout->itemAt(at)->widget() != item_widget) --at;
      if (item_layout != nullptr) {
        for (at = layout->count() - 1; at >= 0 && layout->itemAt(at)->layout() != item_layout;) --at;
      }
      for (int k = at - 1; k >= 0; --k) {
        if (const QLabel* label = last_label(layout->itemAt(k))) return plain(label->text());
      }
      item_layout = layout;
      item_widget = nullptr;
      layout = qobject_cast<QLayout*>(layout->parent());
      if (layout == nullptr) break;
    }
  }
  return {};
}

QString name_for(QWidget& control) {
  if (control.parentWidget() != nullptr && !control.parentWidget()->accessibleName().isEmpty()) {
    return control.parentWidget()->accessibleName();  // a slider and a box that are one number
  }
  const bool button = qobject_cast<QAbstractButton*>(&control) != nullptr;
  if (button && !control.toolTip().isEmpty()) return plain(control.toolTip());
  const QString label = label_before(&control);
  return label.isEmpty() ? plain(control.toolTip()) : label;
}

}  // namespace

bool is_control(const QWidget& widget) {
  if (widget.focusPolicy() == Qt::NoFocus || qobject_cast<const QScrollBar*>(&widget) != nullptr) return false;
  if (qobject_cast<const QComboBox*>(widget.parentWidget() != nullptr ? widget.parentWidget()->parentWidget()
                                                                      : nullptr))
    return false;  // the list that opens out of a box is part of it
  return qobject_cast<const QAbstractButton*>(&widget) != nullptr || qobject_cast<const QSlider*>(&widget) != nullptr ||
         qobject_cast<const QAbstractSpinBox*>(&widget) != nullptr ||
         qobject_cast<const QComboBox*>(&widget) != nullptr ||
         qobject_cast<const QAbstractItemView*>(&widget) != nullptr ||
         qobject_cast<const RenderWidget*>(&widget) != nullptr;
}

void name_controls(QWidget& within) {
  for (QWidget* control : within.findChildren<QWidget*>()) {
    if (!is_control(*control)) continue;
    const auto* button = qobject_cast<QAbstractButton*>(control);
    if (button != nullptr && !button->text().isEmpty()) continue;
    if (!control->accessibleName().isEmpty() && !control->property(named_here).toBool()) continue;
    control->setProperty(named_here, true);
    control->setAccessibleName(name_for(*control));
  }
}

}  // namespace glisson::widgets

#pragma once
// Whether a person can read and reach all of a window: no text larger than the room it has, no control beyond the edge
// of what it lies in. What scrolls up and down may lie below; nothing scrolls sideways.

#include <QAbstractButton>
#include <QAbstractScrollArea>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QScrollBar>
#include <QStyle>
#include <QTableView>
#include <QToolButton>
#include <QTreeView>
#include <QWidget>

namespace glisson::widgets::test {

inline QString place_of(const QWidget& widget) {
  QStringList names;
  for (const QWidget* up = &widget; up != nullptr; up = up->parentWidget()) {
    if (!up->objectName().isEmpty()) names.prepend(up->objectName());
  }
  return names.join('/');
}

// What of a label, button or box is cut off; empty for nothing.
inline QString cut_off(const QWidget& widget) {
  constexpr int hair = 1;  // rounding at other scales
  if (const auto* label = qobject_cast<const QLabel*>(&widget)) {
    if (label->text().isEmpty()) return {};
    if (label->wordWrap()) {
      const bool tall = label->heightForWidth(label->width()) > label->height() + hair;
      return tall ? QString("\"%1\" needs %2 px of height and has %3")
                        .arg(label->text())
                        .arg(label->heightForWidth(label->width()))
                        .arg(label->height())
                  : QString();
    }
    const QSize wanted = label->sizeHint();
    const bool small = wanted.width() > label->width() + hair || wanted.height() > label->height() + hair;
    return small ? QString("\"%1\" needs %2 x %3 px and has %4 x %5")
                       .arg(label->text())
                       .arg(wanted.width())
                       .arg(wanted.height())
                       .arg(label->width())
                       .arg(label->height())
                 : QString();
  }
  if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) {
    const auto* tool = qobject_cast<const QToolButton*>(button);
    const bool icon_alone =
        tool != nullptr && tool->toolButtonStyle() == Qt::ToolButtonIconOnly && !tool->icon().isNull();
    if (button->text().isEmpty() || icon_alone) return {};
    const int text_px = button->fontMetrics().size(Qt::TextShowMnemonic, button->text()).width();
    const bool icon = !button->icon().isNull();
    const int wanted = text_px + (icon ? button->iconSize().width() + 4 : 0);
    return wanted > button->width() + hair
               ? QString("\"%1\" needs %2 px and has %3").arg(button->text()).arg(wanted).arg(button->width())
               : QString();
  }
  if (const auto* box = qobject_cast<const QComboBox*>(&widget)) {
    constexpr int arrow = 16;
    const int wanted = box->fontMetrics().horizontalAdvance(box->currentText()) + arrow;
    return wanted > box->width() + hair
               ? QString("\"%1\" needs %2 px and has %3").arg(box->currentText()).arg(wanted).arg(box->width())
               : QString();
  }
  return {};
}

// Column heads, which Qt shortens to "Di...".
inline QString heads_cut_off(const QHeaderView& header) {
  if (header.orientation() != Qt::Horizontal || header.model() == nullptr) return {};
  for (int column = 0; column < header.count(); ++column) {
    if (header.isSectionHidden(column)) continue;
    const QString words = header.model()->headerData(column, Qt::Horizontal).toString();
    const int wanted = header.fontMetrics().size(0, words).width();
    if (wanted > header.sectionSize(column)) {
      return QString("the head \"%1\" needs %2 px and has %3").arg(words).arg(wanted).arg(header.sectionSize(column));
    }
  }
  return {};
}

// Everything of a window, as it stands there now, that cannot be read or reached.
inline QStringList what_does_not_fit(const QWidget& window) {
  QStringList found;
  for (const auto* widget : window.findChildren<const QWidget*>()) {
    if (!widget->isVisible() || widget->window() != &window || widget->size().isEmpty()) continue;
    const QWidget* parent = widget->parentWidget();
    const bool scrolls = qobject_cast<const QAbstractScrollArea*>(parent->parentWidget()) != nullptr;
    const QRect room = parent->rect().adjusted(-1, -1, 1, 1);
    const QRect place = widget->geometry();
    const bool beside = place.left() < room.left() || place.right() > room.right();
    const bool above = place.top() < room.top() || place.bottom() > room.bottom();
    if (beside || (above && !scrolls)) {
      found << QString("%1 (%2) lies beyond %3: %4..%5, %6..%7 in %8 x %9")
                   .arg(place_of(*widget), widget->metaObject()->className(), place_of(*parent))
                   .arg(place.left())
                   .arg(place.right())
                   .arg(place.top())
                   .arg(place.bottom())
                   .arg(parent->width())
                   .arg(parent->height());
    }
    QString problem = cut_off(*widget);
    if (const auto* header = qobject_cast<const QHeaderView*>(widget)) problem = heads_cut_off(*header);
    if (!problem.isEmpty()) found << place_of(*widget) + ": " + problem;
  }
  return found;
}

}  // namespace glisson::widgets::test

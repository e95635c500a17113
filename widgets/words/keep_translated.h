#pragma once
// Texts that follow the language of the window:
//
//   keep_translated(this, [=, this] {
//     title->setText(tr("Structures"));
//     open->setToolTip(tr("Opens a case"));
//   });
//
// sets them now and again at each change of language, and of theme, since a text may have colours. A text that is set
// anywhere else stays in the language of that moment.

#include <functional>
#include <QWidget>

namespace glisson::widgets {

void keep_translated(QWidget* owner, std::function<void()> set_texts);

}  // namespace glisson::widgets

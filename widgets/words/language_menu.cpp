#include "widgets/words/language_menu.h"

#include <QActionGroup>

#include "widgets/words/keep_translated.h"
#include "widgets/words/language.h"

namespace glisson::widgets {

LanguageMenu::LanguageMenu(QWidget* parent) : QMenu(parent) {
  setObjectName("language");
  auto* choices = new QActionGroup(this);
  const auto add = [&](const Language& language) {
    QAction* choice = addAction(language.name);
    choice->setData(language.code);
    choice->setCheckable(true);
    choice->setChecked(language.code == kept_language());
    choices->addAction(choice);
    return choice;
  };
  QAction* system = add({});
  addSeparator();
  for (const Language& language : languages()) add(language);
  connect(choices, &QActionGroup::triggered, this,
          [](const QAction* choice) { choose_language(choice->data().toString()); });
  keep_translated(this, [=, this] {
    setTitle(tr("&Language"));
    system->setText(tr("System language"));
  });
}

}  // namespace glisson::widgets

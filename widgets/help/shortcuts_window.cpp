#include "widgets/help/shortcuts_window.h"

#include <algorithm>
#include <QAbstractButton>
#include <QAction>
#include <QHeaderView>
#include <QLineEdit>
#include <QShortcut>
#include <QTableWidget>
#include <QVBoxLayout>
#include <vector>

#include "widgets/words/keep_translated.h"

namespace glisson::widgets {
namespace {

struct Key {
  QString does;
  QString keys;
};

QString without_mnemonic(QString text) { return text.remove('&').remove("..."); }

std::vector<Key> keys_of(const QWidget& window) {
  std::vector<Key> keys;
  const auto add = [&](const QString& does, const QKeySequence& sequence) {
    if (sequence.isEmpty() || does.isEmpty()) return;
    keys.push_back({without_mnemonic(does), sequence.toString(QKeySequence::NativeText)});
  };
  for (const QAction* action : window.findChildren<QAction*>()) add(action->text(), action->shortcut());
  for (const QShortcut* shortcut : window.findChildren<QShortcut*>()) add(shortcut->whatsThis(), shortcut->key());
  for (const QAbstractButton* button : window.findChildren<QAbstractButton*>())
    add(button->text().isEmpty() ? button->toolTip() : button->text(), button->shortcut());
  std::sort(keys.begin(), keys.end(), [](const Key& a, const Key& b) { return a.does.localeAwareCompare(b.does) < 0; });
  return keys;
}

}  // namespace

ShortcutsWindow::ShortcutsWindow(QWidget* window) : QWidget(window, Qt::Window) {
  setAttribute(Qt::WA_DeleteOnClose);
  setObjectName("shortcuts_window");
  resize(560, 640);
  auto* column = new QVBoxLayout(this);
  auto* words = new QLineEdit;
  words->setClearButtonEnabled(true);
  column->addWidget(words);
  auto* table = new QTableWidget(0, 2);
  table->setObjectName("shortcuts");
  table->verticalHeader()->hide();
  table->setShowGrid(false);
  table->setAlternatingRowColors(true);
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  table->horizontalHeader()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  column->addWidget(table, 1);

  connect(words, &QLineEdit::textChanged, table, [table](const QString& wanted) {
    for (int row = 0; row < table->rowCount(); ++row)
      table->setRowHidden(row, !table->item(row, 0)->text().contains(wanted, Qt::CaseInsensitive) &&
                                   !table->item(row, 1)->text().contains(wanted, Qt::CaseInsensitive));
  });
  keep_translated(this, [=, this] {
    setWindowTitle(tr("Keys - Glisson"));
    words->setPlaceholderText(tr("Search"));
    words->setAccessibleName(tr("Words to search for"));
    table->setAccessibleName(tr("Keys"));
    table->setHorizontalHeaderLabels({tr("What it does"), tr("Key")});
    const std::vector<Key> keys = keys_of(*window);
    table->setRowCount(static_cast<int>(keys.size()));
    for (int row = 0; row < table->rowCount(); ++row) {
      table->setItem(row, 0, new QTableWidgetItem(keys[static_cast<std::size_t>(row)].does));
      table->setItem(row, 1, new QTableWidgetItem(keys[static_cast<std::size_t>(row)].keys));
    }
  });
}

}  // namespace glisson::widgets

#include "theme.h"

#include <QApplication>
#include <QFile>
#include <QPalette>
#include <QStyleFactory>

// Resources of a static library are left out by the linker unless somebody asks for them; outside any namespace.
static void take_in_resources() {
  Q_INIT_RESOURCE(glisson);
  Q_INIT_RESOURCE(translations);
}

namespace glisson::widgets {

void apply_dark_theme(QApplication& application) {
  take_in_resources();
  application.setStyle(QStyleFactory::create("Fusion"));
  QPalette palette;
  const QColor window(0x1b, 0x1f, 0x26);
  const QColor base(0x14, 0x17, 0x1c);
  const QColor raised(0x2a, 0x30, 0x3a);
  const QColor text(0xe4, 0xe8, 0xee);
  const QColor faint(0x7d, 0x87, 0x95);
  const QColor accent(0x2f, 0x9e, 0xa8);
  palette.setColor(QPalette::Window, window);
  palette.setColor(QPalette::WindowText, text);
  palette.setColor(QPalette::Base, base);
  palette.setColor(QPalette::AlternateBase, QColor(0x18, 0x1c, 0x22));
  palette.setColor(QPalette::Text, text);
  palette.setColor(QPalette::Button, raised);
  palette.setColor(QPalette::ButtonText, text);
  palette.setColor(QPalette::ToolTipBase, raised);
  palette.setColor(QPalette::ToolTipText, text);
  palette.setColor(QPalette::PlaceholderText, faint);
  palette.setColor(QPalette::Highlight, accent);
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::Link, QColor(0x5c, 0xc4, 0xcd));
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    palette.setColor(QPalette::Disabled, role, QColor(0x5c, 0x64, 0x70));
  }
  application.setPalette(palette);
  QFile sheet(":/themes/dark.qss");
  if (sheet.open(QIODevice::ReadOnly)) application.setStyleSheet(QString::fromUtf8(sheet.readAll()));
}

}  // namespace glisson::widgets

#include "widgets/theme.h"
#include "widgets/settings/program_settings.h"

#include <map>
#include <QApplication>
#include <QEvent>
#include <QFile>
#include <QPalette>
#include <QStyleFactory>
#include <QTextStream>
#include <QWidget>

// Resources of a static library are left out by the linker unless somebody asks for them; outside any namespace.
static void take_in_resources() {
  Q_INIT_RESOURCE(glisson);
  Q_INIT_RESOURCE(translations);
}

namespace glisson::widgets {
namespace {

constexpr const char* theme_key = "theme";
Theme applied = Theme::dark;

QString resource_text(const QString& resource) {
  QFile file(resource);
  return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

// Lines "name #rrggbb".
std::map<QString, QString> colours(Theme theme) {
  QString lines = resource_text(theme == Theme::dark ? ":/themes/dark.colours" : ":/themes/light.colours");
  QTextStream stream(&lines);
  std::map<QString, QString> found;
  while (!stream.atEnd()) {
    QString name;
    QString colour;
    stream >> name >> colour;
    if (!colour.isEmpty()) found[name] = colour;
  }
  return found;
}

QPalette palette_of(const std::map<QString, QString>& named) {
  const auto colour = [&](const char* name) { return QColor(named.at(name)); };
  QPalette palette;
  palette.setColor(QPalette::Window, colour("panel"));
  palette.setColor(QPalette::WindowText, colour("ink"));
  palette.setColor(QPalette::Base, colour("page"));
  palette.setColor(QPalette::AlternateBase, colour("stripe"));
  palette.setColor(QPalette::Text, colour("ink"));
  palette.setColor(QPalette::Button, colour("raised"));
  palette.setColor(QPalette::ButtonText, colour("ink"));
  palette.setColor(QPalette::ToolTipBase, colour("raised"));
  palette.setColor(QPalette::ToolTipText, colour("ink"));
  palette.setColor(QPalette::PlaceholderText, colour("waiting"));
  palette.setColor(QPalette::Highlight, colour("accent"));
  palette.setColor(QPalette::HighlightedText, colour("on_accent"));
  palette.setColor(QPalette::Link, colour("accent_edge"));
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    palette.setColor(QPalette::Disabled, role, colour("disabled"));
  }
  return palette;
}

}  // namespace

void apply_theme(Theme theme) {
  take_in_resources();
  applied = theme;
  const auto named = colours(theme);
  QString sheet = resource_text(":/themes/window.qss");
  for (const auto& [name, colour] : named) sheet.replace('@' + name + '@', colour);
  QApplication::setStyle(QStyleFactory::create("Fusion"));
  QApplication::setPalette(palette_of(named));
  qApp->setStyleSheet(sheet);
  QEvent changed(QEvent::ThemeChange);  // words/keep_translated.h and plots/themed_plot.h listen
  for (QWidget* widget : QApplication::allWidgets()) QApplication::sendEvent(widget, &changed);
}

QColor theme_colour(const char* name) {
  static const std::map<QString, QString> named[] = {colours(Theme::dark), colours(Theme::light)};
  return QColor(named[applied == Theme::dark ? 0 : 1].at(name));
}

Theme kept_theme() { return program_settings().value(theme_key).toString() == "light" ? Theme::light : Theme::dark; }

void keep_theme(Theme theme) {
  program_settings().setValue(theme_key, theme == Theme::light ? "light" : "dark");
  apply_theme(theme);
}

}  // namespace glisson::widgets

// The window's colours: both themes name the same ones, the style sheet uses no other, and words can be read.

#include <cmath>
#include <QFile>
#include <QRegularExpression>
#include <QSet>
#include <QtTest>

#include "run_test.h"
#include "widgets/theme.h"

namespace glisson::widgets {
namespace {

QString text_of(const QString& resource) {
  QFile file(resource);
  return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

QSet<QString> names_in(const QString& resource) {
  QSet<QString> names;
  for (const QString& line : text_of(resource).split('\n', Qt::SkipEmptyParts)) names.insert(line.section(' ', 0, 0));
  return names;
}

// Relative luminance and contrast ratio of WCAG 2.1.
double luminance(const QColor& colour) {
  const auto linear = [](double c) { return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) + 0.0722 * linear(colour.blueF());
}

double contrast(const char* one, const char* other) {
  const double a = luminance(theme_colour(one));
  const double b = luminance(theme_colour(other));
  return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

class ThemeTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void both_themes_name_the_same_colours() {
    QVERIFY(names_in(":/themes/dark.colours").size() > 20);
    QCOMPARE(names_in(":/themes/dark.colours"), names_in(":/themes/light.colours"));
  }

  void the_style_sheet_uses_named_colours_only() {
    const QString sheet = text_of(":/themes/window.qss");
    const QSet<QString> names = names_in(":/themes/dark.colours");
    QVERIFY(!sheet.contains(QRegularExpression("#[0-9a-fA-F]{6}\\b")));
    auto used = QRegularExpression("@(\\w+)@").globalMatch(sheet);
    QVERIFY(used.hasNext());
    while (used.hasNext()) {
      const QString name = used.next().captured(1);
      if (name != "name") QVERIFY2(names.contains(name), qPrintable(name));
    }
  }

  void words_can_be_read_data() {
    QTest::addColumn<int>("theme");
    QTest::newRow("dark") << static_cast<int>(Theme::dark);
    QTest::newRow("light") << static_cast<int>(Theme::light);
  }

  // 4.5 is WCAG's level AA for text.
  void words_can_be_read() {
    QFETCH(int, theme);
    apply_theme(static_cast<Theme>(theme));
    for (const auto& [ink, page] : {std::pair{"ink", "panel"},
                                    {"ink", "page"},
                                    {"ink", "raised"},
                                    {"faint", "panel"},
                                    {"ink_soft", "header"},
                                    {"ink_softer", "header"},
                                    {"warning_ink", "warning_page"},
                                    {"warning", "page"},
                                    {"fine", "page"},
                                    {"trouble_ink", "trouble_page"},
                                    {"ink", "accent_page"},
                                    {"waiting", "edge"},
                                    {"ink_strong", "selected"}}) {
      QVERIFY2(contrast(ink, page) >= 4.5, qPrintable(QString("%1 on %2: %3").arg(ink, page).arg(contrast(ink, page))));
    }
    QVERIFY(contrast("on_accent", "accent") >= 3);  // bold, as large text
  }
};

}  // namespace
}  // namespace glisson::widgets

int main(int argc, char** argv) { return glisson::widgets::run_test<glisson::widgets::ThemeTest>(argc, argv); }

#include "theme_test.moc"

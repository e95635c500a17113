#include "widgets/hardware/platform_words.h"

#include <QLocale>
#include <QStringList>

#include "widgets/hardware/platform_view.h"
#include "widgets/theme.h"
#include "widgets/words/numbers.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {

using hardware::Device;
using hardware::DevicePlan;

namespace {

QString listed(const QStringList& items);
QStringList remedies_in_words(const hardware::Remedies& remedies);
QString source_in_words(hardware::Source source);

}  // namespace

QString platform_in_full(const DevicePlan& answer, const Device& device, const hardware::PlanRequest& request) {
  const auto escaped = [](const std::string& text) { return QString::fromStdString(text).toHtmlEscaped(); };
  QString html = "<h3>" + escaped(device.name) + "</h3><p>" + escaped(device.worn_how) + "</p>";
  html += "<p><b>" +
          PlatformView::tr(
              "Idle first: it draws %1 W of the %2 W that its battery allows over %3 h; it would last %4 h "
              "and reach %5 °C without computing anything.")
              .arg(significant(answer.idle.idle_W), significant(answer.idle.allowed_W), significant(request.duration_h),
                   significant(answer.idle.idle_h), significant(answer.idle.idle_C)) +
          "</b></p>";
  html +=
      "<p>" +
      PlatformView::tr(
          "Frames/s: %1 by its speed, %2 by its battery, %3 by its heat. A frame takes %4 J above "
          "idle; mean power %5 W.")
          .arg(significant(answer.fps_by_computing), significant(answer.fps_by_energy),
               significant(answer.fps_by_temperature), significant(answer.frame_joules), significant(answer.power_W)) +
      "</p>";
  html += "<p>" +
          PlatformView::tr(
              "How sure that is: with its figures off by as much as their sources may be, 5 to 30 %, it holds in %1 of "
              "100 draws, and in 80 of 100 it can do %2 to %3 frames/s.")
              .arg(significant(100 * answer.certainty.holds), significant(answer.certainty.fps_low),
                   significant(answer.certainty.fps_high)) +
          "</p>";
  if (!answer.feasible) {
    QStringList reasons;
    for (const hardware::Reason& reason : answer.reasons) reasons << translated(reason.sentence).toHtmlEscaped();
    html += "<p>" + PlatformView::tr("Why it fails:") + "</p>" + listed(reasons);
    const QStringList remedies = remedies_in_words(answer.remedies);
    html += remedies.isEmpty() ? "<p>" + PlatformView::tr("No single figure would make it hold.") + "</p>"
                               : "<p>" + PlatformView::tr("It would hold with one of:") + "</p>" + listed(remedies);
  }
  html += "<p>" + PlatformView::tr("Where its figures come from:") + "</p><table cellspacing='0' cellpadding='3'>";
  for (const hardware::NamedFigure& named : hardware::figures_of(device)) {
    const bool assumed = named.figure.source == hardware::Source::assumed;
    const QString ink = theme_colour(assumed ? "warning" : "ink").name();
    html += QString(
                "<tr><td><nobr>%1</nobr></td><td align='right'>%2</td><td style='color:%3'>%4</td></tr>"
                "<tr><td colspan='3' style='color:%6'>%5</td></tr>")
                .arg(escaped(named.name), significant(named.figure.value, 4), ink, source_in_words(named.figure.source),
                     escaped(named.figure.note), theme_colour("faint").name());
  }
  return html + "</table>";
}

QString task_in_words(const hardware::Task& task) {
  return task.id == "rehearse"                ? PlatformView::tr("Rehearse: a live frame, small deformations")
         : task.id == "rehearse-large-strain" ? PlatformView::tr("Rehearse: a live frame, large deformations")
         : task.id == "rehearse-meshfree"     ? PlatformView::tr("Rehearse: a step of the meshfree engine")
         : task.id == "guide"                 ? PlatformView::tr("Guide: a frame")
         : task.id == "match"                 ? PlatformView::tr("Match: a registration of 128 points")
                                              : QString::fromStdString(task.what);
}

namespace {

QString listed(const QStringList& items) {
  return items.isEmpty() ? QString() : "<ul><li>" + items.join("</li><li>") + "</li></ul>";
}

QStringList remedies_in_words(const hardware::Remedies& remedies) {
  QStringList words;
  const auto add = [&](const std::optional<double>& value, const QString& sentence) {
    if (value) words << sentence.arg(significant(*value));
  };
  add(remedies.duration_h, PlatformView::tr("an operation of at most %1 h"));
  add(remedies.frames_per_s, PlatformView::tr("at most %1 frames/s"));
  add(remedies.accuracy_mm, PlatformView::tr("an accuracy of %1 mm"));
  add(remedies.battery_Wh, PlatformView::tr("a battery of %1 Wh"));
  add(remedies.thermal_resistance_C_per_W, PlatformView::tr("a heat sink of %1 °C/W"));
  return words;
}

QString source_in_words(hardware::Source source) {
  switch (source) {
    case hardware::Source::measured: return PlatformView::tr("measured");
    case hardware::Source::computed: return PlatformView::tr("computed");
    case hardware::Source::dissertation: return PlatformView::tr("dissertation");
    case hardware::Source::assumed: return PlatformView::tr("ASSUMED");
  }
  return {};
}

}  // namespace
}  // namespace glisson::widgets

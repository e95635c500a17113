#include "widgets/hardware/platform_table.h"

#include <algorithm>
#include <cmath>
#include <QHeaderView>
#include <QLocale>
#include <QSignalBlocker>

#include "widgets/theme.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {

using hardware::Constraint;
using hardware::Device;
using hardware::DevicePlan;

namespace {

QString short_number(double value) { return QLocale().toString(value, 'g', value >= 100 ? 4 : 3); }

// "≈ 2.8" where one of the figures that it rests on is assumed, and its reasons as a tooltip.
struct Number {
  QString text;
  QString reasons;
};
Number number_resting_on(double value, const Device& device, std::initializer_list<const char*> figures) {
  Number number{short_number(value), {}};
  QStringList reasons;
  for (const hardware::NamedFigure& named : hardware::figures_of(device)) {
    const bool rests =
        std::any_of(figures.begin(), figures.end(), [&](const char* name) { return named.name == name; });
    if (!rests || named.figure.source != hardware::Source::assumed) continue;
    reasons << PlatformTable::tr("Assumed: %1 %2 (%3)")
                   .arg(QString::fromStdString(named.name), short_number(named.figure.value),
                        QString::fromStdString(named.figure.note));
  }
  number.reasons = reasons.join("\n");
  if (!reasons.isEmpty()) number.text = QStringLiteral("≈ ") + number.text;
  return number;
}

QString worn_place(hardware::Worn worn) {
  switch (worn) {
    case hardware::Worn::head: return PlatformTable::tr("head");
    case hardware::Worn::belt: return PlatformTable::tr("belt");
    case hardware::Worn::back: return PlatformTable::tr("back");
  }
  return {};
}

QString words_for(Constraint constraint) {
  switch (constraint) {
    case Constraint::idle_energy: return PlatformTable::tr("idle draw");
    case Constraint::idle_temperature: return PlatformTable::tr("too hot idle");
    case Constraint::computing: return PlatformTable::tr("too slow");
    case Constraint::throttling: return PlatformTable::tr("slows itself down");
    case Constraint::energy: return PlatformTable::tr("battery");
    case Constraint::temperature: return PlatformTable::tr("too hot");
  }
  return {};
}

}  // namespace

QString limit_of(const DevicePlan& answer) {
  if (!answer.feasible) {
    QStringList words;
    for (const hardware::Reason& reason : answer.reasons) words << words_for(reason.constraint);
    return PlatformTable::tr("✕ fails: %1").arg(words.join(", "));
  }
  const QString bound = answer.fps == answer.fps_by_energy && answer.fps_by_energy < answer.fps_by_computing
                            ? PlatformTable::tr("battery")
                        : answer.fps == answer.fps_by_temperature && answer.fps_by_temperature < answer.fps_by_computing
                            ? PlatformTable::tr("heat")
                            : PlatformTable::tr("speed");
  return PlatformTable::tr("✓ holds; next limit: %1").arg(bound);
}

PlatformTable::PlatformTable(QWidget* parent) : QTableWidget(0, columns, parent) {
  setObjectName("platforms");
  keep_translated(this, [this] {
    setHorizontalHeaderLabels({tr("Platform"), tr("Worn on\nthe"), tr("Draws idle\nW"), tr("Battery\nallows W"),
                               tr("Left to\ncompute W"), tr("Frames/s\nat most"), tr("Lasts\nh"), tr("Surface\n°C"),
                               tr("Sure to\nhold %"), tr("Limit"), tr("Assumed\nfigures")});
    horizontalHeaderItem(idle)->setToolTip(tr("What it takes from its battery when nothing is computed"));
    horizontalHeaderItem(allowed)->setToolTip(
        tr("The largest constant power that its battery carries for the operation"));
    horizontalHeaderItem(left)->setToolTip(tr("What the battery allows, less what idling takes"));
    horizontalHeaderItem(frames)->setToolTip(tr("The frame rate that meets every constraint"));
    horizontalHeaderItem(lasts)->setToolTip(tr("On one charge, at the wanted frame rate or the fastest it computes"));
    horizontalHeaderItem(surface)->setToolTip(tr("At the end of the operation"));
    horizontalHeaderItem(sure)->setToolTip(
        tr("In how many of 100 draws of its figures, off by as much as their sources may be, it holds"));
    horizontalHeaderItem(assumed)->setToolTip(tr("Figures that nobody measured; ≈ marks what rests on them"));
    fit_columns();
  });
  horizontalHeader()->setMinimumSectionSize(40);
  for (const int column : {name, limit}) horizontalHeader()->setSectionResizeMode(column, QHeaderView::Stretch);
  verticalHeader()->hide();
  verticalHeader()->setDefaultSectionSize(25);
  setEditTriggers(NoEditTriggers);
  setSelectionBehavior(SelectRows);
  setSelectionMode(SingleSelection);
  setShowGrid(false);
  setAlternatingRowColors(true);
  connect(this, &QTableWidget::itemSelectionChanged, this, [this] {
    if (!chosen().isEmpty()) Q_EMIT platform_chosen(chosen());
  });
}

void PlatformTable::showEvent(QShowEvent* event) {
  QTableWidget::showEvent(event);
  fit_columns();  // the headings' font is known now
}

// As narrow as the headings and figures allow: names and limits share what is left. Nothing depends on what is in the
// cells, so that nothing jumps while a slider moves.
void PlatformTable::fit_columns() {
  QFont bold = font();
  bold.setBold(true);
  constexpr int room = 14;
  const auto wide_enough_for = [&](const QString& text) { return QFontMetrics(bold).horizontalAdvance(text) + room; };
  const int widest_figure = wide_enough_for("≈ 1 234"), widest_count = wide_enough_for(tr("%1 of %2").arg(88).arg(88));
  for (int column = worn; column < columns; ++column) {
    if (column == limit) continue;
    const int cells = column == worn ? 0 : column == assumed ? widest_count : widest_figure;
    setColumnWidth(column, std::max(horizontalHeader()->sectionSizeHint(column), cells));
  }
}

QString PlatformTable::chosen() const {
  const QTableWidgetItem* item = currentRow() >= 0 ? this->item(currentRow(), name) : nullptr;
  return item != nullptr ? item->data(Qt::UserRole).toString() : QString();
}

void PlatformTable::choose(const QString& id) {
  for (int row = 0; row < rowCount(); ++row) {
    if (item(row, name)->data(Qt::UserRole).toString() == id) setCurrentCell(row, name);
  }
}

void PlatformTable::show_plan(const hardware::Plan& plan, const std::vector<Device>& devices) {
  const QString kept = chosen();
  const QSignalBlocker quiet(this);
  std::vector<std::size_t> order(plan.platforms.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return plan.platforms[a].worn < plan.platforms[b].worn; });
  setRowCount(static_cast<int>(order.size()));
  for (int row = 0; row < rowCount(); ++row) {
    const std::size_t index = order[static_cast<std::size_t>(row)];
    const DevicePlan& answer = plan.platforms[index];
    const Device& device = devices[index];
    const bool recommended = plan.recommended == answer.id;
    const auto put = [&](int column, const QString& text, const QString& tip = {}) {
      if (item(row, column) == nullptr) setItem(row, column, new QTableWidgetItem);
      QTableWidgetItem* cell = item(row, column);
      cell->setText(text);
      cell->setToolTip(tip);
      if (column >= idle && column <= sure) cell->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      QFont font = cell->font();
      font.setBold(recommended);
      cell->setFont(font);
      return cell;
    };
    const auto put_number = [&](int column, double value, std::initializer_list<const char*> figures) {
      const Number number = number_resting_on(value, device, figures);
      return put(column, number.text, number.reasons);
    };
    put(name, QString::fromStdString(answer.name), QString::fromStdString(answer.name + ": " + device.worn_how))
        ->setData(Qt::UserRole, QString::fromStdString(answer.id));
    put(worn, worn_place(answer.worn), QString::fromStdString(device.worn_how));
    put_number(idle, answer.idle.idle_W, {"idle_W"});
    put_number(allowed, answer.idle.allowed_W, {"battery.capacity_mAh", "battery.voltage_V"});
    QTableWidgetItem* headroom =
        put_number(left, answer.idle.headroom_W, {"idle_W", "battery.capacity_mAh", "battery.voltage_V"});
    headroom->setForeground(answer.idle.headroom_W < 0.1 * answer.idle.allowed_W ? QBrush(theme_colour("warning"))
                                                                                 : QBrush());
    put_number(frames, answer.fps, {"kernel.bandwidth_GB_s", "kernel.active_W", "kernel.energy_nJ_per_byte"});
    put_number(lasts, answer.battery_h,
               {"idle_W", "kernel.active_W", "kernel.energy_nJ_per_byte", "battery.capacity_mAh", "battery.voltage_V"});
    put_number(surface, answer.temperature_C,
               {"thermal_resistance_C_per_W", "thermal_time_constant_s", "idle_W", "kernel.active_W"});
    put(sure, QLocale().toString(std::round(100 * answer.certainty.holds), 'f', 0),
        tr("In 80 of 100 draws it can do %1 to %2 frames/s")
            .arg(short_number(answer.certainty.fps_low), short_number(answer.certainty.fps_high)));
    QStringList reasons;
    for (const hardware::Reason& reason : answer.reasons) reasons << translated(reason.sentence);
    put(limit, limit_of(answer), reasons.join("\n"))->setForeground(theme_colour(answer.feasible ? "fine" : "warning"));
    QStringList names;
    for (const std::string& figure : answer.assumed) names << QString::fromStdString(figure);
    put(assumed, tr("%1 of %2").arg(answer.assumed.size()).arg(hardware::figures_of(device).size()), names.join("\n"));
  }
  choose(kept);
  if (chosen().isEmpty())
    choose(QString::fromStdString(plan.recommended.value_or(plan.platforms.empty() ? "" : plan.platforms.front().id)));
}

}  // namespace glisson::widgets

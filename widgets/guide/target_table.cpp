#include "widgets/guide/target_table.h"

#include <cmath>
#include <QHeaderView>
#include <QLocale>

#include "widgets/guide/overlay_painter.h"
#include "widgets/panels/swatch.h"
#include "widgets/words/numbers.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {
namespace {

constexpr int target_row_px = 25;

QString number_or_dash(double value) { return std::isfinite(value) ? number(value) : no_figure(); }

}  // namespace

TargetTable::TargetTable(QWidget* parent) : QTableWidget(0, column_count, parent) {
  setEditTriggers(NoEditTriggers);
  setSelectionMode(NoSelection);
  setFocusPolicy(Qt::NoFocus);
  setAlternatingRowColors(true);
  setShowGrid(false);
  setWordWrap(false);
  verticalHeader()->hide();
  verticalHeader()->setDefaultSectionSize(target_row_px);
  verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  horizontalHeader()->setSectionResizeMode(name, QHeaderView::Stretch);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
}

void TargetTable::show_structures(const std::vector<guidance::EmbeddedStructure>& structures,
                                  const std::vector<guidance::PlacedOutline>& outlines, double tolerance_mm) {
  setAccessibleName(tr("What is drawn, and how far it may be off"));
  setHorizontalHeaderLabels({tr("Outline"), tr("sd"), tr("90 %"), tr("deep")});
  horizontalHeaderItem(sd)->setToolTip(
      tr("Standard deviation of each coordinate of the error, mm: the largest over the structure"));
  horizontalHeaderItem(within)->setToolTip(tr("90 of 100 such places are off by this at most, mm: 2.5 sd"));
  horizontalHeaderItem(deep)->setToolTip(
      tr("How far its nearest place lies behind the liver's front, along the line of sight, mm"));
  setRowCount(static_cast<int>(structures.size()));
  for (std::size_t s = 0; s < structures.size(); ++s) {
    const auto found =
        std::find_if(outlines.begin(), outlines.end(), [&](const auto& one) { return one.structure == s; });
    const bool known = found != outlines.end() && std::isfinite(found->sd_mm);
    const bool trusted = known && is_trusted(found->sd_mm, tolerance_mm);
    const auto& [red, green, blue] = structures[s].colour;
    const auto row = static_cast<int>(s);
    const auto put = [&](Column column, const QString& text) {
      auto* cell = new QTableWidgetItem(text);
      if (column != name) cell->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      if (known && !trusted) {
        QFont bold = cell->font();
        bold.setBold(true);
        cell->setFont(bold);
        cell->setToolTip(tr("Do not trust it at %1 mm").arg(number_or_dash(tolerance_mm)));
      }
      setItem(row, column, cell);
      return cell;
    };
    const QString label = structure_label(structures[s].name);
    put(name, known && !trusted ? QString::fromUtf8("\u26a0 ") + label : label)
        ->setIcon(swatch({red / 255.0, green / 255.0, blue / 255.0}));
    put(sd, known ? number_or_dash(found->sd_mm) : no_figure());
    put(within, known ? number_or_dash(ninety_percent_in_sd * found->sd_mm) : no_figure());
    put(deep, found != outlines.end() && found->deep_mm ? number_or_dash(*found->deep_mm) : no_figure());
  }
  const int most = std::min(rowCount(), 9);
  setFixedHeight(horizontalHeader()->sizeHint().height() + target_row_px * std::max(1, most) + 2 * frameWidth());
}

}  // namespace glisson::widgets

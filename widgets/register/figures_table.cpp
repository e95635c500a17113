#include "widgets/register/figures_table.h"

#include <numeric>
#include <QHeaderView>
#include <QLocale>

#include "widgets/words/numbers.h"

namespace glisson::widgets {
namespace {

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace

FiguresTable::FiguresTable(QWidget* parent) : QTableWidget(row_count, 2, parent) {
  setEditTriggers(NoEditTriggers);
  setSelectionMode(NoSelection);
  setFocusPolicy(Qt::NoFocus);
  setAlternatingRowColors(true);
  setShowGrid(false);
  setWordWrap(false);
  verticalHeader()->setDefaultSectionSize(23);
  verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setFixedHeight(28 + 23 * row_count);
}

void FiguresTable::show_figures(const std::array<const Judged*, 2>& judged, const std::array<QString, 2>& names,
                                double tolerance_mm, int frame) {
  setAccessibleName(tr("Figures of the registrations"));
  setHorizontalHeaderLabels({names[0], names[1]});
  setVerticalHeaderLabels({tr("Mean correlation"), tr("Rejected (%)"), tr("TRE (mm)"), tr("TRE, this frame (mm)"),
                           tr("RMSE (mm)"), tr("RMSE, this frame (mm)"), tr("Landmarks"), tr("Triangles"),
                           tr("Time (s)")});
  verticalHeaderItem(correlation)->setToolTip(tr("SIRGn, over the triangles: 1 is best"));
  verticalHeaderItem(rejected)->setToolTip(
      tr("Share of the triangles whose corners are off by %1 mm or more on average").arg(number(tolerance_mm, 1)));
  for (const int row : {tre, tre_here}) {
    verticalHeaderItem(row)->setToolTip(
        tr("Target registration error: how far registered landmarks are from where they are on the model, mm"));
  }
  for (const int row : {rmse, rmse_here})
    verticalHeaderItem(row)->setToolTip(tr("How far the registered cloud is from the model (root mean square), mm"));
  verticalHeaderItem(time)->setToolTip(tr("To register all frames and to judge them, s"));
  const auto t = static_cast<std::size_t>(frame);
  // Without a model there is no distance from it.
  const auto in_all = [](const std::vector<double>& mm) { return mm.empty() ? no_figure() : number(mean(mm), 2); };
  const auto here = [&](const std::vector<double>& mm) { return t < mm.size() ? number(mm[t], 2) : no_figure(); };
  for (int column = 0; column < 2; ++column) {
    const Judged* one = judged[static_cast<std::size_t>(column)];
    for (int row = 0; row < row_count; ++row) {
      QString text = no_figure();
      if (one != nullptr) {
        const registration_quality::Quality& quality = one->quality;
        switch (row) {
          case correlation: text = number(quality.mean_correlation, 3); break;
          case rejected: text = number(100 * rejected_fraction(quality, tolerance_mm), 1); break;
          case tre: text = in_all(quality.tre_mm); break;
          case tre_here: text = here(quality.tre_mm); break;
          case rmse: text = in_all(quality.rmse_mm); break;
          case rmse_here: text = here(quality.rmse_mm); break;
          case landmarks: text = QString::number(quality.mesh.points_mm.size()); break;
          case triangles: text = QString::number(quality.mesh.triangles.size()); break;
          default: text = number(one->time_s, 1); break;
        }
      }
      auto* cell = new QTableWidgetItem(text);
      cell->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      setItem(row, column, cell);
    }
  }
}

}  // namespace glisson::widgets

#include "widgets/evidence/probability_bars.h"

#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>

#include "widgets/evidence/effect_words.h"
#include "widgets/words/numbers.h"

namespace glisson::widgets {

ProbabilityBars::ProbabilityBars(QWidget* parent) : QWidget(parent) {
  setObjectName("evidence_probabilities");
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setVerticalSpacing(2);
  grid->setColumnStretch(1, 1);
  setMaximumWidth(760);
}

void ProbabilityBars::show_record(const EvidenceRecord& record) {
  constexpr int most = 4, bar_px = 8;
  qDeleteAll(findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly));
  auto* grid = static_cast<QGridLayout*>(layout());
  int line = 0;
  for (const EvidenceProbability& one : record.probabilities) {
    if (line == most || one.probability < 0.01) break;
    const QString name = !one.kinds           ? tr("Something that is not in the catalogue")
                         : one.kinds->empty() ? tr("Nothing is missing")
                                              : effect_labels(*one.kinds);
    auto* bar = new QProgressBar(this);
    bar->setRange(0, 1000);
    bar->setValue(static_cast<int>(1000 * one.probability));
    bar->setTextVisible(false);
    bar->setFixedHeight(bar_px);
    const QString percent = number(100 * one.probability, 0) + " %";
    bar->setAccessibleName(name + ", " + percent);
    grid->addWidget(new QLabel(name, this), line, 0);
    grid->addWidget(bar, line, 1);
    grid->addWidget(new QLabel(percent, this), line, 2, Qt::AlignRight);
    ++line;
  }
  setVisible(line > 0);
  setToolTip(
      tr("Probability of each explanation. Where the answer was known, in generated experiments, 98 of 100 that were "
         "given "
         "90 % and more were right, and 7 of 10 given 60 to 80 %."));
}

}  // namespace glisson::widgets

#include "widgets/resect/resection_results.h"

#include <QGridLayout>
#include <QLocale>
#include <QVBoxLayout>

#include "widgets/panels/parts.h"
#include "widgets/panels/small_table.h"
#include "widgets/panels/swatch.h"
#include "widgets/resect/resection_scene.h"
#include "widgets/theme.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {
namespace {

using rehearsal::ResectionSide;

}  // namespace

QString side_label(ResectionSide side) {
  switch (side) {
    case ResectionSide::specimen: return ResectionResults::tr("removed");
    case ResectionSide::remnant: return ResectionResults::tr("stays");
    case ResectionSide::both: return ResectionResults::tr("cut through");
  }
  return {};
}

QString margin_flag(const rehearsal::TumourMargin& tumour) {
  if (tumour.side == ResectionSide::both) return ResectionResults::tr("▲ R1: cut through");
  if (tumour.side == ResectionSide::remnant) return ResectionResults::tr("▲ Stays in the patient");
  if (tumour.r1()) return ResectionResults::tr("▲ R1: under 1 mm");
  return tumour.narrow() ? ResectionResults::tr("● Under 5 mm") : QString();
}

ResectionResults::ResectionResults(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  why_ = new QLabel(this);
  why_->setObjectName("resection_why");
  why_->setWordWrap(true);
  column->addWidget(why_);
  answer_ = new QWidget(this);
  auto* rows = new QVBoxLayout(answer_);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(8);
  auto* volumes = new QGridLayout;
  volumes->setHorizontalSpacing(10);
  volumes->setColumnStretch(1, 1);
  specimen_ = new QLabel(answer_);
  specimen_->setObjectName("specimen_volume");
  remnant_ = new QLabel(answer_);
  remnant_->setObjectName("remnant_volume");
  for (int row = 0; row < 2; ++row) {
    auto* mark = new QLabel(answer_);
    mark->setPixmap(swatch(row == 0 ? specimen_colour() : remnant_colour()).pixmap(18, 18));
    volumes->addWidget(mark, row, 0);
    volumes->addWidget(row == 0 ? specimen_ : remnant_, row, 1);
  }
  rows->addLayout(volumes);
  retraction_ = wrapped_label("retraction_told", answer_);
  rows->addWidget(retraction_);
  QLabel* margins_title = heading(answer_);
  rows->addWidget(margins_title);
  margins_ = small_table("margins", 4, answer_);
  rows->addWidget(margins_);
  QLabel* crossings_title = heading(answer_);
  rows->addWidget(crossings_title);
  crossings_ = small_table("crossings", 2, answer_);
  rows->addWidget(crossings_);
  no_crossings_ = new QLabel(answer_);
  no_crossings_->setObjectName("faint");
  rows->addWidget(no_crossings_);
  column->addWidget(answer_);
  keep_translated(this, [=, this] {
    margins_title->setText(tr("Margins"));
    margins_->setHorizontalHeaderLabels({tr("Structure"), tr("Side"), tr("mm"), tr("Caution")});
    margins_->horizontalHeaderItem(margin_column)->setToolTip(tr("Smallest distance to the cut inside the liver"));
    margins_->horizontalHeaderItem(flag_column)
        ->setToolTip(tr("R1: a margin under 1 mm counts as tumour at the edge. Under 5 mm is narrow."));
    crossings_title->setText(tr("Vessels crossed"));
    crossings_->setHorizontalHeaderLabels({tr("Vessel"), tr("Diameter, mm")});
    no_crossings_->setText(tr("The cut crosses no vessel that was outlined."));
  });
}

void ResectionResults::show(const LiveResectionResult* result, const QString& why) {
  show_text(why_, why);
  answer_->setVisible(result != nullptr);
  if (result == nullptr) return;
  const rehearsal::Resection& plan = result->plan;
  const auto volume = [&](const QString& words, double ml, double percent) {
    return words.arg(ml, 0, 'f', ml < 100 ? 1 : 0).arg(percent, 0, 'f', 1);
  };
  specimen_->setText(volume(tr("<b>%1 ml</b> removed (%2 %)"), plan.specimen_ml, 100 - plan.remnant_percent()));
  remnant_->setText(volume(tr("<b>%1 ml</b> stay (%2 %)"), plan.remnant_ml, plan.remnant_percent()));
  tell_retraction(plan);
  fill_margins(plan);
  fill_crossings(plan);
}

// "With the tool Tumour 1 goes by 6.1 mm; its margin there is 8.2 mm."
void ResectionResults::tell_retraction(const rehearsal::Resection& plan) {
  retraction_->setVisible(plan.retraction.has_value());
  if (!plan.retraction) return;
  QStringList sentences;
  for (const rehearsal::TumourMargin& tumour : plan.tumours) {
    sentences << tr("With the tool %1 goes by %2 mm; its margin there is %3 mm.")
                     .arg(structure_label(tumour.name))
                     .arg(tumour.shift_mm, 0, 'f', 1)
                     .arg(tumour.margin_mm, 0, 'f', 1);
  }
  if (plan.retraction->state() != mechanics::AnswerState::within) sentences << translated(plan.retraction->sentence());
  retraction_->setText(sentences.join(" "));
}

void ResectionResults::fill_margins(const rehearsal::Resection& plan) {
  margins_->setRowCount(static_cast<int>(plan.tumours.size() + plan.cysts.size()));
  int row = 0;
  for (const rehearsal::TumourMargin& tumour : plan.tumours) {
    const QString flag = margin_flag(tumour);
    put_text(*margins_, row, structure_column, structure_label(tumour.name));
    put_text(*margins_, row, side_column, side_label(tumour.side));
    put_text(*margins_, row, margin_column, QLocale().toString(tumour.margin_mm, 'f', 1))
        ->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    put_text(*margins_, row, flag_column, flag);
    // Colour repeats what the words say.
    if (!flag.isEmpty()) {
      for (const int column : {margin_column, flag_column})
        margins_->item(row, column)->setForeground(theme_colour("warning"));
    }
    ++row;
  }
  for (const rehearsal::StructureSide& cyst : plan.cysts) {
    put_text(*margins_, row, structure_column, structure_label(cyst.name));
    put_text(*margins_, row, side_column, side_label(cyst.side));
    put_text(*margins_, row, margin_column, "–")->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    put_text(*margins_, row, flag_column, {});
    ++row;
  }
  fit_height(*margins_);
}

void ResectionResults::fill_crossings(const rehearsal::Resection& plan) {
  crossings_->setVisible(!plan.crossings.empty());
  no_crossings_->setVisible(plan.crossings.empty());
  crossings_->setRowCount(static_cast<int>(plan.crossings.size()));
  int row = 0;
  for (const rehearsal::VesselCrossing& crossing : plan.crossings) {
    put_text(*crossings_, row, 0, structure_label(crossing.name));
    put_text(*crossings_, row, 1, QLocale().toString(crossing.diameter_mm, 'f', 1))
        ->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    ++row;
  }
  constexpr int most_rows = 8;  // the widest; the others are scrolled to
  fit_height(*crossings_, most_rows);
}

}  // namespace glisson::widgets

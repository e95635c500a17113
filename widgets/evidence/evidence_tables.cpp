#include "widgets/evidence/evidence_tables.h"

#include <algorithm>
#include <QHeaderView>
#include <QLocale>

#include "widgets/evidence/effect_words.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {
namespace {

constexpr int evidence_row_px = 24;

QString figure(double value) { return QLocale().toString(value, 'g', 3); }
QString figure(const std::optional<double>& value) { return value ? figure(*value) : QString("–"); }

void plain_table(QTableWidget& table) {
  table.verticalHeader()->hide();
  table.verticalHeader()->setDefaultSectionSize(evidence_row_px);
  table.setEditTriggers(QAbstractItemView::NoEditTriggers);
  table.setSelectionMode(QAbstractItemView::NoSelection);
  table.setFocusPolicy(Qt::TabFocus);
  table.setShowGrid(false);
  table.setAlternatingRowColors(true);
}

void put(QTableWidget& table, int row, int column, const QString& text, bool number = true) {
  auto* cell = new QTableWidgetItem(text);
  cell->setToolTip(text);
  if (number) cell->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  table.setItem(row, column, cell);
}

// In the words of Kass and Raftery, Bayes factors, J Am Stat Assoc 90 (1995) 773-795, table 2: a BIC that falls by 2, 6
// and 10.
QString strength(double delta_bic) {
  return delta_bic < -10  ? CandidatesTable::tr("very strong")
         : delta_bic < -6 ? CandidatesTable::tr("strong")
         : delta_bic < -2 ? CandidatesTable::tr("weak")
                          : CandidatesTable::tr("none");
}

QString with_law(const std::string& kind, const std::string& law) {
  return law.empty() || law == kind
             ? effect_label(kind)
             : CandidatesTable::tr("%1 (%2)").arg(effect_label(kind), QString::fromStdString(law));
}

void fit_height(QTableWidget& table) {
  table.setFixedHeight(table.horizontalHeader()->sizeHint().height() + evidence_row_px * table.rowCount() + 4);
}

}  // namespace

QString with_unit(double value, const EvidenceRecord& record) {
  return record.unit == "noise" ? ErrorsTable::tr("%1 × noise").arg(figure(value))
                                : figure(value) + " " + QString::fromStdString(record.unit);
}

ErrorsTable::ErrorsTable(QWidget* parent) : QTableWidget(0, 3, parent) {
  setObjectName("evidence_errors");
  plain_table(*this);
  horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
}

void ErrorsTable::show_record(const EvidenceRecord& record) {
  const bool in_noise = record.unit == "noise";
  setHorizontalHeaderLabels({in_noise ? tr("Error, × noise") : tr("Error, %1").arg(QString::fromStdString(record.unit)),
                             tr("Before"), tr("After")});
  setRowCount(0);
  const auto add = [&](const QString& name, const QString& before, const QString& after) {
    const int row = rowCount();
    insertRow(row);
    put(*this, row, 0, name, false);
    put(*this, row, 1, before);
    put(*this, row, 2, after);
  };
  const auto interval = [](const EvidenceErrors& errors) {
    return errors.held_out_low ? tr("%1 to %2").arg(figure(*errors.held_out_low), figure(*errors.held_out_high))
                               : QString("–");
  };
  add(tr("On trials left out"), figure(record.before.held_out_rms), figure(record.after.held_out_rms));
  add(tr("95 % interval of it"), interval(record.before), interval(record.after));
  add(tr("Root mean square"), figure(record.before.rms), figure(record.after.rms));
  add(tr("Mean"), figure(record.before.mean), figure(record.after.mean));
  add(tr("95 of 100 are below"), figure(record.before.p95), figure(record.after.p95));
  if (record.after.hidden_target_mm) {
    add(tr("Hidden targets, mean"), figure(record.before.hidden_target_mm), figure(record.after.hidden_target_mm));
  }
  add(tr("Noise of the measurement"), figure(record.before.noise), figure(record.after.noise));
  fit_height(*this);
}

FoundTree::FoundTree(QWidget* parent) : QTreeWidget(parent) {
  setObjectName("evidence_found");
  setColumnCount(3);
  setSelectionMode(NoSelection);
  setFocusPolicy(Qt::TabFocus);
  setUniformRowHeights(true);
  header()->setStretchLastSection(false);
  header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  header()->setSectionResizeMode(0, QHeaderView::Stretch);
  connect(this, &QTreeWidget::itemChanged, this, &FoundTree::ticked);
}

void FoundTree::show_record(const EvidenceRecord& record) {
  const QSignalBlocker quiet(this);
  clear();
  setHeaderLabels({tr("Effect"), tr("Value ± sd"), tr("95 %")});
  for (const EvidenceEffect& effect : record.effects) {
    auto* row = new QTreeWidgetItem(this, {effect_label(effect.kind), QString::fromStdString(effect.law), {}});
    row->setData(0, Qt::UserRole, QString::fromStdString(effect.kind));
    row->setToolTip(0, translated(effect.sentence));
    row->setCheckState(0, Qt::Checked);
    QFont bold = row->font(0);
    bold.setBold(true);
    row->setFont(0, bold);
    for (const EvidenceParameter& parameter : effect.parameters) {
      const QString value = QString::fromStdString(parameter.value);
      const QString std = QString::fromStdString(parameter.std);
      auto* below = new QTreeWidgetItem(
          row, {parameter_label(parameter.name), std.isEmpty() ? value : value + " ± " + std,
                parameter.determined ? (parameter.low.empty() ? QString()
                                                              : tr("%1 to %2")
                                                                    .arg(QString::fromStdString(parameter.low),
                                                                         QString::fromStdString(parameter.high)))
                                     : tr("● left open by the data")});
      below->setToolTip(0, parameter_label(parameter.name));
    }
    row->setExpanded(true);
    row->setFirstColumnSpanned(effect.law.empty());
  }
}

void FoundTree::show_consequences(const std::vector<closedloop::LearntEffect>& effects) {
  const QSignalBlocker quiet(this);
  for (int k = 0; k < topLevelItemCount(); ++k) {
    QTreeWidgetItem* row = topLevelItem(k);
    const std::string kind = row->data(0, Qt::UserRole).toString().toStdString();
    const auto found = std::find_if(effects.begin(), effects.end(), [&](const auto& one) { return one.kind == kind; });
    if (found == effects.end()) continue;
    row->setToolTip(0, translated(found->sentence));
    row->setFlags(row->flags().setFlag(Qt::ItemIsUserCheckable, found->carried));
    if (found->carried) continue;
    row->setCheckState(0, Qt::Unchecked);
    row->setFirstColumnSpanned(false);
    row->setText(2, tr("changes nothing in the rehearsal"));
  }
}

std::vector<std::string> FoundTree::ticked_kinds() const {
  std::vector<std::string> kinds;
  for (int k = 0; k < topLevelItemCount(); ++k) {
    const QTreeWidgetItem* row = topLevelItem(k);
    if (row->checkState(0) == Qt::Checked) kinds.push_back(row->data(0, Qt::UserRole).toString().toStdString());
  }
  return kinds;
}

CandidatesTable::CandidatesTable(QWidget* parent) : QTableWidget(0, 5, parent) {
  setObjectName("evidence_candidates");
  plain_table(*this);
  horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  horizontalHeader()->setSectionResizeMode(name, QHeaderView::Stretch);
  horizontalHeader()->setSectionResizeMode(alike, QHeaderView::Stretch);
}

void CandidatesTable::show_record(const EvidenceRecord& record) {
  setHorizontalHeaderLabels({tr("Suspect, each by itself"), tr("Error"), tr("On trials left out"), tr("Evidence"),
                             tr("These data cannot tell it from")});
  horizontalHeaderItem(rms)->setToolTip(tr("Root mean square on the trials that it was fitted to"));
  horizontalHeaderItem(held_out)->setToolTip(
      tr("Root mean square on trials that it was not fitted to, left out whole"));
  horizontalHeaderItem(delta_bic)->setToolTip(tr("Against the declared model, by the difference of BIC"));
  setRowCount(static_cast<int>(record.ranking.size()));
  int row = 0;
  for (const EvidenceCandidate& candidate : record.ranking) {
    put(*this, row, name, with_law(candidate.kind, candidate.law), false);
    put(*this, row, rms, figure(candidate.rms));
    put(*this, row, held_out, figure(candidate.held_out_rms));
    put(*this, row, delta_bic, candidate.delta_bic ? strength(*candidate.delta_bic) : QString("–"), false);
    if (candidate.delta_bic) item(row, delta_bic)->setToolTip(tr("ΔBIC %1").arg(*candidate.delta_bic, 0, 'f', 0));
    put(*this, row, alike,
        candidate.removed.empty() ? effect_labels(candidate.alike)
                                  : tr("out of the running: %1").arg(translated(candidate.removed)),
        false);
    ++row;
  }
  fit_height(*this);
}

VisibleTable::VisibleTable(QWidget* parent) : QTableWidget(0, 4, parent) {
  setObjectName("evidence_visible");
  plain_table(*this);
  horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  horizontalHeader()->setSectionResizeMode(effect, QHeaderView::Stretch);
}

void VisibleTable::show_record(const EvidenceRecord& record) {
  setHorizontalHeaderLabels({tr("Effect"), tr("Parameter"), tr("Without effect"), tr("Seen from")});
  horizontalHeaderItem(seen_from)->setToolTip(tr("In nine of ten such experiments an effect of this size is seen"));
  setRowCount(static_cast<int>(record.visible.size()));
  int row = 0;
  for (const EvidenceVisible& one : record.visible) {
    put(*this, row, effect, with_law(one.kind, one.law), false);
    const QString size = parameter_label(one.parameter);
    put(*this, row, parameter, one.component > 0 ? tr("%1 (%2)").arg(size).arg(one.component) : size, false);
    put(*this, row, without, figure(one.no_effect));
    put(*this, row, seen_from, one.value ? figure(*one.value) : tr("at no size"));
    ++row;
  }
  fit_height(*this);
}

}  // namespace glisson::widgets

#include "widgets/rehearse/kept_orders.h"

#include <algorithm>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "rehearsal/comparison.h"
#include "widgets/panels/parts.h"
#include "widgets/panels/small_table.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {

KeptOrders::KeptOrders(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 4, 0, 0);
  column->setSpacing(6);
  table_ = small_table("orders", 5, this);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  column->addWidget(table_);
  text_ = wrapped_label("faint", this);
  column->addWidget(text_);
  name_ = new QLineEdit(this);
  name_->setObjectName("order_name");
  keep_ = named_button("keep_order", this);
  auto* keeping = new QHBoxLayout;
  keeping->addWidget(name_, 1);
  keeping->addWidget(keep_);
  column->addLayout(keeping);
  compare_ = named_button("compare_orders", this);
  drop_ = named_button("drop_order", this);
  auto* others = new QHBoxLayout;
  others->addWidget(compare_);
  others->addWidget(drop_);
  column->addLayout(others);

  connect(keep_, &QPushButton::clicked, this, [this] {
    const QString name = name_->text().trimmed();
    name_->clear();
    Q_EMIT keep_wanted(name.isEmpty() ? tr("Order %1").arg(orders_.size() + 1) : name);
  });
  connect(compare_, &QPushButton::clicked, this, &KeptOrders::compare_wanted);
  connect(drop_, &QPushButton::clicked, this, [this] {
    const auto row = static_cast<std::size_t>(table_->currentRow());
    if (row < orders_.size()) Q_EMIT drop_wanted(QString::fromStdString(orders_[row].name));
  });
  connect(table_, &QTableWidget::itemSelectionChanged, this,
          [this] { drop_->setEnabled(!table_->selectedItems().isEmpty()); });
  keep_translated(this, [this] { update_text(); });
}

void KeptOrders::update_text() {
  table_->setHorizontalHeaderLabels(
      {tr("Order"), tr("Steps"), tr("mm"), tr("N"), "%"});  // units, so that names have room
  table_->horizontalHeaderItem(displacement_column)
      ->setToolTip(tr("How far the landmark goes that moves most; 5 mm or more is marked !"));
  table_->horizontalHeaderItem(force_column)->setToolTip(tr("The largest force of any one tool"));
  table_->horizontalHeaderItem(strain_column)->setToolTip(tr("The largest strain"));
  name_->setPlaceholderText(tr("Name of the order"));
  keep_->setText(tr("Keep these steps"));
  compare_->setText(tr("Compare"));
  compare_->setToolTip(tr("Runs each order again from the liver at rest; the report shows what comes of it"));
  drop_->setText(tr("Drop"));
  drop_->setToolTip(tr("Takes the order that is marked out of the case"));
  allow_keeping(allowed_);
  fill();
}

void KeptOrders::show_orders(std::vector<casefile::KeptOrder> orders,
                             std::optional<casefile::ComparedOrders> compared) {
  orders_ = std::move(orders);
  compared_ = std::move(compared);
  fill();
}

void KeptOrders::allow_keeping(bool allowed) {
  allowed_ = allowed;
  keep_->setEnabled(allowed);
  keep_->setToolTip(allowed ? tr("Keeps all that the tools did, and the cut, in this order")
                            : tr("Steps are kept of rigid tools and of large deformations, by finite elements"));
}

void KeptOrders::fill() {
  for (QWidget* each : std::initializer_list<QWidget*>{table_, compare_, drop_}) each->setVisible(!orders_.empty());
  table_->clearSelection();
  drop_->setEnabled(false);
  table_->setRowCount(static_cast<int>(orders_.size()));
  for (int row = 0; row < table_->rowCount(); ++row) fill_row(row);
  fit_height(*table_);
  QStringList told;
  if (compared_) {
    for (const Sentence& remark : compared_->remarks) told << translated(remark);
    const bool all = std::all_of(orders_.begin(), orders_.end(),
                                 [this](const casefile::KeptOrder& order) { return figures_of(order) != nullptr; });
    if (!all) told << tr("Kept since: compare again.");
  }
  show_text(text_, told.join("\n"));
}

void KeptOrders::fill_row(int row) {
  const casefile::KeptOrder& order = orders_[static_cast<std::size_t>(row)];
  const rehearsal::OrderOfSteps* figures = figures_of(order);
  put_text(*table_, row, name_column, QString::fromStdString(order.name));
  const auto put = [&](int column, const QString& text) {
    put_text(*table_, row, column, text)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  };
  const auto worst = [](const rehearsal::Worst& of, int decimals, double factor = 1) {
    return of.step == 0 ? QString("–") : QString::number(factor * of.value, 'f', decimals);
  };
  put(steps_column, QString::number(order.recording.size()));
  if (figures == nullptr) {
    for (const int column : {displacement_column, force_column, strain_column}) put(column, "–");
    return;
  }
  rehearsal::Worst moves;
  for (const rehearsal::LandmarkMove& landmark : figures->landmarks) {
    if (landmark.largest_mm.value >= moves.value) moves = landmark.largest_mm;
  }
  put(displacement_column, worst(moves, 1) + (moves.value >= rehearsal::significant_mm ? " !" : ""));
  put(force_column, worst(figures->largest_force_N, 2));
  put(strain_column, worst(figures->largest_strain, 0, 100));
  const std::size_t not_done = figures->refused.size() + figures->unusable.size();
  if (not_done == 0) return;
  QTableWidgetItem* name = table_->item(row, name_column);
  name->setText("▲ " + name->text());
  name->setToolTip(tr("Steps that could not be carried out, or are not to be used: %1").arg(not_done));
}

const rehearsal::OrderOfSteps* KeptOrders::figures_of(const casefile::KeptOrder& order) const {
  if (!compared_) return nullptr;
  const auto found = std::find_if(compared_->orders.begin(), compared_->orders.end(),
                                  [&](const rehearsal::OrderOfSteps& one) { return one.name == order.name; });
  return found == compared_->orders.end() ? nullptr : &*found;
}

}  // namespace glisson::widgets

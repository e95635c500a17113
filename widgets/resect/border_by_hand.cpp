#include "widgets/resect/border_by_hand.h"

#include <algorithm>
#include <limits>
#include <QVBoxLayout>

#include "widgets/panels/parts.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/numbers.h"

namespace glisson::widgets {

BorderByHand::BorderByHand(QWidget* parent) : QWidget(parent) {
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  border_ = new QComboBox(this);
  border_->setObjectName("border_at_crosshair");
  border_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  tell_ = named_button("tell_border", this);
  drop_ = named_button("drop_border", this);
  rows->addWidget(border_);
  rows->addWidget(tell_);
  rows->addWidget(drop_);
  connect(tell_, &QPushButton::clicked, this, [this] {
    const auto segments = vasculature::border_named(border_->currentData().toString().toStdString());
    if (segments) Q_EMIT told(*segments);
  });
  connect(drop_, &QPushButton::clicked, this, &BorderByHand::last_dropped);
  keep_translated(this, [this] {
    tell_->setText(tr("Runs through the crosshair"));
    tell_->setToolTip(
        tr("The border of these two segments is to pass the crosshair. Segments are found again by it, and are less in "
           "doubt. Its mark is dragged in a slice or in 3D; Delete takes away the one that was clicked on"));
    border_->setToolTip(tr("First stands the border that runs nearest to the crosshair"));
    show_nearest();
    show_dropping();
  });
}

void BorderByHand::offer(const vasculature::DrawnBorders& drawn, const vasculature::BorderPlaces& set) {
  drawn_ = drawn;
  set_ = set;
  setVisible(!drawn.empty());
  show_nearest();
  show_dropping();
}

void BorderByHand::crosshair_moved(const Eigen::Vector3d& position_mm) {
  crosshair_mm_ = position_mm;
  if (isVisible()) show_nearest();
}

void BorderByHand::show_nearest() {
  std::vector<std::pair<double, vasculature::SegmentPair>> away;
  for (const auto& [segments, places_mm] : drawn_) {
    double nearest_mm = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& place : places_mm) nearest_mm = std::min(nearest_mm, (place - crosshair_mm_).norm());
    away.emplace_back(nearest_mm, segments);
  }
  std::sort(away.begin(), away.end());
  border_->clear();
  for (const auto& [away_mm, segments] : away) {
    border_->addItem(tr("Border %1 (%2 mm away)").arg(border_label(segments), number(away_mm, 0)),
                     QString::fromStdString(vasculature::border_name(segments)));
  }
}

void BorderByHand::show_dropping() {
  drop_->setVisible(!set_.empty());
  if (set_.empty()) return;
  drop_->setText(tr("Forget the last place (%1)").arg(border_label(set_.back().segments)));
  drop_->setToolTip(
      tr("Places on borders that were set by hand: %1. Segments are found again without the last").arg(set_.size()));
}

QString border_label(const vasculature::SegmentPair& segments) {
  return QString::fromStdString(vasculature::border_name(segments)).replace('-', QChar(0x2013));
}

}  // namespace glisson::widgets

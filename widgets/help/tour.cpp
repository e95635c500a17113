#include "widgets/help/tour.h"

#include <QHBoxLayout>
#include <utility>

#include "widgets/words/keep_translated.h"

namespace glisson::widgets {

TourCard::TourCard(QWidget* parent) : QFrame(parent) {
  setObjectName("tour");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(16, 10, 12, 10);
  row->setSpacing(10);
  auto* text = new QVBoxLayout;
  title_ = new QLabel;
  title_->setObjectName("tour_title");
  words_ = new QLabel;
  words_->setObjectName("tour_words");
  words_->setWordWrap(true);
  text->addWidget(title_);
  text->addWidget(words_);
  row->addLayout(text, 1);
  where_ = new QLabel;
  where_->setObjectName("faint");
  row->addWidget(where_);
  auto* leave = new QPushButton;
  leave->setObjectName("tour_end");
  back_ = new QPushButton;
  back_->setObjectName("tour_back");
  next_ = new QPushButton;
  next_->setObjectName("tour_next");
  for (QPushButton* button : {leave, back_, next_}) row->addWidget(button);
  connect(leave, &QPushButton::clicked, this, &TourCard::end);
  connect(back_, &QPushButton::clicked, this, [this] { go(stop_ - 1); });
  connect(next_, &QPushButton::clicked, this, [this] {
    if (stop_ + 1 < stops()) {
      go(stop_ + 1);
    } else {
      end();
    }
  });
  hide();
  keep_translated(this, [=, this] {
    leave->setText(tr("End the tour"));
    back_->setText(tr("Back"));
    update_text();
  });
}

void TourCard::start(std::vector<TourStop> stops) {
  stops_ = std::move(stops);
  show();
  go(0);
  next_->setFocus();
}

void TourCard::end() {
  hide();
  Q_EMIT ended();
}

void TourCard::go(int stop) {
  stop_ = stop;
  update_text();
  const TourStop here = stops_.at(static_cast<std::size_t>(stop));
  Q_EMIT arrived(here.workspace);
  here.act();
}

void TourCard::update_text() {
  if (stops_.empty()) return;
  const TourStop& here = stops_.at(static_cast<std::size_t>(stop_));
  title_->setText(here.title());
  words_->setText(here.words());
  where_->setText(tr("%1 of %2").arg(stop_ + 1).arg(stops()));
  back_->setEnabled(stop_ > 0);
  next_->setText(stop_ + 1 < stops() ? tr("Next") : tr("Done"));
}

}  // namespace glisson::widgets

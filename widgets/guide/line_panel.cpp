#include "widgets/guide/line_panel.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "widgets/panels/parts.h"
#include "widgets/words/keep_translated.h"

namespace glisson::widgets {

LinePanel::LinePanel(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(7);
  mark_ = named_button("mark_lines");
  mark_->setCheckable(true);
  column->addWidget(mark_);
  body_ = new QWidget;
  auto* rows = new QVBoxLayout(body_);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(7);
  auto* row = new QHBoxLayout;
  line_ = new QComboBox;
  line_->setObjectName("marked_line");
  for (const char* id : {"falciform", "lower-edge", "gallbladder", "other"})
    line_->addItem(QString(), QVariant(QString(id)));
  remove_ = named_button("remove_line");
  row->addWidget(line_, 1);
  row->addWidget(remove_);
  rows->addLayout(row);
  places_ = wrapped_label("line_places");
  rows->addWidget(places_);
  help_ = wrapped_label("faint");
  rows->addWidget(help_);
  column->addWidget(body_);
  body_->setVisible(false);
  connect(mark_, &QPushButton::toggled, this, [this](bool on) {
    body_->setVisible(on);
    Q_EMIT turned(on);
  });
  connect(line_, &QComboBox::currentIndexChanged, this, &LinePanel::line_chosen);
  connect(remove_, &QPushButton::clicked, this, &LinePanel::removing_wanted);
  keep_translated(this, [this] { update_text(); });
}

void LinePanel::set_allowed(bool allowed, const QString& why_not) {
  mark_->setEnabled(allowed);
  mark_->setToolTip(allowed ? tr("Mark a ridge or a ligament on the frame and on the model: where the shape alone does "
                                 "not tell how the liver lies, the line does")
                            : why_not);
}

void LinePanel::show_places(std::size_t on_frame, std::size_t on_model) {
  on_frame_ = on_frame;
  on_model_ = on_model;
  update_text();
}

void LinePanel::update_text() {
  mark_->setText(tr("Mark lines"));
  const QStringList names{tr("Falciform ligament"), tr("Lower edge"), tr("Gall bladder's border"), tr("Another line")};
  for (int n = 0; n < names.size(); ++n) line_->setItemText(n, names[n]);
  line_->setAccessibleName(tr("The line that is marked"));
  line_->setToolTip(tr("Which line the next clicks are of"));
  remove_->setText(tr("Remove"));
  remove_->setToolTip(tr("Takes this line away, from the model and from all frames"));
  remove_->setEnabled(on_frame_ + on_model_ > 0);
  const QString places = tr("Places on this frame: %1, on the model: %2.").arg(on_frame_).arg(on_model_);
  places_->setText(on_frame_ >= 2 && on_model_ >= 2 ? places + " " + tr("It counts when the liver is placed.")
                                                    : places + " " + tr("It counts from two on each."));
  help_->setText(tr(
      "Click along the line on the frame, and along the same line on the model. The two need not begin or end at the "
      "same place. Undo takes a click back."));
}

}  // namespace glisson::widgets

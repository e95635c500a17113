#include "widgets/panels/next_step_box.h"

#include "widgets/panels/parts.h"
#include "widgets/words/keep_translated.h"

namespace glisson::widgets {

NextStepBox::NextStepBox(QWidget* parent) : QWidget(parent) {
  setObjectName("next_step");
  setAttribute(Qt::WA_StyledBackground);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(14, 10, 14, 14);
  text_ = new QLabel;
  text_->setWordWrap(true);
  column->addWidget(text_);
  button_ = named_button("primary");
  column->addWidget(button_);
  waves_text_ = wrapped_label("faint");
  column->addWidget(waves_text_);
  waves_ = named_button("next_waves");
  column->addWidget(waves_);
  connect(button_, &QPushButton::clicked, this, [this] { Q_EMIT wanted(next_); });
  connect(waves_, &QPushButton::clicked, this, &NextStepBox::waves_wanted);
  hide();
  keep_translated(this, [this] { update_text(); });
}

void NextStepBox::show_case(const std::filesystem::path& folder) {
  next_ = folder.empty() ? NextStep::none : next_step(folder);
  setVisible(next_ != NextStep::none);
  const bool waves = !folder.empty() && has_waves_to_invert(folder);
  for (QWidget* each : std::initializer_list<QWidget*>{waves_text_, waves_}) each->setVisible(waves);
  update_text();
}

void NextStepBox::update_text() {
  const bool outline = next_ == NextStep::outline_liver;
  text_->setText(outline ? tr("Next: put the crosshair inside the liver, away from large vessels.")
                         : tr("Next: build the model of the liver from its outline and stiffness."));
  waves_text_->setText(tr("Its elastography has not been inverted: until then the stiffness is assumed."));
  waves_->setText(tr("Elastography waves..."));
  button_->setText(outline ? tr("Outline the liver from here") : tr("Build the model"));
}

}  // namespace glisson::widgets

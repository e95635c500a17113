#include "widgets/rehearse/solving_light.h"

#include <QVBoxLayout>

#include "widgets/theme.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {

SolvingLight::SolvingLight(const LiveRehearsal& rehearsal, QWidget* parent) : QWidget(parent), rehearsal_(rehearsal) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  sign_ = new QLabel(this);
  sign_->setObjectName("solving_sign");
  figures_ = new QLabel(this);
  figures_->setObjectName("faint");
  column->addWidget(sign_);
  column->addWidget(figures_);
  trouble_ = new QLabel(this);
  trouble_->setObjectName("solving_trouble");
  trouble_->setWordWrap(true);
  trouble_->hide();
  column->addWidget(trouble_);
  connect(&rehearsal, &LiveRehearsal::solving_changed, this, &SolvingLight::show_state);
  connect(&rehearsal, &LiveRehearsal::state_changed, this, &SolvingLight::show_state);
  keep_translated(this, [this] { show_state(); });
}

void SolvingLight::show_drawing_ms(double drawing_ms) {
  drawing_ms_ = drawing_ms;
  show_state();
}

void SolvingLight::show_state() {
  using mechanics::AnswerState;
  const auto& state = rehearsal_.state();
  const AnswerState worth = state ? state->validity.state() : AnswerState::within;
  QString words;
  QString colour;
  switch (rehearsal_.solving()) {
    case Solving::no_tool: words = tr("○ No tool"); break;
    case Solving::solving:
      words = tr("◐ Solving");
      colour = "warning";
      break;
    case Solving::solved:
      words = worth == AnswerState::within                 ? tr("✔ Solved")
              : worth == AnswerState::outside_of_the_model ? tr("▲ Outside of the model")
                                                           : tr("▲ Not to be used");
      colour = worth == AnswerState::within                 ? "accent_edge"
               : worth == AnswerState::outside_of_the_model ? "warning"
                                                            : "trouble";
      break;
    case Solving::refused:
      words = tr("✖ Not solved");
      colour = "trouble";
      break;
  }
  if (rehearsal_.frozen()) words += "  " + tr("❚❚ Frozen");
  sign_->setText(words);
  sign_->setStyleSheet(colour.isEmpty() ? QString() : QString("color: %1").arg(theme_colour(colour.toLatin1()).name()));
  figures_->setText(
      state ? tr("solved in %1 ms · drawn in %2 ms").arg(state->answer_ms, 0, 'f', 1).arg(drawing_ms_, 0, 'f', 0)
            : QString());
  figures_->setToolTip(
      state ? tr("Residual %1: how far the equations are from balance").arg(state->relative_residual, 0, 'e', 0)
            : QString());
  QString trouble;
  if (rehearsal_.refusal()) {
    trouble = translated(*rehearsal_.refusal()) + " " + tr("What is shown is from before.");
  } else if (worth != AnswerState::within) {
    trouble = translated(state->validity.sentence()) + " " + tr("Use less force.");
  }
  trouble_->setText(trouble);
  trouble_->setVisible(!trouble.isEmpty());
}

}  // namespace glisson::widgets

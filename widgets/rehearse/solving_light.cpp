#include "widgets/rehearse/solving_light.h"

#include <algorithm>
#include <QVBoxLayout>

#include "widgets/panels/parts.h"
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
  bound_ = wrapped_label("error_bound", this);
  bound_->hide();
  column->addWidget(bound_);
  column->addWidget(figures_);
  trouble_ = new QLabel(this);
  trouble_->setObjectName("solving_trouble");
  trouble_->setWordWrap(true);
  trouble_->hide();
  column->addWidget(trouble_);
  connect(&rehearsal, &LiveRehearsal::solving_changed, this, &SolvingLight::show_state);
  connect(&rehearsal, &LiveRehearsal::state_changed, this, &SolvingLight::show_state);
  keep_translated(this, [this] {
    bound_->setToolTip(tr("An estimate, which holds for slow tools; past 0.5 mm the picture is said to be settling"));
    show_state();
  });
}

void SolvingLight::show_drawing_ms(double drawing_ms) {
  drawing_ms_ = drawing_ms;
  show_state();
}

void SolvingLight::show_state() {
  const auto& state = rehearsal_.state();
  show_sign();
  show_bound();
  figures_->setText(
      state ? tr("solved in %1 ms · drawn in %2 ms").arg(state->answer_ms, 0, 'f', 1).arg(drawing_ms_, 0, 'f', 0)
            : QString());
  figures_->setToolTip(
      state ? tr("Residual %1: how far the equations are from balance").arg(state->relative_residual, 0, 'e', 0)
            : QString());
  show_text(trouble_, trouble());
}

namespace {

using mechanics::AnswerState;

AnswerState worth_of(const LiveRehearsal& rehearsal) {
  return rehearsal.state() ? rehearsal.state()->validity.state() : AnswerState::within;
}

// A first picture may be shown as it is where its bound is small.
bool is_near_rest(const LiveRehearsal& rehearsal) {
  const auto bound_mm = rehearsal.error_bound_mm();
  return bound_mm && *bound_mm <= rehearsal::SessionEngine::shown_mm;
}

}  // namespace

void SolvingLight::show_sign() {
  QString words, colour;
  const auto solved = [&] {
    const AnswerState worth = worth_of(rehearsal_);
    words = worth == AnswerState::within                 ? tr("✔ Solved")
            : worth == AnswerState::outside_of_the_model ? tr("▲ Outside of the model")
                                                         : tr("▲ Not to be used");
    colour = worth == AnswerState::within                 ? "accent_edge"
             : worth == AnswerState::outside_of_the_model ? "warning"
                                                          : "trouble";
  };
  switch (rehearsal_.solving()) {
    case Solving::no_tool: words = tr("○ No tool"); break;
    case Solving::solving:
      words = rehearsal_.preparing() ? tr("◐ Preparing") : tr("◐ Solving");
      colour = "warning";
      break;
    case Solving::settling:
      if (rehearsal_.deformations() == Deformations::moving) {
        words = tr("◐ Moving");
      } else if (is_near_rest(rehearsal_)) {
        solved();
      } else {
        words = tr("◐ Settling");
        colour = "warning";
      }
      break;
    case Solving::solved: solved(); break;
    case Solving::unsettled:
      words = tr("▲ Not at rest");
      colour = "trouble";
      break;
    case Solving::refused:
      words = tr("✖ Not solved");
      colour = "trouble";
      break;
  }
  if (rehearsal_.frozen()) words += "  " + tr("❚❚ Frozen");
  sign_->setText(words);
  sign_->setStyleSheet(colour.isEmpty() ? QString() : QString("color: %1").arg(theme_colour(colour.toLatin1()).name()));
}

void SolvingLight::show_bound() {
  const auto bound_mm = rehearsal_.error_bound_mm();
  const bool shown = bound_mm && rehearsal_.state()->validity.usable();
  bound_->setVisible(shown);
  if (!shown) return;
  constexpr double finest_mm = 0.01;
  bound_->setText(tr("Landmarks are within %1 mm of rest").arg(std::max(finest_mm, *bound_mm), 0, 'f', 2));
}

QString SolvingLight::trouble() const {
  const AnswerState worth = worth_of(rehearsal_);
  if (rehearsal_.refusal()) return translated(*rehearsal_.refusal()) + " " + tr("What is shown is from before.");
  if (worth != AnswerState::within) {
    return translated(rehearsal_.state()->validity.sentence()) + " " + tr("Use less force.");
  }
  if (rehearsal_.solving() == Solving::unsettled) {
    return tr(
        "This picture is not at rest, and the liver may slip farther than is shown. Press less, or move the tool a "
        "little.");
  }
  return {};
}

}  // namespace glisson::widgets

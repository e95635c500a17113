#include "widgets/guide/guide_panel.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "widgets/panels/parts.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {
namespace {

constexpr double tolerances_mm[] = {10, 5, 3};  // the dissertation's, section 2.3

}  // namespace

GuidePanel::GuidePanel(QWidget* parent) : QWidget(parent) {
  setObjectName("panel");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(14, 14, 14, 14);
  column->setSpacing(7);
  add_placing(*column);
  column->addSpacing(8);
  add_look(*column);
  column->addStretch(1);
  film_ = named_button("guide_film");
  column->addWidget(film_);
  connect(film_, &QPushButton::clicked, this, &GuidePanel::film_wanted);
  keep_translated(this, [this] { update_text(); });
}

void GuidePanel::add_placing(QVBoxLayout& column) {
  QLabel* title = heading();
  column.addWidget(title);
  place_ = named_button("primary");
  column.addWidget(place_);
  auto* work = new QHBoxLayout;
  progress_ = new QProgressBar;
  progress_->setRange(0, 1000);
  progress_->setTextVisible(false);
  cancel_ = named_button("cancel_guiding");
  work->addWidget(progress_, 1);
  work->addWidget(cancel_);
  column.addLayout(work);
  stage_ = wrapped_label("faint");
  column.addWidget(stage_);
  auto* hand = new QHBoxLayout;
  by_hand_ = named_button("by_hand");
  by_hand_->setCheckable(true);
  refine_ = named_button("refine");
  hand->addWidget(by_hand_, 1);
  hand->addWidget(refine_, 1);
  column.addLayout(hand);
  hand_help_ = wrapped_label("faint");
  column.addWidget(hand_help_);
  lines_ = new LinePanel;
  column.addWidget(lines_);
  connect(place_, &QPushButton::clicked, this, &GuidePanel::placing_wanted);
  connect(refine_, &QPushButton::clicked, this, &GuidePanel::refining_wanted);
  connect(cancel_, &QPushButton::clicked, this, &GuidePanel::cancel_wanted);
  connect(by_hand_, &QPushButton::toggled, this, [this](bool by_hand) {
    update_text();
    Q_EMIT by_hand_changed(by_hand);
  });
  keep_translated(place_, [=, this] {
    title->setText(tr("The liver on the frames"));
    place_->setText(tr("Place the liver"));
    progress_->setAccessibleName(tr("Progress"));
    cancel_->setText(tr("Cancel"));
    cancel_->setToolTip(tr("Stops here; frames that are placed already stay"));
    by_hand_->setText(tr("Place by hand"));
    by_hand_->setToolTip(tr("Lay the liver over the frame yourself, where it is not found or found wrong"));
    refine_->setText(tr("Refine"));
    hand_help_->setText(
        tr("Drag: move. Right drag or Shift: turn. Wheel: nearer, farther. Ctrl and wheel: turn in the picture. Arrow "
           "keys, + and - do the same in steps."));
  });
}

void GuidePanel::add_look(QVBoxLayout& column) {
  shown_ = new QCheckBox;
  shown_->setObjectName("outlines_shown");
  shown_->setChecked(true);
  auto* row = new QHBoxLayout;
  row->addWidget(shown_);
  opacity_ = new QSlider(Qt::Horizontal);
  opacity_->setObjectName("outlines_opacity");
  opacity_->setRange(10, 100);
  opacity_->setValue(100);
  row->addWidget(opacity_, 1);
  column.addLayout(row);
  auto* label = new QLabel;
  column.addWidget(label);
  auto* group = new QButtonGroup(this);
  auto* choices = new QHBoxLayout;
  choices->setSpacing(0);
  for (const double mm : tolerances_mm) {
    auto* choice = named_button(qPrintable(QString("guide_tolerance_%1").arg(mm)));
    choice->setCheckable(true);
    choice->setProperty("segment", tolerances_.empty() ? "first" : mm == 3 ? "last" : "middle");
    group->addButton(choice);
    choices->addWidget(choice, 1);
    tolerances_.push_back(choice);
  }
  tolerances_[1]->setChecked(true);
  column.addLayout(choices);
  targets_ = new TargetTable;
  targets_->setObjectName("guide_targets");
  column.addWidget(targets_);
  connect(shown_, &QCheckBox::toggled, this, &GuidePanel::look_changed);
  connect(opacity_, &QSlider::valueChanged, this, &GuidePanel::look_changed);
  connect(group, &QButtonGroup::buttonToggled, this, [this](const QAbstractButton* /*which*/, bool on) {
    if (on) Q_EMIT look_changed();
  });
  keep_translated(shown_, [=, this] {
    shown_->setText(tr("Outlines"));
    shown_->setToolTip(tr("Shows or hides what is drawn over the frame (O)"));
    opacity_->setAccessibleName(tr("Opacity of the outlines"));
    opacity_->setToolTip(tr("How strong the outlines stand on the frame"));
    label->setText(tr("Trusted up to an error of"));
    for (std::size_t i = 0; i < tolerances_.size(); ++i) {
      tolerances_[i]->setText(tr("%1 mm").arg(tolerances_mm[i]));
      tolerances_[i]->setToolTip(
          tr("Outlines are dashed where 90 % of such places would be off by more than %1 mm").arg(tolerances_mm[i]));
    }
  });
}

OverlayLook GuidePanel::look() const {
  OverlayLook look{shown_->isChecked(), opacity_->value() / 100.0, 5};
  for (std::size_t i = 0; i < tolerances_.size(); ++i) {
    if (tolerances_[i]->isChecked()) look.tolerance_mm = tolerances_mm[i];
  }
  return look;
}

void GuidePanel::show_state(const State& state) {
  if (state.work != state_.work && state.work != Work::none) show_progress(0, {});
  state_ = state;
  update_text();
}

void GuidePanel::show_progress(double fraction, const QString& stage) {
  progress_->setValue(static_cast<int>(1000 * fraction));
  stage_->setText(translated_stage(stage));
}

void GuidePanel::update_text() {
  const bool works = state_.work != Work::none;
  const QString under_way = tr("It is being computed");
  const QString no_camera = tr("The sequence names no camera, so that nothing can be drawn over the video.");
  place_->setEnabled(!works);
  place_->setToolTip(works
                         ? under_way
                         : tr("Finds where the liver lies in the first frame, without a guess or by the lines that are "
                              "marked, and follows it from frame to frame"));
  by_hand_->setEnabled(!works && state_.has_camera);
  if (!state_.has_camera) by_hand_->setToolTip(no_camera);
  lines_->set_allowed(!works && state_.has_camera, works ? under_way : no_camera);
  refine_->setEnabled(!works && state_.has_hand_pose);
  refine_->setToolTip(works                   ? under_way
                      : !state_.has_hand_pose ? tr("Place the liver by hand first")
                                              : tr("Fits the liver from where you laid it, and follows it from there"));
  hand_help_->setVisible(by_hand_->isChecked());
  film_->setText(tr("Save a video..."));
  film_->setEnabled(!works && state_.anything_placed && state_.has_camera);
  film_->setToolTip(works                ? under_way
                    : !state_.has_camera ? no_camera
                    : !state_.anything_placed
                        ? tr("Place the liver first")
                        : tr("All frames with their outlines as they are shown now, MP4 or pictures"));
  for (QWidget* part :
       {static_cast<QWidget*>(progress_), static_cast<QWidget*>(cancel_), static_cast<QWidget*>(stage_)}) {
    part->setVisible(works);
  }
}

}  // namespace glisson::widgets

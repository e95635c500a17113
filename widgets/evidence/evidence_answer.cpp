#include "widgets/evidence/evidence_answer.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QVBoxLayout>
#include <set>

#include "widgets/evidence/effect_words.h"
#include "widgets/evidence/svg_view.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/numbers.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {
namespace {

QLabel* label(const char* name, QWidget* parent) {
  auto* made = new QLabel(parent);
  made->setObjectName(name);
  made->setWordWrap(true);
  made->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return made;
}

}  // namespace

EvidenceAnswer::EvidenceAnswer(QWidget* parent) : QScrollArea(parent) {
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  auto* page = new QWidget;
  page->setObjectName("panel");
  setWidget(page);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(18, 14, 18, 14);
  column->setSpacing(10);
  verdict_ = label("patient_name", page);
  column->addWidget(verdict_);
  probabilities_ = new ProbabilityBars(page);
  column->addWidget(probabilities_);
  details_ = new QCheckBox(page);
  details_->setObjectName("evidence_details");
  column->addWidget(details_);
  connect(details_, &QCheckBox::toggled, this, &EvidenceAnswer::update_text);
  shape_ = label("faint", page);
  column->addWidget(shape_);
  across_ = new QSplitter(Qt::Horizontal, page);
  across_->setChildrenCollapsible(false);
  residual_ = make_residual();
  across_->addWidget(residual_);
  drawings_ = new QWidget;
  new QVBoxLayout(drawings_);
  drawings_->layout()->setContentsMargins(0, 0, 0, 0);
  across_->addWidget(drawings_);
  across_->addWidget(make_numbers());
  for (int part = 0; part < 3; ++part) across_->setStretchFactor(part, 1);
  column->addWidget(across_, 1);
  candidates_title_ = label("heading", page);
  column->addWidget(candidates_title_);
  candidates_ = new CandidatesTable(page);
  column->addWidget(candidates_);
  visible_title_ = label("heading", page);
  column->addWidget(visible_title_);
  visible_ = new VisibleTable(page);
  column->addWidget(visible_);
  next_title_ = label("heading", page);
  column->addWidget(next_title_);
  next_ = label("next_measurement", page);
  column->addWidget(next_);
  notes_ = label("faint", page);
  column->addWidget(notes_);
  keep_translated(this, [this] { update_text(); });
}

QWidget* EvidenceAnswer::make_residual() {
  auto* group = new QWidget;
  auto* column = new QVBoxLayout(group);
  column->setContentsMargins(0, 0, 0, 0);
  auto* row = new QHBoxLayout;
  trial_ = new QComboBox(group);
  trial_->setObjectName("evidence_trial");
  row->addWidget(trial_, 1);
  before_ = new QPushButton(group);
  before_->setObjectName("evidence_before");
  before_->setProperty("segment", "first");
  after_ = new QPushButton(group);
  after_->setObjectName("evidence_after");
  after_->setProperty("segment", "last");
  auto* which = new QButtonGroup(group);
  auto* segments = new QHBoxLayout;
  segments->setSpacing(0);
  for (QPushButton* button : {before_, after_}) {
    button->setCheckable(true);
    which->addButton(button);
    segments->addWidget(button);
  }
  before_->setChecked(true);
  row->addLayout(segments);
  column->addLayout(row);
  space_ = new SpaceView(group);
  space_->setObjectName("residual_space");
  space_->setMinimumHeight(320);
  column->addWidget(space_, 1);
  scale_text_ = label("faint", group);
  column->addWidget(scale_text_);
  connect(trial_, &QComboBox::currentIndexChanged, this, &EvidenceAnswer::show_residual);
  connect(which, &QButtonGroup::buttonClicked, this, &EvidenceAnswer::show_residual);
  return group;
}

QWidget* EvidenceAnswer::make_numbers() {
  auto* group = new QWidget;
  auto* column = new QVBoxLayout(group);
  column->setContentsMargins(0, 0, 0, 0);
  errors_ = new ErrorsTable(group);
  column->addWidget(errors_);
  auto* title = label("heading", group);
  column->addWidget(title);
  found_ = new FoundTree(group);
  found_->setMinimumHeight(130);
  column->addWidget(found_, 1);
  keep_translated(group, [title] { title->setText(tr("What was found")); });
  group->setMinimumWidth(430);
  return group;
}

void EvidenceAnswer::show_record(std::shared_ptr<const EvidenceRecord> record,
                                 std::shared_ptr<const closedloop::Explained> explained) {
  record_ = std::move(record);
  explained_ = std::move(explained);
  const bool in_space = explained_ && has_residual_scene(*explained_);
  residual_->setVisible(in_space);
  {
    const QSignalBlocker quiet(trial_);
    trial_->clear();
    if (in_space) {
      for (const std::string& trial : explained_->model->observations().trials) {
        trial_->addItem(QString::fromStdString(trial));
      }
      trial_->setCurrentIndex(static_cast<int>(worst_trial(*explained_)));
    }
  }
  before_->setChecked(true);
  show_drawings();
  update_text();
  across_->setSizes(in_space ? QList<int>{520, 330, 460} : QList<int>{0, 660, 560});
  if (in_space) {
    show_residual();
    space_->frame_all();
  }
}

void EvidenceAnswer::reword(std::shared_ptr<const EvidenceRecord> record) {
  record_ = std::move(record);
  show_drawings();
}

void EvidenceAnswer::show_residual() {
  if (!explained_ || trial_->currentIndex() < 0) return;
  const auto made = residual_scene(*explained_, static_cast<std::size_t>(trial_->currentIndex()),
                                   before_->isChecked() ? ResidualOf::declared : ResidualOf::better,
                                   tr("Residual (mm)").toStdString());
  space_->show_scene(made.scene);
  scale_text_->setText(
      tr("Measured less predicted, where this trial was farthest off. Arrows %1 times as long as they are; "
         "colours reach to %2 mm, between markers interpolated.")
          .arg(made.magnification, 0, 'g', 2)
          .arg(made.largest_mm, 0, 'g', 2));
}

void EvidenceAnswer::show_drawings() {
  qDeleteAll(drawings_->findChildren<SvgView*>());
  // In space what is left stands already; the last drawing is the error by load.
  const bool in_space = explained_ && has_residual_scene(*explained_);
  const auto& drawings = record_->drawings;
  for (std::size_t k = in_space && !drawings.empty() ? drawings.size() - 1 : 0; k < drawings.size(); ++k) {
    drawings_->layout()->addWidget(new SvgView(drawings[k], drawings_));
  }
  drawings_->setVisible(!drawings.empty());
}

QString EvidenceAnswer::next_measurement(const EvidenceRecord& record) {
  static const std::set<std::string> proposed{"palpation", "material", "platform"};
  if (!proposed.contains(record.experiment_kind))
    return tr("Of experiments of this sort no further trial is proposed.");
  if (record.next.empty()) return tr("No further trial is known that would tell the leading explanations apart.");
  QStringList lines;
  for (const EvidenceNextTrial& next : record.next) {
    QString line = translated(next.sentence);
    if (!next.tells_apart.empty())
      line = tr("%1 It would tell what is likeliest from: %2.").arg(line, effect_labels(next.tells_apart));
    if (next.doubt_removed)
      line = tr("%1 Of the doubt %2 % is expected to be gone then.").arg(line, number(100 * *next.doubt_removed, 0));
    lines << line;
  }
  return lines.join("\n");
}

void EvidenceAnswer::update_text() {
  before_->setText(tr("Before"));
  after_->setText(tr("After"));
  details_->setText(tr("Details"));
  candidates_title_->setText(tr("Suspects"));
  candidates_->setAccessibleName(tr("Suspects"));
  visible_title_->setText(tr("What these trials could have shown"));
  visible_->setAccessibleName(tr("What these trials could have shown"));
  trial_->setAccessibleName(tr("Trial that is shown"));
  space_->setAccessibleName(tr("What is left, in space"));
  errors_->setAccessibleName(tr("The error before and after"));
  if (!record_) return;
  const EvidenceRecord& record = *record_;
  const QString before = with_unit(record.before.rms, record), after = with_unit(record.after.rms, record);
  const bool nothing_missing = record.verdict == "nothing-missing", explained = record.verdict == "explained";
  std::vector<std::string> kinds;
  for (const EvidenceEffect& effect : record.effects) kinds.push_back(effect.kind);
  const QString title = QString::fromStdString(record.title);
  const double share = record.before.rms > 0 ? 100 * (1 - record.after.rms / record.before.rms) : 0;
  const QString percent = QString::number(share, 'f', 0);
  verdict_->setText(
      nothing_missing ? tr("Nothing is missing: what the declared model leaves, %1, shows no effect.").arg(before)
      : kinds.empty()
          ? tr("%1: something acts, but no effect that Glisson knows is probable enough to be named.").arg(title)
      : explained ? tr("%1: %2. This takes away %3 % of the error.").arg(title, effect_labels(kinds), percent)
                  : tr("%1: %2 takes away %3 % of the error, but is not probable enough to be called the cause.")
                        .arg(title, effect_labels(kinds), percent));
  verdict_->setToolTip(tr("The error falls from %1 to %2.").arg(before, after));
  const auto shape = [](const std::vector<std::string>& features) {
    QStringList words;
    for (const std::string& feature : features) words << translated(feature);
    return words.join("; ");
  };
  shape_->setText(record.shape_before.empty()
                      ? tr("No test finds anything in it that noise would not do.")
                      : tr("What the declared model leaves is not noise: %1.").arg(shape(record.shape_before)) +
                            (record.shape_after.empty()
                                 ? QString()
                                 : " " + tr("What is left at the end: %1.").arg(shape(record.shape_after))));
  probabilities_->show_record(record);
  errors_->show_record(record);
  found_->show_record(record);
  candidates_->show_record(record);
  for (QWidget* each : std::initializer_list<QWidget*>{candidates_title_, candidates_}) {
    each->setVisible(!record.ranking.empty() && details_->isChecked());
  }
  for (QWidget* each : std::initializer_list<QWidget*>{shape_, errors_}) each->setVisible(details_->isChecked());
  visible_->show_record(record);
  for (QWidget* each : std::initializer_list<QWidget*>{visible_title_, visible_})
    each->setVisible(!record.visible.empty());
  next_title_->setText(tr("What to measure next"));
  next_->setText(next_measurement(record));
  QStringList notes;
  for (Sentence note : record.notes) {
    for (std::string& named : note.arguments) named = effect_or_parameter_label(named).toStdString();
    notes << translated(note);
  }
  notes_->setText(notes.join("\n"));
  notes_->setVisible(!notes.isEmpty() && details_->isChecked());
  if (explained_ && has_residual_scene(*explained_)) show_residual();
}

}  // namespace glisson::widgets

#include "widgets/session/undo.h"

#include <QJsonArray>
#include <QJsonDocument>

#include "widgets/words/translated.h"
#include "widgets/work/run_in_background.h"

namespace glisson::widgets {
namespace {

// A JSON document is an array or an object: a bare value travels in an array of one.
std::string json_text(const QJsonValue& value) {
  return QJsonDocument(QJsonArray{value}).toJson(QJsonDocument::Compact).toStdString();
}

QJsonValue value_of(const std::string& text) {
  const QJsonArray holder = QJsonDocument::fromJson(QByteArray::fromStdString(text)).array();
  return holder.isEmpty() ? QJsonValue(QJsonValue::Undefined) : holder.first();
}

}  // namespace

Undo::Undo(QObject* parent) : QObject(parent), undo_action_(new QAction(this)), redo_action_(new QAction(this)) {
  thread_.setMaxThreadCount(1);
  undo_action_->setObjectName("undo");
  redo_action_->setObjectName("redo");
  undo_action_->setShortcut(QKeySequence("Ctrl+Z"));
  redo_action_->setShortcuts({QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")});
  connect(undo_action_, &QAction::triggered, this, &Undo::undo);
  connect(redo_action_, &QAction::triggered, this, &Undo::redo);
  name_actions();
}

Undo::~Undo() { wait(); }

void Undo::open_case(const std::filesystem::path& case_folder) {
  if (case_folder == folder_ && (history_ != nullptr || case_folder.empty())) return name_actions();
  wait();
  history_.reset();
  folder_ = case_folder;
  if (!case_folder.empty()) {
    auto opened = casefile::History::open(case_folder);
    if (opened) {
      history_ = *std::move(opened);
    } else {
      Q_EMIT failed(opened.error());
    }
  }
  for (const auto& [key, apply] : keepers_) {
    if (const QJsonValue known = value(key); !known.isUndefined()) apply(known);
  }
  name_actions();
}

Result<void> Undo::recorded(const Sentence& name, const std::function<Result<void>()>& change,
                            const std::vector<std::string>& touches) {
  const auto history = history_;
  return history ? history->record(name, change, touches) : change();
}

void Undo::change(const Sentence& name, const std::vector<std::string>& touches, std::function<Result<void>()> change,
                  std::function<void(const Result<void>&)> then) {
  queue([this, history = history_, refused = refused_, name, touches, change = std::move(change),
         then = std::move(then)] {
    const Result<void> outcome = refused   ? Result<void>(failure(*refused))
                                 : history ? history->record(name, change, touches)
                                           : change();
    return [this, outcome, then] {
      if (!outcome) Q_EMIT failed(outcome.error());
      if (then) then(outcome);
    };
  });
}

void Undo::value_changed(const Sentence& name, const QString& key, const QJsonValue& before, const QJsonValue& after,
                         Joins joins) {
  values_changed(name, {{key, before, after}}, joins);
}

void Undo::values_changed(const Sentence& name, const std::vector<Changed>& values, Joins joins,
                          const std::optional<casefile::RecordingBeside>& beside) {
  std::vector<casefile::ValueChange> changes;
  for (const Changed& value : values) {
    if (value.before != value.after) {
      changes.push_back({value.key.toStdString(), json_text(value.before), json_text(value.after)});
    }
  }
  if (!history_ || refused_ || changes.empty()) return;
  queue([this, history = history_, name, changes, joins, beside]() -> std::function<void()> {
    const auto outcome = history->record_values(
        name, changes,
        joins == Joins::with_same ? casefile::History::Joins::last_of_same_keys : casefile::History::Joins::no, beside);
    return [this, outcome] {
      if (!outcome) Q_EMIT failed(outcome.error());
    };
  });
}

void Undo::keep(const QString& key, std::function<void(const QJsonValue&)> apply) { keepers_[key] = std::move(apply); }

QJsonValue Undo::value(const QString& key) const {
  return history_ ? value_of(history_->value_of(key.toStdString())) : QJsonValue(QJsonValue::Undefined);
}

void Undo::undo() { go(Way::back); }
void Undo::redo() { go(Way::forth); }

void Undo::go(Way way) {
  if (!history_ || refused_ || held_up_) return;
  ++moving_;
  queue([this, history = history_, way]() -> std::function<void()> {
    const auto outcome = way == Way::back ? history->undo() : history->redo();
    return [this, outcome, way] {
      --moving_;
      if (!outcome) {
        if (outcome.error().code != "history-nothing-left") Q_EMIT failed(outcome.error());
        return;
      }
      for (const casefile::ValueChange& value : outcome->values) {
        const auto keeper = keepers_.find(QString::fromStdString(value.key));
        if (keeper != keepers_.end()) keeper->second(value_of(value.after));
      }
      QStringList ids;
      for (const std::string& id : outcome->entries) ids << QString::fromStdString(id);
      if (!ids.isEmpty()) Q_EMIT entries_moved(ids);
      Q_EMIT moved(way == Way::back ? tr("Undone: %1").arg(translated(outcome->name))
                                    : tr("Done again: %1").arg(translated(outcome->name)));
    };
  });
}

void Undo::queue(std::function<std::function<void()>()> work) {
  ++waiting_;
  run_in_background(this, &thread_, std::move(work), [this](const std::function<void()>& then) {
    --waiting_;
    if (then) then();
    name_actions();
    if (waiting_ == 0) Q_EMIT settled();
  });
}

void Undo::set_held_up(bool held_up) {
  held_up_ = held_up;
  name_actions();
}

void Undo::refuse(const std::optional<Error>& why) {
  refused_ = why;
  name_actions();
}

void Undo::wait() { thread_.waitForDone(); }

void Undo::name_actions() {
  const auto undoes = history_ ? history_->undo_name() : std::nullopt;
  const auto redoes = history_ ? history_->redo_name() : std::nullopt;
  undo_action_->setText(undoes ? tr("&Undo: %1").arg(translated(*undoes)) : tr("&Undo"));
  redo_action_->setText(redoes ? tr("&Redo: %1").arg(translated(*redoes)) : tr("&Redo"));
  undo_action_->setEnabled(undoes.has_value() && !held_up_ && !refused_);
  redo_action_->setEnabled(redoes.has_value() && !held_up_ && !refused_);
}

}  // namespace glisson::widgets

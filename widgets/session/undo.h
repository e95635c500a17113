#pragma once
// Undo and redo across the window: one history a case, kept in its folder (casefile/history.h), with Ctrl+Z anywhere.
//
// A workspace changes a case in one of three ways and has nothing more to do for it to be undone:
//
//   context.change(tr("Building the model"), loader);      // long work: recorded under its title, the patient shown
//   anew
//
//   context.undo.change({GLISSON_TEXT("Brush on {0}"), {"liver"}}, {"labels/liver"}, save, [](const auto& outcome)
//   {...});
//                                                         // short work on files, in order, beside the person's own
//
//   context.undo.keep("rehearse/force", [this](const QJsonValue& now) { panel_->set_force(now.toDouble()); });
//   context.undo.value_changed({GLISSON_TEXT("Force"), {}}, "rehearse/force", 1.0, 2.0, Undo::Joins::with_same);
//                                                         // a small value that lives in a workspace
//
// keep() is called back with the value whenever it is undone or redone. It is called once more when a case is opened in
// which it was ever set. Texts of names are GLISSON_TEXT, so that the menu names them in the language of now.

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <QAction>
#include <QJsonValue>
#include <QObject>
#include <QStringList>
#include <QThreadPool>
#include <string>
#include <vector>

#include "base/sentence.h"
#include "casefile/history.h"

namespace glisson::widgets {

class Undo : public QObject {
  Q_OBJECT

 public:
  explicit Undo(QObject* parent = nullptr);
  ~Undo() override;  // waits for what is being written

  // The history of this case from here on; an empty path: none. The same folder again changes nothing.
  void open_case(const std::filesystem::path& case_folder);

  // Any thread: runs the change where it is called, as one step. Without a case it only runs.
  Result<void> recorded(const Sentence& name, const std::function<Result<void>()>& change,
                        const std::vector<std::string>& touches = {});

  // The UI thread: the same on a thread that works these off in their order; `then` comes back here.
  void change(const Sentence& name, const std::vector<std::string>& touches, std::function<Result<void>()> change,
              std::function<void(const Result<void>&)> then = {});

  enum class Joins { never, with_same };  // with_same: one step with the last, where that was of the same key
  void value_changed(const Sentence& name, const QString& key, const QJsonValue& before, const QJsonValue& after,
                     Joins joins = Joins::never);
  // Several that change at once: one step of those that did.
  struct Changed {
    QString key;
    QJsonValue before, after;
  };
  // `beside`: what led to them and is too long for a value.
  void values_changed(const Sentence& name, const std::vector<Changed>& values, Joins joins = Joins::never,
                      const std::optional<casefile::RecordingBeside>& beside = {});
  void keep(const QString& key, std::function<void(const QJsonValue&)> apply);
  // What the case remembers of it; undefined where nothing.
  [[nodiscard]] QJsonValue value(const QString& key) const;

  void undo();
  void redo();
  // For the Edit menu: named after the step, dimmed where there is none or while the case is being changed otherwise.
  [[nodiscard]] QAction* undo_action() const { return undo_action_; }
  [[nodiscard]] QAction* redo_action() const { return redo_action_; }
  // Whether anything waits to be written or undone.
  [[nodiscard]] bool busy() const { return waiting_ > 0; }
  // Whether an undo or redo is under way: what is shown may be about to change.
  [[nodiscard]] bool moving() const { return moving_ > 0; }
  void name_actions();  // in the language of now
  // Nothing of the case is changed any more, for this reason: each attempt fails with it. Nothing: it may be again.
  void refuse(const std::optional<Error>& why);
  void set_held_up(bool held_up);  // by long work on the case
  void wait();                     // until all is written; its outcomes come when the event loop turns

 Q_SIGNALS:
  void entries_moved(const QStringList& ids);  // by an undo or redo: read them again
  void moved(const QString& what);             // "Undone: Brush on liver"
  void failed(const glisson::Error& error);
  void settled();  // nothing waits any more

 private:
  enum class Way { back, forth };
  void go(Way way);
  // Runs `work` in turn on the thread of the history, and what it returns here.
  void queue(std::function<std::function<void()>()> work);

  std::filesystem::path folder_;
  std::shared_ptr<casefile::History> history_;
  std::map<QString, std::function<void(const QJsonValue&)>> keepers_;
  QThreadPool thread_;
  QAction* undo_action_;
  QAction* redo_action_;
  int waiting_ = 0;
  int moving_ = 0;
  bool held_up_ = false;
  std::optional<Error> refused_;
};

}  // namespace glisson::widgets

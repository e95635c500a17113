#pragma once
// What happened in the window, for whoever looks into a problem later. It says which workspace, which work and how long
// it took, what went wrong, and when the window stood still. Nothing about a patient can get in. An entry is a sentence
// of this program with its values left out, an error's code, or a duration. There is no path, no name, no number of the
// patient's.

#include <deque>
#include <QDateTime>
#include <QObject>
#include <QString>

#include "base/result.h"

namespace glisson::widgets {

struct DiaryEntry {
  enum class Kind { event, error, defect, stall };
  QDateTime when;
  Kind kind = Kind::event;
  QString text;  // English, for whoever mends it
};

class Diary : public QObject {
  Q_OBJECT

 public:
  // Keeps `most` entries and forgets the oldest; writes each to `file` too, which is begun anew at 1 MiB (empty: none).
  explicit Diary(QString file = {}, QObject* parent = nullptr, std::size_t maximum = 2000);

  // A literal of this program, so that nothing else can be written by mistake; `took_ms` is left out below 0.
  template <std::size_t length>
  void note(const char (&event)[length], double took_ms = -1) {
    add(DiaryEntry::Kind::event, QString::fromUtf8(event), took_ms);
  }
  void note(const Error& error);  // its code and sentence, the values as {0}, {1}
  void note_defect();             // an exception came out of the work; its words may hold anything, and are left out
  void note_stall(double stood_ms);

  [[nodiscard]] const std::deque<DiaryEntry>& entries() const { return entries_; }

 Q_SIGNALS:
  void added();

 private:
  void add(DiaryEntry::Kind kind, QString text, double took_ms = -1);

  QString file_;
  std::size_t maximum_;
  std::deque<DiaryEntry> entries_;
};

// One line of it: "21:04:07  error  mesh-empty: The structure {0} holds no voxels."
[[nodiscard]] QString line_of(const DiaryEntry& entry);

// All that a report of a problem holds: this program and what it stands on, the machine, and the diary.
[[nodiscard]] QString problem_report(const Diary& diary, const QString& graphics);

}  // namespace glisson::widgets

#include "widgets/diary/diary.h"

#include <QFile>
#include <QFileInfo>
#include <QStringList>
#include <QSysInfo>
#include <QThread>
#include <utility>

#include "base/files.h"
#include "scene/painter.h"

namespace glisson::widgets {
namespace {

constexpr qint64 maximum_diary_bytes = 1 << 20;

const char* name_of(DiaryEntry::Kind kind) {
  switch (kind) {
    case DiaryEntry::Kind::event: return "event";
    case DiaryEntry::Kind::error: return "error";
    case DiaryEntry::Kind::defect: return "defect";
    case DiaryEntry::Kind::stall: return "stall";
  }
  return "";
}

}  // namespace

Diary::Diary(QString file, QObject* parent, std::size_t maximum)
    : QObject(parent), file_(std::move(file)), maximum_(maximum) {}

void Diary::note(const Error& error) {
  if (error.code == "cancelled") return note("Cancelled.");
  add(DiaryEntry::Kind::error,
      QString("%1: %2").arg(QString::fromStdString(error.code), QString::fromStdString(error.text)));
}

// not translated
void Diary::note_defect() { add(DiaryEntry::Kind::defect, "An exception came out of the work."); }

// not translated
void Diary::note_stall(double stood_ms) { add(DiaryEntry::Kind::stall, "The window stood still.", stood_ms); }

void Diary::add(DiaryEntry::Kind kind, QString text, double took_ms) {
  if (took_ms >= 0) text += QString(" %1 ms").arg(took_ms, 0, 'f', 0);
  entries_.push_back({QDateTime::currentDateTime(), kind, std::move(text)});
  if (entries_.size() > maximum_) entries_.pop_front();
  if (!file_.isEmpty()) {
    QFile file(file_);
    const bool anew = QFileInfo(file_).size() > maximum_diary_bytes;
    if (file.open(anew ? QIODevice::WriteOnly : QIODevice::Append))
      file.write((line_of(entries_.back()) + '\n').toUtf8());
  }
  Q_EMIT added();
}

QString line_of(const DiaryEntry& entry) {
  return QString("%1  %2  %3")
      // not translated
      .arg(entry.when.toString("yyyy-MM-dd hh:mm:ss"), QString(name_of(entry.kind)).leftJustified(6), entry.text);
}

QString problem_report(const Diary& diary, const QString& graphics) {
  QStringList lines{
      QString("Glisson %1").arg(QString::fromStdString(version())),
      QString("Qt %1, %2").arg(qVersion(), QString::fromStdString(scene::drawing_library())),
      QString("%1, %2, %3 processors")
          .arg(QSysInfo::prettyProductName(), QSysInfo::currentCpuArchitecture())
          .arg(QThread::idealThreadCount()),
      QString("Graphics: %1").arg(graphics),
      QString(),
      // not translated
      QString("What happened, without patients, names, paths or values:"),
  };
  for (const DiaryEntry& entry : diary.entries()) lines << line_of(entry);
  return lines.join('\n') + '\n';
}

}  // namespace glisson::widgets

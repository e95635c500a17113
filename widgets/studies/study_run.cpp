#include "widgets/studies/study_run.h"

#include <unistd.h>
#include <csignal>
#include <QCoreApplication>
#include <QRegularExpression>

namespace glisson::widgets {

StudyRun::StudyRun(QObject* parent) : QObject(parent) {
  process_.setProgram(QCoreApplication::applicationDirPath() + "/glisson-cli");
  process_.setChildProcessModifier([] { (void)nice(5); });  // the window comes first
  connect(&process_, &QProcess::readyReadStandardError, this, &StudyRun::read);
  connect(&process_, &QProcess::readyReadStandardOutput, this, [this] { process_.readAllStandardOutput(); });
  connect(&process_, &QProcess::finished, this, [this](int code, QProcess::ExitStatus status) {
    read();
    end(status == QProcess::NormalExit && code == 0);
  });
  connect(&process_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error != QProcess::FailedToStart) return;  // of any other, finished() tells
    trouble_ =
        tr("%1 could not be started: it belongs beside this program. Install Glisson again.").arg(process_.program());
    end(false);
  });
}

StudyRun::~StudyRun() {
  process_.disconnect(this);
  if (!running()) return;
  stop();
  if (!process_.waitForFinished(2000)) process_.kill();
  process_.waitForFinished(1000);
}

void StudyRun::start(const QStringList& arguments) {
  if (running()) return;
  line_.clear();
  trouble_.clear();
  stopped_ = false;
  process_.start(process_.program(), arguments);
}

void StudyRun::stop() {
  if (process_.state() == QProcess::Starting) process_.waitForStarted(1000);
  if (process_.processId() <= 0) return;
  stopped_ = true;
  (void)::kill(static_cast<pid_t>(process_.processId()), SIGINT);
}

// " 40 % Patient: 12" a stage; whatever else it says in the end is why it failed.
void StudyRun::read() {
  static const QRegularExpression stage("^\\s*(\\d{1,3}) % (.*)$");
  line_ += process_.readAllStandardError();
  for (qsizetype end = line_.indexOf('\n'); end >= 0; end = line_.indexOf('\n')) {
    const QString line = QString::fromUtf8(line_.left(end));
    line_.remove(0, end + 1);
    const auto found = stage.match(line);
    if (found.hasMatch()) {
      Q_EMIT progressed(found.captured(1).toInt() / 100.0, found.captured(2));
    } else if (line.startsWith("glisson-cli: ")) {
      trouble_ = line.mid(13);
    }
  }
  if (line_.size() > 65536) line_.clear();
}

void StudyRun::end(bool done) {
  if (!done && !stopped_ && trouble_.isEmpty()) trouble_ = tr("The study ended without saying why. Start it again.");
  Q_EMIT ended(done, stopped_ ? QString() : trouble_);
}

}  // namespace glisson::widgets

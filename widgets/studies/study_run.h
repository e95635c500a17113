#pragma once
// One study at work, as a process of glisson-cli beside the window: it takes hours, and the window stays free
// meanwhile. What it has done lies in its folder; stopped, and started again, it goes on there.

#include <QByteArray>
#include <QObject>
#include <QProcess>
#include <QStringList>

namespace glisson::widgets {

class StudyRun : public QObject {
  Q_OBJECT

 public:
  explicit StudyRun(QObject* parent = nullptr);
  StudyRun(const StudyRun&) = delete;
  StudyRun& operator=(const StudyRun&) = delete;
  ~StudyRun() override;  // stops it

  void start(const QStringList& arguments);
  void stop();  // as Ctrl-C would: ended() comes when it has put down what it held
  [[nodiscard]] bool running() const { return process_.state() != QProcess::NotRunning; }

 Q_SIGNALS:
  void progressed(double fraction, const QString& stage);
  // In the words of glisson-cli; empty where it came to its end, or was stopped.
  void ended(bool done, const QString& trouble);

 private:
  void read();
  void end(bool done);

  QProcess process_;
  QByteArray line_;  // as far as it has come
  QString trouble_;
  bool stopped_ = false;
};

}  // namespace glisson::widgets

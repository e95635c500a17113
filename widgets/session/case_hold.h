#pragma once
// Whether this window may change the case that it shows. One window a case may: the first that opened it, on whatever
// computer; a second only looks. Nor may any where the folder takes no files, or is gone.

#include <filesystem>
#include <memory>
#include <optional>
#include <QFileSystemWatcher>
#include <QLockFile>
#include <QObject>

#include "base/result.h"

namespace glisson::widgets {

class CaseHold : public QObject {
  Q_OBJECT

 public:
  explicit CaseHold(QObject* parent = nullptr);

  // Lets go of the case before; an empty folder is no case. The same folder again changes nothing.
  void take(const std::filesystem::path& folder);

  // Why nothing of it can be changed: "case-open-elsewhere", "case-read-only" or "case-gone"; nothing where it can.
  [[nodiscard]] const std::optional<Error>& refusal() const { return refusal_; }

 Q_SIGNALS:
  void changed();  // refusal() is another

 private:
  void look_whether_it_is_there();
  void refuse(std::optional<Error> why);

  std::filesystem::path folder_;
  std::unique_ptr<QLockFile> lock_;
  QFileSystemWatcher watcher_;
  std::optional<Error> refusal_;
};

}  // namespace glisson::widgets

#include "widgets/session/case_hold.h"

#include "widgets/words/paths.h"

namespace glisson::widgets {
namespace {

namespace fs = std::filesystem;

constexpr const char* lock_name = ".window.lock";

Error open_elsewhere(const fs::path& folder) {
  return {"case-open-elsewhere",
          GLISSON_TEXT("Another window has {0} open: here it can be looked at, and nothing is changed."),
          {folder.filename().string()},
          GLISSON_TEXT("Close it there and open it here again."),
          folder};
}

Error read_only(const fs::path& folder) {
  return {"case-read-only",
          GLISSON_TEXT("The folder of {0} takes no files: the case can be looked at, and nothing is kept."),
          {folder.filename().string()},
          GLISSON_TEXT("Copy it to where you may write, and open the copy."),
          folder};
}

Error gone(const fs::path& folder) {
  return {"case-gone",
          GLISSON_TEXT("The folder {0} is gone: nothing more of this case can be kept."),
          {folder.string()},
          GLISSON_TEXT("Bring it back to its place, or open the case where it is now."),
          folder};
}

}  // namespace

CaseHold::CaseHold(QObject* parent) : QObject(parent) {
  connect(&watcher_, &QFileSystemWatcher::directoryChanged, this, &CaseHold::look_whether_it_is_there);
}

void CaseHold::take(const fs::path& folder) {
  if (folder == folder_ && !refusal_) return;
  const bool same = folder == folder_;
  if (!watcher_.directories().isEmpty()) watcher_.removePaths(watcher_.directories());
  lock_.reset();
  folder_ = folder;
  if (folder.empty()) return refuse({});
  watcher_.addPaths({text_of(folder), text_of(folder.parent_path())});
  lock_ = std::make_unique<QLockFile>(text_of(folder / lock_name));
  lock_->setStaleLockTime(0);  // only a process that has ended leaves a stale one
  if (lock_->tryLock(0)) return refuse({});
  const bool elsewhere = lock_->error() == QLockFile::LockFailedError;
  lock_.reset();
  std::error_code problem;
  const bool there = fs::exists(folder, problem);
  const Error why = elsewhere ? open_elsewhere(folder) : there ? read_only(folder) : gone(folder);
  if (same && refusal_ && refusal_->code == why.code) return;  // said before
  refuse(why);
}

void CaseHold::look_whether_it_is_there() {
  std::error_code problem;
  const bool there = fs::is_directory(folder_, problem);
  if (there && refusal_ && refusal_->code == "case-gone") {
    take(folder_);
  } else if (!there && (!refusal_ || refusal_->code != "case-gone")) {
    refuse(gone(folder_));
  }
}

void CaseHold::refuse(std::optional<Error> why) {
  const bool other = why.has_value() || refusal_.has_value();
  refusal_ = std::move(why);
  if (other) Q_EMIT changed();
}

}  // namespace glisson::widgets

#include "settings/settings.h"

#include <algorithm>
#include <QSettings>
#include <QStandardPaths>
#include <QStringList>

#include "base/parallel.h"
#include "words/paths.h"

namespace glisson::widgets {
namespace {

namespace fs = std::filesystem;

constexpr const char* names_key = "show_names_outside";
constexpr const char* threads_key = "threads";
constexpr const char* recent_key = "recent_cases";
constexpr qsizetype most_recent_cases = 8;

QSettings settings() { return QSettings("glisson", "glisson"); }

}  // namespace

fs::path own_folder() { return path_of(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation)); }

bool names_shown_outside() { return settings().value(names_key, false).toBool(); }

void show_names_outside(bool shown) { settings().setValue(names_key, shown); }

int kept_threads() { return std::max(0, settings().value(threads_key, 0).toInt()); }

void keep_threads(int threads) {
  settings().setValue(threads_key, threads);
  set_thread_count(threads);
}

std::vector<fs::path> recent_cases() {
  std::vector<fs::path> there;
  for (const QString& folder : settings().value(recent_key).toStringList()) {
    std::error_code problem;
    const fs::path path = fs::weakly_canonical(path_of(folder), problem);  // one case, whatever way led to it
    if (!fs::exists(path / "case.json", problem)) continue;
    if (std::find(there.begin(), there.end(), path) == there.end()) there.push_back(path);
  }
  return there;
}

void remember_case(const fs::path& folder) {
  std::error_code problem;
  const QString text = text_of(fs::weakly_canonical(folder, problem));
  QStringList folders = settings().value(recent_key).toStringList();
  folders.removeAll(text);
  folders.prepend(text);
  settings().setValue(recent_key, folders.mid(0, most_recent_cases));
}

void forget_recent_cases() { settings().remove(recent_key); }

}  // namespace glisson::widgets

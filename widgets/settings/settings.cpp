#include "widgets/settings/settings.h"

#include <algorithm>
#include <QStandardPaths>
#include <QStringList>

#include "base/parallel.h"
#include "widgets/settings/program_settings.h"
#include "widgets/words/paths.h"

namespace glisson::widgets {
namespace {

namespace fs = std::filesystem;

constexpr const char* names_key = "show_names_outside";
constexpr const char* threads_key = "threads";
constexpr const char* program_key = "outlining_program";
constexpr const char* values_key = "outlining_program_values";
constexpr const char* shapes_key = "shape_model";
constexpr const char* recent_key = "recent_cases";
constexpr const char* windows_key = "grey_windows";
constexpr qsizetype maximum_recent_cases = 8;
constexpr qsizetype maximum_windows = 100;

QString one_way_to(const fs::path& folder) {
  std::error_code problem;
  return text_of(fs::weakly_canonical(folder, problem));
}

}  // namespace

fs::path own_folder() { return path_of(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation)); }

bool names_shown_outside() { return program_settings().value(names_key, false).toBool(); }

void show_names_outside(bool shown) { program_settings().setValue(names_key, shown); }

int kept_threads() { return std::max(0, program_settings().value(threads_key, 0).toInt()); }

void keep_threads(int threads) {
  program_settings().setValue(threads_key, threads);
  set_thread_count(threads);
}

QString kept_shapes() { return program_settings().value(shapes_key).toString().trimmed(); }

void keep_shapes(const QString& file) { program_settings().setValue(shapes_key, file); }

KeptProgram kept_program() {
  return {program_settings().value(program_key).toString(), program_settings().value(values_key).toString()};
}

void keep_program(const KeptProgram& program) {
  program_settings().setValue(program_key, program.command.trimmed());
  program_settings().setValue(values_key, program.values.trimmed());
}

std::vector<fs::path> recent_cases() {
  std::vector<fs::path> there;
  for (const QString& folder : program_settings().value(recent_key).toStringList()) {
    std::error_code problem;
    const fs::path path = fs::weakly_canonical(path_of(folder), problem);  // one case, whatever way led to it
    if (!fs::exists(path / "case.json", problem)) continue;
    if (std::find(there.begin(), there.end(), path) == there.end()) there.push_back(path);
  }
  return there;
}

void remember_case(const fs::path& folder) {
  const QString text = one_way_to(folder);
  QStringList folders = program_settings().value(recent_key).toStringList();
  folders.removeAll(text);
  folders.prepend(text);
  program_settings().setValue(recent_key, folders.mid(0, maximum_recent_cases));
}

void forget_recent_cases() {
  program_settings().remove(recent_key);
  program_settings().remove(windows_key);
  program_settings().remove(last_folder_key);
}

// Lines "60 160 /a/case.glisson", the last one first.
std::optional<GreyWindow> kept_window(const fs::path& case_folder) {
  if (case_folder.empty()) return std::nullopt;
  for (const QString& line : program_settings().value(windows_key).toStringList()) {
    if (line.section(' ', 2) != one_way_to(case_folder)) continue;
    const GreyWindow window{line.section(' ', 0, 0).toDouble(), line.section(' ', 1, 1).toDouble()};
    return window.width > 0 ? std::optional(window) : std::nullopt;
  }
  return std::nullopt;
}

void keep_window(const fs::path& case_folder, const GreyWindow& window) {
  if (case_folder.empty()) return;
  const QString folder = one_way_to(case_folder);
  QStringList lines = program_settings().value(windows_key).toStringList();
  lines.removeIf([&](const QString& line) { return line.section(' ', 2) == folder; });
  lines.prepend(QString("%1 %2 %3").arg(window.center).arg(window.width).arg(folder));
  program_settings().setValue(windows_key, lines.mid(0, maximum_windows));
}

}  // namespace glisson::widgets

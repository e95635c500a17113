#pragma once
// Paths between Qt and the core, whatever their letters.

#include <filesystem>
#include <QString>

namespace glisson::widgets {

[[nodiscard]] inline std::filesystem::path path_of(const QString& text) { return {text.toStdU16String()}; }
[[nodiscard]] inline QString text_of(const std::filesystem::path& path) {
  return QString::fromStdU16String(path.u16string());
}

}  // namespace glisson::widgets

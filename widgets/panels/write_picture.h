#pragma once
// Pictures reach the disk as everything does: whole or not at all.

#include <filesystem>
#include <QImage>

#include "base/result.h"

namespace glisson::widgets {

// As PNG. Fails as write_file does.
Result<void> write_picture(const QImage& picture, const std::filesystem::path& file);

}  // namespace glisson::widgets

#include "widgets/panels/write_picture.h"

#include <QBuffer>

#include "base/write_file.h"

namespace glisson::widgets {

Result<void> write_picture(const QImage& picture, const std::filesystem::path& file) {
  QBuffer bytes;
  bytes.open(QIODevice::WriteOnly);
  constexpr const char* format = "PNG";  // not translated
  if (!picture.save(&bytes, format)) return file_not_writable(file, GLISSON_TEXT("there is no picture"));
  return write_file(file, {bytes.data().constData(), static_cast<std::size_t>(bytes.size())});
}

}  // namespace glisson::widgets

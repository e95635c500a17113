#include "scene/picture.h"

#include <png.h>

#include "base/files.h"

namespace glisson::scene {
namespace {

constexpr png_uint_32 maximum_read_px = 16384;

}  // namespace

Result<void> write_png(const Picture& picture, const std::filesystem::path& file) {
  const auto expected = 3 * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
  GLISSON_ASSERT(picture.width > 0 && picture.height > 0 && picture.rgb.size() == expected);
  return write_atomically(file, [&](const std::filesystem::path& beside) -> Result<void> {
    png_image header{};
    header.version = PNG_IMAGE_VERSION;
    header.width = static_cast<png_uint_32>(picture.width);
    header.height = static_cast<png_uint_32>(picture.height);
    header.format = PNG_FORMAT_RGB;
    if (png_image_write_to_file(&header, beside.c_str(), 0, picture.rgb.data(), 0, nullptr) == 0) {
      return failure(Error{"picture-not-written",
                           GLISSON_TEXT("The picture could not be written: {0}."),
                           {header.message},
                           GLISSON_TEXT("Choose a folder that you may write to, on a disk with room."),
                           file});
    }
    return {};
  });
}

Result<Picture> read_png(const std::filesystem::path& file) {
  const auto unreadable = [&](std::string why) {
    return failure(Error{"picture-unreadable",
                         GLISSON_TEXT("This is not a PNG picture that can be read: {0}."),
                         {std::move(why)},
                         GLISSON_TEXT("Check that the file is whole."),
                         file});
  };
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&header, file.c_str()) == 0) return unreadable(header.message);
  if (header.width > maximum_read_px || header.height > maximum_read_px) {
    png_image_free(&header);
    return unreadable(GLISSON_TEXT("it is larger than 16384 pixels a side"));
  }
  header.format = PNG_FORMAT_RGB;
  Picture picture{static_cast<int>(header.width), static_cast<int>(header.height), {}};
  picture.rgb.resize(PNG_IMAGE_SIZE(header));
  const png_color black{0, 0, 0};
  if (png_image_finish_read(&header, &black, picture.rgb.data(), 0, nullptr) == 0) return unreadable(header.message);
  return picture;
}

}  // namespace glisson::scene

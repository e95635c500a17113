#include "vision/frame.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>
#include <string>

#include "base/files.h"
#include "base/folder_contents.h"
#include "base/text.h"
#include "vision/internal/opencv.h"

namespace glisson::vision {
namespace {

namespace fs = std::filesystem;

bool is_picture(const fs::path& file);
bool comes_before(const fs::path& a, const fs::path& b);

}  // namespace

Result<Frame> read_frame(const fs::path& file) {
  cv::Mat image;
  try {
    std::error_code problem;
    if (fs::is_regular_file(file, problem)) image = cv::imread(file.string(), cv::IMREAD_COLOR);
  } catch (const cv::Exception&) {
    image.release();
  }
  if (image.empty()) {
    return failure(Error{"image-not-readable",
                         GLISSON_TEXT("The picture {0} cannot be read."),
                         {file.string()},
                         GLISSON_TEXT("PNG, JPEG, TIFF and BMP are read."),
                         file});
  }
  return from_opencv(image);
}

Result<void> write_frame(const Frame& frame, const fs::path& file) {
  return write_atomically(file, [&](const fs::path& beside) -> Result<void> {
    bool written = false;
    try {
      written = cv::imwrite(beside.string(), to_opencv(frame));
    } catch (const cv::Exception&) {
      written = false;
    }
    if (written) return {};
    return failure(Error{"image-not-written",
                         GLISSON_TEXT("The picture {0} cannot be written."),
                         {file.string()},
                         GLISSON_TEXT("The folder must exist, and the name end in .png or .jpg."),
                         file});
  });
}

struct FrameSource::Inside {
  fs::path where;
  std::vector<fs::path> pictures;  // of a folder
  std::size_t next_picture = 0;
  cv::VideoCapture video;  // opened only for a video file
  int width = 0, height = 0;
};

FrameSource::FrameSource(std::unique_ptr<Inside> inside) : inside_(std::move(inside)) {}
FrameSource::FrameSource(FrameSource&&) noexcept = default;
FrameSource& FrameSource::operator=(FrameSource&&) noexcept = default;
FrameSource::~FrameSource() = default;

Result<FrameSource> FrameSource::open(const fs::path& video_or_folder) {
  auto inside = std::make_unique<Inside>();
  inside->where = video_or_folder;
  std::error_code problem;
  if (fs::is_directory(video_or_folder, problem)) {
    for (const fs::path& file : contents_of(video_or_folder)) {
      if (is_picture(file)) inside->pictures.push_back(file);
    }
    std::sort(inside->pictures.begin(), inside->pictures.end(), comes_before);
    if (inside->pictures.empty()) {
      return failure(Error{"video-no-frames",
                           GLISSON_TEXT("The folder {0} holds no pictures."),
                           {video_or_folder.string()},
                           GLISSON_TEXT("PNG, JPEG, TIFF and BMP are read."),
                           video_or_folder});
    }
    return FrameSource(std::move(inside));
  }
  if (is_picture(video_or_folder) && fs::is_regular_file(video_or_folder, problem)) {
    inside->pictures = {video_or_folder};
    return FrameSource(std::move(inside));
  }
  try {
    if (fs::is_regular_file(video_or_folder, problem)) inside->video.open(video_or_folder.string(), cv::CAP_FFMPEG);
  } catch (const cv::Exception&) {
    inside->video.release();
  }
  if (!inside->video.isOpened()) {
    return failure(Error{"video-not-readable",
                         GLISSON_TEXT("The video {0} cannot be read."),
                         {video_or_folder.string()},
                         GLISSON_TEXT("Give a video file that OpenCV (FFmpeg) reads, or a folder of pictures."),
                         video_or_folder});
  }
  return FrameSource(std::move(inside));
}

Result<std::optional<Frame>> FrameSource::next() {
  Frame frame;
  if (!inside_->pictures.empty()) {
    if (inside_->next_picture == inside_->pictures.size()) return std::nullopt;
    auto read = read_frame(inside_->pictures[inside_->next_picture++]);
    if (!read) return failure(read.error());
    frame = std::move(*read);
  } else {
    cv::Mat image;
    try {
      if (!inside_->video.read(image) || image.empty()) return std::nullopt;
      if (image.channels() == 1) cv::cvtColor(image, image, cv::COLOR_GRAY2BGR);
      frame = from_opencv(image);
    } catch (const cv::Exception& broken) {
      return failure(Error{"video-not-readable",
                           GLISSON_TEXT("The video {0} cannot be decoded: {1}."),
                           {inside_->where.string(), broken.err},
                           {},
                           inside_->where});
    }
  }
  if (inside_->width == 0) {
    inside_->width = frame.width;
    inside_->height = frame.height;
  } else if (frame.width != inside_->width || frame.height != inside_->height) {
    return failure(Error{"video-frame-sizes",
                         GLISSON_TEXT("A picture of {0} has {1} x {2} pixels, the first has {3} x {4}."),
                         {inside_->where.string(), std::to_string(frame.width), std::to_string(frame.height),
                          std::to_string(inside_->width), std::to_string(inside_->height)},
                         {},
                         inside_->where});
  }
  return frame;
}

std::optional<int> FrameSource::count() const {
  if (!inside_->pictures.empty()) return static_cast<int>(inside_->pictures.size());
  const double said = inside_->video.get(cv::CAP_PROP_FRAME_COUNT);
  if (!(said >= 1) || said > 1e9) return std::nullopt;
  return static_cast<int>(std::lround(said));
}

namespace {

bool is_picture(const fs::path& file) {
  const std::string extension = in_lower_case(file.extension().string());
  constexpr const char* known[] = {".png", ".jpg", ".jpeg", ".tif", ".tiff", ".bmp", ".pgm", ".ppm"};
  return std::find(std::begin(known), std::end(known), extension) != std::end(known);
}

// Numbers in names by value, the rest letter by letter.
bool comes_before(const fs::path& a, const fs::path& b) {
  const std::string x = a.filename().string(), y = b.filename().string();
  const auto is_digit = [](char letter) { return std::isdigit(static_cast<unsigned char>(letter)) != 0; };
  std::size_t i = 0, j = 0;
  while (i < x.size() && j < y.size()) {
    if (!is_digit(x[i]) || !is_digit(y[j])) {
      if (x[i] != y[j]) return x[i] < y[j];
      ++i;
      ++j;
      continue;
    }
    const auto number = [&](const std::string& name, std::size_t& at) {
      while (at < name.size() && name[at] == '0') ++at;
      const std::size_t begin = at;
      while (at < name.size() && is_digit(name[at])) ++at;
      return name.substr(begin, at - begin);
    };
    const std::string from_x = number(x, i), from_y = number(y, j);
    if (from_x.size() != from_y.size()) return from_x.size() < from_y.size();
    if (from_x != from_y) return from_x < from_y;
  }
  return x.size() - i < y.size() - j;
}

}  // namespace
}  // namespace glisson::vision

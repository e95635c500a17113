#include "vision/movie.h"

#include <fmt/format.h>
#include <opencv2/videoio.hpp>
#include <optional>
#include <system_error>

#include "base/new_folder.h"
#include "base/write_file.h"
#include "vision/internal/opencv.h"

namespace glisson::vision {
namespace {

namespace fs = std::filesystem;

tl::unexpected<Error> not_written(const fs::path& file, const char* what_to_do) {
  return failure(
      Error{"movie-not-written", GLISSON_TEXT("The movie {0} cannot be written."), {file.string()}, what_to_do, file});
}

}  // namespace

struct MovieWriter::Inside {
  fs::path file;
  std::optional<NewFolder> pictures;
  std::optional<MemoryFile> memory;  // the film, since its encoder does not notice a full disk
  double frames_per_second = 25;
  bool is_video = false;
  cv::VideoWriter video;
  int width = 0;
  int height = 0;
  int count = 0;

  ~Inside() { video.release(); }
};

MovieWriter::MovieWriter(std::unique_ptr<Inside> inside) : inside_(std::move(inside)) {}
MovieWriter::MovieWriter(MovieWriter&&) noexcept = default;
MovieWriter& MovieWriter::operator=(MovieWriter&&) noexcept = default;
MovieWriter::~MovieWriter() = default;

Result<MovieWriter> MovieWriter::begin(const fs::path& file, double frames_per_second) {
  GLISSON_ASSERT(frames_per_second > 0);
  auto inside = std::make_unique<Inside>();
  inside->file = file;
  inside->frames_per_second = frames_per_second;
  inside->is_video = file.extension() == ".mp4";
  std::error_code problem;
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, problem)) return not_written(file, GLISSON_TEXT("Choose a folder that exists."));
  if (!inside->is_video && fs::exists(file, problem)) {
    return not_written(file, GLISSON_TEXT("Choose a name that is not there yet."));
  }
  if (inside->is_video) {
    auto memory = MemoryFile::create(file);
    if (!memory) return failure(std::move(memory.error()));
    inside->memory.emplace(std::move(*memory));
    return MovieWriter(std::move(inside));
  }
  auto pictures = NewFolder::begin(file);
  if (!pictures) return not_written(file, GLISSON_TEXT("Choose a folder in which you may write."));
  inside->pictures.emplace(std::move(*pictures));
  return MovieWriter(std::move(inside));
}

Result<void> MovieWriter::add(const Frame& frame) {
  Inside& in = *inside_;
  if (in.count == 0) {
    in.width = frame.width;
    in.height = frame.height;
  }
  if (frame.width != in.width || frame.height != in.height) {
    return not_written(in.file, GLISSON_TEXT("Leave the window's size as it is while the movie is made."));
  }
  ++in.count;
  if (!in.is_video) return write_frame(frame, in.pictures->path() / fmt::format("{:05}.png", in.count));
  const cv::Size even(in.width - in.width % 2, in.height - in.height % 2);
  try {
    if (in.count == 1) {
      in.video.open(in.memory->path().string(), cv::VideoWriter::fourcc('m', 'p', '4', 'v'), in.frames_per_second,
                    even);
    }
    if (in.video.isOpened()) in.video.write(to_opencv(frame)(cv::Rect({0, 0}, even)).clone());
  } catch (const cv::Exception&) {
    in.video.release();
  }
  if (in.video.isOpened()) return {};
  return not_written(in.file, GLISSON_TEXT("Choose a folder in which you may write, or a name without .mp4: then it "
                                           "becomes a folder of pictures."));
}

Result<void> MovieWriter::finish() {
  Inside& in = *inside_;
  in.video.release();
  if (in.is_video && in.count > 0) return in.memory->write_to(in.file);
  if (in.count > 0 && in.pictures && in.pictures->put_in_place() == 0) return {};
  return not_written(in.file, GLISSON_TEXT("Look whether the disk is full."));
}

}  // namespace glisson::vision

// Pictures from folders and from a video file.

#include "vision/frame.h"

#include <gtest/gtest.h>
#include <cstdlib>
#include <opencv2/videoio.hpp>

#include "base/files.h"

namespace glisson::vision {
namespace {

Frame plain(int width, int height, std::uint8_t grey) {
  return {width, height, std::vector<std::uint8_t>(3 * static_cast<std::size_t>(width * height), grey)};
}

TEST(FrameSource, TakesAFoldersPicturesByTheNumbersInTheirNames) {
  const TemporaryFolder folder;
  for (const int number : {2, 10, 1}) {
    ASSERT_TRUE(write_frame(plain(8, 6, static_cast<std::uint8_t>(10 * number)),
                            folder.path() / ("frame" + std::to_string(number) + ".png")));
  }
  ASSERT_TRUE(write_text_file(folder.path() / "notes.txt", "no picture"));
  auto source = FrameSource::open(folder.path()).value();
  EXPECT_EQ(source.count(), 3);
  std::vector<int> greys;
  while (auto frame = source.next().value()) greys.push_back(*frame->at(3, 3));
  EXPECT_EQ(greys, (std::vector<int>{10, 20, 100}));
}

TEST(FrameSource, ReadsAVideoFile) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "video.avi";
  {
    cv::VideoWriter writer(file.string(), cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 25, {64, 48});
    ASSERT_TRUE(writer.isOpened());
    for (const int grey : {40, 90, 140, 190}) writer.write(cv::Mat(48, 64, CV_8UC3, cv::Scalar(0, 0, grey)));
  }
  auto source = FrameSource::open(file).value();
  int count = 0;
  while (auto frame = source.next().value()) {
    EXPECT_EQ(frame->width, 64);
    EXPECT_EQ(frame->height, 48);
    EXPECT_NEAR(frame->at(20, 20)[0], 40 + 50 * count, 6);  // red, as it was written; JPEG changes it a little
    EXPECT_NEAR(frame->at(20, 20)[2], 0, 6);
    ++count;
  }
  EXPECT_EQ(count, 4);
}

TEST(FrameSource, SaysWhatCannotBeRead) {
  const TemporaryFolder folder;
  EXPECT_EQ(FrameSource::open(folder.path()).error().code, "video-no-frames");
  EXPECT_EQ(FrameSource::open(folder.path() / "nowhere.mp4").error().code, "video-not-readable");
  ASSERT_TRUE(write_text_file(folder.path() / "broken.mp4", "not a video"));
  EXPECT_EQ(FrameSource::open(folder.path() / "broken.mp4").error().code, "video-not-readable");
  ASSERT_TRUE(write_frame(plain(8, 6, 1), folder.path() / "a.png"));
  ASSERT_TRUE(write_frame(plain(6, 8, 1), folder.path() / "b.png"));
  auto source = FrameSource::open(folder.path()).value();
  EXPECT_TRUE(source.next().has_value());
  EXPECT_EQ(source.next().error().code, "video-frame-sizes");
}

}  // namespace
}  // namespace glisson::vision

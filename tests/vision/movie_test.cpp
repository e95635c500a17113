// A film that was written reads back frame by frame; one that was not finished leaves nothing.

#include "vision/movie.h"

#include <gtest/gtest.h>
#include <cstdlib>

#include "base/files.h"
#include "base/write_file.h"

namespace glisson::vision {
namespace {

Frame grey_frame(int width, int height, std::uint8_t grey) {
  return {width, height, std::vector<std::uint8_t>(3 * static_cast<std::size_t>(width * height), grey)};
}

TEST(MovieWriter, AVideoHoldsItsFramesInOrder) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "rehearsal.mp4";
  auto movie = MovieWriter::begin(file, 25).value();
  for (const std::uint8_t grey : {30, 90, 150, 210}) ASSERT_TRUE(movie.add(grey_frame(65, 49, grey)));
  EXPECT_FALSE(std::filesystem::exists(file));
  ASSERT_TRUE(movie.finish());
  auto source = FrameSource::open(file).value();
  std::vector<int> greys;
  while (auto frame = source.next().value()) {
    EXPECT_EQ(frame->width, 64);
    EXPECT_EQ(frame->height, 48);
    greys.push_back(*frame->at(30, 20));
  }
  ASSERT_EQ(greys.size(), 4u);
  // The encoder keeps a plain grey within a few steps.
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(greys[k], 30 + 60 * static_cast<int>(k), 6);
}

TEST(MovieWriter, AnyOtherNameBecomesAFolderOfPictures) {
  const TemporaryFolder folder;
  auto movie = MovieWriter::begin(folder.path() / "frames", 25).value();
  for (const std::uint8_t grey : {10, 20, 30}) ASSERT_TRUE(movie.add(grey_frame(9, 7, grey)));
  ASSERT_TRUE(movie.finish());
  EXPECT_EQ(*read_frame(folder.path() / "frames" / "00002.png").value().at(4, 4), 20);
  const auto again = MovieWriter::begin(folder.path() / "frames", 25);
  ASSERT_FALSE(again);
  EXPECT_EQ(again.error().code, "movie-not-written");
}

TEST(MovieWriter, LeavesNothingUnlessItWasFinished) {
  const TemporaryFolder folder;
  {
    auto movie = MovieWriter::begin(folder.path() / "half.mp4", 25).value();
    ASSERT_TRUE(movie.add(grey_frame(64, 48, 40)));
    EXPECT_FALSE(movie.add(grey_frame(32, 48, 40)));  // another size
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  EXPECT_FALSE(MovieWriter::begin(folder.path() / "nowhere" / "film.mp4", 25));
}

// A killed program's pictures, under whatever name, and those of one that still films.
TEST(MovieWriter, TakesAwayWhatWasLeftHalfDoneAndNothingOfALivingOne) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_text_file(folder.path() / "elsewhere" / "00001.png", "half a pi"));
  std::filesystem::rename(folder.path() / "elsewhere", folder.path() / ".part-old");
  auto movie = MovieWriter::begin(folder.path() / "frames", 25).value();
  EXPECT_FALSE(std::filesystem::exists(folder.path() / ".part-old"));
  ASSERT_TRUE(movie.add(grey_frame(9, 7, 10)));
  remove_abandoned_parts(folder.path());
  ASSERT_TRUE(movie.add(grey_frame(9, 7, 20)));
  ASSERT_TRUE(movie.finish());
  EXPECT_EQ(*read_frame(folder.path() / "frames" / "00001.png").value().at(4, 4), 10);
}

}  // namespace
}  // namespace glisson::vision

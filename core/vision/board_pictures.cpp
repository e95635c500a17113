// A calibration from pictures of a board that lie in files, folders and videos.

#include <fmt/format.h>
#include <algorithm>

#include "vision/calibrate.h"

namespace glisson::vision {
namespace {

namespace fs = std::filesystem;

// Several sources as one: their pictures one after another.
class PictureRow {
 public:
  explicit PictureRow(const std::vector<fs::path>& sources) : sources_(sources) {}

  Result<std::optional<Frame>> next();
  // How many there are, as far as the sources say. Failures: those of FrameSource::open.
  [[nodiscard]] Result<int> count() const;
  // A name for the last picture: of its file where that holds no other.
  [[nodiscard]] std::string name(int number) const {
    const bool alone = open_ && open_->count() == 1;
    return alone ? sources_[at_ - 1].string() : fmt::format("pair {}", number);
  }

 private:
  const std::vector<fs::path>& sources_;
  std::size_t at_ = 0;  // the next source
  std::optional<FrameSource> open_;
};

}  // namespace

Result<CalibrationFit> calibrate(const BoardPictures& pictures, const Progress& progress) {
  auto calibrator = Calibrator::begin(pictures.board);
  if (!calibrator) return failure(calibrator.error());
  PictureRow from_left(pictures.left), from_right(pictures.right);
  const auto expected = from_left.count();
  if (!expected) return failure(expected.error());
  const bool in_one = pictures.right.empty();
  int lefts = 0, rights = 0, taken = 0;
  for (;;) {
    if (progress.cancelled()) return cancelled();
    auto left = from_left.next();
    if (!left) return failure(left.error());
    auto right = in_one ? Result<std::optional<Frame>>() : from_right.next();
    if (!right) return failure(right.error());
    lefts += left->has_value() ? 1 : 0;
    rights += right->has_value() || (in_one && left->has_value()) ? 1 : 0;
    if (!*left && !*right) break;
    if (lefts != rights || (lefts - 1) % pictures.every != 0) continue;  // counted to the end, to say by how many
    BoardPair pair;
    pair.name = from_left.name(++taken);
    if (in_one) {
      auto parted = halves(**left, pictures.shared);
      if (!parted) return failure(parted.error());
      pair.left = std::move(parted->left);
      pair.right = std::move(parted->right);
    } else {
      pair.left = std::move(**left);
      pair.right = std::move(**right);
    }
    if (auto added = calibrator->add(pair); !added) return failure(added.error());
    progress.report(0.9 * lefts / std::max(lefts, *expected), GLISSON_TEXT("calibrating"));
  }
  const auto of_these = [&](int count) { return (count + pictures.every - 1) / pictures.every; };
  if (of_these(lefts) != of_these(rights)) {
    return failure("calibration-not-paired",
                   GLISSON_TEXT("There are {0} left and {1} right pictures: they must be taken in pairs."),
                   {std::to_string(of_these(lefts)), std::to_string(of_these(rights))});
  }
  return calibrator->fit();
}

namespace {

Result<std::optional<Frame>> PictureRow::next() {
  for (;;) {
    if (open_) {
      auto frame = open_->next();
      if (!frame || *frame) return frame;
      open_.reset();
    }
    if (at_ == sources_.size()) return std::nullopt;
    auto opened = FrameSource::open(sources_[at_++]);
    if (!opened) return failure(opened.error());
    open_ = std::move(*opened);
  }
}

Result<int> PictureRow::count() const {
  int count = 0;
  for (const fs::path& source : sources_) {
    const auto opened = FrameSource::open(source);
    if (!opened) return failure(opened.error());
    count += std::min(opened->count().value_or(0), 1'000'000);
  }
  return count;
}

}  // namespace
}  // namespace glisson::vision

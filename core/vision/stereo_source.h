#pragma once
// Where a stereo camera's pairs of pictures come from: a video for each eye, or one video whose pictures show both.

#include <filesystem>
#include <optional>
#include <utility>

#include "base/result.h"
#include "vision/frame.h"

namespace glisson::vision {

// How a picture that both eyes share is divided into two of one size.
enum class Shared { left_then_right, right_then_left, left_above_right };

struct StereoFiles {
  std::filesystem::path left;   // the left eye's, or one that shows both
  std::filesystem::path right;  // empty: `left` shows both
  Shared shared = Shared::left_then_right;

  [[nodiscard]] bool in_one() const { return right.empty(); }
};

struct StereoPair {
  Frame left;
  Frame right;
};

// Failure: "picture-of-one-eye" (what is to be halved has an odd number of pixels, or fewer than two).
Result<StereoPair> halves(const Frame& both, Shared shared);

// One moment, from one picture or two. Failures: those of read_frame and halves; "stereo-image-sizes" (the two differ).
Result<StereoPair> read_pair(const StereoFiles& files);

// The pairs of a video one after another. Files are what FrameSource opens.
class StereoSource {
 public:
  // Failures: those of FrameSource::open.
  static Result<StereoSource> open(const StereoFiles& files);

  // The next pair, or nothing at the end. Failures: those of FrameSource::next and halves; "stereo-image-sizes";
  // "sequence-lengths" (one video ends before the other).
  Result<std::optional<StereoPair>> next();

  // How many there are, as the left video says; nothing where it does not.
  [[nodiscard]] std::optional<int> count() const { return left_.count(); }

  // Known before the first is read: whether one video says that it ends before so many pairs and the other goes on.
  // Files say it only nearly: a hundredth, or one frame, is let pass. Failure: "sequence-lengths".
  [[nodiscard]] Result<void> has(int pairs) const;

 private:
  StereoSource(FrameSource left, std::optional<FrameSource> right, Shared shared)
      : left_(std::move(left)), right_(std::move(right)), shared_(shared) {}

  FrameSource left_;
  std::optional<FrameSource> right_;
  Shared shared_;
  int read_ = 0;
};

}  // namespace glisson::vision

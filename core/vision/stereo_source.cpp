#include "vision/stereo_source.h"

#include <algorithm>
#include <string>

namespace glisson::vision {
namespace {

Frame part_of(const Frame& whole, int x, int y, int width, int height) {
  const auto row_bytes = 3 * static_cast<std::size_t>(width);
  Frame part{width, height, std::vector<std::uint8_t>(row_bytes * static_cast<std::size_t>(height))};
  for (int row = 0; row < height; ++row) std::copy_n(whole.at(x, y + row), row_bytes, part.at(0, row));
  return part;
}

Result<void> of_one_size(const StereoPair& pair) {
  if (pair.left.width == pair.right.width && pair.left.height == pair.right.height) return {};
  return failure("stereo-image-sizes", GLISSON_TEXT("The left image is {0} x {1} pixels, the right one {2} x {3}."),
                 {std::to_string(pair.left.width), std::to_string(pair.left.height), std::to_string(pair.right.width),
                  std::to_string(pair.right.height)});
}

}  // namespace

Result<StereoPair> halves(const Frame& both, Shared shared) {
  const bool is_above = shared == Shared::left_above_right;
  const int divided = is_above ? both.height : both.width;
  if (divided < 2 || divided % 2 != 0) {
    return failure(Error{"picture-of-one-eye",
                         GLISSON_TEXT("A picture of {0} x {1} pixels cannot be halved into two of one size."),
                         {std::to_string(both.width), std::to_string(both.height)},
                         GLISSON_TEXT("Give a video whose pictures show both eyes, or one video for each eye."),
                         {}});
  }
  const int width = is_above ? both.width : both.width / 2, height = is_above ? both.height / 2 : both.height;
  StereoPair pair{part_of(both, 0, 0, width, height),
                  part_of(both, both.width - width, both.height - height, width, height)};
  if (shared == Shared::right_then_left) std::swap(pair.left, pair.right);
  return pair;
}

Result<StereoPair> read_pair(const StereoFiles& files) {
  auto left = read_frame(files.left);
  if (!left) return failure(left.error());
  if (files.in_one()) return halves(*left, files.shared);
  auto right = read_frame(files.right);
  if (!right) return failure(right.error());
  StereoPair pair{std::move(*left), std::move(*right)};
  if (auto good = of_one_size(pair); !good) return failure(good.error());
  return pair;
}

Result<StereoSource> StereoSource::open(const StereoFiles& files) {
  auto left = FrameSource::open(files.left);
  if (!left) return failure(left.error());
  if (files.in_one()) return StereoSource(std::move(*left), std::nullopt, files.shared);
  auto right = FrameSource::open(files.right);
  if (!right) return failure(right.error());
  return StereoSource(std::move(*left), std::move(*right), files.shared);
}

Result<std::optional<StereoPair>> StereoSource::next() {
  auto left = left_.next();
  if (!left) return failure(left.error());
  if (!right_) {
    if (!*left) return std::nullopt;
    return halves(**left, shared_).map([](StereoPair pair) { return std::optional(std::move(pair)); });
  }
  auto right = right_->next();
  if (!right) return failure(right.error());
  if (left->has_value() != right->has_value()) {
    return failure("sequence-lengths", GLISSON_TEXT("The {0} video ends before the other, at frame {1}."),
                   {left->has_value() ? "right" : "left", std::to_string(read_)});
  }
  if (!*left) return std::nullopt;
  ++read_;
  StereoPair pair{std::move(**left), std::move(**right)};
  if (auto good = of_one_size(pair); !good) return failure(good.error());
  return pair;
}

Result<void> StereoSource::has(int pairs) const {
  const auto left = left_.count(), right = right_ ? right_->count() : std::nullopt;
  if (!left || !right) return {};
  const auto [fewer, more] = std::minmax(*left, *right);
  if (fewer >= pairs || more - fewer <= std::max(1, more / 100)) return {};
  return failure(
      Error{"sequence-lengths",
            GLISSON_TEXT("The two videos differ in length: frames of the left one {0}, of the right one {1}."),
            {std::to_string(*left), std::to_string(*right)},
            GLISSON_TEXT("Give two videos of the same moments, or take fewer frames than both have."),
            {}});
}

}  // namespace glisson::vision

#pragma once
// Compares a drawn picture with the one kept in tests/baselines, by three figures:
//
//   largest_difference   of any channel of any pixel, 0..255
//   differing_pixels     how many have any channel off by more than 2
//   perceived_difference the largest CIE 1976 colour difference between the two, after each 4 x 4 block of pixels was
//                        averaged, as the eye does at arm's length; about 2.3 is just noticeable side by side
//                        (Mahy, Van Eycken and Oosterlinck, Color Research and Application 19, 1994)
//
// What was drawn is kept in the build folder under pictures/. Nothing here writes a baseline: a missing one fails, and
// a person who has looked at the drawn picture copies it.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string>

#include "scene/picture.h"
#include "support/folders.h"

namespace glisson::test {

struct PictureDifference {
  int largest_difference = 0;
  std::size_t differing_pixels = 0;
  double perceived_difference = 0;
};

namespace detail {

inline double linear(double srgb) { return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4); }

// CIE L*a*b* under D65 of a linear sRGB colour, each channel 0..1.
inline std::array<double, 3> lab(const std::array<double, 3>& rgb) {
  const auto f = [](double t) { return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116; };
  const double x = f((0.4124 * rgb[0] + 0.3576 * rgb[1] + 0.1805 * rgb[2]) / 0.9505);
  const double y = f(0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2]);
  const double z = f((0.0193 * rgb[0] + 0.1192 * rgb[1] + 0.9505 * rgb[2]) / 1.0890);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

constexpr int block_px = 4;

inline std::array<double, 3> block_average(const scene::Picture& picture, int left, int top) {
  std::array<double, 3> sum{0, 0, 0};
  int count = 0;
  for (int y = top; y < std::min(top + block_px, picture.height); ++y) {
    for (int x = left; x < std::min(left + block_px, picture.width); ++x, ++count) {
      for (std::size_t c = 0; c < 3; ++c) sum[c] += linear(picture.at(x, y)[c] / 255.0);
    }
  }
  for (double& channel : sum) channel /= count;
  return sum;
}

}  // namespace detail

// The pictures have the same size.
inline PictureDifference difference(const scene::Picture& a, const scene::Picture& b) {
  PictureDifference outcome;
  for (std::size_t k = 0; k < a.rgb.size(); k += 3) {
    int largest = 0;
    for (std::size_t c = 0; c < 3; ++c) largest = std::max(largest, std::abs(int(a.rgb[k + c]) - int(b.rgb[k + c])));
    outcome.largest_difference = std::max(outcome.largest_difference, largest);
    if (largest > 2) ++outcome.differing_pixels;
  }
  for (int top = 0; top < a.height; top += detail::block_px) {
    for (int left = 0; left < a.width; left += detail::block_px) {
      const auto one = detail::lab(detail::block_average(a, left, top));
      const auto other = detail::lab(detail::block_average(b, left, top));
      const double distance = std::hypot(one[0] - other[0], one[1] - other[1], one[2] - other[2]);
      outcome.perceived_difference = std::max(outcome.perceived_difference, distance);
    }
  }
  return outcome;
}

// Keeps the picture as <build>/pictures/<name>.png and holds it against tests/baselines/<name>.png. The same software
// renderer draws the same bits; another one may round differently, which is let pass as long as nobody would see it.
inline testing::AssertionResult looks_like_baseline(const scene::Picture& drawn, const std::string& name) {
  const auto folder = glisson::test::build_folder() / "pictures";
  std::filesystem::create_directories(folder);
  const auto kept = folder / (name + ".png");
  if (auto written = scene::write_png(drawn, kept); !written) {
    return testing::AssertionFailure() << written.error().message();
  }
  const auto baseline_file = glisson::test::source_folder() / "tests" / "baselines" / (name + ".png");
  const auto baseline = scene::read_png(baseline_file);
  if (!baseline) {
    return testing::AssertionFailure() << "no baseline at " << baseline_file << "; look at " << kept
                                       << " and copy it there if it is right";
  }
  if (baseline->width != drawn.width || baseline->height != drawn.height) {
    return testing::AssertionFailure() << kept << " is " << drawn.width << " x " << drawn.height << ", its baseline "
                                       << baseline->width << " x " << baseline->height;
  }
  constexpr double noticed_at_a_glance = 6;
  const PictureDifference found = difference(drawn, *baseline);
  const bool alike = found.perceived_difference < noticed_at_a_glance;
  return (alike ? testing::AssertionSuccess() : testing::AssertionFailure())
         << kept << " against " << baseline_file << ": perceived difference " << found.perceived_difference
         << ", largest difference " << found.largest_difference << ", " << found.differing_pixels << " pixels differ";
}

}  // namespace glisson::test

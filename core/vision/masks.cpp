#include "vision/masks.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "vision/internal/opencv.h"

namespace glisson::vision {
namespace {

constexpr double colourless = 0.1;  // a picture whose median saturation is below this has no colours to judge by

struct Colours {
  cv::Mat darkest, brightest;  // of the three colours of each pixel
  cv::Mat saturation;          // CV_32F, 0..1
  cv::Mat lit;                 // bright enough for its colour to mean something
  double usual_saturation = 0;
};

double median_of(const cv::Mat& values, const cv::Mat& where);

Colours colours_of(const cv::Mat& bgr) {
  constexpr int unlit = 40;
  std::vector<cv::Mat> channels;
  cv::split(bgr, channels);
  Colours colours;
  colours.darkest = cv::min(cv::min(channels[0], channels[1]), channels[2]);
  colours.brightest = cv::max(cv::max(channels[0], channels[1]), channels[2]);
  cv::divide(colours.brightest - colours.darkest, cv::max(colours.brightest, 1), colours.saturation, 1, CV_32F);
  colours.lit = colours.brightest >= unlit;
  colours.usual_saturation = median_of(colours.saturation, colours.lit);
  return colours;
}

cv::Mat disc(int radius_px) {
  return cv::getStructuringElement(cv::MORPH_ELLIPSE, {2 * radius_px + 1, 2 * radius_px + 1});
}

// The dark that reaches the picture's edge: a fold in the tissue may be as dark.
cv::Mat scope_border(const Colours& colours, const MaskOptions& options) {
  cv::Mat pieces;
  const cv::Mat dark = colours.brightest < options.darkest;
  const int count = cv::connectedComponents(dark, pieces, 8, CV_32S);
  std::vector<std::uint8_t> at_edge(static_cast<std::size_t>(count), 0);
  const auto touch = [&](int y, int x) { at_edge[static_cast<std::size_t>(pieces.at<int>(y, x))] = 255; };
  for (int x = 0; x < dark.cols; ++x) {
    touch(0, x);
    touch(dark.rows - 1, x);
  }
  for (int y = 0; y < dark.rows; ++y) {
    touch(y, 0);
    touch(y, dark.cols - 1);
  }
  at_edge[0] = 0;  // what is not dark
  cv::Mat border(dark.size(), CV_8U);
  for (int y = 0; y < dark.rows; ++y) {
    for (int x = 0; x < dark.cols; ++x) {
      border.at<std::uint8_t>(y, x) = at_edge[static_cast<std::size_t>(pieces.at<int>(y, x))];
    }
  }
  return border;
}

double median_of(const cv::Mat& values, const cv::Mat& where) {
  std::vector<float> kept;
  for (int y = 0; y < values.rows; ++y) {
    for (int x = 0; x < values.cols; ++x) {
      if (where.at<std::uint8_t>(y, x) != 0) kept.push_back(values.at<float>(y, x));
    }
  }
  if (kept.empty()) return 0;
  const auto middle = kept.begin() + static_cast<std::ptrdiff_t>(kept.size() / 2);
  std::nth_element(kept.begin(), middle, kept.end());
  return static_cast<double>(*middle);
}

cv::Mat highlights_of(const Colours& colours, const MaskOptions& options) {
  constexpr int shrink = 4;  // a median over a large window is slow, and smooth
  cv::Mat surround;
  cv::resize(colours.darkest, surround, {}, 1.0 / shrink, 1.0 / shrink, cv::INTER_AREA);
  cv::medianBlur(surround, surround, std::max(3, colours.darkest.rows / 10 / shrink) | 1);
  cv::resize(surround, surround, colours.darkest.size(), 0, 0, cv::INTER_LINEAR);
  cv::Mat highlights = colours.darkest >= options.highlight_brightness;
  if (colours.usual_saturation >= colourless) {
    cv::add(surround, cv::Scalar(options.highlight_above_surround), surround);
    highlights |= (colours.darkest > surround) & (colours.saturation < colours.usual_saturation);
  }
  cv::dilate(highlights, highlights, cv::Mat(), {-1, -1}, 2);
  return highlights;
}

// Grey pieces that come in from the border.
cv::Mat tools(const Colours& colours, const cv::Mat& border, const MaskOptions& options) {
  cv::Mat tool = cv::Mat::zeros(border.size(), CV_8U), saturation;
  if (colours.usual_saturation < colourless) return tool;
  cv::GaussianBlur(colours.saturation, saturation, {}, std::max(1.0, border.rows / 200.0));
  cv::Mat grey = (saturation < options.tool_greyness * colours.usual_saturation) & colours.lit & ~border;
  cv::morphologyEx(grey, grey, cv::MORPH_OPEN, disc(std::max(1, border.rows / 100)));
  // What lies within a fiftieth of the scope's border or of the picture's edge reaches it.
  const int reach_px = std::max(2, border.rows / 50);
  cv::Mat near_border;
  cv::dilate(border, near_border, disc(reach_px));
  near_border.rowRange(0, reach_px) = 255;
  near_border.rowRange(border.rows - reach_px, border.rows) = 255;
  near_border.colRange(0, reach_px) = 255;
  near_border.colRange(border.cols - reach_px, border.cols) = 255;

  cv::Mat pieces, figures, centers;
  const int count = cv::connectedComponentsWithStats(grey, pieces, figures, centers, 8, CV_32S);
  for (int piece = 1; piece < count; ++piece) {
    const cv::Mat here = pieces == piece;
    if (figures.at<int>(piece, cv::CC_STAT_AREA) < options.smallest_tool * static_cast<double>(border.total()))
      continue;
    if (cv::countNonZero(here & near_border) > 0) tool |= here;
  }
  cv::dilate(tool, tool, disc(std::max(2, border.rows / 100)));
  return tool;
}

cv::Mat smoke(const cv::Mat& bgr, const Colours& colours, const MaskOptions& options) {
  const int window_px = std::max(5, bgr.rows / 20) | 1;
  cv::Mat grey, mean, mean_of_squares, darkest;
  cv::cvtColor(bgr, grey, cv::COLOR_BGR2GRAY);
  grey.convertTo(grey, CV_32F);
  cv::boxFilter(grey, mean, CV_32F, {window_px, window_px});
  cv::sqrBoxFilter(grey, mean_of_squares, CV_32F, {window_px, window_px});
  const cv::Mat variance = mean_of_squares - mean.mul(mean);
  cv::boxFilter(colours.darkest, darkest, CV_32F, {window_px, window_px});
  return (variance < options.smoke_contrast * options.smoke_contrast) & (darkest > options.smoke_brightness);
}

}  // namespace

std::vector<std::uint8_t> tool_pixels(const Frame& frame, const MaskOptions& options) {
  const Colours colours = colours_of(to_opencv(frame));
  const cv::Mat tool = tools(colours, scope_border(colours, options), options);
  return {tool.datastart, tool.dataend};
}

UsablePixels usable_pixels(const Frame& frame, const MaskOptions& options) {
  const cv::Mat bgr = to_opencv(frame);
  const Colours colours = colours_of(bgr);
  const double all = static_cast<double>(bgr.total());
  UsablePixels pixels;
  pixels.usable.assign(bgr.total(), 255);
  cv::Mat usable(bgr.size(), CV_8U, pixels.usable.data());
  const auto take = [&](const cv::Mat& mask) {
    const double share = cv::countNonZero(mask & usable) / all;
    usable &= ~mask;
    return share;
  };
  const cv::Mat border = scope_border(colours, options);
  const cv::Mat highlights = highlights_of(colours, options);
  pixels.shares.border = take(border);
  pixels.shares.highlights = take(highlights);
  if (options.tools == Masking::on) pixels.shares.tools = take(tools(colours, border, options));
  if (options.smoke == Masking::on) pixels.shares.smoke = take(smoke(bgr, colours, options));
  // Dark within the picture shows nothing either, but is no border.
  take(colours.brightest < options.darkest);
  return pixels;
}

}  // namespace glisson::vision

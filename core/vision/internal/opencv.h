#pragma once
// Between our pictures and OpenCV's, which hold blue first.

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "vision/frame.h"

namespace glisson::vision {

inline cv::Mat to_opencv(const Frame& frame) {
  const cv::Mat rgb(frame.height, frame.width, CV_8UC3, const_cast<std::uint8_t*>(frame.rgb.data()));
  cv::Mat bgr;
  cv::cvtColor(rgb, bgr, cv::COLOR_RGB2BGR);
  return bgr;
}

inline Frame from_opencv(const cv::Mat& bgr) {
  Frame frame{bgr.cols, bgr.rows, std::vector<std::uint8_t>(3 * bgr.total())};
  cv::Mat rgb(frame.height, frame.width, CV_8UC3, frame.rgb.data());
  cv::cvtColor(bgr, rgb, cv::COLOR_BGR2RGB);
  return frame;
}

}  // namespace glisson::vision

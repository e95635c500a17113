#pragma once
// Disparities to a fraction of a pixel: what semi-global matching and its smoothing leave is a few tenths off,
// smoothly, which at a laparoscope's distance is millimetres.

#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

namespace glisson::vision {

// Around every `step_px`-th pixel that is usable (255) and has a disparity, the left picture is explained by the right
// one with a disparity that changes evenly over the window, and with a gain and an offset of brightness (least squares,
// Lucas and Kanade 1981; weak priors hold what the picture does not tell). What strays from its beginning stays as it
// was. Pictures: CV_8UC1, rectified, of one size; `disparity_px`: CV_32F, not finite where nothing is known.
void refine_disparity(const cv::Mat& left, const cv::Mat& right, const std::vector<std::uint8_t>& usable, int step_px,
                      cv::Mat& disparity_px);

}  // namespace glisson::vision

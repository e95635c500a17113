#pragma once
// What a wave image was encoded for, among the options of its entry in case.json: "frequency_Hz", "direction",
// "offset", "along" ("0 0 1", patient LPS), "slice_times_s" (one a slice).

#include <map>
#include <string>

#include "imaging/study.h"

namespace glisson::casefile {

void put_motion(const imaging::MotionEncoding& motion, std::map<std::string, std::string>& options);
[[nodiscard]] imaging::MotionEncoding motion_from(const std::map<std::string, std::string>& options);

}  // namespace glisson::casefile

#include "casefile/internal/motion_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <charconv>
#include <cmath>
#include <vector>

namespace glisson::casefile {
namespace {

// The numbers of a text with blanks between them; none where anything else stands in it.
std::vector<double> numbers_in(const std::map<std::string, std::string>& options, const std::string& name) {
  std::vector<double> numbers;
  const auto found = options.find(name);
  if (found == options.end()) return numbers;
  const char* at = found->second.data();
  const char* const end = at + found->second.size();
  while (at < end) {
    double number = 0;
    const auto [next, problem] = std::from_chars(at, end, number);
    if (problem != std::errc() || !std::isfinite(number)) return {};
    numbers.push_back(number);
    at = next;
    while (at < end && *at == ' ') ++at;
  }
  return numbers;
}

std::optional<int> index_in(const std::map<std::string, std::string>& options, const std::string& name) {
  const std::vector<double> numbers = numbers_in(options, name);
  if (numbers.size() != 1 || numbers[0] < 0 || numbers[0] > 1000) return std::nullopt;
  return static_cast<int>(numbers[0]);
}

}  // namespace

void put_motion(const imaging::MotionEncoding& motion, std::map<std::string, std::string>& options) {
  if (motion.frequency_Hz) options["frequency_Hz"] = fmt::format("{:g}", *motion.frequency_Hz);
  if (motion.direction) options["direction"] = std::to_string(*motion.direction);
  if (motion.offset) options["offset"] = std::to_string(*motion.offset);
  if (!motion.slice_times_s.empty()) {
    options["slice_times_s"] = fmt::format("{:.6g}", fmt::join(motion.slice_times_s, " "));
  }
  if (motion.along) {
    options["along"] = fmt::format("{:.6g} {:.6g} {:.6g}", motion.along->x(), motion.along->y(), motion.along->z());
  }
}

imaging::MotionEncoding motion_from(const std::map<std::string, std::string>& options) {
  imaging::MotionEncoding motion;
  if (const auto frequency = numbers_in(options, "frequency_Hz"); frequency.size() == 1) {
    motion.frequency_Hz = frequency[0];
  }
  motion.direction = index_in(options, "direction");
  motion.offset = index_in(options, "offset");
  motion.slice_times_s = numbers_in(options, "slice_times_s");
  if (const auto along = numbers_in(options, "along"); along.size() == 3) {
    motion.along = Eigen::Vector3d(along[0], along[1], along[2]).normalized();
  }
  return motion;
}

}  // namespace glisson::casefile

#include "imaging/internal/motion_encoding.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>

#include "base/text.h"

namespace glisson::imaging {
namespace {

// The number in "NAME[number]".
std::optional<double> bracketed(const std::string& text, const std::string& name) {
  const std::size_t at = text.find(name + "[");
  if (at == std::string::npos) return std::nullopt;
  return read_leading_number(std::string_view(text).substr(at + name.size() + 1));
}

std::optional<int> index_in(const std::string& text, const std::string& name) {
  const auto number = bracketed(text, name);
  if (!number || *number < 0 || *number > 1000) return std::nullopt;
  return static_cast<int>(*number);
}

}  // namespace

MotionEncoding motion_encoding_of(const DicomImage& image, const Picture& picture) {
  MotionEncoding motion = motion_in_comments(picture.comments.empty() ? image.comments : picture.comments);
  for (const std::string* text : {&picture.comments, &image.description, &image.protocol, &image.comments}) {
    if (!motion.frequency_Hz) motion.frequency_Hz = frequency_in_text_Hz(*text);
  }
  if (!motion.along) motion.along = picture.motion_along;
  if (!motion.offset && picture.temporal_position > 0) motion.offset = picture.temporal_position - 1;
  return motion;
}

void number_directions(std::vector<MotionEncoding>& motions) {
  std::vector<Eigen::Vector3d> directions;
  std::vector<int> number;
  for (const MotionEncoding& motion : motions) {
    if (motion.direction || !motion.along) return;
    const auto same = [&](const Eigen::Vector3d& known) { return (known - *motion.along).norm() < 0.01; };
    const auto known = std::find_if(directions.begin(), directions.end(), same);
    number.push_back(static_cast<int>(known - directions.begin()));
    if (known == directions.end()) directions.push_back(*motion.along);
  }
  if (directions.size() < 2) return;
  for (std::size_t v = 0; v < motions.size(); ++v) motions[v].direction = number[v];
}

MotionEncoding motion_in_comments(const std::string& comments) {
  MotionEncoding motion;
  if (!comments.starts_with("MRE:")) return motion;
  motion.direction = index_in(comments, "dI");
  motion.offset = index_in(comments, "tI");
  const auto period_us = bracketed(comments, "VP");
  if (period_us && *period_us > 0) motion.frequency_Hz = 1e6 / *period_us;
  const auto azimuth_deg = bracketed(comments, "az");
  const auto polar_deg = bracketed(comments, "po");
  if (azimuth_deg && polar_deg) {
    const double azimuth = *azimuth_deg * std::numbers::pi / 180;
    const double polar = *polar_deg * std::numbers::pi / 180;
    motion.along =
        Eigen::Vector3d(-std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth), std::cos(polar));
  }
  return motion;
}

std::optional<double> frequency_in_text_Hz(const std::string& text) {
  for (std::size_t unit = 1; unit + 1 < text.size(); ++unit) {
    const bool is_hertz = std::toupper(static_cast<unsigned char>(text[unit])) == 'H' &&
                          std::toupper(static_cast<unsigned char>(text[unit + 1])) == 'Z' &&
                          (unit + 2 == text.size() || std::isalpha(static_cast<unsigned char>(text[unit + 2])) == 0);
    if (!is_hertz) continue;
    std::size_t end = unit;
    while (end > 0 && (text[end - 1] == ' ' || text[end - 1] == '_')) --end;
    std::size_t begin = end;
    while (begin > 0 && (std::isdigit(static_cast<unsigned char>(text[begin - 1])) != 0 || text[begin - 1] == '.')) {
      --begin;
    }
    // "kHz" and "MHz" have a letter where digits are looked for, and so name no vibration.
    const auto number = read_leading_number(std::string_view(text).substr(begin, end - begin));
    if (begin < end && number && *number >= 1 && *number <= 2000) return number;
  }
  return std::nullopt;
}

}  // namespace glisson::imaging

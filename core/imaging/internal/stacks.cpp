// What belongs in one stack, by size, orientation, spacing, echo and part of the complex signal.

#include "imaging/internal/stacks.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <map>

#include "imaging/internal/slice_spacing.h"

namespace glisson::imaging {
namespace {

// A thousandth is 0.06 degrees: a millimetre over a metre.
constexpr double direction_tolerance = 1e-3;
constexpr double spacing_tolerance = 1e-3;

// Radial and rotating acquisitions have some 200 orientations. Every picture is compared with every kind, so that more
// would let one file keep the scan busy for hours.
constexpr std::size_t maximum_kinds = 512;

bool same_kind(const std::vector<DicomImage>& images, const PictureRef& a, const PictureRef& b);
std::string kind_of(const Picture& picture);
std::vector<Stack> cut_at_wide_gaps(const std::vector<DicomImage>& images, Stack stack);
void tell_ge_phase_from_magnitude(const std::vector<DicomImage>& images, std::vector<Stack>& stacks);

}  // namespace

Stacks part_into_stacks(const std::vector<DicomImage>& images) {
  Stacks parted;
  std::vector<Stack> alike;
  for (std::size_t i = 0; i < images.size(); ++i) {
    for (std::size_t p = 0; p < images[i].pictures.size(); ++p) {
      const PictureRef ref{i, p};
      const auto found = std::find_if(alike.begin(), alike.end(), [&](const Stack& stack) {
        return same_kind(images, stack.pictures.front(), ref);
      });
      if (found != alike.end()) {
        found->pictures.push_back(ref);
      } else if (alike.size() < maximum_kinds) {
        alike.push_back({{ref}, kind_of(images[i].pictures[p])});
      } else {
        ++parted.pictures_left_out;
      }
    }
  }
  tell_ge_phase_from_magnitude(images, alike);
  for (Stack& stack : alike) {
    for (Stack& part : cut_at_wide_gaps(images, std::move(stack))) parted.stacks.push_back(std::move(part));
  }
  std::stable_sort(parted.stacks.begin(), parted.stacks.end(),
                   [](const Stack& a, const Stack& b) { return a.pictures.size() > b.pictures.size(); });
  return parted;
}

double position_along_normal_mm(const Picture& picture) {
  return picture.along_row.cross(picture.along_column).dot(picture.position_mm);
}

std::string name_of(const std::vector<DicomImage>& images, const PictureRef& ref) {
  const DicomImage& image = images[ref.image];
  const std::string name = image.path.filename().string();
  if (image.pictures.size() == 1) return name;
  return name + (image.frames > 1 ? ", frame " : ", tile ") + std::to_string(ref.picture + 1);
}

namespace {

bool same_kind(const std::vector<DicomImage>& images, const PictureRef& first, const PictureRef& second) {
  const Picture& a = picture_of(images, first);
  const Picture& b = picture_of(images, second);
  const auto close = [](double x, double y) { return std::abs(x - y) <= spacing_tolerance * std::abs(x); };
  return a.columns == b.columns && a.rows == b.rows && a.placed == b.placed && a.component == b.component &&
         a.echo_number == b.echo_number && a.stack_id == b.stack_id && a.mapping.unit == b.mapping.unit &&
         images[first.image].format.is_colour() == images[second.image].format.is_colour() &&
         images[first.image].frame_of_reference_uid == images[second.image].frame_of_reference_uid &&
         close(a.row_spacing_mm, b.row_spacing_mm) && close(a.column_spacing_mm, b.column_spacing_mm) &&
         (a.along_row - b.along_row).norm() <= direction_tolerance &&
         (a.along_column - b.along_column).norm() <= direction_tolerance;
}

std::string kind_of(const Picture& picture) {
  std::string kind;
  if (picture.component == "M") kind = "magnitude";
  if (picture.component == "P") kind = "phase";
  if (picture.component == "R") kind = "real part";
  if (picture.component == "I") kind = "imaginary part";
  if (picture.echo_number > 1) kind += (kind.empty() ? "echo " : ", echo ") + std::to_string(picture.echo_number);
  return kind;
}

std::vector<Stack> cut_at_wide_gaps(const std::vector<DicomImage>& images, Stack stack) {
  if (!picture_of(images, stack.pictures.front()).placed) return {std::move(stack)};
  std::vector<std::pair<double, PictureRef>> ordered;
  for (const PictureRef& ref : stack.pictures) {
    ordered.emplace_back(position_along_normal_mm(picture_of(images, ref)), ref);
  }
  std::stable_sort(ordered.begin(), ordered.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<double> distinct_mm;
  for (const auto& [position_mm, ref] : ordered) {
    if (distinct_mm.empty() || position_mm - distinct_mm.back() > 0.01) distinct_mm.push_back(position_mm);
  }
  const double widest_mm = widest_gap_in_spacings * usual_gap_mm(distinct_mm);
  if (distinct_mm.size() < 3) return {std::move(stack)};
  std::vector<Stack> parts(1, Stack{{}, stack.kind});
  for (std::size_t i = 0; i < ordered.size(); ++i) {
    if (i > 0 && ordered[i].first - ordered[i - 1].first > widest_mm) parts.push_back({{}, stack.kind});
    parts.back().pictures.push_back(ordered[i].second);
  }
  return parts;
}

// GE's raw elastography series holds the phase images first and then as many magnitude images, by instance number,
// with nothing in ImageType to tell them apart (so sorted by the hepatosplenic MRE tools of the Mayo Clinic).
void tell_ge_phase_from_magnitude(const std::vector<DicomImage>& images, std::vector<Stack>& stacks) {
  const DicomImage& first = images.front();
  const bool ge_mre = first.ge_pulse_sequence.find("mre") != std::string::npos && !first.image_type.empty() &&
                      first.image_type.front() == "ORIGINAL" && first.temporal_positions > 0;
  if (!ge_mre || stacks.size() != 1 || !stacks.front().kind.empty()) return;
  std::vector<PictureRef> ordered = stacks.front().pictures;
  std::map<long, std::size_t> at_position;
  for (const PictureRef& ref : ordered) {
    ++at_position[std::lround(position_along_normal_mm(picture_of(images, ref)) * 100)];
  }
  const auto twice = static_cast<std::size_t>(first.temporal_positions) * 2;
  for (const auto& [position, count] : at_position) {
    if (count != twice) return;
  }
  std::stable_sort(ordered.begin(), ordered.end(), [&](const PictureRef& a, const PictureRef& b) {
    return images[a.image].instance_number < images[b.image].instance_number;
  });
  const auto middle = ordered.begin() + static_cast<std::ptrdiff_t>(ordered.size() / 2);
  stacks = {Stack{{ordered.begin(), middle}, "phase"}, Stack{{middle, ordered.end()}, "magnitude"}};
}

}  // namespace
}  // namespace glisson::imaging

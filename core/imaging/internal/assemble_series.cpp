// Stacks, their volumes, places and roles, put together; and where the voxels lie in the files.

#include "imaging/internal/assemble_series.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "imaging/internal/motion_encoding.h"
#include "imaging/internal/place_slices.h"
#include "imaging/internal/roles.h"
#include "imaging/internal/stacks.h"
#include "imaging/internal/voxel_layout.h"

namespace glisson::imaging {
namespace {

using Images = std::vector<DicomImage>;

constexpr std::size_t maximum_problems_of_a_kind = 5;

std::vector<std::string> leave_out_copies(Images& images);
Series assemble_stack(const Images& images, const Stack& stack);
void describe_parts(const std::vector<Stack>& stacks, std::vector<Series>& parts);
void lay_out(const Images& images, const Volumes& volumes, const std::vector<SliceBlend>& blends, Series& series);
void find_role_and_unit(const Images& images, const Stack& stack, Series& series);
void append(std::vector<std::string>& problems, std::vector<std::string> more);

}  // namespace

std::vector<Series> assemble_series(std::vector<DicomImage> images) {
  std::vector<std::string> copies = leave_out_copies(images);
  const Stacks parted = part_into_stacks(images);
  std::vector<Series> parts;
  for (const Stack& stack : parted.stacks) parts.push_back(assemble_stack(images, stack));
  describe_parts(parted.stacks, parts);
  if (parted.pictures_left_out > 0) {
    parts.front().problems.push_back(fmt::format(
        "The series mixes more kinds of picture than can be sorted: {} are left out.", parted.pictures_left_out));
  }
  append(parts.front().problems, std::move(copies));
  return parts;
}

namespace {

// The same image under two names, as when a disc was copied twice.
std::vector<std::string> leave_out_copies(Images& images) {
  std::sort(images.begin(), images.end(), [](const DicomImage& a, const DicomImage& b) { return a.path < b.path; });
  std::vector<std::string> problems;
  std::map<std::string, std::string> first_name;
  Images kept;
  for (DicomImage& image : images) {
    const auto [entry, is_new] = first_name.try_emplace(image.sop_instance_uid, image.path.filename().string());
    if (image.sop_instance_uid.empty() || is_new) {
      kept.push_back(std::move(image));
    } else {
      problems.push_back(fmt::format("{} and {} are the same picture; the second is left out.", entry->second,
                                     image.path.filename().string()));
    }
  }
  images = std::move(kept);
  return problems;
}

Series assemble_stack(const Images& images, const Stack& stack) {
  const PictureRef front = stack.pictures.front();
  const DicomImage& image = images[front.image];
  Series series;
  series.uid = image.series_uid;
  series.study_uid = image.study_uid;
  series.frame_of_reference_uid = image.frame_of_reference_uid;
  series.description = image.description;
  series.modality = image.modality;
  series.number = image.series_number;

  const Volumes volumes = part_into_volumes(images, stack);
  series.volumes = static_cast<int>(volumes.of_volume.size());
  series.volume_labels = volumes.labels;
  const PlacedSlices placed = place_slices(images, volumes);
  series.grid = placed.grid;
  // A segmentation leaves empty frames out, so that gaps in it mean nothing.
  if (image.modality != "SEG") {
    append(series.problems, placed.problems);
    append(series.problems, volumes.problems);
  }
  lay_out(images, volumes, placed.slices, series);
  find_role_and_unit(images, stack, series);
  if (series.role == Role::mre_magnitude || series.role == Role::mre_phase || series.role == Role::mre_wave) {
    for (const std::vector<PictureRef>& slices : volumes.of_volume) {
      const PictureRef first = slices.front();
      MotionEncoding motion = motion_encoding_of(images[first.image], picture_of(images, first));
      for (const PictureRef& slice : slices) {
        const auto time_ms = picture_of(images, slice).time_in_volume_ms;
        if (time_ms) motion.slice_times_s.push_back(1e-3 * *time_ms);
      }
      if (motion.slice_times_s.size() != static_cast<std::size_t>(series.grid.size[2])) motion.slice_times_s.clear();
      series.motion.push_back(std::move(motion));
    }
    number_directions(series.motion);
  }
  append(series.problems, image.problems);
  return series;
}

void describe_parts(const std::vector<Stack>& stacks, std::vector<Series>& parts) {
  if (parts.size() < 2) return;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0) parts[i].uid += "#" + std::to_string(i + 1);
    const std::string kind = stacks[i].kind.empty() ? "" : ": " + stacks[i].kind;
    const Grid& grid = parts[i].grid;
    parts[i].problems.insert(
        parts[i].problems.begin(),
        fmt::format("The series mixes sizes, orientations or kinds of picture; this is stack {} of {}, with {} x {} x "
                    "{} voxels{}.",
                    i + 1, parts.size(), grid.size[0], grid.size[1], grid.size[2], kind));
  }
}

void lay_out(const Images& images, const Volumes& volumes, const std::vector<SliceBlend>& blends, Series& series) {
  auto layout = std::make_shared<VoxelLayout>();
  std::map<std::size_t, int> file_of_image;
  for (const std::vector<PictureRef>& slices : volumes.of_volume) {
    const int first_source = static_cast<int>(layout->sources.size());
    for (const PictureRef& ref : slices) {
      const DicomImage& image = images[ref.image];
      const auto [entry, is_new] = file_of_image.try_emplace(ref.image, static_cast<int>(layout->files.size()));
      if (is_new) {
        layout->files.push_back({image.path, image.file_bytes, image.frames, image.syntax, image.format, image.pixels});
        series.files.push_back(image.path);
      }
      const Picture& picture = image.pictures[ref.picture];
      layout->sources.push_back(
          {entry->second, picture.frame, picture.left, picture.top, picture.mapping.slope, picture.mapping.intercept});
    }
    for (const SliceBlend& blend : blends) {
      const bool alone = blend.first == blend.second;
      layout->slices.push_back({first_source + static_cast<int>(blend.first),
                                alone ? -1 : first_source + static_cast<int>(blend.second),
                                static_cast<float>(blend.weight_of_second)});
    }
  }
  series.layout = std::move(layout);
}

void find_role_and_unit(const Images& images, const Stack& stack, Series& series) {
  const DicomImage& image = images[stack.pictures.front().image];
  const Picture& picture = picture_of(images, stack.pictures.front());
  series.unit = picture.mapping.unit;
  series.unit_evidence = picture.mapping.evidence;

  RoleClues clues;
  clues.modality = image.modality;
  clues.manufacturer = image.manufacturer;
  clues.image_type = image.image_type;
  clues.description = image.description;
  clues.protocol = image.protocol;
  clues.sequence_name = image.sequence_name;
  clues.comments = image.comments;
  clues.ge_pulse_sequence = image.ge_pulse_sequence;
  clues.unit = series.unit;
  clues.component = picture.component;
  if (stack.kind == "phase") clues.component = "P";
  if (stack.kind == "magnitude") clues.component = "M";
  clues.is_colour = image.format.is_colour();
  clues.volumes = series.volumes;
  clues.series_number = image.series_number;
  clues.window_center = image.window_center;
  clues.window_width = image.window_width;
  const RoleFinding finding = role_of(clues);
  series.role = finding.role;
  series.role_evidence = finding.evidence;

  if (clues.is_colour) series.problems.push_back("The pictures are in colour, so that they hold no values to measure.");
  const bool wants_rescale = image.modality == "CT" || series.role == Role::mre_phase ||
                             series.role == Role::mre_wave || series.role == Role::mre_stiffness;
  if (wants_rescale && !picture.mapping.stated && image.pixels.element == 0x0010 && !clues.is_colour) {
    series.problems.push_back("No rescale is given: the values are taken as they are stored.");
  }
  if (!picture.placed && series.role != Role::other) {
    series.role = Role::other;
    series.role_evidence = "no place in the patient is given";
  }
}

void append(std::vector<std::string>& problems, std::vector<std::string> more) {
  for (std::size_t i = 0; i < more.size(); ++i) {
    if (i == maximum_problems_of_a_kind) {
      problems.push_back(fmt::format("And {} more of this kind.", more.size() - i));
      return;
    }
    problems.push_back(std::move(more[i]));
  }
}

}  // namespace
}  // namespace glisson::imaging

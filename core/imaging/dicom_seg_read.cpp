// Reading DICOM SEG from its data set directly. For formal faults dcmseg refuses much that other programs write. Here
// it is read all the same, as long as it says where the voxels are.

#include "imaging/dicom_seg.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <map>

#include "imaging/internal/cielab.h"
#include "imaging/internal/dicom_fields.h"
#include "imaging/internal/file_bytes.h"

namespace glisson::imaging {
namespace fs = std::filesystem;
namespace {

// One frame: a plane of one segment.
struct Frame {
  int segment_number = 0;
  Eigen::Vector3d position_mm{0, 0, 0};
  int plane = 0;  // on the common grid
};

struct Layout {
  int rows = 0, columns = 0;
  int bits = 1;         // allocated: 1 or 8
  int inside_from = 1;  // the smallest stored value that counts as inside
  std::vector<Frame> frames;
  Grid grid;
};
Result<Layout> layout_of(DcmDataset& data_set, const fs::path& file);
Result<void> place_planes(Layout& layout, double declared_spacing_mm, const fs::path& file);
std::vector<SegmentInfo> segments_of(DcmDataset& data_set, std::map<int, std::size_t>& index_of_number);
Result<void> read_frames(const Layout& layout, const PixelElement& pixels, const fs::path& file,
                         const std::map<int, std::size_t>& index_of_number, std::vector<SegmentedMask>& segments);

Failure refused(const char* code, const char* sentence, const fs::path& file, const std::string& detail = "") {
  return failure(Error{code,
                       sentence,
                       {file.string(), detail},
                       GLISSON_TEXT("Export the segmentation again, as binary and uncompressed DICOM SEG."),
                       file});
}

}  // namespace

Result<std::vector<SegmentedMask>> read_dicom_seg(const fs::path& file) {
  const auto checked = check_dicom_file(file);
  if (!checked) return failure(checked.error());
  const auto data_set = parse(*checked);
  if (!data_set || text_of(*data_set, DCM_SOPClassUID) != UID_SegmentationStorage || !checked->pixels) {
    return refused("dicom-seg-not-a-segmentation", GLISSON_TEXT("{0} is not a DICOM segmentation."), file);
  }
  if (checked->syntax.encapsulated || !checked->syntax.little_endian) {
    return refused("dicom-seg-compressed", GLISSON_TEXT("The segmentation {0} is compressed (or big endian)."), file);
  }
  const auto layout = layout_of(*data_set, file);
  if (!layout) return failure(layout.error());

  std::map<int, std::size_t> index_of_number;
  std::vector<SegmentedMask> segments;
  for (SegmentInfo& info : segments_of(*data_set, index_of_number)) segments.push_back({std::move(info), {}});
  constexpr double maximum_bytes = 4294967296.0;
  const auto voxels = static_cast<double>(layout->grid.voxels());
  if (segments.empty() || voxels * static_cast<double>(segments.size()) > maximum_bytes) {
    return refused("dicom-seg-too-large",
                   GLISSON_TEXT("The segmentation {0} names no segment, or too many for its size: {1}."), file,
                   std::to_string(segments.size()));
  }
  for (SegmentedMask& segment : segments)
    segment.mask = {layout->grid, std::vector<std::uint8_t>(layout->grid.voxels())};
  if (auto read = read_frames(*layout, *checked->pixels, file, index_of_number, segments); !read) {
    return failure(std::move(read.error()));
  }
  return segments;
}

Result<SegmentationSource> segmentation_source(const std::vector<fs::path>& slice_files) {
  SegmentationSource source;
  for (const fs::path& file : slice_files) {
    const auto checked = check_dicom_file(file);
    if (!checked) return failure(checked.error());
    const auto data_set = parse(*checked);
    if (!data_set) return refused("dicom-damaged", GLISSON_TEXT("The headers of {0} are damaged."), file);
    source.instances.push_back({text_of(*data_set, DCM_SOPClassUID), text_of(*data_set, DCM_SOPInstanceUID)});
    if (source.instances.size() > 1) continue;
    source.patient_name = text_of(*data_set, DCM_PatientName);
    source.patient_id = text_of(*data_set, DCM_PatientID);
    source.patient_comments = text_of(*data_set, DCM_PatientComments);
    source.study_uid = text_of(*data_set, DCM_StudyInstanceUID);
    source.series_uid = text_of(*data_set, DCM_SeriesInstanceUID);
    source.frame_of_reference_uid = text_of(*data_set, DCM_FrameOfReferenceUID);
    source.study_date = text_of(*data_set, DCM_StudyDate);
    source.study_time = text_of(*data_set, DCM_StudyTime);
  }
  return source;
}

namespace {

// The item of a functional group of one frame, or the one that all frames share; null if neither has it.
DcmItem* functional_group(DcmItem* frame, DcmItem* shared, const DcmTagKey& group) {
  for (DcmItem* place : {frame, shared}) {
    if (!place) continue;
    if (DcmItem* item = item_of(*place, group)) return item;
  }
  return nullptr;
}

std::vector<double> group_numbers(DcmItem* frame, DcmItem* shared, const DcmTagKey& group, const DcmTagKey& key) {
  DcmItem* item = functional_group(frame, shared, group);
  return item ? numbers_of(*item, key) : std::vector<double>{};
}

Result<Layout> layout_of(DcmDataset& data_set, const fs::path& file) {
  const auto bad_geometry = [&](const std::string& what) {
    return refused("dicom-seg-bad-geometry",
                   GLISSON_TEXT("The segmentation {0} does not say where its frames are: {1}."), file, what);
  };
  Layout layout;
  layout.rows = whole_number_of(data_set, DCM_Rows, 0);
  layout.columns = whole_number_of(data_set, DCM_Columns, 0);
  layout.bits = whole_number_of(data_set, DCM_BitsAllocated, 0);
  const bool fractional = text_of(data_set, DCM_SegmentationType) == "FRACTIONAL";
  if (fractional) layout.inside_from = (whole_number_of(data_set, DCM_MaximumFractionalValue, 255) + 1) / 2;
  layout.inside_from = std::max(1, layout.inside_from);
  const int frames = whole_number_of(data_set, DCM_NumberOfFrames, 0);
  if (layout.rows < 1 || layout.columns < 1 || frames < 1 || (layout.bits != 1 && layout.bits != 8)) {
    return bad_geometry(GLISSON_TEXT("rows, columns, frames or bits"));
  }

  DcmItem* shared = item_of(data_set, DCM_SharedFunctionalGroupsSequence);
  std::vector<double> orientation, pixel_spacing;
  double spacing_mm = 0;
  for (int f = 0; f < frames; ++f) {
    DcmItem* item = item_of(data_set, DCM_PerFrameFunctionalGroupsSequence, static_cast<unsigned>(f));
    const auto position = group_numbers(item, shared, DCM_PlanePositionSequence, DCM_ImagePositionPatient);
    const auto number = group_numbers(item, shared, DCM_SegmentIdentificationSequence, DCM_ReferencedSegmentNumber);
    const auto own = group_numbers(item, shared, DCM_PlaneOrientationSequence, DCM_ImageOrientationPatient);
    if (!item || position.size() != 3 || number.empty() || own.size() != 6 || (f > 0 && own != orientation)) {
      return bad_geometry(fmt::format("frame {}", f + 1));
    }
    if (f == 0) {
      orientation = own;
      pixel_spacing = group_numbers(item, shared, DCM_PixelMeasuresSequence, DCM_PixelSpacing);
      const auto between = group_numbers(item, shared, DCM_PixelMeasuresSequence, DCM_SpacingBetweenSlices);
      const auto thickness = group_numbers(item, shared, DCM_PixelMeasuresSequence, DCM_SliceThickness);
      spacing_mm = !between.empty() ? between[0] : !thickness.empty() ? thickness[0] : 0;
    }
    layout.frames.push_back({static_cast<int>(number[0]), {position[0], position[1], position[2]}, 0});
  }

  const Eigen::Vector3d row(orientation[0], orientation[1], orientation[2]);
  const Eigen::Vector3d column(orientation[3], orientation[4], orientation[5]);
  // Directions are written with few digits at times: a thousandth off is still at right angles.
  if (std::abs(row.norm() - 1) > 1e-3 || std::abs(column.norm() - 1) > 1e-3 || std::abs(row.dot(column)) > 1e-3) {
    return bad_geometry("orientation");
  }
  if (pixel_spacing.size() != 2 || !(pixel_spacing[0] > 0) || !(pixel_spacing[1] > 0)) {
    return bad_geometry(GLISSON_TEXT("pixel spacing"));
  }
  layout.grid.direction.col(0) = row.normalized();
  layout.grid.direction.col(1) = column.normalized();
  layout.grid.direction.col(2) = row.cross(column).normalized();
  layout.grid.spacing_mm = {pixel_spacing[1], pixel_spacing[0], 1};  // DICOM gives that between rows first
  if (auto placed = place_planes(layout, std::abs(spacing_mm), file); !placed)
    return failure(std::move(placed.error()));
  return layout;
}

// Finds the evenly spaced planes that the frames lie on. The spacing is the declared one if all positions fit it,
// else the smallest step between two planes.
Result<void> place_planes(Layout& layout, double declared_spacing_mm, const fs::path& file) {
  constexpr double same_place_mm = 1e-2;  // positions are written with as few as four decimals
  const Eigen::Vector3d normal = layout.grid.direction.col(2);
  const auto first = std::min_element(layout.frames.begin(), layout.frames.end(), [&](const Frame& a, const Frame& b) {
    return normal.dot(a.position_mm) < normal.dot(b.position_mm);
  });
  const Eigen::Vector3d origin = first->position_mm;
  std::vector<double> heights_mm;
  for (const Frame& frame : layout.frames) {
    const Eigen::Vector3d from = frame.position_mm - origin;
    heights_mm.push_back(normal.dot(from));
    if ((from - heights_mm.back() * normal).norm() > 0.5 * layout.grid.spacing_mm.head<2>().minCoeff()) {
      return refused("dicom-seg-bad-geometry",
                     GLISSON_TEXT("The frames of the segmentation {0} are not above each other."), file);
    }
  }
  std::vector<double> sorted = heights_mm;
  std::sort(sorted.begin(), sorted.end());
  double smallest_step_mm = 0;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    const double step = sorted[i] - sorted[i - 1];
    if (step > same_place_mm && (smallest_step_mm == 0 || step < smallest_step_mm)) smallest_step_mm = step;
  }

  const auto fits = [&](double spacing_mm) {
    return spacing_mm > same_place_mm && std::all_of(sorted.begin(), sorted.end(), [&](double height) {
             const double off_mm = std::abs(height - spacing_mm * std::round(height / spacing_mm));
             return off_mm < 0.05 * spacing_mm + same_place_mm;
           });
  };
  double spacing_mm = 0;
  for (const double candidate : {declared_spacing_mm, smallest_step_mm}) {
    if (spacing_mm == 0 && fits(candidate)) spacing_mm = candidate;
  }
  constexpr double maximum_planes = 16384;
  if (sorted.back() <= same_place_mm && spacing_mm == 0) spacing_mm = 1;  // a single plane of unknown thickness
  if (spacing_mm == 0 || sorted.back() / spacing_mm > maximum_planes) {
    return refused("dicom-seg-bad-geometry", GLISSON_TEXT("The frames of the segmentation {0} are not evenly spaced."),
                   file);
  }
  // The average over all steps, where the declared spacing is rounded.
  const double steps = std::round(sorted.back() / spacing_mm);
  if (steps > 0) spacing_mm = sorted.back() / steps;
  for (std::size_t f = 0; f < layout.frames.size(); ++f) {
    layout.frames[f].plane = static_cast<int>(std::lround(heights_mm[f] / spacing_mm));
  }
  layout.grid.origin_mm = origin;
  layout.grid.spacing_mm[2] = spacing_mm;
  layout.grid.size = {layout.columns, layout.rows, static_cast<int>(steps) + 1};
  return {};
}

std::vector<SegmentInfo> segments_of(DcmDataset& data_set, std::map<int, std::size_t>& index_of_number) {
  std::vector<SegmentInfo> segments;
  for (unsigned n = 0; DcmItem* item = item_of(data_set, DCM_SegmentSequence, n); ++n) {
    const int number = whole_number_of(*item, DCM_SegmentNumber, static_cast<int>(n) + 1);
    if (!index_of_number.emplace(number, segments.size()).second) continue;
    SegmentInfo info;
    info.name = text_of(*item, DCM_SegmentLabel);
    if (info.name.empty()) info.name = fmt::format("segment-{}", number);
    info.label_value = number >= 1 && number <= 255 ? number : 1;
    const auto lab = numbers_of(*item, DCM_RecommendedDisplayCIELabValue);
    if (lab.size() == 3) {
      std::array<std::uint16_t, 3> stored{};
      for (std::size_t i = 0; i < 3; ++i) stored[i] = static_cast<std::uint16_t>(std::clamp(lab[i], 0.0, 65535.0));
      info.color_rgb = srgb_from_cielab(stored);
    }
    segments.push_back(std::move(info));
  }
  return segments;
}

// Binary frames follow each other bit by bit, lowest bit first, with no gap between frames (PS3.5 8.1.1).
Result<void> read_frames(const Layout& layout, const PixelElement& pixels, const fs::path& file,
                         const std::map<int, std::size_t>& index_of_number, std::vector<SegmentedMask>& segments) {
  const auto area = static_cast<std::uint64_t>(layout.rows) * static_cast<std::uint64_t>(layout.columns);
  const auto frames = static_cast<std::uint64_t>(layout.frames.size());
  const auto bits = static_cast<std::uint64_t>(layout.bits);
  if ((area * frames * bits + 7) / 8 > pixels.native.length) {
    return refused("dicom-seg-truncated", GLISSON_TEXT("The segmentation {0} holds fewer frames than it declares."),
                   file);
  }
  const auto opened = OpenFile::open(file);
  if (!opened) return failure(opened.error());
  std::vector<std::uint8_t> bytes;
  for (std::uint64_t f = 0; f < frames; ++f) {
    const Frame& frame = layout.frames[static_cast<std::size_t>(f)];
    const auto index = index_of_number.find(frame.segment_number);
    if (index == index_of_number.end()) continue;  // of a segment that is not described
    const std::uint64_t first_bit = f * area * bits, end_bit = first_bit + area * bits;
    const std::uint64_t begin = first_bit / 8, count = (end_bit + 7) / 8 - begin;
    bytes.resize(static_cast<std::size_t>(count));
    if (opened->read(pixels.native.offset + begin, count, bytes.data()) != count) {
      return refused("dicom-seg-truncated", GLISSON_TEXT("The segmentation {0} ends before its last frame."), file);
    }
    std::uint8_t* plane = segments[index->second].mask.values.data() + area * static_cast<std::uint64_t>(frame.plane);
    for (std::uint64_t i = 0; i < area; ++i) {
      const std::uint64_t bit = first_bit % 8 + i * bits;
      const int stored = bits == 8 ? bytes[bit / 8] : (bytes[bit / 8] >> (bit % 8)) & 1;
      if (stored >= layout.inside_from) plane[i] = 1;
    }
  }
  return {};
}

}  // namespace
}  // namespace glisson::imaging

// NIfTI, NRRD and MetaImage: read by ourselves (volume_header.h, voxel_stream.h), written through ITK's writers of
// those formats, used without ITK's image pipeline.

#include "imaging/volume_file.h"

#include <fmt/format.h>
#include <itkMetaDataObject.h>
#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <sstream>

#include "base/files.h"
#include "imaging/internal/volume_header.h"
#include "imaging/internal/voxel_stream.h"
#include "imaging/segment_codes.h"
#include "imaging/segments_file.h"

namespace glisson::imaging {
namespace fs = std::filesystem;
namespace {

constexpr const char* unit_key = "unit";

itk::ImageIOBase::Pointer io_for(const fs::path& file);

// Reads the values, each turned by convert(double) -> Value. Memory is used as they come, not as the header promises.
template <typename Value, typename Convert>
Result<std::vector<Value>> read_values(const VolumeHeader& header, const fs::path& file, Convert convert) {
  std::vector<Value> values;
  values.reserve(header.grid.voxels());
  const auto read = read_voxels(header, file, [&](const double* block, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) values.push_back(convert(block[i]));
  });
  if (!read) return failure(read.error());
  return values;
}

Result<void> write_values(const fs::path& target, const Grid& grid, const void* values, itk::IOComponentEnum type,
                          const std::vector<std::pair<std::string, std::string>>& notes);

// The keys are those of Slicer's segmentation storage node (vtkMRMLSegmentationStorageNode), version 5.
std::vector<std::pair<std::string, std::string>> slicer_fields(const Grid& grid,
                                                               const std::vector<SegmentInfo>& segments);

std::string note(const VolumeHeader& header, const std::string& key);
std::optional<SegmentInfo> segment_of(const VolumeHeader& header);
Result<LabelMap> read_labels(const VolumeHeader& header, const fs::path& file);

}  // namespace

Result<Volume> read_volume_file(const fs::path& file) {
  const auto header = read_volume_header(file);
  if (!header) return failure(header.error());
  auto values = read_values<float>(*header, file, [](double value) { return static_cast<float>(value); });
  if (!values) return failure(std::move(values.error()));

  Volume volume;
  volume.grid = header->grid;
  volume.values = std::move(*values);
  volume.unit = note(*header, unit_key);
  return volume;
}

Result<VolumeFileHeader> read_volume_file_header(const fs::path& file) {
  const auto header = read_volume_header(file);
  if (!header) return failure(header.error());
  return VolumeFileHeader{header->grid, note(*header, unit_key),
                          bytes_of(header->type) == 1 && header->slope == 1 && header->intercept == 0};
}

bool has_volume_file_name(const fs::path& file) { return has_volume_header_name(file); }

Result<LabelMap> read_labels_file(const fs::path& file) {
  const auto header = read_volume_header(file);
  if (!header) return failure(header.error());
  return read_labels(*header, file);
}

Result<void> write_volume_file(const fs::path& file, const Volume& volume) {
  GLISSON_ASSERT(volume.values.size() == volume.grid.voxels());
  std::vector<std::pair<std::string, std::string>> notes;
  if (!volume.unit.empty()) notes.emplace_back(unit_key, volume.unit);
  return write_values(file, volume.grid, volume.values.data(), itk::IOComponentEnum::FLOAT, notes);
}

Result<void> write_mask_file(const fs::path& file, const Mask& mask, const SegmentInfo& info) {
  GLISSON_ASSERT(mask.values.size() == mask.grid.voxels());
  GLISSON_ASSERT(info.label_value >= 1 && info.label_value <= 255);
  std::vector<std::uint8_t> labels(mask.values.size());
  std::transform(mask.values.begin(), mask.values.end(), labels.begin(), [&](std::uint8_t inside) {
    return inside != 0 ? static_cast<std::uint8_t>(info.label_value) : std::uint8_t{0};
  });
  return write_values(file, mask.grid, labels.data(), itk::IOComponentEnum::UCHAR, slicer_fields(mask.grid, {info}));
}

Result<void> write_segments_file(const fs::path& file, const LabelMap& labels,
                                 const std::vector<SegmentInfo>& segments) {
  GLISSON_ASSERT(labels.values.size() == labels.grid.voxels());
  const auto notes = slicer_fields(labels.grid, segments);
  const bool small = std::all_of(labels.values.begin(), labels.values.end(), [](auto value) { return value <= 255; });
  if (!small) {
    return write_values(file, labels.grid, labels.values.data(), itk::IOComponentEnum::USHORT, notes);
  }
  const std::vector<std::uint8_t> bytes(labels.values.begin(), labels.values.end());
  return write_values(file, labels.grid, bytes.data(), itk::IOComponentEnum::UCHAR, notes);
}

Result<SegmentedMask> read_mask_file(const fs::path& file) {
  const auto header = read_volume_header(file);
  if (!header) return failure(header.error());
  const auto labels = read_labels(*header, file);
  if (!labels) return failure(labels.error());
  const std::optional<SegmentInfo> named = segment_of(*header);

  SegmentedMask segment;
  segment.info = named.value_or(SegmentInfo{file.stem().string()});
  segment.mask.grid = labels->grid;
  segment.mask.values.resize(labels->values.size());
  std::transform(labels->values.begin(), labels->values.end(), segment.mask.values.begin(), [&](std::uint16_t label) {
    return static_cast<std::uint8_t>(named ? label == named->label_value : label != 0);
  });
  return segment;
}

namespace {

itk::ImageIOBase::Pointer io_for(const fs::path& file) {
  const std::string name = lower_case_name(file);
  if (name.ends_with(".nii") || name.ends_with(".nii.gz")) return itk::NiftiImageIO::New().GetPointer();
  if (name.ends_with(".nrrd") || name.ends_with(".nhdr")) return itk::NrrdImageIO::New().GetPointer();
  if (name.ends_with(".mha") || name.ends_with(".mhd")) return itk::MetaImageIO::New().GetPointer();
  return nullptr;
}

Failure unknown_type(const fs::path& file) {
  return failure(Error{"volume-file-unknown-type",
                       GLISSON_TEXT("{0} is not of a known kind of volume file."),
                       {file.string()},
                       GLISSON_TEXT("Known are .nii, .nii.gz, .nrrd, .nhdr, .mha and .mhd."),
                       file});
}

// ITK's own sentence without its source line and object address.
std::string reason_of(const itk::ExceptionObject& exception) {
  std::string reason = exception.GetDescription();
  if (const auto colon = reason.find("): "); colon != std::string::npos) reason.erase(0, colon + 3);
  reason.erase(std::remove(reason.begin(), reason.end(), '\n'), reason.end());
  return reason.substr(0, 200);
}

Result<void> write_values(const fs::path& target, const Grid& grid, const void* values, itk::IOComponentEnum type,
                          const std::vector<std::pair<std::string, std::string>>& notes) {
  return write_atomically(target, [&](const fs::path& beside) -> Result<void> {
    const itk::ImageIOBase::Pointer io = io_for(beside);
    if (!io) return unknown_type(target);
    try {
      itk::ImageIORegion region(3);
      io->SetFileName(beside.string());
      io->SetNumberOfDimensions(3);
      for (unsigned axis = 0; axis < 3; ++axis) {
        const auto length = static_cast<itk::SizeValueType>(grid.size[axis]);
        io->SetDimensions(axis, length);
        io->SetSpacing(axis, grid.spacing_mm[axis]);
        io->SetOrigin(axis, grid.origin_mm[axis]);
        const Eigen::Vector3d direction = grid.direction.col(axis);
        io->SetDirection(axis, {direction.x(), direction.y(), direction.z()});
        region.SetIndex(axis, 0);
        region.SetSize(axis, length);
      }
      io->SetIORegion(region);
      io->SetPixelType(itk::IOPixelEnum::SCALAR);
      io->SetNumberOfComponents(1);
      io->SetComponentType(type);
      io->SetUseCompression(true);
      for (const auto& [key, text] : notes) {
        itk::EncapsulateMetaData<std::string>(io->GetMetaDataDictionary(), key, text);
      }
      io->WriteImageInformation();
      io->Write(values);
    } catch (const itk::ExceptionObject& exception) {
      return failure("volume-file-not-written", GLISSON_TEXT("{0} cannot be written: {1}."),
                     {target.string(), reason_of(exception)});
    }
    return {};
  });
}

std::string note(const VolumeHeader& header, const std::string& key) {
  const auto found = header.notes.find(key);
  return found == header.notes.end() ? std::string() : found->second;
}

std::vector<std::pair<std::string, std::string>> slicer_fields(const Grid& grid,
                                                               const std::vector<SegmentInfo>& segments) {
  const auto& size = grid.size;
  std::vector<std::pair<std::string, std::string>> fields;
  for (std::size_t n = 0; n < segments.size(); ++n) {
    const SegmentInfo& info = segments[n];
    const auto& color = info.color_rgb;
    const std::string key = fmt::format("Segment{}_", n);
    fields.insert(fields.end(),
                  {{key + "ID", info.name},
                   {key + "Name", info.name},
                   {key + "NameAutoGenerated", "0"},
                   {key + "Color", fmt::format("{:.6g} {:.6g} {:.6g}", color[0], color[1], color[2])},
                   {key + "ColorAutoGenerated", "0"},
                   {key + "LabelValue", std::to_string(info.label_value)},
                   {key + "Layer", "0"},
                   {key + "Tags", slicer_tags(info.name)},
                   {key + "Extent", fmt::format("0 {} 0 {} 0 {}", size[0] - 1, size[1] - 1, size[2] - 1)}});
  }
  fields.insert(fields.end(), {{"Segmentation_MasterRepresentation", "Binary labelmap"},
                               {"Segmentation_ContainedRepresentationNames", "Binary labelmap|"},
                               {"Segmentation_ReferenceImageExtentOffset", "0 0 0"}});
  return fields;
}

std::optional<SegmentInfo> segment_of(const VolumeHeader& header) {
  SegmentInfo info;
  info.name = note(header, "Segment0_Name");
  if (info.name.empty()) return std::nullopt;
  std::istringstream(note(header, "Segment0_LabelValue")) >> info.label_value;
  std::array<double, 3> color{};
  if (std::istringstream(note(header, "Segment0_Color")) >> color[0] >> color[1] >> color[2]) info.color_rgb = color;
  return info;
}

Result<LabelMap> read_labels(const VolumeHeader& header, const fs::path& file) {
  std::optional<double> stranger;
  auto values = read_values<std::uint16_t>(header, file, [&](double value) {
    const bool is_label = value >= 0 && value <= 65535 && value == std::floor(value);
    if (!is_label && !stranger) stranger = value;
    return is_label ? static_cast<std::uint16_t>(value) : std::uint16_t{0};
  });
  if (!values) return failure(std::move(values.error()));
  if (stranger) {
    return failure(Error{"volume-file-not-labels",
                         GLISSON_TEXT("{0} is not a label map: it holds the value {1}."),
                         {file.string(), fmt::format("{:g}", *stranger)},
                         GLISSON_TEXT("A label map holds whole numbers from 0 to 65535."),
                         file});
  }
  return LabelMap{header.grid, std::move(*values)};
}

}  // namespace
}  // namespace glisson::imaging

// Writing DICOM SEG (PS3.3 A.51): binary, uncompressed, one stack of planes.

#include "imaging/dicom_seg.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <algorithm>
#include <chrono>
#include <Eigen/Geometry>

#include "base/files.h"
#include "imaging/dicom_uid.h"
#include "imaging/internal/cielab.h"
#include "imaging/internal/dicom_text.h"
#include "imaging/segment_codes.h"

// DCMTK after ours: its headers define macros.
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

namespace glisson::imaging {
namespace fs = std::filesystem;
namespace {

// An item of the data set that remembers whether everything went in.
class Item {
 public:
  Item(DcmItem* item, bool& good) : item_(item), good_(good) { good_ = good_ && item_ != nullptr; }
  void text(const DcmTagKey& tag, const std::string& value) {
    good_ = good_ && item_->putAndInsertString(tag, value.c_str()).good();
  }
  void words(const DcmTagKey& tag, const std::vector<Uint16>& values) {
    good_ = good_ && item_->putAndInsertUint16Array(tag, values.data(), values.size()).good();
  }
  void longs(const DcmTagKey& tag, const std::vector<Uint32>& values) {
    good_ = good_ && item_->putAndInsertUint32Array(tag, values.data(), values.size()).good();
  }
  void tag_of(const DcmTagKey& tag, const DcmTagKey& value) {
    good_ = good_ && item_->putAndInsertTagKey(tag, value).good();
  }
  void bytes(const DcmTagKey& tag, const std::vector<Uint8>& values) {
    good_ = good_ && item_->putAndInsertUint8Array(tag, values.data(), values.size()).good();
  }
  // A new item at the end of a sequence.
  Item add(const DcmTagKey& sequence) {
    DcmItem* item = nullptr;
    if (good_) good_ = item_->findOrCreateSequenceItem(sequence, item, -2).good();
    return {item, good_};
  }
  void code(const DcmTagKey& sequence, const char* value, const char* scheme, const char* meaning) {
    Item item = add(sequence);
    item.text(DCM_CodeValue, value);
    item.text(DCM_CodingSchemeDesignator, scheme);
    item.text(DCM_CodeMeaning, meaning);
  }

 private:
  DcmItem* item_;
  bool& good_;
};

// A plane of one segment; frames are written in this order.
struct PlannedFrame {
  std::size_t segment;
  int plane;
};
std::vector<PlannedFrame> planned_frames(const std::vector<SegmentedMask>& segments);
Result<void> check(const std::vector<SegmentedMask>& segments, const SegmentationSource& source);
void describe_study(Item& data_set, const std::vector<SegmentedMask>& segments, const SegmentationSource& source);
void describe_segments(Item& data_set, const std::vector<SegmentedMask>& segments);
void describe_frames(Item& data_set, const std::vector<PlannedFrame>& frames, const Grid& grid,
                     const SegmentationSource& source);
std::vector<Uint8> packed_bits(const std::vector<PlannedFrame>& frames, const std::vector<SegmentedMask>& segments);

}  // namespace

Result<void> write_dicom_seg(const fs::path& file, const std::vector<SegmentedMask>& segments,
                             const SegmentationSource& source) {
  if (auto checked = check(segments, source); !checked) return checked;
  const std::vector<PlannedFrame> frames = planned_frames(segments);
  const Grid& grid = segments.front().mask.grid;

  DcmFileFormat format;
  bool good = true;
  Item data_set(format.getDataset(), good);
  describe_study(data_set, segments, source);
  data_set.words(DCM_SamplesPerPixel, {1});
  data_set.text(DCM_PhotometricInterpretation, "MONOCHROME2");
  data_set.text(DCM_NumberOfFrames, std::to_string(frames.size()));
  data_set.words(DCM_Rows, {static_cast<Uint16>(grid.size[1])});
  data_set.words(DCM_Columns, {static_cast<Uint16>(grid.size[0])});
  data_set.words(DCM_BitsAllocated, {1});
  data_set.words(DCM_BitsStored, {1});
  data_set.words(DCM_HighBit, {0});
  data_set.words(DCM_PixelRepresentation, {0});
  data_set.text(DCM_LossyImageCompression, "00");
  data_set.text(DCM_SegmentationType, "BINARY");
  describe_segments(data_set, segments);
  describe_frames(data_set, frames, grid, source);
  data_set.bytes(DCM_PixelData, packed_bits(frames, segments));

  return write_atomically(file, [&](const fs::path& beside) -> Result<void> {
    const OFCondition saved = good ? format.saveFile(beside.c_str(), EXS_LittleEndianExplicit) : EC_IllegalCall;
    if (saved.good()) return {};
    return failure(Error{"dicom-seg-not-written",
                         GLISSON_TEXT("{0} cannot be written: {1}."),
                         {file.string(), saved.text()},
                         GLISSON_TEXT("Check the folder, your rights there and the free space."),
                         file});
  });
}

namespace {

Result<void> check(const std::vector<SegmentedMask>& segments, const SegmentationSource& source) {
  if (segments.empty() || segments.front().mask.values.empty()) {
    return failure("dicom-seg-empty", GLISSON_TEXT("There is no segment to write."));
  }
  if (source.study_uid.empty() || source.series_uid.empty() || source.frame_of_reference_uid.empty()) {
    return failure("dicom-seg-no-uid",
                   GLISSON_TEXT("A segmentation needs the identifiers of the study, the series and the frame of "
                                "reference that it was drawn on."));
  }
  const Grid& grid = segments.front().mask.grid;
  for (const SegmentedMask& segment : segments) {
    if (!same_grid(segment.mask.grid, grid)) {
      return failure("dicom-seg-grids-differ",
                     GLISSON_TEXT("The segments {0} and {1} lie on different grids; one file holds one grid."),
                     {segments.front().info.name, segment.info.name});
    }
  }
  const bool square = (grid.direction.transpose() * grid.direction).isIdentity(1e-3);
  const bool fits = grid.size[0] <= 65535 && grid.size[1] <= 65535;
  if (!square || grid.direction.determinant() < 0 || !fits) {
    return failure("dicom-seg-bad-geometry",
                   GLISSON_TEXT("The grid of the segment {0} is skewed, left-handed or too large for DICOM."),
                   {segments.front().info.name});
  }
  return {};
}

std::size_t plane_area(const Grid& grid) {
  return static_cast<std::size_t>(grid.size[0]) * static_cast<std::size_t>(grid.size[1]);
}

const std::uint8_t* plane_of(const Mask& mask, int plane) {
  return mask.values.data() + plane_area(mask.grid) * static_cast<std::size_t>(plane);
}

std::vector<PlannedFrame> planned_frames(const std::vector<SegmentedMask>& segments) {
  std::vector<PlannedFrame> frames;
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const Mask& mask = segments[s].mask;
    const std::size_t area = plane_area(mask.grid), before = frames.size();
    for (int plane = 0; plane < mask.grid.size[2]; ++plane) {
      const std::uint8_t* values = plane_of(mask, plane);
      if (s == 0 || std::any_of(values, values + area, [](auto v) { return v != 0; })) frames.push_back({s, plane});
    }
    if (frames.size() == before) frames.push_back({s, 0});  // an empty segment has a frame too
  }
  return frames;
}

void describe_study(Item& data_set, const std::vector<SegmentedMask>& segments, const SegmentationSource& source) {
  std::string content = source.series_uid;
  for (const SegmentedMask& segment : segments) {
    const auto& values = segment.mask.values;
    content +=
        "/" + segment.info.name + "/" + sha256_of_text({reinterpret_cast<const char*>(values.data()), values.size()});
  }
  const auto now = fmt::localtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now()));
  data_set.text(DCM_SpecificCharacterSet, "ISO_IR 192");
  data_set.text(DCM_ImageType, "DERIVED\\PRIMARY");
  data_set.text(DCM_SOPClassUID, UID_SegmentationStorage);
  data_set.text(DCM_SOPInstanceUID, uid_from_name(content + "/instance"));
  data_set.text(DCM_StudyDate, source.study_date);
  data_set.text(DCM_StudyTime, source.study_time);
  data_set.text(DCM_ContentDate, source.content_date.empty() ? fmt::format("{:%Y%m%d}", now) : source.content_date);
  data_set.text(DCM_ContentTime, source.content_time.empty() ? fmt::format("{:%H%M%S}", now) : source.content_time);
  data_set.text(DCM_AccessionNumber, "");
  data_set.text(DCM_Modality, "SEG");
  data_set.text(DCM_Manufacturer, "Glisson");
  data_set.text(DCM_ReferringPhysicianName, "");
  data_set.text(DCM_SeriesDescription, source.series_description);
  data_set.text(DCM_ManufacturerModelName, "Glisson");
  Item series = data_set.add(DCM_ReferencedSeriesSequence);
  series.text(DCM_SeriesInstanceUID, source.series_uid);
  for (const SourceInstance& instance : source.instances) {
    Item item = series.add(DCM_ReferencedInstanceSequence);
    item.text(DCM_ReferencedSOPClassUID, instance.sop_class_uid);
    item.text(DCM_ReferencedSOPInstanceUID, instance.sop_instance_uid);
  }
  data_set.text(DCM_PatientName, source.patient_name);
  data_set.text(DCM_PatientID, source.patient_id);
  data_set.text(DCM_PatientBirthDate, "");
  data_set.text(DCM_PatientSex, "");
  if (!source.patient_comments.empty()) data_set.text(DCM_PatientComments, source.patient_comments);
  data_set.text(DCM_DeviceSerialNumber, "0");
  data_set.text(DCM_SoftwareVersions, version());
  data_set.text(DCM_StudyInstanceUID, source.study_uid);
  data_set.text(DCM_SeriesInstanceUID, uid_from_name(content + "/series"));
  data_set.text(DCM_StudyID, "");
  data_set.text(DCM_SeriesNumber, "100");
  data_set.text(DCM_InstanceNumber, "1");
  data_set.text(DCM_FrameOfReferenceUID, source.frame_of_reference_uid);
  data_set.text(DCM_PositionReferenceIndicator, "");
  data_set.text(DCM_ContentLabel, "SEGMENTATION");
  data_set.text(DCM_ContentDescription, "");
  data_set.text(DCM_ContentCreatorName, "");

  const std::string organization = uid_from_name(content + "/dimensions");
  data_set.add(DCM_DimensionOrganizationSequence).text(DCM_DimensionOrganizationUID, organization);
  for (const auto& [pointer, group] : {std::pair{DCM_ReferencedSegmentNumber, DCM_SegmentIdentificationSequence},
                                       {DCM_ImagePositionPatient, DCM_PlanePositionSequence}}) {
    Item dimension = data_set.add(DCM_DimensionIndexSequence);
    dimension.text(DCM_DimensionOrganizationUID, organization);
    dimension.tag_of(DCM_DimensionIndexPointer, pointer);
    dimension.tag_of(DCM_FunctionalGroupPointer, group);
  }
}

void describe_segments(Item& data_set, const std::vector<SegmentedMask>& segments) {
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const SegmentInfo& info = segments[s].info;
    const SegmentCode code = segment_code(info.name);
    const auto lab = cielab_from_srgb(info.color_rgb);
    Item segment = data_set.add(DCM_SegmentSequence);
    segment.code(DCM_SegmentedPropertyCategoryCodeSequence, code.category.value, "SCT", code.category.meaning);
    segment.words(DCM_SegmentNumber, {static_cast<Uint16>(s + 1)});
    segment.text(DCM_SegmentLabel, info.name);
    segment.text(DCM_SegmentAlgorithmType, "SEMIAUTOMATIC");
    segment.text(DCM_SegmentAlgorithmName, "Glisson");
    segment.words(DCM_RecommendedDisplayCIELabValue, {lab[0], lab[1], lab[2]});
    segment.code(DCM_SegmentedPropertyTypeCodeSequence, code.type.value, "SCT", code.type.meaning);
  }
}

void describe_frames(Item& data_set, const std::vector<PlannedFrame>& frames, const Grid& grid,
                     const SegmentationSource& source) {
  const Eigen::Vector3d row = grid.direction.col(0), column = grid.direction.col(1);
  Item shared = data_set.add(DCM_SharedFunctionalGroupsSequence);
  shared.add(DCM_PlaneOrientationSequence)
      .text(DCM_ImageOrientationPatient,
            decimal_strings({row.x(), row.y(), row.z(), column.x(), column.y(), column.z()}));
  Item measures = shared.add(DCM_PixelMeasuresSequence);
  measures.text(DCM_SliceThickness, decimal_string(grid.spacing_mm[2]));
  measures.text(DCM_SpacingBetweenSlices, decimal_string(grid.spacing_mm[2]));
  measures.text(DCM_PixelSpacing, decimal_strings({grid.spacing_mm[1], grid.spacing_mm[0]}));  // between rows first

  const bool has_sources = source.instances.size() == static_cast<std::size_t>(grid.size[2]);
  for (const PlannedFrame& planned : frames) {
    const auto number = static_cast<Uint16>(planned.segment + 1);
    const Eigen::Vector3d position = grid.position_mm(0, 0, planned.plane);
    Item frame = data_set.add(DCM_PerFrameFunctionalGroupsSequence);
    if (has_sources) {
      const SourceInstance& instance = source.instances[static_cast<std::size_t>(planned.plane)];
      Item derivation = frame.add(DCM_DerivationImageSequence);
      Item image = derivation.add(DCM_SourceImageSequence);
      image.text(DCM_ReferencedSOPClassUID, instance.sop_class_uid);
      image.text(DCM_ReferencedSOPInstanceUID, instance.sop_instance_uid);
      image.code(DCM_PurposeOfReferenceCodeSequence, "121322", "DCM", "Source image for image processing operation");
      derivation.code(DCM_DerivationCodeSequence, "113076", "DCM", "Segmentation");
    }
    frame.add(DCM_FrameContentSequence)
        .longs(DCM_DimensionIndexValues, {number, static_cast<Uint32>(planned.plane + 1)});
    frame.add(DCM_PlanePositionSequence)
        .text(DCM_ImagePositionPatient, decimal_strings({position.x(), position.y(), position.z()}));
    frame.add(DCM_SegmentIdentificationSequence).words(DCM_ReferencedSegmentNumber, {number});
  }
}

// Frames follow each other bit by bit, lowest bit first, with no gap between them (PS3.5 8.1.1).
std::vector<Uint8> packed_bits(const std::vector<PlannedFrame>& frames, const std::vector<SegmentedMask>& segments) {
  const std::size_t area = plane_area(segments.front().mask.grid);
  std::vector<Uint8> bytes((area * frames.size() + 7) / 8);
  bytes.resize((bytes.size() + 1) / 2 * 2);  // elements have even length
  std::size_t bit = 0;
  for (const PlannedFrame& frame : frames) {
    const std::uint8_t* values = plane_of(segments[frame.segment].mask, frame.plane);
    for (std::size_t i = 0; i < area; ++i, ++bit) {
      if (values[i] != 0) bytes[bit / 8] = static_cast<Uint8>(bytes[bit / 8] | (1u << (bit % 8)));
    }
  }
  return bytes;
}

}  // namespace
}  // namespace glisson::imaging

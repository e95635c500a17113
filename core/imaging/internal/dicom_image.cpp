// Reads the attributes of classic and enhanced images (PS3.3 C.7.6.3, C.7.6.2, C.7.6.16) from the header alone.

#include "imaging/internal/dicom_image.h"

#include <cmath>
#include <Eigen/Geometry>

#include "imaging/internal/dicom_fields.h"
#include "imaging/internal/value_mapping.h"
#include "imaging/mosaic.h"

namespace glisson::imaging {
namespace {

// More frames than any file is known to have.
constexpr int maximum_frames = 200'000;
// A side of a picture that a decoder is asked to fill; detectors for radiography reach some 5000.
constexpr std::uint64_t maximum_bits_of_compressed_frame = std::uint64_t{8192} * 8192 * 32;

void read_identity(DcmItem& data_set, DicomImage& image) {
  image.sop_class_uid = text_of(data_set, DCM_SOPClassUID);
  image.sop_instance_uid = text_of(data_set, DCM_SOPInstanceUID);
  image.series_uid = text_of(data_set, DCM_SeriesInstanceUID);
  image.study_uid = text_of(data_set, DCM_StudyInstanceUID);
  image.frame_of_reference_uid = text_of(data_set, DCM_FrameOfReferenceUID);
  image.description = text_of(data_set, DCM_SeriesDescription);
  image.protocol = text_of(data_set, DCM_ProtocolName);
  image.sequence_name = text_of(data_set, DCM_SequenceName);
  if (image.sequence_name.empty()) image.sequence_name = text_of(data_set, DCM_PulseSequenceName);
  image.modality = text_of(data_set, DCM_Modality);
  image.manufacturer = text_of(data_set, DCM_Manufacturer);
  image.comments = text_of(data_set, DCM_ImageComments);
  image.image_type = texts_of(data_set, DCM_ImageType);
  image.series_number = whole_number_of(data_set, DCM_SeriesNumber, 0);
  image.instance_number = whole_number_of(data_set, DCM_InstanceNumber, 0);
  image.acquisition_number = whole_number_of(data_set, DCM_AcquisitionNumber, 0);
  image.temporal_positions = whole_number_of(data_set, DCM_NumberOfTemporalPositions, 0);
  image.acquisition_time = text_of(data_set, DCM_AcquisitionTime);
  image.gantry_tilt_deg = number_of(data_set, DCM_GantryDetectorTilt).value_or(0);
  image.window_center = number_of(data_set, DCM_WindowCenter).value_or(0);
  image.window_width = number_of(data_set, DCM_WindowWidth).value_or(0);
  if (const auto key = private_key(data_set, 0x0019, "GEMS_ACQU_01", 0x9c)) {
    const std::string name = private_bytes(data_set, *key);
    image.ge_pulse_sequence = name.substr(0, name.find_first_of(std::string_view("\0 ", 2)));
  }
}

// De-identified files come without identifiers; then a folder is taken for a series.
void name_series_after_folder(DicomImage& image) {
  image.series_uid = image.path.parent_path().string() + "/series-" + std::to_string(image.series_number);
  image.problems.push_back(
      "No SeriesInstanceUID is given: pictures of one folder with the same series number are taken together.");
}

Failure unfit(const DicomImage& image, const char* code, std::string text, std::vector<std::string> more = {}) {
  std::vector<std::string> arguments{image.path.string()};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return failure(Error{code, std::move(text), std::move(arguments), "", image.path});
}

Result<void> read_format(DcmItem& data_set, DicomImage& image) {
  PixelFormat& format = image.format;
  format.columns = whole_number_of(data_set, DCM_Columns, 0);
  format.rows = whole_number_of(data_set, DCM_Rows, 0);
  format.samples = whole_number_of(data_set, DCM_SamplesPerPixel, 1);
  format.bits_allocated = whole_number_of(data_set, DCM_BitsAllocated, 16);
  format.bits_stored = whole_number_of(data_set, DCM_BitsStored, format.bits_allocated);
  format.high_bit = whole_number_of(data_set, DCM_HighBit, format.bits_stored - 1);
  format.is_signed = whole_number_of(data_set, DCM_PixelRepresentation, 0) == 1;
  format.photometric = text_of(data_set, DCM_PhotometricInterpretation);
  image.frames = whole_number_of(data_set, DCM_NumberOfFrames, 1);
  if (image.pixels.element == 0x0008) format.bits_allocated = format.bits_stored = 32;
  if (image.pixels.element == 0x0009) format.bits_allocated = format.bits_stored = 64;

  const bool sizes_fit = format.columns >= 1 && format.columns <= 65535 && format.rows >= 1 && format.rows <= 65535 &&
                         format.samples >= 1 && format.samples <= 4 && image.frames >= 1 &&
                         image.frames <= maximum_frames;
  if (!sizes_fit) {
    return unfit(image, "dicom-size", GLISSON_TEXT("{0} declares an impossible size: {1} x {2} pixels, frames: {3}."),
                 {std::to_string(format.columns), std::to_string(format.rows), std::to_string(image.frames)});
  }
  const int bits = format.bits_allocated;
  const bool whole_numbers = image.pixels.element == 0x0010;
  const bool bits_fit = !whole_numbers || ((bits == 1 || bits == 8 || bits == 16 || bits == 32) &&
                                           format.bits_stored >= 1 && format.bits_stored <= bits &&
                                           format.high_bit < bits && format.high_bit >= format.bits_stored - 1);
  const int representation = whole_number_of(data_set, DCM_PixelRepresentation, 0);
  if (whole_numbers && representation != 0 && representation != 1) {
    return unfit(image, "dicom-size",
                 GLISSON_TEXT("{0} does not say whether its pixels are signed: PixelRepresentation is {1}."),
                 {std::to_string(representation)});
  }
  if (!bits_fit) {
    return unfit(image, "dicom-size", GLISSON_TEXT("{0} declares impossible pixels: {1} of {2} bits, the highest {3}."),
                 {std::to_string(format.bits_stored), std::to_string(bits), std::to_string(format.high_bit)});
  }
  return {};
}

// Whether the file holds as many pixels as it says: below 2^16 x 2^16 x 4 x 64 bits x 200,000 frames nothing overflows
// 64 bits.
Result<void> compare_with_pixels(const DicomImage& image) {
  const std::uint64_t frames = static_cast<std::uint64_t>(image.frames);
  if (image.syntax.encapsulated) {
    if (image.format.frame_bits() > maximum_bits_of_compressed_frame) {
      return unfit(image, "dicom-size", GLISSON_TEXT("{0} declares compressed pictures too large to be true."));
    }
    if (image.pixels.fragments.size() < frames) {
      return unfit(image, "dicom-truncated", GLISSON_TEXT("{0} holds {1} of the {2} frames that it declares."),
                   {std::to_string(image.pixels.fragments.size()), std::to_string(frames)});
    }
    return {};
  }
  const std::uint64_t needed = (image.format.frame_bits() * frames + 7) / 8;
  if (image.pixels.native.length < needed) {
    return unfit(image, "dicom-truncated",
                 GLISSON_TEXT("{0} holds {1} bytes of pixels, but its size in pixels asks for {2}."),
                 {std::to_string(image.pixels.native.length), std::to_string(needed)});
  }
  return {};
}

// Elements have even length; anything beyond that belongs to no pixel, or the rows and columns are not those it was
// stored with.
void name_surplus_pixels(DicomImage& image) {
  if (image.syntax.encapsulated) return;
  const std::uint64_t needed = (image.format.frame_bits() * static_cast<std::uint64_t>(image.frames) + 7) / 8;
  const std::uint64_t surplus = image.pixels.native.length - needed;
  if (surplus <= 1) return;
  image.problems.push_back(std::to_string(surplus) +
                           " bytes of pixels are more than its rows, columns and frames ask for: the picture may be "
                           "sheared.");
}

// The item that holds a macro of a functional group: that of the frame, else the one shared by all.
DcmItem* macro_of(DcmItem* frame, DcmItem* shared, const DcmTagKey& macro) {
  DcmItem* found = frame != nullptr ? item_of(*frame, macro) : nullptr;
  if (found == nullptr && shared != nullptr) found = item_of(*shared, macro);
  return found;
}

void place(Picture& picture, const std::vector<double>& position, const std::vector<double>& orientation,
           const std::vector<double>& spacing) {
  if (spacing.size() == 2 && spacing[0] > 0 && spacing[1] > 0 && spacing[0] < 1e4 && spacing[1] < 1e4) {
    picture.row_spacing_mm = spacing[0];
    picture.column_spacing_mm = spacing[1];
  } else {
    return;
  }
  if (position.size() != 3 || orientation.size() != 6) return;
  const Eigen::Vector3d along_row(orientation[0], orientation[1], orientation[2]);
  const Eigen::Vector3d along_column(orientation[3], orientation[4], orientation[5]);
  const Eigen::Vector3d where(position[0], position[1], position[2]);
  // Six decimals of a direction cosine leave 1e-6; files with three decimals are met too.
  const bool perpendicular_units = std::abs(along_row.norm() - 1) < 0.01 && std::abs(along_column.norm() - 1) < 0.01 &&
                                   std::abs(along_row.dot(along_column)) < 0.01;
  if (!perpendicular_units || where.cwiseAbs().maxCoeff() > 1e6) return;
  picture.position_mm = where;
  picture.along_row = along_row.normalized();
  picture.along_column = (along_column - along_column.dot(picture.along_row) * picture.along_row).normalized();
  picture.placed = true;
}

// Which part of the complex signal: Siemens and Philips write one letter as third or fourth value of ImageType; GE has
// a private number for it, (0043,xx2f) of GEMS_PARM_01: 0 magnitude, 1 phase, 2 real, 3 imaginary.
std::string classic_component(DcmItem& data_set, const DicomImage& image) {
  for (std::size_t i = 2; i < image.image_type.size() && i < 4; ++i) {
    const std::string& value = image.image_type[i];
    if (value == "M" || value == "P" || value == "R" || value == "I") return value;
    if (value == "PHASE MAP" || value == "PHASE") return "P";
  }
  if (const auto key = private_key(data_set, 0x0043, "GEMS_PARM_01", 0x2f)) {
    const std::string bytes = private_bytes(data_set, *key);
    const int number = whole_number_of(data_set, *key, bytes.size() == 2 ? bytes[0] : -1);
    if (number >= 0 && number <= 3) return std::string(1, "MPRI"[number]);
  }
  return {};
}

Picture classic_picture(DcmItem& data_set, const DicomImage& image) {
  Picture picture;
  picture.columns = image.format.columns;
  picture.rows = image.format.rows;
  place(picture, numbers_of(data_set, DCM_ImagePositionPatient), numbers_of(data_set, DCM_ImageOrientationPatient),
        numbers_of(data_set, DCM_PixelSpacing));
  picture.mapping = preferred(rescale_of(data_set), real_world_mapping_of(data_set));
  picture.temporal_position = whole_number_of(data_set, DCM_TemporalPositionIdentifier, 0);
  picture.echo_number = whole_number_of(data_set, DCM_EchoNumbers, 0);
  picture.echo_time_ms = number_of(data_set, DCM_EchoTime).value_or(0);
  picture.trigger_time_ms = number_of(data_set, DCM_TriggerTime).value_or(0);
  picture.b_value = number_of(data_set, DCM_DiffusionBValue).value_or(0);
  picture.stack_id = text_of(data_set, DCM_StackID);
  picture.slice_thickness_mm = number_of(data_set, DCM_SliceThickness).value_or(0);
  picture.component = classic_component(data_set, image);
  return picture;
}

Picture enhanced_picture(DcmItem* frame, DcmItem* shared, const Picture& common) {
  Picture picture = common;
  std::vector<double> position, orientation, spacing;
  if (DcmItem* macro = macro_of(frame, shared, DCM_PlanePositionSequence)) {
    position = numbers_of(*macro, DCM_ImagePositionPatient);
  }
  if (DcmItem* macro = macro_of(frame, shared, DCM_PlaneOrientationSequence)) {
    orientation = numbers_of(*macro, DCM_ImageOrientationPatient);
  }
  if (DcmItem* macro = macro_of(frame, shared, DCM_PixelMeasuresSequence)) {
    spacing = numbers_of(*macro, DCM_PixelSpacing);
    picture.slice_thickness_mm = number_of(*macro, DCM_SliceThickness).value_or(0);
  }
  place(picture, position, orientation, spacing);

  ValueMapping rescale, real_world;
  if (DcmItem* macro = macro_of(frame, shared, DCM_PixelValueTransformationSequence)) rescale = rescale_of(*macro);
  if (frame != nullptr) real_world = real_world_mapping_of(*frame);
  if (!real_world.stated && shared != nullptr) real_world = real_world_mapping_of(*shared);
  if (rescale.stated || real_world.stated) picture.mapping = preferred(rescale, real_world);

  if (DcmItem* content = macro_of(frame, shared, DCM_FrameContentSequence)) {
    picture.stack_id = text_of(*content, DCM_StackID);
    picture.temporal_position = whole_number_of(*content, DCM_TemporalPositionIndex, 0);
    picture.comments = text_of(*content, DCM_FrameComments);
  }
  if (DcmItem* echo = macro_of(frame, shared, DCM_MREchoSequence)) {
    picture.echo_time_ms = number_of(*echo, DCM_EffectiveEchoTime).value_or(0);
  }
  if (DcmItem* type = macro_of(frame, shared, DCM_MRImageFrameTypeSequence)) {
    picture.component = text_of(*type, DCM_ComplexImageComponent).substr(0, 1);
  }
  if (DcmItem* diffusion = macro_of(frame, shared, DCM_MRDiffusionSequence)) {
    picture.b_value = number_of(*diffusion, DCM_DiffusionBValue).value_or(0);
  }
  if (DcmItem* velocity = macro_of(frame, shared, DCM_MRVelocityEncodingSequence)) {
    const std::vector<double> along = numbers_of(*velocity, DCM_VelocityEncodingDirection);
    if (along.size() == 3 && Eigen::Vector3d(along.data()).norm() > 0.5) {
      picture.motion_along = Eigen::Vector3d(along.data()).normalized();
    }
  }
  if (DcmItem* cardiac = macro_of(frame, shared, DCM_CardiacSynchronizationSequence)) {
    picture.trigger_time_ms = number_of(*cardiac, DCM_NominalCardiacTriggerDelayTime).value_or(0);
  }
  return picture;
}

// Per-frame items are taken in one pass: asking DCMTK for the n-th item walks a list.
std::vector<Picture> enhanced_pictures(DcmItem& data_set, const DicomImage& image) {
  const Picture common = classic_picture(data_set, image);
  DcmItem* shared = item_of(data_set, DCM_SharedFunctionalGroupsSequence);
  DcmSequenceOfItems* per_frame = nullptr;
  data_set.findAndGetSequence(DCM_PerFrameFunctionalGroupsSequence, per_frame);
  std::vector<Picture> pictures;
  DcmObject* item = nullptr;
  for (int n = 0; n < image.frames; ++n) {
    if (per_frame != nullptr) item = per_frame->nextInContainer(item);
    pictures.push_back(enhanced_picture(dynamic_cast<DcmItem*>(item), shared, common));
    pictures.back().frame = n;
    if (item == nullptr) per_frame = nullptr;
  }
  return pictures;
}

bool is_mosaic(const DicomImage& image) {
  for (const std::string& value : image.image_type) {
    if (value == "MOSAIC") return true;
  }
  return false;
}

void read_pictures(DcmItem& data_set, DicomImage& image) {
  if (image.frames > 1 || data_set.tagExists(DCM_SharedFunctionalGroupsSequence)) {
    image.pictures = enhanced_pictures(data_set, image);
    return;
  }
  const Picture picture = classic_picture(data_set, image);
  image.pictures = {picture};
  if (!is_mosaic(image)) return;
  const auto facts = mosaic_facts(data_set);
  const auto spacing = number_of(data_set, DCM_SpacingBetweenSlices);
  const auto tiles =
      facts && spacing && *spacing > 0 && picture.placed ? unpack_mosaic(picture, *facts, *spacing) : std::nullopt;
  if (tiles) {
    image.pictures = *tiles;
  } else {
    image.problems.push_back(
        "It is a mosaic of slices whose number or spacing the header does not give, so that it "
        "cannot be taken apart.");
    for (Picture& whole : image.pictures) whole.placed = false;
  }
}

}  // namespace

Result<DicomImage> read_dicom_image_header(const std::filesystem::path& file) {
  Result<CheckedDicom> checked = check_dicom_file(file);
  if (!checked) return failure(checked.error());
  const auto data_set = parse(*checked);
  DicomImage image;
  image.path = file;
  image.syntax = checked->syntax;
  image.file_bytes = checked->file_bytes;
  if (!data_set) return unfit(image, "dicom-damaged", GLISSON_TEXT("{0} is damaged: its header cannot be understood."));
  read_identity(*data_set, image);
  if (!checked->pixels) {
    return unfit(image, "dicom-no-image", GLISSON_TEXT("{0} is DICOM, but holds no picture ({1})."),
                 {image.modality.empty() ? "no modality given" : image.modality});
  }
  image.pixels = std::move(*checked->pixels);
  if (image.series_uid.empty()) name_series_after_folder(image);
  if (const Result<void> format = read_format(*data_set, image); !format) return failure(format.error());
  if (const Result<void> enough = compare_with_pixels(image); !enough) return failure(enough.error());
  name_surplus_pixels(image);
  read_pictures(*data_set, image);
  for (Picture& picture : image.pictures) add_implied_unit(picture.mapping, image);
  return image;
}

Result<std::vector<std::filesystem::path>> files_named_in_dicomdir(const std::filesystem::path& dicomdir) {
  const Result<CheckedDicom> checked = check_dicom_file(dicomdir);
  if (!checked) return failure(checked.error());
  const auto data_set = parse(*checked);
  DcmSequenceOfItems* records = nullptr;
  if (!data_set || data_set->findAndGetSequence(DCM_DirectoryRecordSequence, records).bad() || records == nullptr) {
    return failure(Error{"dicomdir-damaged",
                         GLISSON_TEXT("{0} is no directory of DICOM files."),
                         {dicomdir.string()},
                         GLISSON_TEXT("Open the folder itself instead."),
                         dicomdir});
  }
  std::vector<std::filesystem::path> files;
  for (DcmObject* record = records->nextInContainer(nullptr); record != nullptr;
       record = records->nextInContainer(record)) {
    auto* item = dynamic_cast<DcmItem*>(record);
    if (item == nullptr) continue;
    std::filesystem::path relative;
    bool inside = true;
    for (const std::string& part : texts_of(*item, DCM_ReferencedFileID)) {
      inside = inside && part != ".." && part.find('/') == std::string::npos;
      relative /= part;
    }
    if (inside && !relative.empty()) files.push_back(dicomdir.parent_path() / relative);
  }
  return files;
}

}  // namespace glisson::imaging

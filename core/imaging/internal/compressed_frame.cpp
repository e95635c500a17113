// Decoders have crashed on hostile streams before. What can be checked without decoding is checked first. Each frame is
// then decoded by itself, out of a data set made here. So nothing else of the file reaches the decoder.

#include "imaging/internal/compressed_frame.h"

#include <cstring>
#include <memory>
#include <mutex>
#include <optional>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcpixel.h>
#include <dcmtk/dcmdata/dcpixseq.h>
#include <dcmtk/dcmdata/dcpxitem.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmjpeg/djdecode.h>
#include <dcmtk/dcmjpls/djdecode.h>
#include <gdcmFragment.h>
#include <gdcmJPEG2000Codec.h>
#include <gdcmSequenceOfFragments.h>
#include <gdcmTrace.h>

#include "imaging/internal/run_length.h"

namespace glisson::imaging {
namespace {

// What a JPEG, JPEG-LS or JPEG 2000 stream says of itself, read from its marker segments alone.
struct CodestreamSize {
  std::uint32_t columns = 0;
  std::uint32_t rows = 0;
  int components = 0;
  int bits = 0;
};

enum class Coding { rle, jpeg, jpeg_ls, jpeg_2000, unknown };

Coding coding_of(const std::string& uid) {
  if (uid == "1.2.840.10008.1.2.5") return Coding::rle;
  for (const char* end : {"50", "51", "57", "70"}) {
    if (uid == std::string("1.2.840.10008.1.2.4.") + end) return Coding::jpeg;
  }
  if (uid == "1.2.840.10008.1.2.4.80" || uid == "1.2.840.10008.1.2.4.81") return Coding::jpeg_ls;
  if (uid == "1.2.840.10008.1.2.4.90" || uid == "1.2.840.10008.1.2.4.91") return Coding::jpeg_2000;
  return Coding::unknown;
}

Failure frame_damaged(const std::string& name) {
  return failure("dicom-pixels-damaged", GLISSON_TEXT("The compressed pixels of {0} are damaged."), {name});
}

Result<void> compare_sizes(Coding coding, const PixelFormat& format, const std::string& stream,
                           const std::string& name);
Result<std::vector<std::uint8_t>> decode_by_dcmtk(const TransferSyntax& syntax, const PixelFormat& format,
                                                  const std::string& stream, const std::string& name);
Result<std::vector<std::uint8_t>> decode_by_gdcm(const PixelFormat& format, const std::string& stream,
                                                 const std::string& name);

}  // namespace

Result<std::vector<std::uint8_t>> decode_frame(const TransferSyntax& syntax, const PixelFormat& format,
                                               const std::string& stream, const std::string& name) {
  const Coding coding = coding_of(syntax.uid);
  if (coding == Coding::unknown) {
    return failure(Error{"dicom-compression-unknown",
                         GLISSON_TEXT("{0} is compressed in a way that is not read (transfer syntax {1})."),
                         {name, syntax.uid},
                         GLISSON_TEXT("Convert it to an uncompressed or JPEG form first."),
                         {}});
  }
  if (coding == Coding::rle) {
    const std::size_t pixels = static_cast<std::size_t>(format.columns) * static_cast<std::size_t>(format.rows);
    auto samples = decode_run_lengths(stream, pixels, static_cast<std::size_t>(format.bits_allocated) / 8);
    if (!samples) return frame_damaged(name);
    return std::move(*samples);
  }
  if (const Result<void> sizes = compare_sizes(coding, format, stream, name); !sizes) return failure(sizes.error());
  try {
    return coding == Coding::jpeg_2000 ? decode_by_gdcm(format, stream, name)
                                       : decode_by_dcmtk(syntax, format, stream, name);
  } catch (const std::exception&) {
    return frame_damaged(name);
  }
}

namespace {

std::uint32_t big_endian(const std::string& bytes, std::size_t at, int count) {
  std::uint32_t number = 0;
  for (int i = 0; i < count; ++i)
    number = number << 8 | static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(i)]);
  return number;
}

// ISO 15444-1 annex A: SIZ follows the start of the codestream, which a JP2 file wraps in boxes.
std::optional<CodestreamSize> jpeg_2000_size(const std::string& stream) {
  const std::size_t start = stream.find("\xFF\x4F\xFF\x51");
  if (start == std::string::npos || stream.size() - start < 4 + 39) return std::nullopt;
  const std::size_t siz = start + 4;
  CodestreamSize size;
  const std::uint32_t right = big_endian(stream, siz + 4, 4), bottom = big_endian(stream, siz + 8, 4);
  const std::uint32_t left = big_endian(stream, siz + 12, 4), top = big_endian(stream, siz + 16, 4);
  if (right <= left || bottom <= top) return std::nullopt;
  size.columns = right - left;
  size.rows = bottom - top;
  size.components = static_cast<int>(big_endian(stream, siz + 36, 2));
  size.bits = static_cast<int>((big_endian(stream, siz + 38, 1) & 0x7Fu) + 1);
  return size;
}

// ITU-T T.81 annex B and T.87: segments up to the frame header, each with its length. Markers that stand alone or are
// padded have no place there; DCMTK loses its way over them, in one case for ever.
std::optional<CodestreamSize> jpeg_size(const std::string& stream, bool jpeg_ls) {
  if (stream.compare(0, 2, "\xFF\xD8") != 0) return std::nullopt;
  std::size_t at = 2;
  while (at + 4 <= stream.size()) {
    const unsigned marker = big_endian(stream, at, 2);
    const std::uint32_t length = big_endian(stream, at + 2, 2);
    const bool stands_alone = marker == 0xFF01 || (marker >= 0xFFD0 && marker <= 0xFFD9);
    if (marker < 0xFFC0 || marker == 0xFFFF || stands_alone) return std::nullopt;
    if (length < 2 || length > stream.size() - at - 2) return std::nullopt;
    const bool is_jpeg_frame =
        marker >= 0xFFC0 && marker <= 0xFFCF && marker != 0xFFC4 && marker != 0xFFC8 && marker != 0xFFCC;
    const bool is_jpeg_ls_frame = marker == 0xFFF7;
    if (is_jpeg_frame || is_jpeg_ls_frame) {
      if (is_jpeg_ls_frame != jpeg_ls || length < 8) return std::nullopt;
      return CodestreamSize{big_endian(stream, at + 7, 2), big_endian(stream, at + 5, 2),
                            static_cast<int>(big_endian(stream, at + 9, 1)),
                            static_cast<int>(big_endian(stream, at + 4, 1))};
    }
    at += 2 + length;
  }
  return std::nullopt;
}

Result<void> compare_sizes(Coding coding, const PixelFormat& format, const std::string& stream,
                           const std::string& name) {
  const std::optional<CodestreamSize> size =
      coding == Coding::jpeg_2000 ? jpeg_2000_size(stream) : jpeg_size(stream, coding == Coding::jpeg_ls);
  if (!size) return frame_damaged(name);
  const bool fits = size->columns == static_cast<std::uint32_t>(format.columns) &&
                    size->rows == static_cast<std::uint32_t>(format.rows) && size->components == format.samples &&
                    size->bits <= format.bits_allocated;
  if (fits) return {};
  return failure(
      "dicom-pixels-damaged",
      GLISSON_TEXT("The compressed picture of {0} is {1} x {2} with {3} bits, where its header says {4} x {5} "
                   "with {6}."),
      {name, std::to_string(size->columns), std::to_string(size->rows), std::to_string(size->bits),
       std::to_string(format.columns), std::to_string(format.rows), std::to_string(format.bits_stored)});
}

void register_decoders() {
  static std::once_flag once;
  std::call_once(once, [] {
    DJDecoderRegistration::registerCodecs();
    DJLSDecoderRegistration::registerCodecs();
  });
}

Result<std::vector<std::uint8_t>> decode_by_dcmtk(const TransferSyntax& syntax, const PixelFormat& format,
                                                  const std::string& stream, const std::string& name) {
  register_decoders();
  DcmDataset data_set;
  const auto put = [&](const DcmTagKey& key, int value) {
    data_set.putAndInsertUint16(key, static_cast<Uint16>(value));
  };
  put(DCM_Rows, format.rows);
  put(DCM_Columns, format.columns);
  put(DCM_SamplesPerPixel, format.samples);
  put(DCM_BitsAllocated, format.bits_allocated);
  put(DCM_BitsStored, format.bits_stored);
  put(DCM_HighBit, format.high_bit);
  put(DCM_PixelRepresentation, format.is_signed ? 1 : 0);
  data_set.putAndInsertString(DCM_PhotometricInterpretation, format.photometric.c_str());

  auto* sequence = new DcmPixelSequence(DCM_PixelSequenceTag);
  auto* pixel_data = new DcmPixelData(DCM_PixelData);
  pixel_data->putOriginalRepresentation(DcmXfer(syntax.uid.c_str()).getXfer(), nullptr, sequence);
  data_set.insert(pixel_data, OFTrue);  // the data set owns it from here, and it the sequence
  sequence->insert(new DcmPixelItem(DCM_PixelItemTag));
  auto* fragment = new DcmPixelItem(DCM_PixelItemTag);
  sequence->insert(fragment);
  fragment->putUint8Array(reinterpret_cast<const Uint8*>(stream.data()), static_cast<unsigned long>(stream.size()));

  std::vector<std::uint8_t> samples((format.frame_bits() + 7) / 8 + 1);
  const auto even_size = static_cast<Uint32>(samples.size() / 2 * 2);
  Uint32 first_fragment = 0;
  OFString colour_model;
  const OFCondition decoded =
      pixel_data->getUncompressedFrame(&data_set, 0, first_fragment, samples.data(), even_size, colour_model);
  if (decoded.bad()) return frame_damaged(name);
  return samples;
}

Result<std::vector<std::uint8_t>> decode_by_gdcm(const PixelFormat& format, const std::string& stream,
                                                 const std::string& name) {
  static std::once_flag quiet;
  std::call_once(quiet, [] {
    gdcm::Trace::WarningOff();
    gdcm::Trace::ErrorOff();
  });
  gdcm::JPEG2000Codec codec;
  const unsigned int size[3] = {static_cast<unsigned int>(format.columns), static_cast<unsigned int>(format.rows), 1};
  codec.SetNumberOfDimensions(2);
  codec.SetDimensions(size);
  codec.SetPlanarConfiguration(0);
  codec.SetPhotometricInterpretation(gdcm::PhotometricInterpretation::MONOCHROME2);
  codec.SetPixelFormat(
      gdcm::PixelFormat(static_cast<unsigned short>(format.samples), static_cast<unsigned short>(format.bits_allocated),
                        static_cast<unsigned short>(format.bits_stored), static_cast<unsigned short>(format.high_bit),
                        static_cast<unsigned short>(format.is_signed ? 1 : 0)));
  gdcm::Fragment fragment;
  fragment.SetByteValue(stream.data(), gdcm::VL(static_cast<std::uint32_t>(stream.size())));
  const gdcm::SmartPointer<gdcm::SequenceOfFragments> fragments = gdcm::SequenceOfFragments::New();
  fragments->AddFragment(fragment);
  gdcm::DataElement compressed(gdcm::Tag(0x7fe0, 0x0010)), decoded;
  compressed.SetVR(gdcm::VR::OB);
  compressed.SetValue(*fragments);
  if (!codec.Decode(compressed, decoded)) return frame_damaged(name);
  const gdcm::ByteValue* bytes = decoded.GetByteValue();
  const std::uint64_t needed = (format.frame_bits() + 7) / 8;
  if (bytes == nullptr || bytes->GetLength() < needed) return frame_damaged(name);
  const auto* first = reinterpret_cast<const std::uint8_t*>(bytes->GetPointer());
  return std::vector<std::uint8_t>(first, first + needed);
}

}  // namespace
}  // namespace glisson::imaging

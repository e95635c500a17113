// Broken and hostile files: one clear sentence each, and the rest of the study still loads.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cmath>

#include "base/files.h"
#include "imaging/internal/checked_dicom.h"
#include "imaging/mosaic.h"
#include "imaging/read_series.h"
#include "support/dicom_files.h"

namespace glisson::imaging {
namespace {

namespace fs = std::filesystem;
using test::SliceSpec;
using testing::HasSubstr;

// Beside a good stack of four slices.
class HostileFile : public testing::Test {
 protected:
  HostileFile() { test::save_stack(folder_.path() / "good", 4); }

  // The reason for which the one bad file was skipped, after making sure that the good ones were not.
  std::string reason() const {
    const Result<Study> study = scan(folder_.path());
    if (!study) return "the scan failed: " + study.error().message();
    if (study->skipped.size() != 1) return fmt::format("{} files were skipped", study->skipped.size());
    if (study->series.empty() || study->series.front().files.size() != 4) return "the good series was lost";
    const Result<Volume> volume = read_series(study->series.front());
    if (!volume || volume->at(0, 0, 3) != 300) return "the good series cannot be read";
    const std::string& sentence = study->skipped.front().reason;
    EXPECT_EQ(sentence.back(), '.');
    EXPECT_EQ(sentence.find('\n'), std::string::npos);
    EXPECT_THAT(sentence, HasSubstr(bad().filename().string()));
    return sentence;
  }
  fs::path bad() const { return folder_.path() / "bad.dcm"; }
  std::string good_bytes() const { return test::bytes_of(folder_.path() / "good" / "IM_0001.dcm"); }

  TemporaryFolder folder_;
};

std::string number32(std::uint32_t number) {
  std::string bytes;
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(number >> shift & 0xFF);
  return bytes;
}

// A file's beginning: preamble, mark, transfer syntax.
std::string beginning(const std::string& syntax = "1.2.840.10008.1.2.1") {
  std::string uid = syntax;
  if (uid.size() % 2 != 0) uid += '\0';
  return std::string(128, '\0') + "DICM" + std::string("\x02\x00\x10\x00UI", 6) + static_cast<char>(uid.size()) +
         std::string(1, '\0') + uid;
}

TEST_F(HostileFile, OfZeroBytes) {
  test::write_bytes(bad(), "");
  EXPECT_THAT(reason(), HasSubstr("is empty"));
}

TEST_F(HostileFile, OfTextNamedDcm) {
  test::write_bytes(bad(), "Dear colleague,\nthe images are on the other disc.\n");
  EXPECT_THAT(reason(), HasSubstr("is no DICOM file"));
}

TEST_F(HostileFile, CutInItsPixels) {
  const std::string whole = good_bytes();
  test::write_bytes(bad(), whole.substr(0, whole.size() - 10));
  EXPECT_THAT(reason(), HasSubstr("cut short: 86 of 96 bytes"));
}

TEST_F(HostileFile, CutAnywhere) {
  const std::string whole = good_bytes();
  for (std::size_t length = 1; length < whole.size(); length += 7) {
    test::write_bytes(bad(), whole.substr(0, length));
    EXPECT_THAT(reason(), HasSubstr("bad.dcm")) << length;
  }
}

TEST_F(HostileFile, ThatSaysNeitherThatItsPixelsAreSignedNorNot) {
  const auto file = test::dicom_slice({});
  file->getDataset()->putAndInsertUint16(DCM_PixelRepresentation, 3);
  test::save(*file, bad());
  EXPECT_THAT(reason(), HasSubstr("PixelRepresentation is 3"));
}

// Rows of another length than they were stored with shear the picture, which only the surplus gives away.
TEST_F(HostileFile, WithMorePixelsThanRowsAndColumnsIsTold) {
  const auto file = test::dicom_slice({});
  std::vector<Uint16> pixels(8 * 6 + 6, 1);
  file->getDataset()->putAndInsertUint16Array(DCM_PixelData, pixels.data(), pixels.size());
  test::save(*file, bad());
  const auto study = scan(bad());
  ASSERT_TRUE(study && study->series.size() == 1);
  EXPECT_THAT(study->series.front().problems, testing::Contains(HasSubstr("the picture may be sheared")));
}

TEST_F(HostileFile, WithALengthBeyondItsEnd) {
  test::write_bytes(bad(), beginning() + std::string("\x08\x00\x05\x00UN\0\0", 8) + number32(0xFFFFFFF0u) + "short");
  EXPECT_THAT(reason(), HasSubstr("ends at byte"));
}

TEST_F(HostileFile, WithAnItemLongerThanItsSequence) {
  const std::string item = std::string("\xFE\xFF\x00\xE0", 4) + number32(5000) + std::string(16, '\0');
  test::write_bytes(bad(), beginning() + std::string("\x08\x00\x40\x11SQ\0\0", 8) +
                               number32(static_cast<std::uint32_t>(item.size())) + item + std::string(9000, '\0'));
  EXPECT_THAT(reason(), HasSubstr("leaves what encloses it"));
}

TEST_F(HostileFile, WithSequencesNestedAThousandDeep) {
  for (const bool with_lengths : {false, true}) {
    std::string nested;
    for (int depth = 0; depth < 1000; ++depth) {
      const std::uint32_t item = with_lengths ? static_cast<std::uint32_t>(nested.size()) : 0xFFFFFFFFu;
      const std::uint32_t sequence = with_lengths ? item + 8 : 0xFFFFFFFFu;
      std::string outer = std::string("\x08\x00\x40\x11SQ\0\0", 8) + number32(sequence) +
                          std::string("\xFE\xFF\x00\xE0", 4) + number32(item) + nested;
      if (!with_lengths) {
        outer += std::string("\xFE\xFF\x0D\xE0\0\0\0\0", 8) + std::string("\xFE\xFF\xDD\xE0\0\0\0\0", 8);
      }
      nested = std::move(outer);
    }
    test::write_bytes(bad(), beginning() + nested);
    EXPECT_THAT(reason(), HasSubstr("more than 32 deep"));
  }
}

// In implicit VR a private sequence shows itself only by the item that it begins with.
TEST_F(HostileFile, WithPrivateSequencesNestedInImplicitVr) {
  std::string nested;
  for (int depth = 0; depth < 1000; ++depth) {
    nested = std::string("\x09\x00\x01\x10", 4) + number32(static_cast<std::uint32_t>(nested.size()) + 8) +
             std::string("\xFE\xFF\x00\xE0", 4) + number32(static_cast<std::uint32_t>(nested.size())) + nested;
  }
  test::write_bytes(bad(), beginning("1.2.840.10008.1.2") + nested);
  EXPECT_THAT(reason(), HasSubstr("more than 32 deep"));
}

TEST_F(HostileFile, WithSizesWhoseProductOverflows) {
  const auto file = test::dicom_slice({});
  DcmDataset& data_set = *file->getDataset();
  data_set.putAndInsertUint16(DCM_Rows, 65535);
  data_set.putAndInsertUint16(DCM_Columns, 65535);
  data_set.putAndInsertUint16(DCM_BitsAllocated, 32);
  data_set.putAndInsertString(DCM_NumberOfFrames, "2147483647");
  test::save(*file, bad());
  EXPECT_THAT(reason(), HasSubstr("impossible size"));
  data_set.putAndInsertString(DCM_NumberOfFrames, "1");
  test::save(*file, bad());
  EXPECT_THAT(reason(), HasSubstr("its size in pixels asks for 17179344900"));  // 65535 x 65535 x 4
}

TEST_F(HostileFile, WhoseNrrdHeaderOverflows64Bits) {
  test::write_bytes(folder_.path() / "bad.dcm.nrrd",
                    "NRRD0004\ntype: short\ndimension: 3\nsizes: 4294967296 4294967296 2\nencoding: raw\n\nxx");
  EXPECT_THAT(reason(), Not(HasSubstr("good series")));
}

TEST_F(HostileFile, WithFewerFramesThanItDeclares) {
  const auto file = test::dicom_slice({});
  file->getDataset()->putAndInsertString(DCM_NumberOfFrames, "50");
  test::save(*file, bad());
  EXPECT_THAT(reason(), HasSubstr("holds 96 bytes of pixels"));
}

TEST_F(HostileFile, WithItsCompressedFragmentsCut) {
  test::save_slice({}, bad(), EXS_RLELossless);
  const std::string whole = test::bytes_of(bad());
  test::write_bytes(bad(), whole.substr(0, whole.size() - 20));
  EXPECT_THAT(reason(), HasSubstr("cut short in its compressed pixels"));
}

TEST_F(HostileFile, ThatIsDicomWithoutAPicture) {
  const auto file = test::dicom_slice({.modality = "SR"});
  file->getDataset()->findAndDeleteElement(DCM_PixelData);
  test::save(*file, bad());
  EXPECT_THAT(reason(), HasSubstr("holds no picture (SR)"));
}

TEST_F(HostileFile, ThatMayNotBeRead) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may read every file; run as another user to see this";
  test::write_bytes(bad(), good_bytes());
  ASSERT_EQ(::chmod(bad().c_str(), 0), 0);
  EXPECT_THAT(reason(), HasSubstr("may not be read"));
}

TEST_F(HostileFile, ThatIsAPipeDoesNotHang) {
  ASSERT_EQ(::mkfifo(bad().c_str(), 0600), 0);
  EXPECT_THAT(reason(), HasSubstr("no ordinary file"));
}

TEST_F(HostileFile, ThatIsALinkToNowhere) {
  fs::create_symlink(folder_.path() / "nowhere", bad());
  EXPECT_THAT(reason(), HasSubstr("cannot be opened"));
}

// What compresses well may claim any size: the stream's own size must be the header's.
TEST_F(HostileFile, WhoseStreamHasAnotherSizeThanItsHeader) {
  SliceSpec spec;
  spec.series_uid = "1.2.3.8";
  const auto file = test::dicom_slice(spec);
  test::save(*file, bad(), EXS_JPEGLSLossless);
  std::string bytes = test::bytes_of(bad());
  const std::size_t frame = bytes.find("\xFF\xF7");
  ASSERT_NE(frame, std::string::npos);
  bytes[frame + 5] = '\x7F';  // rows: from 6 to 32518
  test::write_bytes(bad(), bytes);
  const Result<Study> study = scan(bad());
  ASSERT_TRUE(study.has_value() && study->series.size() == 1);
  const Result<Volume> volume = read_series(study->series.front());
  ASSERT_FALSE(volume.has_value());
  EXPECT_EQ(volume.error().code, "dicom-pixels-damaged");
  EXPECT_THAT(volume.error().message(), HasSubstr("8 x 32518"));
}

// Each picture is compared with each kind: a hundred thousand kinds in one file would keep the scan busy for hours.
TEST_F(HostileFile, WithThousandsOfOrientations) {
  SliceSpec spec;
  spec.series_uid = "1.2.3.8";
  spec.columns = spec.rows = 1;
  const std::vector<Eigen::Vector3d> places(3000, Eigen::Vector3d(0, 0, 0));
  const auto file = test::enhanced_image(spec, places, [](int, int, int) { return 0; });
  for (std::size_t n = 0; n < places.size(); ++n) {
    DcmItem* frame = nullptr;
    DcmItem* macro = nullptr;
    file->getDataset()->findOrCreateSequenceItem(DCM_PerFrameFunctionalGroupsSequence, frame, static_cast<long>(n));
    frame->findOrCreateSequenceItem(DCM_PlaneOrientationSequence, macro, 0);
    const double angle = 0.002 * static_cast<double>(n);
    macro->putAndInsertString(DCM_ImageOrientationPatient,
                              fmt::format("{:.7f}\\{:.7f}\\0\\0\\0\\1", std::cos(angle), std::sin(angle)).c_str());
  }
  test::save(*file, bad());
  const Result<Study> study = scan(bad());
  ASSERT_TRUE(study.has_value());
  EXPECT_EQ(study->series.size(), 512U);
  EXPECT_THAT(study->series.front().problems, testing::Contains(HasSubstr("are left out")));
}

TEST_F(HostileFile, WithAnUnknownCompression) {
  test::save_slice({.series_uid = "1.2.3.8"}, bad(), EXS_RLELossless);
  std::string bytes = test::bytes_of(bad());
  const std::size_t uid = bytes.find("1.2.840.10008.1.2.5");
  bytes.replace(uid, 19, "1.2.840.10008.1.2.9");
  test::write_bytes(bad(), bytes);
  const Result<Study> study = scan(bad());
  ASSERT_TRUE(study.has_value() && study->series.size() == 1);
  EXPECT_EQ(read_series(study->series.front()).error().code, "dicom-compression-unknown");
}

TEST(CsaHeader, IsReadNoFurtherThanItsEnd) {
  std::string header = "SV10" + std::string("\4\3\2\1", 4) + number32(1) + number32(77);
  header += std::string("NumberOfImagesInMosaic").append(42, '\0') + number32(1) + std::string("US\0\0", 4) +
            number32(0) + number32(1) + number32(77);
  header += number32(1) + number32(4) + number32(77) + number32(4) + "5   ";
  const auto facts = mosaic_facts_in_csa_header(header);
  ASSERT_TRUE(facts.has_value());
  EXPECT_EQ(facts->tiles, 5);
  for (std::size_t length = 0; length < header.size(); ++length) {
    EXPECT_FALSE(mosaic_facts_in_csa_header(std::string_view(header).substr(0, length)).has_value()) << length;
  }
}

}  // namespace
}  // namespace glisson::imaging

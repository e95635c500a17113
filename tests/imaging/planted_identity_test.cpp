// Identity is planted wherever a file has room for it, and then looked for in the bytes of what de-identification
// wrote.

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <algorithm>
#include <cctype>

#include "base/files.h"
#include "imaging/deidentify.h"
#include "imaging/dicom_seg.h"
#include "imaging/read_series.h"
#include "support/dicom_files.h"

namespace glisson::imaging {
namespace {

namespace fs = std::filesystem;

// What is planted; in capitals, so that it fits in a coded string.
const std::string planted = "SEKRET";

std::vector<DcmTagKey> all_attributes() {
  std::vector<DcmTagKey> keys;
  DcmDataDictionary& dictionary = dcmDataDict.wrlock();
  for (auto entry = dictionary.normalBegin(); entry != dictionary.normalEnd(); ++entry) {
    const DcmTagKey key = (*entry)->getKey();
    const bool of_the_file = key.getGroup() < 0x0008 || key.getGroup() >= 0x7fe0 || key.getElement() == 0;
    // With a provider's address in it, DCMTK writes no file.
    if (key == DCM_PixelDataProviderURL || of_the_file || (*entry)->getPrivateCreator() != nullptr) continue;
    keys.push_back(key);
  }
  dcmDataDict.wrunlock();
  return keys;
}

// The dictionary's kind, or another that the file claims.
void plant(DcmItem& item, const DcmTagKey& key, DcmEVR claimed = EVR_UNKNOWN) {
  if (item.tagExists(key)) return;
  DcmTag tag(key.getGroup(), key.getElement());
  if (claimed != EVR_UNKNOWN) tag.setVR(DcmVR(claimed));
  const std::string text = tag.getEVR() == EVR_UI ? "1.2.840.10008." + planted : planted + planted;
  switch (tag.getEVR()) {
    case EVR_SQ: {
      DcmItem* inner = nullptr;
      if (item.findOrCreateSequenceItem(tag, inner, -2).bad()) return;
      inner->putAndInsertString(DCM_PatientName, (planted + "^NESTED").c_str());
      inner->putAndInsertString(DCM_PatientID, planted.c_str());
      inner->putAndInsertString(DCM_CodeMeaning, planted.c_str());
      inner->putAndInsertString(DcmTag(0x0009, 0x0010, EVR_LO), planted.c_str());
      return;
    }
    case EVR_OB:
    case EVR_OW:
    case EVR_ox:
    case EVR_UN: {
      tag.setVR(DcmVR(tag.getEVR() == EVR_ox ? EVR_OB : tag.getEVR()));
      item.putAndInsertUint8Array(tag, reinterpret_cast<const Uint8*>(text.data()),
                                  static_cast<unsigned long>(text.size()));
      return;
    }
    case EVR_US:
    case EVR_xs:
    case EVR_SS: {
      tag.setVR(DcmVR(EVR_US));
      item.putAndInsertUint16Array(tag, reinterpret_cast<const Uint16*>(text.data()),
                                   static_cast<unsigned long>(text.size() / 2));
      return;
    }
    default: item.putAndInsertString(tag, text.c_str()); return;
  }
}

test::SliceSpec slice_spec(int number) {
  test::SliceSpec spec;
  spec.instance_number = number;
  spec.position_mm = {0, 0, 3.0 * number};
  spec.bits_stored = 12;
  return spec;
}

std::string capitals_of(const fs::path& file) {
  std::string bytes = *read_text_file(file);
  std::transform(bytes.begin(), bytes.end(), bytes.begin(), [](unsigned char c) { return std::toupper(c); });
  return bytes;
}

void expect_nothing_planted(const fs::path& out) {
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(out)) {
    EXPECT_EQ(entry.path().string().substr(out.string().size()).find(planted), std::string::npos) << entry.path();
    if (!entry.is_regular_file()) continue;
    ++files;
    const std::string bytes = capitals_of(entry.path());
    const std::size_t at = bytes.find(planted);
    if (at == std::string::npos) continue;
    DcmFileFormat format;
    format.loadFile(entry.path().c_str());
    std::ostringstream dump;
    format.print(dump);
    std::istringstream lines(dump.str());
    for (std::string line; std::getline(lines, line);) {
      if (line.find(planted) != std::string::npos) ADD_FAILURE() << line;
    }
    ADD_FAILURE() << planted << " stands at byte " << at << " of " << entry.path();
  }
  EXPECT_GT(files, 0);
}

class PlantedAs : public testing::TestWithParam<DcmEVR> {};

// Every attribute of the dictionary, outermost and two levels down in sequences that stay.
TEST_P(PlantedAs, LeavesNothingOfIt) {
  const TemporaryFolder in, out;
  const auto file = test::dicom_slice(slice_spec(1));
  DcmDataset& data = *file->getDataset();
  DcmItem *frame = nullptr, *deep = nullptr;
  data.findOrCreateSequenceItem(DCM_PerFrameFunctionalGroupsSequence, frame, -2);
  frame->findOrCreateSequenceItem(DCM_FrameContentSequence, deep, -2);
  int count = 0;
  for (const DcmTagKey& key : all_attributes()) {
    for (DcmItem* item : {static_cast<DcmItem*>(&data), deep}) {
      plant(*item, key, GetParam());
      ++count;
    }
  }
  EXPECT_GT(count, 6000);
  test::save(*file, in.path() / "a.dcm");
  const auto done = deidentify(in.path(), out.path());
  ASSERT_TRUE(done) << done.error().message();
  ASSERT_EQ(done->files.size(), 1U);
  expect_nothing_planted(out.path());

  const auto study = scan(out.path());
  ASSERT_TRUE(study && study->series.size() == 1);
  const auto volume = read_series(study->series.front());
  ASSERT_TRUE(volume) << volume.error().message();
  EXPECT_EQ(volume->values[3], 30) << "the picture is not the one that went in";
}

INSTANTIATE_TEST_SUITE_P(Kinds, PlantedAs, testing::Values(EVR_UNKNOWN, EVR_CS, EVR_DS, EVR_UI, EVR_LT, EVR_UN));

TEST(PlantedIdentity, GoesFromPlacesThatAreNoAttributes) {
  const TemporaryFolder in, out;
  const auto file = test::dicom_slice(slice_spec(1));
  DcmDataset& data = *file->getDataset();
  // Behind the last pixel, and in the bits above the twelve that are stored.
  std::vector<Uint16> pixels(8 * 6);
  for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = static_cast<Uint16>(i | 0xA000);
  const std::string behind = planted + planted;
  pixels.resize(pixels.size() + behind.size() / 2);
  std::copy(behind.begin(), behind.end(), reinterpret_cast<char*>(pixels.data() + 48));
  data.putAndInsertUint16Array(DCM_PixelData, pixels.data(), pixels.size());
  data.putAndInsertString(DcmTag(0x7fe1, 0x0010, EVR_LO), planted.c_str());
  data.putAndInsertUint8Array(DcmTag(0xfffc, 0xfffc, EVR_OB), reinterpret_cast<const Uint8*>(behind.data()),
                              static_cast<unsigned long>(behind.size()));
  // In the private elements that may stay.
  data.putAndInsertString(DcmTag(0x0019, 0x0010, EVR_LO), "GEMS_ACQU_01");
  data.putAndInsertString(DcmTag(0x0019, 0x109c, EVR_LO), (planted + "_MRE").c_str());
  data.putAndInsertString(DcmTag(0x0043, 0x0010, EVR_LO), "GEMS_PARM_01");
  data.putAndInsertString(DcmTag(0x0043, 0x102f, EVR_LO), planted.c_str());
  test::save(*file, in.path() / "a.dcm");
  std::string bytes = test::bytes_of(in.path() / "a.dcm");
  bytes.replace(0, planted.size(), planted);  // the preamble
  test::write_bytes(in.path() / "a.dcm", bytes);

  ASSERT_TRUE(deidentify(in.path(), out.path()));
  expect_nothing_planted(out.path());
  const auto study = scan(out.path());
  ASSERT_EQ(study->series.size(), 1U);
  EXPECT_EQ(read_series(study->series.front())->values[47], 47);
  EXPECT_THAT(study->series.front().problems, testing::Each(testing::Not(testing::HasSubstr("bytes of pixels"))));
}

// A codestream has room for comments (JPEG's APP and COM segments) that no list of attributes reaches.
TEST(PlantedIdentity, GoesFromCompressedStreams) {
  const TemporaryFolder in, out;
  test::SliceSpec spec = slice_spec(1);
  test::save_slice(spec, in.path() / "a.dcm", EXS_JPEGProcess14SV1);
  std::string bytes = test::bytes_of(in.path() / "a.dcm");
  const std::size_t start = bytes.find("\xFF\xD8\xFF");
  ASSERT_NE(start, std::string::npos);
  // A comment takes the place of the padding behind: the fragment grows, and so does its length.
  const std::string comment = std::string("\xFF\xFE\x00\x08", 4) + planted;
  bytes.insert(start + 2, comment);
  const auto length_at = start - 4;
  const auto length = static_cast<unsigned char>(bytes[length_at]) +
                      (static_cast<unsigned>(static_cast<unsigned char>(bytes[length_at + 1])) << 8) + comment.size();
  bytes[length_at] = static_cast<char>(length & 0xFF);
  bytes[length_at + 1] = static_cast<char>(length >> 8 & 0xFF);
  test::write_bytes(in.path() / "a.dcm", bytes);

  const auto done = deidentify(in.path(), out.path());
  ASSERT_TRUE(done) << done.error().message();
  expect_nothing_planted(out.path());
  EXPECT_EQ(read_series(scan(out.path())->series.front())->values[3], 30);
}

// Identifiers name the folders and files that are written.
TEST(PlantedIdentity, NeverNamesAFileOrLeavesTheFolder) {
  const TemporaryFolder in, around;
  const fs::path out = around.path() / "a" / "b" / "out";
  const auto file = test::dicom_slice(slice_spec(1));
  DcmDataset& data = *file->getDataset();
  data.putAndInsertString(DCM_SeriesInstanceUID, "1.2.840.10008./../../../SEKRET");
  data.putAndInsertString(DCM_SOPInstanceUID, "1.2.840.10008./../../x");
  test::save(*file, in.path() / "a.dcm");
  const auto done = deidentify(in.path(), out);
  ASSERT_TRUE(done) << done.error().message();
  for (const auto& entry : fs::recursive_directory_iterator(around.path())) {
    if (!entry.is_regular_file()) continue;
    EXPECT_TRUE(entry.path().string().starts_with(out.string() + "/2.25.")) << entry.path();
    EXPECT_EQ(entry.path().filename().string().find_first_not_of("0123456789."),
              entry.path().filename().string().find("dcm"));
  }
  expect_nothing_planted(out);
}

TEST(Deidentify, KeepsFilesApartThatShareTheirIdentifier) {
  const TemporaryFolder in, out;
  for (const int number : {1, 2}) {
    const auto file = test::dicom_slice(slice_spec(number));
    file->getDataset()->putAndInsertString(DCM_SOPInstanceUID, "1.2.3.4.5");
    test::save(*file, in.path() / (std::to_string(number) + ".dcm"));
  }
  const auto done = deidentify(in.path(), out.path());
  ASSERT_TRUE(done);
  ASSERT_EQ(done->files.size(), 2U);
  EXPECT_NE(done->files[0], done->files[1]);
  EXPECT_NE(test::bytes_of(done->files[0]), test::bytes_of(done->files[1])) << "one has taken the other's place";
}

TEST(Deidentify, NamesSegmentsByAnatomyAlone) {
  const TemporaryFolder in, out;
  Grid grid;
  grid.size = {4, 4, 2};
  std::vector<SegmentedMask> segments;
  for (const char* name : {"liver", "tumour-2", "SEKRET liver"}) {
    segments.push_back({{name, static_cast<int>(segments.size()) + 1}, {grid, std::vector<std::uint8_t>(32, 1)}});
  }
  SegmentationSource source;
  source.patient_name = planted;
  source.study_uid = "1.2.3";
  source.series_uid = "1.2.4";
  source.frame_of_reference_uid = "1.2.5";
  ASSERT_TRUE(write_dicom_seg(in.path() / "seg.dcm", segments, source));
  const auto done = deidentify(in.path(), out.path());
  ASSERT_TRUE(done) << done.error().message();
  expect_nothing_planted(out.path());
  const auto read = read_dicom_seg(done->files.front());
  ASSERT_TRUE(read) << read.error().message();
  ASSERT_EQ(read->size(), 3U);
  EXPECT_EQ((*read)[0].info.name, "liver");
  EXPECT_EQ((*read)[1].info.name, "tumour-2");
  EXPECT_EQ((*read)[2].info.name, "segment-3");
  EXPECT_EQ((*read)[1].mask.values, segments[1].mask.values);
}

// PS3.15, E.2: the file says what was done to it.
TEST(Deidentify, NamesTheProfileAndItsOptions) {
  const TemporaryFolder in, out;
  test::save_slice(slice_spec(1), in.path() / "a.dcm");
  const auto done = deidentify(in.path(), out.path());
  ASSERT_TRUE(done);
  DcmFileFormat format;
  ASSERT_TRUE(format.loadFile(done->files.front().c_str()).good());
  std::vector<std::string> codes;
  for (signed long n = 0;; ++n) {
    DcmItem* item = nullptr;
    OFString code;
    if (format.getDataset()->findAndGetSequenceItem(DCM_DeidentificationMethodCodeSequence, item, n).bad()) break;
    item->findAndGetOFString(DCM_CodeValue, code);
    codes.emplace_back(code.c_str());
  }
  EXPECT_THAT(codes, testing::ElementsAre("113100", "113105", "113111"));
}

}  // namespace
}  // namespace glisson::imaging

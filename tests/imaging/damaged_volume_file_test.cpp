// A volume file that is damaged anywhere is refused, or still says what it said; and whole ones read as ITK reads them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>
#include <algorithm>
#include <cstring>
#include <Eigen/Geometry>

#include "base/files.h"
#include "imaging/study.h"
#include "imaging/volume_file.h"
#include "support/data.h"
#include "support/dicom_files.h"

namespace glisson::imaging {
namespace {

namespace fs = std::filesystem;

Volume small_volume() {
  Volume volume;
  volume.grid.size = {9, 7, 5};
  volume.grid.spacing_mm = {1.5, 2.0, 4.0};
  volume.grid.origin_mm = {-31.25, 12.5, -208.0};
  volume.grid.direction =
      (Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX()) * Eigen::AngleAxisd(-0.2, Eigen::Vector3d::UnitZ()))
          .toRotationMatrix();
  // Unlike each other, so that compression finds little and every byte counts.
  for (std::size_t i = 0; i < volume.grid.voxels(); ++i) {
    volume.values.push_back(static_cast<float>(i * i * 7919 % 10007) * 0.25F);
  }
  return volume;
}

std::string code_of(const Result<Volume>& volume) { return volume ? "read" : volume.error().code; }

class DamagedVolumeFile : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    file_ = folder_.path() / (std::string("volume") + GetParam());
    ASSERT_TRUE(write_volume_file(file_, small_volume()));
    good_ = test::bytes_of(file_);
    values_ = read_volume_file(file_)->values;
    ASSERT_EQ(values_, small_volume().values);
  }
  TemporaryFolder folder_;
  fs::path file_;
  std::string good_;
  std::vector<float> values_;
};

TEST_P(DamagedVolumeFile, IsRefusedWhereverItIsCut) {
  for (std::size_t length = 0; length < good_.size(); length += length + 40 < good_.size() ? 7 : 1) {
    test::write_bytes(file_, good_.substr(0, length));
    const auto volume = read_volume_file(file_);
    EXPECT_FALSE(volume) << "cut to " << length << " of " << good_.size() << " bytes";
  }
}

// In the header a changed byte may mean another place or unit; the voxels must be those that were written, or none.
TEST_P(DamagedVolumeFile, NeverGivesOtherVoxelsThanWereWrittenToACompressedStream) {
  const bool all_compressed = file_.extension() == ".gz";
  const std::size_t voxels_begin = all_compressed ? 0 : good_.size() - 800;
  int refused = 0;
  for (std::size_t at = voxels_begin; at < good_.size(); ++at) {
    std::string bad = good_;
    bad[at] = static_cast<char>(bad[at] ^ 0x10);
    test::write_bytes(file_, bad);
    const auto volume = read_volume_file(file_);
    if (!volume) ++refused;
    if (volume) {
      EXPECT_EQ(volume->values, values_) << "byte " << at;
    }
  }
  EXPECT_GT(refused, 700);
}

INSTANTIATE_TEST_SUITE_P(Compressed, DamagedVolumeFile, testing::Values(".nrrd", ".nii.gz", ".mha"));

std::string metaimage(const std::string& fields, const std::string& payload) {
  return "ObjectType = Image\nNDims = 3\nDimSize = 4 3 2\nElementType = MET_UCHAR\n" + fields +
         "ElementDataFile = LOCAL\n" + payload;
}

std::string counting(std::size_t count) {
  std::string bytes;
  for (std::size_t i = 0; i < count; ++i) bytes += static_cast<char>(i + 1);
  return bytes;
}

TEST(MetaImage, IsReadWithoutTheSizeOfItsCompressedVoxels) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "volume.mha";
  ASSERT_TRUE(write_volume_file(file, small_volume()));
  std::string bytes = test::bytes_of(file);
  const std::size_t at = bytes.find("CompressedDataSize");
  ASSERT_NE(at, std::string::npos);
  bytes.erase(at, bytes.find('\n', at) + 1 - at);
  test::write_bytes(file, bytes);
  const auto volume = read_volume_file(file);
  ASSERT_TRUE(volume) << volume.error().message();
  EXPECT_EQ(volume->values, small_volume().values);
}

TEST(MetaImage, FindsItsVoxelsWhereTheHeaderSays) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "volume.mha";
  const std::string voxels = counting(24);
  const std::vector<float> expected(voxels.begin(), voxels.end());
  test::write_bytes(file, metaimage("", voxels));
  EXPECT_EQ(read_volume_file(file)->values, expected);
  test::write_bytes(file, metaimage("HeaderSize = -1\n", "something before" + voxels));
  EXPECT_EQ(read_volume_file(file)->values, expected);
  test::write_bytes(file, metaimage("HeaderSize = 1000000000\n", voxels));
  EXPECT_EQ(code_of(read_volume_file(file)), "volume-file-truncated");
  test::write_bytes(file, metaimage("HeaderSize = -7\n", voxels));
  EXPECT_EQ(code_of(read_volume_file(file)), "volume-file-unreadable");
  test::write_bytes(file, metaimage("", voxels.substr(1)));
  EXPECT_EQ(code_of(read_volume_file(file)), "volume-file-truncated");
  test::write_bytes(file, metaimage("", voxels + "abcd"));
  EXPECT_EQ(code_of(read_volume_file(file)), "volume-file-longer");
  test::write_bytes(file, metaimage("BinaryData = False\n",
                                    "1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 "
                                    "23 24"));
  EXPECT_EQ(read_volume_file(file)->values, expected);
  test::write_bytes(file,
                    metaimage("BinaryData = False\n", "1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 "));
  EXPECT_EQ(code_of(read_volume_file(file)), "volume-file-truncated");
}

// One bad file is skipped with its reason, and the good one beside it is found.
TEST(ScanOfVolumeFiles, FindsTheGoodOnesBesideBadOnes) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_volume_file(folder.path() / "good.mha", small_volume()));
  const std::string good = metaimage("", counting(24));
  const auto with = [&](const std::string& what, const std::string& instead) {
    std::string bytes = good;
    bytes.replace(bytes.find(what), what.size(), instead);
    return bytes;
  };
  const std::pair<const char*, std::string> bad[] = {
      {"axes.mha", with("NDims = 3", "NDims = -1")},
      {"many.mha", with("NDims = 3", "NDims = 2000000000")},
      {"type.mha", with("MET_UCHAR", "MET_SOMETHING")},
      {"none.mha", with("MET_UCHAR", "MET_NONE")},
      {"size.mha", with("4 3 2", "4 3 x")},
      {"minus.mha", with("4 3 2", "4 -3 2")},
      {"list.mha", with("LOCAL", "LIST")},
      {"loop.mha", with("LOCAL", "loop.mha/loop.mha")},
      {"empty.nii.gz", std::string("\x1f\x8b\x08\x00", 4)},
      {"text.nrrd", "NRRD0004\ntype: uchar\ndimension: -3\nsizes: 1 1 1\nencoding: raw\n\nx"},
      {"bz.nrrd", "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 1 1 1\nencoding: bzip2\n\nx"}};
  for (const auto& [name, bytes] : bad) test::write_bytes(folder.path() / name, bytes);
  const auto study = scan(folder.path());
  ASSERT_TRUE(study);
  ASSERT_EQ(study->series.size(), 1U);
  EXPECT_EQ(study->series.front().description, "good.mha");
  EXPECT_EQ(study->skipped.size(), std::size(bad));
}

// Memory is asked for neither by a header that promises much, nor for more than anybody's scan has.
TEST(VolumeFile, RefusesMoreVoxelsThanAnyScanHas) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "large.nrrd";
  test::write_bytes(file,
                    "NRRD0004\ntype: uchar\ndimension: 3\nspace: left-posterior-superior\nsizes: 1024 1024 1024\nspace "
                    "directions: (1,0,0) (0,1,0) (0,0,1)\nencoding: raw\nspace origin: (0,0,0)\n\n");
  fs::resize_file(file, (std::uintmax_t{1} << 30) + 200);  // a hole: nothing is written
  EXPECT_EQ(code_of(read_volume_file(file)), "volume-file-too-large");
  EXPECT_EQ(read_volume_file_header(file).error().code, "volume-file-too-large");
}

// Two megabytes of it took four gigabytes of memory.
TEST(VolumeFile, RefusesWhatUnpacksToHundredsOfTimesItsSize) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "hollow.nrrd";
  const auto packed = [&](const char* slices, std::size_t bytes, const char* type = "short") {
    test::write_bytes(file, std::string("NRRD0004\ntype: ") + type +
                                "\ndimension: 3\nspace: left-posterior-superior\n"
                                "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\n"
                                "endian: little\nencoding: gzip\nsizes: 512 512 " +
                                slices + "\n\n" + std::string(bytes, 'x'));
    const auto header = read_volume_file_header(file);
    return header ? std::string("read") : header.error().code;
  };
  EXPECT_EQ(packed("700", 400'000), "volume-file-hollow");
  EXPECT_EQ(packed("700", 1'000'000), "read");  // a label map of the whole body
  EXPECT_EQ(packed("300", 160'000), "read");
  EXPECT_EQ(packed("700", 300'000), "volume-file-truncated");
  // A byte becomes a float of four: one megabyte took two gigabytes.
  EXPECT_EQ(packed("2000", 1'100'000, "uchar"), "volume-file-hollow");
  EXPECT_EQ(packed("2000", 2'600'000, "uchar"), "read");  // a label map of the whole body, at a 200th
  EXPECT_EQ(packed("600", 200'000, "uchar"), "read");     // the mask of one organ
}

// --- as ITK reads them ---

struct WrittenVolume {
  Grid grid;
  std::vector<double> values;
};

std::optional<WrittenVolume> read_by_itk(itk::ImageIOBase& io, const fs::path& file) {
  io.SetFileName(file.string());
  io.ReadImageInformation();
  WrittenVolume volume;
  itk::ImageIORegion region(io.GetNumberOfDimensions());
  for (unsigned axis = 0; axis < io.GetNumberOfDimensions(); ++axis) {
    region.SetIndex(axis, 0);
    region.SetSize(axis, io.GetDimensions(axis));
    if (axis >= 3) continue;
    volume.grid.size[axis] = static_cast<int>(io.GetDimensions(axis));
    volume.grid.spacing_mm[axis] = io.GetSpacing(axis);
    volume.grid.origin_mm[axis] = io.GetOrigin(axis);
    for (unsigned row = 0; row < 3; ++row) volume.grid.direction(row, axis) = io.GetDirection(axis)[row];
  }
  io.SetIORegion(region);
  std::vector<char> bytes(io.GetImageSizeInBytes());
  io.Read(bytes.data());
  const std::size_t voxels = volume.grid.voxels();
  volume.values.resize(voxels);
  const auto take = [&](auto one) {
    for (std::size_t i = 0; i < voxels; ++i) {
      std::memcpy(&one, bytes.data() + i * sizeof one, sizeof one);
      volume.values[i] = static_cast<double>(one);
    }
  };
  using Type = itk::IOComponentEnum;
  switch (io.GetComponentType()) {
    case Type::UCHAR: take(static_cast<unsigned char>(0)); break;
    case Type::SHORT: take(short{0}); break;
    case Type::USHORT: take(static_cast<unsigned short>(0)); break;
    case Type::INT: take(int{0}); break;
    case Type::FLOAT: take(float{0}); break;
    case Type::DOUBLE: take(double{0}); break;
    default: return std::nullopt;
  }
  return volume;
}

std::optional<WrittenVolume> read_by_itk(const fs::path& file) {
  const std::string name = file.filename().string();
  if (name.ends_with(".nii") || name.ends_with(".nii.gz")) return read_by_itk(*itk::NiftiImageIO::New(), file);
  if (name.ends_with(".nrrd")) return read_by_itk(*itk::NrrdImageIO::New(), file);
  return read_by_itk(*itk::MetaImageIO::New(), file);
}

void expect_as_itk(const fs::path& file) {
  SCOPED_TRACE(file.string());
  const auto theirs = read_by_itk(file);
  ASSERT_TRUE(theirs);
  const auto ours = read_volume_file(file);
  ASSERT_TRUE(ours) << ours.error().message();
  ASSERT_EQ(ours->grid.size, theirs->grid.size);
  EXPECT_TRUE(ours->grid.spacing_mm.isApprox(theirs->grid.spacing_mm, 1e-5));
  EXPECT_LT((ours->grid.origin_mm - theirs->grid.origin_mm).norm(), 1e-3);
  EXPECT_LT((ours->grid.direction - theirs->grid.direction).norm(), 1e-4);
  for (std::size_t i = 0; i < ours->values.size(); ++i) {
    ASSERT_FLOAT_EQ(ours->values[i], static_cast<float>(theirs->values[i])) << "voxel " << i;
  }
}

TEST(VolumeFile, ReadsRealFilesAsItkDoes) {
  GLISSON_NEEDS_DATA("totalseg_abdomen_mr_ct");
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(test::shared_data())) {
    const std::string name = entry.path().filename().string();
    const bool volume =
        name.ends_with(".nii.gz") || name.ends_with(".nii") || name.ends_with(".nrrd") || name.ends_with(".mha");
    if (!volume || !entry.is_regular_file() || entry.file_size() > (8u << 20)) continue;
    if (!read_volume_file_header(entry.path())) continue;  // more than three axes
    expect_as_itk(entry.path());
    if (++files == 12) break;
  }
  EXPECT_GE(files, 3);
}

// The fields of a NIfTI header that say where it lies, in each of the ways that nifti1.h allows.
TEST(Nifti, IsPlacedAsItkPlacesIt) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "volume.nii";
  ASSERT_TRUE(write_volume_file(file, small_volume()));
  const std::string good = test::bytes_of(file);
  const auto put = [](std::string& bytes, std::size_t at, auto value) {
    std::memcpy(bytes.data() + at, &value, sizeof value);
  };
  constexpr std::size_t qform = 252, sform = 254, pixdim = 76, slope = 112, intercept = 116;
  for (const auto& [q, s] : {std::pair{1, 0}, {0, 1}, {1, 1}, {2, 1}}) {
    for (const float factor : {1.0F, -1.0F}) {
      std::string bytes = good;
      put(bytes, qform, static_cast<std::int16_t>(q));
      put(bytes, sform, static_cast<std::int16_t>(s));
      put(bytes, pixdim, factor);  // the sense of the third axis of a quaternion
      if (s != 0 && factor < 0 && q != 0) continue;
      put(bytes, slope, 2.5F);
      put(bytes, intercept, -3.0F);
      test::write_bytes(file, bytes);
      SCOPED_TRACE(std::to_string(q) + " " + std::to_string(s) + " " + std::to_string(factor));
      expect_as_itk(file);
    }
  }
}

TEST(Nrrd, IsPlacedAsItkPlacesIt) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "volume.nrrd";
  const std::string head = "NRRD0004\n# a comment\ntype: unsigned short\ndimension: 3\nsizes: 4 3 2\nendian: big\n";
  const std::string voxels = counting(48);
  for (const char* where : {"space: left-posterior-superior\nspace directions: (2,0,0) (0,0,3) (0,-4,0)\nspace origin: "
                            "(1,2,3)\nencoding: raw\n\n",
                            "space: RAS\nspace directions: (2,0,0) (0,0,3) (0,-4,0)\nspace origin: (1,2,3)\nencoding: "
                            "raw\n\n",
                            "spacings: 2 3 4\naxis mins: 1 2 3\nencoding: raw\n\n",
                            "spacings: 2 3 4\naxis mins: 1 2 3\ncenters: node node node\nencoding: raw\n\n",
                            "spacings: 2 3 4\nencoding: raw\n\n", "encoding: raw\n\n"}) {
    test::write_bytes(file, head + where + voxels);
    SCOPED_TRACE(where);
    expect_as_itk(file);
  }
}

// ITK 5.2 turns the first axis of this space in place of the second.
TEST(Nrrd, TurnsAnteriorToPosterior) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "volume.nrrd";
  test::write_bytes(file,
                    "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 4 3 2\nspace: left-anterior-superior\nspace "
                    "directions: (2,0,0) (0,3,0) (0,0,4)\nspace origin: (1,2,3)\nencoding: raw\n\n" +
                        counting(24));
  const auto volume = read_volume_file(file);
  ASSERT_TRUE(volume) << volume.error().message();
  EXPECT_EQ(volume->grid.origin_mm, Eigen::Vector3d(1, -2, 3));
  EXPECT_EQ(volume->grid.direction.col(1), Eigen::Vector3d(0, -1, 0));
}

TEST(MetaImage, IsPlacedAsItkPlacesIt) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "volume.mha";
  for (const char* where : {"Offset = 1 2 3\nTransformMatrix = 0 1 0 -1 0 0 0 0 1\nElementSpacing = 2 3 4\n",
                            "Position = 1 2 3\nRotation = 1 0 0 0 0 1 0 -1 0\nElementSize = 2 3 4\n",
                            "ElementSpacing = 2 3 4\nElementByteOrderMSB = True\nBinaryData = True\n", ""}) {
    test::write_bytes(file, metaimage(where, counting(24)));
    SCOPED_TRACE(where);
    expect_as_itk(file);
  }
}

}  // namespace
}  // namespace glisson::imaging

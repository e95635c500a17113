// Structures that another program outlines. The stand-in for a network is a shell script that takes what it outlines
// from a folder beside it, and keeps what it was handed.

#include "casefile/outlined_by_program.h"

#include <gmock/gmock.h>

#include "base/files.h"
#include "casefile/structures.h"
#include "imaging/volume_file.h"

namespace glisson::casefile {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class OutlinedByProgram : public testing::Test {
 protected:
  OutlinedByProgram() {
    image_.grid = {{10, 8, 6}, {1, 1.5, 2}, {-30, 12, 7}, Eigen::Matrix3d::Identity()};
    image_.values.resize(480);
    for (std::size_t n = 0; n < image_.values.size(); ++n) image_.values[n] = static_cast<float>(n) * 0.5F - 100;
    patient_ = *Case::create(folder_.path() / "a.glisson");
    EXPECT_TRUE(patient_->add("volumes/anatomy", ".nrrd", {"import", {}, {}, {}, {}},
                              [&](const fs::path& file) { return imaging::write_volume_file(file, image_); }));
    fs::create_directories(kept());
    // Copies what it outlines into $2 and what it was handed into its own folder.
    EXPECT_TRUE(write_text_file(folder_.path() / "network", "#!/bin/sh\nset -e\ncp \"$1\" '" + kept().string() +
                                                                "/handed.nii.gz'\necho ' 50%|#'\ncp -r '" +
                                                                kept().string() + "/outlines/.' \"$2\"\n"));
    fs::permissions(folder_.path() / "network", fs::perms::owner_all);
    fs::create_directories(outlines());
  }
  fs::path kept() const { return folder_.path() / "kept"; }
  fs::path outlines() const { return kept() / "outlines"; }
  std::string network() const { return (folder_.path() / "network").string(); }

  // A label map of 8 bits in which the first voxels hold these values.
  void outlines(const std::string& name, const std::vector<std::uint8_t>& first) const {
    std::string header =
        "NRRD0004\ntype: unsigned char\ndimension: 3\nspace: left-posterior-superior\nsizes: 10 8 6\n"
        "space directions: (1,0,0) (0,1.5,0) (0,0,2)\nkinds: domain domain domain\nencoding: raw\n"
        "space origin: (-30,12,7)\n\n";
    std::string voxels(480, '\0');
    for (std::size_t n = 0; n < first.size(); ++n) voxels[n] = static_cast<char>(first[n]);
    ASSERT_TRUE(write_text_file(outlines() / name, header + voxels));
  }
  std::size_t voxels(const std::string& structure) const {
    const auto mask = imaging::read_mask_file(folder_.path() / "a.glisson" / "labels" / (structure + ".nrrd"));
    if (!mask) return 0;
    return static_cast<std::size_t>(std::count(mask->mask.values.begin(), mask->mask.values.end(), 1));
  }

  TemporaryFolder folder_;
  imaging::Volume image_;
  std::optional<Case> patient_;
};

TEST_F(OutlinedByProgram, FilesOfOneStructureEachComeInByTheirNames) {
  outlines("liver.nrrd", {1, 1, 1, 1, 1});
  outlines("spleen.nrrd", {0, 0, 0, 0, 0, 1, 1});
  outlines("gallbladder.nrrd", {});          // not in these images
  outlines("vertebrae_L1.nrrd", {0, 1, 1});  // nothing that Glisson knows
  ASSERT_TRUE(write_text_file(outlines() / "statistics.json", "{}"));
  double farthest = 0;
  const Progress progress([&](double fraction, std::string_view) { farthest = std::max(farthest, fraction); });
  const auto outlined = outline_by_program(*patient_, {network() + " {image} {folder}"}, progress);
  ASSERT_TRUE(outlined) << outlined.error().message();
  ASSERT_EQ(outlined->size(), 2U);
  EXPECT_EQ(voxels("liver"), 5U);
  EXPECT_EQ(voxels("spleen"), 2U);
  EXPECT_EQ(patient_->find("labels/liver")->made.options.at("program"), network() + " {image} {folder}");
  EXPECT_GT(farthest, 0.9);

  const auto handed = imaging::read_volume_file(kept() / "handed.nii.gz");
  ASSERT_TRUE(handed) << handed.error().message();
  EXPECT_TRUE(imaging::same_grid(handed->grid, image_.grid));
  EXPECT_EQ(handed->values, image_.values);
}

TEST_F(OutlinedByProgram, ValuesWithoutNamesAreNamedByThePersonAndMayBeAbsent) {
  outlines("labels.nrrd", {1, 1, 1, 2, 0, 7});
  const OutliningProgram unnamed{network() + " {image} {folder}"};
  EXPECT_EQ(outline_by_program(*patient_, unnamed).error().code, "labels-unnamed");
  EXPECT_EQ(patient_->find("labels/liver"), nullptr);
  const OutliningProgram named{unnamed.command, {{1, "liver"}, {2, "tumour-1"}, {3, "cyst-1"}}};
  const auto outlined = outline_by_program(*patient_, named);
  ASSERT_TRUE(outlined) << outlined.error().message();
  EXPECT_EQ(voxels("liver"), 3U);
  EXPECT_EQ(voxels("tumour-1"), 1U);
  EXPECT_EQ(outlined->size(), 2U);
}

TEST_F(OutlinedByProgram, AFailureLeavesTheCaseAsItWas) {
  outlines("liver.nrrd", {1, 1, 1});
  ASSERT_TRUE(outline_by_program(*patient_, {network() + " {image} {folder}"}));
  const std::string before = *read_text_file(patient_->folder() / "case.json");
  const auto code = [&](const std::string& command) {
    const auto outlined = outline_by_program(*patient_, {command});
    return outlined ? std::string("none") : outlined.error().code;
  };
  EXPECT_EQ(code("no-such-network {image} {folder}"), "program-not-found");
  EXPECT_EQ(code("sh -c 'echo out of memory; exit 1' {image} {folder}"), "program-failed");
  EXPECT_EQ(code("true {image} {folder}"), "program-no-labels");
  EXPECT_EQ(code("true {folder}"), "command-no-image");
  EXPECT_EQ(code("true {image}"), "command-no-labels");
  EXPECT_EQ(code("true '{image} {folder}"), "command-quote-open");
  EXPECT_EQ(code("sh -c 'echo rubbish > {labels}' {image}"), "program-no-labels");
  outlines("spleen.nrrd", {0, 0, 0, 1});
  ASSERT_TRUE(write_text_file(outlines() / "spleen-2.nrrd", *read_text_file(outlines() / "spleen.nrrd")));
  fs::rename(outlines() / "spleen-2.nrrd", outlines() / "spleen_seg.nrrd");
  EXPECT_EQ(code(network() + " {image} {folder}"), "labels-twice");
  EXPECT_EQ(*read_text_file(patient_->folder() / "case.json"), before);
  EXPECT_EQ(voxels("liver"), 3U);
}

}  // namespace
}  // namespace glisson::casefile

// What is written of a generated patient opens again, says that it is simulated, and is the same to the byte.

#include <gtest/gtest.h>
#include <set>

#include "anatomy/write_patient.h"
#include "base/files.h"
#include "base/json.h"
#include "geometry/mesh_file.h"
#include "imaging/volume_file.h"

namespace glisson::anatomy {
namespace {

namespace fs = std::filesystem;

Patient small_patient() {
  PatientOptions options;
  options.seed = 7;
  options.volume_ml = 900;
  options.portal_terminals = options.hepatic_terminals = options.arterial_terminals = 60;
  options.lesions = {{LesionKind::tumour, 20, {}, {}}};
  return make_patient(options).value();
}

TEST(WrittenPatient, OpensAgainAndSaysThatItIsSimulated) {
  const TemporaryFolder folder;
  const Patient patient = small_patient();
  ASSERT_TRUE(write_patient(folder.path(), patient, {4, true}));
  for (const char* name : {"liver", "portal-vein", "hepatic-vein", "artery", "gallbladder", "vena-cava", "tumour-1"}) {
    EXPECT_TRUE(geometry::read_surface(folder.path() / "surfaces" / (std::string(name) + ".vtp"))) << name;
    EXPECT_TRUE(imaging::read_mask_file(folder.path() / "labels" / (std::string(name) + ".nrrd"))) << name;
  }
  const auto couinaud = imaging::read_labels_file(folder.path() / "labels/couinaud.nrrd");
  ASSERT_TRUE(couinaud);
  std::array<double, 9> voxels{};
  for (const std::uint16_t value : couinaud->values) voxels.at(value) += 1;
  for (int segment = 1; segment <= 8; ++segment) {
    // Voxels of 4 mm against those of 3 mm.
    const double ml = voxels.at(static_cast<std::size_t>(segment)) * couinaud->grid.voxel_volume_mm3() / 1000;
    EXPECT_NEAR(ml, patient.segments->volume_ml(segment), 0.06 * ml + 2) << segment;
  }

  const Json truth = read_json_file(folder.path() / "truth.json").value();
  EXPECT_EQ(truth.at("simulated"), is_simulated);
  EXPECT_EQ(truth.at("lesions").at(0).at("diameter_mm"), 20);
  const Json tree = read_json_file(folder.path() / "trees/portal-vein.json").value();
  EXPECT_EQ(tree.at("format"), "glisson-vessel-tree/1");
  ASSERT_EQ(tree.at("nodes").size(), patient.portal_vein.nodes.size());
  for (const Json& node : tree.at("nodes")) EXPECT_LT(node.at("parent").get<int>(), node.at("id").get<int>());
}

TEST(WrittenPatient, LeavesNothingOfThePatientBeforeAndWhateverElseLiesThere) {
  const TemporaryFolder folder;
  Patient patient = small_patient();
  ASSERT_TRUE(write_patient(folder.path(), patient, {8, true}));
  ASSERT_TRUE(write_text_file(folder.path() / "surfaces/mine.vtp", "mine"));
  const auto files = [&] {
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder.path())) {
      if (entry.is_regular_file()) names.insert(entry.path().lexically_relative(folder.path()).string());
    }
    return names;
  };
  auto expected = files();
  patient.lesions.clear();
  ASSERT_TRUE(write_patient(folder.path(), patient, {8, true}));
  EXPECT_EQ(expected.erase("surfaces/tumour-1.vtp") + expected.erase("labels/tumour-1.nrrd"), 2u);
  EXPECT_EQ(files(), expected);  // no hidden part either
  EXPECT_EQ(read_text_file(folder.path() / "surfaces/mine.vtp").value(), "mine");
  EXPECT_TRUE(read_json_file(folder.path() / "truth.json").value().at("lesions").empty());
}

TEST(WrittenPatient, IsTheSameToTheByte) {
  const TemporaryFolder once, again;
  ASSERT_TRUE(write_patient(once.path(), small_patient(), {4, true}));
  ASSERT_TRUE(write_patient(again.path(), small_patient(), {4, true}));
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(once.path())) {
    if (!entry.is_regular_file()) continue;
    const fs::path other = again.path() / entry.path().lexically_relative(once.path());
    EXPECT_EQ(sha256_of_file(entry.path()).value(), sha256_of_file(other).value()) << other;
    ++files;
  }
  EXPECT_EQ(files, 7 + 8 + 3 + 1);
}

}  // namespace
}  // namespace glisson::anatomy

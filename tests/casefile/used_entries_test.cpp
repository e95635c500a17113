// What another program has changed is said wherever an answer is made from it, and refused where it is of another body.

#include "casefile/used_entries.h"

#include <gmock/gmock.h>

#include "base/files.h"
#include "casefile/export.h"
#include "casefile/model.h"
#include "casefile/structures.h"
#include "geometry/mesh_file.h"
#include "imaging/volume_file.h"
#include "mechanics/bodies.h"
#include "segmentation/edit.h"

namespace glisson::casefile {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::HasSubstr;

class UsedEntries : public testing::Test {
 protected:
  void SetUp() override {
    auto patient = Case::create(folder_);
    ASSERT_TRUE(patient);
    ASSERT_TRUE(save_structure(*patient, segmentation::make_structure("liver", ball({45, 30, 30})),
                               {"segment", {}, {}, {}, {}}));
    mesh_ = mechanics::test::box(6, 4, 4, {90, 60, 60});
    ASSERT_TRUE(patient->add("meshes/liver", ".vtu", {"mesh", {}, {"labels/liver"}, {}, {}},
                             [&](const fs::path& file) { return geometry::write_tetrahedra(file, mesh_); }));
    ASSERT_TRUE(assign_stiffness(*patient, Uniform{5.0}));
  }
  static imaging::Mask ball(const Eigen::Vector3d& center_mm) {
    imaging::Mask mask;
    mask.grid.size = {60, 40, 40};
    mask.grid.spacing_mm = {3, 3, 3};
    mask.values.resize(mask.grid.voxels());
    return segmentation::paint(std::move(mask), {center_mm, 50});
  }
  // As another program would.
  void replace_mesh(const std::string& id, const Eigen::Vector3d& by_mm, double youngs_kPa) {
    geometry::TetMesh other = mesh_;
    for (Eigen::Vector3d& point : other.points_mm) point += by_mm;
    geometry::set_field(other.cell_fields,
                        {"youngs_modulus_kPa", 1, std::vector<double>(other.cells.size(), youngs_kPa)});
    ASSERT_TRUE(geometry::write_tetrahedra(folder_ / (id + ".vtu"), other));
  }
  Result<PatientModel> model() const {
    return Case::open(folder_).and_then([](const Case& patient) { return read_model(patient); });
  }

  std::vector<std::string> said() const { return messages(model_remarks(Case::open(folder_).value())); }

  TemporaryFolder temporary_;
  fs::path folder_ = temporary_.path() / "patient.glisson";
  geometry::TetMesh mesh_;
};

TEST_F(UsedEntries, NothingIsSaidOfWhatIsAsItWasSaved) {
  const auto read = model();
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_TRUE(said().empty());
  EXPECT_TRUE(export_remarks(Case::open(folder_).value(), ExportFormat::nrrd).empty());
}

// A new outline makes the mesh stale, and with it the model: what is to be made first is named.
TEST_F(UsedEntries, WhatIsStaleByAnotherNamesThatOne) {
  auto patient = Case::open(folder_);
  ASSERT_TRUE(
      save_structure(*patient, segmentation::make_structure("liver", ball({48, 30, 30})), {"segment", {}, {}, {}, {}}));
  const auto remarks = messages(remarks_on(*patient, {"meshes/liver", "meshes/model"}));
  ASSERT_EQ(remarks.size(), 2u);
  EXPECT_EQ(remarks[0], "What meshes/liver was made from has changed since: make it anew.");
  EXPECT_THAT(remarks[1], HasSubstr("make meshes/liver anew, then meshes/model"));
}

TEST_F(UsedEntries, AModelWithOtherStiffnessIsTakenAndToldOf) {
  replace_mesh("meshes/model", {0, 0, 0}, 9);
  const auto read = model();
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(youngs_kPa(*read).front(), 9);
  EXPECT_THAT(said(), Contains(HasSubstr("Another program has changed meshes/model")));
  EXPECT_THAT(messages(export_remarks(Case::open(folder_).value(), ExportFormat::vtu)),
              Contains(HasSubstr("meshes/model")));
}

TEST_F(UsedEntries, AnothersMeshIsRefused) {
  replace_mesh("meshes/model", {3, 0, 0}, 5);  // almost in the same place: its points tell
  EXPECT_EQ(model().error().code, "model-of-another");
  replace_mesh("meshes/liver", {3, 0, 0}, 5);  // both from elsewhere, and still in the liver: told of
  EXPECT_TRUE(model());
  replace_mesh("meshes/model", {90, 0, 0}, 5);
  EXPECT_EQ(model().error().code, "model-of-another");
  const fs::path out = temporary_.path() / "liver.vtu";
  EXPECT_EQ(export_case(Case::open(folder_).value(), ExportFormat::vtu, out).error().code, "model-of-another");
  EXPECT_FALSE(fs::exists(out));
}

TEST_F(UsedEntries, AnEditedLabelIsToldOfAndAnothersLiverIsRefused) {
  const auto put = [&](const Eigen::Vector3d& center_mm) {
    return imaging::write_mask_file(folder_ / "labels/liver.nrrd", ball(center_mm), {"liver", 1, {1, 0, 0}});
  };
  ASSERT_TRUE(put({48, 30, 30}));
  const auto read = model();
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_THAT(said(), Contains(HasSubstr("Another program has changed labels/liver")));
  EXPECT_THAT(said(), Contains(HasSubstr("make meshes/liver anew, then meshes/model")));
  EXPECT_THAT(messages(export_remarks(Case::open(folder_).value(), ExportFormat::nifti)),
              Contains(HasSubstr("labels/liver")));
  ASSERT_TRUE(put({175, 100, 100}));
  EXPECT_EQ(model().error().code, "model-of-another");
}

}  // namespace
}  // namespace glisson::casefile

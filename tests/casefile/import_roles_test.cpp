// Series taken into a case in the roles that a person gave them, and nothing asked for besides.

#include <gmock/gmock.h>

#include "base/files.h"
#include "casefile/import.h"
#include "imaging/volume_file.h"

namespace glisson::casefile {
namespace {

namespace fs = std::filesystem;
using imaging::Role;

class ImportRolesTest : public testing::Test {
 protected:
  ImportRolesTest() {
    fs::create_directories(images_);
    for (const char* name : {"one.nrrd", "two.nrrd"}) {
      imaging::Volume volume;
      volume.grid.size = {8, 7, 5};
      volume.values.assign(volume.grid.voxels(), name[0] == 'o' ? 1.5F : 2.5F);
      EXPECT_TRUE(imaging::write_volume_file(images_ / name, volume));
    }
    study_ = imaging::scan(images_).value();
  }
  std::string uid(const std::string& name) const {
    for (const imaging::Series& series : study_.series) {
      if (series.files.front().filename() == name) return series.uid;
    }
    return {};
  }
  Result<Imported> import(const std::vector<SeriesRole>& roles) {
    fs::remove_all(folder_);
    auto made = Case::create(folder_);
    return import_series_as(*made, study_, roles);
  }
  std::size_t entries() const { return Case::open(folder_)->entries().size(); }

  TemporaryFolder temporary_;
  fs::path images_ = temporary_.path() / "images", folder_ = temporary_.path() / "patient.glisson";
  imaging::Study study_;
};

TEST_F(ImportRolesTest, WavesAloneMakeACaseWithoutAnAnatomy) {
  const auto imported = import({{uid("one.nrrd"), Role::mre_wave}, {uid("two.nrrd"), Role::other}});
  ASSERT_TRUE(imported) << imported.error().message();
  EXPECT_EQ(entries(), 1u);
  EXPECT_TRUE(Case::open(folder_)->find("volumes/wave"));
}

TEST_F(ImportRolesTest, EachSeriesIsWhatThePersonSays) {
  ASSERT_TRUE(import({{uid("one.nrrd"), Role::mre_confidence}, {uid("two.nrrd"), Role::anatomy}}));
  const auto opened = Case::open(folder_);
  EXPECT_EQ(opened->volume("volumes/confidence")->values.front(), 1.5F);
  EXPECT_EQ(opened->volume("volumes/anatomy")->values.front(), 2.5F);
}

TEST_F(ImportRolesTest, SeveralPhasesAreNumberedThrough) {
  ASSERT_TRUE(import({{uid("one.nrrd"), Role::mre_phase}, {uid("two.nrrd"), Role::mre_phase}}));
  EXPECT_TRUE(Case::open(folder_)->find("volumes/phase-01"));
  EXPECT_TRUE(Case::open(folder_)->find("volumes/phase-02"));
}

TEST_F(ImportRolesTest, AMagnitudeServesAsTheAnatomyWhereThereIsNone) {
  ASSERT_TRUE(import({{uid("one.nrrd"), Role::mre_magnitude}}));
  EXPECT_TRUE(Case::open(folder_)->find("volumes/anatomy"));
  EXPECT_TRUE(Case::open(folder_)->find("volumes/magnitude"));
}

// The mark comes with the volumes, in one transaction: an import that is killed or cancelled cannot lose it.
TEST_F(ImportRolesTest, ASimulatedStudyIsTakenInWithItsMarkOrNotAtAll) {
  for (imaging::Series& series : study_.series) series.description = "Simulated " + series.description;
  fs::remove_all(folder_);
  auto made = Case::create(folder_);
  std::stop_source stop;
  stop.request_stop();
  const auto interrupted =
      import_series_as(*made, study_, {{uid("one.nrrd"), Role::anatomy}}, Progress({}, stop.get_token()));
  EXPECT_EQ(interrupted.error().code, "cancelled");
  EXPECT_EQ(Case::open(folder_)->origin(), "");
  EXPECT_TRUE(Case::open(folder_)->entries().empty());
  ASSERT_TRUE(import_series_as(*made, study_, {{uid("one.nrrd"), Role::anatomy}}));
  EXPECT_THAT(Case::open(folder_)->origin(), testing::StartsWith("SIMULATED"));
  EXPECT_EQ(Case::open(folder_)->entries().size(), 1u);
}

TEST_F(ImportRolesTest, RefusesWhatCannotBe) {
  EXPECT_EQ(import({{uid("one.nrrd"), Role::other}}).error().code, "import-nothing");
  EXPECT_EQ(import({{uid("one.nrrd"), Role::anatomy}, {uid("two.nrrd"), Role::anatomy}}).error().code,
            "import-role-twice");
  EXPECT_EQ(import({{"nobody", Role::anatomy}}).error().code, "import-unknown-uid");
  EXPECT_EQ(entries(), 0u);
}

}  // namespace
}  // namespace glisson::casefile

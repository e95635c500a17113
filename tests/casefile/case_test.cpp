// The case folder survives whatever interrupts it, and says what is stale.

#include <gmock/gmock.h>
#include <fstream>

#include "base/files.h"
#include "casefile/case.h"

namespace glisson::casefile {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

auto text_writer(std::string text) {
  return [text = std::move(text)](const fs::path& file) -> Result<void> {
    std::ofstream(file) << text;
    return {};
  };
}

class CaseTest : public testing::Test {
 protected:
  TemporaryFolder temporary_;
  fs::path folder_ = temporary_.path() / "patient.glisson";
};

TEST_F(CaseTest, OpensWithAllThatWasSaved) {
  auto made = Case::create(folder_);
  ASSERT_TRUE(made);
  ASSERT_TRUE(made->add("volumes/anatomy", ".nrrd",
                        {"import", {{"series", "1.2"}}, {}, {{"a.dcm", "00"}}, {{"a note on {0}", {"liver"}}}},
                        text_writer("voxels")));
  ASSERT_TRUE(made->set_origin("SIMULATED"));

  const auto opened = Case::open(folder_);
  ASSERT_TRUE(opened);
  ASSERT_EQ(opened->entries().size(), 1u);
  const Entry& entry = opened->entries().front();
  EXPECT_EQ(entry.sha256, sha256_of_text("voxels"));
  EXPECT_EQ(entry.made.options.at("series"), "1.2");
  EXPECT_EQ(entry.made.notes.front().message(), "a note on liver");
  EXPECT_EQ(entry.made.notes.front().arguments, std::vector<std::string>{"liver"});
  EXPECT_EQ(opened->origin(), "SIMULATED");
  EXPECT_EQ(read_text_file(opened->file_of("volumes/anatomy").value()).value(), "voxels");
}

TEST_F(CaseTest, AFailedAdditionLeavesTheCaseAsItWas) {
  auto made = Case::create(folder_);
  ASSERT_TRUE(made->add("labels/liver", ".nrrd", {"segment", {}, {}, {}, {}}, text_writer("first")));
  EXPECT_FALSE(
      made->add("labels/liver", ".nrrd", {"segment", {}, {}, {}, {}}, [](const fs::path& file) -> Result<void> {
        std::ofstream(file) << "half a fi";
        return failure("test", "disk full");
      }));
  EXPECT_EQ(read_text_file(made->file_of("labels/liver").value()).value(), "first");
  EXPECT_EQ(Case::open(folder_)->freshness("labels/liver"), Freshness::current);
}

// The two moments at which a kill could tear an addition apart, re-enacted on disk.
TEST_F(CaseTest, KilledBeforeTheRecordOpensAsItWas) {
  auto made = Case::create(folder_);
  ASSERT_TRUE(made->add("labels/liver", ".nrrd", {"segment", {}, {}, {}, {}}, text_writer("old")));
  std::ofstream(folder_ / "labels/.next-liver.nrrd") << "new, but not recorded";
  const auto opened = Case::open(folder_);
  ASSERT_TRUE(opened);
  EXPECT_EQ(read_text_file(opened->file_of("labels/liver").value()).value(), "old");
  EXPECT_FALSE(fs::exists(folder_ / "labels/.next-liver.nrrd"));
}

TEST_F(CaseTest, KilledAfterTheRecordOpensAsItBecame) {
  auto made = Case::create(folder_);
  ASSERT_TRUE(made->add("labels/liver", ".nrrd", {"segment", {}, {}, {}, {}}, text_writer("new")));
  fs::rename(folder_ / "labels/liver.nrrd", folder_ / "labels/.next-liver.nrrd");
  std::ofstream(folder_ / "labels/liver.nrrd") << "old";
  const auto opened = Case::open(folder_);
  ASSERT_TRUE(opened);
  EXPECT_EQ(read_text_file(opened->file_of("labels/liver").value()).value(), "new");
}

TEST_F(CaseTest, AnEditOfTheLiverMakesItsMeshStale) {
  auto made = Case::create(folder_);
  ASSERT_TRUE(made->add("labels/liver", ".nrrd", {"segment", {}, {}, {}, {}}, text_writer("liver")));
  ASSERT_TRUE(made->add("meshes/liver", ".vtu", {"mesh", {}, {"labels/liver"}, {}, {}}, text_writer("mesh")));
  EXPECT_EQ(made->freshness("meshes/liver"), Freshness::current);
  // Edited in another program:
  std::ofstream(folder_ / "labels/liver.nrrd") << "liver, corrected";
  EXPECT_EQ(made->freshness("labels/liver"), Freshness::changed_outside);
  EXPECT_EQ(made->freshness("meshes/liver"), Freshness::stale);
}

TEST_F(CaseTest, RefusesWhatIsNotItsOwn) {
  EXPECT_EQ(Case::open(temporary_.path()).error().code, "not-a-case");
  ASSERT_TRUE(Case::create(folder_));
  EXPECT_EQ(Case::create(folder_).error().code, "case-exists");
  ASSERT_TRUE(write_text_file(folder_ / "case.json", R"({"format": "glisson-case/1", "entries":
      [{"id": "x", "file": "../../etc/passwd", "sha256": "", "made": {"by": "import"}}]})"));
  EXPECT_EQ(Case::open(folder_).error().code, "case-path-outside");
  EXPECT_THAT(Case::create(folder_ / "other")->file_of("meshes/liver").error().advice(), HasSubstr("glisson-cli mesh"));
}

}  // namespace
}  // namespace glisson::casefile

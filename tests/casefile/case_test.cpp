// The case folder survives whatever interrupts it, and says what is stale.

#include <gmock/gmock.h>
#include <fstream>

#include "base/files.h"
#include "casefile/case.h"
#include "casefile/internal/new_case.h"

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

// A label that says that its file is case.json would let the next segmentation delete the case.
TEST_F(CaseTest, RefusesAnEntryThatIsNotInItsPlace) {
  for (const char* file : {"case.json", "history/journal.json", "labels/tumour.nrrd",
                           "labels/liver.nrrd/../../case.json", "labels/.next-liver.nrrd", "labels/liver"}) {
    fs::remove_all(folder_);
    ASSERT_TRUE(Case::create(folder_));
    ASSERT_TRUE(write_text_file(folder_ / "case.json", std::string(R"({"format": "glisson-case/1", "entries":
        [{"id": "labels/liver", "file": ")") + file + R"(", "sha256": "", "made": {"by": "segment"}}]})"));
    EXPECT_EQ(Case::open(folder_).error().code, "case-path-outside") << file;
  }
}

TEST_F(CaseTest, WritesThroughNoLink) {
  auto made = Case::create(folder_);
  const fs::path elsewhere = temporary_.path() / "elsewhere";
  fs::create_directories(elsewhere);
  ASSERT_TRUE(write_text_file(elsewhere / "liver.vtu", "theirs"));
  fs::create_directory_symlink(elsewhere, folder_ / "meshes");
  const auto added = made->add("meshes/liver", ".vtu", {"mesh", {}, {}, {}, {}}, text_writer("ours"));
  ASSERT_FALSE(added);
  EXPECT_EQ(added.error().code, "case-link");
  EXPECT_EQ(read_text_file(elsewhere / "liver.vtu").value(), "theirs");
  EXPECT_EQ(Case::open(folder_)->entries().size(), 0u);
}

TEST_F(CaseTest, OpeningRemovesWhatKilledWritersLeft) {
  auto made = Case::create(folder_);
  ASSERT_TRUE(made->add("labels/liver", ".nrrd", {"segment", {}, {}, {}, {}}, text_writer("liver")));
  for (const char* left : {".part-case.json", "labels/.part-12-0-.next-liver.nrrd", "labels/.next-tumour.nrrd",
                           "results/mre/.part-result.vtu"}) {
    ASSERT_TRUE(write_text_file(folder_ / left, "half a fi"));
  }
  ASSERT_TRUE(Case::open(folder_));
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder_)) {
    if (entry.is_regular_file()) names.push_back(entry.path().filename().string());
  }
  EXPECT_THAT(names, testing::UnorderedElementsAre("case.json", "liver.nrrd"));
}

TEST_F(CaseTest, ANewCaseIsThereWhenItIsWholeAndNotBefore) {
  const auto failed = make_case(folder_, [&](Case& made) {
    EXPECT_FALSE(fs::exists(folder_));
    return made.add("volumes/anatomy", ".nrrd", {"import", {}, {}, {}, {}}, text_writer("voxels"))
        .and_then([]() -> Result<void> { return failure("test", "interrupted"); });
  });
  EXPECT_FALSE(failed);
  EXPECT_TRUE(fs::is_empty(temporary_.path()));

  // As a kill leaves it.
  ASSERT_TRUE(write_text_file(temporary_.path() / ".part-patient.glisson/patient.glisson/case.json", "half a re"));
  const auto made = make_case(folder_, [](Case& patient) {
    return patient.add("volumes/anatomy", ".nrrd", {"import", {}, {}, {}, {}}, text_writer("voxels"));
  });
  ASSERT_TRUE(made) << made.error().message();
  EXPECT_EQ(made->folder(), folder_);
  EXPECT_EQ(made->freshness("volumes/anatomy"), Freshness::current);
  EXPECT_EQ(std::distance(fs::directory_iterator(temporary_.path()), fs::directory_iterator()), 1);
  EXPECT_EQ(make_case(folder_, [](Case&) { return Result<void>(); }).error().code, "case-exists");
}

TEST_F(CaseTest, BytesThatAreNoTextAreKeptOutOfTheRecord) {
  auto made = Case::create(folder_);
  ASSERT_TRUE(made->add("volumes/anatomy", ".nrrd",
                        {"import",
                         {},
                         {},
                         {{"Stra\xDF"
                           "e.dcm",
                           "00"}},
                         {}},
                        text_writer("voxels")));
  EXPECT_TRUE(Case::open(folder_));
}

}  // namespace
}  // namespace glisson::casefile

// What every command keeps to: exit codes, one JSON document, one clear sentence, nothing left behind.

#include <gmock/gmock.h>
#include <fstream>

#include "base/files.h"
#include "support/folders.h"
#include "support/process.h"
#include "support/small_liver.h"

namespace glisson::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

TEST(Usage, HelpAndVersionAreNoErrors) {
  EXPECT_EQ(glisson_cli({"--help"}).exit_code, 0);
  const Finished version = glisson_cli({"--version"});
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_THAT(version.out, HasSubstr("glisson-cli " + glisson::version()));
}

TEST(Usage, WrongUsageExitsWithTwo) {
  EXPECT_EQ(glisson_cli({}).exit_code, 2);
  EXPECT_EQ(glisson_cli({"no-such-command"}).exit_code, 2);
  EXPECT_EQ(glisson_cli({"scan"}).exit_code, 2);
  EXPECT_EQ(glisson_cli({"segment", "x.glisson", "--structure", "gallbladder"}).exit_code, 2);
  EXPECT_EQ(glisson_cli({"segment", "x.glisson", "--structure", "../liver", "--seed", "0,0,0"}).exit_code, 2);
}

TEST(Usage, ARefusalIsOneSentenceAndAnErrorDocument) {
  const Finished refused = glisson_cli({"scan", "/no/such/folder", "--json", "--quiet"});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.err, HasSubstr("/no/such/folder"));
  const Json error = refused.json().at("error");
  for (const char* key : {"code", "message", "hint", "file"}) EXPECT_TRUE(error.contains(key)) << key;
  EXPECT_EQ(error.at("code"), "path-not-found");
}

TEST(Usage, AFailedImportLeavesNothingBehind) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "a.dcm") << "this is no image";
  const fs::path made = folder.path() / "patient.glisson";
  EXPECT_EQ(glisson_cli({"import", (folder.path() / "a.dcm").string(), "--case", made.string(), "--quiet"}).exit_code,
            1);
  EXPECT_FALSE(fs::exists(made));
}

TEST(Usage, AFailedImportLeavesAnExistingCaseUntouched) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_text_file(folder.path() / "patient.glisson" / "case.json", "precious"));
  const Finished refused =
      glisson_cli({"import", "/no/such/folder", "--case", (folder.path() / "patient.glisson").string(), "--quiet"});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_EQ(read_text_file(folder.path() / "patient.glisson" / "case.json").value(), "precious");
}

// Values of other types than they should be, and names that no file can have.
TEST(Usage, HostileJsonIsRefusedAndNoDefect) {
  const TemporaryFolder folder;
  const auto at = [&](const char* name) { return (folder.path() / name).string(); };
  ASSERT_TRUE(write_text_file(at("session.json"), R"({"format": 1, "commands": []})"));
  const Finished session = glisson_cli({"session", at("none.glisson"), "--commands", at("session.json"), "--quiet"});
  EXPECT_EQ(session.exit_code, 1) << session.err;
  EXPECT_THAT(session.err, HasSubstr("session"));
  ASSERT_TRUE(write_text_file(at("sequence.json"), R"({"frames": [{"cloud": ")" + std::string(300, 'n') +
                                                       R"("}], "landmarks": "tracks.csv", "model": "model.ply"})"));
  const Finished sequence =
      glisson_cli({"sirgn", at("sequence.json"), "--method", "icp", "--out", at("out"), "--quiet"});
  EXPECT_EQ(sequence.exit_code, 1) << sequence.err;
  EXPECT_THAT(sequence.err, HasSubstr("Frame 0 is missing"));
}

// A surface of lines and points has no nearest place to anything.
TEST(Usage, ASurfaceWithoutAnAreaIsRefusedAndNoDefect) {
  const TemporaryFolder folder;
  const std::string flat = (folder.path() / "flat.obj").string(), out = (folder.path() / "out.ply").string();
  ASSERT_TRUE(write_text_file(flat, "v 0 0 0\nv 1 1 1\nv 2 2 2\nv 3 3 3\nf 1 2 3\nf 2 3 4\nf 1 1 2\n"));
  for (const char* method : {"icp", "geo"}) {
    const Finished refused = glisson_cli({"register", flat, flat, "--method", method, "--out", out, "--quiet"});
    EXPECT_EQ(refused.exit_code, 1) << refused.err;
    EXPECT_THAT(refused.err, HasSubstr("area"));
  }
  EXPECT_FALSE(fs::exists(out));
}

// Discs from before Unicode: the bytes of a name are taken as they are, and told as well as JSON can.
TEST(Usage, NamesThatAreNotUtf8AreReadAndTold) {
  const TemporaryFolder folder;
  const fs::path disc = folder.path() / "M\xFCller";
  ASSERT_TRUE(write_small_liver(disc));
  const fs::path made = folder.path() / "J\xF6rg.glisson";
  const Finished imported =
      glisson_cli({"import", (disc / "scan.nrrd").string(), "--case", made.string(), "--json", "--quiet"});
  EXPECT_EQ(imported.exit_code, 0) << imported.err;
  EXPECT_TRUE(imported.json().contains("volumes"));
  const Finished segmented = glisson_cli({"segment", made.string(), "--structure", "liver", "--labels",
                                          (disc / "liver.nrrd").string(), "--json", "--quiet"});
  EXPECT_EQ(segmented.exit_code, 0) << segmented.err;
  EXPECT_TRUE(parse_json(*read_text_file(made / "case.json")));
  const Finished missing = glisson_cli({"scan", (disc / "none").string(), "--json", "--quiet"});
  EXPECT_EQ(missing.exit_code, 1);
  EXPECT_EQ(missing.json().at("error").at("code"), "path-not-found");
}

// The answer itself may meet a full disk.
TEST(Usage, AnAnswerThatCannotBeWrittenIsNoSuccess) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  const Finished finished =
      run("/bin/sh", {"-c", (build_folder() / "bin" / "glisson-cli").string() + " platform list --json > /dev/full"});
  EXPECT_EQ(finished.exit_code, 1);
  EXPECT_THAT(finished.err, HasSubstr("No space left"));
}

}  // namespace
}  // namespace glisson::test

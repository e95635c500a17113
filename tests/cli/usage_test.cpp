// What every command keeps to: exit codes, one JSON document, one clear sentence, nothing left behind.

#include <gmock/gmock.h>
#include <fstream>

#include "base/files.h"
#include "support/process.h"

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
  EXPECT_EQ(glisson_cli({"segment", "x.glisson", "--structure", "liver"}).exit_code, 2);
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

}  // namespace
}  // namespace glisson::test

// Raw elastography through glisson-cli: from the scanner's files to the stiffness that a case uses.

#include <gmock/gmock.h>
#include <filesystem>

#include "answer.h"
#include "base/files.h"
#include "support/data.h"
#include "support/process.h"

namespace glisson::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

// Measured by the Charite: a brain shaken at 20 Hz. At that frequency published brain stiffnesses lie near 1 kPa: |G*|
// 0.5 to 1.5 kPa, with a loss below the storage.
class MeasuredBrain : public testing::Test {
 protected:
  void SetUp() override {
    GLISSON_NEEDS_DATA("mre_brain_ir_charite");
    const std::string data = (shared_data() / "mre_brain_ir_charite" / "volunteer_A").string();
    std::vector<std::string> uids;
    const Json scan = answer({"scan", data});
    for (const Json& series : scan.at("series")) uids.push_back(series.at("uid"));
    const Json imported = answer({"import", data, "--case", case_, "--magnitude", uids.at(0), "--phase", uids.at(1)});
    EXPECT_EQ(imported.at("volumes").size(), 1u + 24 + 24);
  }

  TemporaryFolder folder_;
  std::string case_ = (folder_.path() / "brain.glisson").string();
};

TEST_F(MeasuredBrain, ComesOutAsStiffAsBrainsAreAndGoesIntoTheCase) {
  const Json direct = answer({"invert", case_});
  EXPECT_EQ(direct.at("method"), "direct");
  EXPECT_EQ(direct.at("frequency_Hz"), 20);  // from the headers
  EXPECT_GT(direct.at("mean_kPa").get<double>(), 0.4);
  EXPECT_LT(direct.at("mean_kPa").get<double>(), 2.0);
  EXPECT_GT(direct.at("confident_fraction").get<double>(), 0.1);
  EXPECT_GT(direct.at("loss_kPa").get<double>(), 0);
  EXPECT_LT(direct.at("loss_kPa").get<double>(), direct.at("storage_kPa").get<double>());

  for (const std::string scene : {"waves", "stiffness", "confidence"}) {
    const std::string picture = (folder_.path() / (scene + ".png")).string();
    answer({"render", case_, "--scene", scene, "--size", "400x300", "--out", picture});
    EXPECT_TRUE(fs::exists(picture));
  }

  const Json lfe = answer({"invert", case_, "--method", "lfe"});
  EXPECT_EQ(lfe.at("method"), "lfe");
  EXPECT_GT(lfe.at("mean_kPa").get<double>(), 0.4);
  EXPECT_LT(lfe.at("mean_kPa").get<double>(), 3.0);
  EXPECT_FALSE(fs::exists(fs::path(case_) / "volumes" / "loss.nrrd"));  // which this method does not know
}

// A wrong one brings the slices, which were acquired one after the other, to the wrong instants: the waves then do not
// go on from slice to slice, and the confidence says so.
TEST_F(MeasuredBrain, TheFrequencyCanBeGivenAgainstTheHeaders) {
  const Json header = answer({"invert", case_});
  const Json asked = answer({"invert", case_, "--frequency-Hz", "40"});
  EXPECT_EQ(asked.at("frequency_Hz"), 40);
  EXPECT_LT(asked.at("confident_fraction").get<double>(), 0.1 * header.at("confident_fraction").get<double>());
}

TEST(Invert, ACaseWithoutWavesSaysWhatIsMissing) {
  GLISSON_NEEDS_DATA("totalseg_abdomen_mr_ct");
  const TemporaryFolder folder;
  const std::string patient = (folder.path() / "p.glisson").string();
  answer({"import", (shared_data() / "totalseg_abdomen_mr_ct" / "example_mr_sm.nii.gz").string(), "--case", patient});
  const Finished refused = glisson_cli({"invert", patient, "--quiet"});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.err, HasSubstr("--phase"));
}

}  // namespace
}  // namespace glisson::test

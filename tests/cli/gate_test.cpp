// glisson-cli gate, as a CI calls it.

#include <gmock/gmock.h>
#include <algorithm>

#include "base/files.h"
#include "support/folders.h"
#include "support/process.h"
#include "vision/frame.h"

namespace glisson::test {
namespace {

namespace fs = std::filesystem;

TEST(GateCommand, EndsWithExitCodeOneAPageAndJunitWhereSomethingGotWorse) {
  const TemporaryFolder room;
  const auto at = [&](const char* name) { return room.path() / name; };
  const auto write = [&](const char* name, const std::string& text) {
    EXPECT_TRUE(write_text_file(at(name) / "metrics.csv", text));
  };
  write("base", "case,tre_mm,dice\na,1,0.9\nb,2,0.9\n");
  write("now", "case,tre_mm,dice\na,1,0.9\nb,3,0.95\n");
  vision::Frame picture = vision::read_frame(source_folder() / "tests" / "baselines" / "organ.png").value();
  EXPECT_TRUE(vision::write_frame(picture, at("base") / "pictures" / "a" / "organ.png"));
  for (int y = picture.height / 2 - 12; y < picture.height / 2 + 12; ++y)
    std::fill_n(picture.at(picture.width / 2 - 12, y), 3 * 24, std::uint8_t{255});
  EXPECT_TRUE(vision::write_frame(picture, at("now") / "pictures" / "a" / "organ.png"));

  const auto judged =
      glisson_cli({"gate", at("base").string(), at("now").string(), "--out", at("out").string(), "--json", "--quiet"});
  EXPECT_EQ(judged.exit_code, 1) << judged.err;
  EXPECT_EQ(judged.err, "");
  const Json answer = judged.json();
  EXPECT_EQ(answer.at("verdict"), "worse");
  EXPECT_EQ(answer.at("worst").at(0).at("case"), "b");
  EXPECT_EQ(answer.at("pictures").at(0).at("verdict"), "worse");
  const std::string junit = read_text_file(at("out") / "junit.xml").value_or("");
  EXPECT_THAT(junit, testing::HasSubstr("tests=\"3\" failures=\"2\""));
  EXPECT_THAT(junit, testing::HasSubstr("<testcase classname=\"metric\" name=\"dice\"/>"));
  EXPECT_TRUE(fs::exists(at("out") / "gate.html"));
  const auto beside = vision::read_frame(at("out") / "pictures" / "worst-1.png");
  ASSERT_TRUE(beside);
  EXPECT_EQ(beside->width, 3 * picture.width);

  const auto same =
      glisson_cli({"gate", at("base").string(), at("base").string(), "--out", at("out2").string(), "--quiet"});
  EXPECT_EQ(same.exit_code, 0) << same.out << same.err;
  EXPECT_TRUE(write_text_file(at("loose.json"), R"({"metrics": {"tre_mm": {"percent": 60}}, "similarity": 0.1})"));
  const auto loose = glisson_cli({"gate", at("base").string(), at("now").string(), "--tolerances",
                                  at("loose.json").string(), "--out", at("out3").string(), "--quiet"});
  EXPECT_EQ(loose.exit_code, 0) << loose.out << loose.err;
  EXPECT_TRUE(write_text_file(at("wrong.json"), R"({"metrics": {"tre_mm": {"better": "smaller"}}})"));
  const auto wrong = glisson_cli({"gate", at("base").string(), at("now").string(), "--tolerances",
                                  at("wrong.json").string(), "--out", at("out4").string(), "--quiet"});
  EXPECT_EQ(wrong.exit_code, 1);
  EXPECT_THAT(wrong.err, testing::HasSubstr("metrics, tre_mm, better must be one of"));
  EXPECT_FALSE(fs::exists(at("out4")));
}

}  // namespace
}  // namespace glisson::test

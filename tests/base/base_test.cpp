// The foundations: errors that read well, files written whole or not at all, JSON that refuses politely.

#include <gmock/gmock.h>
#include <atomic>
#include <cmath>
#include <fstream>
#include <limits>

#include "base/error_file.h"
#include "base/files.h"
#include "base/json.h"
#include "base/json_forward.h"
#include "base/parallel.h"
#include "base/progress.h"
#include "base/units.h"

namespace glisson {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

TEST(Error, FillsArgumentsIntoItsSentence) {
  const Error error{"x", "The slice {0} of {1} is missing; {2} stays.", {"7", "series A"}, "See {1}.", {}};
  EXPECT_EQ(error.message(), "The slice 7 of series A is missing; {2} stays.");
  EXPECT_EQ(error.advice(), "See series A.");
}

TEST(Error, NamesItsFileWhereItsSentenceDoesNot) {
  const Error error{"x", "", {}, {}, "/cases/one.glisson/case.json"};
  EXPECT_EQ(file_behind("It is no case.", error), " (/cases/one.glisson/case.json)");
  EXPECT_EQ(file_behind("The file case.json is no case.", error), "");
  EXPECT_EQ(file_behind("It did not converge.", Error{}), "");
}

TEST(Files, AFailedWriteLeavesTheOldFileAndNothingElse) {
  const TemporaryFolder folder;
  const fs::path target = folder.path() / "case.json";
  ASSERT_TRUE(write_text_file(target, "old"));
  const auto written = write_atomically(target, [](const fs::path& beside) -> Result<void> {
    std::ofstream(beside) << "half";
    return failure("test", "interrupted");
  });
  EXPECT_FALSE(written);
  EXPECT_EQ(read_text_file(target).value(), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1);
}

TEST(Files, Sha256MatchesThePublishedVector) {
  // FIPS 180-2, appendix B.1: the digest of "abc".
  EXPECT_EQ(sha256_of_text("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(Files, ReadingStopsAtTheLimitBeforeMemoryIsTaken) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_text_file(folder.path() / "big.txt", std::string(100, 'x')));
  EXPECT_EQ(read_text_file(folder.path() / "big.txt", 99).error().code, "file-too-large");
}

TEST(Json, NamesTheLineOfAMistake) {
  const auto parsed = parse_json("{\n \"a\": 1,\n \"b\" 2\n}", "scenario.json");
  ASSERT_FALSE(parsed);
  EXPECT_THAT(parsed.error().message(), HasSubstr("line 3"));
}

TEST(Json, RefusesANumberThatOverflows) { EXPECT_EQ(parse_json("{\"a\": 1e999}").error().code, "json-invalid"); }

TEST(Json, SuggestsTheKeyThatWasMeant) {
  const auto checked = refuse_unknown_keys(Json{{"poison_ratio", 0.4}}, {"poisson_ratio", "engine"}, "scenario.json");
  ASSERT_FALSE(checked);
  EXPECT_THAT(checked.error().advice(), HasSubstr("poisson_ratio"));
}

TEST(Json, ADocumentIsAsItsTextReads) {
  const double beyond = std::numeric_limits<double>::infinity();
  const Json document{{"a", 1.5}, {"b", {1, std::nan("")}}, {"c", {{"d", beyond}}}};
  EXPECT_EQ(null_where_not_finite(document), parse_json(document.dump()).value());
}

TEST(Json, RefusesNestingThatWouldExhaustTheStack) {
  EXPECT_EQ(parse_json(std::string(100000, '[')).error().code, "json-too-deep");
}

TEST(Parallel, CoversEveryIndexOnce) {
  std::vector<std::atomic<int>> seen(10007);
  parallel_for(seen.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) ++seen[i];
  });
  EXPECT_TRUE(std::all_of(seen.begin(), seen.end(), [](const auto& count) { return count == 1; }));
}

TEST(Progress, PartsMapOntoTheWhole) {
  double last = -1;
  const Progress progress([&](double fraction, std::string_view) { last = fraction; });
  progress.part(0.5, 1.0).part(0.0, 0.5).report(1.0, "half of the second half");
  EXPECT_DOUBLE_EQ(last, 0.75);
}

TEST(Units, AgreeWithOneAnother) {
  // 1 kg under standard gravity weighs 9.81 N; a column of water 1 m high presses 9.81 kPa.
  EXPECT_DOUBLE_EQ(units::N_from_mN(1.0 * units::standard_gravity_mm_s2), 9.81);
  EXPECT_NEAR(units::kg_mm3_from_kg_m3(1000) * units::standard_gravity_mm_s2 * 1000, 9.81, 1e-12);
  EXPECT_DOUBLE_EQ(units::shear_from_youngs(units::youngs_from_shear(2.1, 0.45), 0.45), 2.1);
}

}  // namespace
}  // namespace glisson

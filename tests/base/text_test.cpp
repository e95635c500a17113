#include "base/text.h"

#include <gmock/gmock.h>
#include <cstdint>

namespace glisson {
namespace {

using testing::Eq;
using testing::Optional;

TEST(Text, OneFiniteNumberAndNothingElseIsANumber) {
  EXPECT_THAT(read_number("-2.5e-3"), Optional(-2.5e-3));
  for (const char* not_one : {"", "+1", " 1", "1 ", "1,5", "1.5mm", "nan", "inf", "1e999", "0x10"})
    EXPECT_THAT(read_number(not_one), Eq(std::nullopt)) << not_one;
}

TEST(Text, ANumberMayLeadATextThatGoesOn) {
  EXPECT_THAT(read_leading_number("60 Hz"), Optional(60.0));
  for (const char* without : {"", "Hz 60", " 60", "nan", "inf Hz"})
    EXPECT_THAT(read_leading_number(without), Eq(std::nullopt)) << without;
}

TEST(Text, AWholeNumberFitsItsType) {
  EXPECT_THAT(read_whole_number<int>("-7"), Optional(-7));
  EXPECT_THAT(read_whole_number<std::uint64_t>("18446744073709551615"), Optional(UINT64_MAX));
  EXPECT_THAT(read_whole_number<int>("2147483648"), Eq(std::nullopt));
  EXPECT_THAT(read_whole_number<std::uint64_t>("-1"), Eq(std::nullopt));
  for (const char* not_one : {"", "1.0", "1e3", "7x", " 7"})
    EXPECT_THAT(read_whole_number<std::int64_t>(not_one), Eq(std::nullopt)) << not_one;
}

TEST(Text, LowerCaseLeavesWhatIsNoLetterOfAscii) {
  EXPECT_EQ(in_lower_case("MRE-\xC3\x84_1.NII"), "mre-\xC3\x84_1.nii");
}

}  // namespace
}  // namespace glisson

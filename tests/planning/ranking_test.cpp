// Which plan comes first, and which another one beats.

#include "planning/ranking.h"

#include <gmock/gmock.h>

namespace glisson::planning {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

PlanAnswer answer(double margin_mm, double living_ml, double beyond_ml, Side tumour = Side::removed) {
  PlanAnswer made;
  made.margin_mm = margin_mm;
  made.living_ml = living_ml;
  made.branches = {{0, {0, 0, 0}, 2, beyond_ml / 2, 0}, {1, {0, 0, 0}, 2, beyond_ml / 2, 0}};
  made.tumours = {{"tumour-1", tumour, margin_mm, false}};
  return made;
}

TEST(Ranking, PutsFirstWhatTheSurgeonChose) {
  const std::vector<PlanAnswer> plans = {answer(4, 900, 300), answer(12, 600, 500), answer(8, 800, 200),
                                         answer(30, 1400, 0, Side::left)};
  EXPECT_THAT(ranked(plans, RankBy::margin), ElementsAre(1, 2, 0, 3));
  EXPECT_THAT(ranked(plans, RankBy::living), ElementsAre(0, 2, 1, 3));
  EXPECT_THAT(ranked(plans, RankBy::branches), ElementsAre(2, 0, 1, 3));
  EXPECT_FALSE(rank_by("beauty"));
  EXPECT_EQ(rank_by("living"), RankBy::living);
}

TEST(Ranking, APlanIsBeatenByWhatIsNoWorseInAnythingAndBetterInOne) {
  const std::vector<PlanAnswer> plans = {answer(8, 800, 0), answer(8.3, 700, 0), answer(12, 600, 0),
                                         answer(8, 800.4, 0), answer(9, 900, 0, Side::cut_through)};
  const auto better = beaten_by(plans);
  EXPECT_THAT(better[0], IsEmpty()) << "0.4 ml more are no more";
  EXPECT_THAT(better[1], ElementsAre(0, 3)) << "0.3 mm more are no more";
  EXPECT_THAT(better[2], IsEmpty()) << "a wider margin against more tissue: the surgeon's to weigh";
  EXPECT_THAT(better[3], IsEmpty());
  EXPECT_THAT(better[4], IsEmpty()) << "more tissue, though a tumour is cut through";
  EXPECT_TRUE(beaten_by({}).empty());
}

}  // namespace
}  // namespace glisson::planning

// Segments of real livers beside those that somebody drew. The halves are parted in real_livers.h, by a rule.
//
// What docs/territories.md says of real livers is printed with GLISSON_JUDGE=judging (or tuning).

#include "real_livers.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <iostream>

#include "support/data.h"
#include "vasculature/center_lines.h"

namespace glisson::test {
namespace {

TEST(RealLivers, ThreeOfTheTuningHalfAreToldByTheirShape) {
  GLISSON_NEEDS_DATA("livers_couinaud");
  std::vector<double> dice;
  const std::vector<std::string> names = real_livers(Kind::with_vessels, Half::tuning);
  ASSERT_GE(names.size(), 3u);
  for (std::size_t n = 0; n < 3; ++n) {
    const RealLiver liver = read_real_liver(names[n]);
    const auto found = vasculature::couinaud_segments(liver.liver);
    ASSERT_TRUE(found) << names[n] << ": " << found.error().message();
    const SegmentScore score = score_of(found->segment, liver.segments);
    dice.insert(dice.end(), score.dice.begin() + 1, score.dice.end());
  }
  EXPECT_GT(median(dice), 0.7);
}

TEST(RealLivers, VesselsOfOneClassBecomeTwoTrees) {
  GLISSON_NEEDS_DATA("livers_couinaud");
  const RealLiver liver = read_real_liver(real_livers(Kind::with_vessels, Half::tuning).front());
  const auto graph = vasculature::center_lines(liver.vessels);
  ASSERT_TRUE(graph) << graph.error().message();
  const auto found = vasculature::explain_vessels(*graph, liver.liver);
  ASSERT_TRUE(found) << found.error().message();
  std::array<double, 2> length{};
  for (const auto& branch : found->trees.branches) {
    length.at(static_cast<std::size_t>(branch.system)) += branch.length_mm;
    EXPECT_FALSE(branch.name.empty());
  }
  EXPECT_GT(length[0], 500);
  EXPECT_GT(length[1], 500);
  EXPECT_EQ(found->segments.from, vasculature::SegmentsFrom::trees);
}

// One place on each of the four longest borders that are drawn.
vasculature::BorderPlaces four_by_hand(const RealLiver& liver) {
  vasculature::BorderPlaces places = middles_of_borders(liver.segments);
  places.resize(std::min<std::size_t>(places.size(), 4));
  return places;
}

struct Scores {
  std::vector<double> dice, volume_errors;
  void add(const imaging::LabelMap& found, const RealLiver& liver) {
    const SegmentScore score = score_of(found, liver.segments);
    dice.insert(dice.end(), score.dice.begin() + 1, score.dice.end());
    volume_errors.insert(volume_errors.end(), score.volume_error.begin() + 1, score.volume_error.end());
  }
  void print(const std::string& what) const {
    fmt::print("{}: livers {}, median Dice {:.3f}, volume error {:.1f} %, by segment", what, dice.size() / 8,
               median(dice), 100 * median(volume_errors));
    for (std::size_t s = 0; s < 8; ++s) {
      std::vector<double> of_segment;
      for (std::size_t i = s; i < dice.size(); i += 8) of_segment.push_back(dice[i]);
      fmt::print(" {:.2f}", median(of_segment));
    }
    fmt::print("\n");
    std::fflush(stdout);
  }
};

TEST(RealLivers, Judged) {
  const char* which = std::getenv("GLISSON_JUDGE");
  if (which == nullptr) GTEST_SKIP() << "set GLISSON_JUDGE=judging (or tuning): takes minutes";
  GLISSON_NEEDS_DATA("livers_couinaud");
  const Half half = std::string(which) == "tuning" ? Half::tuning : Half::judging;
  Scores shape_alone, shape_by_hand, shape, trees, clicked, by_hand, another;
  for (const std::string& name : real_livers(Kind::without_vessels, half)) {
    const RealLiver liver = read_real_liver(name);
    shape_alone.add(vasculature::couinaud_segments(liver.liver).value().segment, liver);
    const vasculature::BorderPlaces set = four_by_hand(liver);
    shape_by_hand.add(vasculature::couinaud_segments(liver.liver, nullptr, set).value().segment, liver);
  }
  shape_by_hand.print("four places by hand, livers without vessels");
  shape_alone.print("shape, livers without vessels");
  double slowest_s = 0;
  for (const std::string& name : real_livers(Kind::with_vessels, half)) {
    const RealLiver liver = read_real_liver(name);
    if (!liver.segments_by_another.values.empty()) another.add(liver.segments_by_another, liver);
    shape.add(vasculature::couinaud_segments(liver.liver).value().segment, liver);
    const auto start = std::chrono::steady_clock::now();
    const auto graph = vasculature::center_lines(liver.vessels).value();
    trees.add(vasculature::explain_vessels(graph, liver.liver).value().segments.segment, liver);
    slowest_s = std::max(slowest_s, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    by_hand.add(vasculature::explain_vessels(graph, liver.liver, {{}, four_by_hand(liver)}).value().segments.segment,
                liver);
    clicked.add(explained_with_clicks(liver, graph, 2).segments.segment, liver);
  }
  shape.print("shape, livers with vessels");
  trees.print("vessels, no click");
  clicked.print("vessels, two clicks");
  by_hand.print("vessels, four places by hand");
  another.print("another labelling");
  fmt::print("slowest liver from mask to segments: {:.1f} s\n", slowest_s);
  EXPECT_GT(median(shape_alone.dice), 0.5);
}

}  // namespace
}  // namespace glisson::test

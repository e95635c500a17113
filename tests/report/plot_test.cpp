// Plots draw what they are given, inside their frame, and nothing that is no number.

#include "report/plot.h"

#include <gmock/gmock.h>
#include <cmath>
#include <limits>
#include <regex>

namespace glisson::report {
namespace {

using testing::HasSubstr;
using testing::Not;

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
  return found;
}

TEST(Plot, DrawsEachBarPointBoxAndRuleInsideItsFrame) {
  Plot plot;
  plot.caption = "a <b> & c";
  plot.histogram = Histogram{{0, 1, 2, 3}, {5, 2, 7}};
  plot.curves = {{"dots", {{0.5, 1}, {2.5, 6}}, PlotCurve::Style::dots},
                 {"line", {{0, 0}, {3, 7}}, PlotCurve::Style::line}};
  plot.rules = {{Rule::Along::y, 4, "four"}};
  const std::string svg = svg_of(plot);
  EXPECT_EQ(count(svg, "<circle"), 2u);
  EXPECT_EQ(count(svg, "<path"), 1u);
  EXPECT_EQ(count(svg, "<rect"), 3u + 2u);  // bars, and a patch in the legend for each curve
  EXPECT_THAT(svg, HasSubstr("a &lt;b&gt; &amp; c"));
  EXPECT_THAT(svg, HasSubstr(">four<"));
  const std::regex centre("c([xy])=\"([-0-9.]+)\"");
  for (std::sregex_iterator match(svg.begin(), svg.end(), centre), end; match != end; ++match) {
    const double px = std::stod((*match)[2]);
    EXPECT_GE(px, 0);
    EXPECT_LE(px, (*match)[1] == "x" ? 640 : 400);
  }
}

TEST(Plot, BandsLieBehindBarsAndAreNamed) {
  Plot plot;
  plot.histogram = Histogram{{0, 1, 2}, {5, 2}};
  plot.bands = {{0.5, 4, "95 % of <them>"}};
  const std::string svg = svg_of(plot);
  EXPECT_EQ(count(svg, "<rect"), 1u + 2u + 1u);
  EXPECT_LT(svg.find("fill-opacity=\"0.2\""), svg.find("fill-opacity=\"0.55\""));
  EXPECT_THAT(svg, HasSubstr(">95 % of &lt;them&gt;<"));
  const std::regex band("x=\"([0-9.]+)\"[^/]* width=\"([0-9.]+)\"[^/]*fill-opacity=\"0.2\"");
  std::smatch found;
  ASSERT_TRUE(std::regex_search(svg, found, band));
  EXPECT_GT(std::stod(found[1]), 70);
  EXPECT_LE(std::stod(found[1]) + std::stod(found[2]), 620.1);  // the axis reaches over it
}

TEST(Plot, CurvesWithoutExtentAreFramesWithoutNonsense) {
  for (const auto& points : {std::vector<std::pair<double, double>>{{1, 0}}, {{0, 0}, {0, 0}}}) {
    Plot plot{"", "time (s)", "a & b"};
    plot.curves = {{"", points, PlotCurve::Style::dashes}};
    plot.from_zero = false;
    const std::string svg = svg_of(plot);
    EXPECT_THAT(svg, HasSubstr("a &amp; b"));
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
    EXPECT_THAT(svg, Not(HasSubstr("inf")));
  }
}

TEST(Plot, ArrowsKeepTheirProportionsAndTheHottestIsRed) {
  Plot plot{"", "x (mm)", "z (mm)"};
  plot.arrows = {{0, 0, 10, 0, 1}, {0, 50, 0, 10, 0}};
  plot.hottest = 1;
  const std::string svg = svg_of(plot);
  EXPECT_THAT(svg, HasSubstr("#c02d26"));
  EXPECT_THAT(svg, HasSubstr("#3168b0"));
  const std::regex line("x1=\"([-0-9.]+)\" y1=\"([-0-9.]+)\" x2=\"([-0-9.]+)\" y2=\"([-0-9.]+)\" stroke=\"#");
  std::vector<double> lengths;
  for (std::sregex_iterator match(svg.begin(), svg.end(), line), end; match != end; ++match)
    lengths.push_back(
        std::hypot(std::stod((*match)[3]) - std::stod((*match)[1]), std::stod((*match)[4]) - std::stod((*match)[2])));
  ASSERT_EQ(lengths.size(), 2u);
  EXPECT_NEAR(lengths[0], lengths[1], 0.2);
}

TEST(Plot, BoxesStandInTheirOrder) {
  Plot plot;
  plot.boxes = {{"soft", 1, 2, 3, 4, 5}, {"stiff", 2, 4, 6, 8, 10}};
  const std::string svg = svg_of(plot);
  EXPECT_LT(svg.find(">soft<"), svg.find(">stiff<"));
  EXPECT_EQ(count(svg, "<rect"), 2u);
}

TEST(Plot, LeavesOutWhatIsNoNumberAndBearsNothingAtAll) {
  Plot plot;
  EXPECT_THAT(svg_of(plot), Not(HasSubstr("nan")));
  plot.curves = {{"", {{1, std::numeric_limits<double>::quiet_NaN()}, {2, 3}}, PlotCurve::Style::dots}};
  const std::string svg = svg_of(plot);
  EXPECT_EQ(count(svg, "<circle"), 1u);
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

}  // namespace
}  // namespace glisson::report

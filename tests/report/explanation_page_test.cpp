// The report of a closed loop shows what was found, and drawings that hold whatever was measured.

#include "report/explanation_page.h"

#include <gmock/gmock.h>

#include "base/files.h"
#include "report/drawing.h"
#include "report/html.h"

namespace glisson::report {
namespace {

using testing::HasSubstr;
using testing::Not;

closedloop::Observations two_markers() {
  closedloop::Observations all;
  all.unit = "mm";
  all.directions = {"x", "y", "z"};
  all.trials = {"p<01>"};
  all.measured.resize(6);
  all.measured << 1, 0, 0, 0, 2, 0;
  all.noise = Eigen::VectorXd::Constant(6, 0.1);
  all.trial.assign(6, 0);
  all.sample.assign(6, 0);
  all.direction = {0, 1, 2, 0, 1, 2};
  all.point = {0, 0, 0, 1, 1, 1};
  all.time_s = all.load = Eigen::VectorXd::Ones(6);
  all.place_mm = Eigen::MatrixXd::Zero(6, 3);
  all.place_mm.bottomRows(3).col(0).setConstant(30);
  all.place_mm.bottomRows(3).col(1).setConstant(20);
  all.conditions.resize(6, 0);
  return all;
}

TEST(ExplanationPage, SaysTheVerdictTheSuspectsAndWhatToMeasureNext) {
  const TemporaryFolder folder;
  closedloop::Explanation e;
  e.verdict = closedloop::Verdict::explained;
  e.predicted_before = Eigen::VectorXd::Zero(6);
  e.predicted_after = two_markers().measured;
  e.effects.push_back({"support-compliance", "", "The bed gives way.", {}, -800, 0.1, 1.0, 0.9, {"preload"}});
  e.ranking.push_back({"capsule", "", {}, 1, {}, -3, {}, "the solve failed"});
  e.next = closedloop::NextMeasurement{"Press at the rim.", {"preload"}, 12};
  const Page page = explanation_page(e, two_markers(), "A <pad>");
  ASSERT_TRUE(write_html(folder.path() / "r.html", page));
  const std::string html = read_text_file(folder.path() / "r.html").value();
  for (const char* expected : {"Explained", "The bed gives way.", "preload", "the solve failed", "Press at the rim.",
                               "<svg", "A &lt;pad&gt;", "p&lt;01&gt;"})
    EXPECT_THAT(html, HasSubstr(expected));
  EXPECT_THAT(html, Not(HasSubstr("nan")));
}

TEST(Drawing, CurvesWithoutExtentAndNoneAtAllAreFramesWithoutNonsense) {
  for (const auto& curves : {std::vector<Curve>{}, std::vector<Curve>{{{{1, 0}}, Ink::measured}},
                             std::vector<Curve>{{{{0, 0}, {0, 0}}, Ink::after}}}) {
    const std::string svg = curves_svg(curves, "time (s)", "a & b");
    EXPECT_THAT(svg, HasSubstr("a &amp; b"));
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
    EXPECT_THAT(svg, Not(HasSubstr("inf")));
  }
}

TEST(Drawing, ArrowsKeepTheirProportionsAndTheHottestIsRed) {
  const std::string svg = arrows_svg({{0, 0, 10, 0, 1}, {0, 50, 0, 10, 0}}, 1, "x (mm)", "z (mm)");
  EXPECT_THAT(svg, HasSubstr("#c02d26"));
  EXPECT_THAT(svg, HasSubstr("#3168b0"));
}

}  // namespace
}  // namespace glisson::report

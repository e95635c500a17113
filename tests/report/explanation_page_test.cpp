// The report of a closed loop shows what was found, and drawings that hold whatever was measured.

#include "report/internal/explanation_page.h"

#include <gmock/gmock.h>

#include "base/files.h"
#include "report/html.h"

namespace glisson::report {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

closedloop::Observations two_markers() {
  closedloop::Observations all;
  all.unit = "mm";
  all.directions = {"x", "y", "z"};
  all.trials = {"p<01>"};
  const Eigen::Vector3d moved_mm[] = {{1, 0, 0}, {0, 2, 0}}, at_mm[] = {{0, 0, 0}, {30, 20, 0}};
  std::vector<closedloop::Observation> rows;
  for (int marker = 0; marker < 2; ++marker)
    for (int d = 0; d < 3; ++d) rows.push_back({moved_mm[marker][d], 0.1, 0, 0, d, marker, 1, 1, at_mm[marker], {}});
  all.add(rows);
  return all;
}

closedloop::Explanation a_bed_that_gives_way() {
  closedloop::Explanation e;
  e.verdict = closedloop::Verdict::explained;
  e.predicted_before = Eigen::VectorXd::Zero(6);
  e.predicted_after = two_markers().measured;
  e.effects.push_back({"support-compliance", "", "The bed gives way.", {}, -800, 0.1, 1.0, 0.9, {"preload"}});
  e.ranking.push_back({"capsule", "", {}, 1, {}, -3, {}, "the solve failed"});
  e.settings = {{"support-compliance", {}, {}}};
  e.posterior = {{{"support-compliance"}, false, 0.72}, {{}, true, 0.28}};
  return e;
}

TEST(ExplanationPage, SaysTheVerdictTheCandidatesAndWhatToMeasureNext) {
  const TemporaryFolder folder;
  closedloop::Explanation e = a_bed_that_gives_way();
  e.next.to_make = {{{"Press at the rim.", {}}, {}, {"preload"}, 0.8}};
  e.smallest_visible = {{"capsule", "", "stiffness_N_per_mm", 0, 0, 0.125},
                        {"preload", "gravity", "gravity_m_s2", 2, 0, {}}};
  const Page page = explanation_page(e, two_markers(), "A <pad>");
  ASSERT_TRUE(write_html(folder.path() / "r.html", page));
  const std::string html = read_text_file(folder.path() / "r.html").value();
  for (const char* expected : {"Explained", "The bed gives way.", "preload", "the solve failed", "Press at the rim.",
                               "<svg", "Probability of support-compliance: 72 %", "72.0 %", "something else", "0.125",
                               "gravity_m_s2 2", "at no size in its range", "A &lt;pad&gt;", "p&lt;01&gt;"})
    EXPECT_THAT(html, HasSubstr(expected));
  EXPECT_THAT(html, Not(HasSubstr("nan")));
}

TEST(ExplanationPage, DrawsHowProbabilitiesWentFromTwoAnswersOn) {
  const closedloop::Explanation e = a_bed_that_gives_way();
  const auto drawn = [&](const closedloop::PosteriorHistory& history) {
    const TemporaryFolder folder;
    EXPECT_TRUE(write_html(folder.path() / "r.html", explanation_page(e, two_markers(), "A pad", {}, history)));
    return read_text_file(folder.path() / "r.html").value();
  };
  const closedloop::PosteriorStep before{{"p1"}, {{{"capsule"}, false, 0.6}, {{}, true, 0.4}}};
  const closedloop::PosteriorStep now{{"p1", "p2"}, e.posterior};
  EXPECT_THAT(drawn({now}), Not(HasSubstr("How the probabilities went")));
  EXPECT_THAT(drawn({before, now}), AllOf(HasSubstr("How the probabilities went"), HasSubstr("capsule")));
}

// With words of another language no English stands on the page: a reader that turns every sentence round finds none as
// it was, and every name is asked for.
TEST(ExplanationPage, SpeaksTheWordsThatItIsGiven) {
  const closedloop::Explanation e = a_bed_that_gives_way();
  Words words;
  words.language = "xx";
  words.sentence = [](const Sentence& said) {
    std::string text = "[";
    for (const std::string& argument : said.arguments) text += argument + "|";
    return text + "]";
  };
  words.effect = [](const std::string& kind) { return "#" + kind.substr(0, 3); };
  const Page page = explanation_page(e, two_markers(), "A pad", words);
  EXPECT_EQ(page.language, "xx");
  const TemporaryFolder folder;
  ASSERT_TRUE(write_html(folder.path() / "r.html", page));
  std::string html = read_text_file(folder.path() / "r.html").value();
  html.erase(html.find("<style>"), html.find("</style>") - html.find("<style>"));
  for (const char* english : {"Explained", "gives way", "support-compliance", "preload", "capsule", "something else",
                              "Error", "force", "before", "noise", "Probability", "Glisson"})
    EXPECT_THAT(html, Not(HasSubstr(english)));
  EXPECT_THAT(html, HasSubstr("#sup"));
  EXPECT_THAT(html, HasSubstr("&quot;#pre&quot;"));
}

}  // namespace
}  // namespace glisson::report

// What was done to a case can be done again without the window, from its own history, and nothing that a case says can
// become another command.

#include "casefile/macro.h"

#include <gmock/gmock.h>
#include <fstream>
#include <map>

#include "base/files.h"
#include "base/json.h"
#include "casefile/contents.h"
#include "casefile/history.h"
#include "casefile/placed_landmarks.h"
#include "casefile/redo_step.h"
#include "casefile/structures.h"
#include "rehearsal/session.h"
#include "segmentation/edit.h"

namespace glisson::casefile {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

imaging::Mask ball_of_macro(double radius_mm) {
  imaging::Mask mask;
  mask.grid.size = {40, 32, 20};
  mask.grid.spacing_mm = {1.5, 1.5, 3.1};
  mask.values.assign(mask.grid.voxels(), 0);
  return segmentation::paint(std::move(mask), {{30, 24, 30}, radius_mm});
}

Result<void> add(const fs::path& folder, const std::string& id, const Provenance& made, const std::string& text) {
  auto opened = Case::open(folder);
  return opened->add(id, ".json", made, [&](const fs::path& file) -> Result<void> {
    std::ofstream(file) << text;
    return {};
  });
}

using test::contents;

class MacroTest : public testing::Test {
 protected:
  MacroTest() { (void)Case::create(folder_).value(); }
  void step(const std::string& name, const std::function<Result<void>(Case&)>& change) {
    const auto done = history()->record(
        {name, {}}, [&] { return Case::open(folder_).and_then([&](Case patient) { return change(patient); }); });
    ASSERT_TRUE(done) << done.error().message();
  }
  void draw(const std::string& name, double radius_mm) {
    step("Brush on " + name, [&](Case& patient) {
      return save_structure(patient, segmentation::make_structure(name, ball_of_macro(radius_mm)),
                            {"segment", {{"method", "drawn"}}, {}, {}, {}})
          .map([](const auto&) {});
    });
  }
  // An entry of that stage, as if it had been computed.
  void compute(const std::string& id, const std::string& by, const std::map<std::string, std::string>& options) {
    step(by, [&](Case&) { return add(folder_, id, {by, options, {}, {}, {}}, id); });
  }
  std::vector<std::string> words() {
    const auto macro = macro_of(folder_);
    EXPECT_TRUE(macro) << macro.error().message();
    std::vector<std::string> lines;
    for (const MacroStep& step : macro->steps) {
      for (const Command& command : step.commands) {
        std::string line;
        for (const std::string& word : command.words) line += (line.empty() ? "" : " ") + word;
        lines.push_back(line);
      }
    }
    return lines;
  }
  History* history() {
    if (!history_) history_ = History::open(folder_).value();
    return history_.get();
  }
  void copy_now() { fs::copy(folder_, copy_, fs::copy_options::recursive); }

  TemporaryFolder temporary_;
  fs::path folder_ = temporary_.path() / "patient.glisson", copy_ = temporary_.path() / "copy.glisson";
  std::unique_ptr<History> history_;
};

TEST_F(MacroTest, WhatAHandDidComesOutTheSameOnACopyStepByStep) {
  draw("liver", 12);
  copy_now();
  std::vector<std::map<std::string, std::string>> states;
  const auto then = [&] { states.push_back(contents(folder_)); };
  draw("liver", 14), then();
  draw("liver", 11), then();
  draw("tumour-1", 5), then();
  step("Rename", [&](Case& patient) {
    return save_structure(patient, segmentation::make_structure("cyst-1", ball_of_macro(5)),
                          {"segment", {}, {}, {}, {}})
        .and_then([&](const auto&) { return patient.remove("labels/tumour-1"); });
  });
  then();
  step("Landmarks", [&](Case& patient) { return keep_landmarks(patient, {{"hilum", {1.25, 2, 3}}}); }), then();
  step("Other landmarks", [&](Case& patient) { return keep_landmarks(patient, {{"hilum", {1, 2, 4}}}); }), then();
  step("No landmarks", [&](Case& patient) { return keep_landmarks(patient, {}); }), then();
  auto other = Case::open(copy_);
  for (std::size_t n = 0; n < states.size(); ++n) {
    const auto done = redo_step(*other, folder_, static_cast<int>(n) + 2);
    ASSERT_TRUE(done) << done.error().message();
    EXPECT_EQ(contents(copy_), states[n]) << n;
    EXPECT_EQ(Case::open(copy_)->entries().size(), states[n].size());
  }
}

TEST_F(MacroTest, AnotherCaseIsRefusedAndStaysAsItIs) {
  draw("liver", 12);
  draw("liver", 14);
  copy_now();
  auto other = Case::open(copy_);
  const auto before = contents(copy_);
  EXPECT_EQ(redo_step(*other, folder_, 2).error().code, "step-does-not-fit");  // it was done there already
  EXPECT_EQ(redo_step(*other, folder_, 7).error().code, "step-unknown");
  ASSERT_TRUE(history()->record_values({"Force", {}}, {{"rehearse/force", "[1]", "[2]"}}));
  EXPECT_EQ(redo_step(*other, folder_, 3).error().code, "step-changes-nothing");
  step("Mesh", [&](Case&) { return add(folder_, "meshes/liver", {"mesh", {}, {}, {}, {}}, "a mesh"); });
  std::ofstream(folder_ / "meshes/liver.json") << "overwritten";
  EXPECT_EQ(redo_step(*other, folder_, 4).error().code, "step-content-gone");
  EXPECT_EQ(contents(copy_), before);
}

TEST_F(MacroTest, WhatWasComputedIsComputedAgainWithTheSameOptions) {
  compute("labels/liver", "segment",
          {{"method", "seeds"}, {"seed-1_mm", "-1.125,2,30.0625"}, {"seed-2_mm", "4,5,6"}, {"within", "body"}});
  compute("labels/vessels", "segment",
          {{"method", "tubes"}, {"within", "liver"}, {"brightness", "dark"}, {"seed-1_mm", "1,2,3"}});
  compute("labels/liver", "segment",
          {{"method", "shape"}, {"shapes", "simulated"}, {"seed-1_mm", "1,2,3"}, {"not-1_mm", "4,5,6"}});
  compute("meshes/liver", "mesh", {{"target-cells", "20000"}});
  compute("meshes/model", "stiffness", {{"uniform_kPa", "6.1"}});
  compute("meshes/model", "stiffness", {{"atlas_kPa", "6.09"}});
  compute("meshes/model", "stiffness", {});
  compute("vessels/trees", "vessels", {{"of", "vessels"}, {"click-1_mm", "right-hepatic-vein=1,2,3"}});
  compute("vessels/trees", "vessels", {{"of", "vessels"}, {"portal-click_mm", "1,2,3"}});  // of an earlier version
  compute("vessels/trees", "vessels",
          {{"of", "vessels"}, {"click-10_mm", "portal-vein=4,5,6"}, {"click-9_mm", "hepatic-vein=4,5,6"}});
  compute("vessels/trees", "vessels", {{"of", "vessels"}, {"border-1_mm", "V-VIII=1,2,3"}});
  compute("territories/couinaud", "territories", {{"from", "prior"}});
  compute("territories/couinaud", "territories",
          {{"from", "prior"}, {"border-1_mm", "V-VIII=1,2,3"}, {"border-2_mm", "I-VII=4,5,-6.5"}});
  compute("volumes/stiffness", "invert",
          {{"method", "lfe"}, {"long-waves", "curl"}, {"directions", "apart"}, {"asked-frequency_Hz", "62.5"}});
  EXPECT_THAT(words(),
              ElementsAre("segment {case} --structure liver --seed -1.125,2,30.0625 --seed 4,5,6 --inside body",
                          "segment {case} --structure vessels --seed 1,2,3 --inside liver --tubes --brightness dark",
                          "segment {case} --structure liver --seed 1,2,3 --not 4,5,6 --shapes simulated",
                          "mesh {case} --target-cells 20000", "stiffness {case} --uniform-kPa 6.1",
                          "stiffness {case} --atlas 2.1", "stiffness {case}",
                          "vessels {case} --structure vessels --click right-hepatic-vein=1,2,3",
                          "vessels {case} --structure vessels --click portal-vein=1,2,3",
                          "vessels {case} --structure vessels --click hepatic-vein=4,5,6 --click portal-vein=4,5,6",
                          "vessels {case} --structure vessels --border V-VIII=1,2,3", "territories {case} --from prior",
                          "territories {case} --from prior --border V-VIII=1,2,3 --border I-VII=4,5,-6.5",
                          "invert {case} --method lfe --long-waves curl --directional --frequency-Hz 62.5"));
}

TEST_F(MacroTest, WhatAHandEditedAfterwardsOrCameFromOutsideIsRedone) {
  compute("labels/liver", "segment", {{"method", "seeds"}, {"seed-1_mm", "1,2,3"}, {"edited", "drawn"}});
  compute("volumes/anatomy", "import", {});
  step("Both", [&](Case&) {
    return add(folder_, "meshes/liver", {"mesh", {{"target-cells", "900"}}, {}, {}, {}}, "m").and_then([&] {
      return add(folder_, "labels/vessels", {"import", {}, {}, {}, {}}, "v");
    });
  });
  EXPECT_THAT(words(), ElementsAre("redo {case} --from {recorded} --step 1", "redo {case} --from {recorded} --step 2",
                                   "redo {case} --from {recorded} --step 3"));
}

TEST_F(MacroTest, NothingThatACaseSaysBecomesAnotherCommand) {
  compute("labels/liver", "segment", {{"method", "seeds"}, {"seed-1_mm", "1,2,$(touch hit)"}});
  compute("vessels/trees", "vessels", {{"of", "a'; touch hit; '"}});
  ASSERT_TRUE(history()->record({"Drawn\ntouch hit\n", {}}, [&] {
    return add(folder_, "labels/x", {"segment", {}, {}, {}, {}}, "x");
  }));
  const auto macro = macro_of(folder_);
  ASSERT_TRUE(macro);
  const std::string shell = as_command_line(*macro), python = as_python(*macro);
  EXPECT_THAT(shell, Not(HasSubstr("$(touch")));
  EXPECT_THAT(shell, HasSubstr("--structure 'a'\\''; touch hit; '\\'''"));
  for (const std::string& text : {shell, python}) EXPECT_THAT(text, Not(HasSubstr("\ntouch")));
  EXPECT_THAT(python, HasSubstr("structure=\"a'; touch hit; '\""));
}

TEST_F(MacroTest, AToolThatPressedIsASimulationAndWhatWasUndoneIsLeftOut) {
  const std::string tools =
      R"([{"touch":"patch","tools":[{"preset":"","center_mm":[1,2,3],"outward":[0,0,1],"radius_mm":10,"force_N":2,"direction":[0,0,-1]}]}])";
  ASSERT_TRUE(history()->record_values({"Place the tool", {}}, {{"rehearse/tool", "", tools}}));
  ASSERT_TRUE(history()->record_values({"By hand", {}}, {{"guide/hand", "", "[1]"}}));
  draw("liver", 12);
  ASSERT_TRUE(history()->undo());
  const auto macro = macro_of(folder_);
  ASSERT_TRUE(macro);
  ASSERT_EQ(macro->steps.size(), 2u);
  EXPECT_THAT(macro->steps[0].commands.at(0).document, HasSubstr("\"force_N\":[0.0,0.0,-2.0]"));
  EXPECT_THAT(macro->steps[0].commands.at(0).words,
              ElementsAre("simulate", "{case}", "--scenario", "scenario-1.json", "--out", "rehearsal-1"));
  EXPECT_TRUE(macro->steps[1].commands.empty());
  EXPECT_THAT(as_command_line(*macro), HasSubstr("# 2. By hand (moved a view, and changed nothing in the case)"));
}

TEST_F(MacroTest, ASessionIsOneCommandHoweverManyStepsItTook) {
  const auto hold = [](double push_mN, const std::string& digest) {
    mechanics::TouchingTool probe{mechanics::palpation_probe(8), mechanics::pose_towards({1, 2, 3}, {0, 0, 1}),
                                  push_mN};
    return std::pair<rehearsal::SessionCommand, std::string>{rehearsal::HoldTool{{"tool-0", probe}}, digest};
  };
  rehearsal::Recording recording;
  const std::map<std::string, std::string> kinds{{"a", "small"}, {"b", "large"}, {"c", "meshfree"}, {"d", "moving"}};
  const auto tool_step = [&](double push_mN, const std::string& session) {
    recording.push_back(hold(push_mN, "digest-" + std::to_string(recording.size())));
    const std::string before = history()->value_of("rehearse/tool");
    const std::string after = Json::array({{{"touch", "rigid"},
                                            {"deformations", kinds.at(session)},
                                            {"tools", Json::array()},
                                            {"session", session},
                                            {"commands", recording.size()}}})
                                  .dump();
    ASSERT_TRUE(history()->record_values({"Tool", {}}, {{"rehearse/tool", before, after}}, History::Joins::no,
                                         RecordingBeside{session, rehearsal::recording_text(recording)}));
  };
  tool_step(100, "a");
  tool_step(200, "a");
  tool_step(300, "a");
  ASSERT_TRUE(history()->undo());  // the third is no step any more
  recording.clear();
  tool_step(50, "b");
  recording.clear();
  tool_step(70, "c");
  recording.clear();
  tool_step(90, "d");
  const auto macro = macro_of(folder_);
  ASSERT_TRUE(macro);
  ASSERT_EQ(macro->steps.size(), 5u);
  EXPECT_TRUE(macro->steps[0].commands.empty());
  EXPECT_EQ(macro->steps[0].told_in, 2);
  EXPECT_THAT(words(), ElementsAre("session {case} --live --material linear --settle last --commands session-2.json "
                                   "--out rehearsal-2",
                                   "session {case} --live --material neo-hookean --settle last --commands "
                                   "session-4.json --out rehearsal-4",
                                   "session {case} --live --material linear --settle last --engine meshfree "
                                   "--commands session-5.json --out rehearsal-5",
                                   "session {case} --live --material linear --settle last --motion 0.04 "
                                   "--commands session-6.json --out rehearsal-6"));
  const auto again = rehearsal::parse_recording(macro->steps[1].commands.front().document);
  ASSERT_TRUE(again);
  ASSERT_EQ(again->size(), 2u);
  EXPECT_EQ(again->back().second, "digest-1");
  EXPECT_THAT(as_command_line(*macro), HasSubstr("# 1. Tool (in the session of step 2)"));
  EXPECT_THAT(as_python(*macro), HasSubstr("rehearsal_4 = patient.session(material=\"neo-hookean\")"));
  EXPECT_THAT(as_python(*macro), HasSubstr("rehearsal_5 = patient.session(material=\"linear\", engine=\"meshfree\")"));
  EXPECT_THAT(as_python(*macro), HasSubstr("rehearsal_6 = patient.session(material=\"linear\", step_s=0.04)"));
  // What no step needs any more goes.
  draw("liver", 12);
  EXPECT_NE(recording_beside(folder_, "a"), "");
  while (history()->steps_to_undo() > 0) ASSERT_TRUE(history()->undo());
  draw("liver", 13);
  EXPECT_EQ(recording_beside(folder_, "a"), "");
  EXPECT_EQ(recording_beside(folder_, "../../case"), "");
}

TEST_F(MacroTest, MarkedLinesAreGuidedBy) {
  const std::string content(64, 'b');
  const auto lines = [](const std::string& sequence, const std::string& seen) {
    return R"([{"format":"glisson-marked-lines/1","sequence":")" + sequence +
           R"(","lines":[{"id":"falciform","at_rest":[[0,0,0],[9,0,0]],"seen":{"3":)" + seen + "}}]}]";
  };
  const std::string begun = lines(content, "[[0,0,99]]"), marked = lines(content, "[[0,0,99],[9,0,99]]");
  ASSERT_TRUE(history()->record_values({"Mark", {}}, {{"guide/lines", "[null]", begun}}));
  ASSERT_TRUE(history()->record_values({"Mark", {}}, {{"guide/lines", begun, marked}}));
  const std::string pose = R"([{"sequence":")" + content + R"(","frame":1,"pose":[1,0,0,0,0,1,0,2,0,0,1,90,0,0,0,1]}])";
  ASSERT_TRUE(history()->record_values({"By hand", {}}, {{"guide/pose", "[null]", pose}}));
  ASSERT_TRUE(history()->record_values({"Mark", {}},
                                       {{"guide/lines", marked, lines(std::string(64, 'c'), "[[0,0,99],[9,0,99]]")}}));
  const auto macro = macro_of(folder_);
  ASSERT_TRUE(macro);
  ASSERT_EQ(macro->steps.size(), 4u);
  EXPECT_TRUE(macro->steps[0].commands.empty());  // one place is no line
  const std::string common = "guide {case} --sequence {sequence-1} --sequence-sha256 " + content;
  const std::string by_hand = " --frame 1 --pose=1,0,0,0,0,1,0,2,0,0,1,90,0,0,0,1";
  EXPECT_THAT(words(), ElementsAre(common + " --frame 3 --lines lines-2.json --out guided-2",
                                   common + by_hand + " --lines lines-3.json --out guided-3",
                                   common + by_hand + " --out guided-4"));  // its lines are of another video
  EXPECT_EQ(Json::parse(macro->steps[1].commands.at(0).document).at("sequence"), content);
  EXPECT_THAT(as_command_line(*macro), HasSubstr("cat > lines-2.json"));
  EXPECT_THAT(as_python(*macro), HasSubstr("frame=3, lines={\"format\""));
}

TEST_F(MacroTest, ACutInTheMakingIsAnsweredAndALiverLaidByHandIsRefined) {
  const auto said = [](const std::string& plan) { return Json::array({plan}).dump(); };
  const std::string plane = said(R"({"format":"glisson-plan/1","name":"taken","cuts":[{"plane":{"point_mm":[1,2,3],)"
                                 R"("normal":[1,0,0],"removed":"larger"}}]})");
  const std::string taken = said(R"({"format":"glisson-plan/1","name":"taken","cuts":[{"segments":[6,7]}]})");
  ASSERT_TRUE(history()->record_values({"Set a plane", {}}, {{"resect/surface", "[null]", plane}}));
  ASSERT_TRUE(history()->record_values({"Cut by segments", {}}, {{"resect/taken", "[null]", taken}}));
  ASSERT_TRUE(history()->record_values({"No cut", {}},
                                       {{"resect/surface", plane, "[null]"}, {"resect/taken", taken, "[null]"}}));
  const std::string content(64, 'a');
  const std::string pose =
      R"([{"sequence":")" + content + R"(","frame":2,"pose":[1,0,0,0.1,0,1,0,2,0,0,1,90,0,0,0,1]}])";
  ASSERT_TRUE(history()->record_values({"By hand", {}}, {{"guide/pose", "[null]", pose}}));
  ASSERT_TRUE(
      history()->record_values({"By hand", {}}, {{"guide/pose", pose, R"([{"sequence":"$[hit]","frame":2}])"}}));
  const auto macro = macro_of(folder_);
  ASSERT_TRUE(macro);
  ASSERT_EQ(macro->steps.size(), 5u);
  EXPECT_EQ(Json::parse(macro->steps[0].commands.at(0).document).at("cuts").size(), 1u);
  const Json both = Json::parse(macro->steps[1].commands.at(0).document).at("cuts");
  ASSERT_EQ(both.size(), 2u);
  EXPECT_EQ(both[0].at("plane").at("removed"), "larger");
  EXPECT_TRUE(macro->steps[2].commands.empty());
  EXPECT_TRUE(macro->steps[4].commands.empty());
  EXPECT_THAT(words(), ElementsAre("plan {case} --answer plan-1.json --out plan-1",
                                   "plan {case} --answer plan-2.json --out plan-2",
                                   "guide {case} --sequence {sequence-1} --sequence-sha256 " + content +
                                       " --frame 2 "
                                       "--pose=1,0,0,0.1,0,1,0,2,0,0,1,90,0,0,0,1 --out guided-4"));
  EXPECT_THAT(as_command_line(*macro), HasSubstr("SEQUENCE_1=sequence.json  # the file whose SHA-256 is " + content));
  EXPECT_THAT(as_command_line(*macro), HasSubstr("--sequence \"$SEQUENCE_1\""));
  EXPECT_THAT(as_python(*macro), HasSubstr("patient.guide(sequence_1, frame=2, pose=[1, 0, 0, 0.1, "));
}

TEST_F(MacroTest, SaysThatEarlierStepsAreForgotten) {
  history_ = History::open(folder_, HistoryCaps{.disk_bytes = std::uintmax_t{1} << 30, .steps = 2}).value();
  draw("liver", 12);
  draw("liver", 13);
  EXPECT_FALSE(macro_of(folder_)->earlier_forgotten);
  draw("liver", 14);
  EXPECT_TRUE(macro_of(folder_)->earlier_forgotten);
  EXPECT_THAT(as_python(*macro_of(folder_)), HasSubstr("Earlier steps are no longer known"));
}

}  // namespace
}  // namespace glisson::casefile

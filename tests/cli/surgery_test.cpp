// Rehearsing and resecting through the program itself, on a liver that is an ellipsoid with a ball in it.

#include <gmock/gmock.h>

#include "base/files.h"
#include "base/json.h"
#include "casefile/orders.h"
#include "geometry/mesh_file.h"
#include "support/data.h"
#include "support/process.h"
#include "support/small_liver.h"

namespace glisson::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class SmallLiver : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TemporaryFolder;
    ASSERT_TRUE(write_small_liver(folder_->path()));
    answer({"import", file("scan.nrrd"), "--case", patient()});
    answer({"segment", patient(), "--structure", "liver", "--labels", file("liver.nrrd")});
    answer({"segment", patient(), "--structure", "tumour-1", "--labels", file("tumour.nrrd")});
    answer({"mesh", patient(), "--target-cells", "1500"});
    answer({"stiffness", patient(), "--uniform-kPa", "6"});
  }
  static void TearDownTestSuite() { delete folder_; }

  static Json answer(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--json", "--quiet"});
    const Finished finished = glisson_cli(arguments);
    EXPECT_EQ(finished.exit_code, 0) << arguments.front() << ": " << finished.err;
    return finished.json();
  }
  static std::string file(const std::string& name) { return (folder_->path() / name).string(); }
  static std::string patient() { return file("small.glisson"); }

  static TemporaryFolder* folder_;
};
TemporaryFolder* SmallLiver::folder_ = nullptr;

TEST_F(SmallLiver, IsResectedWithVolumesAndTheTumoursMargin) {
  const Json plan = answer({"resect", patient(), "--plane=-20,0,0,1,0,0", "--out", file("resection")});
  const double specimen_ml = plan.at("specimen_ml"), remnant_ml = plan.at("remnant_ml");
  EXPECT_NEAR(specimen_ml + remnant_ml, 4.0 / 3.0 * 3.14159 * 70 * 50 * 50 / 1000, 40);
  EXPECT_NEAR(plan.at("remnant_percent").get<double>(), 100 * remnant_ml / (specimen_ml + remnant_ml), 1e-6);
  ASSERT_EQ(plan.at("tumours").size(), 1u);
  EXPECT_EQ(plan.at("tumours")[0].at("side"), "specimen");
  EXPECT_NEAR(plan.at("tumours")[0].at("margin_mm").get<double>(), 5, 2.5);  // half a voxel
  for (const char* name : {"resection.json", "parts.vtu", "cut.vtp"}) {
    EXPECT_TRUE(fs::exists(folder_->path() / "resection" / name)) << name;
  }
  const Json through = answer({"resect", patient(), "--plane=-35,0,0,1,0,0", "--out", file("through")});
  EXPECT_TRUE(through.at("tumours")[0].at("r1").get<bool>());
}

TEST_F(SmallLiver, ACutThatMissesIsRefusedAndLeavesNothing) {
  const Finished missed =
      glisson_cli({"resect", patient(), "--plane=500,0,0,1,0,0", "--out", file("missed"), "--json", "--quiet"});
  EXPECT_EQ(missed.exit_code, 1);
  EXPECT_EQ(missed.json().at("error").at("code"), "cut-misses");
  EXPECT_FALSE(fs::exists(folder_->path() / "missed"));
  EXPECT_EQ(glisson_cli({"resect", patient(), "--out", file("none")}).exit_code, 2);  // neither plane nor points
}

TEST_F(SmallLiver, IsResectedAsAToolHoldsItAside) {
  ASSERT_TRUE(write_text_file(folder_->path() / "aside.json", R"({"loads": [
    {"tool": {"center_mm": [-30, -45, 0], "radius_mm": 15, "force_N": [0, -0.5, 0]}}]})"));
  const Json pulled = answer({"simulate", patient(), "--scenario", file("aside.json"), "--out", file("aside")});
  double moved_mm = 0;
  for (const Json& landmark : pulled.at("landmarks")) {
    if (landmark.at("id") == "tumour-1") moved_mm = landmark.at("displacement_mm");
  }
  ASSERT_GT(moved_mm, 0.5);
  // Across the way that it is pulled: what lies before the plane at rest is pulled through it.
  const std::string plane = "--plane=0,-30,0,0,-1,0";
  const Json rest = answer({"resect", patient(), plane, "--out", file("rest")});
  const Json held = answer({"resect", patient(), plane, "--result", file("aside/result.vtu"), "--out", file("held")});
  EXPECT_EQ(held.at("cut").at("liver"), "held-aside");
  EXPECT_NEAR(held.at("tumours")[0].at("shift_mm").get<double>(), moved_mm, 0.5);
  EXPECT_FALSE(rest.at("tumours")[0].contains("shift_mm"));
  const auto whole_ml = [](const Json& plan) {
    return plan.at("specimen_ml").get<double>() + plan.at("remnant_ml").get<double>();
  };
  EXPECT_NEAR(whole_ml(held), whole_ml(rest), 1e-6);  // tissue neither comes nor goes
  EXPECT_GT(held.at("specimen_ml").get<double>(), rest.at("specimen_ml").get<double>() + 0.5);
  EXPECT_LT(held.at("tumours")[0].at("margin_mm").get<double>(),
            rest.at("tumours")[0].at("margin_mm").get<double>() - 0.3);

  const Finished other = glisson_cli({"resect", "--mesh", file("held/parts.vtu"), plane, "--result",
                                      file("aside/result.vtu"), "--out", file("other"), "--json", "--quiet"});
  EXPECT_EQ(other.exit_code, 1);  // the parts are more cells than the model
}

TEST_F(SmallLiver, AcceptedEvidenceChangesWhatIsRehearsedAndIsTakenBackToTheBit) {
  ASSERT_TRUE(write_text_file(folder_->path() / "model.json", R"({"format": "glisson-closedloop-model/1",
    "kind": "palpation", "verdict": "explained", "effects": [
    {"kind": "stiffness-scale", "parameters": {"factor": 0.5}},
    {"kind": "anisotropy", "law": "fibres", "parameters": {"axis": [1, 0, 0], "ratio": 2}},
    {"kind": "force-bias", "parameters": {"zero_N": 0, "gain": 1.1}}]})"));
  ASSERT_TRUE(write_text_file(folder_->path() / "pull.json", R"({"loads": [
    {"tool": {"center_mm": [0, -50, 0], "radius_mm": 15, "force_N": [0, -0.5, 0]}}]})"));
  ASSERT_TRUE(write_text_file(folder_->path() / "hook.json", R"({"format": "glisson-session/1", "commands": [
    {"hold": {"id": "hook", "shape": "nathanson-retractor", "position_mm": [0, 0, -70], "direction": [0, 0, 1],
              "push_mN": 200}}]})"));
  const auto pull = [&](const char* out) {
    return answer({"simulate", patient(), "--scenario", file("pull.json"), "--out", file(out)});
  };
  const auto hold = [&] { return answer({"session", patient(), "--commands", file("hook.json")}); };
  const Json before = pull("before");
  const Json held_before = hold();
  EXPECT_FALSE(before.contains("evidence"));

  for (const char* refused : {"force-bias", "stiffness-scale"}) {  // of no consequence; of whose tissue, nobody says
    EXPECT_EQ(glisson_cli({"accept", patient(), file("model.json"), "--effect", refused, "--quiet"}).exit_code, 1);
  }
  const Json accepted =
      answer({"accept", patient(), file("model.json"), "--effect", "stiffness-scale", "--of-this-patient"});
  ASSERT_EQ(accepted.at("effects").size(), 1u);
  EXPECT_TRUE(accepted.at("effects")[0].at("carried").get<bool>());
  EXPECT_EQ(answer({"accept", patient()}), accepted);
  const Json softer = pull("softer");
  EXPECT_EQ(softer.at("evidence").size(), 1u);
  const double moved = before.at("landmarks")[0].at("displacement_mm");
  EXPECT_GT(softer.at("landmarks")[0].at("displacement_mm").get<double>(), 1.5 * moved);
  EXPECT_LE(softer.at("landmarks")[0].at("displacement_mm").get<double>(), 2 * moved);  // springs do not soften
  const Json held_softer = hold();
  EXPECT_EQ(held_softer.at("evidence").at("effects").size(), 1u);
  EXPECT_NE(held_softer.at("frames")[0].at("digest"), held_before.at("frames")[0].at("digest"));

  // In its place.
  answer({"accept", patient(), file("model.json"), "--effect", "anisotropy", "--of-this-patient"});
  EXPECT_LT(pull("grained").at("max_displacement_mm").get<double>(), before.at("max_displacement_mm").get<double>());
  EXPECT_THAT(read_text_file(folder_->path() / "grained/scenario.json").value(), HasSubstr("\"grain\""));

  EXPECT_TRUE(answer({"accept", patient(), "--take-back"}).at("effects").empty());
  EXPECT_EQ(pull("after").at("landmarks"), before.at("landmarks"));
  EXPECT_EQ(hold().at("frames")[0].at("digest"), held_before.at("frames")[0].at("digest"));
  EXPECT_EQ(glisson_cli({"accept", patient(), "--effect", "capsule"}).exit_code, 2);
  EXPECT_EQ(glisson_cli({"accept", patient(), "--take-back", "--effect", "capsule"}).exit_code, 1);
}

TEST_F(SmallLiver, EveryAnswerSaysWhatItIsWorthAndNoneThatMayNotBeUsedIsPrinted) {
  const auto pulled = [&](const std::string& name, const std::string& force_N) {
    EXPECT_TRUE(write_text_file(folder_->path() / (name + ".json"), R"({"loads": [{"tool": {
        "center_mm": [0, -50, 0], "radius_mm": 15, "force_N": [0, -)" + force_N +
                                                                        ", 0]}}]}"));
    return answer({"simulate", patient(), "--scenario", file(name + ".json"), "--out", file(name)});
  };
  const Json gentle = pulled("gentle", "0.05"), hard = pulled("hard", "2"), brute = pulled("brute", "200");
  EXPECT_EQ(gentle.at("state"), "within");
  EXPECT_TRUE(gentle.at("converged").get<bool>());
  EXPECT_FALSE(gentle.contains("reason"));
  EXPECT_EQ(hard.at("state"), "outside-of-the-model");
  EXPECT_GT(hard.at("largest_strain").get<double>(), 0.2);
  EXPECT_THAT(hard.at("reason").get<std::string>(), HasSubstr("beyond 20 %"));
  EXPECT_GT(hard.at("landmarks")[0].at("displacement_mm").get<double>(), 0);
  EXPECT_EQ(brute.at("state"), "unusable");
  EXPECT_GT(brute.at("inverted_cells").get<int>(), 0);
  EXPECT_FALSE(brute.at("converged").get<bool>());
  EXPECT_FALSE(brute.contains("max_displacement_mm"));
  EXPECT_FALSE(brute.at("landmarks")[0].contains("displaced_mm"));
  EXPECT_EQ(read_json_file(folder_->path() / "brute/result.json").value().at("state"), "unusable");

  const Finished words =
      glisson_cli({"simulate", patient(), "--scenario", file("brute.json"), "--out", file("brute"), "--quiet"});
  EXPECT_EQ(words.exit_code, 0);
  EXPECT_THAT(words.out, HasSubstr("Not to be used: cells turned inside out"));
  EXPECT_THAT(words.out, HasSubstr("Largest displacement -;"));
  // Nor does anything go on from it.
  const std::string plane = "--plane=0,-30,0,0,-1,0";
  EXPECT_EQ(
      glisson_cli({"resect", patient(), plane, "--result", file("brute"), "--out", file("no"), "--quiet"}).exit_code,
      1);
  EXPECT_EQ(glisson_cli({"compare", file("gentle"), file("brute"), "--quiet"}).exit_code, 1);
  const Json held = answer({"resect", patient(), plane, "--result", file("hard"), "--out", file("aside")});
  EXPECT_EQ(held.at("retraction").at("state"), "outside-of-the-model");
  EXPECT_EQ(answer({"compare", file("gentle"), file("hard")}).at("states")[1].at("state"), "outside-of-the-model");
}

TEST_F(SmallLiver, AnAssumedStiffnessIsCalledSoAndNotComparedWithTheReferenceBody) {
  const Json given = answer({"stiffness", patient(), "--uniform-kPa", "6"});
  EXPECT_TRUE(given.at("assumed").get<bool>());
  EXPECT_THAT(glisson_cli({"stiffness", patient(), "--uniform-kPa", "6", "--quiet"}).out,
              HasSubstr("is assumed, 6 kPa"));
  ASSERT_TRUE(write_text_file(folder_->path() / "touch.json", R"({"format": "glisson-session/1", "commands": [
    {"hold": {"id": "hook", "shape": "nathanson-retractor", "position_mm": [0, 0, -70], "direction": [0, 0, 1],
              "push_mN": 200, "friction": 0.1}}]})"));
  const Json session = answer({"session", patient(), "--commands", file("touch.json")});
  EXPECT_THAT(session.at("notes").dump(), HasSubstr("not compared with the atlas"));
  EXPECT_THAT(session.at("notes").dump(), HasSubstr("At small strain every tool is smooth"));
  const Json& step = session.at("frames")[0];
  EXPECT_FALSE(step.contains("atlas"));
  EXPECT_FALSE(step.contains("max_difference_mm"));
  EXPECT_TRUE(step.at("usable").get<bool>());
  EXPECT_GT(step.at("largest_strain").get<double>(), 0);
  ASSERT_TRUE(write_text_file(folder_->path() / "weight.json", R"({"loads": [{"gravity_m_s2": [0, 9.81, 0]}]})"));
  const Json hung = answer({"simulate", patient(), "--scenario", file("weight.json"), "--out", file("weight")});
  EXPECT_THAT(hung.at("notes").dump(), HasSubstr("The stiffness is assumed"));
}

// As another program would, in a copy of the case.
class ReplacedModel : public SmallLiver {
 protected:
  void SetUp() override {
    fs::copy(patient(), copy_, fs::copy_options::recursive);
    ASSERT_TRUE(write_text_file(place_.path() / "pull.json", R"({"loads": [
      {"tool": {"center_mm": [0, -50, 0], "radius_mm": 15, "force_N": [0, -0.2, 0]}}]})"));
  }
  void replace_model(const Eigen::Vector3d& by_mm) const {
    auto mesh = geometry::read_tetrahedra(copy_ / "meshes" / "model.vtu");
    ASSERT_TRUE(mesh) << mesh.error().message();
    for (Eigen::Vector3d& point : mesh->points_mm) point += by_mm;
    geometry::set_field(mesh->cell_fields, {"youngs_modulus_kPa", 1, std::vector<double>(mesh->cells.size(), 9.0)});
    ASSERT_TRUE(geometry::write_tetrahedra(copy_ / "meshes" / "model.vtu", *mesh));
  }
  [[nodiscard]] std::string at(const char* name) const { return (place_.path() / name).string(); }
  // What answers from the case's files.
  [[nodiscard]] std::vector<std::vector<std::string>> commands() const {
    return {{"simulate", copy_.string(), "--scenario", at("pull.json"), "--out", at("pulled")},
            {"resect", copy_.string(), "--plane=-20,0,0,1,0,0", "--out", at("resected")},
            {"export", copy_.string(), "--format", "vtu", "--out", at("liver.vtu")}};
  }

  TemporaryFolder place_;
  fs::path copy_ = place_.path() / "copy.glisson";
};

TEST_F(ReplacedModel, IsToldOfInTheAnswer) {
  replace_model({0, 0, 0});
  for (const auto& command : commands()) {
    EXPECT_THAT(answer(command).at("notes").dump(), HasSubstr("Another program has changed meshes/model"))
        << command.front();
    const Finished in_words = glisson_cli(command);
    EXPECT_THAT(in_words.out, HasSubstr("Another program has changed meshes/model")) << command.front();
  }
}

TEST_F(ReplacedModel, OfAnotherBodyIsRefusedAndNothingIsWritten) {
  replace_model({200, 0, 0});
  for (const auto& command : commands()) {
    std::vector<std::string> as_json = command;
    as_json.insert(as_json.end(), {"--json", "--quiet"});
    const Finished refused = glisson_cli(as_json);
    EXPECT_EQ(refused.exit_code, 1) << command.front();
    EXPECT_EQ(refused.json().at("error").at("code"), "model-of-another") << command.front();
    EXPECT_FALSE(fs::exists(command.back())) << command.front();
  }
}

TEST_F(ReplacedModel, AnEditedLabelIsToldOf) {
  ASSERT_TRUE(write_text_file(copy_ / "labels" / "tumour-1.nrrd", *read_text_file(file("tumour.nrrd"))));
  for (const auto& command : commands()) {
    if (command.front() == "export") continue;  // of the model alone
    EXPECT_THAT(answer(command).at("notes").dump(), HasSubstr("Another program has changed labels/tumour-1"))
        << command.front();
  }
  const Json labels = answer({"export", copy_.string(), "--format", "nrrd", "--out", at("labels")});
  EXPECT_THAT(labels.at("notes").dump(), HasSubstr("Another program has changed labels/tumour-1"));
}

TEST_F(SmallLiver, ResultsThatAreALinkToThemselvesAreNone) {
  const TemporaryFolder place;
  const fs::path copy = place.path() / "copy.glisson";
  fs::copy(patient(), copy, fs::copy_options::recursive);
  fs::remove_all(copy / "results");
  fs::create_symlink("results", copy / "results");
  const std::string page = (place.path() / "page.html").string();
  const Finished told = glisson_cli({"report", copy.string(), "--out", page, "--quiet"});
  EXPECT_EQ(told.exit_code, 0) << told.err;
  EXPECT_TRUE(fs::exists(page));
}

TEST_F(SmallLiver, ASessionWithTwoToolsIsRecordedAndReplaysToTheBit) {
  const char* commands = R"({"format": "glisson-session/1", "commands": [
    {"hold": {"id": "hook", "shape": "nathanson-retractor", "position_mm": [0, 0, -70], "direction": [0, 0, 1],
              "push_mN": 200}},
    {"hold": {"id": "probe", "shape": "palpation-probe", "position_mm": [-40, -80, 0], "direction": [0, 1, 0],
              "push_mN": 100}},
    {"hold": {"id": "lost", "shape": "palpation-probe", "position_mm": [0, 300, 0], "direction": [0, 1, 0],
              "push_mN": 100}},
    {"release": "hook"}, {"undo": true}]})";
  ASSERT_TRUE(write_text_file(folder_->path() / "commands.json", commands));
  const Json session =
      answer({"session", patient(), "--commands", file("commands.json"), "--out", file("recorded.json")});
  const Json& steps = session.at("frames");
  ASSERT_EQ(steps.size(), 5u);
  const Json& both = steps[1].at("patient");
  EXPECT_FALSE(steps[1].contains("refused"));
  EXPECT_TRUE(both.at("converged").get<bool>());
  EXPECT_LE(both.at("penetration_mm").get<double>(), 0.1);
  EXPECT_NEAR(both.at("tools")[0].at("force_N")[2].get<double>(), 0.2, 1e-3);
  EXPECT_NEAR(both.at("tools")[1].at("force_N")[1].get<double>(), 0.1, 1e-3);
  EXPECT_THAT(steps[2].at("refused").get<std::string>(), HasSubstr("meets no surface"));
  EXPECT_EQ(steps[2].at("digest"), steps[1].at("digest"));
  EXPECT_EQ(steps[4].at("digest"), steps[1].at("digest"));  // undone

  answer({"session", patient(), "--commands", file("recorded.json")});  // the same bits again
  std::string changed = read_text_file(folder_->path() / "recorded.json", 1 << 20).value();
  const std::string digest = steps[1].at("digest");
  changed.replace(changed.find(digest), 4, "0000");
  ASSERT_TRUE(write_text_file(folder_->path() / "changed.json", changed));
  const Finished other = glisson_cli({"session", patient(), "--commands", file("changed.json"), "--json", "--quiet"});
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_EQ(other.json().at("error").at("code"), "replay-differs");
  EXPECT_THAT(other.json().at("error").at("message").get<std::string>(), HasSubstr("Command 2"));
}

TEST_F(SmallLiver, ASessionByTheMeshfreeEngineStandsBesideFiniteElements) {
  ASSERT_TRUE(write_text_file(folder_->path() / "press.json", R"({"format": "glisson-session/1", "commands": [
    {"hold": {"id": "probe", "shape": "palpation-probe", "position_mm": [0, -70, 0], "direction": [0, 1, 0],
              "push_mN": 100}}]})"));
  const Json meshfree =
      answer({"session", patient(), "--engine", "meshfree", "--nodes", "60", "--commands", file("press.json")});
  const Json elements = answer({"session", patient(), "--engine", "fem", "--commands", file("press.json")});
  const Json& frame = meshfree.at("frames")[0];
  double apart_mm = 0;
  for (std::size_t l = 0; l < frame.at("landmarks").size(); ++l) {
    const auto at = [&](const Json& one) {
      const auto mm = one.at("frames")[0].at("landmarks")[l].at("displaced_mm").get<std::vector<double>>();
      return Eigen::Vector3d(mm[0], mm[1], mm[2]);
    };
    apart_mm = std::max(apart_mm, (at(meshfree) - at(elements)).norm());
  }
  EXPECT_NEAR(frame.at("finite_elements").at("landmarks_mm").get<double>(), apart_mm, 1e-6);
  EXPECT_GE(frame.at("finite_elements").at("surface_mm").get<double>(), 0.01);
  EXPECT_FALSE(elements.at("frames")[0].contains("finite_elements"));
  const Finished large = glisson_cli({"session", patient(), "--engine", "meshfree", "--material", "neo-hookean",
                                      "--commands", file("press.json"), "--json", "--quiet"});
  EXPECT_EQ(large.exit_code, 1);
  EXPECT_THAT(large.json().at("error").at("message").get<std::string>(), HasSubstr("linear, isotropic"));
}

TEST_F(SmallLiver, TwoOrdersOfStepsAreComparedInFiguresAndAsAPage) {
  const auto order = [&](const char* name, double first_mN) {
    const std::string commands = R"({"format": "glisson-session/1", "commands": [
      {"hold": {"id": "hook", "shape": "nathanson-retractor", "position_mm": [0, 0, -70], "direction": [0, 0, 1],
                "push_mN": )" + std::to_string(first_mN) +
                                 R"(}},
      {"hold": {"id": "hook", "shape": "nathanson-retractor", "position_mm": [0, 0, -70], "direction": [0, 0, 1],
                "push_mN": 100}}]})";
    EXPECT_TRUE(write_text_file(folder_->path() / name, commands));
    return file(name);
  };
  const Json compared = answer({"session", patient(), "--commands", order("gently.json", 150),
                                order("hard <first>.json", 300), "--out", file("orders")});
  const Json& orders = compared.at("orders");
  ASSERT_EQ(orders.size(), 2u);
  EXPECT_EQ(orders[0].at("name"), "gently");
  // The push, and what presses on the blade sideways.
  const double gently_N = orders[0].at("largest_force_N"), hard_N = orders[1].at("largest_force_N");
  EXPECT_GE(gently_N, 0.149);
  EXPECT_LE(gently_N, 0.165);
  EXPECT_GE(hard_N, 0.299);
  EXPECT_LE(hard_N, 0.33);
  EXPECT_EQ(orders[1].at("largest_force_N_at_step"), 1);
  ASSERT_FALSE(orders[0].at("landmarks").empty());
  for (std::size_t l = 0; l < orders[0].at("landmarks").size(); ++l) {
    const Json &gently = orders[0].at("landmarks")[l], &hard = orders[1].at("landmarks")[l];
    EXPECT_LT(gently.at("largest_mm"), hard.at("largest_mm"));
    EXPECT_NEAR(gently.at("end_mm").get<double>(), hard.at("end_mm").get<double>(), 0.2);
  }
  const std::string page = read_text_file(folder_->path() / "orders" / "orders.html", 1 << 22).value();
  EXPECT_THAT(page, HasSubstr("Orders of steps compared"));
  EXPECT_THAT(page, HasSubstr("hard &lt;first&gt;"));
  EXPECT_EQ(Json::parse(read_text_file(folder_->path() / "orders" / "orders.json", 1 << 22).value()).at("orders"),
            orders);
}

TEST_F(SmallLiver, KeepsOrdersOfStepsWithWhatTheyAskAndShowsThemInTheReport) {
  const auto push = [&](const char* name, int push_mN) {
    EXPECT_TRUE(write_text_file(folder_->path() / name, R"({"format": "glisson-session/1", "commands": [
      {"hold": {"id": "hook", "shape": "nathanson-retractor", "position_mm": [0, 0, -70], "direction": [0, 0, 1],
                "push_mN": )" + std::to_string(push_mN) + "}}]}"));
    return file(name);
  };
  fs::create_directories(folder_->path() / "again");
  const std::string kept = file("orders.glisson");
  fs::copy(patient(), kept, fs::copy_options::recursive);
  const Json compared = answer(
      {"session", kept, "--commands", push("a.json", 100), push("again/a.json", 200), push("b.json", 150), "--keep"});
  EXPECT_EQ(compared.at("orders")[1].at("name"), "again a");
  const auto orders = casefile::kept_orders(casefile::Case::open(kept).value());
  ASSERT_TRUE(orders.has_value()) << orders.error().message();
  ASSERT_EQ(orders->size(), 3U);
  EXPECT_EQ(orders->back().name, "b");
  ASSERT_EQ(orders->back().recording.size(), 1U);

  // What was kept is what was printed, and each of them is a recording that can be run again.
  const auto read = casefile::kept_comparison(casefile::Case::open(kept).value());
  ASSERT_TRUE(read.has_value() && read->has_value());
  EXPECT_FALSE((*read)->remarks.empty());  // that its stiffness is assumed
  for (std::size_t n = 0; n < 3; ++n) EXPECT_EQ(rehearsal::json_of((*read)->orders[n]), compared.at("orders")[n]);
  answer({"session", kept, "--commands", (fs::path(kept) / "orders" / "b.json").string()});
  answer({"report", kept, "--out", file("orders-report.html")});
  const std::string page = read_text_file(folder_->path() / "orders-report.html", 1 << 24).value();
  EXPECT_THAT(page, HasSubstr("What each order asks of the liver at its worst"));
  EXPECT_THAT(page, HasSubstr("again a"));

  // A damaged comparison is told, with its name, and changes nothing.
  ASSERT_TRUE(write_text_file(fs::path(kept) / "results" / "orders.json",
                              R"({"format": "glisson-orders/1", "material": "linear", "orders": [{"name": "a"}]})"));
  const Finished damaged = glisson_cli({"report", kept, "--out", file("damaged.html"), "--json", "--quiet"});
  EXPECT_EQ(damaged.exit_code, 1);
  EXPECT_EQ(damaged.json().at("error").at("code"), "orders-invalid");
  EXPECT_FALSE(fs::exists(folder_->path() / "damaged.html"));
}

TEST_F(SmallLiver, IsCutAndTouchedByAScenario) {
  ASSERT_TRUE(write_text_file(folder_->path() / "cut.json", R"({"material": "linear",
      "supports": [{"point_array": "bare_area"}, {"point_array": "diaphragm", "foundation_kPa_per_mm": 1.1}],
      "cuts": [{"points_mm": [[0, -60, -60], [0, 60, -60], [5, -60, 0], [5, 60, 0]], "center_mm": [0, 0, -50],
                "radius_mm": 30}],
      "tools": [{"id": "probe", "shape": "palpation-probe", "position_mm": [-30, -80, 0], "direction": [0, 1, 0],
                 "advance_mm": 35}]})"));
  const Json result = answer({"simulate", patient(), "--scenario", file("cut.json"), "--out", file("cut")});
  EXPECT_TRUE(result.at("converged").get<bool>());
  EXPECT_GT(result.at("tools")[0].at("force_N")[1].get<double>(), 0);
  EXPECT_LE(result.at("contact").at("penetration_mm").get<double>(), 0.1);
  EXPECT_GT(result.at("cut").at("largest_opening_mm").get<double>(), 0);
}

}  // namespace
}  // namespace glisson::test

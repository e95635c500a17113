// Accepted evidence changes the organ of a case and its rehearsal; taken back, they are what they were, to the bit.

#include "casefile/evidence.h"

#include <gmock/gmock.h>
#include <fstream>

#include "base/files.h"
#include "base/json.h"
#include "casefile/model.h"
#include "geometry/mesh_file.h"
#include "mechanics/bodies.h"
#include "mechanics/simulation.h"
#include "rehearsal/session.h"

namespace glisson::casefile {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::SizeIs;

Json effect(const char* kind, const Json& parameters) { return {{"kind", kind}, {"parameters", parameters}}; }
const Json scaled = effect("stiffness-scale", {{"factor", 2.0}});
const Json skin = effect("capsule", {{"stiffness_N_per_mm", 0.5}});
const Json bias = effect("force-bias", {{"zero_N", 0.0}, {"gain", 1.2}});

// A block that is held at its back, as the liver is by its bare area.
class EvidenceTest : public testing::Test {
 protected:
  void SetUp() override {
    auto made = Case::create(folder_);
    ASSERT_TRUE(made);
    geometry::TetMesh mesh = mechanics::test::box(6, 4, 4, {90, 60, 60});
    mechanics::test::name_points(mesh, "bare_area", [](const Eigen::Vector3d& p) { return p.y() == 60; });
    mechanics::test::name_points(mesh, "diaphragm", [](const Eigen::Vector3d& p) { return p.z() == 60 && p.y() < 50; });
    geometry::set_field(mesh.cell_fields,
                        {mechanics::youngs_modulus_field, 1, std::vector<double>(mesh.cells.size(), 6.0)});
    ASSERT_TRUE(made->add("meshes/model", ".vtu", {"stiffness", {}, {}, {}, {}},
                          [&](const fs::path& file) { return geometry::write_tetrahedra(file, mesh); }));
  }
  Case open() { return Case::open(folder_).value(); }
  fs::path model(const std::vector<Json>& effects, const char* verdict = "explained",
                 const Json& more = Json::object()) {
    const fs::path file = temporary_.path() / "model.json";
    Json json{
        {"format", "glisson-closedloop-model/1"}, {"kind", "palpation"}, {"verdict", verdict}, {"effects", effects}};
    json.update(more);
    EXPECT_TRUE(write_text_file(file, json.dump()));
    return file;
  }
  static Result<Evidence> accept(Case& patient, const fs::path& file, const std::vector<std::string>& kinds = {}) {
    return accept_evidence(patient, file, kinds, Tissue::told_by_person);
  }
  // Where a rehearsed retraction brings the surface.
  static std::vector<Eigen::Vector3d> retracted(const Case& patient) {
    const auto rehearsal = rehearsal::StaticRehearsal::create(rehearsal_setup(read_model(patient).value())).value();
    return rehearsal.place_tool({60, 0, 30}, 15)->answer({0, -0.5, 0.3}).patient.surface_mm;
  }

  TemporaryFolder temporary_;
  fs::path folder_ = temporary_.path() / "patient.glisson";
};

TEST_F(EvidenceTest, AcceptedItChangesTheRehearsalByTheRightAmountTakenBackNotAtAll) {
  Case patient = open();
  const auto rest = geometry::boundary_surface(read_model(patient)->mesh).points_mm;
  const auto before = retracted(patient);
  const auto accepted = accept_evidence(patient, model({scaled, bias}), {}, Tissue::told_by_person);
  ASSERT_TRUE(accepted) << accepted.error().message();
  ASSERT_THAT(accepted->effects, SizeIs(1));  // the load cell's bias leaves the organ as it is
  EXPECT_TRUE(accepted->effects[0].carried);
  const auto after = retracted(open());
  // Springs under the diaphragm do not scale, so that a block twice as stiff moves by a little less than half; where
  // nothing but the held back resists, by half.
  double largest_mm = 0;
  for (std::size_t p = 0; p < rest.size(); ++p) largest_mm = std::max(largest_mm, (before[p] - rest[p]).norm());
  ASSERT_GT(largest_mm, 1.0);
  const PatientModel stiff = read_model(open()).value();
  EXPECT_EQ(youngs_kPa(stiff).front(), 12.0);
  rehearsal::RehearsalSetup by_hand = rehearsal_setup(read_model_before_evidence(open()).value());
  for (double& youngs_kPa : by_hand.patient_youngs_kPa) youngs_kPa *= 2;
  const auto expected = rehearsal::StaticRehearsal::create(by_hand)
                            ->place_tool({60, 0, 30}, 15)
                            ->answer({0, -0.5, 0.3})
                            .patient.surface_mm;
  for (std::size_t p = 0; p < rest.size(); ++p) EXPECT_EQ(after[p], expected[p]);

  Case again = open();
  ASSERT_TRUE(take_back_evidence(again));
  EXPECT_EQ(retracted(open()), before);  // to the bit
  EXPECT_FALSE(fs::exists(folder_ / "evidence/model.json"));
}

// The patient alone, and with large deformations alone.
TEST_F(EvidenceTest, StrainStiffeningComesIntoTheSessionAtLargeStrain) {
  Case patient = open();
  const Json stiffens{{"kind", "strain-stiffening"}, {"law", "yeoh"}, {"parameters", {{"coefficient", 30.0}}}};
  ASSERT_TRUE(accept(patient, model({stiffens})));
  const auto largest_mm = [&](mechanics::MaterialLaw law, bool stiffened) {
    auto setup = rehearsal::with_law(rehearsal_setup(read_model(patient).value()), law);
    EXPECT_TRUE(setup.patient_stiffening);
    if (!stiffened) setup.patient_stiffening.reset();
    setup.reference_youngs_kPa = 6.0;
    auto engine = rehearsal::SessionEngine::create(std::move(setup)).value();
    const mechanics::ContactTool probe{
        "probe", mechanics::TouchingTool{mechanics::palpation_probe(10),
                                         mechanics::pose_towards({20, 30, 90}, {0, 0, -1}), 2500.0}};
    const rehearsal::SessionState state = engine.step(rehearsal::HoldTool{probe});
    EXPECT_EQ(state.refused, "");
    return std::pair(state.patient.max_displacement_mm, state.reference->max_displacement_mm);
  };
  const auto with = largest_mm(mechanics::MaterialLaw::neo_hookean, true);
  const auto without = largest_mm(mechanics::MaterialLaw::neo_hookean, false);
  EXPECT_LT(with.first, 0.95 * without.first);
  EXPECT_EQ(with.second, without.second);
  EXPECT_EQ(largest_mm(mechanics::MaterialLaw::linear, true), largest_mm(mechanics::MaterialLaw::linear, false));
  mechanics::Scenario scenario;
  scenario.material = mechanics::MaterialLaw::veronda_westmann;
  PatientModel stiffening = read_model(patient).value();
  put_into(scenario, stiffening);
  EXPECT_GT(scenario.strain_stiffening, 1);
  mechanics::Scenario linear;
  const auto said = put_into(linear, stiffening);
  EXPECT_THAT(said.front().message(), testing::HasSubstr("Only the material veronda-westmann stiffens"));
}

// What a rehearsal holds for long stays long; a motion takes over how the organ gets there, from its moduli at once.
TEST_F(EvidenceTest, CreepComesIntoAMotionAndLeavesAnEquilibriumAsItWas) {
  Case patient = open();
  ASSERT_TRUE(accept(patient, model({effect("viscoelastic-creep", {{"amplitude", 0.5}, {"time_s", 3.0}})})));
  const PatientModel long_held = read_model(patient).value();
  EXPECT_NEAR(youngs_kPa(long_held).front(), 6.0 / 1.5, 1e-12);

  mechanics::Scenario still;
  PatientModel of_still = long_held;
  EXPECT_THAT(put_into(still, of_still).front().message(), HasSubstr("relaxes on the way there, with times of 2 s"));
  EXPECT_TRUE(still.relaxation.empty());
  EXPECT_EQ(youngs_kPa(of_still), youngs_kPa(long_held));

  mechanics::Scenario moving;
  moving.motion = mechanics::Motion{0.1, 10};
  PatientModel of_moving = long_held;
  put_into(moving, of_moving);
  ASSERT_THAT(moving.relaxation, SizeIs(1));
  EXPECT_NEAR(moving.relaxation[0].weight, 0.5 / 1.5, 1e-12);
  EXPECT_NEAR(moving.relaxation[0].time_s, 3.0 / 1.5, 1e-12);
  EXPECT_NEAR(youngs_kPa(of_moving).front(), 6.0, 1e-12);

  for (const bool own_modulus : {true, false}) {
    mechanics::Scenario own;
    own.motion = moving.motion;
    if (own_modulus) own.youngs_modulus = 5.0;
    if (!own_modulus) own.relaxation = {{0.1, 1.0}};
    PatientModel of_own = long_held;
    EXPECT_THAT(put_into(own, of_own).front().message(), HasSubstr("The scenario says itself how"));
    EXPECT_THAT(own.relaxation, SizeIs(own_modulus ? 0 : 1));
    if (!own_modulus) {
      EXPECT_NEAR(youngs_kPa(of_own).front(), 6.0, 1e-12);  // which the scenario's relaxation is of
    }
  }
}

TEST_F(EvidenceTest, TheCaseSaysWhereItIsFrom) {
  Case patient = open();
  const fs::path file = model({scaled});
  ASSERT_TRUE(accept(patient, file));
  const Entry* entry = open().find("evidence/model");
  const Case opened = open();
  entry = opened.find("evidence/model");
  ASSERT_NE(entry, nullptr);
  EXPECT_EQ(entry->made.by, "accept");
  EXPECT_EQ(entry->made.options.at("effects"), "stiffness-scale");
  EXPECT_EQ(entry->made.sources.begin()->second, sha256_of_file(file).value());
  EXPECT_TRUE(entry->from_sha256.contains("meshes/model"));
  EXPECT_EQ(opened.freshness("evidence/model"), Freshness::current);
}

TEST_F(EvidenceTest, OneEffectIsTakenBackAndTheOtherStays) {
  Case patient = open();
  ASSERT_TRUE(accept(patient, model({scaled, skin})));
  EXPECT_TRUE(read_model(open())->capsule.has_value());
  const auto left = take_back_evidence(patient, {"stiffness-scale"});
  ASSERT_TRUE(left) << left.error().message();
  ASSERT_THAT(left->effects, SizeIs(1));
  const PatientModel model_now = read_model(open()).value();
  EXPECT_EQ(youngs_kPa(model_now).front(), 6.0);
  EXPECT_NEAR(model_now.capsule->youngs_modulus_kPa * model_now.capsule->thickness_mm, 500, 1e-9);  // mN/mm
  EXPECT_EQ(take_back_evidence(patient, {"stiffness-scale"}).error().code, "effect-missing");
  ASSERT_TRUE(take_back_evidence(patient, {"capsule"}));
  EXPECT_EQ(open().find("evidence/model"), nullptr);
}

TEST_F(EvidenceTest, AnotherModelTakesItsPlace) {
  Case patient = open();
  ASSERT_TRUE(accept(patient, model({scaled})));
  ASSERT_TRUE(accept(patient, model({skin})));
  EXPECT_EQ(youngs_kPa(read_model(open()).value()).front(), 6.0);
  EXPECT_TRUE(read_model(open())->capsule.has_value());
}

TEST_F(EvidenceTest, WhatIsRefusedLeavesTheCaseAsItWas) {
  Case patient = open();
  const std::string before = read_text_file(folder_ / "case.json").value();
  EXPECT_EQ(accept(patient, model({})).error().code, "evidence-empty");
  EXPECT_EQ(accept(patient, model({effect("stiffness-scale", {{"factor", 0.0}})})).error().code, "model-invalid");
  EXPECT_EQ(accept(patient, model({scaled}), {"capsule"}).error().code, "effect-missing");
  EXPECT_FALSE(accept(patient, temporary_.path() / "no-such.json"));
  EXPECT_EQ(read_text_file(folder_ / "case.json").value(), before);
  EXPECT_FALSE(fs::exists(folder_ / "evidence/model.json"));
  Case empty = Case::create(temporary_.path() / "empty.glisson").value();
  EXPECT_EQ(accept(empty, model({scaled})).error().code, "case-lacks-entry");
}

TEST_F(EvidenceTest, OnlyThisPatientsTissueIsTakenForIt) {
  Case patient = open();
  const std::string before = read_text_file(folder_ / "case.json").value();
  const auto refused = accept_evidence(patient, model({scaled}, "explained", {{"title", "Silicone EF10_75T"}}));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, "evidence-not-this-patient");
  EXPECT_THAT(refused.error().message(), HasSubstr("Silicone EF10_75T"));
  EXPECT_THAT(refused.error().message(), HasSubstr("patient"));
  EXPECT_EQ(read_text_file(folder_ / "case.json").value(), before);
  EXPECT_TRUE(accept_evidence(patient, model({scaled}, "explained", {{"title", "Biopsy of Patient, 2026"}})));
  // The block itself: its box and volume are the organ's.
  const Json place{{"min_mm", {0, 0, 0}}, {"max_mm", {90, 60, 60}}, {"volume_mm3", 324000}};
  EXPECT_TRUE(accept_evidence(patient, model({scaled}, "explained", {{"title", "A pad"}, {"specimen", place}})));
  EXPECT_FALSE(is_of_patient({"Outpatients' pads", false}, "patient"));
}

TEST_F(EvidenceTest, NothingIsAcceptedThatChangesNothing) {
  Case patient = open();
  const std::string before = read_text_file(folder_ / "case.json").value();
  for (const auto& refused : {accept(patient, model({bias})), accept(patient, model({scaled, bias}), {"force-bias"})}) {
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, "evidence-without-effect");
    EXPECT_THAT(refused.error().message(), HasSubstr("leaves the organ as it is"));
  }
  EXPECT_EQ(read_text_file(folder_ / "case.json").value(), before);
}

TEST_F(EvidenceTest, DamagedEvidenceIsSaidWithWhatToDo) {
  Case patient = open();
  ASSERT_TRUE(accept(patient, model({scaled})));
  std::ofstream(folder_ / "evidence/model.json") << "{}";
  const auto read = read_model(open());
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, "evidence-damaged");
  EXPECT_THAT(read.error().advice(), HasSubstr("--take-back"));
  ASSERT_TRUE(take_back_evidence(patient));
  EXPECT_TRUE(read_model(open()));
}

TEST_F(EvidenceTest, AModelMadeAnewIsRemarkedOn) {
  Case patient = open();
  ASSERT_TRUE(accept(patient, model({scaled})));
  geometry::TetMesh mesh = read_model_before_evidence(patient)->mesh;
  geometry::set_field(mesh.cell_fields,
                      {mechanics::youngs_modulus_field, 1, std::vector<double>(mesh.cells.size(), 7.0)});
  ASSERT_TRUE(patient.add("meshes/model", ".vtu", {"stiffness", {}, {}, {}, {}},
                          [&](const fs::path& file) { return geometry::write_tetrahedra(file, mesh); }));
  const PatientModel now = read_model(open()).value();
  EXPECT_EQ(youngs_kPa(now).front(), 14.0);
  ASSERT_THAT(now.evidence.remarks, SizeIs(1));
  EXPECT_THAT(now.evidence.remarks.front().message(), HasSubstr("made anew"));
}

TEST_F(EvidenceTest, WhatAScenarioSaysItselfStandsAndThatIsSaid) {
  Case patient = open();
  ASSERT_TRUE(accept(patient, model({scaled, skin, effect("support-compliance", {{"foundation_kPa_per_mm", 0.5}}),
                                     effect("anisotropy", {{"axis", {0, 0, 1}}, {"ratio", 2.0}})})));
  PatientModel model_now = read_model(patient).value();
  mechanics::Scenario plain;
  const auto carried = put_into(plain, model_now);
  ASSERT_THAT(carried, SizeIs(4));
  EXPECT_TRUE(plain.capsule && plain.anisotropy);
  EXPECT_TRUE(std::holds_alternative<mechanics::Foundation>(plain.supports.front().how));

  mechanics::Scenario own;
  own.material = mechanics::MaterialLaw::neo_hookean;
  own.youngs_modulus = 5.0;
  own.supports = {{geometry::Box{{-1, 50, -1}, {91, 61, 61}}, mechanics::Fixed{}}};
  own.capsule = mechanics::Capsule{.thickness_mm = 0.01};
  const auto said = put_into(own, model_now);
  ASSERT_THAT(said, SizeIs(4));
  for (const Sentence& sentence : said) EXPECT_THAT(sentence.message(), HasSubstr("is left out"));
  EXPECT_TRUE(std::holds_alternative<mechanics::Fixed>(own.supports.front().how));
  EXPECT_EQ(own.capsule->thickness_mm, 0.01);
  EXPECT_FALSE(own.anisotropy);
}

}  // namespace
}  // namespace glisson::casefile

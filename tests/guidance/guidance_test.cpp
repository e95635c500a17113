// Placing an organ in a camera's frame: bodies whose place is known in closed form, livers deformed by CalculiX, and
// files that cannot be answered.

#include <gmock/gmock.h>
#include <fstream>

#include "base/files.h"
#include "base/json.h"
#include "geometry/mesh_file.h"
#include "guidance/guidance_answer.h"
#include "guidance/guidance_file.h"
#include "support/data.h"
#include "support/egg.h"

namespace glisson::guidance {
namespace {

namespace fs = std::filesystem;
using Eigen::Isometry3d;
using Eigen::Vector3d;

TEST(ElasticRegistration, ARigidOrganIsPlacedAndNoDeformationInvented) {
  const geometry::TetMesh mesh = egg();
  const auto modes = ForceModes::create(mesh, std::vector<double>(mesh.cells.size(), 5.0), 0.45);
  ASSERT_TRUE(modes) << modes.error().message();
  SeenFrame frame = half_seen(mesh, somewhere());
  Isometry3d guess = somewhere();
  guess.rotate(Eigen::AngleAxisd(0.08, Vector3d(0, 1, 1).normalized()));
  guess.pretranslate(Vector3d(4, -3, 5));
  const auto targets = mechanics::locate_points(mesh, {Vector3d(0, 0, 0), Vector3d(15, 5, -10), Vector3d(-20, 0, 5)});
  const ElasticPlacement placed = register_elastic(*modes, frame, guess, targets);
  ASSERT_TRUE(placed.converged) << placed.why_not.message();
  EXPECT_LT(placed.elastic_rms_mm, 0.3);
  EXPECT_LT((placed.target_mm[0] - somewhere() * Vector3d(0, 0, 0)).norm(), 0.5);
  EXPECT_LT((placed.target_mm[1] - somewhere() * Vector3d(15, 5, -10)).norm(), 0.5);
  EXPECT_NEAR(placed.residual_rms_mm, 0.4, 0.15);
  EXPECT_GT(placed.visible_share, 0.4);
}

TEST(ForceModes, AreBalancedAndWithoutRigidPart) {
  const geometry::TetMesh mesh = egg();
  const auto modes =
      ForceModes::create(mesh, std::vector<double>(mesh.cells.size(), 5.0), 0.45, {.patches = 12, .supports = {}});
  ASSERT_TRUE(modes);
  ASSERT_EQ(modes->displacement_mm().cols(), 36);
  Eigen::RowVectorXd mean = Eigen::RowVectorXd::Zero(36);
  double volume = 0;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const double quarter = geometry::cell_volume_mm3(mesh, c) / 4;
    volume += 4 * quarter;
    for (const int p : mesh.cells[c]) mean += quarter * modes->displacement_mm().row(3 * p);
  }
  EXPECT_LT(mean.cwiseAbs().maxCoeff() / volume, 1e-8);
}

TEST(Guidance, LiversDeformedByCalculixAreFoundBetterThanByTheBestRigidMotion) {
  GLISSON_NEEDS_DATA("guidance_examples");
  for (const char* example : {"example-a", "example-b", "example-d"}) {
    const fs::path folder = test::shared_data() / "guidance_examples" / example;
    const auto guidance = read_guidance(folder / "guidance.json");
    ASSERT_TRUE(guidance) << guidance.error().message();
    const auto answered = answer(*guidance);
    ASSERT_TRUE(answered) << answered.error().message();
    const Json truth = read_json_file(folder / "truth.json").value();
    for (std::size_t f = 0; f < answered->frames.size(); ++f) {
      const ElasticPlacement& placed = answered->frames[f].placement;
      ASSERT_TRUE(placed.converged) << placed.why_not.message();
      double sum = 0;
      for (std::size_t t = 0; t < placed.target_mm.size(); ++t) {
        const Json& at = truth["frames"][f]["targets"][t];
        ASSERT_EQ(at["id"].get<std::string>(), guidance->targets[t].id);
        const auto& p = at["position_mm"];
        sum += (placed.target_mm[t] - Vector3d(p[0].get<double>(), p[1].get<double>(), p[2].get<double>())).norm();
      }
      const double best_rigid_mm = truth["frames"][f]["best_rigid_tre_mm"]["mean"].get<double>();
      EXPECT_LT(sum / static_cast<double>(placed.target_mm.size()), 0.95 * best_rigid_mm)
          << example << ' ' << answered->frames[f].id;
    }
  }
}

TEST(Guidance, WithoutAGuessTheFeaturesSayWhereARigidLiverLies) {
  GLISSON_NEEDS_DATA("guidance_examples");
  const fs::path folder = test::shared_data() / "guidance_examples" / "example-c";
  const auto guidance = read_guidance(folder / "guidance.json");
  ASSERT_TRUE(guidance) << guidance.error().message();
  ASSERT_FALSE(guidance->frames.front().pose_guess);
  const auto answered = answer(*guidance);
  ASSERT_TRUE(answered);
  const Json truth = read_json_file(folder / "truth.json").value();
  for (std::size_t f = 0; f < answered->frames.size(); ++f) {
    const ElasticPlacement& placed = answered->frames[f].placement;
    ASSERT_TRUE(placed.converged) << placed.why_not.message();
    const auto& p = truth["frames"][f]["targets"][0]["position_mm"];
    EXPECT_LT((placed.target_mm[0] - Vector3d(p[0].get<double>(), p[1].get<double>(), p[2].get<double>())).norm(), 1.0);
  }
}

// ---- What cannot be answered ----

class BadGuidance : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(geometry::write_tetrahedra(folder_.path() / "egg.vtu", egg()));
    write("targets.csv", "id,x_mm,y_mm,z_mm\nt1,0,0,0\n");
    write_cloud(1.0);
  }
  void write(const char* name, const std::string& text) { std::ofstream(folder_.path() / name) << text; }
  void write_cloud(double scale) {
    const SeenFrame frame = half_seen(egg(), Isometry3d::Identity());
    std::ostringstream text;
    text << "ply\nformat ascii 1.0\nelement vertex " << frame.points_mm.size()
         << "\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
    for (const Vector3d& point : frame.points_mm) text << (scale * point).transpose() << '\n';
    write("f0.ply", text.str());
  }
  Json document() {
    return {{"format", "glisson-guidance/1"},
            {"model", {{"mesh", "egg.vtu"}, {"youngs_modulus_kPa", 5.0}}},
            {"frames",
             {{{"id", "f0"}, {"points", "f0.ply"}, {"pose_guess", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}}}},
            {"targets", "targets.csv"}};
  }
  Result<GuidanceCase> read(const Json& json) {
    write("guidance.json", json.dump());
    return read_guidance(folder_.path() / "guidance.json");
  }
  TemporaryFolder folder_;
};

TEST_F(BadGuidance, AGoodOneIsReadAndAnswered) {
  const auto guidance = read(document());
  ASSERT_TRUE(guidance) << guidance.error().message();
  const auto answered = answer(*guidance);
  ASSERT_TRUE(answered);
  EXPECT_TRUE(answered->frames[0].placement.converged) << answered->frames[0].placement.why_not.message();
  ASSERT_TRUE(write_answer(folder_.path() / "out", *guidance, *answered));
  EXPECT_TRUE(fs::exists(folder_.path() / "out" / "f0.vtu"));
  const Json written = read_json_file(folder_.path() / "out" / "guidance.json").value();
  EXPECT_EQ(written["frames"][0]["pose"].size(), 16u);
  EXPECT_EQ(written["frames"][0]["targets"][0]["id"], "t1");
}

TEST_F(BadGuidance, ACloudInMetresIsNotAnswered) {
  write_cloud(1e-3);
  const auto answered = answer(read(document()).value());
  ASSERT_TRUE(answered);
  EXPECT_FALSE(answered->frames[0].placement.converged);
  EXPECT_THAT(answered->frames[0].placement.why_not.message(), ::testing::HasSubstr("metres"));
  EXPECT_TRUE(answered->frames[0].placement.target_mm.empty());
}

// Names exchanged, each line is seen where the other one is.
TEST(Guidance, FeaturesThatContradictEachOtherAreNotAnswered) {
  GLISSON_NEEDS_DATA("guidance_examples");
  for (const char* example : {"example-b", "example-c"}) {
    auto guidance = read_guidance(test::shared_data() / "guidance_examples" / example / "guidance.json").value();
    guidance.frames.resize(1);
    auto& curves = guidance.frames[0].curves;
    ASSERT_GE(curves.size(), 2u);
    std::swap(curves[0].seen_mm, curves[1].seen_mm);
    const auto answered = answer(guidance).value();
    EXPECT_FALSE(answered.frames[0].placement.converged) << example;
    EXPECT_FALSE(answered.frames[0].placement.why_not.message().empty());
    EXPECT_TRUE(answer_json(guidance, answered)["frames"][0]["targets"].empty());
  }
}

TEST(Guidance, ALiverSeenInAMirrorIsNotAnsweredThoughAGuessIsGiven) {
  GLISSON_NEEDS_DATA("guidance_examples");
  auto guidance = read_guidance(test::shared_data() / "guidance_examples/example-b/guidance.json").value();
  guidance.frames.resize(1);
  guidance.frames[0].curves.clear();
  for (Vector3d& point : guidance.frames[0].points_mm) point[0] = -point[0];
  const auto answered = answer(guidance).value();
  EXPECT_FALSE(answered.frames[0].placement.converged);
}

TEST(Guidance, AFeatureOfAnotherLiverIsNotAnswered) {
  GLISSON_NEEDS_DATA("guidance_examples");
  auto guidance = read_guidance(test::shared_data() / "guidance_examples/example-d/guidance.json").value();
  guidance.mesh = read_guidance(test::shared_data() / "guidance_examples/example-b/guidance.json").value().mesh;
  guidance.youngs_kPa.assign(guidance.mesh.cells.size(), 5.0);
  const auto answered = answer(guidance).value();
  EXPECT_THAT(answered.frames[0].placement.why_not.message(), ::testing::HasSubstr("from the organ at rest"));
}

// The cloud of one, begun where its liver lies, on the model of another: no feature says that they differ. Each of
// these is bent by less than what no liver is believed to be bent by.
TEST(Guidance, AnotherPatientsLiverIsToldThoughItCanBeBentIntoTheCloud) {
  GLISSON_NEEDS_DATA("guidance_examples");
  const auto example = [](const std::string& name) {
    return read_guidance(test::shared_data() / "guidance_examples" / name / "guidance.json").value();
  };
  const auto middle = [](const GuidanceCase& of) {
    Vector3d sum(0, 0, 0);
    for (const Vector3d& point : of.mesh.points_mm) sum += point;
    return Vector3d(sum / static_cast<double>(of.mesh.points_mm.size()));
  };
  struct Confused {
    const char *seen, *declared;
    std::size_t frame;
  };
  for (const auto& [seen, declared, frame] : {Confused{"example-d", "example-c", 0}, {"example-a", "example-b", 1}}) {
    GuidanceCase guidance = example(declared);
    const GuidanceCase right = example(seen);
    guidance.frames = {right.frames[frame]};
    SeenFrame& only = guidance.frames[0];
    only.curves.clear();
    only.pose_guess = only.pose_guess->translate(middle(right) - middle(guidance));
    const auto answered = answer(guidance).value();
    EXPECT_FALSE(answered.frames[0].placement.converged) << seen << " on " << declared;
    EXPECT_THAT(answered.frames[0].placement.why_not.message(), ::testing::HasSubstr("another patient's"));
    EXPECT_TRUE(answer_json(guidance, answered)["frames"][0]["targets"].empty());
  }
}

TEST_F(BadGuidance, AMirroringPoseAnUnknownFeatureAndAFrameWithoutAnyHintAreRefused) {
  Json mirrored = document();
  mirrored["frames"][0]["pose_guess"][0] = -1;
  Json unknown = document();
  unknown["frames"][0]["features"] = {{{"id", "ridge"}, {"points", "ridge.csv"}}};
  Json lost = document();
  lost["frames"][0].erase("pose_guess");
  Json escaping = document();
  escaping["frames"][0]["id"] = "../f0";
  for (const Json& json : {mirrored, unknown, lost, escaping}) {
    const auto refused = read(json);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, "guidance-invalid");
    EXPECT_FALSE(refused.error().file.empty());
  }
}

TEST_F(BadGuidance, SupportsThatNameNothingOrLackTheirSizeAreRefusedAndLigamentsAreSaidToBeUnused) {
  Json json = document();
  json["supports"] = {{{"sphere", {{"center_mm", {0, 0, 0}}}}}};
  EXPECT_THAT(read(json).error().message(), ::testing::HasSubstr("radius_mm"));
  json["supports"] = {{{"point_array", "nothing"}}};
  const auto unnamed = answer(read(json).value());
  ASSERT_FALSE(unnamed);
  EXPECT_THAT(unnamed.error().message(), ::testing::HasSubstr("nothing"));
  json["supports"] = {{{"sphere", {{"center_mm", {40, 0, 0}}, {"radius_mm", 15}}}},
                      {{"sphere", {{"center_mm", {-30, 0, 0}}, {"radius_mm", 15}}},
                       {"ligament", {{"anchor_mm", {-60, 0, 0}}, {"stiffness_N_per_mm", 0.1}}}}};
  const auto guidance = read(json);
  ASSERT_TRUE(guidance) << guidance.error().message();
  EXPECT_EQ(guidance->supports.size(), 1u);
  ASSERT_EQ(guidance->notes.size(), 1u);
  EXPECT_THAT(guidance->notes[0], ::testing::HasSubstr("Ligaments"));
}

TEST_F(BadGuidance, AnotherFormatATextForANumberAndABrokenTargetSayWhatIsWrong) {
  Json other = document();
  other["format"] = 1;
  EXPECT_EQ(read(other).error().code, "guidance-invalid");
  Json text = document();
  text["frames"][0]["noise_mm"] = "half";
  EXPECT_EQ(read(text).error().code, "guidance-invalid");
  write("targets.csv", "id,x_mm,y_mm,z_mm\nt1,0,zero,0\n");
  EXPECT_THAT(read(document()).error().message(), ::testing::HasSubstr("2"));
}

}  // namespace
}  // namespace glisson::guidance

// glisson-cli shapes: a cut-off ellipsoid completed, livers drawn and taken up again, and what is refused; segment
// --shapes: a liver found in a SIMULATED image.

#include <gmock/gmock.h>
#include <filesystem>

#include "anatomy/patient.h"
#include "base/files.h"
#include "base/json.h"
#include "ellipsoids.h"
#include "geometry/mesh_file.h"
#include "imaging/volume_file.h"
#include "segmentation/structures.h"
#include "shapes/model_file.h"
#include "shapes/smooth_model.h"
#include "simulated_abdomen.h"
#include "support/process.h"
#include "vasculature/tree_file.h"

namespace glisson::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class ShapesCommand : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(shapes::write_model(model(), shapes::honest_model(ellipsoids(30)).value()));
    geometry::Surface cut = ellipsoid({1, 0, -1});
    for (Eigen::Vector3d& point : cut.points_mm) point.z() = std::min(point.z(), 25.0);
    ASSERT_TRUE(geometry::write_surface(room_.path() / "cut.vtp", cut));
  }
  [[nodiscard]] std::string model() const { return (room_.path() / "model.vtp").string(); }
  [[nodiscard]] std::string file(const char* name) const { return (room_.path() / name).string(); }

 private:
  TemporaryFolder room_;
};

}  // namespace

TEST_F(ShapesCommand, CompletesAFlatEnd) {
  const Finished done =
      glisson_cli({"shapes", "complete", model(), file("cut.vtp"), "--out", file("whole.vtp"), "--json"});
  ASSERT_EQ(done.exit_code, 0) << done.err;
  const Json document = Json::parse(done.out);
  const double true_ml = geometry::volume_mm3(ellipsoid({1, 0, -1})) / 1000;
  EXPECT_NEAR(document["volume_ml"].get<double>(), true_ml, 0.06 * true_ml);
  EXPECT_GT(document["unseen_mean_sd_mm"].get<double>(), 1);
  EXPECT_LT(document["seen_fraction"].get<double>(), 0.9);
  const auto whole = geometry::read_surface(file("whole.vtp")).value();
  EXPECT_TRUE(is_watertight(whole));
  EXPECT_NE(geometry::find_field(whole.point_fields, "sd_mm"), nullptr);
}

TEST_F(ShapesCommand, RefusesWhatIsNoModelAndWhatIsNoLiverOfIt) {
  const Finished no_model =
      glisson_cli({"shapes", "complete", file("cut.vtp"), file("cut.vtp"), "--out", file("whole.vtp")});
  EXPECT_EQ(no_model.exit_code, 1);
  EXPECT_THAT(no_model.err, HasSubstr("no shape model"));
  geometry::Surface flat = unit_sphere();
  for (Eigen::Vector3d& point : flat.points_mm) point = {150 * point.x(), 25 * point.y(), 110 * point.z()};
  ASSERT_TRUE(geometry::write_surface(file("flat.vtp"), flat));
  const Finished outside = glisson_cli({"shapes", "complete", model(), file("flat.vtp"), "--out", file("whole.vtp")});
  EXPECT_EQ(outside.exit_code, 1);
  EXPECT_THAT(outside.err, HasSubstr("flat.vtp"));
  EXPECT_FALSE(fs::exists(file("whole.vtp")));
}

TEST_F(ShapesCommand, DrawsSimulatedLiversAndGoesOn) {
  const std::vector<std::string> words{"shapes", "draw",  model(),          "--count", "2",
                                       "--seed", "3",     "--target-cells", "800",     "--vessels",
                                       "none",   "--out", file("drawn"),    "--json"};
  const Finished done = glisson_cli(words);
  ASSERT_EQ(done.exit_code, 0) << done.err;
  EXPECT_EQ(Json::parse(done.out)["livers"], 2);
  EXPECT_EQ(Json::parse(done.out)["simulated"], true);
  EXPECT_THAT(read_text_file(fs::path(file("drawn")) / "SIMULATED.txt").value(), HasSubstr("SIMULATED"));
  const fs::path second = fs::path(file("drawn")) / "simulated-00002.vtu";
  const auto mesh = geometry::read_tetrahedra(second).value();
  const geometry::Field* stiffness = geometry::find_field(mesh.cell_fields, "youngs_modulus_kPa");
  ASSERT_NE(stiffness, nullptr);
  for (const double kPa : stiffness->values) EXPECT_GT(kPa, 0);
  const std::string before = sha256_of_file(second).value();
  fs::remove(second);
  const Finished again = glisson_cli(words);
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(Json::parse(again.out)["reused"], 1);
  EXPECT_EQ(sha256_of_file(second).value(), before);
}

TEST_F(ShapesCommand, DrawnLiversHaveVesselsThatReadAsAnyTrees) {
  ASSERT_TRUE(shapes::write_model(file("smooth.vtp"), shapes::smooth_model({.reference_spacing_mm = 9}).value()));
  const auto draw = [&](const std::string& model_file, const std::string& spacing_mm) {
    return glisson_cli({"shapes", "draw", model_file, "--count", "1", "--target-cells", "800", "--out", file("drawn"),
                        "--reference-spacing-mm", spacing_mm, "--json"});
  };
  for (const auto& [of, spacing_mm] : {std::pair{model(), "7"}, std::pair{file("smooth.vtp"), "7"}}) {
    const Finished other = draw(of, spacing_mm);  // ellipsoids, and a model of another spacing
    EXPECT_EQ(other.exit_code, 1);
    EXPECT_THAT(other.err, HasSubstr("draw without vessels"));
    EXPECT_THAT(other.err, HasSubstr(fs::path(of).filename().string()));
  }
  const Finished done = draw(file("smooth.vtp"), "9");
  ASSERT_EQ(done.exit_code, 0) << done.err;
  const fs::path trees_file = fs::path(file("drawn")) / "simulated-00001_trees.json";
  const auto trees = vasculature::read_trees(trees_file);
  ASSERT_TRUE(trees) << trees.error().message();
  EXPECT_GT(trees->branches.size(), 500u);
  EXPECT_THAT(read_json_file(trees_file).value()["simulated"].get<std::string>(), HasSubstr("SIMULATED"));
  const auto mesh = geometry::read_tetrahedra(fs::path(file("drawn")) / "simulated-00001.vtu").value();
  const geometry::Box box = geometry::bounding_box(mesh.points_mm);
  for (const auto& branch : trees->branches) {
    EXPECT_TRUE((branch.points.back().position_mm.array() >= box.min_mm.array()).all());
    EXPECT_TRUE((branch.points.back().position_mm.array() <= box.max_mm.array()).all());
  }
  fs::remove(trees_file);
  ASSERT_EQ(draw(file("smooth.vtp"), "9").exit_code, 0);
  EXPECT_TRUE(fs::exists(trees_file));
}

TEST_F(ShapesCommand, AFolderWithoutLiversIsSaid) {
  fs::create_directories(file("empty"));
  const Finished none = glisson_cli({"study", "shapes", file("empty"), "--out", file("out")});
  EXPECT_EQ(none.exit_code, 1);
  EXPECT_THAT(none.err, HasSubstr("no label maps"));
}

TEST_F(ShapesCommand, SegmentFindsTheLiverWithoutAPoint) {
  anatomy::PatientOptions options;
  options.seed = 5;
  const auto made = simulated_abdomen(anatomy::make_liver_surface(options, 4).value(), Looks::portal_ct, 2, 4);
  ASSERT_TRUE(imaging::write_volume_file(file("ct.nrrd"), made.image));
  ASSERT_EQ(glisson_cli({"import", file("ct.nrrd"), "--case", file("p.glisson")}).exit_code, 0);
  const std::vector<std::string> segment{"segment", file("p.glisson"), "--structure", "liver", "--json"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), segment.begin(), segment.end());
    return glisson_cli(more);
  };
  for (const std::vector<std::string>& how : {std::vector<std::string>{}, {"--shapes", file("smooth.vtp")}}) {
    if (!how.empty()) {
      ASSERT_TRUE(shapes::write_model(how[1], shapes::smooth_model({.reference_spacing_mm = 11}).value()));
    }
    const Finished done = with(how);
    ASSERT_EQ(done.exit_code, 0) << done.err;
    EXPECT_THAT(done.out, HasSubstr("found without a point"));
    const auto found = imaging::read_mask_file(Json::parse(done.out)["file"].get<std::string>()).value();
    EXPECT_GT(segmentation::dice(found.mask, made.liver).value(), 0.9);
  }
  const Finished no_model = with({"--shapes", file("cut.vtp")});
  EXPECT_EQ(no_model.exit_code, 1);
  EXPECT_THAT(no_model.err, HasSubstr("no shape model"));
  EXPECT_THAT(no_model.err, HasSubstr("cut.vtp"));
  const Finished outside = with({"--shapes", "simulated", "--seed", "5000,0,0"});
  EXPECT_EQ(outside.exit_code, 1);
  EXPECT_THAT(outside.err, HasSubstr("outside the image"));
  const Finished tumour =
      glisson_cli({"segment", file("p.glisson"), "--structure", "tumour-1", "--shapes", "simulated"});
  EXPECT_EQ(tumour.exit_code, 2);
}

}  // namespace glisson::test

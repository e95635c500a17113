// What is told of a model: its cells against an independent measure, what holds it, and that it went stale, and why.

#include "casefile/model_upkeep.h"

#include <gmock/gmock.h>

#include "base/files.h"
#include "base/tissue.h"
#include "base/units.h"
#include "casefile/structures.h"
#include "geometry/mesh_file.h"
#include "mechanics/bodies.h"
#include "segmentation/edit.h"

namespace glisson::casefile {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;

imaging::Mask ball(double radius_mm) {
  imaging::Mask mask;
  mask.grid.size = {20, 20, 20};
  mask.grid.spacing_mm = {3, 3, 3};
  mask.values.resize(mask.grid.voxels());
  return segmentation::paint(std::move(mask), {{30, 30, 30}, radius_mm});
}

class ModelUpkeep : public testing::Test {
 protected:
  void SetUp() override {
    auto patient = Case::create(folder_);
    ASSERT_TRUE(patient);
    outline(15);
    auto opened = open();
    geometry::TetMesh mesh = mechanics::test::box(6, 4, 4, {90, 60, 60});
    mechanics::test::disturb_inner_points(mesh, 3.0);
    mechanics::test::name_points(mesh, "bare_area", [](const Eigen::Vector3d& p) { return p.y() == 60; });
    mechanics::test::name_points(mesh, "diaphragm", [](const Eigen::Vector3d& p) { return p.z() == 60; });
    ASSERT_TRUE(opened.add("meshes/liver", ".vtu", {"mesh", {{"target-cells", "600"}}, {"labels/liver"}, {}, {}},
                           [&](const fs::path& file) { return geometry::write_tetrahedra(file, mesh); }));
    mesh_ = mesh;
    ASSERT_TRUE(assign_stiffness(opened, Uniform{5.0}));
  }
  Case open() { return Case::open(folder_).value(); }
  void outline(double radius_mm) {
    auto patient = open();
    ASSERT_TRUE(
        save_structure(patient, segmentation::make_structure("liver", ball(radius_mm)), {"segment", {}, {}, {}, {}}));
  }

  TemporaryFolder temporary_;
  fs::path folder_ = temporary_.path() / "patient.glisson";
  geometry::TetMesh mesh_;
};

TEST_F(ModelUpkeep, TellsTheCellsAndWhatHoldsThem) {
  const auto facts = model_facts(open());
  ASSERT_TRUE(facts) << facts.error().message();
  EXPECT_EQ(facts->cells, mesh_.cells.size());
  EXPECT_NEAR(facts->mesh_ml, 324, 1e-6);
  EXPECT_EQ(facts->target_cells, 600);
  EXPECT_DOUBLE_EQ(facts->mean_kPa, 5);
  EXPECT_DOUBLE_EQ(facts->sd_kPa, 0);
  EXPECT_NEAR(facts->label_ml, 4.0 / 3 * 3.14159 * 1.5 * 1.5 * 1.5, 1.0);  // a ball of voxels
  EXPECT_NEAR(area_mm2(facts->held), 90 * 60, 1e-6);
  EXPECT_NEAR(area_mm2(facts->on_springs), 90 * 60, 1e-6);
  ASSERT_EQ(facts->min_dihedral_deg.size(), mesh_.cells.size());
  EXPECT_NEAR(*std::min_element(facts->min_dihedral_deg.begin(), facts->min_dihedral_deg.end()),
              geometry::quality(mesh_).min_dihedral_deg, 1e-6);
}

TEST_F(ModelUpkeep, AnOutlineThatChangedMakesTheModelStaleByName) {
  EXPECT_TRUE(model_state(open()).current);
  outline(12);
  const ModelState state = model_state(open());
  EXPECT_TRUE(state.built);
  EXPECT_FALSE(state.current);
  EXPECT_THAT(state.changed, ElementsAre("labels/liver"));
  EXPECT_FALSE(state.changed_outside);
}

TEST_F(ModelUpkeep, AFileThatAnotherProgramWroteIsToldApart) {
  ASSERT_TRUE(geometry::write_tetrahedra(open().file_of("meshes/model").value(), mesh_));
  const ModelState state = model_state(open());
  EXPECT_FALSE(state.current);
  EXPECT_TRUE(state.changed_outside);
}

TEST_F(ModelUpkeep, KnowsWhoseStiffnessItHas) {
  EXPECT_DOUBLE_EQ(std::get<Uniform>(stiffness_choice_of(open())).youngs_kPa, 5);
  for (const auto reference :
       {elastography::PopulationMean::dissertation_cohort, elastography::PopulationMean::published_cohort}) {
    auto patient = open();
    ASSERT_TRUE(assign_stiffness(patient, FromPopulationMean{reference}));
    EXPECT_EQ(std::get<FromPopulationMean>(stiffness_choice_of(patient)).mean, reference);
  }
}

TEST_F(ModelUpkeep, TheShearModulusIsRehearsedWithThePoissonsRatioThatTheMeshWasMadeWith) {
  auto patient = open();
  elastography::StiffnessOptions options;
  options.poisson_ratio = 0.49;
  ASSERT_TRUE(assign_stiffness(patient, FromPopulationMean{}, options));
  const auto setup = rehearsal_setup(read_model(patient).value());
  EXPECT_EQ(setup.options.poisson_ratio, 0.49);
  const double shear_kPa = elastography::population_shear_kPa(elastography::PopulationMean::dissertation_cohort);
  EXPECT_DOUBLE_EQ(setup.patient_youngs_kPa.front(), units::youngs_from_shear(shear_kPa, 0.49));
  // One value that a person states is Young's modulus itself.
  ASSERT_TRUE(assign_stiffness(patient, Uniform{5.0}, options));
  const auto stated = rehearsal_setup(read_model(patient).value());
  EXPECT_EQ(stated.options.poisson_ratio, usual_poisson_ratio);
  EXPECT_EQ(stated.patient_youngs_kPa.front(), 5.0);
}

TEST_F(ModelUpkeep, OnlyTheStiffnessIsGivenAnewWhereTheCellsAreCurrent) {
  auto patient = open();
  const std::string cells_before = patient.find("meshes/liver")->sha256;
  ASSERT_TRUE(bring_model_up_to_date(patient, {std::nullopt, Uniform{9.0}}));
  EXPECT_EQ(patient.find("meshes/liver")->sha256, cells_before);
  EXPECT_DOUBLE_EQ(model_facts(patient)->mean_kPa, 9);
}

}  // namespace
}  // namespace glisson::casefile

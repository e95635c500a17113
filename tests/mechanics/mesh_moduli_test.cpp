// What elastography measured, the shear modulus, stays what it was on the way through a mesh to the mechanics.

#include "mechanics/scenario/mesh_moduli.h"

#include <gmock/gmock.h>
#include <random>

#include "base/files.h"
#include "base/units.h"
#include "geometry/mesh_file.h"
#include "mechanics/bodies.h"
#include "mechanics/simulation.h"

namespace glisson::mechanics {
namespace {

using testing::HasSubstr;

class MeasuredMesh : public testing::Test {
 protected:
  MeasuredMesh() {
    test::name_points(mesh, "fixed", [](const Eigen::Vector3d& p) { return p.z() == 0; });
    std::mt19937 random(1);
    std::uniform_real_distribution<double> stiffness_kPa(1.0, 8.0);
    std::vector<double> youngs_kPa;
    for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
      shear_kPa.push_back(stiffness_kPa(random));
      youngs_kPa.push_back(units::youngs_from_shear(shear_kPa.back(), 0.45));
    }
    set_moduli(mesh, youngs_kPa, 0.45);
    scenario.supports = {test::fixed("fixed")};
    scenario.loads = {ToolLoad{{15, 15, 30}, 8, {20, 0, 50}}};
  }
  // The largest error of a shear modulus, relative to it.
  double error_of(const std::vector<double>& youngs_kPa, double poisson_ratio) const {
    double largest = 0;
    for (std::size_t cell = 0; cell < shear_kPa.size(); ++cell) {
      const double shear = units::shear_from_youngs(youngs_kPa.at(cell), poisson_ratio);
      largest = std::max(largest, std::abs(shear / shear_kPa[cell] - 1));
    }
    return largest;
  }
  geometry::TetMesh mesh = test::box(3, 3, 3, {30, 30, 30});
  std::vector<double> shear_kPa;
  Scenario scenario;
};

TEST_F(MeasuredMesh, AScenarioOfAnotherPoissonsRatioKeepsTheShearModulus) {
  scenario.poisson_ratio = 0.49;
  const auto simulation = simulate(mesh, scenario).value();
  const auto& used_kPa = geometry::find_field(simulation.mesh.cell_fields, youngs_modulus_field)->values;
  EXPECT_LT(error_of(used_kPa, 0.49), 1e-12);
  EXPECT_EQ(poisson_ratio_of(simulation.mesh), 0.49) << "the result's moduli are of the scenario's ratio";
  ASSERT_EQ(simulation.result.notes.size(), 1u);
  EXPECT_THAT(simulation.result.notes[0], HasSubstr("by a Poisson's ratio of 0.45; for 0.49 they are 1.028 times"));

  // As if the moduli had been made for 0.49 in the first place.
  std::vector<double> youngs_kPa;
  for (const double shear : shear_kPa) youngs_kPa.push_back(units::youngs_from_shear(shear, 0.49));
  set_moduli(mesh, youngs_kPa, 0.49);
  const auto direct = simulate(mesh, scenario).value();
  EXPECT_NEAR(direct.result.max_displacement_mm, simulation.result.max_displacement_mm,
              1e-9 * direct.result.max_displacement_mm);
}

TEST_F(MeasuredMesh, TheRatioGoesThroughAFile) {
  const TemporaryFolder folder;
  ASSERT_TRUE(geometry::write_tetrahedra(folder.path() / "model.vtu", mesh));
  const auto read = geometry::read_tetrahedra(folder.path() / "model.vtu").value();
  EXPECT_EQ(poisson_ratio_of(read), 0.45);
  EXPECT_LT(error_of(moduli_of(read, youngs_modulus_field, 0.49)->youngs_kPa, 0.49), 1e-12);
}

TEST_F(MeasuredMesh, ModuliAreTakenAsTheyAreWhereNothingElseIsKnown) {
  const std::vector<double> youngs_kPa = geometry::find_field(mesh.cell_fields, youngs_modulus_field)->values;
  const auto as_made = moduli_of(mesh, youngs_modulus_field, 0.45).value();
  EXPECT_EQ(as_made.youngs_kPa, youngs_kPa);
  EXPECT_FALSE(as_made.note);
  geometry::set_field(mesh.cell_fields, {"mine", 1, youngs_kPa});
  EXPECT_EQ(moduli_of(mesh, "mine", 0.49)->youngs_kPa, youngs_kPa) << "the ratio is not of this field";
  set_moduli(mesh, youngs_kPa, std::nullopt);
  const auto of_an_old_file = moduli_of(mesh, youngs_modulus_field, 0.49).value();
  EXPECT_EQ(of_an_old_file.youngs_kPa, youngs_kPa);
  EXPECT_FALSE(of_an_old_file.note);
}

TEST_F(MeasuredMesh, ARatioThatCannotBeIsRefused) {
  geometry::set_field(mesh.cell_fields, {poisson_ratio_field, 1, std::vector<double>(mesh.cells.size(), -1.0)});
  EXPECT_EQ(moduli_of(mesh, youngs_modulus_field, 0.45).error().code, "poisson-invalid");
}

}  // namespace
}  // namespace glisson::mechanics

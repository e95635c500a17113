// The same mesh, materials and loads in CalculiX, an independent finite element code (ccx, Debian's calculix-ccx).

#include <gtest/gtest.h>
#include <fstream>
#include <iomanip>
#include <sstream>

#include "base/files.h"
#include "mechanics/bodies.h"
#include "mechanics/calculix.h"
#include "mechanics/statics/displacements.h"
#include "mechanics/statics/equilibrium.h"
#include "mechanics/statics/static_model.h"

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;
using test::faces_of_calculix, test::read_displacements, test::run_calculix, test::write_body;

constexpr double poisson_ratio = 0.45;
const Vector3d gravity_mm_s2(1000, 0, -9810);
constexpr double pressure_kPa = 0.3;

bool at_wall(const Vector3d& p) { return p.x() == 0; }

void write_gravity(std::ostream& out, const NodeLayout& layout) {
  for (std::size_t c = 0; c < layout.cells.size(); ++c) {
    out << "E" << c + 1 << ", GRAV, " << gravity_mm_s2.norm();
    for (const double d : gravity_mm_s2.normalized()) out << ", " << d;
    out << "\n";
  }
}

void write_input(const std::filesystem::path& file, const StaticModel& model) {
  const NodeLayout& layout = model.nodes();
  std::ofstream out(file);
  write_body(
      out, layout,
      [&](std::size_t c) {
        std::ostringstream material;
        material << std::setprecision(12) << "*ELASTIC\n" << model.youngs_kPa()[c] << ", " << poisson_ratio << "\n";
        return material.str();
      },
      at_wall);
  out << "*STEP\n*STATIC\n*DLOAD\n";
  write_gravity(out, layout);
  for (const auto& [cell, face] : faces_of_calculix(model.mesh())) {
    out << cell + 1 << ", P" << face << ", " << pressure_kPa << "\n";
  }
  out << "*NODE PRINT, NSET=NALL\nU\n*END STEP\n";
}

geometry::TetMesh crooked_block() {
  auto mesh = test::bent_box(6, 3, 3, [](const Vector3d& unit) {
    return Vector3d(60 * unit.x(), 30 * unit.y() + 6 * unit.x() * unit.x(), 24 * unit.z() * (1 - 0.3 * unit.x()));
  });
  test::disturb_inner_points(mesh, 1.5);
  test::name_points(mesh, "wall", [](const Vector3d& p) { return p.x() == 0; });
  return mesh;
}

std::vector<double> patchy(const geometry::TetMesh& mesh) {
  std::vector<double> youngs_kPa;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) youngs_kPa.push_back(3.0 + 2.5 * (c % 11));
  return youngs_kPa;
}

TEST(AgainstCalculix, TheSameHeterogeneousBodyUnderGravityAndPressureMovesTheSame) {
  GLISSON_NEEDS_CALCULIX();
  const auto mesh = crooked_block();
  const auto youngs_kPa = patchy(mesh);
  StaticOptions options;
  options.poisson_ratio = poisson_ratio;
  const auto model = StaticModel::create(mesh, youngs_kPa, {test::fixed("wall")}, options).value();
  const auto ours = model.solve({GravityLoad{gravity_mm_s2}, PressureLoad{pressure_kPa}}).value();

  const TemporaryFolder folder;
  write_input(folder.path() / "body.inp", model);
  ASSERT_EQ(run_calculix(folder.path()), 0) << read_text_file(folder.path() / "ccx.log").value_or("");
  const auto theirs = read_displacements(folder.path() / "body.dat", model.nodes().nodes());

  double largest_mm = 0;
  for (int n = 0; n < model.nodes().nodes(); ++n) {
    const Vector3d& u = n < model.nodes().corner_nodes ? ours.displacement_mm[n]
                                                       : ours.mid_side_displacement_mm[n - model.nodes().corner_nodes];
    ASSERT_TRUE(theirs[n].allFinite()) << "node " << n + 1;
    largest_mm = std::max(largest_mm, (u - theirs[n]).norm());
  }
  RecordProperty("largest_difference_mm", std::to_string(largest_mm));
  // CalculiX prints seven digits: half a unit of the last is 5e-7 of the value.
  EXPECT_LT(largest_mm, 2e-6 * ours.max_displacement_mm) << "of " << ours.max_displacement_mm << " mm";
}

// CalculiX's neo-Hooke is C10 (I1 - 3) + (J - 1)^2 / D1, which is isochoric.h's with C10 = mu / 2 and D1 = 2 / K.
TEST(AgainstCalculix, TheSameNeoHookeanBodyBendsFarTheSame) {
  GLISSON_NEEDS_CALCULIX();
  const auto mesh = crooked_block();
  const Body body =
      prepare_body(mesh, patchy(mesh), {test::fixed("wall")}, {.poisson_ratio = poisson_ratio}, Holding::required)
          .value();
  std::vector<Material> materials;
  for (const Lame& lame : body.materials) materials.emplace_back(neo_hookean_from(lame));
  const auto ours = find_equilibrium(body, materials, Loads{GravityLoad{gravity_mm_s2}}).value();
  ASSERT_TRUE(ours.may_be_used()) << ours.why_stopped;

  const TemporaryFolder folder;
  {
    std::ofstream out(folder.path() / "body.inp");
    write_body(
        out, body.layout, [&](std::size_t c) { return test::neo_hookean_card(body, c); }, at_wall);
    out << "*STEP, NLGEOM\n*STATIC\n0.25, 1.\n*CONTROLS, PARAMETERS=FIELD\n1e-7, 1e-7\n*DLOAD\n";
    write_gravity(out, body.layout);
    out << "*NODE PRINT, NSET=NALL, FREQUENCY=999\nU\n*END STEP\n";
  }
  ASSERT_EQ(run_calculix(folder.path()), 0) << read_text_file(folder.path() / "ccx.log").value_or("");
  const auto theirs = read_displacements(folder.path() / "body.dat", body.layout.nodes());
  const Eigen::VectorXd u_mm = nodal_displacements(body.layout, ours);
  double largest_mm = 0;
  for (int n = 0; n < body.layout.nodes(); ++n) {
    ASSERT_TRUE(theirs[n].allFinite()) << "node " << n + 1;
    largest_mm = std::max(largest_mm, (u_mm.segment<3>(3 * n) - theirs[n]).norm());
  }
  RecordProperty("largest_difference_mm", std::to_string(largest_mm));
  // Both stop at a residual of 1e-6 of the load or less, and CalculiX prints seven digits.
  EXPECT_GT(ours.max_displacement_mm, 10);  // of a body 60 mm long: far beyond small strain
  EXPECT_LT(largest_mm, 1e-5 * ours.max_displacement_mm) << "of " << ours.max_displacement_mm << " mm";

  // The law that is stable under inversion is another one at large strain: how far apart they are here.
  const auto stable =
      find_equilibrium(body, materials_of(body, MaterialLaw::neo_hookean), Loads{GravityLoad{gravity_mm_s2}}).value();
  double apart_mm = 0;
  for (std::size_t p = 0; p < mesh.points_mm.size(); ++p) {
    apart_mm = std::max(apart_mm, (stable.displacement_mm[p] - ours.displacement_mm[p]).norm());
  }
  RecordProperty("stable_law_differs_by_mm", std::to_string(apart_mm));
  EXPECT_LT(apart_mm, 0.1 * ours.max_displacement_mm);
}

}  // namespace
}  // namespace glisson::mechanics

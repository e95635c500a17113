// The meshfree engine against theory, and against finite elements on the same body.

#include <gmock/gmock.h>
#include <cmath>
#include <Eigen/Geometry>

#include <fmt/format.h>

#include "geometry/mesh_file.h"
#include "mechanics/bodies.h"
#include "mechanics/meshfree/internal/meshfree_body.h"
#include "mechanics/meshfree/internal/meshfree_dynamics.h"
#include "mechanics/meshfree/internal/reduced_matrix.h"
#include "mechanics/meshfree/meshfree_model.h"
#include "mechanics/simulation.h"
#include "mechanics/statics/equilibrium.h"
#include "meshing/mesh_labels.h"
#include "segmentation/rasterise.h"
#include "support/data.h"

namespace glisson::mechanics {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using test::box;
using test::fixed;
using test::held_along;
using test::uniform;
using testing::HasSubstr;

constexpr double fall_mm_s2 = 9810.0;

StaticOptions meshfree_options(double poisson_ratio, double density_kg_mm3 = 1000e-9) {
  StaticOptions options;
  options.poisson_ratio = poisson_ratio;
  options.density_kg_mm3 = density_kg_mm3;
  return options;
}

// A body whose cells are irregular and whose stiffness varies a hundredfold.
struct MottledBody {
  geometry::TetMesh mesh = box(4, 4, 4, {30, 25, 25});
  std::vector<double> youngs_kPa;

  MottledBody() {
    test::disturb_inner_points(mesh, 0.8);
    for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
      youngs_kPa.push_back(std::pow(10.0, 1.0 + std::sin(0.4 * geometry::cell_centroid_mm(mesh, c).x())));
    }
  }
};

MeshfreeBody prepared(const geometry::TetMesh& mesh, const std::vector<double>& youngs_kPa, MaterialLaw law, int nodes,
                      const StaticOptions& options, const std::vector<Support>& supports = {}) {
  auto handles =
      prepare_meshfree_body(mesh, youngs_kPa, supports, law, options, {.nodes = nodes}, {}, Holding::optional);
  EXPECT_TRUE(handles) << handles.error().message();
  return std::move(*handles);
}

TEST(MeshfreeShapeFunctions, SumToOneAndAreNeverNegative) {
  const MottledBody body;
  const auto shape = shape_functions_of(body.mesh, body.youngs_kPa, {.nodes = 25}).value();
  ASSERT_EQ(shape.nodes_mm.size(), 25u);
  for (std::size_t p = 0; p < body.mesh.points_mm.size(); ++p) {
    double sum = 0;
    for (std::size_t k = shape.starts[p]; k < shape.starts[p + 1]; ++k) {
      EXPECT_GE(shape.weights[k], 0.0);
      sum += shape.weights[k];
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);
  }
}

TEST(MeshfreeShapeFunctions, AlongABarFallStraightWithTheComplianceDistance) {
  // Two nodes in a bar, half of it 50 times as stiff: the stiff half moves nearly as one, and the soft half takes up
  // the stretch, as a bar in tension does. Weights that did not know the material would be even at the middle.
  const auto mesh = box(60, 3, 3, {60, 3, 3});
  std::vector<double> youngs_kPa;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    youngs_kPa.push_back(geometry::cell_centroid_mm(mesh, c).x() < 30 ? 50.0 : 1.0);
  }
  const auto shape = shape_functions_of(mesh, youngs_kPa, {.nodes = 2, .voxels_per_node = 400}).value();
  const int stiff = shape.nodes_mm[0].x() < shape.nodes_mm[1].x() ? 0 : 1;
  EXPECT_DOUBLE_EQ(shape.node_youngs_kPa[stiff], 50.0);
  EXPECT_DOUBLE_EQ(shape.node_youngs_kPa[1 - stiff], 1.0);
  const auto stiff_weight = [&](double x_mm) {
    const std::size_t p = test::point_at(mesh, {x_mm, 1, 1});
    for (std::size_t k = shape.starts[p]; k < shape.starts[p + 1]; ++k) {
      if (shape.nodes[k] == stiff) return shape.weights[k];
    }
    return 0.0;
  };
  EXPECT_GT(stiff_weight(29), 0.95);
  EXPECT_NEAR(stiff_weight(37.5), 0.5, 0.06);  // half way through the compliance between the nodes, which is all soft
  EXPECT_LT(stiff_weight(46), 0.06);
}

TEST(MeshfreePatch, AnyUniformStrainIsInTheSpaceAndBalancesItsTractions) {
  MottledBody body;
  const double nu = 0.3, youngs = 6;
  Matrix3d gradient;
  gradient << 0.02, 0.01, -0.03, 0.005, -0.01, 0.02, 0.015, 0.0, 0.03;
  // The weights see the mottled stiffness, the stress is that of a uniform body.
  MeshfreeBody handles = prepared(body.mesh, body.youngs_kPa, MaterialLaw::linear, 30, meshfree_options(nu));
  handles.body.materials.assign(body.mesh.cells.size(), lame_from_youngs(youngs, nu));
  handles.materials = materials_of(handles.body, MaterialLaw::linear);

  const Eigen::VectorXd q =
      affine_handles(handles.shape, [&](const Vector3d& x) { return (Vector3d(1, 2, 3) + gradient * x).eval(); });
  const Eigen::VectorXd u_mm = handles.basis->displacement(q);
  for (int place = 0; place < handles.body.layout.nodes(); ++place) {
    const Vector3d expected = Vector3d(1, 2, 3) + gradient * handles.body.layout.positions_mm[place];
    EXPECT_LT((u_mm.segment<3>(3 * place) - expected).norm(), 1e-12);
  }
  const Matrix3d stress = stress_kPa(handles.body.materials[0], small_strain(gradient));
  Eigen::VectorXd traction_mN = Eigen::VectorXd::Zero(u_mm.size());
  for (const BoundaryFace& face : handles.body.boundary) add_traction(face, stress * face.normal, traction_mN);
  const Eigen::VectorXd loads_mN = handles.basis->reduce(traction_mN);
  const ReducedOperator tangent = handles.tangent(Eigen::VectorXd::Zero(u_mm.size()), Tangent::exact);
  EXPECT_LT((tangent * q - loads_mN).norm(), 1e-10 * loads_mN.norm());
  EXPECT_LT((handles.basis->reduce(internal_force_mN(handles.body, handles.materials, u_mm)) - loads_mN).norm(),
            1e-10 * loads_mN.norm());
}

TEST(MeshfreePatch, ABodyBetweenSymmetryPlanesStretchesUniformly) {
  // Solved, not only balanced. What is held is held by springs: that is the difference.
  auto mesh = box(5, 5, 5, {20, 20, 20});
  test::disturb_inner_points(mesh, 0.5);
  test::name_points(mesh, "x0", [](const Vector3d& p) { return p.x() == 0; });
  test::name_points(mesh, "y0", [](const Vector3d& p) { return p.y() == 0; });
  test::name_points(mesh, "z0", [](const Vector3d& p) { return p.z() == 0; });
  const double nu = 0.45, youngs = 6, pressure = 0.3;
  const auto model = MeshfreeModel::create(mesh, uniform(mesh, youngs),
                                           {held_along("x0", true, false, false), held_along("y0", false, true, false),
                                            held_along("z0", false, false, true)},
                                           MaterialLaw::linear, meshfree_options(nu), {.nodes = 20})
                         .value();
  const auto result = model.solve({PressureLoad{pressure}}).value();
  ASSERT_TRUE(result.may_be_used()) << result.why_stopped;
  const double strain = -pressure * (1 - 2 * nu) / youngs;
  for (std::size_t p = 0; p < mesh.points_mm.size(); ++p) {
    EXPECT_LT((result.displacement_mm[p] - strain * mesh.points_mm[p]).norm(), 0.01 * std::abs(strain) * 20);
  }
}

// --- the cantilever of table 6.1: 50 x 10 x 10 mm, 12 kPa, 997 kg/m3

geometry::TetMesh cantilever_mesh(int across) {
  auto mesh = box(5 * across, across, across, {50, 10, 10});
  test::name_points(mesh, "wall", [](const Vector3d& p) { return p.x() == 0; });
  return mesh;
}

double tip_mm(const geometry::TetMesh& mesh, const StaticResult& result) {
  return -result.displacement_mm[test::point_at(mesh, {50, 5, 5})].z();
}

TEST(MeshfreeCantilever, ApproachesTheoryFromBelowAsNodesAreAdded) {
  // Euler and Bernoulli's tip (eq. 6.6) with Timoshenko's shear, at nu = 0. A few handles cannot bend enough; none
  // bends more than the quadratic cells of the same mesh, whose displacements contain theirs.
  const auto mesh = cantilever_mesh(4);
  const double f = 997e-9 * fall_mm_s2 * 100, inertia = 1e4 / 12;
  const double theory = f * std::pow(50.0, 4) / (8 * 12 * inertia) + f * 2500 / 2 / (10.0 / 12 * 6 * 100);
  const Loads weight{GravityLoad{{0, 0, -fall_mm_s2}}};
  const double by_cells =
      tip_mm(mesh, solve_static(mesh, uniform(mesh, 12), {fixed("wall")}, weight, meshfree_options(0, 997e-9)).value());
  double before_mm = 0;
  for (const auto& [nodes, share] : {std::pair{20, 0.65}, {60, 0.85}, {180, 0.94}}) {
    const auto model = MeshfreeModel::create(mesh, uniform(mesh, 12), {fixed("wall")}, MaterialLaw::linear,
                                             meshfree_options(0, 997e-9), {.nodes = nodes})
                           .value();
    const auto result = model.solve(weight).value();
    ASSERT_TRUE(result.may_be_used()) << result.why_stopped;
    EXPECT_LT(result.relative_residual, 1e-6);
    const double tip = tip_mm(mesh, result);
    RecordProperty("tip_mm_of_" + std::to_string(nodes), std::to_string(tip));
    EXPECT_GT(tip, share * theory) << nodes;
    EXPECT_GT(tip, before_mm);
    EXPECT_LT(tip, 1.002 * by_cells);  // and the springs at the wall
    EXPECT_NEAR(result.fixed_reaction_mN.z(), -result.applied_force_mN.z(), 1e-4 * f * 50);
    before_mm = tip;
  }
}

TEST(MeshfreeRotation, ABodyTurnedByHalfATurnHasNoEnergyAndNoForce) {
  const MottledBody body;
  for (const MaterialLaw law : {MaterialLaw::corotational, MaterialLaw::neo_hookean}) {
    const MeshfreeBody handles = prepared(body.mesh, body.youngs_kPa, law, 20, meshfree_options(0.45));
    const Matrix3d turn = Eigen::AngleAxisd(M_PI, Vector3d(1, 2, 2).normalized()).toRotationMatrix();
    const Eigen::VectorXd q = affine_handles(handles.shape, [&](const Vector3d& x) { return (turn * x - x).eval(); });
    const Eigen::VectorXd u_mm = handles.basis->displacement(q);
    EXPECT_NEAR(strain_energy_uJ(handles.body, handles.materials, u_mm), 0.0, 1e-9);
    EXPECT_LT(handles.basis->reduce(internal_force_mN(handles.body, handles.materials, u_mm)).norm(), 1e-7);
  }
}

TEST(MeshfreeRotation, ABentCantileverKeepsItsLength) {
  // 10 times its weight bends the beam far down. Small strain would stretch its axis by half; the corotational one
  // keeps it, and agrees with finite elements.
  const auto mesh = cantilever_mesh(3);
  const Loads loads{GravityLoad{{0, 0, -3 * fall_mm_s2}}};
  const auto model = MeshfreeModel::create(mesh, uniform(mesh, 12), {fixed("wall")}, MaterialLaw::corotational,
                                           meshfree_options(0.3, 997e-9), {.nodes = 60})
                         .value();
  const auto result = model.solve(loads).value();
  ASSERT_TRUE(result.may_be_used()) << result.why_stopped;
  double length_mm = 0;
  for (int i = 0; i < 15; ++i) {
    const auto at = [&](double x) {
      const std::size_t p = test::point_at(mesh, {x, 10.0 / 3, 10.0 / 3});
      return (mesh.points_mm[p] + result.displacement_mm[p]).eval();
    };
    length_mm += (at(50.0 * (i + 1) / 15) - at(50.0 * i / 15)).norm();
  }
  EXPECT_GT(tip_mm(mesh, result), 25);
  EXPECT_NEAR(length_mm, 50, 2.0);

  const auto body =
      prepare_body(mesh, uniform(mesh, 12), {fixed("wall")}, meshfree_options(0.3, 997e-9), Holding::required).value();
  const auto by_cells = find_equilibrium(body, materials_of(body, MaterialLaw::corotational), loads).value();
  EXPECT_NEAR(tip_mm(mesh, result), tip_mm(mesh, by_cells), 0.06 * tip_mm(mesh, by_cells));
}

TEST(MeshfreeImplicitEuler, ABodyFallsAndItsMomentumIsItsWeightTimesTheTime) {
  const MottledBody body;
  for (const MaterialLaw law : {MaterialLaw::linear, MaterialLaw::corotational}) {
    auto moving = MeshfreeImplicitEuler::create(prepared(body.mesh, body.youngs_kPa, law, 20, meshfree_options(0.45)),
                                                {.step_s = 0.01, .relative_tolerance = 1e-8})
                      .value();
    const auto weight = applied_loads(moving.body(), {GravityLoad{{0, 0, -fall_mm_s2}}}, PressureKind::dead).value();
    for (int step = 0; step < 10; ++step) ASSERT_TRUE(moving.step(weight).converged);
    const double mass_kg = 1000e-9 * geometry::volume_mm3(body.mesh);
    EXPECT_LT((moving.momentum_kg_mm_s() - Vector3d(0, 0, -mass_kg * fall_mm_s2 * 0.1)).norm(),
              1e-6 * mass_kg * fall_mm_s2);
    const Eigen::VectorXd u_mm = moving.displacement_mm();
    // Implicit Euler: h^2 g (1 + 2 + ... + 10).
    for (Eigen::Index i = 2; i < u_mm.size(); i += 3) EXPECT_NEAR(u_mm[i], -fall_mm_s2 * 1e-4 * 55, 1e-4);
  }
}

TEST(MeshfreeImplicitEuler, ASpinningBodyTurnsWithoutGrowing) {
  const MottledBody body;
  auto moving = MeshfreeImplicitEuler::create(
                    prepared(body.mesh, body.youngs_kPa, MaterialLaw::corotational, 12, meshfree_options(0.3)),
                    {.step_s = 0.01, .relative_tolerance = 1e-6})
                    .value();
  moving.set_rigid_velocity(Vector3d(0, 0, 6).cross(-Vector3d(15, 12.5, 12.5)), {0, 0, 6});
  const Vector3d momentum = moving.momentum_kg_mm_s();
  const AppliedLoads nothing{Eigen::VectorXd::Zero(3 * moving.body().layout.nodes())};
  double largest_turn = 0;
  for (int step = 0; step < 40; ++step) {
    ASSERT_TRUE(moving.step(nothing).converged);
    const Eigen::VectorXd u_mm = moving.displacement_mm();
    double volume_mm3 = 0;
    geometry::TetMesh moved = body.mesh;
    for (std::size_t p = 0; p < moved.points_mm.size(); ++p) {
      moved.points_mm[p] += u_mm.segment<3>(3 * moving.body().layout.node_of_point[p]);
    }
    volume_mm3 = geometry::volume_mm3(moved);
    EXPECT_NEAR(volume_mm3, geometry::volume_mm3(body.mesh), 0.02 * geometry::volume_mm3(body.mesh));
    const Vector3d side = moved.points_mm[test::point_at(body.mesh, {30, 12.5, 12.5})] -
                          moved.points_mm[test::point_at(body.mesh, {0, 12.5, 12.5})];
    largest_turn = std::max(largest_turn, std::atan2(std::abs(side.y()), side.x()));
  }
  EXPECT_GT(largest_turn, 1.5);  // a quarter turn and more
  EXPECT_LT((moving.momentum_kg_mm_s() - momentum).norm(), 1e-6);
}

TEST(MeshfreeImplicitEuler, SettlesWhereTheEquilibriumIs) {
  const auto mesh = cantilever_mesh(3);
  const Loads loads{GravityLoad{{0, 0, -500}}};
  const auto still = MeshfreeModel::create(mesh, uniform(mesh, 12), {fixed("wall")}, MaterialLaw::linear,
                                           meshfree_options(0.3), {.nodes = 30})
                         .value()
                         .solve(loads)
                         .value();
  auto moving = MeshfreeImplicitEuler::create(
                    prepared(mesh, uniform(mesh, 12), MaterialLaw::linear, 30, meshfree_options(0.3), {fixed("wall")}),
                    {.step_s = 0.05, .mass_damping_per_s = 5})
                    .value();
  const auto applied = applied_loads(moving.body(), loads, PressureKind::dead).value();
  for (int step = 0; step < 100; ++step) {
    const StepReport report = moving.step(applied);
    ASSERT_TRUE(report.converged);
    EXPECT_LE(report.iterations, 3);  // the factor is of the very matrix
  }
  const Eigen::VectorXd u_mm = moving.displacement_mm();
  const std::size_t tip = test::point_at(mesh, {50, 5, 5});
  EXPECT_NEAR(u_mm[3 * moving.body().layout.node_of_point[tip] + 2], still.displacement_mm[tip].z(),
              1e-3 * still.max_displacement_mm);
}

// --- cutting

TEST(OpenCuts, KeepsTheVolumeAndGivesEachSideItsFace) {
  auto mesh = box(4, 4, 4, {20, 20, 20});
  test::disturb_inner_points(mesh, 1.0);
  geometry::set_field(mesh.cell_fields, {"region", 1, std::vector<double>(mesh.cells.size(), 7.0)});
  const Vector3d normal = Vector3d(3, 1, 0.5).normalized();
  const auto halves = open_cuts(mesh, {{{9.3, 10, 10}, normal}}, Along::exactly)->mesh;
  EXPECT_TRUE(geometry::check_cells(halves)) << geometry::check_cells(halves).error().message();
  EXPECT_NEAR(geometry::volume_mm3(halves), 8000, 1e-8);
  const auto parts = geometry::parts_by_faces(halves);
  EXPECT_EQ(*std::max_element(parts.begin(), parts.end()), 1);
  // A watertight surface says that the small tetrahedra fit each other: a misfit would leave inner faces bare. Both cut
  // faces have the plane's area in the cube.
  const geometry::Surface surface = geometry::boundary_surface(halves);
  EXPECT_TRUE(geometry::is_watertight(surface));
  EXPECT_NEAR(geometry::area_mm2(surface), 6 * 400 + 2 * 400 / normal.x(), 1e-6);
  EXPECT_EQ(geometry::find_field(halves.cell_fields, "region")->values.size(), halves.cells.size());
}

TEST(OpenCuts, OfADiscLeavesTheBodyInOnePiece) {
  const auto mesh = box(4, 4, 4, {20, 20, 20});
  const auto opened = open_cuts(mesh, {{{11, 10, 20}, {1, 0, 0}, 8.0, {}}}, Along::exactly)->mesh;
  EXPECT_TRUE(geometry::check_tetrahedra(opened)) << geometry::check_tetrahedra(opened).error().message();
  EXPECT_NEAR(geometry::volume_mm3(opened), 8000, 1e-8);
  EXPECT_GT(geometry::area_mm2(geometry::boundary_surface(opened)), 6 * 400 + 40);
  EXPECT_EQ(open_cuts(mesh, {{{40, 10, 10}, {1, 0, 0}}}, Along::exactly).error().code, "cut-misses");
}

TEST(MeshfreeCut, NoNodeActsAcrossAndTheOtherSideStaysStill) {
  auto whole = box(8, 4, 4, {40, 20, 20});
  test::name_points(whole, "ends", [](const Vector3d& p) { return p.x() == 0 || p.x() == 40; });
  const Cut cut{{21, 10, 10}, Vector3d(1, 0.2, 0).normalized()};
  const auto mesh = open_cuts(whole, {cut}, Along::exactly)->mesh;
  StaticOptions options = meshfree_options(0.3);
  options.parts = StaticOptions::Parts::several;
  const auto model =
      MeshfreeModel::create(mesh, uniform(mesh, 6), {fixed("ends")}, MaterialLaw::linear, options, {.nodes = 30}, {cut})
          .value();
  const auto result = model.solve({ToolLoad{{10, 10, 20}, 6, {0, 0, 5}}}).value();
  ASSERT_TRUE(result.may_be_used()) << result.why_stopped;
  const auto parts = geometry::parts_by_faces(mesh);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    if (cut.normal.dot(geometry::cell_centroid_mm(mesh, c) - cut.center_mm) < 0) continue;
    for (const int p : mesh.cells[c]) EXPECT_LT(result.displacement_mm[p].norm(), 1e-9);
  }
  EXPECT_GT(result.max_displacement_mm, 0.1);
}

TEST(MeshfreeCut, ACutHalfThroughOpens) {
  // What is left under the cut is about as thick as one node, and bends less than finite elements on the opened mesh
  // say: the tip sinks by 6.3 mm there, 9.2 mm by finite elements, 3.8 mm without a cut.
  auto whole = cantilever_mesh(4);
  const Cut cut{{16.2, 5, 12}, {1, 0, 0}, 8.0, {}};  // from above, through about half of the section
  const auto mesh = open_cuts(whole, {cut}, Along::exactly)->mesh;
  const Loads loads{GravityLoad{{0, 0, -500}}};
  const auto tip_of = [&](const geometry::TetMesh& body, const std::vector<Cut>& cuts) {
    const auto model = MeshfreeModel::create(body, uniform(body, 12), {fixed("wall")}, MaterialLaw::linear,
                                             meshfree_options(0.3), {.nodes = 150}, cuts)
                           .value();
    return tip_mm(body, model.solve(loads).value());
  };
  const double uncut_mm = tip_of(whole, {}), cut_mm = tip_of(mesh, {cut});
  const double by_cells_mm =
      tip_mm(mesh, solve_static(mesh, uniform(mesh, 12), {fixed("wall")}, loads, meshfree_options(0.3)).value());
  EXPECT_GT(cut_mm, 1.5 * uncut_mm);
  EXPECT_LT(cut_mm, by_cells_mm);
  RecordProperty("uncut_meshfree_fem_mm", fmt::format("{:.3f} {:.3f} {:.3f}", uncut_mm, cut_mm, by_cells_mm));
}

// --- on a liver

TEST(MeshfreeLiver, FollowsFiniteElementsOnALiverOfUnevenStiffness) {
  GLISSON_NEEDS_DATA("liver_patient_models_ucl");
  const auto patient = geometry::read_surface(glisson::test::shared_data() /
                                              "liver_patient_models_ucl/voxelisation/liver_downsample.stl");
  ASSERT_TRUE(patient) << patient.error().message();
  const geometry::Box box = geometry::bounding_box(patient->points_mm);
  imaging::LabelMap labels;
  labels.grid.spacing_mm.setConstant(4);
  labels.grid.origin_mm = box.min_mm - Vector3d::Constant(10);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    labels.grid.size[axis] = static_cast<int>((box.max_mm - box.min_mm)[static_cast<Eigen::Index>(axis)] / 4) + 6;
  }
  const imaging::Mask mask = segmentation::rasterise(*patient, labels.grid);
  labels.values.assign(mask.values.begin(), mask.values.end());
  auto meshed = meshing::mesh_labels(labels, {.target_cells = 3000});
  ASSERT_TRUE(meshed) << meshed.error().message();
  geometry::TetMesh* liver = &meshed->body;
  const Vector3d middle = box.center_mm();
  geometry::Field stiffness{youngs_modulus_field, 1, {}};
  for (std::size_t c = 0; c < liver->cells.size(); ++c) {  // 3 to 20 kPa, and a stiff lump
    const Vector3d at = geometry::cell_centroid_mm(*liver, c) - middle;
    const bool lump = (at - Vector3d(-20, 0, 0)).norm() < 25;
    stiffness.values.push_back(lump ? 60.0 : 8.0 * std::exp(0.9 * std::sin(0.05 * at.x()) * std::cos(0.07 * at.y())));
  }
  geometry::set_field(liver->cell_fields, stiffness);
  const geometry::Box bounds = geometry::bounding_box(liver->points_mm);
  Scenario scenario;
  scenario.supports = {
      {geometry::Box{bounds.min_mm, {bounds.min_mm.x() + 50, bounds.max_mm.y(), bounds.max_mm.z()}}, Fixed{}}};
  const geometry::Surface surface = geometry::boundary_surface(*liver);
  const auto tip = *std::max_element(surface.points_mm.begin(), surface.points_mm.end(),
                                     [](const Vector3d& a, const Vector3d& b) { return a.x() < b.x(); });
  scenario.loads = {ToolLoad{tip, 25, {0, 0, 400}}};
  const auto by_cells = simulate(*liver, scenario).value();
  scenario.engine = Engine::meshfree;
  double before_mm = 1e9;
  for (const int nodes : {30, 100}) {
    scenario.meshfree.nodes = nodes;
    const auto meshfree = simulate(*liver, scenario).value();
    ASSERT_TRUE(meshfree.result.may_be_used());
    double sum_mm = 0;
    for (std::size_t p = 0; p < liver->points_mm.size(); ++p) {
      sum_mm += (meshfree.result.displacement_mm[p] - by_cells.result.displacement_mm[p]).norm();
    }
    const double mean_mm = sum_mm / static_cast<double>(liver->points_mm.size());
    std::printf("liver of %zu points, %d nodes: mean difference %.3f mm of %.2f mm at most\n", liver->points_mm.size(),
                nodes, mean_mm, by_cells.result.max_displacement_mm);
    EXPECT_LT(mean_mm, before_mm);
    before_mm = mean_mm;
  }
  EXPECT_LT(before_mm, 0.1 * by_cells.result.max_displacement_mm);
}

TEST(Meshfree, WhatCannotBeIsRefused) {
  const auto mesh = cantilever_mesh(2);
  const auto code = [&](const MeshfreeOptions& options, const std::vector<Support>& supports) {
    return MeshfreeModel::create(mesh, uniform(mesh, 12), supports, MaterialLaw::linear, {}, options).error().code;
  };
  EXPECT_EQ(code({.nodes = -1}, {fixed("wall")}), "meshfree-options");
  EXPECT_EQ(code({.overlap = 0.5}, {fixed("wall")}), "meshfree-options");
  EXPECT_EQ(code({}, {}), "body-free");
  EXPECT_EQ(code({}, {fixed("floor")}), "array-unknown");
}

}  // namespace
}  // namespace glisson::mechanics

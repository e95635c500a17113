// Meshing of shapes that are known in closed form, and of label maps as they should not be.

#include "meshing/mesh_labels.h"

#include <gmock/gmock.h>
#include <cmath>
#include <numbers>

#include "labelled_shapes.h"

namespace glisson::meshing {
namespace {

using Eigen::Vector3d;
using imaging::LabelMap;
using test::empty_labels;
using test::paint;
using test::paint_ball;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

double ball_ml(double radius_mm) { return 4.0 / 3.0 * std::numbers::pi * std::pow(radius_mm, 3) * 1e-3; }

// What every mesh must be, whatever it was made from.
void expect_sound(const LiverMesh& mesh) {
  EXPECT_TRUE(check_tetrahedra(mesh.body)) << check_tetrahedra(mesh.body).error().message();
  EXPECT_TRUE(is_watertight(mesh.surface));
  EXPECT_THAT(pinched_points(mesh.surface), IsEmpty());
  EXPECT_NEAR(volume_mm3(mesh.surface), volume_mm3(mesh.body), 1e-6 * volume_mm3(mesh.body));
  EXPECT_GT(mesh.quality.min_dihedral_deg, 5);
  double regions_ml = 0;
  for (const RegionVolume& region : mesh.regions) regions_ml += region.mesh_volume_ml;
  EXPECT_NEAR(regions_ml, volume_mm3(mesh.body) * 1e-3, 1e-6 * regions_ml);
}

LabelMap ball_with_inner_ball(double inner_radius_mm) {
  LabelMap labels = empty_labels(2, 55);
  paint_ball(labels, 1, Vector3d::Zero(), 50);
  paint_ball(labels, 7, {20, 5, -3}, inner_radius_mm);
  return labels;
}

TEST(MeshLabels, ABallInABallHasTheVolumesOfTheClosedForms) {
  const auto mesh = mesh_labels(ball_with_inner_ball(12), {.target_cells = 20000});
  ASSERT_TRUE(mesh) << mesh.error().message();
  expect_sound(*mesh);
  ASSERT_EQ(mesh->regions.size(), 2U);
  // Points lie on the boundary and facets are chords: edges of 5 mm on a radius of 50 mm cut off up to 5^2 / (8 * 50) =
  // 0.06 mm, and less than 1 % of the volume; the inner ball's edges are two thirds of its radius, and 8 % is lost.
  EXPECT_NEAR(mesh->regions[0].mesh_volume_ml, ball_ml(50) - ball_ml(12), 0.015 * ball_ml(50));
  EXPECT_NEAR(mesh->regions[1].mesh_volume_ml, ball_ml(12), 0.08 * ball_ml(12));
  EXPECT_EQ(mesh->regions[1].label, 7);
  // Half a voxel's diagonal, 1.7 mm, is what the steps of the labels alone make; the mesh adds little to it.
  EXPECT_LT(mesh->hausdorff_mm, 2.5);
  EXPECT_LT(mesh->mean_distance_mm, 0.6);
  EXPECT_THAT(messages(mesh->notes), IsEmpty());
}

TEST(MeshLabels, TheNumberOfCellsIsWithin15PercentOfTheTarget) {
  for (const int target : {1500, 5000, 20000}) {
    const auto mesh = mesh_labels(ball_with_inner_ball(8), {.target_cells = target});
    ASSERT_TRUE(mesh) << mesh.error().message();
    EXPECT_NEAR(static_cast<double>(mesh->body.cells.size()), target, 0.15 * target);
  }
}

TEST(MeshLabels, ATargetThatTheShapeDoesNotAllowIsSaidToBeMissed) {
  const auto mesh = mesh_labels(ball_with_inner_ball(8), {.target_cells = 800, .inner_share = 0.9});
  ASSERT_TRUE(mesh) << mesh.error().message();
  EXPECT_THAT(messages(mesh->notes), Contains(HasSubstr("cells instead of 800")));
}

TEST(MeshLabels, AnInclusionIsNotLostInACoarseMesh) {
  // Cells of the liver are 20 mm long here, and the inclusion 6 mm across: three voxels.
  const auto mesh = mesh_labels(ball_with_inner_ball(3), {.target_cells = 1500});
  ASSERT_TRUE(mesh) << mesh.error().message();
  expect_sound(*mesh);
  EXPECT_NEAR(mesh->regions[1].mesh_volume_ml, mesh->regions[1].label_volume_ml,
              0.2 * mesh->regions[1].label_volume_ml);
}

TEST(MeshLabels, CellsConformToTheBoundaryInside) {
  const auto mesh = mesh_labels(ball_with_inner_ball(15), {.target_cells = 10000});
  ASSERT_TRUE(mesh);
  const auto* region = find_field(mesh->body.cell_fields, "region");
  ASSERT_NE(region, nullptr);
  std::vector<int> inner;
  for (std::size_t cell = 0; cell < mesh->body.cells.size(); ++cell) {
    if (region->values[cell] == 7) inner.push_back(static_cast<int>(cell));
  }
  // Every point of the inner region's own boundary lies on the inner ball, to half a voxel.
  for (const Vector3d& point : boundary_surface(part_of(mesh->body, inner)).points_mm) {
    EXPECT_NEAR((point - Vector3d(20, 5, -3)).norm(), 15, 1.0);
  }
}

TEST(MeshLabels, ARotatedAnisotropicLeftHandedGridEndsInThePatientRightWayOut) {
  const Vector3d center(120, -40, 300);
  LabelMap labels;
  labels.grid.size = {70, 80, 30};
  labels.grid.spacing_mm = {1.5, 1.2, 4.0};
  labels.grid.direction =
      Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix() * Vector3d(1, 1, -1).asDiagonal();
  labels.grid.origin_mm =
      center - labels.grid.direction * labels.grid.spacing_mm.cwiseProduct(Vector3d(34.3, 39.8, 14.6));
  labels.values.assign(labels.grid.voxels(), 0);
  paint_ball(labels, 1, center, 40);
  const auto mesh = mesh_labels(labels, {.target_cells = 8000});
  ASSERT_TRUE(mesh) << mesh.error().message();
  expect_sound(*mesh);
  EXPECT_GT(volume_mm3(mesh->surface), 0);
  EXPECT_NEAR(volume_mm3(mesh->body) * 1e-3, ball_ml(40), 0.02 * ball_ml(40));
  for (const Vector3d& point : mesh->surface.points_mm) EXPECT_NEAR((point - center).norm(), 40, 2.5);
}

TEST(MeshLabels, TheSameLabelsGiveTheSameMesh) {
  const LabelMap labels = ball_with_inner_ball(8);
  const auto first = mesh_labels(labels, {.target_cells = 5000});
  const auto second = mesh_labels(labels, {.target_cells = 5000});
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->body.points_mm, second->body.points_mm);
  EXPECT_EQ(first->body.cells, second->body.cells);
}

TEST(MeshLabels, ABodyCutByTheImageIsClosedByAFlatCapAndSaidToBe) {
  LabelMap labels = empty_labels(2, 40);
  paint_ball(labels, 1, Vector3d(0, 0, -40), 35);  // half of it lies below the last slice, at z = -40 mm
  const auto mesh = mesh_labels(labels, {.target_cells = 5000});
  ASSERT_TRUE(mesh) << mesh.error().message();
  expect_sound(*mesh);
  EXPECT_THAT(messages(mesh->notes),
              Contains(AllOf(HasSubstr("cuts the body off towards the feet"), HasSubstr("flat cap"))));
  // The slice reaches half a spacing beyond its voxels' centres: the cap is at z = -41 mm.
  const double half_ball_ml = 0.5 * ball_ml(35) + std::numbers::pi * 35 * 35 * 1.0 * 1e-3;
  EXPECT_NEAR(volume_mm3(mesh->body) * 1e-3, half_ball_ml, 0.02 * half_ball_ml);
  double lowest_mm = 0;
  for (const Vector3d& point : mesh->surface.points_mm) {
    lowest_mm = std::min(lowest_mm, point.z());
    const bool on_the_cap = std::hypot(point.x(), point.y()) < 25 && point.z() < -36;
    if (on_the_cap) {
      EXPECT_NEAR(point.z(), -41, 0.1);
    }
  }
  EXPECT_NEAR(lowest_mm, -41, 0.1);
}

TEST(MeshLabels, TheLargestPartIsKeptAndTheOthersAreNamedWithTheirVolumes) {
  LabelMap labels = empty_labels(2, 60);
  paint_ball(labels, 1, {-15, 0, 0}, 35);
  paint_ball(labels, 1, {45, 0, 0}, 8);
  paint_ball(labels, 3, {45, 40, 0}, 6);
  const auto mesh = mesh_labels(labels, {.target_cells = 3000, .names = {{1, "liver"}, {3, "tumour-1"}, {4, "cyst"}}});
  ASSERT_TRUE(mesh) << mesh.error().message();
  expect_sound(*mesh);
  EXPECT_THAT(messages(mesh->notes),
              Contains(AllOf(HasSubstr("3 parts"), HasSubstr("liver (label 1): "), HasSubstr("tumour-1 (label 3): "))));
  EXPECT_THAT(messages(mesh->notes), Contains(HasSubstr("cyst (label 4) holds no voxels")));
  EXPECT_NEAR(volume_mm3(mesh->body) * 1e-3, ball_ml(35), 0.03 * ball_ml(35));
}

TEST(MeshLabels, SmallIslandsOfAnInnerStructureAreKept) {
  LabelMap labels = empty_labels(2, 60);
  paint_ball(labels, 1, Vector3d::Zero(), 50);
  paint_ball(labels, 2, {-20, 0, 0}, 10);
  paint_ball(labels, 2, {25, 0, 0}, 4);
  const auto mesh = mesh_labels(labels, {.target_cells = 8000});
  ASSERT_TRUE(mesh) << mesh.error().message();
  const auto& region = find_field(mesh->body.cell_fields, "region")->values;
  double island_ml = 0;
  for (std::size_t cell = 0; cell < mesh->body.cells.size(); ++cell) {
    if (region[cell] == 2 && cell_centroid_mm(mesh->body, cell).x() > 0) {
      island_ml += cell_volume_mm3(mesh->body, cell) * 1e-3;
    }
  }
  // Two voxels of radius: chords of two thirds of the radius cut off a tenth, the voxels are as far from a ball.
  EXPECT_NEAR(island_ml, ball_ml(4), 0.2 * ball_ml(4));
}

TEST(MeshLabels, HolesAreFilledAndSpecksJoinWhatTheyTouch) {
  LabelMap labels = empty_labels(2, 45);
  paint_ball(labels, 1, Vector3d::Zero(), 40);
  paint_ball(labels, 0, {10, 0, 0}, 6);
  labels.at(20, 20, 20) = 9;
  const auto mesh = mesh_labels(labels, {.target_cells = 3000});
  ASSERT_TRUE(mesh) << mesh.error().message();
  expect_sound(*mesh);
  EXPECT_THAT(messages(mesh->notes), Contains(AllOf(HasSubstr("Holes"), HasSubstr("filled"))));
  EXPECT_THAT(messages(mesh->notes), Contains(HasSubstr("1 speck of fewer than 8 voxels")));
  EXPECT_EQ(mesh->regions.size(), 1U);
}

LabelMap ball_with_vessel() {
  LabelMap labels = empty_labels(2, 60);
  paint_ball(labels, 1, Vector3d::Zero(), 50);
  // A straight vessel of 3 mm radius and 70 mm length, slanted to the grid.
  const Vector3d along = Vector3d(1, 0.6, 0.3).normalized();
  paint(labels, 4, [&](const Vector3d& at) {
    const double axial = at.dot(along);
    return std::abs(axial) < 35 && (at - axial * along).norm() < 3;
  });
  return labels;
}

TEST(MeshLabels, AVesselTooThinForTheTargetIsSaidToHaveNoCells) {
  const auto mesh = mesh_labels(ball_with_vessel(), {.target_cells = 2000, .names = {{4, "portal-vein"}}});
  ASSERT_TRUE(mesh) << mesh.error().message();
  expect_sound(*mesh);
  EXPECT_THAT(messages(mesh->notes),
              Contains(AllOf(HasSubstr("portal-vein (label 4)"), HasSubstr("too thin for 2000 cells"))));
  ASSERT_EQ(mesh->regions.size(), 2U);
  EXPECT_EQ(mesh->regions[1].mesh_volume_ml, 0);
  EXPECT_NEAR(volume_mm3(mesh->body) * 1e-3, ball_ml(50), 0.04 * ball_ml(50));  // the liver has its place
}

TEST(MeshLabels, TheSameVesselIsFollowedWhereCellsAllowIt) {
  const auto mesh = mesh_labels(ball_with_vessel(), {.target_cells = 20000});
  ASSERT_TRUE(mesh) << mesh.error().message();
  expect_sound(*mesh);
  EXPECT_THAT(messages(mesh->notes), IsEmpty());
  EXPECT_NEAR(mesh->regions[1].mesh_volume_ml, mesh->regions[1].label_volume_ml,
              0.15 * mesh->regions[1].label_volume_ml);
}

TEST(MeshLabels, AStructureAtTheSurfaceLeavesItAManifold) {
  LabelMap labels = empty_labels(2, 60);
  paint_ball(labels, 1, Vector3d::Zero(), 45);
  paint_ball(labels, 2, {40, 0, 0}, 12);  // a part of it stands out of the liver
  paint_ball(labels, 3, {-45, 0, 0}, 5);
  const auto mesh = mesh_labels(labels, {.target_cells = 8000});
  ASSERT_TRUE(mesh) << mesh.error().message();
  expect_sound(*mesh);
}

TEST(MeshLabels, WhatCannotBeMeshedIsRefused) {
  LabelMap labels = empty_labels(2, 20);
  EXPECT_EQ(mesh_labels(labels, {}).error().code, "labels-empty");
  paint_ball(labels, 1, Vector3d::Zero(), 15);
  EXPECT_EQ(mesh_labels(labels, {.target_cells = 3}).error().code, "mesh-options");
  EXPECT_EQ(mesh_labels(labels, {.inner_share = 2}).error().code, "mesh-options");
  LabelMap skewed = labels;
  skewed.grid.direction(0, 1) = 0.3;
  EXPECT_EQ(mesh_labels(skewed, {}).error().code, "labels-grid");
  LabelMap short_of_values = labels;
  short_of_values.values.pop_back();
  EXPECT_EQ(mesh_labels(short_of_values, {}).error().code, "labels-grid");
}

TEST(MeshLabels, CanBeStopped) {
  std::stop_source stop;
  const Progress progress(
      [&](double, std::string_view stage) {
        if (stage == "Filling the body with tetrahedra") stop.request_stop();
      },
      stop.get_token());
  EXPECT_EQ(mesh_labels(ball_with_inner_ball(8), {.target_cells = 20000}, progress).error().code, "cancelled");
}

}  // namespace
}  // namespace glisson::meshing

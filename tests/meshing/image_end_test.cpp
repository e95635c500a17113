// A tool is told to be on the cap only where the image's end is, and faces it.

#include "meshing/image_end.h"

#include <gmock/gmock.h>

#include "geometry/tetrahedra.h"
#include "meshing/mesh_labels.h"
#include "support/shapes.h"

namespace glisson::meshing {
namespace {

using Eigen::Vector3d;

imaging::Grid grid_around(double spacing_mm) {
  imaging::Grid grid;
  grid.size = {40, 40, 20};
  grid.spacing_mm = {spacing_mm, spacing_mm, spacing_mm};
  grid.origin_mm = {-10, -20, 100};
  return grid;
}

// The lower part of a ball, whose middle lies in the image's last layer but five: meshed as a liver is.
geometry::Surface ball_cut_off_at_the_head() {
  imaging::LabelMap labels{grid_around(3), {}};
  labels.values.assign(labels.grid.voxels(), 0);
  const Vector3d middle_mm = labels.grid.position_mm(20, 20, 14);
  for (int k = 0; k < 20; ++k) {
    for (int j = 0; j < 40; ++j) {
      for (int i = 0; i < 40; ++i) {
        if ((labels.grid.position_mm(i, j, k) - middle_mm).norm() < 36) labels.at(i, j, k) = 1;
      }
    }
  }
  MeshOptions options;
  options.target_cells = 2000;
  const auto meshed = mesh_labels(labels, options);
  if (!meshed) ADD_FAILURE() << meshed.error().message();
  return geometry::boundary_surface(meshed->body);
}

TEST(ImageEnd, OfAMeshedBodyOnlyTheCapIsTheImagesEnd) {
  const geometry::Surface body = ball_cut_off_at_the_head();
  const imaging::Grid grid = grid_around(3);
  const Vector3d middle_mm = grid.position_mm(20, 20, 14), top_mm = grid.position_mm(20, 20, 19);
  EXPECT_STREQ(cut_off_under(body, grid, top_mm, 12), "the head");
  EXPECT_EQ(cut_off_under(body, grid, middle_mm - Vector3d(0, 0, 36), 12), nullptr);
  EXPECT_EQ(cut_off_under(body, grid, middle_mm + Vector3d(36, 0, 0), 12), nullptr);
  EXPECT_EQ(cut_off_under(body, grid, middle_mm - Vector3d(0, 36, 0), 8), nullptr);
}

TEST(ImageEnd, TheSideIsThePatientsHoweverTheImageLies) {
  const geometry::Surface body = ball_cut_off_at_the_head();
  imaging::Grid turned = grid_around(3);  // the same places, counted from the left, the back and the head
  turned.origin_mm = grid_around(3).position_mm(39, 39, 19);
  turned.direction = -Eigen::Matrix3d::Identity();
  EXPECT_STREQ(cut_off_under(body, turned, turned.position_mm(19, 19, 0), 12), "the head");
  EXPECT_STREQ(side_of_patient({-1, 0.2, 0}), "the patient's right");
}

TEST(ImageEnd, ABodyWellInsideIsNotCutOff) {
  const Vector3d middle_mm = grid_around(3).position_mm(20, 20, 10);
  const geometry::Surface ball = glisson::test::sphere_surface(20, 3, middle_mm);
  EXPECT_EQ(cut_off_under(ball, grid_around(3), middle_mm + Vector3d(0, 0, 20), 12), nullptr);
}

}  // namespace
}  // namespace glisson::meshing

// Real livers: network-made labels of an abdominal MR and CT, cut at both ends of the slab, and a patient's surface.

#include <gmock/gmock.h>

#include "geometry/mesh_file.h"
#include "imaging/volume_file.h"
#include "meshing/mesh_labels.h"
#include "segmentation/rasterise.h"
#include "support/data.h"

namespace glisson::meshing {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::uint16_t liver_label = 5;  // of TotalSegmentator

imaging::LabelMap only(imaging::LabelMap labels, std::uint16_t label) {
  for (std::uint16_t& value : labels.values) value = value == label ? label : 0;
  return labels;
}

void expect_sound(const LiverMesh& mesh, int target_cells) {
  EXPECT_TRUE(check_tetrahedra(mesh.body)) << check_tetrahedra(mesh.body).error().message();
  EXPECT_TRUE(is_watertight(mesh.surface));
  EXPECT_THAT(pinched_points(mesh.surface), IsEmpty());
  EXPECT_NEAR(static_cast<double>(mesh.body.cells.size()), target_cells, 0.15 * target_cells);
  EXPECT_GT(mesh.quality.min_dihedral_deg, 5);
  for (const RegionVolume& region : mesh.regions) {
    EXPECT_NEAR(region.mesh_volume_ml, region.label_volume_ml, 0.03 * region.label_volume_ml);
  }
}

class SlabLiver : public testing::TestWithParam<const char*> {};

TEST_P(SlabLiver, IsMeshedAndItsCutEndsAreSaid) {
  GLISSON_NEEDS_DATA("totalseg_abdomen_mr_ct");
  const auto labels = imaging::read_labels_file(test::shared_data() / "totalseg_abdomen_mr_ct" / GetParam());
  ASSERT_TRUE(labels) << labels.error().message();
  const auto mesh = mesh_labels(only(*labels, liver_label), {.target_cells = 20000, .names = {{liver_label, "liver"}}});
  ASSERT_TRUE(mesh) << mesh.error().message();
  expect_sound(*mesh, 20000);
  EXPECT_THAT(messages(mesh->notes), Contains(HasSubstr("The image cuts the body")));
  // Voxels of 3 mm: the corner of a voxel that stands alone is up to a voxel's diagonal, 5.2 mm, from a smooth surface.
  EXPECT_LT(mesh->hausdorff_mm, 6.0);
  EXPECT_LT(mesh->mean_distance_mm, 0.8);
}

INSTANTIATE_TEST_SUITE_P(MrAndCt, SlabLiver, testing::Values("example_seg_mr.nii.gz", "example_seg.nii.gz"),
                         [](const auto& tested) { return tested.index == 0 ? "mr" : "ct"; });

TEST(PatientLiver, ItsRasterisedSurfaceIsFollowedWithinAVoxel) {
  GLISSON_NEEDS_DATA("liver_patient_models_ucl");
  const auto surface =
      geometry::read_surface(test::shared_data() / "liver_patient_models_ucl/voxelisation/liver_downsample.stl");
  ASSERT_TRUE(surface) << surface.error().message();
  const geometry::Box box = geometry::bounding_box(surface->points_mm);
  constexpr double spacing_mm = 2;
  imaging::LabelMap labels;
  labels.grid.spacing_mm = Eigen::Vector3d::Constant(spacing_mm);
  labels.grid.origin_mm = box.min_mm - Eigen::Vector3d::Constant(3 * spacing_mm);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto extent_mm = (box.max_mm - box.min_mm)[static_cast<Eigen::Index>(axis)];
    labels.grid.size[axis] = static_cast<int>(extent_mm / spacing_mm) + 7;
  }
  const imaging::Mask mask = segmentation::rasterise(*surface, labels.grid);
  labels.values.assign(mask.values.begin(), mask.values.end());
  const auto mesh = mesh_labels(labels, {.target_cells = 20000});
  ASSERT_TRUE(mesh) << mesh.error().message();
  expect_sound(*mesh, 20000);
  EXPECT_NEAR(volume_mm3(mesh->body) * 1e-3, volume_mm3(*surface) * 1e-3, 0.02 * volume_mm3(*surface) * 1e-3);
}

}  // namespace
}  // namespace glisson::meshing

// What thin vessels look like: a generated portal vein of voxels of 1.4 mm, and a real one.

#include <gtest/gtest.h>
#include <algorithm>
#include <array>
#include <Eigen/Geometry>
#include <iostream>

#include "base/stopwatch.h"
#include "casefile/drawn_vessels.h"
#include "imaging/volume_file.h"
#include "known_trees.h"
#include "meshing/mask_surface.h"
#include "real_livers.h"
#include "scene/anatomy.h"
#include "scene/scene.h"
#include "support/data.h"
#include "support/picture_check.h"
#include "vasculature/center_lines.h"

namespace glisson::test {
namespace {

using geometry::Surface;

segmentation::Structure portal_vein(double spacing_mm) {
  const KnownVessels known = make_known_vessels(12, {0, 0, 0}, spacing_mm);
  const anatomy::Field wall = tree_field(known.patient.portal_vein, known.liver.grid, 1);
  segmentation::Structure vein{"portal-vein", {}, {known.liver.grid, {}}};
  for (std::size_t i = 0; i < wall.values.size(); ++i) {
    vein.mask.values.push_back(wall.values[i] < 0 && known.liver.values[i] != 0 ? 1 : 0);
  }
  return vein;
}

scene::Scene picture_of(const Surface& surface, const std::string& title) {
  const scene::Appearance look = scene::appearance_of("portal-vein");
  scene::Scene scene;
  scene.surfaces = {{"portal-vein", std::make_shared<Surface>(surface), look.colour, look.opacity, look.finish, {}}};
  scene.annotations.title = title;
  scene.annotations.text_scale = 0.7;
  return scene;
}

TEST(ThinVessels, AreTubesInThePictureAndFewerPieces) {
  const segmentation::Structure vein = portal_vein(1.4);
  const Surface outline = meshing::mask_surface(vein.mask).value();
  const auto drawn = casefile::drawn_vessel(vein, outline);
  ASSERT_TRUE(drawn);
  EXPECT_TRUE(looks_like_baseline(scene::draw(picture_of(*drawn, "Thin vessels as tubes"), 480, 360).value(),
                                  "vessels-as-tubes"));
  const auto kept = build_folder() / "pictures" / "vessels-as-outlined.png";
  ASSERT_TRUE(scene::write_png(scene::draw(picture_of(outline, "As outlined"), 480, 360).value(), kept));
}

// What is no vessel is drawn as it is outlined.
TEST(ThinVessels, AreVesselsAlone) {
  segmentation::Structure vein = portal_vein(1.4);
  const Surface outline = meshing::mask_surface(vein.mask).value();
  vein.name = "tumour-1";
  EXPECT_FALSE(casefile::drawn_vessel(vein, outline));
}

// On a real mask every triangle that is left of the outline is of the outline, and tubes keep to the mask: no point of
// one is farther from a voxel of it than a voxel's diagonal.
TEST(ThinVessels, OfARealLiverStayWithinAVoxelOfTheirMask) {
  const auto names = real_livers(Kind::with_vessels, Half::judging);
  if (names.empty()) GTEST_SKIP() << "no real livers: set GLISSON_SHARED_DATA to the folder that holds them";
  const RealLiver liver = read_real_liver(names.front());
  const segmentation::Structure vessels{"vessels", {}, liver.vessels};
  const Surface outline = meshing::mask_surface(vessels.mask).value();
  const Stopwatch watch;
  const auto drawn = casefile::drawn_vessel(vessels, outline);
  ASSERT_TRUE(drawn) << names.front();
  std::cout << names.front() << ": " << watch.seconds() << " s, " << outline.triangles.size() << " triangles outlined, "
            << drawn->triangles.size() << " drawn\n";
  const imaging::Grid& grid = vessels.mask.grid;
  const auto near_mask = [&](const Eigen::Vector3d& place_mm) {
    const Eigen::Vector3i at = grid.index_of(place_mm).array().round().cast<int>();
    for (int k = -1; k <= 1; ++k) {
      for (int j = -1; j <= 1; ++j) {
        for (int i = -1; i <= 1; ++i) {
          const Eigen::Vector3i other = at + Eigen::Vector3i(i, j, k);
          if ((other.array() < 0).any() || other[0] >= grid.size[0] || other[1] >= grid.size[1] ||
              other[2] >= grid.size[2])
            continue;
          if (vessels.mask.at(other[0], other[1], other[2]) != 0) return true;
        }
      }
    }
    return false;
  };
  const auto outside = std::count_if(drawn->points_mm.begin(), drawn->points_mm.end(),
                                     [&](const Eigen::Vector3d& p) { return !near_mask(p); });
  EXPECT_LT(static_cast<double>(outside), 0.01 * static_cast<double>(drawn->points_mm.size()));
  const auto kept = build_folder() / "pictures";
  (void)scene::write_png(scene::draw(picture_of(*drawn, names.front()), 960, 720).value(), kept / "real-tubes.png");
  (void)scene::write_png(scene::draw(picture_of(outline, names.front()), 960, 720).value(), kept / "real-outline.png");
}

struct WideVessel {
  const char* file;
  const char* name;
  int label;  // by TotalSegmentator's list of that image's kind
};

imaging::Mask mask_of(const WideVessel& vessel) {
  const imaging::LabelMap labels =
      imaging::read_labels_file(shared_data() / "totalseg_abdomen_mr_ct" / vessel.file).value();
  imaging::Mask mask{labels.grid, std::vector<std::uint8_t>(labels.values.size())};
  for (std::size_t i = 0; i < mask.values.size(); ++i) mask.values[i] = labels.values[i] == vessel.label ? 1 : 0;
  return mask;
}

// Real venae cavae and aortas, which an image ends: wide all along, flat here and there, cut off straight. The edges of
// their cut ends are no thin vessels, and nothing of them is drawn as one.
TEST(ThinVessels, AreNotTheEdgesOfAWideVesselWhereTheImageEndsIt) {
  GLISSON_NEEDS_DATA("totalseg_abdomen_mr_ct");
  const std::vector<WideVessel> all{{"example_seg_fast_force_split.nii.gz", "vena-cava", 63},
                                    {"example_seg_fast_force_split.nii.gz", "aorta", 52},
                                    {"example_seg.nii.gz", "vena-cava", 63},
                                    {"example_seg.nii.gz", "aorta", 52},
                                    {"example_seg_dicom.nii.gz", "vena-cava", 63},
                                    {"example_seg_dicom.nii.gz", "aorta", 52},
                                    {"example_seg_mr.nii.gz", "vena-cava", 24},
                                    {"example_seg_mr.nii.gz", "aorta", 23}};
  for (const WideVessel& one : all) {
    const segmentation::Structure vessel{"vena-cava", {}, mask_of(one)};
    const Surface outline = meshing::mask_surface(vessel.mask).value();
    EXPECT_FALSE(casefile::drawn_vessel(vessel, outline)) << one.name << " of " << one.file;
  }
}

// The vessels of this liver hold the vena cava, which thins out to a sheet above, where whoever drew it stopped. There
// it stays as it is outlined, point by point, and no line that runs up the sheet is drawn as a vessel.
TEST(ThinVessels, AreNotTheRibsOfASheetWhereAVenaCavaEnds) {
  GLISSON_NEEDS_DATA("livers_couinaud");
  const segmentation::Structure vessels{"vessels", {}, read_real_liver("3Dircadb-12").vessels};
  const Surface outline = meshing::mask_surface(vessels.mask).value();
  const auto drawn = casefile::drawn_vessel(vessels, outline);
  ASSERT_TRUE(drawn);
  const Eigen::AlignedBox3d end_mm(Eigen::Vector3d(140, 165, 238), Eigen::Vector3d(160, 180, 250));
  const auto there = [&](const Surface& surface) {
    std::vector<std::array<double, 3>> points_mm;
    for (const Eigen::Vector3d& p : surface.points_mm) {
      if (end_mm.contains(p)) points_mm.push_back({p.x(), p.y(), p.z()});
    }
    std::sort(points_mm.begin(), points_mm.end());
    return points_mm;
  };
  EXPECT_GT(there(outline).size(), 500u);
  EXPECT_EQ(there(*drawn), there(outline));
  (void)scene::write_png(scene::draw(picture_of(*drawn, "Where a vena cava ends"), 960, 720).value(),
                         build_folder() / "pictures" / "vena-cava-end.png");
}

}  // namespace
}  // namespace glisson::test

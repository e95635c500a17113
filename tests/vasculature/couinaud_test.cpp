// Segments of generated patients, whose segments are known, and what is refused.

#include <gmock/gmock.h>
#include <set>

#include "anatomy/patient.h"
#include "real_livers.h"
#include "segmentation/rasterise.h"

namespace glisson::vasculature {
namespace {

using Eigen::Vector3d;
using imaging::Mask;

struct Known {
  Mask liver;
  imaging::LabelMap segments;
};

Known known_liver(std::uint64_t seed, double spacing_mm) {
  anatomy::PatientOptions options;
  options.seed = seed;
  options.portal_terminals = options.hepatic_terminals = options.arterial_terminals = 4;
  const anatomy::Patient patient = anatomy::make_patient(options).value();
  const geometry::Box box = geometry::bounding_box(patient.liver->surface.points_mm);
  const Vector3d border = Vector3d::Constant(6);
  Known known;
  known.liver = segmentation::rasterise(patient.liver->surface,
                                        anatomy::grid_over({box.min_mm - border, box.max_mm + border}, spacing_mm));
  const imaging::Grid& grid = known.liver.grid;
  known.segments = {grid, std::vector<std::uint16_t>(grid.voxels(), 0)};
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        if (known.liver.at(i, j, k) == 0) continue;
        known.segments.at(i, j, k) =
            static_cast<std::uint16_t>(anatomy::segment_at(patient, grid.position_mm(i, j, k)));
      }
    }
  }
  return known;
}

TEST(Couinaud, TheShapeAloneTellsSegmentsOfALiverThatWasNotInThePrior) {
  const Known known = known_liver(21, 2);
  const auto found = couinaud_segments(known.liver);
  ASSERT_TRUE(found) << found.error().message();
  EXPECT_EQ(found->from, SegmentsFrom::shape);
  const glisson::test::SegmentScore score = glisson::test::score_of(found->segment, known.segments);
  EXPECT_GT(score.dice[0], 0.65);
  double all = 0;
  for (std::size_t s = 1; s <= 8; ++s) {
    EXPECT_GT(found->volume_ml[s], 0) << "segment " << s;
    all += found->volume_ml[s];
  }
  EXPECT_NEAR(all, found->volume_ml[0], 1e-6);
  for (std::size_t i = 0; i < known.liver.values.size(); ++i) {
    ASSERT_EQ(found->segment.values[i] != 0, known.liver.values[i] != 0);
  }
}

TEST(Couinaud, WrongVoxelsAreInMoreDoubtThanRightOnes) {
  const Known known = known_liver(22, 2.5);
  const auto found = couinaud_segments(known.liver).value();
  std::array<double, 2> doubt{}, count{};
  for (std::size_t i = 0; i < known.liver.values.size(); ++i) {
    if (known.liver.values[i] == 0) continue;
    const std::size_t right = found.segment.values[i] == known.segments.values[i] ? 1 : 0;
    doubt.at(right) += found.doubt[i];
    ++count.at(right);
  }
  ASSERT_GT(count[0], 0);
  EXPECT_GT(doubt[0] / count[0], 1.3 * doubt[1] / count[1]);
}

TEST(Couinaud, AMirroredGridOfTheSameLiverGivesTheSameSegments) {
  const Known known = known_liver(23, 3);
  Known turned = known;  // the same voxels, counted from the other end of the first axis
  imaging::Grid& grid = turned.liver.grid;
  grid.origin_mm = known.liver.grid.position_mm(grid.size[0] - 1, 0, 0);
  grid.direction.col(0) *= -1;
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        turned.liver.at(i, j, k) = known.liver.at(grid.size[0] - 1 - i, j, k);
      }
    }
  }
  const auto a = couinaud_segments(known.liver).value(), b = couinaud_segments(turned.liver).value();
  for (std::size_t s = 1; s <= 8; ++s) EXPECT_NEAR(a.volume_ml[s], b.volume_ml[s], 0.05 * a.volume_ml[0]);
}

TEST(Couinaud, HalfALiverAndVesselsElsewhereAreRefusedWithASentence) {
  const Known known = known_liver(24, 4);
  Mask half = known.liver;
  half.grid.size[2] /= 2;
  half.values.resize(half.grid.voxels());
  EXPECT_EQ(couinaud_segments(half).error().code, "liver-cut-off");
  Mask empty = known.liver;
  std::fill(empty.values.begin(), empty.values.end(), std::uint8_t{0});
  EXPECT_EQ(couinaud_segments(empty).error().code, "liver-empty");
  VesselTrees elsewhere;
  elsewhere.branches.emplace_back();
  for (int i = 0; i < 50; ++i) elsewhere.branches.back().points.push_back({{1000.0 + i, 0, 0}, 3});
  const auto refused = couinaud_segments(known.liver, &elsewhere);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, "vessels-outside");
  EXPECT_THAT(refused.error().message(), testing::HasSubstr("0 %"));
}

TEST(Couinaud, BranchesGetStableNamesOfTheirOwn) {
  const Known known = known_liver(25, 3);
  const auto segments = couinaud_segments(known.liver).value();
  VesselTrees trees;
  for (int n = 0; n < 6; ++n) {  // twigs in the first voxels of segments
    for (std::size_t i = 0; i < segments.segment.values.size(); ++i) {
      if (segments.segment.values[i] != n + 3) continue;
      const auto& size = known.liver.grid.size;
      const int x = static_cast<int>(i) % size[0], y = static_cast<int>(i) / size[0] % size[1],
                z = static_cast<int>(i) / size[0] / size[1];
      TreeBranch twig;
      twig.points = {{known.liver.grid.position_mm(x, y, z), 1.0 + n}};
      trees.branches.push_back(twig);
      trees.branches.push_back(twig);
      break;
    }
  }
  name_branches(trees, segments);
  std::set<std::string> names;
  for (const TreeBranch& branch : trees.branches) names.insert(branch.name);
  EXPECT_EQ(names.size(), trees.branches.size());
  EXPECT_THAT(names, testing::IsSupersetOf({"portal/right/posterior/VI", "portal/right/posterior/VI/2"}));
}

}  // namespace
}  // namespace glisson::vasculature

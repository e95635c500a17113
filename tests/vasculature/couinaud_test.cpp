// Segments of generated patients, whose segments are known, and what is refused.

#include <gmock/gmock.h>
#include <algorithm>
#include <cmath>
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

// A vein 20 mm away from where the shape has its border, in a liver by its shape alone.
TEST(Couinaud, ABorderFollowsTheVeinThatSomebodyNamed) {
  const Known known = known_liver(24, 3);
  const auto before = couinaud_segments(known.liver).value();
  const auto at = [](const CouinaudSegments& segments, const Vector3d& place_mm) {
    const Vector3d index = segments.segment.grid.index_of(place_mm);
    return segments.segment.at(static_cast<int>(std::lround(index.x())), static_cast<int>(std::lround(index.y())),
                               static_cast<int>(std::lround(index.z())));
  };
  // Along one row from right to left: where IV begins, the border along the middle hepatic vein.
  Vector3d sum = Vector3d::Zero();
  double voxels = 0;
  const imaging::Grid& grid = known.liver.grid;
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i + 1 < grid.size[0]; ++i) {
        const int a = before.segment.at(i, j, k), b = before.segment.at(i + 1, j, k);
        if (std::min(a, b) != 4 || (std::max(a, b) != 5 && std::max(a, b) != 8)) continue;
        sum += grid.position_mm(i, j, k);
        ++voxels;
      }
    }
  }
  ASSERT_GT(voxels, 0);
  const Vector3d middle_mm = sum / voxels, vein_mm = middle_mm - Vector3d(15, 0, 0);
  EXPECT_NE(at(before, vein_mm + Vector3d(7, 0, 0)), 4);
  VesselTrees trees;
  trees.portal_entry_mm = expected_entries(known.liver).value().portal_mm;
  trees.hepatic_entry_mm = expected_entries(known.liver).value().hepatic_mm;
  TreeBranch vein;
  vein.system = System::hepatic_vein;
  vein.confidence = 0.5;  // says nothing but by its name
  for (int z = -10; z <= 10; ++z) vein.points.push_back({vein_mm + Vector3d(0, 0, z), 3});
  TreeBranch elsewhere = vein;
  elsewhere.confidence = 1;
  elsewhere.points = {{vein_mm + Vector3d(0, 0, 20), 1.3}, {vein_mm + Vector3d(0, 0, 21), 1.3}};
  trees.branches = {vein, elsewhere};
  trees.clicks = {{Vessel::middle_hepatic_vein, vein_mm}};
  const auto after = couinaud_segments(known.liver, &trees).value();
  EXPECT_EQ(at(after, vein_mm + Vector3d(7, 0, 0)), 4);
  EXPECT_NE(at(after, vein_mm - Vector3d(10, 0, 0)), 4);
  const auto along_vein_ml = [](const CouinaudSegments& segments) {
    for (const BorderDoubt& doubt : segments.border_doubts) {
      if (doubt.vessel == Vessel::middle_hepatic_vein) return doubt.doubt_ml;
    }
    return -1.0;
  };
  EXPECT_LT(along_vein_ml(after), along_vein_ml(before)) << "what was told is less in doubt";
  EXPECT_TRUE(std::is_sorted(after.border_doubts.begin(), after.border_doubts.end(),
                             [](const auto& a, const auto& b) { return a.doubt_ml > b.doubt_ml; }));
}

// Whether both segments lie among the eight voxels around the place.
bool passes(const imaging::LabelMap& segments, const BorderPlace& place) {
  const Vector3d index = segments.grid.index_of(place.position_mm);
  std::set<int> around;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3d at = index.array().floor().matrix() + Vector3d(corner & 1, corner >> 1 & 1, corner >> 2);
    around.insert(segments.at(static_cast<int>(at.x()), static_cast<int>(at.y()), static_cast<int>(at.z())));
  }
  return around.count(place.segments[0]) != 0 && around.count(place.segments[1]) != 0;
}

double doubt_ml(const CouinaudSegments& segments) {
  double sum = 0;
  for (const BorderDoubt& doubt : segments.border_doubts) sum += doubt.doubt_ml;
  return sum;
}

TEST(Couinaud, BordersPassWhereAHandSetThemAndTheRestFollows) {
  const Known known = known_liver(25, 2);
  const BorderPlaces drawn = glisson::test::middles_of_borders(known.segments);
  ASSERT_GE(drawn.size(), 8u);
  const auto before = couinaud_segments(known.liver).value();
  int passed_before = 0;
  for (const BorderPlace& place : drawn) passed_before += passes(before.segment, place) ? 1 : 0;
  EXPECT_LT(passed_before, static_cast<int>(drawn.size()) / 2) << "most borders lie elsewhere by the shape alone";
  for (const BorderPlace& place : drawn) {
    const auto found = couinaud_segments(known.liver, nullptr, {place});
    ASSERT_TRUE(found) << border_text(place) << ": " << found.error().message();
    EXPECT_TRUE(passes(found->segment, place)) << border_text(place);
  }
  const auto found = couinaud_segments(known.liver, nullptr, drawn);
  ASSERT_TRUE(found) << found.error().message();
  for (const BorderPlace& place : drawn) EXPECT_TRUE(passes(found->segment, place)) << border_text(place);
  EXPECT_LT(doubt_ml(*found), 0.7 * doubt_ml(before)) << "what was told is less in doubt";
  const double dice_before = glisson::test::score_of(before.segment, known.segments).dice[0];
  EXPECT_GT(glisson::test::score_of(found->segment, known.segments).dice[0], dice_before + 0.05);
}

TEST(Couinaud, BordersThatCannotPassThereAreRefusedWithASentence) {
  const Known known = known_liver(25, 3);
  const BorderPlaces drawn = glisson::test::middles_of_borders(known.segments);
  const auto of = [&](const std::string& name) {
    const auto found = std::find_if(drawn.begin(), drawn.end(),
                                    [&](const BorderPlace& place) { return border_name(place.segments) == name; });
    return found->position_mm;
  };
  const auto outside = couinaud_segments(known.liver, nullptr, {{{5, 8}, {0, 0, 4000}}});
  ASSERT_FALSE(outside);
  EXPECT_EQ(outside.error().code, "border-outside");
  EXPECT_THAT(outside.error().message(), testing::HasSubstr("0.0,0.0,4000.0"));
  const auto both = couinaud_segments(known.liver, nullptr, {{{5, 8}, of("V-VIII")}, {{2, 3}, of("V-VIII")}});
  ASSERT_FALSE(both);
  EXPECT_EQ(both.error().code, "borders-contradict");
  EXPECT_THAT(both.error().message(), testing::HasSubstr("take one of the places back"));
  const imaging::Grid& grid = known.liver.grid;
  Vector3d right_most_mm = of("VI-VII");
  for (int i = 0; i < grid.size[0]; ++i) {
    for (int k = 0; k < grid.size[2]; ++k) {
      const Vector3d index = grid.index_of(right_most_mm);
      const Vector3d here = grid.position_mm(i, static_cast<int>(std::lround(index.y())), k);
      if (known.liver.at(i, static_cast<int>(std::lround(index.y())), k) != 0 && here.x() < right_most_mm.x()) {
        right_most_mm = here;
      }
    }
  }
  const auto far = couinaud_segments(known.liver, nullptr, {{{2, 3}, right_most_mm}});
  ASSERT_FALSE(far);
  EXPECT_EQ(far.error().code, "border-far");
  EXPECT_EQ(couinaud_segments(known.liver, nullptr, BorderPlaces(201, drawn.front())).error().code, "borders-many");
  EXPECT_EQ(border_named("VIII-V"), (SegmentPair{5, 8}));
  for (const char* none : {"II-VII", "V-V", "IX-I", "V", ""}) EXPECT_FALSE(border_named(none)) << none;
  EXPECT_FALSE(border_of_text("V-VIII=1,2"));
  const BorderPlace place{{5, 8}, {1.5, -2, 0.1}};
  EXPECT_EQ(border_of_text(border_text(place)), place);
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

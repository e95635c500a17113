#include "segmentation/grow.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <iostream>
#include <limits>
#include <random>

#include "base/parallel.h"
#include "deepest.h"
#include "imaging/filters.h"
#include "imaging/read_series.h"
#include "imaging/study.h"
#include "imaging/volume_file.h"
#include "segmentation/edit.h"
#include "segmentation/resample.h"
#include "segmentation/structures.h"
#include "support/data.h"

namespace glisson::segmentation {
namespace {

using Eigen::Vector3d;
using imaging::Mask;
using imaging::Volume;

constexpr int liver_label = 5;  // of TotalSegmentator

struct Case {
  Volume image;
  Mask liver;       // drawn by a network, not by hand
  Mask main_piece;  // the slab of the MR cuts the left lobe off: a seed cannot reach it through the missing slices
};

Case read_case(const std::string& image, const std::string& labels) {
  const auto folder = test::shared_data() / "totalseg_abdomen_mr_ct";
  const auto label_map = imaging::read_labels_file(folder / (labels + ".nii.gz"));
  Mask liver = mask_of_label(label_map.value(), liver_label);
  Mask main_piece = keep_largest(liver);
  return {imaging::read_volume_file(folder / (image + ".nii.gz")).value(), std::move(liver), std::move(main_piece)};
}

Vector3d position_mm(const imaging::Grid& grid, std::size_t voxel) {
  const auto nx = static_cast<std::size_t>(grid.size[0]), ny = static_cast<std::size_t>(grid.size[1]);
  return grid.position_mm(static_cast<int>(voxel % nx), static_cast<int>(voxel / nx % ny),
                          static_cast<int>(voxel / (nx * ny)));
}

std::vector<float> depths_mm(const Mask& mask) {
  Mask outside = mask;
  for (auto& value : outside.values) value = value == 0 ? 1 : 0;
  std::vector<float> depths = imaging::squared_distances_mm2(outside);
  for (float& depth : depths) depth = std::sqrt(depth);
  return depths;
}

// Dice of several growths, each from `seeds_each` random voxels of the liver's main piece at least `depth_mm` deep.
std::vector<double> dice_from_random_seeds(const Case& c, int growths, int seeds_each, float depth_mm) {
  const std::vector<float> depths = depths_mm(c.main_piece);
  std::vector<std::size_t> choice;
  for (std::size_t voxel = 0; voxel < depths.size(); ++voxel) {
    if (c.main_piece.values[voxel] != 0 && depths[voxel] >= depth_mm) choice.push_back(voxel);
  }
  std::mt19937 random(2026);
  std::vector<double> found;
  for (int n = 0; n < growths; ++n) {
    std::vector<Vector3d> seeds_mm;
    for (int s = 0; s < seeds_each; ++s) {
      seeds_mm.push_back(position_mm(c.image.grid, choice[random() % choice.size()]));
    }
    const auto grown = grow_from_seeds(c.image, seeds_mm);
    found.push_back(grown ? dice(grown->mask, c.liver).value() : 0.0);
  }
  std::sort(found.begin(), found.end());
  return found;
}

// A click on what the first growth left out most of: the deepest point of the largest piece that is missing.
double dice_after_second_click(const Case& c, const Vector3d& first_mm, const Mask& grown) {
  const Mask missing = keep_largest(subtracted(c.liver, grown));
  if (voxel_count(missing) == 0) return dice(grown, c.liver).value();
  const auto again = grow_from_seeds(c.image, {first_mm, deepest_mm(missing)});
  return again ? dice(again->mask, c.liver).value() : 0.0;
}

double median(const std::vector<double>& sorted) {
  return 0.5 * (sorted[(sorted.size() - 1) / 2] + sorted[sorted.size() / 2]);
}

void print_row(const std::string& name, const std::vector<double>& sorted) {
  std::cout << "  " << name << ": Dice min " << sorted.front() << ", median " << median(sorted) << ", max "
            << sorted.back() << " (" << sorted.size() << " growths)\n";
}

class RealLiver : public testing::TestWithParam<std::pair<const char*, const char*>> {};

// The table of Dice figures in docs/real-data.md comes from here, and says which images were for tuning and which were
// judged. The limits lie a little below what was measured; the labels are a network's.
TEST_P(RealLiver, IsFoundFromWhereverTheSeedsLie) {
  GLISSON_NEEDS_DATA("totalseg_abdomen_mr_ct");
  const Case c = read_case(GetParam().first, GetParam().second);
  const auto grown = grow_from_seeds(c.image, {deepest_mm(c.main_piece)});
  ASSERT_TRUE(grown) << grown.error().message();
  const double from_centre = dice(grown->mask, c.liver).value();
  std::cout << GetParam().first << ": from the deepest point Dice " << from_centre << ", " << grown->volume_ml
            << " ml of " << volume_ml(c.liver) << " ml, tissue " << grown->tissue_mean << " +- " << grown->tissue_sd
            << ", " << grown->rounds << " rounds\n";
  for (const auto& doubt : grown->doubts) std::cout << "    " << doubt.sentence.message() << "\n";
  std::cout << "  two clicks: Dice " << dice_after_second_click(c, deepest_mm(c.main_piece), grown->mask) << "\n";
  const std::vector<double> one = dice_from_random_seeds(c, c.image.grid.size[2] > 50 ? 1 : 6, 1, 6);
  const std::vector<double> three = dice_from_random_seeds(c, c.image.grid.size[2] > 50 ? 1 : 3, 3, 6);
  print_row("one seed, 6 mm or deeper", one);
  print_row("three seeds, 6 mm or deeper", three);
  EXPECT_GT(from_centre, 0.88);
  EXPECT_GT(median(one), 0.88);
  EXPECT_GT(one.front(), 0.85);
  EXPECT_GT(median(three), 0.88);
  EXPECT_FALSE(grown->probably_leaked());
}

INSTANTIATE_TEST_SUITE_P(Grow, RealLiver,
                         testing::Values(std::pair{"example_mr_sm", "example_seg_mr"},
                                         std::pair{"example_ct_sm", "example_seg"},
                                         std::pair{"example_ct", "example_seg_fast_force_split"}),
                         [](const auto& tested) { return std::string(tested.param.first); });

// Three slices of another scanner, with a hand-made outline that goes around the fat too. For tuning.
TEST(Grow, TheBorderLiesWhereAHandDrewIt) {
  GLISSON_NEEDS_DATA("dcmqi_liver_seg_ct3");
  const auto folder = test::shared_data() / "dcmqi_liver_seg_ct3";
  const Volume image = imaging::read_series(imaging::scan(folder / "ct-3slice").value().series.front()).value();
  const Mask liver =
      resample(mask_of_label(imaging::read_labels_file(folder / "liver_seg.nrrd").value(), 1), image.grid);
  const auto grown = grow_from_seeds(image, {deepest_mm(liver)});
  ASSERT_TRUE(grown) << grown.error().message();
  const double overlap = dice(grown->mask, liver).value();
  std::cout << "dcmqi: Dice " << overlap << ", " << grown->volume_ml << " ml of " << volume_ml(liver) << "\n";
  EXPECT_GT(overlap, 0.93);  // 0.914 before the border was sought in the image
  EXPECT_NEAR(grown->volume_ml, volume_ml(liver), 0.13 * volume_ml(liver));
}

// Between the arms this CT is 30 HU darker and noisier. For tuning: the rule that tries wider tolerances was made here.
TEST(Grow, CrossesTheDarkBandOfACt) {
  GLISSON_NEEDS_DATA("totalseg_abdomen_mr_ct");
  const auto folder = test::shared_data() / "totalseg_abdomen_mr_ct";
  Volume image = imaging::read_series(imaging::scan(folder / "example_ct_dicom").value().series.front()).value();
  const auto labels = imaging::read_labels_file(folder / "example_seg_dicom.nii.gz");
  Mask liver = resample(mask_of_label(labels.value(), liver_label), image.grid);
  Mask main_piece = keep_largest(liver);
  const Case c{std::move(image), std::move(liver), std::move(main_piece)};
  const auto grown = grow_from_seeds(c.image, {deepest_mm(c.main_piece)});
  ASSERT_TRUE(grown) << grown.error().message();
  const double overlap = dice(grown->mask, c.liver).value();
  std::cout << "example_ct_dicom: Dice " << overlap << ", " << grown->volume_ml << " ml of " << volume_ml(c.liver)
            << "\n";
  EXPECT_GT(overlap, 0.95);  // 0.356 before
  EXPECT_FALSE(grown->probably_leaked());
  const std::vector<double> one = dice_from_random_seeds(c, 3, 1, 6);
  print_row("one seed, 6 mm or deeper", one);
  EXPECT_GT(median(one), 0.95);
  EXPECT_GT(one.front(), 0.95);  // in the bright part: 0.785 where only twice the volume was enough
}

// Its coil's light falls off, so that much of the border is unsure, and wider tolerances end in the air around it.
TEST(Grow, StaysInTheBodyOfAMouse) {
  GLISSON_NEEDS_DATA("mouse_abdomen_mr_dicom");
  const Volume image =
      imaging::read_series(imaging::scan(test::shared_data() / "mouse_abdomen_mr_dicom").value().series.front())
          .value();
  const auto grown = grow_from_seeds(image, {Vector3d(-32, 7.4, -0.9)});
  ASSERT_TRUE(grown) << grown.error().message();
  EXPECT_LT(grown->volume_ml, 5);  // 125 with the air
  EXPECT_FALSE(grown->probably_leaked());
}

// The bile, stomach and muscle at this slab's liver look much like it.
TEST(Grow, SaysWhereItIsUnsure) {
  GLISSON_NEEDS_DATA("totalseg_abdomen_mr_ct");
  const Case c = read_case("example_mr_sm", "example_seg_mr");
  const auto grown = grow_from_seeds(c.image, {deepest_mm(c.main_piece)});
  ASSERT_TRUE(grown) << grown.error().message();
  EXPECT_TRUE(std::any_of(grown->doubts.begin(), grown->doubts.end(),
                          [](const auto& doubt) { return doubt.kind == GrowthDoubt::unsure_border; }));
  ASSERT_FALSE(grown->unsure_places_mm.empty());
}

// An ellipsoid of 100 in 60, with a spread of 10 and a drift of 0.2 % a mm: 36 % from one end to the other.
Volume drifting_phantom() {
  Volume image;
  image.grid.size = {80, 70, 40};
  image.grid.spacing_mm = {3, 3, 4};
  image.grid.direction = Eigen::AngleAxisd(0.3, Vector3d::UnitX()).toRotationMatrix();
  image.values.resize(image.grid.voxels());
  std::mt19937 random(1);
  std::normal_distribution<float> noise(0, 10);
  for (int k = 0; k < 40; ++k)
    for (int j = 0; j < 70; ++j)
      for (int i = 0; i < 80; ++i) {
        const Vector3d off_mm = Vector3d(3 * i, 3 * j, 4 * k) - Vector3d(120, 105, 80);
        const bool inside = off_mm.cwiseQuotient(Vector3d(90, 75, 60)).norm() < 1;
        image.at(i, j, k) = (inside ? 100.0F : 60.0F) * static_cast<float>(1 + 0.002 * off_mm.x()) + noise(random);
      }
  return image;
}

Vector3d phantom_center_mm(const Volume& image) { return image.grid.position_mm(Vector3d(40, 35, 20)); }

TEST(Grow, FollowsADrift) {
  const Volume image = drifting_phantom();
  const auto grown = grow_from_seeds(image, {phantom_center_mm(image)});
  ASSERT_TRUE(grown) << grown.error().message();
  const double truth_ml = 4.0 / 3.0 * 3.14159265 * 90 * 75 * 60 / 1000;
  EXPECT_NEAR(grown->volume_ml, truth_ml, 0.1 * truth_ml);
  EXPECT_TRUE(grown->doubts.empty());
}

TEST(Grow, IsTheSameWhateverTheNumberOfThreads) {
  const Volume image = drifting_phantom();
  set_thread_count(1);
  const auto alone = grow_from_seeds(image, {phantom_center_mm(image)});
  set_thread_count(0);
  EXPECT_EQ(alone->mask.values, grow_from_seeds(image, {phantom_center_mm(image)})->mask.values);
}

TEST(Grow, SurvivesVoxelsThatAreNotNumbers) {
  Volume image = drifting_phantom();
  for (std::size_t voxel = 0; voxel < image.values.size(); voxel += 97) {
    image.values[voxel] = voxel % 2 == 0 ? std::nanf("") : std::numeric_limits<float>::infinity();
  }
  const auto grown = grow_from_seeds(image, {phantom_center_mm(image)});
  ASSERT_TRUE(grown) << grown.error().message();
  EXPECT_GT(grown->volume_ml, 1000);
}

TEST(Grow, RefusesInOneClearSentence) {
  const Volume image = drifting_phantom();
  const Vector3d center_mm = phantom_center_mm(image);
  EXPECT_EQ(grow_from_seeds(image, {}).error().code, "grow-no-seeds");

  const auto outside = grow_from_seeds(image, {center_mm, image.grid.position_mm(Vector3d(-10.5, 3, 3))});
  EXPECT_EQ(outside.error().code, "grow-seed-outside");
  EXPECT_THAT(outside.error().message(), testing::HasSubstr("Seed 2"));
  EXPECT_THAT(outside.error().message(), testing::HasSubstr("30.0 mm"));  // ten voxels of 3 mm beyond the first cell
  EXPECT_EQ(grow_from_seeds(image, {Vector3d::Constant(std::nan(""))}).error().code, "grow-seed-outside");

  Volume constant = image;
  std::fill(constant.values.begin(), constant.values.end(), 5.0F);
  EXPECT_EQ(grow_from_seeds(constant, {center_mm}).error().code, "grow-constant-image");
  std::fill(constant.values.begin(), constant.values.end(), std::nanf(""));
  EXPECT_EQ(grow_from_seeds(constant, {center_mm}).error().code, "grow-constant-image");

  Volume hollow = image;
  for (int k = 10; k < 30; ++k)
    for (int j = 20; j < 50; ++j)
      for (int i = 25; i < 55; ++i) hollow.at(i, j, k) = std::nanf("");
  EXPECT_EQ(grow_from_seeds(hollow, {center_mm}).error().code, "grow-seed-on-nothing");

  EXPECT_EQ(grow_from_seeds(Volume{}, {center_mm}).error().code, "grow-bad-image");
  GrowOptions options;
  options.neck_radius_mm = -1;
  EXPECT_EQ(grow_from_seeds(image, {center_mm}, options).error().code, "grow-bad-options");
  options = {};
  options.neck_radius_mm = 200;
  EXPECT_EQ(grow_from_seeds(image, {center_mm}, options).error().code, "grow-nothing-found");
}

TEST(Grow, CanBeCancelled) {
  const Volume image = drifting_phantom();
  std::stop_source stop;
  stop.request_stop();
  const auto grown = grow_from_seeds(image, {phantom_center_mm(image)}, {}, Progress({}, stop.get_token()));
  EXPECT_EQ(grown.error().code, "cancelled");
}

}  // namespace
}  // namespace glisson::segmentation

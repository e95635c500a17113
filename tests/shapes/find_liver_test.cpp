// The liver by brightness and shape together, on SIMULATED images of nobody's liver.

#include "shapes/find_liver.h"

#include <gmock/gmock.h>

#include "../segmentation/deepest.h"
#include "anatomy/patient.h"
#include "base/parallel.h"
#include "segmentation/edit.h"
#include "segmentation/structures.h"
#include "shapes/model_placing.h"
#include "shapes/smooth_model.h"
#include "simulated_abdomen.h"

namespace glisson::shapes {
namespace {

using Eigen::Vector3d;

// A generated liver that is not the model's mean: another volume, other proportions.
const test::SimulatedAbdomen& abdomen() {
  static const test::SimulatedAbdomen made = [] {
    anatomy::PatientOptions options;
    options.seed = 7;
    options.volume_ml = 1350;
    return test::simulated_abdomen(anatomy::make_liver_surface(options, 4).value(), test::Looks::portal_ct, 3, 4);
  }();
  return made;
}

const ShapeModel& model() {
  static const ShapeModel made = smooth_model({.reference_spacing_mm = 11}).value();
  return made;
}

double dice(const imaging::Mask& a, const imaging::Mask& b) { return segmentation::dice(a, b).value(); }

}  // namespace

TEST(SmoothModel, VariesAsItWasAsked) {
  const SmoothModelOptions options{.reference_spacing_mm = 11};
  const ShapeModel& smooth = model();
  EXPECT_EQ(smooth.livers, 0);
  EXPECT_EQ(smooth.rank(), options.modes);
  EXPECT_TRUE(is_watertight(smooth.mean));
  // What the modes hold and what they leave make up the deviation at each point.
  for (Eigen::Index p = 0; p < smooth.residual_sd_mm.size(); p += 50) {
    const double held = smooth.modes_mm.row(3 * p).squaredNorm();
    EXPECT_NEAR(std::sqrt(held + std::pow(smooth.residual_sd_mm[p], 2)), options.deviation_mm, 0.1);
  }
}

TEST(FindLiver, NeedsNoPoint) {
  const auto found = find_liver(abdomen().image, model());
  ASSERT_TRUE(found) << found.error().message();
  const double overlap = dice(found->liver.mask, abdomen().liver);
  std::cout << "no point: Dice " << overlap << "\n";
  EXPECT_GT(overlap, 0.9);
  EXPECT_GT(found->seen_fraction, 0.5);
}

TEST(FindLiver, HoldsThePointsGiven) {
  const Vector3d seed_mm = segmentation::deepest_mm(abdomen().liver);
  const auto found = find_liver(abdomen().image, model(), {{seed_mm}, {}});
  ASSERT_TRUE(found) << found.error().message();
  const double overlap = dice(found->liver.mask, abdomen().liver);
  std::cout << "one point: Dice " << overlap << "\n";
  EXPECT_GT(overlap, 0.9);
  const Eigen::Vector3i at = abdomen().image.grid.index_of(seed_mm).array().round().cast<int>();
  EXPECT_EQ(found->liver.mask.at(at.x(), at.y(), at.z()), 1);
}

// A click into the heart or the stomach takes away what was held of it, and nothing else.
TEST(FindLiver, LeavesOutThePointsGivenOutside) {
  const Vector3d seed_mm = segmentation::deepest_mm(abdomen().liver);
  const auto before = find_liver(abdomen().image, model(), {{seed_mm}, {}});
  ASSERT_TRUE(before);
  const imaging::Mask wrong = segmentation::keep_largest(segmentation::subtracted(before->liver.mask, abdomen().liver));
  const Vector3d click_mm = segmentation::deepest_mm(wrong);
  const auto after = find_liver(abdomen().image, model(), {{seed_mm}, {click_mm}});
  ASSERT_TRUE(after) << after.error().message();
  const Eigen::Vector3i at = abdomen().image.grid.index_of(click_mm).array().round().cast<int>();
  EXPECT_EQ(before->liver.mask.at(at.x(), at.y(), at.z()), 1);
  EXPECT_EQ(after->liver.mask.at(at.x(), at.y(), at.z()), 0);
  EXPECT_GE(dice(after->liver.mask, abdomen().liver), dice(before->liver.mask, abdomen().liver) - 0.005);
  // Also in the middle of the liver, where every hole would be filled.
  const auto hole = find_liver(abdomen().image, model(), {{}, {seed_mm}});
  ASSERT_TRUE(hole) << hole.error().message();
  const Eigen::Vector3i middle = abdomen().image.grid.index_of(seed_mm).array().round().cast<int>();
  EXPECT_EQ(hole->liver.mask.at(middle.x(), middle.y(), middle.z()), 0);
}

// The shape of three slices is no liver's.
TEST(FindLiver, IsWhatGrowsWhereNoShapeFits) {
  imaging::Volume slab{abdomen().image};
  const Vector3d seed_mm = segmentation::deepest_mm(abdomen().liver);
  const int middle = static_cast<int>(std::round(slab.grid.index_of(seed_mm).z()));
  slab.grid.origin_mm = slab.grid.position_mm(0, 0, middle - 1);
  const auto slice = static_cast<std::size_t>(slab.grid.size[0]) * static_cast<std::size_t>(slab.grid.size[1]);
  slab.grid.size[2] = 3;
  const auto first = abdomen().image.values.begin() + static_cast<std::ptrdiff_t>(slice) * (middle - 1);
  slab.values.assign(first, first + 3 * static_cast<std::ptrdiff_t>(slice));
  EXPECT_FALSE(find_liver(slab, model()));
  const auto found = find_liver(slab, model(), {{seed_mm}, {}});
  ASSERT_TRUE(found) << found.error().message();
  EXPECT_TRUE(found->by_brightness_alone);
}

// No liver of the mean's shape reaches from a seed to the image's corner.
TEST(FindLiver, IsPlacedByItsFirstPointWhereNoPlaceHoldsAll) {
  const Vector3d seed_mm = segmentation::deepest_mm(abdomen().liver);
  const auto& grid = abdomen().image.grid;
  const Vector3d corner_mm = grid.position_mm(grid.size[0] - 2, grid.size[1] - 2, grid.size[2] - 2);
  const auto by_first = place_model(abdomen().image, model(), {seed_mm});
  const auto by_both = place_model(abdomen().image, model(), {seed_mm, corner_mm});
  ASSERT_TRUE(by_first);
  ASSERT_TRUE(by_both) << by_both.error().message();
  EXPECT_EQ(by_both->shift_mm, by_first->shift_mm);
  EXPECT_FALSE(place_model(abdomen().image, model(), {corner_mm, seed_mm}));  // what is first counts
}

TEST(FindLiver, IsTheSameWhateverTheNumberOfThreads) {
  set_thread_count(1);
  const auto alone = find_liver(abdomen().image, model());
  set_thread_count(0);
  EXPECT_EQ(alone->liver.mask.values, find_liver(abdomen().image, model())->liver.mask.values);
}

TEST(FindLiver, SaysThatThereIsNone) {
  // Noise alone; and a body whose liver is fat.
  imaging::Volume noise = abdomen().image;
  std::mt19937 random(1);
  std::normal_distribution<float> normal(60, 200);
  for (float& value : noise.values) value = normal(random);
  const auto in_noise = find_liver(noise, model());
  ASSERT_FALSE(in_noise);
  EXPECT_EQ(in_noise.error().code, "shapes-no-liver-found");

  imaging::Volume constant = abdomen().image;
  std::fill(constant.values.begin(), constant.values.end(), 60.0F);
  const auto in_constant = find_liver(constant, model());
  ASSERT_FALSE(in_constant);
  EXPECT_EQ(in_constant.error().code, "shapes-no-liver-found");

  const auto nothing = find_liver(imaging::Volume{}, model());
  ASSERT_FALSE(nothing);
  EXPECT_EQ(nothing.error().code, "grow-bad-image");
}

TEST(FindLiver, RefusesAPointOutsideTheImage) {
  const auto found = find_liver(abdomen().image, model(), {{Vector3d(5000, 0, 0)}, {}});
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, "grow-seed-outside");
}

TEST(FindLiver, CanBeCancelled) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(find_liver(abdomen().image, model(), {}, {}, Progress({}, stop.get_token())).error().code, "cancelled");
}

}  // namespace glisson::shapes

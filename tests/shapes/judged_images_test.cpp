// What the shape adds: Dice by growing alone, from a point and from none, with a model of real livers and with
// nobody's. Judged on images that nothing was tuned on; docs/real-data.md has the figures and the rule.

#include <gmock/gmock.h>
#include <cstdlib>

#include "../segmentation/deepest.h"
#include "imaging/volume_file.h"
#include "segmentation/edit.h"
#include "segmentation/grow.h"
#include "segmentation/structures.h"
#include "shapes/find_liver.h"
#include "shapes/liver_outline.h"
#include "shapes/model_file.h"
#include "shapes/smooth_model.h"
#include "simulated_abdomen.h"
#include "studies/dissertation/shapes_study.h"
#include "support/data.h"

namespace glisson::shapes {
namespace {

using Eigen::Vector3d;
using imaging::Mask;

// A model of the livers for tuning ("study shapes --judge tuning"); none is shipped.
std::optional<ShapeModel> model_of_real_livers() {
  const char* file = std::getenv("GLISSON_SHAPE_MODEL");
  if (file == nullptr) return std::nullopt;
  auto model = read_model(file);
  EXPECT_TRUE(model) << model.error().message();
  return model ? std::optional(std::move(*model)) : std::nullopt;
}

double dice(const Mask& a, const Mask& b) { return segmentation::dice(a, b).value(); }

struct Scores {
  double grown = 0, seed = 0, two_clicks = 0, none = 0, nobodys_seed = 0, nobodys_none = 0;
};

double dice_of(const Result<FoundLiver>& found, const Mask& truth) {
  if (!found) std::cout << "    " << found.error().message() << "\n";
  return found ? dice(found->liver.mask, truth) : 0;
}

Scores judged(const imaging::Volume& image, const Mask& truth, const ShapeModel& model) {
  static const ShapeModel nobodys = smooth_model().value();
  const Vector3d seed_mm = segmentation::deepest_mm(segmentation::keep_largest(truth));
  Scores scores;
  const auto grown = segmentation::grow_from_seeds(image, {seed_mm});
  scores.grown = grown ? dice(grown->mask, truth) : 0;
  const auto found = find_liver(image, model, {seed_mm});
  scores.seed = scores.two_clicks = dice_of(found, truth);
  if (found) {
    // A click on what was left out most: the deepest point of the largest piece that is missing.
    const Mask missing = segmentation::keep_largest(segmentation::subtracted(truth, found->liver.mask));
    if (segmentation::voxel_count(missing) > 0) {
      scores.two_clicks = dice_of(find_liver(image, model, {seed_mm, segmentation::deepest_mm(missing)}), truth);
    }
  }
  scores.none = dice_of(find_liver(image, model), truth);
  scores.nobodys_seed = dice_of(find_liver(image, nobodys, {seed_mm}), truth);
  scores.nobodys_none = dice_of(find_liver(image, nobodys), truth);
  return scores;
}

void print(const std::string& name, const Scores& scores) {
  std::cout << name << ": grown " << scores.grown << ", shape and one point " << scores.seed << ", two points "
            << scores.two_clicks << ", no point " << scores.none << ", nobody's and one point " << scores.nobodys_seed
            << ", nobody's and no point " << scores.nobodys_none << std::endl;
}

void print_summary(const char* what, std::vector<double> values) {
  std::sort(values.begin(), values.end());
  std::cout << what << ": min " << values.front() << ", median "
            << 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]) << " (" << values.size()
            << " images)\n";
}

}  // namespace

// The two judged images of docs/real-data.md.
TEST(JudgedImages, RealOnes) {
  GLISSON_NEEDS_DATA("totalseg_abdomen_mr_ct");
  const auto model = model_of_real_livers();
  if (!model) GTEST_SKIP() << "no model: set GLISSON_SHAPE_MODEL to the model.vtp of \"study shapes\"";
  const auto folder = test::shared_data() / "totalseg_abdomen_mr_ct";
  for (const auto& [name, labels] :
       {std::pair("example_ct", "example_seg_fast_force_split"), std::pair("example_ct_sm", "example_seg")}) {
    constexpr int liver_label = 5;
    const auto image = imaging::read_volume_file(folder / (std::string(name) + ".nii.gz")).value();
    const Mask truth = segmentation::mask_of_label(
        imaging::read_labels_file(folder / (std::string(labels) + ".nii.gz")).value(), liver_label);
    print(name, judged(image, truth, *model));
  }
}

// Every fourth liver for judging, from the first on; the looks take turns.
TEST(JudgedImages, SimulatedAroundRealLivers) {
  GLISSON_NEEDS_DATA("livers_couinaud");
  const auto model = model_of_real_livers();
  if (!model) GTEST_SKIP() << "no model: set GLISSON_SHAPE_MODEL to the model.vtp of \"study shapes\"";
  std::vector<double> grown, seed, two, none, nobodys_seed, nobodys_none;
  unsigned number = 0;
  for (const studies::ShapesLiver& liver : studies::shapes_livers(test::shared_data() / "livers_couinaud")) {
    if (liver.for_tuning || number++ % 4 != 0) continue;
    const auto outline = outline_of(imaging::read_labels_file(liver.file).value());
    if (!outline || outline->cut_off_at != nullptr) continue;
    const auto looks = static_cast<test::Looks>(number / 4 % 4);
    const auto made = test::simulated_abdomen(outline->surface, looks, 100 + number);
    const Scores scores = judged(made.image, made.liver, *model);
    print(liver.id + " " + test::name_of(looks), scores);
    grown.push_back(scores.grown);
    seed.push_back(scores.seed);
    two.push_back(scores.two_clicks);
    none.push_back(scores.none);
    nobodys_seed.push_back(scores.nobodys_seed);
    nobodys_none.push_back(scores.nobodys_none);
  }
  print_summary("grown from one point", grown);
  print_summary("shape and one point", seed);
  print_summary("shape and two points", two);
  print_summary("shape and no point", none);
  print_summary("nobody's shape and one point", nobodys_seed);
  print_summary("nobody's shape and no point", nobodys_none);
}

}  // namespace glisson::shapes

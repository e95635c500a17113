// What the shape adds: Dice by growing alone, from a point and from none, and after further clicks where a person would
// make them. GLISSON_SHAPE_MODEL says by which shapes: a model of real livers ("study shapes"; none is shipped), or
// "simulated", nobody's; without it there is nothing to judge. Judged on images that nothing was tuned on, and shown
// for those for tuning; docs/real-data.md has the figures and the rule.

#include <gmock/gmock.h>
#include <cstdlib>
#include <map>

#include "../segmentation/deepest.h"
#include "imaging/read_series.h"
#include "imaging/study.h"
#include "imaging/volume_file.h"
#include "segmentation/edit.h"
#include "segmentation/grow.h"
#include "segmentation/resample.h"
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

bool has_model() { return std::getenv("GLISSON_SHAPE_MODEL") != nullptr; }
const ShapeModel& chosen_model() {
  static const ShapeModel made = [](const std::string& shapes) {
    return shapes == "simulated" ? smooth_model().value() : read_model(shapes).value();
  }(std::getenv("GLISSON_SHAPE_MODEL"));
  return made;
}

// Of the noise and the neighbours in simulated contrasts: GLISSON_SIMULATED_SEED, for a judgement.
unsigned first_number() {
  const char* asked = std::getenv("GLISSON_SIMULATED_SEED");
  return asked != nullptr ? static_cast<unsigned>(std::stoul(asked)) : 200;
}

double dice(const Mask& a, const Mask& b) { return segmentation::dice(a, b).value(); }

struct Scores {
  double grown = 0, seed = 0, one_more = 0, two_more = 0, none = 0;
};

double dice_of(const Result<FoundLiver>& found, const Mask& truth) {
  if (!found) std::cout << "    " << found.error().message() << "\n";
  return found ? dice(found->liver.mask, truth) : 0;
}

// What is wrong most: the deepest point of the largest piece that is missing, or that is too much.
void click_on_the_worst(const Mask& found, const Mask& truth, segmentation::GivenPoints& points) {
  const Mask missing = segmentation::keep_largest(segmentation::subtracted(truth, found));
  const Mask wrong = segmentation::keep_largest(segmentation::subtracted(found, truth));
  const auto lacking = segmentation::voxel_count(missing), surplus = segmentation::voxel_count(wrong);
  if (std::max(lacking, surplus) == 0) return;
  if (lacking >= surplus)
    points.inside_mm.push_back(segmentation::deepest_mm(missing));
  else
    points.outside_mm.push_back(segmentation::deepest_mm(wrong));
}

Scores judged(const imaging::Volume& image, const Mask& truth) {
  segmentation::GivenPoints points{{segmentation::deepest_mm(segmentation::keep_largest(truth))}, {}};
  Scores scores;
  const auto grown = segmentation::grow_from_seeds(image, points.inside_mm);
  scores.grown = grown ? dice(grown->mask, truth) : 0;
  scores.none = dice_of(find_liver(image, chosen_model()), truth);
  auto found = find_liver(image, chosen_model(), points);
  scores.seed = scores.one_more = scores.two_more = dice_of(found, truth);
  for (double* after : {&scores.one_more, &scores.two_more}) {
    if (!found) break;
    click_on_the_worst(found->liver.mask, truth, points);
    found = find_liver(image, chosen_model(), points);
    *after = dice_of(found, truth);
  }
  return scores;
}

void print(const std::string& name, const Scores& scores) {
  std::cout << name << ": grown " << scores.grown << ", one point " << scores.seed << ", a click more "
            << scores.one_more << ", two clicks more " << scores.two_more << ", no point " << scores.none << std::endl;
}

void print_summary(const char* what, std::vector<double> values) {
  std::sort(values.begin(), values.end());
  std::cout << what << ": min " << values.front() << ", median "
            << 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]) << " (" << values.size()
            << " images)\n";
}

}  // namespace

// The two judged images of docs/real-data.md, and the slab of MR for tuning.
class LabelledImages : public testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(LabelledImages, OfOtherPeoplesNeighbours) {
  GLISSON_NEEDS_DATA("totalseg_abdomen_mr_ct");
  if (!has_model()) GTEST_SKIP() << "set GLISSON_SHAPE_MODEL";
  constexpr int liver_label = 5;
  const auto folder = test::shared_data() / "totalseg_abdomen_mr_ct";
  const auto [name, labels] = GetParam();
  const auto image = imaging::read_volume_file(folder / (std::string(name) + ".nii.gz")).value();
  const Mask truth = segmentation::mask_of_label(
      imaging::read_labels_file(folder / (std::string(labels) + ".nii.gz")).value(), liver_label);
  print(name, judged(image, truth));
}
INSTANTIATE_TEST_SUITE_P(JudgedImages, LabelledImages,
                         testing::Values(std::pair{"example_ct", "example_seg_fast_force_split"},
                                         std::pair{"example_ct_sm", "example_seg"}));
INSTANTIATE_TEST_SUITE_P(TuningImages, LabelledImages, testing::Values(std::pair{"example_mr_sm", "example_seg_mr"}));

// The CT of 20 slices, for tuning.
TEST(TuningImages, DicomCt) {
  GLISSON_NEEDS_DATA("totalseg_abdomen_mr_ct");
  if (!has_model()) GTEST_SKIP() << "set GLISSON_SHAPE_MODEL";
  constexpr int liver_label = 5;
  const auto folder = test::shared_data() / "totalseg_abdomen_mr_ct";
  const auto image = imaging::read_series(imaging::scan(folder / "example_ct_dicom").value().series.front()).value();
  const auto labels = imaging::read_labels_file(folder / "example_seg_dicom.nii.gz").value();
  print("example_ct_dicom",
        judged(image, segmentation::resample(segmentation::mask_of_label(labels, liver_label), image.grid)));
}

// Calls of_liver(id, surface, number) for each `every`th liver of a half, from number `first` (0 is the half's first)
// on, that lies whole in its image. `number` counts the half's livers from 1.
template <typename OfLiver>
void for_every(unsigned every, unsigned first, bool for_tuning, const OfLiver& of_liver) {
  unsigned number = 0;
  for (const studies::ShapesLiver& liver : studies::shapes_livers(test::shared_data() / "livers_couinaud")) {
    if (liver.for_tuning != for_tuning || number++ % every != first) continue;
    const auto outline = outline_of(imaging::read_labels_file(liver.file).value());
    if (outline && outline->cut_off_at == nullptr) of_liver(liver.id, outline->surface, number);
  }
}

// Every fourth liver of a half, from the first on; the looks take turns.
void simulated_around_every_fourth(bool for_tuning) {
  GLISSON_NEEDS_DATA("livers_couinaud");
  if (!has_model()) GTEST_SKIP() << "set GLISSON_SHAPE_MODEL";
  std::vector<double> grown, seed, one_more, two_more, none;
  for_every(4, 0, for_tuning, [&](const std::string& id, const auto& surface, unsigned number) {
    const auto looks = static_cast<test::Looks>(number / 4 % 4);
    const auto made = test::simulated_abdomen(surface, looks, 100 + number);
    const Scores scores = judged(made.image, made.liver);
    print(id + " " + test::name_of(looks), scores);
    grown.push_back(scores.grown);
    seed.push_back(scores.seed);
    one_more.push_back(scores.one_more);
    two_more.push_back(scores.two_more);
    none.push_back(scores.none);
  });
  print_summary("grown from one point", grown);
  print_summary("one point", seed);
  print_summary("a click more", one_more);
  print_summary("two clicks more", two_more);
  print_summary("no point", none);
}

// Each contrast around the same livers of a half, every eighth from the third on.
void simulated_contrasts(bool for_tuning) {
  GLISSON_NEEDS_DATA("livers_couinaud");
  if (!has_model()) GTEST_SKIP() << "set GLISSON_SHAPE_MODEL";
  using test::Looks;
  std::map<Looks, std::vector<double>> grown, seed, two_more, none;
  for_every(8, 2, for_tuning, [&](const std::string& id, const auto& surface, unsigned number) {
    for (const Looks looks : {Looks::portal_ct, Looks::native_ct, Looks::low_dose_ct, Looks::t1_mr, Looks::t2_mr,
                              Looks::in_phase_mr, Looks::opposed_phase_mr, Looks::fatty_opposed_mr}) {
      const auto made = test::simulated_abdomen(surface, looks, first_number() + number);
      const Scores scores = judged(made.image, made.liver);
      print(id + " " + test::name_of(looks), scores);
      grown[looks].push_back(scores.grown);
      seed[looks].push_back(scores.seed);
      two_more[looks].push_back(scores.two_more);
      none[looks].push_back(scores.none);
    }
  });
  EXPECT_EQ(seed.size(), 8U) << "not every contrast was judged";
  for (const auto& [looks, values] : seed) {
    const std::string name = test::name_of(looks);
    print_summary((name + ", grown").c_str(), grown[looks]);
    print_summary((name + ", one point").c_str(), values);
    print_summary((name + ", two clicks more").c_str(), two_more[looks]);
    print_summary((name + ", no point").c_str(), none[looks]);
  }
}
TEST(JudgedImages, SimulatedContrasts) { simulated_contrasts(false); }
TEST(TuningImages, SimulatedContrasts) { simulated_contrasts(true); }

TEST(JudgedImages, SimulatedAroundRealLivers) { simulated_around_every_fourth(false); }
TEST(TuningImages, SimulatedAroundRealLivers) { simulated_around_every_fourth(true); }

}  // namespace glisson::shapes

// Two cases of one generated patient, the left side of whose liver has grown by a known factor in between. What is
// found is what was put there. What may not be compared, or not without a word, is said.

#include "casefile/growth.h"

#include <gmock/gmock.h>

#include "anatomy/write_patient.h"
#include "base/files.h"
#include "casefile/belonging.h"
#include "casefile/import.h"
#include "casefile/plans.h"
#include "imaging/segments_file.h"
#include "imaging/volume_file.h"
#include "support/dicom_files.h"
#include "support/drawn_out.h"

namespace glisson::casefile {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

constexpr double factor = 1.4;

struct Labels {
  imaging::Mask liver, tumour;
  imaging::LabelMap segments;
};

// What the images say of themselves.
struct Images {
  std::string patient, date;
};

// Tissue of a segment without the tumour, ml; 0: all.
double tissue_ml(const Labels& labels, int segment) {
  double voxels = 0;
  for (std::size_t v = 0; v < labels.liver.values.size(); ++v) {
    const bool tissue = labels.liver.values[v] != 0 && labels.tumour.values[v] == 0;
    voxels += tissue && (segment == 0 || labels.segments.values[v] == segment) ? 1 : 0;
  }
  return voxels * labels.liver.grid.voxel_volume_mm3() / 1000;
}

class Growth : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TemporaryFolder;
    anatomy::PatientOptions options;
    options.seed = 31;
    options.lesions.emplace_back();
    const auto patient = anatomy::make_patient(options);
    ASSERT_TRUE(patient);
    ASSERT_TRUE(anatomy::write_patient(folder_->path(), *patient, {3, true}));
    const auto mask = [&](const char* name) {
      return imaging::read_mask_file(folder_->path() / "labels" / (std::string(name) + ".nrrd")).value().mask;
    };
    before_ = new Labels{mask("liver"), mask("tumour-1"),
                         imaging::read_labels_file(folder_->path() / "labels" / "couinaud.nrrd").value()};
    // The segments' own border between left and right would do as well: any plane is known.
    const glisson::test::DrawnOut growth{
        before_->liver.grid.position_mm(before_->liver.grid.size[0] / 2, 0, 0).x() + 1.5, factor};
    const imaging::Grid grid = growth.other_grid(before_->liver.grid);
    after_ = new Labels{growth.carried(before_->liver, grid), growth.carried(before_->tumour, grid),
                        growth.carried(before_->segments, grid)};
  }
  static void TearDownTestSuite() {
    delete before_;
    delete after_;
    delete folder_;
  }

  // With the segments of the truth as those that were found.
  Case made(const std::string& name, const Labels& labels, const std::optional<Images>& images = {},
            float shear_kPa = 0) {
    auto patient = Case::create(cases_.path() / (name + ".glisson"));
    EXPECT_TRUE(patient);
    if (images) {
      const fs::path slices = cases_.path() / (name + "-slices");
      fs::create_directories(slices);
      for (int k = 0; k < 3; ++k) {
        glisson::test::SliceSpec spec;
        spec.position_mm.z() = 3 * k;
        spec.instance_number = k + 1;
        const auto file = glisson::test::dicom_slice(spec);
        file->getDataset()->putAndInsertString(DCM_PatientID, images->patient.c_str());
        file->getDataset()->putAndInsertString(DCM_PatientName, ("Name^" + images->patient).c_str());
        file->getDataset()->putAndInsertString(DCM_StudyDate, images->date.c_str());
        glisson::test::save(*file, slices / (std::to_string(k) + ".dcm"));
      }
      const auto imported = import_study(*patient, imaging::scan(slices).value(), {});
      EXPECT_TRUE(imported) << imported.error().message();
    }
    const auto add = [&](const std::string& id, Provenance from,
                         const std::function<Result<void>(const fs::path&)>& write) {
      const auto added = patient->add(id, ".nrrd", std::move(from), write);
      EXPECT_TRUE(added) << added.error().message();
    };
    const auto add_mask = [&](const std::string& structure, const imaging::Mask& mask) {
      add("labels/" + structure, {"segment", {}, {}, {}, {}}, [&](const fs::path& file) {
        return imaging::write_mask_file(file, mask, imaging::SegmentInfo{structure, 1, {1, 0, 0}});
      });
    };
    add_mask("liver", labels.liver);
    add_mask("tumour-1", labels.tumour);
    const Provenance found{"territories", {{"from", "prior"}}, {"labels/liver"}, {}, {}};
    add(couinaud_id, found, [&](const fs::path& file) {
      return imaging::write_segments_file(file, labels.segments, couinaud_segment_infos());
    });
    const auto add_volume = [&](const std::string& id, const Provenance& from, float inside, const char* unit) {
      imaging::Volume volume{{labels.liver.grid, {}}, unit};
      for (const std::uint8_t value : labels.liver.values) volume.values.push_back(value != 0 ? inside : 0.0F);
      add(id, from, [&](const fs::path& file) { return imaging::write_volume_file(file, volume); });
    };
    add_volume("territories/doubt", found, 0, "%");
    if (shear_kPa > 0) add_volume("volumes/stiffness", {"import", {}, {}, {}, {}}, shear_kPa, "kPa");
    return *std::move(patient);
  }

  static void keep(Case& patient, const planning::Plan& plan) {
    const auto opened = open_planner(patient);
    ASSERT_TRUE(opened);
    const auto answer = opened->planner.answer(plan.cuts);
    ASSERT_TRUE(answer) << answer.error().message();
    ASSERT_TRUE(keep_plan(patient, plan, *answer, opened->planner.trees()));
  }

  static std::string refused(const Case& before, const Case& after, const GrowthQuestion& question = {}) {
    const auto compared = compare_studies(before, after, question);
    return compared ? "" : compared.error().code;
  }
  static std::string remarks(const ComparedStudies& compared) {
    std::string all;
    for (const std::string& remark : messages(compared.remarks)) all += remark + "\n";
    return all;
  }

  static TemporaryFolder* folder_;
  static Labels *before_, *after_;
  TemporaryFolder cases_;
};
TemporaryFolder* Growth::folder_ = nullptr;
Labels* Growth::before_ = nullptr;
Labels* Growth::after_ = nullptr;

TEST_F(Growth, IsWhatWasPutThere) {
  Case before = made("before", *before_, Images{"4711", "20240220"}, 2.0F);
  const Case after = made("after", *after_, Images{"4711", "20240312"}, 2.5F);
  keep(before, {"Right side", {planning::SegmentsCut{{5, 6, 7, 8}}}});
  GrowthQuestion question;
  question.plan = "Right side";
  const auto compared = compare_studies(before, after, question);
  ASSERT_TRUE(compared) << compared.error().message();

  double remnant_before_ml = 0, remnant_after_ml = 0;
  const double all_before_ml = tissue_ml(*before_, 0), all_after_ml = tissue_ml(*after_, 0);
  ASSERT_EQ(compared->growth.segments.size(), 8u);
  for (const planning::SegmentGrowth& segment : compared->growth.segments) {
    const double was_ml = tissue_ml(*before_, segment.number), is_ml = tissue_ml(*after_, segment.number);
    EXPECT_NEAR(segment.part.before.ml, was_ml, 1e-6) << segment.number;
    EXPECT_NEAR(segment.part.after.ml, is_ml, 1e-6) << segment.number;
    if (segment.number <= 4) remnant_before_ml += was_ml, remnant_after_ml += is_ml;
    // E = 2 G (1 + nu): stiffer by the same quarter as the shear modulus.
    EXPECT_NEAR(*segment.part.after.mean_kPa / *segment.part.before.mean_kPa, 1.25, 1e-3) << segment.number;
  }
  // II lies on the left, VI on the right: by the voxels' size of 3 mm, the factor and nothing.
  EXPECT_NEAR(*compared->growth.segments[1].part.change_percent(), 100 * (factor - 1), 4);
  EXPECT_NEAR(*compared->growth.segments[5].part.change_percent(), 0, 4);
  ASSERT_TRUE(compared->growth.remnant);
  const planning::RemnantGrowth& remnant = *compared->growth.remnant;
  EXPECT_NEAR(remnant.part.before.ml, remnant_before_ml, 1e-6);
  EXPECT_NEAR(remnant.part.after.ml, remnant_after_ml, 1e-6);
  const double points = 100 * (remnant_after_ml / all_after_ml - remnant_before_ml / all_before_ml);
  EXPECT_GT(points, 2);
  EXPECT_NEAR(remnant.hypertrophy_points(), points, 1e-6);
  EXPECT_EQ(compared->days_from, DaysFrom::dates);
  EXPECT_EQ(compared->days, 21);  // over the 29th of February
  EXPECT_NEAR(*remnant.points_per_week, points / 3, 1e-6);
  EXPECT_TRUE(compared->remarks.empty()) << remarks(*compared);
  EXPECT_TRUE(compared->segment_error_percent && compared->remnant_error_percent);
}

TEST_F(Growth, IsRefusedForTwoPatientsUnlessAPersonSaysThatTheyAreOne) {
  const Case before = made("before", *before_, Images{"4711", "20240110"});
  const Case after = made("after", *after_, Images{"4712", "20240210"});
  EXPECT_EQ(same_patient(before, after), SamePatient::no);
  EXPECT_EQ(refused(before, after), "growth-not-one-patient");
  GrowthQuestion question;
  question.patients = GrowthQuestion::Patients::one;
  const auto compared = compare_studies(before, after, question);
  ASSERT_TRUE(compared) << compared.error().message();
  EXPECT_THAT(remarks(*compared), HasSubstr("two patients"));
  EXPECT_FALSE(compared->days);  // the dates of two names do not go together
  question.options.days = 28;
  EXPECT_EQ(compare_studies(before, after, question)->days_from, DaysFrom::person);
}

TEST_F(Growth, IsRefusedTheWrongWayRoundOfItselfAndOfOtherDays) {
  const Case before = made("before", *before_, Images{"4711", "20231215"});
  const Case after = made("after", *after_, Images{"4711", "20240110"});
  EXPECT_EQ(days_between(before, after), 26);
  EXPECT_EQ(refused(after, before), "growth-order");
  EXPECT_EQ(refused(after, after), "growth-same-case");
  GrowthQuestion question;
  question.options.days = 40;
  EXPECT_EQ(refused(before, after, question), "growth-days-differ");
  question.options.days = 26;
  EXPECT_EQ(refused(before, after, question), "");
}

TEST_F(Growth, SaysWhatIsNotKnownOfImagesThatNameNobody) {
  const Case before = made("before", *before_), after = made("after", *after_);
  const auto compared = compare_studies(before, after, {});
  ASSERT_TRUE(compared) << compared.error().message();
  EXPECT_EQ(same_patient(before, after), SamePatient::unknown);
  EXPECT_THAT(remarks(*compared), HasSubstr("of one patient"));
  EXPECT_THAT(remarks(*compared), HasSubstr("How many days"));
  EXPECT_FALSE(compared->growth.segments.front().part.before.mean_kPa);
  // Dates that are none.
  const Case undated = made("undated", *before_, Images{"4711", ""});
  const Case dated = made("dated", *after_, Images{"4711", "20240110"});
  EXPECT_EQ(same_patient(undated, dated), SamePatient::yes);
  EXPECT_FALSE(days_between(undated, dated));
}

TEST_F(Growth, NeedsSegmentsThatHold) {
  Case before = made("before", *before_);
  const Case after = made("after", *after_);
  ASSERT_TRUE(before.add("labels/liver", ".nrrd", {"segment", {}, {}, {}, {}}, [&](const fs::path& file) {
    return imaging::write_mask_file(file, before_->tumour, imaging::SegmentInfo{"liver", 1, {1, 0, 0}});
  }));
  EXPECT_EQ(refused(before, after), "growth-segments-stale");
  EXPECT_EQ(refused(after, before), "growth-segments-stale");
  ASSERT_TRUE(before.remove(couinaud_id));
  EXPECT_EQ(refused(before, after), "growth-segments-missing");
}

// A plane stands in the space of its own study; segments are found in each.
TEST_F(Growth, TakesOverAPlanByAnatomyAlone) {
  Case before = made("before", *before_), after = made("after", *after_);
  const double middle_mm = before_->liver.grid.position_mm(before_->liver.grid.size[0] / 2, 0, 0).x();
  keep(after, {"Plane", {planning::PlaneCut{{middle_mm, 0, 0}, {1, 0, 0}, planning::Removed::below}}});
  GrowthQuestion question;
  question.plan = "Plane";
  EXPECT_EQ(refused(before, after, question), "growth-plan-in-one-study");
  keep(before, {"Plane", {planning::PlaneCut{{middle_mm - 10, 0, 0}, {1, 0, 0}, planning::Removed::below}}});
  const auto compared = compare_studies(before, after, question);
  ASSERT_TRUE(compared) << compared.error().message();
  EXPECT_NE(compared->growth.remnant->part.before.ml, compared->growth.remnant->part.after.ml);
  EXPECT_FALSE(compared->remnant_error_percent);  // that of segments says nothing of a plane
  question.plan = "Nowhere";
  EXPECT_EQ(refused(before, after, question), "plan-unknown");
}

// Neither name, nor number, nor date stands in the case.
TEST_F(Growth, KeepsNothingInTheClear) {
  // No number of hexadecimal digits: such ones come up in hashes by chance.
  const Case patient = made("patient", *before_, Images{"XK4711", "20240220"});
  const std::string text = read_text_file(patient.folder() / "case.json").value();
  EXPECT_THAT(text, HasSubstr("whose-check"));
  EXPECT_THAT(text, HasSubstr("whose-day"));
  for (const char* clear : {"XK4711", "20240220", "2024-02-20", "\"19773\""}) {  // days since 1970
    EXPECT_THAT(text, Not(HasSubstr(clear)));
  }
}

}  // namespace
}  // namespace glisson::casefile

#include "casefile/growth.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <variant>

#include "casefile/belonging.h"
#include "casefile/plans.h"

namespace glisson::casefile {
namespace {

namespace fs = std::filesystem;

// Of ten known growths of real livers nine were found again to within this, in per cent of the volume before: by the
// liver's shape, and by vessels of one class without a click (docs/territories.md).
struct ChangeError {
  double segment_percent, remnant_percent;
};
constexpr ChangeError error_by_shape{23.4, 20.3}, error_by_trees{26.8, 29.3};

// One study by each was not judged: the larger of both.
ChangeError error_of(SegmentsBy before, SegmentsBy after) {
  if (before == after) return before == SegmentsBy::trees ? error_by_trees : error_by_shape;
  return {std::max(error_by_trees.segment_percent, error_by_shape.segment_percent),
          std::max(error_by_trees.remnant_percent, error_by_shape.remnant_percent)};
}

bool goes_by_anatomy(const planning::Cut& cut) {
  return std::holds_alternative<planning::SegmentsCut>(cut) || std::holds_alternative<planning::TerritoryCut>(cut);
}
bool all_by_anatomy(const std::vector<planning::Cut>& cuts) {
  return std::all_of(cuts.begin(), cuts.end(), goes_by_anatomy);
}

std::string name_of(const Case& patient) { return patient.folder().filename().string(); }

// Which are kept and hold; fails where there are none, or what they were made from has changed.
Result<SegmentsBy> kept_segments(const Case& patient);

Result<void> check_patients(const Case& before, const Case& after, GrowthQuestion::Patients patients,
                            std::vector<Sentence>& remarks);

// By the images' dates or the person, into `compared`.
Result<void> find_days(const Case& before, const Case& after, const std::optional<double>& given,
                       ComparedStudies& compared);

// The plan's cuts in each study, with what is to be said of them.
Result<planning::RemnantCuts> cuts_of_plan(const Case& before, const Case& after, const std::string& name,
                                           std::vector<Sentence>& remarks);

// A liver that the image cuts off, say, is as much of a difference as growth.
void add_notes(const Case& patient, std::vector<Sentence>& remarks) {
  const std::vector<Sentence>& notes = patient.find("labels/liver")->made.notes;
  if (!notes.empty()) remarks.push_back({GLISSON_TEXT("Noted when {0}'s liver was outlined:"), {name_of(patient)}});
  remarks.insert(remarks.end(), notes.begin(), notes.end());
}

}  // namespace

Result<ComparedStudies> compare_studies(const Case& before, const Case& after, const GrowthQuestion& question,
                                        const Progress& progress) {
  std::error_code unreadable;
  if (fs::equivalent(before.folder(), after.folder(), unreadable)) {
    return failure(Error{"growth-same-case",
                         GLISSON_TEXT("{0} is compared with itself."),
                         {name_of(after)},
                         GLISSON_TEXT("Name the case of the earlier study first, then that of the later one."),
                         after.folder()});
  }
  ComparedStudies compared;
  compared.standard_liver_ml = question.options.standard_liver_ml;
  compared.plan = question.plan.value_or("");
  auto checked = check_patients(before, after, question.patients, compared.remarks).and_then([&] {
    return find_days(before, after, question.options.days, compared);
  });
  if (!checked) return failure(std::move(checked.error()));

  std::vector<planning::Planner> planners;
  for (const Case* patient : {&before, &after}) {
    const double done = static_cast<double>(planners.size()) / 2;
    const auto by = kept_segments(*patient);
    if (!by) return failure(by.error());
    const auto found = territories_in(*patient, *by, progress.part(done, done + 0.25));
    if (!found) return failure(found.error());
    auto opened = open_planner(*patient, *found, progress.part(done + 0.25, done + 0.5));
    if (!opened) return failure(std::move(opened.error()));
    compared.segments_by.at(planners.size()) = *by;
    planners.push_back(std::move(opened->planner));
    add_notes(*patient, compared.remarks);
    std::move(opened->remarks.begin(), opened->remarks.end(), std::back_inserter(compared.remarks));
  }
  if (compared.segments_by[0] != compared.segments_by[1]) {
    compared.remarks.push_back(
        {GLISSON_TEXT("One study was parted into segments by its vessels, the other by the liver's shape alone: a part "
                      "of what differs comes of that."),
         {}});
  }
  std::optional<planning::RemnantCuts> remnant;
  if (question.plan) {
    auto cuts = cuts_of_plan(before, after, *question.plan, compared.remarks);
    if (!cuts) return failure(std::move(cuts.error()));
    remnant = std::move(*cuts);
  }
  planning::GrowthOptions options = question.options;
  options.days = compared.days;
  const ChangeError error = error_of(compared.segments_by[0], compared.segments_by[1]);
  if (!options.segment_error_percent) options.segment_error_percent = error.segment_percent;
  const bool by_segments = remnant && all_by_anatomy(remnant->before) && all_by_anatomy(remnant->after);
  if (!options.remnant_error_percent && by_segments) options.remnant_error_percent = error.remnant_percent;
  compared.segment_error_percent = options.segment_error_percent;
  compared.remnant_error_percent = options.remnant_error_percent;
  auto growth = planning::growth_between(planners[0], planners[1], remnant, options);
  if (!growth) return failure(std::move(growth.error()));
  compared.growth = std::move(*growth);
  return compared;
}

namespace {

Result<SegmentsBy> kept_segments(const Case& patient) {
  const Entry* segments = patient.find(couinaud_id);
  if (segments == nullptr) {
    return failure(Error{"growth-segments-missing",
                         GLISSON_TEXT("{0} has no segments yet."),
                         {name_of(patient)},
                         GLISSON_TEXT("Find them first: in Resect, or by glisson-cli territories CASE."),
                         patient.folder()});
  }
  for (const SegmentsBy by : {SegmentsBy::trees, SegmentsBy::shape}) {
    if (kept_territories(patient, by) == Kept::current) return by;
  }
  return failure(Error{"growth-segments-stale",
                       GLISSON_TEXT("The segments of {0} are older than the outlines or vessels that they were made "
                                    "from, or of another version of Glisson."),
                       {name_of(patient)},
                       GLISSON_TEXT("Find them anew: in Resect, or by glisson-cli territories CASE."),
                       patient.folder()});
}

Result<void> check_patients(const Case& before, const Case& after, GrowthQuestion::Patients patients,
                            std::vector<Sentence>& remarks) {
  switch (same_patient(before, after)) {
    case SamePatient::yes: return {};
    case SamePatient::unknown:
      remarks.push_back(
          {GLISSON_TEXT("Nothing shows whether {0} and {1} are of one patient: the images of one or both name nobody, "
                        "or came into their case before cases kept what tells."),
           {name_of(before), name_of(after)}});
      return {};
    case SamePatient::no: break;
  }
  if (patients == GrowthQuestion::Patients::one) {
    remarks.push_back({GLISSON_TEXT("The images of {0} and {1} name two patients; you said that they are of one."),
                       {name_of(before), name_of(after)}});
    return {};
  }
  return failure(Error{"growth-not-one-patient",
                       GLISSON_TEXT("The images of {0} and {1} name two patients."),
                       {name_of(before), name_of(after)},
                       GLISSON_TEXT("Where they are of one all the same, say so with --same-patient."),
                       after.folder()});
}

Result<void> find_days(const Case& before, const Case& after, const std::optional<double>& given,
                       ComparedStudies& compared) {
  const auto by_dates = days_between(before, after);
  if (by_dates && *by_dates < 0) {
    return failure(Error{"growth-order",
                         GLISSON_TEXT("By the dates of its images {0} is {1} days older than {2}."),
                         {name_of(after), std::to_string(-*by_dates), name_of(before)},
                         GLISSON_TEXT("Name the case of the earlier study first, then that of the later one."),
                         after.folder()});
  }
  if (by_dates && given && std::abs(*given - *by_dates) > 1) {  // a date may be the scan's or the report's
    return failure(Error{"growth-days-differ",
                         GLISSON_TEXT("By the dates of their images the studies are {0} days apart, and not {1}."),
                         {std::to_string(*by_dates), fmt::format("{}", *given)},
                         GLISSON_TEXT("Leave --days out: it is for studies without dates."),
                         after.folder()});
  }
  if (given) {
    compared.days = given;
    compared.days_from = DaysFrom::person;
  } else if (by_dates && *by_dates > 0) {
    compared.days = *by_dates;
    compared.days_from = DaysFrom::dates;
  } else if (by_dates) {
    compared.remarks.push_back({GLISSON_TEXT("Both studies are of the same day: there is no growth rate."), {}});
  } else {
    compared.remarks.push_back(
        {GLISSON_TEXT("How many days lie between the studies is not known, so that there is no growth rate: their "
                      "images have no dates, or name nobody. Say it (--days)."),
         {}});
  }
  return {};
}

Result<planning::RemnantCuts> cuts_of_plan(const Case& before, const Case& after, const std::string& name,
                                           std::vector<Sentence>& remarks) {
  const auto in_before = kept_plan(before, name), in_after = kept_plan(after, name);
  for (const auto* kept : {&in_before, &in_after}) {
    if (!*kept && kept->error().code != "plan-unknown") return failure(kept->error());
    if (*kept) remarks.insert(remarks.end(), (*kept)->remarks.begin(), (*kept)->remarks.end());
  }
  if (in_before && in_after) return planning::RemnantCuts{in_before->plan.cuts, in_after->plan.cuts};
  if (!in_before && !in_after) {
    return failure(Error{"plan-unknown",
                         GLISSON_TEXT("Neither {0} nor {1} has a plan {2}."),
                         {name_of(before), name_of(after), name},
                         {},
                         after.folder()});
  }
  const Case& has_it = in_before ? before : after;
  const Case& lacks_it = in_before ? after : before;
  const std::vector<planning::Cut>& cuts = in_before ? in_before->plan.cuts : in_after->plan.cuts;
  if (!all_by_anatomy(cuts)) {
    return failure(Error{"growth-plan-in-one-study",
                         GLISSON_TEXT("{0} alone has the plan {1}, and not all of it goes by segments or territories: "
                                      "a plane, a sheet, a margin or a zone has its place in its own study."),
                         {name_of(has_it), name},
                         GLISSON_TEXT("Keep a plan of that name in the other case too."),
                         lacks_it.folder()});
  }
  return planning::RemnantCuts{cuts, cuts};
}

}  // namespace
}  // namespace glisson::casefile

#include "report/growth.h"

#include <fmt/format.h>
#include <algorithm>

#include "base/json.h"
#include "vasculature/couinaud.h"

namespace glisson::report {
namespace {

using casefile::ComparedStudies;
using planning::PartGrowth;

std::string whole(double value) { return fmt::format("{:.0f}", value); }
std::string fine(double value) { return fmt::format("{:.1f}", value); }
std::string signed_fine(double value) { return fmt::format("{:+.1f}", value); }

Json part_json(const PartGrowth& part) {
  Json json{{"before_ml", part.before.ml},
            {"after_ml", part.after.ml},
            {"change_ml", part.change_ml()},
            {"before_percent", part.before_percent},
            {"after_percent", part.after_percent}};
  if (const auto change = part.change_percent()) {
    json["change_percent"] = *change;
  } else {
    json["change_percent_reason"] = "the first study has nothing of it";
  }
  const auto add_stiffness = [&](const char* kPa, const char* share, const planning::Tissue& tissue) {
    if (!tissue.mean_kPa) return;
    json[kPa] = *tissue.mean_kPa;
    json[share] = tissue.confident_share;
  };
  add_stiffness("before_kPa", "before_confident_share", part.before);
  add_stiffness("after_kPa", "after_confident_share", part.after);
  return json;
}

const char* way(casefile::SegmentsBy by) { return by == casefile::SegmentsBy::trees ? "tree" : "prior"; }

}  // namespace

std::vector<Sentence> growth_sentences(const ComparedStudies& compared) {
  const planning::Growth& growth = compared.growth;
  std::vector<Sentence> said;
  const auto change = [](const PartGrowth& part) { return signed_fine(part.change_percent().value_or(0)); };
  said.push_back({GLISSON_TEXT("The liver without tumours has {1} ml, {0} ml before ({2} %)."),
                  {whole(growth.liver.before.ml), whole(growth.liver.after.ml), change(growth.liver)}});
  if (growth.remnant) {
    const PartGrowth& remnant = growth.remnant->part;
    said.push_back({GLISSON_TEXT("What the plan {0} leaves has {2} ml, {1} ml before ({3} %)."),
                    {compared.plan, whole(remnant.before.ml), whole(remnant.after.ml), change(remnant)}});
    const std::string points = signed_fine(growth.remnant->hypertrophy_points());
    if (compared.standard_liver_ml) {
      said.push_back(
          {GLISSON_TEXT("That is {1} % of the standard liver volume of {3} ml, {0} % before: a degree of "
                        "hypertrophy of {2} percentage points."),
           {fine(remnant.before_percent), fine(remnant.after_percent), points, whole(*compared.standard_liver_ml)}});
    } else {
      said.push_back({GLISSON_TEXT("That is {1} % of the liver without tumours of its own study, {0} % before: a "
                                   "degree of hypertrophy of {2} percentage points."),
                      {fine(remnant.before_percent), fine(remnant.after_percent), points}});
    }
    if (growth.remnant->points_per_week) {
      const std::vector<std::string> figures{fmt::format("{:+.2f}", *growth.remnant->points_per_week),
                                             fmt::format("{:g}", *compared.days)};
      said.push_back(
          {compared.days_from == casefile::DaysFrom::dates
               ? GLISSON_TEXT("Kinetic growth rate: {0} percentage points a week, over {1} days by the images' dates.")
               : GLISSON_TEXT("Kinetic growth rate: {0} percentage points a week, over the {1} days that were given."),
           figures});
    }
    if (remnant.within_error) {
      said.push_back({GLISSON_TEXT("A remnant's change of up to {0} % may be none: volumes of what is parted anew are "
                                   "off by as much in one of ten."),
                      {whole(*compared.remnant_error_percent)}});
    }
  }
  const bool any = std::any_of(growth.segments.begin(), growth.segments.end(),
                               [](const planning::SegmentGrowth& segment) { return segment.part.within_error; });
  if (any) {
    said.push_back({GLISSON_TEXT("A segment's change of up to {0} % (~) may be none: volumes of segments that are "
                                 "parted anew are off by as much in one of ten."),
                    {whole(*compared.segment_error_percent)}});
  }
  said.insert(said.end(), compared.remarks.begin(), compared.remarks.end());
  return said;
}

Json growth_json(const ComparedStudies& compared) {
  const planning::Growth& growth = compared.growth;
  Json json{{"format", "glisson-growth/1"}};
  if (compared.days) {
    json["days"] = *compared.days;
    json["days_from"] = compared.days_from == casefile::DaysFrom::dates ? "dates" : "given";
  }
  json["percent_of"] = compared.standard_liver_ml ? "standard" : "own";
  if (compared.standard_liver_ml) json["standard_liver_ml"] = *compared.standard_liver_ml;
  json["segments_from"] = {{"before", way(compared.segments_by[0])}, {"after", way(compared.segments_by[1])}};
  json["liver"] = part_json(growth.liver);
  json["tumours"] = {{"before_ml", growth.tumours_before_ml}, {"after_ml", growth.tumours_after_ml}};
  json["segments"] = Json::array();
  for (const planning::SegmentGrowth& segment : growth.segments) {
    Json& one = json["segments"].emplace_back(Json{{"number", segment.number}});
    one.update(part_json(segment.part));
    one["within_error"] = segment.part.within_error;
  }
  if (compared.segment_error_percent) json["segment_error_percent"] = *compared.segment_error_percent;
  if (growth.remnant) {
    Json& remnant = json["remnant"] = Json{{"plan", compared.plan}};
    remnant.update(part_json(growth.remnant->part));
    remnant["within_error"] = growth.remnant->part.within_error;
    remnant["degree_of_hypertrophy_points"] = growth.remnant->hypertrophy_points();
    if (growth.remnant->points_per_week) {
      remnant["kinetic_growth_rate_points_per_week"] = *growth.remnant->points_per_week;
    } else {
      remnant["kinetic_growth_rate_reason"] = "the days between the studies are not known";
    }
    if (compared.remnant_error_percent) json["remnant_error_percent"] = *compared.remnant_error_percent;
  }
  json["sentences"] = messages(growth_sentences(compared));
  return json;
}

std::string growth_table(const ComparedStudies& compared) {
  std::string text =
      "part,before_ml,after_ml,change_ml,change_percent,before_percent,after_percent,before_kPa,after_kPa,"
      "within_error\n";
  const auto figure = [](const std::optional<double>& value) { return value ? fmt::format("{:.3f}", *value) : ""; };
  const auto add = [&](const std::string& name, const PartGrowth& part, const char* within_error) {
    text += fmt::format("{},{:.3f},{:.3f},{:.3f},{},{:.3f},{:.3f},{},{},{}\n", name, part.before.ml, part.after.ml,
                        part.change_ml(), figure(part.change_percent()), part.before_percent, part.after_percent,
                        figure(part.before.mean_kPa), figure(part.after.mean_kPa), within_error);
  };
  const auto within = [](const PartGrowth& part) { return part.within_error ? "1" : "0"; };
  for (const planning::SegmentGrowth& segment : compared.growth.segments) {
    add(vasculature::segment_name(static_cast<std::size_t>(segment.number)), segment.part, within(segment.part));
  }
  if (compared.growth.remnant) add("remnant", compared.growth.remnant->part, within(compared.growth.remnant->part));
  add("liver", compared.growth.liver, "");
  return text;
}

}  // namespace glisson::report

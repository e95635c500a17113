#include "casefile/belonging.h"

#include <fmt/format.h>
#include <algorithm>
#include <chrono>

#include "base/secret_hash.h"
#include "base/text.h"
#include "casefile/label_map.h"
#include "imaging/dicom_seg.h"
#include "imaging/volume_file.h"

namespace glisson::casefile {
namespace {

using imaging::Series;

constexpr const char* patient_option = "whose-patient";
constexpr const char* salt_option = "whose-salt";
constexpr const char* check_option = "whose-check";
constexpr const char* day_option = "whose-day";

// What the images say of themselves, in the clear: never leaves this file.
struct Named {
  const char* option;
  std::string name;
};
std::vector<Named> named_in(const imaging::SegmentationSource& source);
// Nothing of formats that name nobody.
std::optional<imaging::SegmentationSource> source_of(const Series& series);

// What two cases of a patient have in common, and the day of this one (see belonging.h).
std::map<std::string, std::string> to_compare(const std::string& patient, const std::string& study_date);

const Sentence& doubt_about(std::string_view option) {
  static const Sentence patient{GLISSON_TEXT("They are of another patient."), {}};
  static const Sentence study{GLISSON_TEXT("They are of another examination."), {}};
  static const Sentence frame{
      GLISSON_TEXT("They have another frame of reference: the patient may have moved between them."), {}};
  return option == "whose-patient" ? patient : option == "whose-study" ? study : frame;
}

}  // namespace

std::map<std::string, std::string> whose(const Series& series) {
  std::map<std::string, std::string> options;
  const auto source = source_of(series);
  if (!source) return options;
  const std::string salt = new_salt();
  for (const Named& named : named_in(*source)) {
    if (named.name.empty()) continue;
    options[named.option] = secret_hash(named.name, salt);
    options[salt_option] = salt;
    if (std::string_view(named.option) == patient_option) options.merge(to_compare(named.name, source->study_date));
  }
  return options;
}

std::vector<Sentence> doubts_of_belonging(const Case& patient, const imaging::Study& study,
                                          const std::vector<SeriesRole>& roles) {
  constexpr double enough = 0.5;  // of the place, to lie in the same body
  std::vector<Sentence> doubts;
  const auto add = [&](const Sentence& doubt) {
    if (std::none_of(doubts.begin(), doubts.end(), [&](const Sentence& one) { return one.text == doubt.text; })) {
      doubts.push_back(doubt);
    }
  };
  const Entry* anatomy = patient.find("volumes/anatomy");
  if (anatomy == nullptr) return doubts;
  const auto header = imaging::read_volume_file_header(patient.folder() / anatomy->file);
  const auto& options = anatomy->made.options;
  std::map<std::string, std::string> hashed;  // by what it is of: many series name the same
  for (const SeriesRole& wanted : roles) {
    if (wanted.role == imaging::Role::other) continue;
    const auto series = std::find_if(study.series.begin(), study.series.end(),
                                     [&](const Series& one) { return one.uid == wanted.uid; });
    if (series == study.series.end()) continue;
    const auto source = source_of(*series);
    for (const Named& named : source ? named_in(*source) : std::vector<Named>()) {
      const auto known = options.find(named.option);
      if (known == options.end() || named.name.empty() || !options.contains(salt_option)) continue;
      auto [hash, is_new] = hashed.try_emplace(std::string(named.option) + named.name);
      if (is_new) hash->second = secret_hash(named.name, options.at(salt_option));
      if (hash->second != known->second) add(doubt_about(named.option));
    }
    if (!header || series->grid.voxels() == 0) continue;
    const double shared = shared_place(series->grid, header->grid);
    if (shared < enough) {
      add({GLISSON_TEXT("They lie elsewhere: only {0} % of their place is that of the case's anatomy."),
           {fmt::format("{:.0f}", 100 * shared)}});
    }
  }
  return doubts;
}

bool would_replace_anatomy(const Case& patient, const std::vector<SeriesRole>& roles) {
  return patient.find("volumes/anatomy") != nullptr &&
         std::any_of(roles.begin(), roles.end(),
                     [](const SeriesRole& one) { return one.role == imaging::Role::anatomy; });
}

namespace {

const std::string* anatomy_option(const Case& patient, const char* option) {
  const Entry* anatomy = patient.find("volumes/anatomy");
  if (anatomy == nullptr) return nullptr;
  const auto found = anatomy->made.options.find(option);
  return found == anatomy->made.options.end() ? nullptr : &found->second;
}

std::optional<int> number_of(const std::string* text) {
  return text == nullptr ? std::nullopt : read_whole_number<int>(*text);
}

}  // namespace

SamePatient same_patient(const Case& a, const Case& b) {
  const std::string* one = anatomy_option(a, check_option);
  const std::string* other = anatomy_option(b, check_option);
  if (one == nullptr || other == nullptr) return SamePatient::unknown;
  return *one == *other ? SamePatient::yes : SamePatient::no;
}

std::optional<int> days_between(const Case& earlier, const Case& later) {
  const auto from = number_of(anatomy_option(earlier, day_option)), to = number_of(anatomy_option(later, day_option));
  if (!from || !to || same_patient(earlier, later) != SamePatient::yes) return std::nullopt;
  return *to - *from;
}

namespace {

std::optional<imaging::SegmentationSource> source_of(const Series& series) {
  if (series.files.empty() || imaging::has_volume_file_name(series.files.front())) return std::nullopt;
  auto source = imaging::segmentation_source({series.files.front()});
  return source ? std::optional(std::move(*source)) : std::nullopt;
}

// A number that two hospitals may both give counts with the name that goes with it.
std::vector<Named> named_in(const imaging::SegmentationSource& source) {
  const bool known = !source.patient_id.empty() || !source.patient_name.empty();
  return {{patient_option, known ? source.patient_id + '\n' + source.patient_name : std::string()},
          {"whose-study", source.study_uid},
          {"whose-frame", source.frame_of_reference_uid}};
}

// Days since 1970 of YYYYMMDD; nothing where that is no date.
std::optional<int> day_of(const std::string& date) {
  const auto all = number_of(&date);
  if (!all || date.size() != 8 || *all < 0) return std::nullopt;
  const std::chrono::year_month_day day{std::chrono::year(*all / 10000),
                                        std::chrono::month(static_cast<unsigned>(*all / 100 % 100)),
                                        std::chrono::day(static_cast<unsigned>(*all % 100))};
  if (!day.ok()) return std::nullopt;
  return static_cast<int>(std::chrono::sys_days(day).time_since_epoch().count());
}

std::map<std::string, std::string> to_compare(const std::string& patient, const std::string& study_date) {
  constexpr std::size_t check_digits = 4, shift_digits = 8;
  constexpr unsigned long century_days = 36525;
  const std::string hash = secret_hash(patient, "glisson: two cases of one patient");
  std::map<std::string, std::string> options{{check_option, hash.substr(0, check_digits)}};
  if (const auto day = day_of(study_date)) {
    const auto shift = std::stoul(hash.substr(check_digits, shift_digits), nullptr, 16) % century_days;
    options[day_option] = std::to_string(*day + static_cast<int>(shift));
  }
  return options;
}

}  // namespace
}  // namespace glisson::casefile

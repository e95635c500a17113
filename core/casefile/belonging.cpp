#include "casefile/belonging.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>

#include "base/secret_hash.h"
#include "casefile/label_map.h"
#include "imaging/dicom_seg.h"
#include "imaging/volume_file.h"

namespace glisson::casefile {
namespace {

using imaging::Series;

constexpr const char* salt_option = "whose-salt";

// What the images say of themselves, in the clear: never leaves this file.
struct Named {
  const char* option;
  std::string name;
};
std::vector<Named> named_in(const Series& series);

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
  const std::string salt = new_salt();
  for (const Named& named : named_in(series)) {
    if (named.name.empty()) continue;
    options[named.option] = secret_hash(named.name, salt);
    options[salt_option] = salt;
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
    for (const Named& named : named_in(*series)) {
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

// A number that two hospitals may both give counts with the name that goes with it.
std::vector<Named> named_in(const Series& series) {
  if (series.files.empty() || imaging::has_volume_file_name(series.files.front())) return {};
  const auto source = imaging::segmentation_source({series.files.front()});
  if (!source) return {};
  const bool known = !source->patient_id.empty() || !source->patient_name.empty();
  return {{"whose-patient", known ? source->patient_id + '\n' + source->patient_name : std::string()},
          {"whose-study", source->study_uid},
          {"whose-frame", source->frame_of_reference_uid}};
}

}  // namespace
}  // namespace glisson::casefile

#include "studies/dissertation/subjects.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <tuple>

#include "base/files.h"
#include "base/folder_contents.h"
#include "casefile/model.h"
#include "casefile/structure_landmarks.h"
#include "casefile/structures.h"
#include "imaging/read_series.h"
#include "imaging/stiffness_map.h"
#include "segmentation/resample.h"
#include "studies/dissertation/real_livers.h"

namespace glisson::studies {
namespace fs = std::filesystem;
namespace {

// "017Stiffness_warped.nii.gz" -> "017Stiffness_warped": what is left serves as a file name.
std::string id_of(const fs::path& path) {
  std::string name = path.filename().string();
  name = name.substr(0, name.find('.', 1));
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-' && c != '_') c = '-';
  }
  return name;
}

bool holds_a_value(float kPa) { return kPa > 0 && std::isfinite(kPa); }

// What a case knows besides its map.
Result<MeasuredLiver> case_without_map(const casefile::Case& patient) {
  MeasuredLiver liver;
  auto reliability = casefile::reliability_of(patient);
  if (!reliability) return failure(reliability.error());
  liver.confident = std::move(reliability->confident);
  if (reliability->organ) liver.organ = std::move(*reliability->organ);
  const auto structures = casefile::read_structures(patient);
  if (!structures) return failure(structures.error());
  liver.landmarks = casefile::landmarks_of(*structures);
  if (!liver.landmarks.empty()) {
    liver.groups = {{"landmarks", std::vector<std::size_t>(liver.landmarks.size())}};
    std::iota(liver.groups[0].members.begin(), liver.groups[0].members.end(), std::size_t{0});
  }
  return liver;
}

}  // namespace

Result<std::vector<Subject>> find_subjects(const fs::path& folder) {
  std::vector<Subject> subjects;
  for (const fs::path& path : contents_of(folder)) {
    if (path.extension() == ".glisson") subjects.push_back({id_of(path), path, {}});
  }
  const auto study = imaging::scan(folder);
  if (!study) return failure(study.error());
  for (const imaging::Series& series : study->series) {
    if (series.role != imaging::Role::mre_stiffness || series.files.empty()) continue;
    const fs::path& first = series.files.front();
    const auto in_case = [](const fs::path& part) { return part.extension() == ".glisson"; };
    if (std::any_of(first.begin(), first.end(), in_case)) continue;
    // The files of a DICOM series are named by number; its folder tells more.
    const bool one_file = series.files.size() == 1;
    subjects.push_back({one_file ? id_of(first) : id_of(first.parent_path()), first, series});
  }
  std::sort(subjects.begin(), subjects.end(),
            [](const Subject& a, const Subject& b) { return std::tie(a.id, a.path) < std::tie(b.id, b.path); });
  std::set<std::string> taken;
  for (Subject& subject : subjects) {
    const std::string name = subject.id;
    for (int n = 2; !taken.insert(subject.id).second; ++n) subject.id = fmt::format("{}-{}", name, n);
  }
  return subjects;
}

std::string fingerprint_of(const Subject& subject) {
  if (subject.drawn) {
    const auto sum = [](const fs::path& file) { return sha256_of_file(file).value_or("unreadable"); };
    const fs::path& vessels = subject.drawn->vessels;
    return fmt::format("{} {} {}", sum(subject.path), vessels.empty() ? "none" : sum(vessels), subject.drawn->seed);
  }
  return sha256_of_file(subject.series ? subject.path : subject.path / "case.json").value_or("unreadable");
}

Result<MeasuredLiver> read_subject(const Subject& subject) {
  if (subject.drawn) return read_liver(subject);
  MeasuredLiver liver;
  Result<imaging::Volume> stored = tl::unexpected(Error{});
  if (subject.series) {
    stored = imaging::read_series(*subject.series);
  } else {
    const auto patient = casefile::Case::open(subject.path);
    if (!patient) return failure(patient.error());
    auto known = case_without_map(*patient);
    if (!known) return known;
    liver = std::move(*known);
    stored = patient->volume("volumes/stiffness");
  }
  if (!stored) return failure(stored.error());
  auto map =
      imaging::stiffness_in_kPa(std::move(*stored), subject.series ? subject.series->unit_evidence : std::string());
  if (!map) return failure(map.error());
  liver.shear_kPa = std::move(map->shear_kPa);
  if (liver.organ.values.empty()) {
    liver.organ.grid = liver.shear_kPa.grid;
    for (const float kPa : liver.shear_kPa.values) liver.organ.values.push_back(holds_a_value(kPa) ? 1 : 0);
  }
  return liver;
}

std::vector<double> MeasuredLiver::values_kPa() const {
  const imaging::Mask inside = segmentation::resample(organ, shear_kPa.grid);
  std::vector<double> values;
  for (std::size_t v = 0; v < shear_kPa.values.size(); ++v) {
    if (inside.values[v] != 0 && holds_a_value(shear_kPa.values[v])) {
      values.push_back(static_cast<double>(shear_kPa.values[v]));
    }
  }
  return values;
}

}  // namespace glisson::studies

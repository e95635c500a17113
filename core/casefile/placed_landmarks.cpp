#include "casefile/placed_landmarks.h"

#include <set>

#include "base/files.h"
#include "base/json.h"
#include "casefile/import.h"

namespace glisson::casefile {
namespace {

namespace fs = std::filesystem;

constexpr const char* landmarks_entry = "landmarks/placed";
constexpr const char* format = "glisson-landmarks/1";

Error invalid(const fs::path& file, const std::string& what) {
  return Error{"landmarks-invalid",
               GLISSON_TEXT("The landmarks in {0} cannot be read: {1}."),
               {file.string(), what},
               GLISSON_TEXT("Undo the change in the window, or delete the file's entry and set them again."),
               file};
}

}  // namespace

std::string landmark_name(std::string_view typed) { return structure_name(std::string(typed)); }

Result<std::vector<mechanics::Landmark>> placed_landmarks(const Case& patient) {
  std::vector<mechanics::Landmark> landmarks;
  const Entry* entry = patient.find(landmarks_entry);
  if (entry == nullptr) return landmarks;
  const fs::path file = patient.folder() / entry->file;
  const auto document = read_json_file(file);
  if (!document) return failure(document.error());
  try {
    if (document->at("format") != format) return failure(invalid(file, "its format is not glisson-landmarks/1"));
    std::set<std::string> names;
    for (const Json& told : document->at("landmarks")) {
      const auto name = told.at("name").get<std::string>();
      const auto at = told.at("position_mm").get<std::vector<double>>();
      if (name.empty() || name != landmark_name(name) || !names.insert(name).second) {
        return failure(invalid(file, "the name \"" + name + "\" is not allowed or there twice"));
      }
      if (at.size() != 3) return failure(invalid(file, "a position is not three numbers"));
      const Eigen::Vector3d position_mm(at[0], at[1], at[2]);
      if (!position_mm.allFinite()) return failure(invalid(file, "a position is not finite"));
      landmarks.push_back({name, position_mm});
    }
  } catch (const Json::exception& problem) {
    return failure(invalid(file, problem.what()));
  }
  return landmarks;
}

Result<void> keep_landmarks(Case& patient, const std::vector<mechanics::Landmark>& landmarks) {
  if (landmarks.empty())
    return patient.find(landmarks_entry) == nullptr ? Result<void>() : patient.remove(landmarks_entry);
  Json document{{"format", format}, {"landmarks", Json::array()}};
  std::set<std::string> names;
  for (const mechanics::Landmark& landmark : landmarks) {
    GLISSON_ASSERT(!landmark.id.empty() && landmark.id == landmark_name(landmark.id));
    GLISSON_ASSERT(names.insert(landmark.id).second);
    const Eigen::Vector3d& at = landmark.position_mm;
    document["landmarks"].push_back({{"name", landmark.id}, {"position_mm", {at.x(), at.y(), at.z()}}});
  }
  Provenance made{"landmark", {{"method", "by hand"}}, {}, {}, {}};
  if (patient.find("volumes/anatomy") != nullptr) made.from = {"volumes/anatomy"};
  return patient.add(landmarks_entry, ".json", std::move(made),
                     [&](const fs::path& file) { return write_json_file(file, document); });
}

}  // namespace glisson::casefile

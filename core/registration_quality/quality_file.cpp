#include "registration_quality/quality_file.h"

#include <fmt/format.h>
#include <algorithm>

#include "base/json.h"
#include "base/write_file.h"
#include "geometry/mesh_file.h"

namespace glisson::registration_quality {
namespace {

namespace fs = std::filesystem;

std::string frame_field(std::size_t frame) { return fmt::format("frame_{:03}_mm", frame); }

Failure invalid(const fs::path& folder) {
  return failure(Error{"quality-invalid",
                       GLISSON_TEXT("The folder {0} holds no judgement of a registration."),
                       {folder.string()},
                       GLISSON_TEXT("Make one: glisson-cli sirgn SEQUENCE.json --method icp --out FOLDER."),
                       folder});
}

}  // namespace

std::string_view judged_against(const Quality& quality) {
  return quality.against_benchmark ? "benchmark" : "own-landmarks";
}

Result<void> write_quality(const fs::path& folder, const StoredQuality& stored) {
  std::error_code problem;
  geometry::Surface mesh = stored.quality.mesh;
  for (std::size_t t = 0; t < stored.quality.mesh_in_frames_mm.size(); ++t) {
    geometry::Field places{frame_field(t), 3, {}};
    for (const Eigen::Vector3d& place : stored.quality.mesh_in_frames_mm[t]) {
      places.values.insert(places.values.end(), place.begin(), place.end());
    }
    mesh.point_fields.push_back(std::move(places));
  }
  const Json summary{{"sequence", fs::absolute(stored.sequence, problem).string()},
                     {"method", stored.method},
                     {"judged_against", judged_against(stored.quality)},
                     {"tolerances_mm", stored.tolerances_mm},
                     {"frames", stored.quality.mesh_in_frames_mm.size()},
                     {"mean_correlation", stored.quality.mean_correlation},
                     {"tre_per_frame_mm", stored.quality.tre_mm},
                     {"rmse_per_frame_mm", stored.quality.rmse_mm},
                     {"notes", messages(stored.quality.notes)}};
  return write_together([&] {
    return geometry::write_surface(folder / "quality.vtp", mesh).and_then([&] {
      return write_json_file(folder / "sirgn.json", summary);
    });
  });
}

Result<StoredQuality> read_quality(const fs::path& folder) {
  const auto document = read_json_file(folder / "sirgn.json");
  if (!document) return failure(document.error());
  auto mesh = geometry::read_surface(folder / "quality.vtp");
  if (!mesh) return failure(mesh.error());
  StoredQuality stored;
  std::size_t frames = 0;
  try {
    stored.sequence = document->at("sequence").get<std::string>();
    stored.method = document->at("method").get<std::string>();
    stored.tolerances_mm = document->at("tolerances_mm").get<std::vector<double>>();
    stored.quality.tre_mm = document->at("tre_per_frame_mm").get<std::vector<double>>();
    stored.quality.rmse_mm = document->at("rmse_per_frame_mm").get<std::vector<double>>();
    stored.quality.against_benchmark = document->value("judged_against", "") == "benchmark";
    stored.quality.mean_correlation = document->at("mean_correlation").get<double>();
    frames = document->at("frames").get<std::size_t>();
  } catch (const Json::exception&) {
    return invalid(folder);
  }
  for (const auto& [name, values] :
       {std::pair{"correlation", &stored.quality.correlation}, std::pair{"error_mm", &stored.quality.error_mm}}) {
    const geometry::Field* field = geometry::find_field(mesh->cell_fields, name);
    if (field == nullptr || field->values.size() != mesh->triangles.size()) return invalid(folder);
    *values = field->values;
  }
  const geometry::Field* seen = geometry::find_field(mesh->cell_fields, "frames");
  if (seen == nullptr || seen->values.size() != mesh->triangles.size()) return invalid(folder);
  const auto is_count = [](double count) { return count >= 0 && count <= 1e9; };
  if (!std::all_of(seen->values.begin(), seen->values.end(), is_count)) return invalid(folder);
  for (const double count : seen->values) stored.quality.frames_seen.push_back(static_cast<int>(count));
  for (std::size_t t = 0; t < frames; ++t) {
    const geometry::Field* field = geometry::find_field(mesh->point_fields, frame_field(t));
    if (field == nullptr || field->values.size() != 3 * mesh->points_mm.size()) return invalid(folder);
    auto& places = stored.quality.mesh_in_frames_mm.emplace_back();
    for (std::size_t i = 0; i < mesh->points_mm.size(); ++i) {
      places.emplace_back(field->values[3 * i], field->values[3 * i + 1], field->values[3 * i + 2]);
    }
  }
  mesh->point_fields.clear();
  stored.quality.mesh = std::move(*mesh);
  return stored;
}

}  // namespace glisson::registration_quality

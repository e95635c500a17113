#pragma once
// What files of guidance are made of: tables of curves and targets, poses, names of features. Failures are thrown, as
// base/json_reading.h has them.

#include <Eigen/Geometry>
#include <filesystem>
#include <string>
#include <vector>

#include "base/json_reading.h"
#include "guidance/guidance_file.h"

namespace glisson::guidance {

[[noreturn]] void refuse_in(const std::string& where, const std::string& what);
[[nodiscard]] std::string text_under(const Json& json, const char* key, const std::string& where);
[[nodiscard]] double number_or(const Json& json, const char* key, double otherwise, const std::string& where);
[[nodiscard]] double positive_or(const Json& json, const char* key, double otherwise, const std::string& where);

// Columns of a table, by name, as places; rows that are not finite are left out.
[[nodiscard]] std::vector<Eigen::Vector3d> curve_from(const std::filesystem::path& file);   // x_mm, y_mm, z_mm
[[nodiscard]] std::vector<Eigen::Vector2d> pixels_from(const std::filesystem::path& file);  // x_px, y_px
[[nodiscard]] std::vector<Target> targets_from(const std::filesystem::path& file);

[[nodiscard]] Eigen::Isometry3d pose_from(const Json& json, const std::string& where);
// The frame's name, which names files too.
[[nodiscard]] std::string frame_id_from(const Json& json);

struct CurveAtRest {
  std::string id;
  std::vector<Eigen::Vector3d> points_mm;
};
// "features" of a document; its tables are named from `folder`.
[[nodiscard]] std::vector<CurveAtRest> curves_at_rest(const Json& json, const std::filesystem::path& folder);
[[nodiscard]] const CurveAtRest& curve_called(const std::string& id, const std::vector<CurveAtRest>& among,
                                              const std::string& where);

}  // namespace glisson::guidance

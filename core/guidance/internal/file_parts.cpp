#include "guidance/internal/file_parts.h"

#include <algorithm>
#include <array>

#include "base/csv.h"
#include "base/files.h"
#include "base/json_value.h"

namespace glisson::guidance {

namespace fs = std::filesystem;
using Eigen::Vector3d;

namespace {

template <int N>
std::vector<Eigen::Matrix<double, N, 1>> places_from(const fs::path& file, const std::array<const char*, N>& names) {
  const CsvTable table = taken(read_csv(file));
  std::array<std::size_t, N> columns{};
  for (std::size_t axis = 0; axis < N; ++axis) {
    columns[axis] =
        taken(table.column(names[axis]).map_error([&](Error error) { return std::move(error).in_file(file); }));
  }
  std::vector<Eigen::Matrix<double, N, 1>> places;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    Eigen::Matrix<double, N, 1> place;
    for (std::size_t axis = 0; axis < N; ++axis) place[static_cast<int>(axis)] = table.columns[columns[axis]][row];
    if (place.allFinite()) places.push_back(place);
  }
  return places;
}

}  // namespace

void refuse_in(const std::string& where, const std::string& what) {
  refuse({}, GLISSON_TEXT("In {0}: {1}."), {where, what}, {});
}

std::string text_under(const Json& json, const char* key, const std::string& where) {
  return text_in(required(json, key, where), where + ", " + key);
}

double number_or(const Json& json, const char* key, double otherwise, const std::string& where) {
  const Json* value = value_in(json, key);
  return value == nullptr ? otherwise : number_in(*value, where + ", " + key);
}

double positive_or(const Json& json, const char* key, double otherwise, const std::string& where) {
  const Json* value = value_in(json, key);
  return value == nullptr ? otherwise : positive_in(*value, where + ", " + key);
}

std::vector<Vector3d> curve_from(const fs::path& file) { return places_from<3>(file, {"x_mm", "y_mm", "z_mm"}); }

std::vector<Eigen::Vector2d> pixels_from(const fs::path& file) { return places_from<2>(file, {"x_px", "y_px"}); }

std::vector<Target> targets_from(const fs::path& file) {
  const std::string text = taken(read_text_file(file, std::uint64_t{64} << 20));
  const std::vector<CsvRow> rows = csv_rows(text);
  if (rows.empty() || rows.front().cells != std::vector<std::string_view>{"id", "x_mm", "y_mm", "z_mm"}) {
    refuse({}, GLISSON_TEXT("The first line must be id,x_mm,y_mm,z_mm."), {}, {}, file);
  }
  std::vector<Target> targets;
  for (auto row = rows.begin() + 1; row != rows.end(); ++row) {
    Target target{std::string(row->cells[0]), {row->number(1), row->number(2), row->number(3)}};
    if (row->cells.size() != 4 || !target.at_rest_mm.allFinite()) {
      refuse({}, GLISSON_TEXT("Line {0} must hold an id and three numbers."), {std::to_string(row->line)}, {}, file);
    }
    targets.push_back(std::move(target));
  }
  return targets;
}

Eigen::Isometry3d pose_from(const Json& json, const std::string& where) {
  if (!json.is_array() || json.size() != 16) refuse_in(where, "\"pose_guess\" must be 16 numbers, row by row");
  std::vector<double> numbers;
  for (const Json& number : json) numbers.push_back(number_in(number, where + ", pose_guess"));
  const auto pose = rigid_pose(numbers);
  if (pose) return *pose;
  const Eigen::Matrix4d matrix = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>(numbers.data());
  refuse_in(where, matrix.topLeftCorner<3, 3>().determinant() < 0 ? "\"pose_guess\" mirrors the organ"
                                                                  : "\"pose_guess\" is no rigid motion");
}

std::vector<CurveAtRest> curves_at_rest(const Json& json, const fs::path& folder) {
  std::vector<CurveAtRest> curves;
  const Json* features = value_in(json, "features");
  for (const Json& feature : features == nullptr ? Json::array() : *features) {
    const std::string id = text_under(feature, "id", "features");
    curves.push_back({id, curve_from(folder / text_under(feature, "points", "feature " + id))});
    if (curves.back().points_mm.size() < 2) refuse_in("feature " + id, "a curve needs at least two points");
  }
  return curves;
}

const CurveAtRest& curve_called(const std::string& id, const std::vector<CurveAtRest>& among,
                                const std::string& where) {
  const auto known = std::find_if(among.begin(), among.end(), [&](const CurveAtRest& curve) { return curve.id == id; });
  if (known == among.end()) refuse_in(where, "the feature \"" + id + "\" is not among those of the organ");
  return *known;
}

std::string frame_id_from(const Json& json) {
  const std::string id = text_under(json, "id", "frames");
  if (id.empty() || id.find_first_of("/\\") != std::string::npos || id.front() == '.') {
    refuse_in("frame " + id, "an id names a file: no slashes, and no dot in front");
  }
  return id;
}

}  // namespace glisson::guidance

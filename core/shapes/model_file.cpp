#include "shapes/model_file.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "geometry/mesh_file.h"

namespace glisson::shapes {

using Eigen::Index;
using geometry::Field;

namespace {

std::string name_of_mode(int number) { return fmt::format("mode_{:03}_mm", number); }

}  // namespace

Result<void> write_model(const std::filesystem::path& file, const ShapeModel& model) {
  geometry::Surface surface = model.mean;
  for (int k = 0; k < model.rank(); ++k) {
    const auto column = model.modes_mm.col(k);
    surface.point_fields.push_back({name_of_mode(k + 1), 3, {column.begin(), column.end()}});
  }
  surface.point_fields.push_back({"residual_sd_mm", 1, {model.residual_sd_mm.begin(), model.residual_sd_mm.end()}});
  surface.point_fields.push_back({"livers", 1, std::vector<double>(surface.points_mm.size(), model.livers)});
  return geometry::write_surface(file, surface);
}

Result<ShapeModel> read_model(const std::filesystem::path& file) {
  auto surface = geometry::read_surface(file);
  if (!surface) return failure(surface.error());
  const auto refused = [&](const std::string& name) {
    return failure(Error{"shapes-not-a-model",
                         GLISSON_TEXT("The file is no shape model: its point array {0} is missing or damaged."),
                         {name},
                         GLISSON_TEXT("Give a model.vtp that \"study shapes\" has made."),
                         file});
  };
  const std::size_t points = surface->points_mm.size();
  const auto good = [&](const Field* field, int components) {
    return field != nullptr && field->components == components && field->items() == points &&
           std::all_of(field->values.begin(), field->values.end(), [](double value) { return std::isfinite(value); });
  };
  ShapeModel model;
  int modes = 0;
  while (geometry::find_field(surface->point_fields, name_of_mode(modes + 1)) != nullptr) ++modes;
  if (modes == 0) return refused(name_of_mode(1));
  model.modes_mm.resize(3 * static_cast<Index>(points), modes);
  for (int k = 0; k < modes; ++k) {
    const Field* mode = geometry::find_field(surface->point_fields, name_of_mode(k + 1));
    if (!good(mode, 3)) return refused(name_of_mode(k + 1));
    model.modes_mm.col(k) = Eigen::Map<const Eigen::VectorXd>(mode->values.data(), model.modes_mm.rows());
  }
  const Field* residual = geometry::find_field(surface->point_fields, "residual_sd_mm");
  const Field* livers = geometry::find_field(surface->point_fields, "livers");
  if (!good(residual, 1) || *std::min_element(residual->values.begin(), residual->values.end()) < 0) {
    return refused("residual_sd_mm");
  }
  if (!good(livers, 1) || livers->values.front() < 0 || livers->values.front() > 1e6) return refused("livers");
  model.residual_sd_mm = Eigen::Map<const Eigen::VectorXd>(residual->values.data(), static_cast<Index>(points));
  model.livers = static_cast<int>(livers->values.front());
  model.mean = std::move(*surface);
  model.mean.point_fields.clear();
  model.mean.cell_fields.clear();
  return model;
}

}  // namespace glisson::shapes

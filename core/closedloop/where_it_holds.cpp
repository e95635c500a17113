#include "closedloop/where_it_holds.h"

#include <cmath>
#include <map>
#include <tuple>
#include <vector>

#include "imaging/volume_file.h"

namespace glisson::closedloop {
namespace {

struct PatchSquare {
  Eigen::Vector3d place_mm;
  double square = 0, rows = 0;
};

// Of each trial its patches with the mean square of their rows.
std::vector<std::vector<PatchSquare>> squares_of(const Observations& all, const Eigen::VectorXd& residual) {
  std::vector<std::map<std::tuple<double, double, double>, PatchSquare>> of_trial(all.trials.size());
  for (Eigen::Index row = 0; row < all.rows(); ++row) {
    const Eigen::Vector3d place = all.place_mm.row(row).transpose();
    PatchSquare& patch =
        of_trial[static_cast<std::size_t>(all.trial[static_cast<std::size_t>(row)])][{place.x(), place.y(), place.z()}];
    patch.place_mm = place;
    patch.square += residual[row] * residual[row];
    patch.rows += 1;
  }
  std::vector<std::vector<PatchSquare>> patches;
  for (const auto& trial : of_trial) {
    patches.emplace_back();
    for (const auto& [place, patch] : trial) patches.back().push_back(patch);
  }
  return patches;
}

// Between patches by the inverse fourth power of the distance; beyond `reach_mm` of the nearest none.
imaging::Volume painted(const Elastography& waves, const std::vector<std::vector<PatchSquare>>& trials,
                        double reach_mm) {
  imaging::Volume map;
  map.grid = waves.grid;
  map.unit = "noise";
  map.values.assign(waves.grid.voxels(), 0);
  const auto& size = waves.grid.size;
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i) {
        const std::size_t voxel = waves.grid.offset(i, j, k);
        if (waves.region[voxel] == 0) continue;
        const Eigen::Vector3d here = waves.grid.position_mm(i, j, k);
        double sum = 0, weights = 0;
        for (const auto& patches : trials) {
          for (const PatchSquare& patch : patches) {
            const double distance2 = (patch.place_mm - here).squaredNorm();
            if (distance2 > reach_mm * reach_mm) continue;
            const double weight = 1 / (distance2 * distance2 + 1e-6 * std::pow(reach_mm, 4));
            sum += weight * patch.square / patch.rows;
            weights += weight;
          }
        }
        if (weights > 0) map.values[voxel] = static_cast<float>(std::sqrt(sum / weights));
      }
    }
  }
  return map;
}

double typical_distance_mm(const std::vector<PatchSquare>& patches) {
  double nearest = 0;
  for (const PatchSquare& other : patches) {
    const double distance = (other.place_mm - patches.front().place_mm).norm();
    if (distance > 0 && (nearest == 0 || distance < nearest)) nearest = distance;
  }
  return nearest;
}

}  // namespace

bool has_where_it_holds(const Experiment& experiment) { return std::holds_alternative<Elastography>(experiment.setup); }

WhereItHolds where_it_holds(const Explained& explained) {
  const auto& waves = std::get<Elastography>(explained.experiment.setup);
  const Observations& all = explained.model->observations();
  const auto before = squares_of(all, all.measured - explained.explanation.predicted_before);
  const auto after = squares_of(all, all.measured - explained.explanation.predicted_after);
  double reach_mm = 0;
  for (const auto& trial : before) reach_mm = std::max(reach_mm, typical_distance_mm(trial));
  if (reach_mm == 0) reach_mm = 4 * waves.grid.spacing_mm.maxCoeff();
  return {painted(waves, before, reach_mm), painted(waves, after, reach_mm)};
}

Result<void> write_where_it_holds(const std::filesystem::path& folder, const Explained& explained) {
  const WhereItHolds maps = where_it_holds(explained);
  return imaging::write_volume_file(folder / "residual_before.nrrd", maps.before).and_then([&] {
    return imaging::write_volume_file(folder / "residual_after.nrrd", maps.after);
  });
}

}  // namespace glisson::closedloop

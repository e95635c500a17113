#include "known_scans.h"

#include <algorithm>
#include <cmath>

#include "base/noise.h"
#include "imaging/filters.h"
#include "segmentation/rasterise.h"

namespace glisson::test {
namespace {

using Eigen::Vector3d;

// Of a voxel, by how far its centre is from the wall.
double share_inside(double wall_mm, double voxel_mm) { return std::clamp(0.5 - wall_mm / voxel_mm, 0.0, 1.0); }

std::vector<float> noise_of(const imaging::Grid& grid, const Scanner& scanner, std::uint64_t seed) {
  std::vector<float> noise(grid.voxels());
  for (std::size_t n = 0; n < noise.size(); ++n) noise[n] = static_cast<float>(normal_pair(seed, n).x());
  noise = imaging::gaussian_blur(std::move(noise), grid, scanner.blur_mm);
  double squares = 0;
  for (const float value : noise) squares += static_cast<double>(value) * static_cast<double>(value);
  const double scale = scanner.noise / std::sqrt(squares / static_cast<double>(noise.size()));
  for (float& value : noise) value = static_cast<float>(scale * static_cast<double>(value));
  return noise;
}

}  // namespace

KnownScan make_known_scan(std::uint64_t seed, const Scanner& scanner) {
  anatomy::PatientOptions options;
  options.seed = seed;
  options.arterial_terminals = 10;
  for (int n = 0; n < 2; ++n) options.lesions.push_back({});
  KnownScan scan{anatomy::make_patient(options).value(), {}, {}, {}};
  const geometry::Box box = geometry::bounding_box(scan.patient.liver->surface.points_mm);
  imaging::Grid grid = anatomy::grid_over({box.min_mm - Vector3d::Constant(8), box.max_mm + Vector3d::Constant(8)}, 1);
  for (int a = 0; a < 3; ++a) {
    const double extent_mm = grid.size[static_cast<std::size_t>(a)];
    grid.size[static_cast<std::size_t>(a)] = static_cast<int>(extent_mm / scanner.spacing_mm[a]);
  }
  grid.spacing_mm = scanner.spacing_mm;
  scan.liver = segmentation::rasterise(scan.patient.liver->surface, grid);
  const anatomy::Field portal = tree_field(scan.patient.portal_vein, grid, 0.3),
                       hepatic = tree_field(scan.patient.hepatic_vein, grid, 0.3);
  const anatomy::Field portal_seen = tree_field(scan.patient.portal_vein, grid, 1),
                       hepatic_seen = tree_field(scan.patient.hepatic_vein, grid, 1);
  scan.vessels = {grid, std::vector<std::uint8_t>(grid.voxels(), 0)};
  scan.image = {{grid, std::vector<float>(grid.voxels())}, scanner.unit};
  const double voxel_mm = std::cbrt(grid.voxel_volume_mm3());
  const std::size_t row = static_cast<std::size_t>(grid.size[0]), slice = row * static_cast<std::size_t>(grid.size[1]);
  const auto position_mm = [&](std::size_t n) {
    return grid.position_mm(static_cast<int>(n % row), static_cast<int>(n % slice / row), static_cast<int>(n / slice));
  };
  for (std::size_t n = 0; n < scan.image.values.size(); ++n) {
    double value = scan.liver.values[n] != 0 ? scanner.tissue : scanner.around;
    for (const anatomy::Lesion& lesion : scan.patient.lesions) {
      value += share_inside(lesion.distance_mm(position_mm(n)), voxel_mm) * (scanner.tumour - value);
    }
    value += share_inside(static_cast<double>(hepatic.values[n]), voxel_mm) * (scanner.hepatic - value);
    value += share_inside(static_cast<double>(portal.values[n]), voxel_mm) * (scanner.portal - value);
    scan.image.values[n] = static_cast<float>(value);
    scan.vessels.values[n] =
        std::min(portal_seen.values[n], hepatic_seen.values[n]) < 0 && scan.liver.values[n] != 0 ? 1 : 0;
  }
  scan.image.values = imaging::gaussian_blur(std::move(scan.image.values), grid, scanner.blur_mm);
  const std::vector<float> noise = noise_of(grid, scanner, mixed(seed, 5));
  for (std::size_t n = 0; n < scan.image.values.size(); ++n) {
    const double gain = 1 + scanner.drift * smooth_noise(mixed(seed, 6), position_mm(n), 150);
    scan.image.values[n] = static_cast<float>(gain * static_cast<double>(scan.image.values[n])) + noise[n];
  }
  return scan;
}

}  // namespace glisson::test

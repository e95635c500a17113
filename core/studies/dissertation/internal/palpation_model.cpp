#include "studies/dissertation/internal/palpation_model.h"

#include <array>
#include <cmath>

#include "base/units.h"
#include "elastography/inversion.h"
#include "elastography/wave_phantom.h"
#include "mechanics/scenario/mesh_moduli.h"
#include "mechanics/simulation.h"

namespace glisson::studies {

using Eigen::Vector3d;

// A square, graded, bent to a disc: (u, v) to (u sqrt(1 - v2/2), v sqrt(1 - u2/2)).
geometry::TetMesh palpation_mesh(const PalpationSpecimen& specimen, const PalpationMesh& options) {
  const int across = options.across, high = options.high;
  const auto graded = [&](int i) {
    const double even = 2.0 * i / across - 1;
    return std::copysign(std::pow(std::abs(even), options.grading), even);
  };
  geometry::TetMesh mesh;
  const auto point = [&](int i, int j, int k) { return i + (across + 1) * (j + (across + 1) * k); };
  for (int k = 0; k <= high; ++k) {
    for (int j = 0; j <= across; ++j) {
      for (int i = 0; i <= across; ++i) {
        const double u = graded(i), v = graded(j);
        mesh.points_mm.emplace_back(specimen.radius_mm * u * std::sqrt(1 - v * v / 2),
                                    specimen.radius_mm * v * std::sqrt(1 - u * u / 2), specimen.height_mm * k / high);
      }
    }
  }
  constexpr std::array<std::array<std::size_t, 3>, 6> walks{
      {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
  for (int k = 0; k < high; ++k) {
    for (int j = 0; j < across; ++j) {
      for (int i = 0; i < across; ++i) {
        for (const auto& walk : walks) {
          std::array<int, 3> at{i, j, k};
          std::array<int, 4> cell{point(at[0], at[1], at[2])};
          for (std::size_t step = 0; step < 3; ++step) {
            ++at[walk[step]];
            cell[step + 1] = point(at[0], at[1], at[2]);
          }
          mesh.cells.push_back(cell);
          if (geometry::cell_volume_mm3(mesh, mesh.cells.size() - 1) < 0)
            std::swap(mesh.cells.back()[2], mesh.cells.back()[3]);
        }
      }
    }
  }
  return mesh;
}

namespace {

imaging::Grid grid_around(const PalpationSpecimen& specimen, double voxel_mm) {
  const int across = static_cast<int>(std::ceil(2 * specimen.radius_mm / voxel_mm));
  const int slices = static_cast<int>(std::floor(specimen.height_mm / voxel_mm));
  imaging::Grid grid = elastography::cube_grid(across, slices, voxel_mm, voxel_mm);
  grid.origin_mm.z() += specimen.height_mm / 2;
  return grid;
}

std::vector<elastography::ComplexField> waves_in(const PalpationSpecimen& specimen, const imaging::Grid& grid,
                                                 const PalpationScan& scan) {
  const auto modulus_kPa = [&](double youngs_kPa) {
    const double shear_kPa = units::shear_from_youngs(youngs_kPa, usual_poisson_ratio);
    return elastography::Complex(shear_kPa, scan.loss * shear_kPa);
  };
  const Vector3d middle(0, 0, specimen.height_mm / 2);
  if (specimen.upper_kPa != specimen.lower_kPa) {
    return elastography::crossing_waves(elastography::LayeredPhantom{
        grid, scan.frequency_Hz, modulus_kPa(specimen.lower_kPa), modulus_kPa(specimen.upper_kPa), middle.z()});
  }
  const double inside_kPa = specimen.inclusion_radius_mm > 0 ? specimen.inclusion_kPa : specimen.upper_kPa;
  return elastography::crossing_waves(
      elastography::WavePhantom{grid, scan.frequency_Hz, modulus_kPa(specimen.upper_kPa), modulus_kPa(inside_kPa),
                                middle, specimen.inclusion_radius_mm});
}

}  // namespace

Result<elastography::CellStiffness> elastography_of(const PalpationSpecimen& specimen, const geometry::TetMesh& mesh,
                                                    const PalpationScan& scan, double poisson_ratio,
                                                    const Progress& progress) {
  const imaging::Grid grid = grid_around(specimen, scan.voxel_mm);
  imaging::Mask organ{grid, std::vector<std::uint8_t>(grid.voxels(), 0)};
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        organ.at(i, j, k) = grid.position_mm(i, j, k).head<2>().norm() < specimen.radius_mm ? 1 : 0;
      }
    }
  }
  const auto images = elastography::measured(grid, scan.frequency_Hz, waves_in(specimen, grid, scan),
                                             scan.amplitude_rad, scan.noise_rad, scan.instants, scan.seed);
  const elastography::InversionOptions inversion;
  const auto map = elastography::invert({images}, organ, inversion, progress);
  if (!map) return failure(map.error());
  imaging::Mask confident{grid, std::vector<std::uint8_t>(grid.voxels(), 0)};
  for (std::size_t v = 0; v < confident.values.size(); ++v) {
    confident.values[v] = map->confidence.values[v] >= inversion.minimum_confidence ? 1 : 0;
  }
  std::vector<Vector3d> centroids_mm(mesh.cells.size());
  for (std::size_t cell = 0; cell < centroids_mm.size(); ++cell) {
    centroids_mm[cell] = geometry::cell_centroid_mm(mesh, cell);
  }
  elastography::StiffnessOptions options;
  options.poisson_ratio = poisson_ratio;
  return elastography::cell_stiffness(centroids_mm, map->magnitude_kPa, {confident, organ}, options);
}

Result<PressedPhantom> press(geometry::TetMesh mesh, std::vector<double> youngs_kPa, double poisson_ratio,
                             double ball_radius_mm, double force_N, const Progress& progress) {
  double top_mm = 0;
  for (const Vector3d& p : mesh.points_mm) top_mm = std::max(top_mm, p.z());
  PressedPhantom phantom{geometry::boundary_surface(mesh), {}, 0, 0};
  mechanics::set_moduli(mesh, std::move(youngs_kPa), poisson_ratio);
  mechanics::Scenario scenario;
  scenario.material = mechanics::MaterialLaw::neo_hookean;
  scenario.poisson_ratio = poisson_ratio;
  scenario.youngs_modulus = mechanics::youngs_modulus_field;
  scenario.supports = {{geometry::Box{{-1e3, -1e3, -1}, {1e3, 1e3, 1e-6}}, mechanics::Fixed{}}};
  mechanics::ScenarioRigidTool ball{mechanics::palpation_probe(ball_radius_mm),
                                    {0, 0, top_mm + ball_radius_mm},
                                    {0, 0, -1},
                                    0,
                                    units::mN_from_N(force_N)};
  scenario.tools = {{"ball", ball}};
  const auto simulation = mechanics::simulate(mesh, scenario, {}, progress);
  if (!simulation) return failure(simulation.error());
  if (!simulation->result.may_be_used()) {
    return failure("palpation-not-converged", GLISSON_TEXT("The phantom's equilibrium was not reached: {0}"),
                   {mechanics::why_not_used(simulation->result)});
  }
  phantom.depth_mm = simulation->tools.front().advance_mm;
  phantom.largest_strain = simulation->result.largest_strain;
  phantom.pressed = phantom.rest;
  const geometry::Field* mesh_point = geometry::find_field(phantom.rest.point_fields, "mesh_point");
  GLISSON_ASSERT(mesh_point != nullptr);
  for (std::size_t p = 0; p < phantom.pressed.points_mm.size(); ++p) {
    phantom.pressed.points_mm[p] += simulation->result.displacement_mm[static_cast<std::size_t>(mesh_point->values[p])];
  }
  return phantom;
}

}  // namespace glisson::studies

// Labels to tetrahedra and to Voronoi nodes, on a large generated liver rasterised to 1.5 mm.
//
//   bench_meshing        counters: cells, min_dihedral_deg, hausdorff_mm

#include <benchmark/benchmark.h>

#include "anatomy/patient.h"
#include "mechanics/meshfree/voronoi_nodes.h"
#include "meshing/mesh_labels.h"
#include "segmentation/rasterise.h"

namespace {

using namespace glisson;

imaging::Mask patient_liver() {
  anatomy::PatientOptions options;
  options.volume_ml = 2300;
  const auto surface = anatomy::make_liver_surface(options);
  constexpr double spacing_mm = 1.5;
  constexpr int margin = 3;
  const geometry::Box box = geometry::bounding_box(surface->points_mm);
  imaging::Grid grid;
  grid.spacing_mm = Eigen::Vector3d::Constant(spacing_mm);
  grid.origin_mm = box.min_mm - Eigen::Vector3d::Constant(margin * spacing_mm);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double extent_mm = box.max_mm[static_cast<Eigen::Index>(axis)] - box.min_mm[static_cast<Eigen::Index>(axis)];
    grid.size[axis] = static_cast<int>(extent_mm / spacing_mm) + 1 + 2 * margin;
  }
  return segmentation::rasterise(*surface, grid);
}

void mesh_a_liver(benchmark::State& state) {
  const imaging::Mask liver = patient_liver();
  imaging::LabelMap labels;
  labels.grid = liver.grid;
  labels.values.assign(liver.values.begin(), liver.values.end());
  for (auto _ : state) {
    const auto mesh = meshing::mesh_labels(labels, {.target_cells = static_cast<int>(state.range(0))});
    if (!mesh) return state.SkipWithError(mesh.error().message().c_str());
    state.counters["cells"] = static_cast<double>(mesh->body.cells.size());
    state.counters["min_dihedral_deg"] = mesh->quality.min_dihedral_deg;
    state.counters["hausdorff_mm"] = mesh->hausdorff_mm;
  }
}
BENCHMARK(mesh_a_liver)->Arg(5000)->Arg(20000)->Arg(90000)->Unit(benchmark::kMillisecond)->UseRealTime();

void spread_nodes(benchmark::State& state) {
  const imaging::Mask liver = patient_liver();
  for (auto _ : state) {
    const auto nodes = mechanics::voronoi_nodes(liver, {.nodes = static_cast<int>(state.range(0))});
    if (!nodes) return state.SkipWithError(nodes.error().message().c_str());
    state.counters["rounds"] = static_cast<double>(nodes->energies_mm5.size() - 1);
  }
}
BENCHMARK(spread_nodes)->Arg(1000)->Arg(10000)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

BENCHMARK_MAIN();

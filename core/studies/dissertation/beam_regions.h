#pragma once
// Does one stiffness serve a whole liver? Beams of tissue are cut where a liver is softest, stiffest and most uneven.
// They are hoisted, and compared with a beam of the liver's mean. Source: section 4.4 of the dissertation (figures 4.9,
// 4.13; table 4.1).
//
// A beam is 50 x 10 x 10 mm at 997 kg/m3 and lifted by 0.05 N at its middle. It hangs between two ends on the abdominal
// wall. The wall has 22 kPa as a layer of 20 mm, as for whole livers (rehearsal/liver_supports.h), so 1.1 kPa/mm. The
// table says neither where the wall nor where the force acts: both are our assumption. Meshfree engine, corotational,
// Poisson's ratio 0.45.

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "geometry/surface.h"
#include "geometry/tetrahedra.h"
#include "mechanics/meshfree/compliance_distance.h"
#include "mechanics/scenario/scenario.h"

namespace glisson::studies {

struct BeamOptions {
  double force_N = 0.05;
  double foundation_kPa_per_mm = 1.1;
  // Linear finite elements answer for many beams. They come within a tenth of the meshfree engine for a beam of 3.5
  // kPa, which is lifted by 20 mm. They are some hundred times faster.
  mechanics::Engine engine = mechanics::Engine::meshfree;
  int nodes = 60;  // a beam takes seconds with them, and minutes with 120
  double significant_mm = 5.0;
};

enum class BeamRegion { soft, stiff, uneven };
inline constexpr std::array<const char*, 3> region_names{"soft", "stiff", "most heterogeneous"};

// A beam's place in the liver.
struct BeamPlace {
  Eigen::Vector3d corner_mm{0, 0, 0};  // patient coordinates; the beam runs along `axis`
  int axis = 0;                        // 0 x, 1 y, 2 z
  double mean_kPa = 0, sd_kPa = 0;     // Young's modulus over the beam
};

// Where in a liver of tetrahedra a beam would have the lowest mean modulus, the highest, and the largest standard
// deviation. All places on a grid of 2.5 mm that lie wholly inside are compared. Failures: "liver-too-small" (no beam
// fits).
Result<std::array<BeamPlace, 3>> beam_places(const geometry::TetMesh& liver, const std::vector<double>& youngs_kPa);

// The same in tissue given as voxels of that size.
inline constexpr double beam_voxel_mm = 2.5;
Result<std::array<BeamPlace, 3>> beam_places(const mechanics::VoxelBody& tissue);

struct BeamComparison {
  BeamPlace place;
  double largest_displacement_mm = 0;
  double mean_mm = 0, max_mm = 0;  // apart from the control beam, over the surface
  geometry::Surface lifted;        // in the beam's own frame (x along it, z up), with the point field "apart_mm"
};

struct BeamRow {
  std::string patient;
  double mean_kPa = 0;  // of the whole liver, by volume
  double control_displacement_mm = 0;
  std::array<BeamComparison, 3> regions;
};

Result<BeamRow> compare_beams(const std::string& patient, const geometry::TetMesh& liver,
                              const std::vector<double>& youngs_kPa, const BeamOptions& options,
                              const Progress& progress = {});

// The same in tissue as beam_places takes it; the control beam has the modulus `mean_kPa`.
Result<BeamRow> compare_beams(const std::string& patient, const mechanics::VoxelBody& tissue, double mean_kPa,
                              const BeamOptions& options, const Progress& progress = {});

// beams.csv, summary.json and report.html.
Result<void> write_beams(const std::filesystem::path& out, const std::vector<BeamRow>& rows,
                         const BeamOptions& options);

}  // namespace glisson::studies

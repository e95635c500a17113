// Against a measured beam: silicone (Dragon Skin 10, 30 x 30 x 100 mm, 1070 kg/m3), clamped level at one end, let go
// under its weight and with 52 g at its tip, seen by motion capture (srl-ethz/diffPD_sim2real, MIT). One number is
// fitted, Young's modulus, to one trial under weight alone; the other trials are foretold.

#include <gmock/gmock.h>
#include <cmath>

#include "base/csv.h"
#include "mechanics/bodies.h"
#include "mechanics/equilibrium.h"
#include "support/data.h"

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;

// How far the tip sinks, mean of its three markers: from the first frame, where it is held up, to the end, where it has
// come to rest. Gravity is along -x.
double measured_sag_mm(const std::string& trial) {
  const auto table = read_csv(glisson::test::shared_data() / "softbeam_mocap_eth/csv" / (trial + ".csv")).value();
  double sag_mm = 0;
  for (const char* marker : {"Tip-1_x_mm", "Tip-2_x_mm", "Tip-3_x_mm"}) {
    const auto& x_mm = table.columns[table.column(marker).value()];
    double rest_mm = 0;
    for (std::size_t i = x_mm.size() - 50; i < x_mm.size(); ++i) rest_mm += x_mm[i] / 50;
    sag_mm += (x_mm.front() - rest_mm) / 3;
  }
  return sag_mm;
}

struct MeasuredBeam {
  geometry::TetMesh mesh = test::box(8, 3, 3, {100, 30, 30});
  StaticOptions options;

  MeasuredBeam() {
    options.poisson_ratio = 0.49;
    options.density_kg_mm3 = 1070e-9;
    test::name_points(mesh, "clamp", [](const Vector3d& p) { return p.x() == 0; });
  }
  [[nodiscard]] static Loads loads(double tip_kg) {
    Loads all{GravityLoad{{0, 0, -9810}}};
    if (tip_kg > 0) all.emplace_back(ToolLoad{{100, 15, 15}, 14, {0, 0, -9810 * tip_kg}});
    return all;
  }
  [[nodiscard]] double sag_mm(const StaticResult& result) const {
    EXPECT_TRUE(result.may_be_used()) << result.why_stopped;
    double sag = 0;
    int points = 0;
    for (std::size_t p = 0; p < mesh.points_mm.size(); ++p) {
      if (mesh.points_mm[p].x() < 100) continue;
      sag -= result.displacement_mm[p].z();
      ++points;
    }
    return sag / points;
  }
  [[nodiscard]] double by_cells_mm(double youngs_kPa, double tip_kg) const {
    const auto body =
        prepare_body(mesh, test::uniform(mesh, youngs_kPa), {test::held("clamp")}, options, Holding::required).value();
    return sag_mm(find_equilibrium(body, materials_of(body, MaterialLaw::neo_hookean), loads(tip_kg)).value());
  }
};

TEST(MeasuredBeam, ItsSagUnderATipLoadIsForetoldFromItsSagUnderItsWeight) {
  GLISSON_NEEDS_DATA("softbeam_mocap_eth");
  const MeasuredBeam beam;
  const double known_mm = measured_sag_mm("beam_gravity_V2_a");
  double youngs_kPa = 263.8;  // the authors' own fit, to start from
  const double by_authors_mm = beam.by_cells_mm(youngs_kPa, 0);
  for (int round = 0; round < 2; ++round) youngs_kPa *= beam.by_cells_mm(youngs_kPa, 0) / known_mm;
  std::printf("under its weight: measured %.2f and %.2f mm; %.2f mm with the authors' 263.8 kPa; fitted %.1f kPa\n",
              known_mm, measured_sag_mm("beam_gravity_V2_b"), by_authors_mm, youngs_kPa);
  const double by_cells_mm = beam.by_cells_mm(youngs_kPa, 0.052);
  for (const char* trial : {"beam_load52_V2_a", "beam_load52_V2_b"}) {
    const double measured_mm = measured_sag_mm(trial);
    std::printf("%s: measured %.2f mm; %+.2f mm off\n", trial, measured_mm, by_cells_mm - measured_mm);
    // Trials alike differ by up to 1.1 mm at a marker (the data's SOURCE.txt). The rest of the 1.4 mm by which the beam
    // sinks farther is not explained by a modulus: 8 % of the sag.
    EXPECT_NEAR(by_cells_mm, measured_mm, 1.7);
  }
}

}  // namespace
}  // namespace glisson::mechanics

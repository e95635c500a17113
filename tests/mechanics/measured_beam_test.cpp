// Against a measured beam: silicone (Dragon Skin 10, 30 x 30 x 100 mm, 1070 kg/m3), clamped level at one end, let go
// under its weight and with 52 g at its tip, seen by motion capture (srl-ethz/diffPD_sim2real, MIT). One number is
// fitted, Young's modulus, to one trial under weight alone; the other trials are predicted.

#include <gmock/gmock.h>
#include <cmath>

#include "base/csv.h"
#include "mechanics/bodies.h"
#include "mechanics/statics/equilibrium.h"
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

// What a marker does along an axis, from the first frame to rest.
double moved_mm(const std::string& trial, const std::string& marker, char axis) {
  const auto table = read_csv(glisson::test::shared_data() / "softbeam_mocap_eth/csv" / (trial + ".csv")).value();
  const auto& at_mm = table.columns[table.column(marker + "_" + axis + "_mm").value()];
  double rest_mm = 0;
  for (std::size_t i = at_mm.size() - 50; i < at_mm.size(); ++i) rest_mm += at_mm[i] / 50;
  return rest_mm - at_mm.front();
}

// How far the tip's end turns about the level axis across the beam: the markers 1 and 3 are 29 mm apart in height.
double measured_turn_rad(const std::string& trial) {
  const auto table = read_csv(glisson::test::shared_data() / "softbeam_mocap_eth/csv" / (trial + ".csv")).value();
  const auto first = [&](const char* name) { return table.columns[table.column(name).value()].front(); };
  const double height_mm = first("Tip-1_x_mm") - first("Tip-3_x_mm");
  const double before_mm = first("Tip-1_z_mm") - first("Tip-3_z_mm");
  const double more_mm = moved_mm(trial, "Tip-1", 'z') - moved_mm(trial, "Tip-3", 'z');
  const double height_after_mm = height_mm + moved_mm(trial, "Tip-1", 'x') - moved_mm(trial, "Tip-3", 'x');
  return std::atan2(before_mm + more_mm, height_after_mm) - std::atan2(before_mm, height_mm);
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
  [[nodiscard]] double turn_rad(const StaticResult& result) const {
    const std::size_t top = test::point_at(mesh, {100, 10, 30}), bottom = test::point_at(mesh, {100, 10, 0});
    const Vector3d across =
        mesh.points_mm[top] + result.displacement_mm[top] - mesh.points_mm[bottom] - result.displacement_mm[bottom];
    return std::atan2(across.x(), across.z());
  }
  [[nodiscard]] StaticResult by_cells(double youngs_kPa, double tip_kg) const {
    return under(youngs_kPa, loads(tip_kg));
  }
  [[nodiscard]] StaticResult under(double youngs_kPa, const Loads& applied) const {
    const auto body =
        prepare_body(mesh, test::uniform(mesh, youngs_kPa), {test::fixed("clamp")}, options, Holding::required).value();
    return find_equilibrium(body, materials_of(body, MaterialLaw::neo_hookean), applied).value();
  }
  [[nodiscard]] double by_cells_mm(double youngs_kPa, double tip_kg) const {
    return sag_mm(by_cells(youngs_kPa, tip_kg));
  }
};

TEST(MeasuredBeam, ItsSagUnderATipLoadIsPredictedFromItsSagUnderItsWeight) {
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

// The beam sinks by 8 % more under the 52 g than predicted. What of that the recordings themselves can say:
TEST(MeasuredBeam, WhatIsMissingUnderTheTipLoadIsNotTheClampNorThePlaceOfTheMarkers) {
  GLISSON_NEEDS_DATA("softbeam_mocap_eth");
  const MeasuredBeam beam;
  constexpr double fitted_kPa = 261.6;  // by the test above
  // Its clamp gives way alike with and without the load: markers 1 and 2 on it, 28 mm apart in height, move by less
  // than 0.1 mm more, so that it turns by 0.003 rad more at most, a third of a millimetre at the tip.
  for (const char* marker : {"Base-1", "Base-2", "Base-3"}) {
    const double more_mm = moved_mm("beam_load52_V2_a", marker, 'x') - moved_mm("beam_gravity_V2_a", marker, 'x');
    EXPECT_LT(std::abs(more_mm), 0.1) << marker;
  }
  // The tip's end turns farther too, wherever on it the markers sit, and by a larger share than it sinks: with the load
  // 22 % more than predicted beyond what the weight alone makes, against 15 % of sag. Under its weight it turns as
  // predicted.
  const StaticResult by_weight = beam.by_cells(fitted_kPa, 0), predicted = beam.by_cells(fitted_kPa, 0.052);
  const double turned_rad = 0.5 * (measured_turn_rad("beam_load52_V2_a") + measured_turn_rad("beam_load52_V2_b"));
  const double sunk_mm = 0.5 * (measured_sag_mm("beam_load52_V2_a") + measured_sag_mm("beam_load52_V2_b"));
  EXPECT_NEAR(beam.turn_rad(by_weight), measured_turn_rad("beam_gravity_V2_a"), 0.007);
  const double more_sag = (sunk_mm - beam.sag_mm(by_weight)) / (beam.sag_mm(predicted) - beam.sag_mm(by_weight));
  const double more_turn =
      (turned_rad - beam.turn_rad(by_weight)) / (beam.turn_rad(predicted) - beam.turn_rad(by_weight));
  // A heavier load or a softer beam would make both the same share larger. A load that hangs beyond the end by a makes
  // them larger by 1.5 a / L and 2 a / L: with 10 mm both come out. A 52 g weight of steel is a cube of 19 mm, which
  // glued to the end has its middle there. The recordings do not say how it was hung, and it stays out of the model.
  const double arm_mm = 10.0, couple_mN_mm = 0.052 * 9810 * arm_mm, apart_mm = 20.0;
  Loads beyond = MeasuredBeam::loads(0.052);
  beyond.emplace_back(ToolLoad{{100, 15, 25}, 6, {couple_mN_mm / apart_mm, 0, 0}});
  beyond.emplace_back(ToolLoad{{100, 15, 5}, 6, {-couple_mN_mm / apart_mm, 0, 0}});
  const StaticResult hung_beyond = beam.under(fitted_kPa, beyond);
  const StaticResult heavier = beam.by_cells(fitted_kPa, 0.060);
  std::printf(
      "more than predicted: sag %.3f, turn %.3f times; %.2f mm and %.3f rad measured; 10 mm beyond the end %.2f "
      "and %.3f, 60 g %.2f and %.3f\n",
      more_sag, more_turn, sunk_mm, turned_rad, beam.sag_mm(hung_beyond), beam.turn_rad(hung_beyond),
      beam.sag_mm(heavier), beam.turn_rad(heavier));
  EXPECT_GT(more_turn, more_sag);
  EXPECT_NEAR(beam.sag_mm(hung_beyond), sunk_mm, 0.4);
  EXPECT_NEAR(beam.turn_rad(hung_beyond), turned_rad, 0.01);
}

}  // namespace
}  // namespace glisson::mechanics

// The cell model: its energy, and whether it is found again in discharges that it made itself.

#include "hardware/cell.h"

#include <gtest/gtest.h>
#include <cmath>
#include <numeric>

#include "base/files.h"

namespace glisson::hardware {
namespace {

CellModel made_up_cell() {
  CellModel cell;
  cell.capacity_Ah = 2;
  cell.cutoff_V = 2.6;
  cell.resistance_per_C = 0.015;
  cell.heat = {12, 800};
  for (int k = 0; k <= 100; ++k) {
    const double depth = k / 100.0;
    cell.open_circuit_V.push_back(4.1 - 0.8 * depth - 0.7 * std::pow(depth, 12));
    cell.resistance_ohm.push_back(0.05 + 0.02 * depth);
  }
  return cell;
}

TEST(Cell, WhatIsReleasedIsDeliveredOrBecomesHeat) {
  for (const double current_A : {0.2, 2.0, 8.0}) {
    const CellRun run = run_cell(made_up_cell(), current_A, 20);
    EXPECT_NEAR(run.delivered_Wh + run.heat_Wh, run.released_Wh, 1e-9);
    EXPECT_GT(run.heat_Wh, 0);
    // The samples' own integral differs by a step at each end.
    EXPECT_NEAR(run.discharge.energy_Wh(), run.delivered_Wh, 2 * current_A * 4.1 / 3600);
  }
}

TEST(Cell, FasterIsShorterAndHotter) {
  const CellModel cell = made_up_cell();
  const Discharge slow = run_cell(cell, 2, 20).discharge;
  const Discharge fast = run_cell(cell, 6, 20).discharge;
  EXPECT_LT(fast.charge_Ah(), slow.charge_Ah());
  EXPECT_GT(fast.temperature_C.back(), slow.temperature_C.back());
}

TEST(Cell, IsFoundAgainInItsOwnDischarges) {
  const CellModel truth = made_up_cell();
  const auto found = cell_from(run_cell(truth, 0.1, 22).discharge,
                               {run_cell(truth, 2, 22).discharge, run_cell(truth, 4, 22).discharge});
  ASSERT_TRUE(found);
  // The slow discharge stops at the cutoff, a thousandth of the charge early.
  EXPECT_NEAR(found->capacity_Ah, truth.capacity_Ah, 0.005);
  EXPECT_NEAR(found->resistance_per_C, truth.resistance_per_C, 0.002);
  EXPECT_NEAR(found->heat.resistance_C_per_W, truth.heat.resistance_C_per_W, 0.2);
  EXPECT_NEAR(found->heat.time_constant_s, truth.heat.time_constant_s, 20);
  // At half the charge; the knots are 2 % of the charge apart.
  EXPECT_NEAR(found->resistance_ohm[found->resistance_ohm.size() / 2], 0.06, 0.001);
  EXPECT_NEAR(found->open_circuit_V[found->open_circuit_V.size() / 2], 3.7, 0.002);
}

TEST(Cell, TooFewDischargesAreRefused) {
  const CellModel truth = made_up_cell();
  const Discharge slow = run_cell(truth, 0.1, 22).discharge;
  const Discharge fast = run_cell(truth, 2, 22).discharge;
  EXPECT_EQ(cell_from(slow, {fast}).error().code, "discharges-too-alike");
  EXPECT_EQ(cell_from(slow, {fast, slow}).error().code, "discharges-too-alike");
}

TEST(DischargeFile, PausesAroundItAreDroppedAndHolesRefused) {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& text) {
    EXPECT_TRUE(write_text_file(folder.path() / "d.csv", text));
    DischargeColumns columns;
    columns.ambient_C = "";
    columns.temperature_C = "4";
    return read_discharge(folder.path() / "d.csv", columns);
  };
  std::string text = "0,0,4.1,22\n1,0,4.1,22\n";
  for (int i = 2; i < 40; ++i) text += std::to_string(i) + ",3,3.9,23\n";
  const auto sound = read(text + "40,0,4,23\n");
  ASSERT_TRUE(sound) << sound.error().message();
  EXPECT_EQ(sound->time_s.size(), 38u);
  EXPECT_NEAR(sound->charge_Ah(), 3 * 37 / 3600.0, 1e-12);
  EXPECT_EQ(read(text + "41,3,,23\n").error().code, "discharge-invalid");
  EXPECT_EQ(read(text + "3,3,3.9,23\n").error().code, "discharge-invalid");
  EXPECT_EQ(read("0,3,4.1,22\n1,3,4.1,22\n").error().code, "discharge-invalid");
}

}  // namespace
}  // namespace glisson::hardware

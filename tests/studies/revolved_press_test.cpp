// The pressed gel that `study palpation` takes for true: judged by closed forms, by its own energy, and by CalculiX
// with contact of surfaces, on another mesh and at large strain.

#include "studies/dissertation/internal/revolved_press.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <cmath>
#include <fstream>
#include <numbers>

#include "base/files.h"
#include "mechanics/calculix.h"

namespace glisson::studies {
namespace {

constexpr double youngs_kPa = 10, poisson_ratio = 0.45;

Gel gel(double stiffening = 0) {
  return {youngs_kPa / (2 * (1 + poisson_ratio)), youngs_kPa / (3 * (1 - 2 * poisson_ratio)), stiffening};
}
RevolvedBody even(double radius_mm, double height_mm, double stiffening = 0) {
  return {radius_mm, height_mm, [stiffening](double, double) { return gel(stiffening); }};
}

// A ball on a thin layer that is bonded to its ground (Dimitriadis et al. 2002, Biophys. J. 82:2798, eq. 2): Hertz's
// law and what the ground adds to it. The contact is a tenth of the height, the strain small.
TEST(RevolvedPress, ALittleWayIsHertzsLawOverAHardGround) {
  constexpr double nu = poisson_ratio, pi = std::numbers::pi, ball_mm = 20, height_mm = 26, depth_mm = 0.4;
  const double hertz_mN = 4.0 / 3 * youngs_kPa / (1 - nu * nu) * std::sqrt(ball_mm) * std::pow(depth_mm, 1.5);
  const double a = -(1.2876 - 1.4678 * nu + 1.3442 * nu * nu) / (1 - nu);
  const double b = (0.6387 - 1.0277 * nu + 1.5164 * nu * nu) / (1 - nu);
  const double x = std::sqrt(ball_mm * depth_mm) / height_mm, s = 2 * a / pi * x;
  const double by_ground = 1 - s + s * s - 8 / std::pow(pi, 3) * (a * a * a + 4 * pi * pi / 15 * b) * std::pow(x, 3) +
                           16 * a / std::pow(pi, 4) * (a * a * a + 3 * pi * pi / 5 * b) * std::pow(x, 4);
  ASSERT_GT(by_ground, 1.1);
  const auto curve = press_revolved(even(60, height_mm), ball_mm, {hertz_mN * by_ground},
                                    {.finest_mm = 1.25, .layers = 20, .step_mm = 0.2});
  ASSERT_TRUE(curve) << curve.error().message();
  EXPECT_NEAR(curve->at_force.front().depth_mm, depth_mm, 0.01 * depth_mm);
}

TEST(RevolvedPress, TheBallsWorkIsTheGelsEnergyAndAFinerMeshSaysTheSame) {
  for (const double stiffening : {0.0, 1.0}) {
    const auto coarse =
        press_revolved(even(30, 20, stiffening), 10, {300, 900}, {.finest_mm = 2.5, .layers = 8, .step_mm = 0.25});
    ASSERT_TRUE(coarse) << coarse.error().message();
    double work_uJ = 0;
    PressedProfile before;
    for (const PressedProfile& step : coarse->steps) {
      work_uJ += (step.depth_mm - before.depth_mm) * (step.force_mN + before.force_mN) / 2;
      before = step;
    }
    // Trapezia over steps of a quarter of a millimetre.
    EXPECT_NEAR(work_uJ, before.energy_uJ, 0.01 * work_uJ);
    ASSERT_EQ(coarse->at_force.size(), 2U);
    EXPECT_NEAR(coarse->at_force.back().force_mN, 900, 0.1);
    const auto fine = press_revolved(even(30, 20, stiffening), 10, {900}, {.finest_mm = 1.7, .layers = 12});
    ASSERT_TRUE(fine) << fine.error().message();
    EXPECT_NEAR(coarse->at_force.back().depth_mm, fine->at_force.front().depth_mm, 0.01 * fine->steps.back().depth_mm);
  }
}

TEST(RevolvedPress, WhatCannotBePressedSoFarIsNoAnswer) {
  const auto curve =
      press_revolved(even(30, 20), 10, {50000}, {.finest_mm = 3, .layers = 6, .step_mm = 0.5, .largest_part = 0.3});
  ASSERT_FALSE(curve);
  EXPECT_EQ(curve.error().code, "press-too-deep");
}

constexpr double radius_mm = 30, height_mm = 20, ball_mm = 10;

// Quadrilaterals of a body of revolution (CAX8R), the same size everywhere, under a ball that goes down by parts.
void write_input(const std::filesystem::path& file, double depth_mm, const std::string& law) {
  constexpr int across = 16, high = 10, arcs = 40;
  std::ofstream out(file);
  out << std::setprecision(10) << "*NODE, NSET=NALL\n";
  const auto node = [](int i, int k) { return 1 + i * (2 * high + 1) + k; };
  for (int i = 0; i <= 2 * across; ++i) {
    for (int k = 0; k <= 2 * high; ++k) {
      if (i % 2 == 1 && k % 2 == 1) continue;
      out << node(i, k) << ", " << radius_mm * i / (2 * across) << ", " << height_mm * k / (2 * high) << ", 0\n";
    }
  }
  out << "*ELEMENT, TYPE=CAX8R, ELSET=GEL\n";
  for (int i = 0; i < across; ++i) {
    for (int k = 0; k < high; ++k) {
      const int a = 2 * i, b = 2 * k;
      out << 1 + i * high + k;
      for (const auto& [di, dk] : {std::pair{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0}, {2, 1}, {1, 2}, {0, 1}}) {
        out << ", " << node(a + di, b + dk);
      }
      out << "\n";
    }
  }
  const int first = node(2 * across, 2 * high) + 1, first_arc = across * high + 1;
  out << "*NODE, NSET=BALL\n";
  for (int j = 0; j <= arcs; ++j) {
    const double angle = 75 * std::numbers::pi / 180 * j / arcs;
    for (const int layer : {0, 1}) {
      const double r = ball_mm - 1 + layer;
      out << first + 2 * j + layer << ", " << r * std::sin(angle) << ", " << height_mm + ball_mm - r * std::cos(angle)
          << ", 0\n";
    }
  }
  out << "*ELEMENT, TYPE=CAX4, ELSET=EBALL\n";
  for (int j = 0; j < arcs; ++j) {
    const int a = first + 2 * j;
    out << first_arc + j << ", " << a + 1 << ", " << a + 3 << ", " << a + 2 << ", " << a << "\n";
  }
  out << "*MATERIAL, NAME=MGEL\n"
      << law << "*SOLID SECTION, ELSET=GEL, MATERIAL=MGEL\n*MATERIAL, NAME=MBALL\n*ELASTIC\n1000, 0.3\n"
      << "*SOLID SECTION, ELSET=EBALL, MATERIAL=MBALL\n*SURFACE, NAME=TOP, TYPE=ELEMENT\n";
  for (int i = 0; i < across; ++i) out << (i + 1) * high << ", S3\n";
  out << "*SURFACE, NAME=OUTSIDE, TYPE=ELEMENT\nEBALL, S1\n*SURFACE INTERACTION, NAME=PRESS\n"
      << "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n2000.\n"
      << "*CONTACT PAIR, INTERACTION=PRESS, TYPE=SURFACE TO SURFACE\nTOP, OUTSIDE\n*BOUNDARY\n";
  for (int i = 0; i <= 2 * across; ++i) out << node(i, 0) << ", 1, 2\n";
  for (int k = 1; k <= 2 * high; ++k) out << node(0, k) << ", 1, 1\n";
  out << "*STEP, NLGEOM, INC=1000\n*STATIC\n0.1, 1., 1e-5, 0.1\n*BOUNDARY\nBALL, 1, 1, 0\nBALL, 2, 2, " << -depth_mm
      << "\n*NODE PRINT, NSET=BALL, TOTALS=ONLY, FREQUENCY=999\nRF\n*END STEP\n";
}

// CalculiX computes a wedge of two degrees, and prints what acts on that.
double force_mN(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string line;
  while (std::getline(in, line) && line.find("total force") == std::string::npos) {
  }
  double x = NAN, y = NAN;
  in >> x >> y;
  return -180 * y;
}

TEST(RevolvedPress, ABallAQuarterOfTheHeightDeepPressesAsInCalculix) {
  GLISSON_NEEDS_CALCULIX();
  constexpr double depth_mm = 5;
  for (const double stiffening : {0.0, 1.0}) {
    const Gel g = gel(stiffening);
    const std::string law =
        stiffening == 0 ? fmt::format("*HYPERELASTIC, NEO HOOKE\n{:.10g}, {:.10g}\n", g.shear_kPa / 2, 2 / g.bulk_kPa)
                        : fmt::format("*HYPERELASTIC, YEOH\n{0:.10g}, {1:.10g}, 0., {2:.10g}, 0., 0.\n",
                                      g.shear_kPa / 2, stiffening * g.shear_kPa / 2, 2 / g.bulk_kPa);
    const TemporaryFolder folder;
    write_input(folder.path() / "body.inp", depth_mm, law);
    ASSERT_EQ(mechanics::test::run_calculix(folder.path()), 0)
        << read_text_file(folder.path() / "ccx.log").value_or("");
    const double there_mN = force_mN(folder.path() / "body.dat");
    ASSERT_GT(there_mN, 500);
    const auto curve =
        press_revolved(even(radius_mm, height_mm, stiffening), ball_mm, {there_mN}, {.finest_mm = 1.25, .layers = 16});
    ASSERT_TRUE(curve) << curve.error().message();
    RecordProperty(stiffening == 0 ? "neo_hookean_depth_is" : "yeoh_depth_is",
                   std::to_string(curve->at_force.front().depth_mm / depth_mm));
    EXPECT_NEAR(curve->at_force.front().depth_mm, depth_mm, 0.015 * depth_mm) << stiffening;
  }
}

}  // namespace
}  // namespace glisson::studies

// Equilibria straight from measured strain and stress, against the laws that made the data, and on real silicone.

#include <gmock/gmock.h>
#include <cmath>
#include <Eigen/QR>
#include <random>

#include "mechanics/bodies.h"
#include "mechanics/data_driven.h"

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;
using test::box;
using test::held;
using test::held_along;
using test::uniform;

// --- the pieces

TEST(NonNegativeLeastSquares, FindsTheBestOfAllActiveSets) {
  // The slow, obvious way: every subset of the unknowns, solved freely, those with a negative weight left out.
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 60; ++trial) {
    Eigen::MatrixXd a(3, 5);
    Eigen::Vector3d b;
    for (double& value : a.reshaped()) value = normal(random);
    for (double& value : b) value = normal(random);
    double best = b.norm();
    for (unsigned set = 1; set < 32; ++set) {
      std::vector<int> columns;
      for (int i = 0; i < 5; ++i) {
        if (set >> i & 1U) columns.push_back(i);
      }
      const Eigen::MatrixXd part = a(Eigen::all, columns);
      const Eigen::VectorXd w = part.completeOrthogonalDecomposition().solve(b);
      if (w.minCoeff() >= 0) best = std::min(best, (part * w - b).norm());
    }
    const Eigen::VectorXd found = non_negative_least_squares(a, b);
    EXPECT_GE(found.minCoeff(), 0.0);
    EXPECT_NEAR((a * found - b).norm(), best, 1e-9);
  }
}

std::vector<StressStrain> sampled(const std::function<double(double)>& stress_kPa, double from, double to, int count) {
  std::vector<StressStrain> data;
  for (int i = 0; i < count; ++i) {
    const double strain = from + (to - from) * i / (count - 1);
    data.push_back({strain, stress_kPa(strain)});
  }
  return data;
}

TEST(MaterialData, StatesOnTheCurveAreTheirOwnNearest) {
  const auto data =
      MaterialData::create(sampled([](double e) { return 6 * e; }, -0.3, 0.3, 25), {.poisson_ratio = 0.45}).value();
  EXPECT_NEAR(data.slope_kPa(), 6.0, 1e-12);
  for (const double strain : {-0.21, -0.003, 0.05, 0.2}) {
    const double stress_kPa = 2.0 * data.shear_kPa() * strain;
    const auto nearest = data.nearest({strain, stress_kPa});
    EXPECT_NEAR(nearest.strain, strain, 1e-7);
    EXPECT_NEAR(nearest.stress_kPa, stress_kPa, 1e-6);
  }
}

TEST(MaterialData, WhatIsNoMaterialIsRefused) {
  EXPECT_EQ(MaterialData::create({{0.1, 1}}, {}).error().code, "data-invalid");
  EXPECT_EQ(MaterialData::create({{0.1, -1}, {0.2, -2}, {0.3, -3}}, {}).error().code, "data-invalid");
  EXPECT_EQ(MaterialData::create({{0.1, 1}, {0.2, NAN}, {0.3, 3}}, {}).error().code, "data-invalid");
}

// --- against the law that made the data

struct Retracted {
  geometry::TetMesh mesh = box(10, 3, 3, {50, 20, 15});
  Loads hoist{ToolLoad{{50, 10, 0}, 9, {0, 0, 20}}};

  Retracted() {
    test::name_points(mesh, "wall", [](const Vector3d& p) { return p.x() == 0; });
  }
  [[nodiscard]] StaticResult by_law(double youngs_kPa) const {
    StaticOptions options;
    options.poisson_ratio = 0.45;
    return solve_static(mesh, uniform(mesh, youngs_kPa), {held("wall")}, hoist, options).value();
  }
  [[nodiscard]] DataDrivenResult by_data(const std::vector<StressStrain>& measured, int neighbours = 6) const {
    const auto data = MaterialData::create(measured, {.poisson_ratio = 0.45, .neighbours = neighbours}).value();
    return find_equilibrium_from_data(mesh, data, {held("wall")}, hoist, 1000e-9).value();
  }
  [[nodiscard]] double apart_mm(const StaticResult& a, const StaticResult& b) const {
    double largest_mm = 0;
    for (std::size_t p = 0; p < mesh.points_mm.size(); ++p) {
      largest_mm = std::max(largest_mm, (a.displacement_mm[p] - b.displacement_mm[p]).norm());
    }
    return largest_mm;
  }
};

TEST(DataDriven, InTheLinearRangeARetractionAgreesWithTheLawWithinATenthOfAMillimetre) {
  // Chapter 5's claim. 21 measurements of a liver of 6 kPa.
  const Retracted liver;
  const auto by_law = liver.by_law(6.0);
  const auto by_data = liver.by_data(sampled([](double e) { return 6 * e; }, -0.3, 0.3, 21));
  ASSERT_TRUE(by_data.result.may_be_used()) << by_data.result.why_stopped;
  EXPECT_GT(by_law.max_displacement_mm, 2.0);
  EXPECT_LT(liver.apart_mm(by_data.result, by_law), 0.01);
  EXPECT_LT(by_data.distances.back(), 1e-3);
  for (std::size_t i = 2; i < by_data.distances.size(); ++i) {
    EXPECT_LE(by_data.distances[i], 1.001 * by_data.distances[i - 1]) << "round " << i;
  }
}

// A cube between frictionless plates, under a stress along z.
double squeezed_strain(const MaterialData& data, double stress_kPa) {
  auto mesh = box(1, 1, 1, {10, 10, 10});
  test::name_points(mesh, "x0", [](const Vector3d& p) { return p.x() == 0; });
  test::name_points(mesh, "y0", [](const Vector3d& p) { return p.y() == 0; });
  test::name_points(mesh, "z0", [](const Vector3d& p) { return p.z() == 0; });
  const auto found =
      find_equilibrium_from_data(mesh, data,
                                 {held_along("x0", true, false, false), held_along("y0", false, true, false),
                                  held_along("z0", false, false, true)},
                                 {ToolLoad{{5, 5, 10}, 3, {0, 0, 100 * stress_kPa}}}, 1000e-9);
  EXPECT_TRUE(found) << found.error().message();
  EXPECT_TRUE(found->result.may_be_used()) << found->result.why_stopped;
  return found->result.displacement_mm[test::point_at(mesh, {10, 10, 10})].z() / 10;
}

TEST(DataDriven, AUniaxialTestGivesTheMeasuredCurveBack) {
  const auto stiffening = [](double e) { return 5 * e + 60 * e * e * e; };
  const auto data = MaterialData::create(sampled(stiffening, -0.4, 0.4, 161), {.poisson_ratio = 0.45}).value();
  for (const double strain : {-0.35, -0.2, 0.1, 0.3}) {
    EXPECT_NEAR(squeezed_strain(data, stiffening(strain)), strain, 2e-3);
  }
}

}  // namespace
}  // namespace glisson::mechanics

// The hyperelastic laws of full-field planes: slopes that are slopes, laws that are each other at special numbers.

#include <gtest/gtest.h>

#include <cmath>

#include "closedloop/fullfield/laws.h"

namespace glisson::closedloop {
namespace {

Eigen::VectorXd some_numbers(const LawForm& form) {
  Eigen::VectorXd numbers(static_cast<Eigen::Index>(form.parameters.size()));
  for (std::size_t p = 0; p < form.parameters.size(); ++p) {
    const LawNumber number = form.parameters[p].number;
    numbers[static_cast<Eigen::Index>(p)] = number == LawNumber::shape   ? form.parameters[p].tried.front()
                                            : number == LawNumber::angle ? 30
                                                                         : 0.4 + 0.3 * static_cast<double>(p);
  }
  return numbers;
}

PlaneStress stress_of(const PlaneLaw& law, const Eigen::Vector4d& deformation) {
  PlaneStress stress;
  add_stress(law, deformation, true, stress);
  return stress;
}

TEST(PlaneLaws, TangentIsTheSlopeOfStress) {
  const std::vector<Eigen::Vector4d> deformations{
      {1, 0, 0, 1}, {1.2, 0, 0, 1.2}, {1.2, 0.1, -0.05, 1.4}, {0.9, 0.2, 0.1, 1.05}, {1.2001, 0, 0, 1.2}};
  for (const LawForm& form : plane_laws()) {
    const PlaneLaw law{&form, some_numbers(form)};
    for (const Eigen::Vector4d& f : deformations) {
      const Eigen::Matrix4d tangent = stress_of(law, f).tangent;
      for (int i = 0; i < 4; ++i) {
        const Eigen::Vector4d step = 1e-5 * Eigen::Vector4d::Unit(i);
        const Eigen::Vector4d slope = (stress_of(law, f + step).stress - stress_of(law, f - step).stress) / 2e-5;
        EXPECT_LT((slope - tangent.col(i)).norm(), 1e-5 * (1 + tangent.norm())) << form.name << " at " << f.transpose();
      }
    }
  }
}

TEST(PlaneLaws, RestIsFreeOfStress) {
  for (const LawForm& form : plane_laws())
    EXPECT_LT(stress_of({&form, some_numbers(form)}, {1, 0, 0, 1}).stress.norm(), 1e-12) << form.name;
}

// Rotated by the same turn; a law that is not would weigh how the plate lies.
TEST(PlaneLaws, StressTurnsWithTheBody) {
  const double c = std::cos(0.7), s = std::sin(0.7);
  Eigen::Matrix2d turn, stretch;
  turn << c, -s, s, c;
  stretch << 1.3, 0.1, -0.1, 0.9;
  const auto flat = [](const Eigen::Matrix2d& m) { return Eigen::Vector4d(m(0, 0), m(0, 1), m(1, 0), m(1, 1)); };
  for (const LawForm& form : plane_laws()) {
    const PlaneLaw law{&form, some_numbers(form)};
    const Eigen::Vector4d still = stress_of(law, flat(stretch)).stress;
    Eigen::Matrix2d still_matrix;
    still_matrix << still[0], still[1], still[2], still[3];
    const Eigen::Vector4d turned = stress_of(law, flat(turn * stretch)).stress;
    EXPECT_LT((turned - flat(turn * still_matrix)).norm(), 1e-10) << form.name;
  }
}

TEST(PlaneLaws, OgdensOfTwoAndManyChainsAreNeoHookean) {
  const Eigen::Vector4d f(1.3, 0.2, 0.1, 0.95);
  const Eigen::Vector4d plain = stress_of({plane_law("neo-hookean"), Eigen::Vector2d(0.5, 1.5)}, f).stress;
  EXPECT_LT((stress_of({plane_law("ogden"), Eigen::Vector3d(1, 1.5, 2)}, f).stress - plain).norm(), 1e-10);
  EXPECT_LT((stress_of({plane_law("arruda-boyce"), Eigen::Vector3d(1, 1.5, 1e9)}, f).stress - plain).norm(), 1e-6);
  EXPECT_LT((stress_of({plane_law("gent"), Eigen::Vector3d(1, 1.5, 1e9)}, f).stress - plain).norm(), 1e-6);
}

TEST(PlaneLaws, NamesAreFoundHoweverTheirWordsAreJoined) {
  EXPECT_STREQ(plane_law("NeoHookean")->name, "neo-hookean");
  EXPECT_STREQ(plane_law("Gent Thomas")->name, "gent-thomas");
  EXPECT_STREQ(plane_law("Anisotropy")->name, "fibre");
  EXPECT_EQ(plane_law("steel"), nullptr);
}

}  // namespace
}  // namespace glisson::closedloop

// What the mesh's own error shows of itself in the measurements is taken off the better model, and nothing where the
// measurements do not show it. (How near that comes to a truth by other elements on another mesh, the benchmark says.)

#include <gmock/gmock.h>
#include <cmath>

#include "base/files.h"
#include "closedloop/explanation_file.h"
#include "closedloop/inference/diagnosis.h"
#include "closedloop/palpation/model.h"
#include "palpation_bodies.h"

namespace glisson::closedloop {
namespace {

constexpr double noise_mm = 0.02;
const Setting softer{"stiffness-scale", "", Eigen::VectorXd::Constant(1, 0.7)};

Palpation coarse() {
  Palpation pad = test::pad({.bricks = {4, 4, 2}});
  pad.noise_mm = noise_mm;
  return pad;
}

// Measured on a body whose displacements are those of the coarse mesh, and so much of what a finer one would change.
struct MeshErrorCase {
  Eigen::VectorXd truth_mm;
  Palpation measured;
};
MeshErrorCase made_with(double share, const Settings& settings) {
  const auto model = palpation_model(coarse()).value();
  const Eigen::VectorXd truth_mm = model->predict(settings).value() + share * model->systematic_uncertainty().expected;
  return {truth_mm, test::measured_as(coarse(), truth_mm, noise_mm)};
}

double rms(const Eigen::VectorXd& error) { return std::sqrt(error.squaredNorm() / static_cast<double>(error.size())); }

TEST(MeshError, IsTakenOffWhereTheMeasurementsShowIt) {
  const MeshErrorCase fine = made_with(0.8, {});
  const auto model = palpation_model(fine.measured).value();
  const Explanation e = diagnose(*model).value();
  EXPECT_EQ(e.verdict, Verdict::nothing_missing);
  EXPECT_TRUE(e.effects.empty());
  EXPECT_NEAR(e.mesh_error_share, 0.8, 0.05);
  const Eigen::VectorXd as_solved = model->predict(e.settings).value();
  EXPECT_LT(rms(e.predicted_after - fine.truth_mm), 0.2 * rms(as_solved - fine.truth_mm));
  EXPECT_LT(e.held_out->rms, 1.1 * noise_mm);

  // The model's file brings it along.
  const TemporaryFolder folder;
  const Experiment experiment{"experiment.json", "pad", fine.measured};
  ASSERT_TRUE(write_text_file(folder.path() / "model.json", model_text(e, *model, experiment)));
  const auto better = read_model(folder.path() / "model.json", *model, experiment);
  ASSERT_TRUE(better) << better.error().message();
  EXPECT_LT((predict_with(*model, *better).value() - e.predicted_after).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(MeshError, IsLeftAloneWhereTheyDoNot) {
  const MeshErrorCase same = made_with(0, {softer});
  const auto model = palpation_model(same.measured).value();
  const Explanation e = diagnose(*model).value();
  ASSERT_EQ(e.effects.size(), 1u);
  EXPECT_EQ(e.mesh_error_share, 0);
  EXPECT_EQ(e.predicted_after, model->predict(e.settings).value());
}

}  // namespace
}  // namespace glisson::closedloop

// A published benchmark (Suwelack and others 2014, SIMULATED): a whole liver, and half of its deformed surface.
// Guidance bends the liver; how far each place of its surface, the hidden half too, is from the truth.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "geometry/mesh_file.h"
#include "guidance/guidance_answer.h"
#include "registration/rigid.h"
#include "support/data.h"
#include "support/liver_on_video.h"

namespace glisson::studies {
namespace {

using Eigen::Vector3d;

double mean_mm(const std::vector<Vector3d>& a, const std::vector<Vector3d>& b) {
  double sum = 0;
  for (std::size_t p = 0; p < a.size(); ++p) sum += (a[p] - b[p]).norm();
  return sum / static_cast<double>(a.size());
}

TEST(HiddenSurface, IsFoundFromTheHalfThatIsSeen) {
  GLISSON_NEEDS_DATA("pbsm_liver_insilico");
  const auto surface = [](const char* file) {
    return geometry::read_surface(test::shared_data() / "pbsm_liver_insilico" / "Liver1" / file).value();
  };
  const geometry::Surface before = surface("src.ply"), after = surface("gt.ply");
  const casefile::PatientModel model = test::liver_model(before, 8000, {});
  guidance::GuidanceCase asked;
  asked.mesh = model.mesh;
  asked.youngs_kPa.assign(model.mesh.cells.size(), 5.0);
  guidance::SeenFrame frame;
  frame.id = "f0";
  frame.points_mm = surface("tgt.ply").points_mm;
  frame.pose_guess = Eigen::Isometry3d::Identity();  // as it lies in the benchmark
  asked.frames = {frame};
  std::vector<Vector3d> truth;
  for (std::size_t p = 0; p < before.points_mm.size(); p += 5) {
    asked.further_mm.push_back(before.points_mm[p]);
    truth.push_back(after.points_mm[p]);
  }
  const auto answer = guidance::answer(asked);
  ASSERT_TRUE(answer) << answer.error().message();
  const guidance::ElasticPlacement& placed = answer->frames.front().placement;
  ASSERT_TRUE(placed.converged) << placed.why_not.message();
  std::vector<Vector3d> rigid = asked.further_mm;
  const auto best = registration::align_points(asked.further_mm, truth).value();
  for (Vector3d& place : rigid) place = best * place;
  const double found_mm = mean_mm(placed.further_mm, truth), rigid_mm = mean_mm(rigid, truth);
  std::size_t within = 0;
  for (std::size_t p = 0; p < truth.size(); ++p) {
    within += (placed.further_mm[p] - truth[p]).norm() < 2.5 * placed.further_sd_mm[p] ? 1 : 0;
  }
  fmt::print(
      "whole liver: {:.2f} mm before, {:.2f} by the best rigid motion, {:.2f} by guidance; {:.0f} % within 2.5 sd\n",
      mean_mm(asked.further_mm, truth), rigid_mm, found_mm,
      100.0 * static_cast<double>(within) / static_cast<double>(truth.size()));
  EXPECT_LT(found_mm, 2.5);
  EXPECT_LT(found_mm, 0.6 * rigid_mm);
}

}  // namespace
}  // namespace glisson::studies

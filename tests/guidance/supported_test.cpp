// An organ whose supports are known. A tool's force and the targets of a body moved by another room's statics on other
// elements are found under a wrong guess of the pose. Weight and known forces are loads. The last liver is another
// group's simulation.

#include <gmock/gmock.h>

#include "base/json.h"
#include "guidance/guidance_answer.h"
#include "guidance/guidance_file.h"
#include "guidance/internal/large_deformation.h"
#include "mechanics/statics/equilibrium.h"
#include "mechanics/statics/static_model.h"
#include "support/data.h"
#include "support/egg.h"

namespace glisson::guidance {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double youngs_kPa = 5.0;
const Vector3d top_mm{2, 0, 20};
constexpr double tool_mm = 10;

std::vector<mechanics::Support> lower_part() {
  return {{geometry::Box{Vector3d(-60, -60, -30), Vector3d(60, 60, -11)}, mechanics::Fixed{}}};
}

// Quadratic elements, as the registration has linear ones.
geometry::TetMesh moved_by(const geometry::TetMesh& mesh, const mechanics::Loads& loads) {
  mechanics::StaticOptions options;
  options.poisson_ratio = 0.4;
  const auto model =
      mechanics::StaticModel::create(mesh, std::vector<double>(mesh.cells.size(), youngs_kPa), lower_part(), options);
  const auto result = model.value().solve(loads);
  geometry::TetMesh moved = model->mesh();
  for (std::size_t p = 0; p < moved.points_mm.size(); ++p) moved.points_mm[p] += result.value().displacement_mm[p];
  return moved;
}

Result<ForceModes> supported_modes(const geometry::TetMesh& mesh) {
  return ForceModes::create(mesh, std::vector<double>(mesh.cells.size(), youngs_kPa), 0.4, {.supports = lower_part()});
}

Isometry3d wrong(const Isometry3d& pose) {
  Isometry3d guess = pose;
  guess.rotate(Eigen::AngleAxisd(0.1, Vector3d(1, 1, 0).normalized()));
  guess.pretranslate(Vector3d(5, -4, 4));
  return guess;
}

Vector3d place_in(const geometry::TetMesh& mesh, const mechanics::PointInMesh& place) {
  Vector3d there = Vector3d::Zero();
  for (int k = 0; k < 4; ++k) {
    const int point = mesh.cells[static_cast<std::size_t>(place.cell)][k];
    there += place.barycentric[k] * mesh.points_mm[static_cast<std::size_t>(point)];
  }
  return there;
}

TEST(SupportedModes, StandStillWhereTheyAreFixed) {
  const geometry::TetMesh mesh = egg();
  const auto modes = supported_modes(mesh);
  ASSERT_TRUE(modes) << modes.error().message();
  EXPECT_TRUE(modes->is_supported());
  const Eigen::MatrixXd pulled_mm = 400 * modes->under_tool_mm_mN(top_mm, tool_mm).col(2);
  double highest_mm = 0;
  for (std::size_t p = 0; p < mesh.points_mm.size(); ++p) {
    const Vector3d u = pulled_mm.block<3, 1>(3 * static_cast<Eigen::Index>(p), 0);
    if (mesh.points_mm[p].z() < -11) {
      EXPECT_EQ(u.norm(), 0);
    }
    highest_mm = std::max(highest_mm, u.z());
  }
  const geometry::TetMesh moved = moved_by(mesh, {mechanics::ToolLoad{top_mm, tool_mm, Vector3d(0, 0, 400)}});
  double reference_mm = 0;
  for (std::size_t p = 0; p < mesh.points_mm.size(); ++p)
    reference_mm = std::max(reference_mm, moved.points_mm[p].z() - mesh.points_mm[p].z());
  EXPECT_NEAR(highest_mm, reference_mm, 0.25 * reference_mm);  // linear elements are stiffer
}

TEST(SupportedRegistration, FindsAToolsForceAndTheTargetsUnderAWrongGuess) {
  const geometry::TetMesh mesh = egg();
  const auto modes = supported_modes(mesh);
  ASSERT_TRUE(modes) << modes.error().message();
  const Vector3d force_mN(100, 0, 500);
  const geometry::TetMesh moved = moved_by(mesh, {mechanics::ToolLoad{top_mm, tool_mm, force_mN}});
  const auto targets = mechanics::locate_points(mesh, {Vector3d(0, 0, 0), Vector3d(15, 5, 5), Vector3d(-20, 0, -5)});
  const Isometry3d pose = somewhere();
  SeenFrame frame = half_seen(moved, pose);
  const auto at = [&](std::size_t t) { return pose * place_in(moved, targets[t]); };
  Vector3d touched_mm = Vector3d::Zero();
  double touched = 0;
  for (std::size_t p = 0; p < mesh.points_mm.size(); ++p) {
    if ((mesh.points_mm[p] - top_mm).norm() > 6) continue;
    touched_mm += moved.points_mm[p];
    ++touched;
  }
  frame.tools = {{"grasper", pose * Vector3d(touched_mm / touched), tool_mm, {}}};
  const ElasticPlacement placed = register_elastic(*modes, frame, wrong(pose), targets);
  ASSERT_TRUE(placed.converged) << placed.why_not.message();
  ASSERT_EQ(placed.tools.size(), 1u);
  EXPECT_LT((placed.tools[0].force_mN - pose.linear() * force_mN).norm(), 0.3 * force_mN.norm());
  EXPECT_GT(placed.tools[0].sd_mN, 0);
  for (std::size_t t = 0; t < targets.size(); ++t) EXPECT_LT((placed.target_mm[t] - at(t)).norm(), 1.0) << t;

  // The same force declared is a load: nothing is asked for, and the targets stay where they are.
  frame.tools[0].force_mN = pose.linear() * force_mN;
  const ElasticPlacement known = register_elastic(*modes, frame, wrong(pose), targets);
  ASSERT_TRUE(known.converged) << known.why_not.message();
  EXPECT_TRUE(known.tools.empty());
  for (std::size_t t = 0; t < targets.size(); ++t) EXPECT_LT((known.target_mm[t] - at(t)).norm(), 1.0) << t;
}

std::vector<mechanics::Support> left_part() {
  return {{geometry::Box{Vector3d(-60, -60, -30), Vector3d(-10, 60, 30)}, mechanics::Fixed{}}};
}

Result<mechanics::StaticResult> drawn_far(const geometry::TetMesh& mesh, const mechanics::Loads& loads) {
  mechanics::StaticOptions options;
  options.poisson_ratio = 0.4;
  const auto body = mechanics::prepare_body(mesh, std::vector<double>(mesh.cells.size(), youngs_kPa), left_part(),
                                            options, mechanics::Holding::required);
  return mechanics::find_equilibrium(body.value(),
                                     mechanics::materials_of(body.value(), mechanics::MaterialLaw::neo_hookean), loads);
}

const Vector3d right_end_mm{36, 0, 6};

TEST(LargeDeformation, RepeatedIsTheEquilibriumOfStatics) {
  const geometry::TetMesh mesh = egg();
  const auto modes =
      ForceModes::create(mesh, std::vector<double>(mesh.cells.size(), youngs_kPa), 0.4, {.supports = left_part()});
  ASSERT_TRUE(modes) << modes.error().message();
  const Eigen::VectorXd force_mN = modes->forces_mN(700 * modes->under_tool_mm_mN(right_end_mm, tool_mm).col(2));
  const auto reference = mechanics::find_equilibrium(
      modes->body(), mechanics::materials_of(modes->body(), mechanics::MaterialLaw::corotational), force_mN);
  ASSERT_TRUE(reference) << reference.error().message();
  LargeDeformation large(*modes, mechanics::MaterialLaw::corotational);
  Eigen::VectorXd u_mm = Eigen::VectorXd::Zero(force_mN.size());
  for (int step = 1; step <= 20; ++step) {  // the load in five parts
    ASSERT_TRUE(large.turn_to(u_mm));
    u_mm = large.under(std::min(1.0, 0.2 * step) * force_mN);
  }
  ASSERT_TRUE(large.turn_to(u_mm));
  EXPECT_LT(large.off_equilibrium(force_mN), 1e-6);
  double off_mm = 0, most_mm = 0;
  for (std::size_t p = 0; p < mesh.points_mm.size(); ++p) {
    const Vector3d there = reference->displacement_mm[p];
    off_mm = std::max(off_mm, (there - u_mm.segment<3>(3 * static_cast<Eigen::Index>(p))).norm());
    most_mm = std::max(most_mm, there.norm());
  }
  EXPECT_GT(most_mm, 20);
  EXPECT_LT(off_mm, 1e-3);
}

// By another law on other elements.
TEST(SupportedRegistration, FollowsAnOrganThatIsDrawnRoundByATool) {
  const geometry::TetMesh mesh = egg();
  const auto modes =
      ForceModes::create(mesh, std::vector<double>(mesh.cells.size(), youngs_kPa), 0.4, {.supports = left_part()});
  ASSERT_TRUE(modes) << modes.error().message();
  const auto pulled = drawn_far(mesh, {mechanics::ToolLoad{right_end_mm, tool_mm, Vector3d(0, 0, 700)}});
  ASSERT_TRUE(pulled) << pulled.error().message();
  geometry::TetMesh moved = mesh;
  std::size_t touched = 0;
  for (std::size_t p = 0; p < mesh.points_mm.size(); ++p) {
    moved.points_mm[p] += pulled->displacement_mm[p];
    if ((mesh.points_mm[p] - right_end_mm).norm() < (mesh.points_mm[touched] - right_end_mm).norm()) touched = p;
  }
  const Isometry3d pose = somewhere();
  SeenFrame frame = half_seen(moved, pose);
  frame.tools = {{"grasper", pose * moved.points_mm[touched], tool_mm, {}}};
  std::vector<Vector3d> inside_mm{{20, 0, 0}, {10, 10, -5}, {25, -8, 4}, {0, 0, 0}, {15, 5, 8}};
  const auto targets = mechanics::locate_points(mesh, inside_mm);
  const auto mean_error_mm = [&](const ElasticPlacement& placed) {
    double sum_mm = 0;
    for (std::size_t t = 0; t < targets.size(); ++t) {
      sum_mm += (placed.target_mm[t] - pose * place_in(moved, targets[t])).norm();
    }
    return sum_mm / static_cast<double>(targets.size());
  };
  const ElasticPlacement placed = register_elastic(*modes, frame, wrong(pose), targets);
  ASSERT_TRUE(placed.converged) << placed.why_not.message();
  RegistrationOptions small;
  small.large_deformation = false;
  const ElasticPlacement linear = register_elastic(*modes, frame, wrong(pose), targets, Vector3d::Zero(), small);
  EXPECT_LT(mean_error_mm(placed), 1.5);
  EXPECT_LT(mean_error_mm(placed), 0.7 * mean_error_mm(linear));
}

TEST(SupportedRegistration, KnowsTheWeight) {
  const geometry::TetMesh mesh = egg();
  const auto modes = supported_modes(mesh);
  ASSERT_TRUE(modes) << modes.error().message();
  const Vector3d gravity_mm_s2(0, 9810, 0);
  const geometry::TetMesh moved = moved_by(mesh, {mechanics::GravityLoad{gravity_mm_s2}});
  const Eigen::VectorXd known_mm = modes->known_mm(gravity_mm_s2);
  double most_mm = 0, off_mm = 0;
  for (std::size_t p = 0; p < mesh.points_mm.size(); ++p) {
    const Vector3d u = moved.points_mm[p] - mesh.points_mm[p];
    most_mm = std::max(most_mm, u.norm());
    off_mm = std::max(off_mm, (u - known_mm.segment<3>(3 * static_cast<Eigen::Index>(p))).norm());
  }
  EXPECT_GT(most_mm, 1.0);
  EXPECT_LT(off_mm, 0.25 * most_mm);
}

// Another group's simulated liver, drawn by a tool that is not declared; 0.5 mm of noise and a wrong pose are added.
TEST(SupportedRegistration, FindsAPulledLiverByItsSupportWhereTheBestRigidMotionCannot) {
  GLISSON_NEEDS_DATA("guidance_adjoint");
  const std::filesystem::path folder = test::shared_data() / "guidance_adjoint/linear-s5";
  auto guidance = read_guidance(folder / "guidance.json");
  ASSERT_TRUE(guidance) << guidance.error().message();
  const Json told = read_json_file(folder / "known.json").value();
  geometry::Field fixed{"fixed", 1, std::vector<double>(guidance->mesh.points_mm.size(), 0.0)};
  for (const Json& node : told["fixed_nodes"]) fixed.values[node.get<std::size_t>()] = 1;
  guidance->mesh.point_fields.push_back(std::move(fixed));
  guidance->supports = {{mechanics::NamedPoints{"fixed"}, mechanics::Fixed{}}};
  guidance->frames.resize(3);
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0, 0.5);
  for (SeenFrame& frame : guidance->frames) {
    for (Vector3d& point : frame.points_mm)
      point = somewhere() * point + Vector3d(noise(random), noise(random), noise(random));
    frame.noise_mm = 0.5;
    const Vector3d middle_mm(0, 0, 480);
    Isometry3d off = Isometry3d::Identity();
    off.translate(middle_mm + Vector3d(5, -4, 4));
    off.rotate(Eigen::AngleAxisd(0.1, Vector3d(1, 1, 0).normalized()));
    off.translate(-middle_mm);
    frame.pose_guess = somewhere() * off;
  }
  const auto answered = answer(*guidance);
  ASSERT_TRUE(answered) << answered.error().message();
  const Json truth = read_json_file(folder / "truth/truth.json").value();
  for (std::size_t f = 0; f < answered->frames.size(); ++f) {
    const ElasticPlacement& placed = answered->frames[f].placement;
    ASSERT_TRUE(placed.converged) << placed.why_not.message();
    double sum_mm = 0;
    for (std::size_t t = 0; t < placed.target_mm.size(); ++t) {
      const Json& p = truth["frames"][f]["targets"][t]["position_mm"];
      const Vector3d at(p[0].get<double>(), p[1].get<double>(), p[2].get<double>());
      sum_mm += (placed.target_mm[t] - somewhere() * at).norm();
    }
    EXPECT_LT(sum_mm / static_cast<double>(placed.target_mm.size()),
              0.6 * truth["frames"][f]["best_rigid_tre_mm"]["mean"].get<double>());
  }
}

}  // namespace
}  // namespace glisson::guidance

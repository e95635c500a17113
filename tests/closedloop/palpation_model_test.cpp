// The forward model of a palpation against other solvers and closed forms, its uncertainty, and what it refuses.

#include "closedloop/palpation/model.h"

#include <gmock/gmock.h>
#include <array>
#include <Eigen/Dense>
#include <set>

#include "base/json.h"
#include "closedloop/palpation/internal/effects.h"
#include "closedloop/palpation/internal/error_at_strain.h"
#include "closedloop/palpation/internal/refinement.h"
#include "closedloop/palpation_bodies.h"
#include "mechanics/statics/displacements.h"
#include "mechanics/statics/equilibrium.h"
#include "mechanics/statics/static_model.h"

namespace glisson::closedloop {
namespace {

using test::pad;
using testing::HasSubstr;

std::unique_ptr<ForwardModel> model_of(const Palpation& experiment) {
  auto model = palpation_model(experiment);
  if (!model) throw std::runtime_error(model.error().message());
  return std::move(*model);
}

Setting setting(const std::string& kind, const std::string& form, std::initializer_list<double> values) {
  return {kind, form, Eigen::Map<const Eigen::VectorXd>(values.begin(), static_cast<Eigen::Index>(values.size()))};
}

// The slow, obvious way: mechanics' own solver, a solve a sample.
Eigen::VectorXd solved_one_by_one(const Palpation& experiment, const std::vector<double>& youngs_kPa,
                                  const std::vector<mechanics::Support>& supports, const mechanics::Loads& besides) {
  mechanics::StaticOptions options;
  options.poisson_ratio = experiment.poisson_ratio;
  options.density_kg_mm3 = experiment.density_kg_mm3;
  const auto model = mechanics::StaticModel::create(experiment.mesh, youngs_kPa, supports, options).value();
  std::vector<double> values;
  for (const PalpationTrial& trial : experiment.trials) {
    for (const PalpationSample& sample : trial.samples) {
      mechanics::Loads loads = besides;
      loads.push_back(
          mechanics::ToolLoad{trial.tool.center_mm, trial.tool.radius_mm, sample.force_mN * trial.tool.direction});
      if (sample.markers.empty()) continue;
      std::vector<Eigen::Vector3d> places;
      for (const Marker& marker : sample.markers) places.push_back(marker.rest_mm);
      const auto result = model.solve(loads).value();
      for (const auto& u : model.displacement_at(result, mechanics::locate_points(experiment.mesh, places))) {
        values.insert(values.end(), {u.x(), u.y(), u.z()});
      }
    }
  }
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

double largest_difference(const Eigen::VectorXd& a, const Eigen::VectorXd& b) { return (a - b).cwiseAbs().maxCoeff(); }

TEST(PalpationModel, PredictsWhatTheSolverOfMechanicsDoes) {
  Palpation experiment = pad();
  experiment.gravity_mm_s2 = {0, 500, -9810};
  const mechanics::Loads weight{mechanics::GravityLoad{experiment.gravity_mm_s2}};
  const auto model = model_of(experiment);
  EXPECT_LT(largest_difference(model->predict({}).value(),
                               solved_one_by_one(experiment, experiment.cell_young_kPa, experiment.supports, weight)),
            1e-7);

  std::vector<double> stiffer = experiment.cell_young_kPa;
  for (double& youngs : stiffer) youngs *= 1.4;
  EXPECT_LT(largest_difference(model->predict({setting(palpation::stiffness_scale, "", {1.4})}).value(),
                               solved_one_by_one(experiment, stiffer, experiment.supports, weight)),
            1e-7);

  const std::vector<mechanics::Support> springs{{mechanics::NamedPoints{"fixed"}, mechanics::Foundation{0.7}}};
  EXPECT_LT(largest_difference(model->predict({setting(palpation::support_compliance, "", {0.7})}).value(),
                               solved_one_by_one(experiment, experiment.cell_young_kPa, springs, weight)),
            1e-7);

  mechanics::Loads more = weight;
  more.push_back(mechanics::PressureLoad{0.9});
  more.push_back(mechanics::GravityLoad{{1000, 0, 0}});
  EXPECT_LT(largest_difference(model
                                   ->predict({setting(palpation::preload, "pressure", {0.9}),
                                              setting(palpation::preload, "gravity", {1, 0, 0})})
                                   .value(),
                               solved_one_by_one(experiment, experiment.cell_young_kPa, experiment.supports, more)),
            1e-7);
}

TEST(PalpationModel, ALayerGivesWayOtherwiseAcrossThanSideways) {
  Palpation experiment = pad({.bricks = {4, 4, 2}});
  experiment.cell_young_kPa.assign(experiment.mesh.cells.size(), 1e6);  // as good as rigid
  PalpationTrial push{"push", {{30, 30, 30}, 20.0, {0.6, 0, -0.8}}, {{0, 0, {}}}};
  push.samples.push_back({1, 1600, {{"base", {30, 30, 0}, {30, 30, 0}}}});
  experiment.trials = {push};
  const Eigen::VectorXd u =
      model_of(experiment)->predict({setting(palpation::support_compliance, "layer", {0.6, 0.15})}).value();
  constexpr double base_mm2 = 60 * 60;
  EXPECT_NEAR(u[0], 0.6 * 1600 / (0.15 * base_mm2), 1e-3);
  EXPECT_NEAR(u[1], 0, 1e-3);
  EXPECT_NEAR(u[2], -0.8 * 1600 / (0.6 * base_mm2), 1e-3);
}

// A bar on rollers under a uniform pull of its end is uniformly strained, whatever its law.
Palpation bar() {
  Palpation experiment;
  experiment.mesh = mechanics::test::box(2, 2, 4, {10, 10, 20});
  for (const auto& [name, axis] : {std::pair{"x0", 0}, {"y0", 1}, {"z0", 2}}) {
    mechanics::test::name_points(experiment.mesh, name,
                                 [axis = axis](const Eigen::Vector3d& p) { return p[axis] < 1e-9; });
    experiment.supports.push_back(mechanics::test::held_along(name, axis == 0, axis == 1, axis == 2));
  }
  experiment.cell_young_kPa.assign(experiment.mesh.cells.size(), 20.0);
  experiment.noise_mm = 0.1;
  PalpationTrial trial{"pull", {{5, 5, 20}, 5.0, {0, 0, 1}}, {{0, 0, {}}}};  // the end, and no face of the sides
  for (const double stress_kPa : {1.0, 2.0, 4.0}) {
    trial.samples.push_back(
        {stress_kPa, 100 * stress_kPa, {{"end", {10, 10, 20}, {10, 10, 20}}, {"middle", {5, 5, 10}, {5, 5, 10}}}});
  }
  experiment.trials = {trial};
  return experiment;
}

TEST(PalpationModel, ABarWithAGrainIsAsStiffAsItsRatioSays) {
  const auto model = model_of(bar());
  for (const std::string form : {"fibres", "engineering"}) {
    const Eigen::VectorXd u = model->predict({setting(palpation::anisotropy, form, {0, 0, 3, 2.5})}).value();
    // At the end, under 1 kPa: 20 mm times 1 / (2.5 * 20); across it, 10 mm times nu of that strain.
    EXPECT_NEAR(u[2], 20.0 / 50.0, 1e-9) << form;
    EXPECT_NEAR(u[0], -10 * 0.45 / 50.0, 1e-9) << form;
  }
  const Eigen::VectorXd across =
      model->predict({setting(palpation::anisotropy, "engineering", {1, 0, 0, 2.5})}).value();
  EXPECT_NEAR(across[2], 20.0 / 20.0, 1e-9);
}

TEST(PalpationModel, ABarStiffensByItsLaw) {
  const auto model = model_of(bar());
  const Eigen::VectorXd grown = model->predict({setting(palpation::strain_stiffening, "exponential", {30})}).value();
  const Eigen::VectorXd straight = model->predict({setting(palpation::strain_stiffening, "linear", {5})}).value();
  for (int sample = 0; sample < 3; ++sample) {
    const double stress_kPa = std::array{1.0, 2.0, 4.0}[std::size_t(sample)];
    const double exponential = grown[6 * sample + 2] / 20, linear = straight[6 * sample + 2] / 20;
    EXPECT_NEAR(20 * std::exp(30 * exponential * exponential) * exponential, stress_kPa, 1e-5);
    EXPECT_NEAR(20 * (1 + 5 * linear) * linear, stress_kPa, 1e-5);
  }
}

TEST(PalpationModel, AtLargeStrainItFindsTheEquilibriumOfMechanics) {
  // On so many cells that no error of the mesh is added.
  Palpation experiment = pad({.bricks = {7, 7, 7}, .markers = 20, .forces_N = {2.5}, .hold_on = false});
  ASSERT_GT(experiment.mesh.cells.size(), maximum_cells_strained);
  experiment.trials.resize(2);
  const auto model = model_of(experiment);
  // Ogden's law with the exponent 2 is the Neo-Hookean one, which mechanics has of its own.
  const Eigen::VectorXd found = model->predict({setting(palpation::strain_stiffening, "ogden", {2})}).value();
  ASSERT_GT(largest_difference(found, model->predict({}).value()), 0.2);

  const auto body = mechanics::prepare_body(experiment.mesh, experiment.cell_young_kPa, experiment.supports, {},
                                            mechanics::Holding::required)
                        .value();
  std::vector<mechanics::Material> materials;
  for (const auto& lame : body.materials) materials.emplace_back(mechanics::neo_hookean_from(lame));
  Eigen::Index row = 0;
  for (const PalpationTrial& trial : experiment.trials) {
    const mechanics::ToolLoad tool{trial.tool.center_mm, trial.tool.radius_mm, 2500 * trial.tool.direction};
    const auto result = mechanics::find_equilibrium(body, materials, mechanics::Loads{tool}).value();
    ASSERT_TRUE(result.may_be_used());
    std::vector<Eigen::Vector3d> places;
    for (const Marker& marker : trial.samples.back().markers) places.push_back(marker.rest_mm);
    for (const auto& u : mechanics::displacement_at(body, result, mechanics::locate_points(body.mesh, places))) {
      EXPECT_LT((found.segment<3>(row) - u).norm(), 1e-4);  // of 4 mm; mechanics stops at 1e-6 of the load
      row += 3;
    }
  }
}

TEST(PalpationModel, UnderAHeldForceTheSpecimenCreepsByItsFunction) {
  Palpation experiment = pad({.bricks = {4, 4, 2}, .forces_N = {1.0}});
  const auto model = model_of(experiment);
  const Eigen::VectorXd elastic = model->predict({}).value();
  const Eigen::VectorXd creeping =
      model->predict({setting(palpation::viscoelastic_creep, "prony-1", {0.5, 4})}).value();
  // A ramp of 2 s, then 8 s held. The delayed load behind a ramp of slope m after t is m (t - T (1 - e^(-t/T))), and
  // from there it goes on towards the load.
  const double ramp = (2 - 4 * (1 - std::exp(-0.5))) / 2, held = 1 - (1 - ramp) * std::exp(-2);
  const Eigen::Index rows = 3 * 40;
  EXPECT_LT((creeping.head(rows) - (1 + 0.5 * ramp) * elastic.head(rows)).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((creeping.segment(rows, rows) - (1 + 0.5 * held) * elastic.segment(rows, rows)).cwiseAbs().maxCoeff(),
            1e-9);
}

TEST(PalpationStructure, ACapsuleHoldsTheEnergyOfItsStrains) {
  auto mesh = mechanics::test::box(2, 3, 2, {10, 20, 30});
  mechanics::test::name_points(mesh, "fixed", [](const Eigen::Vector3d& p) { return p.z() < 1e-9; });
  const auto specimen =
      specimen_body(mesh, mechanics::test::uniform(mesh, 20), {mechanics::test::fixed("fixed")}, 0.4, 1e-6).value();
  // u = (a x, b y, 0) strains the two faces across z by (a, b), those across x by b alone, those across y by a alone;
  // in plane stress their energy is h / (1 - nu2) (a2 + b2 + 2 nu a b) / 2 an area.
  const double a = 0.02, b = -0.01, nu = 0.4;
  Eigen::VectorXd u(specimen.elements.unknowns);
  for (int n = 0; n < specimen.body.layout.nodes(); ++n) {
    const Eigen::Vector3d& p = specimen.body.layout.positions_mm[std::size_t(n)];
    u.segment<3>(3 * n) = Eigen::Vector3d(a * p.x(), b * p.y(), 0);
  }
  const double energy = 0.5 * u.dot(stiffness_derivative(specimen, {}, StructureParameter::capsule, u));
  const double expected =
      0.5 / (1 - nu * nu) * (2 * 200 * (a * a + b * b + 2 * nu * a * b) + 2 * 600 * b * b + 2 * 300 * a * a);
  EXPECT_NEAR(energy, expected, 1e-9 * expected);

  // And the assembled matrix is the same one.
  Structure skin;
  skin.capsule_mN_per_mm = 70;
  const Eigen::SparseMatrix<double> added = stiffness(specimen, skin) - stiffness(specimen, {});
  EXPECT_NEAR(0.5 * u.dot(added.selfadjointView<Eigen::Lower>() * u), 70 * expected, 1e-6 * expected);
}

TEST(PalpationModel, TheDiscretisationErrorIsWhatAFinerMeshShows) {
  // Pressed on the whole top, which both meshes have: a sphere so large that it touches nothing else.
  Palpation experiment = pad({.bricks = {4, 4, 2}, .forces_N = {1.0}, .hold_on = false});
  experiment.trials.resize(1);
  experiment.trials[0].tool = {{30, 30, 1030}, 1001.2, Eigen::Vector3d(0.3, 0, -1).normalized()};
  const auto model = model_of(experiment);
  const Eigen::MatrixXd estimated = model->systematic_uncertainty().directions;
  ASSERT_EQ(estimated.cols(), 2);  // one tool: what the finer mesh changes, and the response's own shape

  Palpation finer = experiment;
  const auto body = specimen_body(experiment.mesh, experiment.cell_young_kPa, experiment.supports, 0.45, 1e-6).value();
  finer.mesh = refined(body.body);
  mechanics::test::name_points(finer.mesh, "fixed", [](const Eigen::Vector3d& p) { return p.z() < 1e-9; });
  finer.cell_young_kPa.assign(finer.mesh.cells.size(), 17.5);
  const Eigen::VectorXd change =
      solved_one_by_one(finer, finer.cell_young_kPa, finer.supports, {}) - model->predict({}).value();
  // A dozen rough steps show the change to a tenth of its size.
  EXPECT_LT((estimated.col(0) / 1.6 - change).norm(), 0.1 * change.norm());
}

TEST(PalpationModel, FurtherTrialsArePredictedAsTheExperimentsOwnWouldBe) {
  Palpation experiment = pad({.bricks = {4, 4, 2}, .forces_N = {1.0}, .hold_on = false});
  experiment.trials.erase(experiment.trials.begin(), experiment.trials.begin() + 2);
  experiment.trials[0].samples.back().force_mN = 1500;
  const auto model = model_of(experiment);
  const std::vector<FurtherTrial> trials = model->further_trials();
  ASSERT_EQ(trials.size(), 13u);
  std::vector<std::string> further;
  for (const FurtherTrial& trial : trials) further.push_back(trial.sentence.message());
  EXPECT_NEAR(trials[1].conditions->at("samples").at(1).at("force_N").get<double>(), 3, 1e-9);
  EXPECT_THAT(further[0], HasSubstr("Press at ("));
  EXPECT_THAT(further[1], HasSubstr("trial p03, but with 3 N"));
  EXPECT_THAT(further[2], HasSubstr("hold the force for"));
  EXPECT_THAT(further[3], HasSubstr("Pull where trial p03 presses"));
  // Places lie apart from each other and from what was pressed; the force is tilted by 30 degrees at most.
  std::set<std::array<double, 3>> places;
  const double width_mm = experiment.trials[0].tool.radius_mm;
  const auto& along = experiment.trials[0].tool.direction;
  for (const FurtherTrial& trial : trials) {
    const auto vector = [&](const char* name) {
      return trial.conditions->at("tool").at(name).get<std::array<double, 3>>();
    };
    const auto direction = vector("direction");
    EXPECT_GT(Eigen::Vector3d(direction.data()).dot(along), std::cos(0.53)) << trial.sentence.message();
    places.insert(vector("center_mm"));
  }
  EXPECT_GE(places.size(), 2u);
  for (auto one = places.begin(); one != places.end(); ++one)
    for (auto other = std::next(one); other != places.end(); ++other)
      EXPECT_GT((Eigen::Vector3d(one->data()) - Eigen::Vector3d(other->data())).norm(), width_mm);

  const Eigen::Index rows = 3 * 40;
  const Eigen::VectorXd own = model->predict({}).value().segment(0, rows) / experiment.noise_mm;
  const auto predicted = [&](std::size_t trial, const Settings& settings) {
    Eigen::Index first = 0;
    for (std::size_t t = 0; t < trial; ++t) first += trials[t].rows;
    return Eigen::VectorXd(model->predict_further(settings).value().segment(first, trials[trial].rows));
  };
  EXPECT_LT((predicted(1, {}) - 2 * own).norm(), 1e-6 * own.norm());
  EXPECT_LT((predicted(2, {}) - own).norm(), 1e-6 * own.norm());  // the declared model does not creep
  EXPECT_LT((predicted(3, {}) + own).norm(), 1e-6 * own.norm());
  EXPECT_GT((predicted(0, {}) - own).norm(), 0.3 * own.norm());
  // A soft specimen and a load cell that reads too little are one under any force that is held at once; one that creeps
  // parts from both while it is held.
  const Settings soft{setting(palpation::stiffness_scale, "", {0.8})};
  const Settings creeping{setting(palpation::viscoelastic_creep, "prony-1", {0.5, 4})};
  EXPECT_LT((predicted(2, soft) - 1.25 * own).norm(), 1e-6 * own.norm());
  EXPECT_NEAR(predicted(2, creeping).norm() / own.norm(), 1.5, 0.1);
}

TEST(PalpationModel, SaysWhichTrialsToolTouchesNothing) {
  Palpation experiment = pad({.bricks = {2, 2, 1}});
  experiment.trials[2].tool.center_mm.z() += 100;
  const auto model = palpation_model(experiment);
  ASSERT_FALSE(model);
  EXPECT_EQ(model.error().code, "tool-touches-nothing");
  EXPECT_THAT(model.error().message(), HasSubstr("Trial p03"));
}

TEST(PalpationModel, RefusesABodyThatIsNotHeldAndOneWithoutMarkers) {
  Palpation loose = pad({.bricks = {2, 2, 1}});
  loose.supports.clear();
  EXPECT_EQ(palpation_model(loose).error().code, "body-free");
  Palpation blind = pad({.bricks = {2, 2, 1}});
  for (PalpationTrial& trial : blind.trials) {
    for (PalpationSample& sample : trial.samples) sample.markers.clear();
  }
  EXPECT_EQ(palpation_model(blind).error().code, "no-measurement");
}

}  // namespace
}  // namespace glisson::closedloop

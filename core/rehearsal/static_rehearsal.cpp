#include "rehearsal/static_rehearsal.h"

#include <algorithm>
#include <atomic>
#include <future>
#include <mutex>

#include "base/stopwatch.h"
#include "base/units.h"
#include "mechanics/meshfree/meshfree_model.h"
#include "mechanics/statics/displacements.h"
#include "mechanics/statics/live_strain.h"

namespace glisson::rehearsal {
namespace {

using Eigen::Vector3d;
using mechanics::PointInMesh;
using mechanics::StaticModel;
using mechanics::StaticResult;

// Displacements are linear in the tool's force: u = standing + per_N * force_N, 12 numbers a point.
struct Response {
  Vector3d standing_mm;
  Eigen::Matrix3d per_N_mm;

  [[nodiscard]] Vector3d at(const Vector3d& force_N) const { return standing_mm + per_N_mm * force_N; }
};
using Responses = std::vector<Response>;

// The responses of everything that one body shows.
struct BodyResponse {
  Responses points;  // every point of the mesh
  Responses surface;
  std::vector<Responses> structures;
  Responses landmarks;
  std::optional<mechanics::LiveStrain> strain;  // of the patient
  double relative_residual = 0;
};

Responses responses_from(const Eigen::MatrixXd& standing_mm, const Eigen::MatrixXd& per_N_mm);
std::vector<Vector3d> displaced(const std::vector<Vector3d>& rest_mm, const Responses& responses,
                                const Vector3d& force_N);
Result<void> usable(const StaticResult& result);
bool is_ligament(const mechanics::Support& support) { return std::holds_alternative<mechanics::Ligament>(support.how); }
Result<StaticModel> meshfree_model(const RehearsalSetup& setup, const Progress& progress);

}  // namespace

struct StaticRehearsal::Impl {
  geometry::Surface surface;
  std::vector<std::size_t> mesh_point;  // of each point of the surface
  std::vector<geometry::Surface> structures;
  std::vector<std::vector<PointInMesh>> structure_places;
  std::vector<mechanics::Landmark> landmarks;
  std::vector<PointInMesh> landmark_places;

  struct Body {
    StaticModel model;
    Eigen::VectorXd standing_mm;  // of all nodes, under the standing loads
    double relative_residual = 0;
    std::optional<mechanics::LiveStrain> strain;  // of the patient, which alone is asked for it
  };
  std::shared_ptr<const RehearsalModels> models;
  mechanics::Loads standing_loads;
  std::optional<Body> patient;
  double setup_s = 0;

  // Made by the first who needs it, never changed then.
  mutable std::mutex making;
  mutable std::optional<Body> reference;
  mutable std::atomic<bool> reference_is_made = false;

  [[nodiscard]] Result<Body> standing(const StaticModel& model) const;
  [[nodiscard]] Result<void> make_reference(const Progress& progress) const;
  [[nodiscard]] Result<BodyResponse> response_to_tool(const Body& body, const Vector3d& center_mm,
                                                      double radius_mm) const;
  [[nodiscard]] RehearsalBody body_under(const BodyResponse& response, const Vector3d& force_N) const;
};

struct PlacedTool::Impl {
  std::shared_ptr<const StaticRehearsal::Impl> rehearsal;
  Vector3d center_mm;
  double radius_mm = 0;
  std::size_t touched_faces = 0;
  double solve_ms = 0;
  BodyResponse patient;
  std::optional<BodyResponse> reference;
};

mechanics::ChosenLaw law_of_patient(const RehearsalSetup& setup) {
  using mechanics::MaterialLaw;
  const bool stiffens = setup.patient_stiffening && setup.law.law == MaterialLaw::neo_hookean;
  return stiffens ? mechanics::ChosenLaw(MaterialLaw::veronda_westmann, *setup.patient_stiffening) : setup.law;
}

RehearsalSetup with_law(RehearsalSetup setup, const mechanics::ChosenLaw& law) {
  const bool was_small = setup.law.law == mechanics::MaterialLaw::linear;
  const bool same_strain = was_small == (law.law == mechanics::MaterialLaw::linear);
  if (!same_strain && std::any_of(setup.supports.begin(), setup.supports.end(), is_ligament)) setup.models.reset();
  setup.law = law;
  return setup;
}

RehearsalSetup in_motion(RehearsalSetup setup, double step_s) {
  setup = with_law(std::move(setup), mechanics::MaterialLaw::linear);
  if (setup.meshfree) setup.models = std::move(setup.elements);
  setup.meshfree.reset();
  setup.motion.emplace().step_s = step_s;
  return setup;
}

RehearsalSetup by_meshfree(RehearsalSetup setup, const mechanics::MeshfreeOptions& options) {
  setup = with_law(std::move(setup), mechanics::MaterialLaw::linear);
  if (!setup.meshfree) setup.elements = std::move(setup.models);
  setup.models.reset();
  setup.meshfree = options;
  return setup;
}

Result<std::shared_ptr<const RehearsalModels>> rehearsal_models(const RehearsalSetup& setup, const Progress& progress) {
  if (setup.models) return setup.models;
  std::vector<mechanics::Support> supports = setup.supports;
  if (setup.law.law != mechanics::MaterialLaw::linear) std::erase_if(supports, is_ligament);
  auto patient = setup.meshfree
                     ? meshfree_model(setup, progress)
                     : StaticModel::create(setup.mesh, setup.patient_youngs_kPa, supports, setup.options, progress);
  if (!patient) return failure(std::move(patient.error()));
  RehearsalModels made{std::move(*patient)};
  if (setup.reference_youngs_kPa) made.reference.emplace(made.patient, *setup.reference_youngs_kPa);
  return std::make_shared<const RehearsalModels>(std::move(made));
}

namespace {

Result<StaticModel> meshfree_model(const RehearsalSetup& setup, const Progress& progress) {
  auto can_be = mechanics::check_meshfree_static(setup.law, setup.supports, setup.options);
  if (!can_be) return failure(std::move(can_be.error()));
  return mechanics::MeshfreeModel::create(setup.mesh, setup.patient_youngs_kPa, setup.supports,
                                          mechanics::MaterialLaw::linear, setup.options, *setup.meshfree, {}, progress)
      .and_then([](const mechanics::MeshfreeModel& model) { return model.static_model(); });
}

}  // namespace

struct ReferenceBody::Made {
  std::mutex making;
  std::optional<StaticModel> model;
};

ReferenceBody::ReferenceBody(StaticModel patient, double youngs_kPa)
    : patient_(std::move(patient)), youngs_kPa_(youngs_kPa), made_(std::make_shared<Made>()) {}

// In the patient's order of elimination: METIS draws from one stream of random numbers for all threads, and the bits of
// every answer would depend on what else was ordered meanwhile.
Result<StaticModel> ReferenceBody::model(const Progress& progress) const {
  const std::lock_guard lock(made_->making);
  if (!made_->model) {
    mechanics::StaticOptions options = patient_.options();
    options.anisotropy.reset();
    auto model =
        patient_.with_moduli(std::vector<double>(patient_.mesh().cells.size(), youngs_kPa_), options, progress);
    if (!model) return failure(std::move(model.error()));
    made_->model = std::move(*model);
  }
  return *made_->model;
}

Result<StaticRehearsal> StaticRehearsal::create(RehearsalSetup setup, const Progress& progress) {
  const Stopwatch watch;
  auto parts = std::make_shared<Impl>();
  auto models = rehearsal_models(setup, progress.part(0.0, 0.95));
  if (!models) return failure(std::move(models.error()));
  parts->models = *models;
  parts->standing_loads = setup.standing_loads;
  auto patient = parts->standing(parts->models->patient);
  if (!patient) return failure(std::move(patient.error()));
  parts->patient = std::move(*patient);
  parts->patient->strain.emplace(parts->patient->model, parts->patient->standing_mm);
  parts->reference_is_made = !parts->models->reference;

  progress.report(0.95, GLISSON_TEXT("Placing landmarks and structures"));
  auto places = mechanics::locate_landmarks(setup.mesh, setup.landmarks, setup.landmark_tolerance_mm);
  if (!places) return failure(std::move(places.error()));
  parts->landmark_places = std::move(*places);
  parts->landmarks = std::move(setup.landmarks);
  for (geometry::Surface& structure : setup.structures) {
    if (auto checked = geometry::check_surface(structure); !checked) return failure(std::move(checked.error()));
    parts->structure_places.push_back(mechanics::locate_points(setup.mesh, structure.points_mm));
    parts->structures.push_back(std::move(structure));
  }
  parts->surface = geometry::boundary_surface(setup.mesh);
  for (const double p : geometry::find_field(parts->surface.point_fields, "mesh_point")->values) {
    parts->mesh_point.push_back(static_cast<std::size_t>(p));
  }
  parts->setup_s = watch.seconds();
  progress.report(1.0, GLISSON_TEXT("Ready"));
  return StaticRehearsal(std::move(parts));
}

Result<StaticRehearsal::Impl::Body> StaticRehearsal::Impl::standing(const StaticModel& model) const {
  auto standing = model.solve(standing_loads);
  if (!standing) return failure(std::move(standing.error()));
  if (auto checked = usable(*standing); !checked) return failure(std::move(checked.error()));
  return Body{model, mechanics::nodal_displacements(model.nodes(), *standing), standing->relative_residual, {}};
}

Result<void> StaticRehearsal::Impl::make_reference(const Progress& progress) const {
  if (reference_is_made) return {};
  const std::lock_guard lock(making);
  if (reference) return {};
  const auto model = models->reference->model(progress);
  if (!model) return failure(model.error());
  auto body = standing(*model);
  if (!body) return failure(std::move(body.error()));
  reference = std::move(*body);
  reference_is_made = true;
  return {};
}

Result<PlacedTool> StaticRehearsal::place_tool(const Vector3d& center_mm, double radius_mm, On bodies) const {
  const Stopwatch watch;
  const auto touched = impl_->patient->model.faces_touched_by(center_mm, radius_mm);
  if (!touched) return failure(touched.error());

  auto placed = std::make_shared<PlacedTool::Impl>();
  placed->rehearsal = impl_;
  placed->center_mm = center_mm;
  placed->radius_mm = radius_mm;
  placed->touched_faces = *touched;
  // Side by side: a solve reads the whole factor, on one core.
  std::future<Result<BodyResponse>> beside;
  const bool compared = bodies == On::both && has_reference();
  if (compared) {
    beside = std::async(std::launch::async, [&]() -> Result<BodyResponse> {
      if (auto made = impl_->make_reference({}); !made) return failure(std::move(made.error()));
      return impl_->response_to_tool(*impl_->reference, center_mm, radius_mm);
    });
  }
  auto patient = impl_->response_to_tool(*impl_->patient, center_mm, radius_mm);
  if (compared) {
    auto reference = beside.get();
    if (!reference) return failure(std::move(reference.error()));
    placed->reference = std::move(*reference);
  }
  if (!patient) return failure(std::move(patient.error()));
  placed->patient = std::move(*patient);
  placed->solve_ms = 1e3 * watch.seconds();
  return PlacedTool(std::move(placed));
}

Result<BodyResponse> StaticRehearsal::Impl::response_to_tool(const Body& body, const Vector3d& center_mm,
                                                             double radius_mm) const {
  // A force of 1 N along each axis; any other is their sum.
  std::vector<mechanics::Loads> unit_loads;
  unit_loads.reserve(3);
  for (int axis = 0; axis < 3; ++axis) {
    unit_loads.push_back({mechanics::ToolLoad{center_mm, radius_mm, units::mN_from_N(1.0) * Vector3d::Unit(axis)}});
  }
  auto solved = body.model.respond_each(unit_loads);
  if (!solved) return failure(solved.error());
  if (auto usable = solved->usable(); !usable) return failure(std::move(usable.error()));

  BodyResponse response;
  response.relative_residual = std::max(body.relative_residual, solved->relative_residual);
  const mechanics::NodeLayout& layout = body.model.nodes();
  const Eigen::MatrixXd& per_N_mm = solved->displacement_mm;
  const auto responses_at = [&](const std::vector<PointInMesh>& places) {
    return responses_from(mechanics::displacements_at(layout, body.standing_mm, places),
                          mechanics::displacements_at(layout, per_N_mm, places));
  };
  for (const int node : layout.node_of_point) {
    if (node < 0) {
      response.points.push_back({Vector3d::Zero(), Eigen::Matrix3d::Zero()});
    } else {
      response.points.push_back({body.standing_mm.segment<3>(3 * node), per_N_mm.middleRows<3>(3 * node)});
    }
  }
  for (const std::size_t p : mesh_point) response.surface.push_back(response.points[p]);
  for (const auto& places : structure_places) response.structures.push_back(responses_at(places));
  response.landmarks = responses_at(landmark_places);
  if (body.strain) response.strain = body.strain->with_force(std::move(solved->displacement_mm));
  return response;
}

RehearsalBody StaticRehearsal::Impl::body_under(const BodyResponse& response, const Vector3d& force_N) const {
  RehearsalBody body;
  body.surface_mm = displaced(surface.points_mm, response.surface, force_N);
  for (std::size_t p = 0; p < body.surface_mm.size(); ++p) {
    body.max_displacement_mm =
        std::max(body.max_displacement_mm, (body.surface_mm[p] - surface.points_mm[p]).squaredNorm());
  }
  body.max_displacement_mm = std::sqrt(body.max_displacement_mm);
  for (std::size_t s = 0; s < structures.size(); ++s) {
    body.structures_mm.push_back(displaced(structures[s].points_mm, response.structures[s], force_N));
  }
  std::vector<Vector3d> displacements;
  for (const Response& landmark : response.landmarks) displacements.push_back(landmark.at(force_N));
  body.landmarks = mechanics::displaced_landmarks(landmarks, landmark_places, displacements);
  return body;
}

RehearsalState PlacedTool::answer(const Vector3d& force_N) const {
  GLISSON_ASSERT(force_N.allFinite());
  const Stopwatch watch;
  RehearsalState state;
  state.force_N = force_N;
  state.patient = impl_->rehearsal->body_under(impl_->patient, force_N);
  state.relative_residual = impl_->patient.relative_residual;
  const mechanics::StrainRange strain = impl_->patient.strain->under(force_N);
  state.validity = {true, strain.largest_strain, strain.inverted_cells};
  if (impl_->reference) {
    state.reference = impl_->rehearsal->body_under(*impl_->reference, force_N);
    state.relative_residual = std::max(state.relative_residual, impl_->reference->relative_residual);
    state.differences = differences_between(state.patient.landmarks, state.reference->landmarks);
    double squared_mm2 = 0;
    for (std::size_t p = 0; p < state.patient.surface_mm.size(); ++p) {
      squared_mm2 = std::max(squared_mm2, (state.patient.surface_mm[p] - state.reference->surface_mm[p]).squaredNorm());
    }
    state.max_difference_mm = std::sqrt(squared_mm2);
  }
  state.answer_ms = 1e3 * watch.seconds();
  return state;
}

// Strain is convex along a line of forces, so that what lies within begins at 0 and ends once.
double PlacedTool::force_within_the_model_N(const Vector3d& direction, double maximum_N) const {
  const auto within = [&](double force_N) {
    return impl_->patient.strain->largest(force_N * direction) <= mechanics::small_strain_limit;
  };
  if (within(maximum_N)) return maximum_N;
  double inside_N = 0, outside_N = maximum_N;
  while (outside_N - inside_N > 0.001 * maximum_N) {
    const double middle_N = 0.5 * (inside_N + outside_N);
    (within(middle_N) ? inside_N : outside_N) = middle_N;
  }
  return inside_N;
}

std::vector<Vector3d> PlacedTool::patient_displacement_mm(const Vector3d& force_N) const {
  GLISSON_ASSERT(force_N.allFinite());
  std::vector<Vector3d> displacements;
  displacements.reserve(impl_->patient.points.size());
  for (const Response& point : impl_->patient.points) displacements.push_back(point.at(force_N));
  return displacements;
}

const Vector3d& PlacedTool::center_mm() const { return impl_->center_mm; }
double PlacedTool::radius_mm() const { return impl_->radius_mm; }
std::size_t PlacedTool::touched_faces() const { return impl_->touched_faces; }
double PlacedTool::solve_ms() const { return impl_->solve_ms; }
bool PlacedTool::compared() const { return impl_->reference.has_value(); }

const geometry::Surface& StaticRehearsal::surface() const { return impl_->surface; }
const std::shared_ptr<const RehearsalModels>& StaticRehearsal::models() const { return impl_->models; }
const StaticModel& StaticRehearsal::patient() const { return impl_->patient->model; }
bool StaticRehearsal::has_reference() const { return impl_->models->reference.has_value(); }
bool StaticRehearsal::reference_is_made() const { return impl_->reference_is_made; }
Result<void> StaticRehearsal::make_reference(const Progress& progress) const { return impl_->make_reference(progress); }
double StaticRehearsal::setup_s() const { return impl_->setup_s; }

namespace {

// Three rows a place.
Responses responses_from(const Eigen::MatrixXd& standing_mm, const Eigen::MatrixXd& per_N_mm) {
  Responses responses;
  for (Eigen::Index row = 0; row < standing_mm.rows(); row += 3) {
    responses.push_back({standing_mm.col(0).segment<3>(row), per_N_mm.middleRows<3>(row)});
  }
  return responses;
}

std::vector<Vector3d> displaced(const std::vector<Vector3d>& rest_mm, const Responses& responses,
                                const Vector3d& force_N) {
  std::vector<Vector3d> positions(rest_mm.size());
  for (std::size_t i = 0; i < positions.size(); ++i) positions[i] = rest_mm[i] + responses[i].at(force_N);
  return positions;
}

Result<void> usable(const StaticResult& result) {
  if (result.converged()) return {};
  return failure("not-converged", GLISSON_TEXT("The equilibrium was not found. {0}"), {result.why_stopped});
}

}  // namespace
}  // namespace glisson::rehearsal

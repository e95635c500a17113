#include "mechanics/contact/contact.h"

#include <numeric>

#include "mechanics/contact/internal/contact_search.h"
#include "mechanics/cutting/opened_surface.h"
#include "mechanics/elements/load_vector.h"
#include "mechanics/statics/displacements.h"

namespace glisson::mechanics {

struct ContactBody::Impl {
  SurfaceResponses responses;
  Loads standing_loads;
  Eigen::VectorXd standing_force_mN;  // on all nodes
  CutSelfContact walls;
  ContactState untouched;

  Impl(StaticModel model, const StaticResult& standing, std::vector<PointInMesh> watched, std::size_t judged)
      : responses(std::move(model), standing, std::move(watched), judged) {}
};

Result<ContactBody> ContactBody::create(StaticModel model, const Loads& standing_loads,
                                        std::vector<PointInMesh> watched, std::size_t judged) {
  const auto standing = model.solve(standing_loads);
  if (!standing) return failure(standing.error());
  if (!standing->converged()) {
    return failure("not-converged", GLISSON_TEXT("The equilibrium was not found. {0}"), {standing->why_stopped});
  }
  const auto boundary = boundary_faces(model.mesh(), model.nodes());
  auto force_mN = load_vector(model.mesh(), model.nodes(), boundary, model.options().density_kg_mm3, standing_loads);
  if (!force_mN) return failure(std::move(force_mN.error()));

  auto parts = std::make_shared<Impl>(std::move(model), *standing, std::move(watched), judged);
  parts->standing_loads = standing_loads;
  parts->standing_force_mN = std::move(*force_mN);
  const SurfaceResponses& responses = parts->responses;
  if (!responses.mutual_points().empty()) {
    std::vector<int> itself(responses.surface().points_mm.size());
    std::iota(itself.begin(), itself.end(), 0);
    parts->walls = CutSelfContact(responses.surface(), itself, responses.mutual_points());
  }
  const std::vector<ContactTool> no_tools;
  ContactSearch search(responses, parts->walls, no_tools, {});
  auto untouched = search.begin_from_rest().and_then([&] { return search.run(); });
  if (!untouched) return failure(std::move(untouched.error()));
  parts->untouched = std::move(*untouched);
  return ContactBody(std::move(parts));
}

Result<ContactState> ContactBody::solve(const ContactState& from, const std::vector<ContactTool>& tools,
                                        const ContactOptions& options) const {
  ContactSearch search(impl_->responses, impl_->walls, tools, options);
  return search.begin_from(from).and_then([&] { return search.run(); });
}

Result<ContactState> ContactBody::solve(const ContactState& from, const std::vector<ContactTool>& tools,
                                        const StepInTime& step, const ContactOptions& options) const {
  GLISSON_ASSERT(opening() == nullptr);
  const SurfaceResponses responses = impl_->responses.within_step(step.rest_mm, step.taken_mm);
  ContactSearch search(responses, impl_->walls, tools, options);
  return search.begin_from(from).and_then([&] { return search.run(); });
}

void ContactBody::show(const Eigen::VectorXd& u_mm, ContactState& state) const {
  const SurfaceResponses& responses = impl_->responses;
  const SurfaceResponses::Seen seen = responses.seen_of(u_mm);
  state.surface_mm = responses.surface_mm(seen);
  state.watched_mm = responses.watched_mm(seen);
  const StrainRange strains = responses.strain_range(responses.mesh_points_mm(seen), {});
  state.report.largest_strain = strains.largest_strain;
  state.report.inverted_cells = strains.inverted_cells;
}

Result<ContactBody> ContactBody::opened(const CutStrip& strip) const {
  auto responses = impl_->responses.opened(strip, impl_->standing_loads);
  if (!responses) return failure(std::move(responses.error()));
  auto parts = std::make_shared<Impl>(*impl_);
  parts->responses = std::move(*responses);
  const std::vector<ContactTool> no_tools;
  ContactSearch search(parts->responses, parts->walls, no_tools, {});
  auto untouched = search.begin_from(impl_->untouched).and_then([&] { return search.run(); });
  if (!untouched) return failure(std::move(untouched.error()));
  parts->untouched = std::move(*untouched);
  return ContactBody(std::move(parts));
}

Result<geometry::Surface> ContactBody::opened_surface(const ContactState& state) const {
  const SurfaceResponses& responses = impl_->responses;
  return responses.all_under(state.force_mN, state.wall_mN).map([&](const SurfaceResponses::Seen& seen) {
    return mechanics::opened_surface(model().mesh(), surface(), responses.open_cells(), responses.mesh_points_mm(seen),
                                     state.jumps_mm);
  });
}

Result<bool> ContactBody::prepare(const CutStrip& ahead) const {
  return opening() == nullptr ? Result<bool>(false) : opening()->prepare(ahead);
}

Result<bool> ContactBody::prepare_touch(const ContactState& state, const std::vector<ContactTool>& tools) const {
  std::vector<Eigen::Vector3d> places_mm;
  for (std::size_t t = 0; t < tools.size(); ++t) {
    if (const auto* grasp = std::get_if<Grasp>(&tools[t].what)) places_mm.push_back(grasp->at_rest_mm);
    const auto* touching = std::get_if<TouchingTool>(&tools[t].what);
    if (touching == nullptr) continue;
    const double advance_mm = t < state.tools.size() ? state.tools[t].advance_mm : 0.0;
    places_mm.push_back(touching->pose.advanced(advance_mm).position_mm);
  }
  return impl_->responses.remember_ahead(state.force_mN, places_mm);
}

const Opening* ContactBody::opening() const { return impl_->responses.opening(); }

ContactState ContactBody::without_shape(ContactState state) {
  state.surface_mm = {};
  state.watched_mm = {};
  return state;
}

Result<ContactState> ContactBody::with_shape(ContactState state) const {
  return mechanics::show(impl_->responses, state).map([&](const StrainRange&) { return std::move(state); });
}

Result<StaticResult> ContactBody::whole_result(const ContactState& state) const {
  Eigen::VectorXd force_mN = impl_->standing_force_mN;
  for (const auto& [point, force] : state.force_mN) force_mN.segment<3>(3 * impl_->responses.node(point)) += force;
  const Opening* cut = opening();
  if (cut == nullptr) return model().solve_nodal({std::move(force_mN), {}});
  const Eigen::VectorXd amplitudes_mm = impl_->responses.amplitudes_under(state.force_mN, state.wall_mN);
  force_mN += cut->force_on_nodes_mN(amplitudes_mm);
  return model().solve_nodal({std::move(force_mN), {}}).map([&](StaticResult result) {
    const Eigen::VectorXd u_mm = nodal_displacements(model().nodes(), result) + cut->of_nodes_mm(amplitudes_mm);
    set_displacements(model().body(), u_mm, result);
    return result;
  });
}

const ContactState& ContactBody::untouched() const { return impl_->untouched; }
const geometry::Surface& ContactBody::surface() const { return impl_->responses.surface(); }
const StaticModel& ContactBody::model() const { return impl_->responses.model(); }

}  // namespace glisson::mechanics

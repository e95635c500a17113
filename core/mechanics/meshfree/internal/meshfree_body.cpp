#include "mechanics/meshfree/internal/meshfree_body.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "base/stopwatch.h"
#include "geometry/nearest.h"
#include "mechanics/potentials/stiffness_matrix.h"
#include "mechanics/potentials/total_potential.h"

namespace glisson::mechanics {
namespace {

// Gives the points that are fixed in all directions a node of their own in each part of the body. Its weight is 1 at
// them and falls to nothing within half the distance of two nodes, the others making room.
void add_fixed_nodes(const Body& body, ShapeFunctions& shape);

// For each fixed direction of a place, a spring penalty_factor times the stiffness that the body has for that place
// alone.
std::vector<double> penalty_springs(const Body& body, const Eigen::SparseMatrix<double>& stiffness);
void add_springs(const std::vector<double>& springs, Eigen::SparseMatrix<double>& lower);

}  // namespace

Result<MeshfreeBody> prepare_meshfree_body(const geometry::TetMesh& mesh, const std::vector<double>& youngs_kPa,
                                           const std::vector<Support>& supports, const ChosenLaw& chosen,
                                           StaticOptions options, const MeshfreeOptions& meshfree,
                                           const std::vector<Cut>& cuts, Holding holding, const Progress& progress) {
  const Stopwatch watch;
  options.order = ElementOrder::quadratic;
  auto body = prepare_body(mesh, youngs_kPa, supports, options, holding);
  if (!body) return failure(std::move(body.error()));

  auto shape = shape_functions_of(body->mesh, body->youngs_kPa, meshfree, cuts, progress.part(0.0, 0.5));
  if (!shape) return failure(std::move(shape.error()));
  add_fixed_nodes(*body, *shape);
  if (meshfree.stiffness == MeshfreeOptions::Stiffness::of_nodes) {
    body->youngs_kPa = youngs_of_nodes_kPa(body->mesh, *shape);
    for (std::size_t c = 0; c < body->youngs_kPa.size(); ++c) {
      body->materials[c] = lame_from_youngs(body->youngs_kPa[c], options.poisson_ratio);
    }
  }
  if (progress.cancelled()) return cancelled();
  progress.report(0.6, GLISSON_TEXT("Assembling the stiffness"));
  Eigen::SparseMatrix<double> stiffness = assemble_stiffness(*body);
  std::vector<double> penalty_mN_mm = penalty_springs(*body, stiffness);
  add_springs(penalty_mN_mm, stiffness);
  const auto basis = std::make_shared<const AffineBasis>(body->mesh, body->layout, *shape);
  Lists meeting = handles_that_meet(*basis);
  const ReducedOperator::Form form = ReducedOperator::form_for(meeting, options.memory_limit_bytes);
  ReducedOperator rest(form, basis, stiffness, meeting);
  std::vector<Material> materials = materials_of(*body, chosen.law, chosen.strain_stiffening);
  progress.report(1.0, GLISSON_TEXT("Assembled"));
  return MeshfreeBody{
      std::move(*body),   chosen.law, std::move(*shape), basis,          std::move(materials), std::move(penalty_mN_mm),
      std::move(meeting), form,       std::move(rest),   watch.seconds()};
}

Eigen::VectorXd MeshfreeBody::penalty_force_mN(const Eigen::VectorXd& u_mm) const {
  return -Eigen::Map<const Eigen::VectorXd>(penalty_mN_mm.data(), static_cast<Eigen::Index>(penalty_mN_mm.size()))
              .cwiseProduct(u_mm);
}

ReducedOperator MeshfreeBody::tangent(const Eigen::VectorXd& u_mm, Tangent which, double pressure_kPa) const {
  const TotalPotential potential(body, elastic_potentials(body, materials, pressure_kPa));
  Eigen::SparseMatrix<double> lower = potential.tangent(u_mm, which);
  add_springs(penalty_mN_mm, lower);
  return over_handles(lower);
}

ReducedMatrix MeshfreeBody::assembled(Eigen::SparseMatrix<double> lower) const {
  add_springs(penalty_mN_mm, lower);
  return reduced(both_triangles(lower), *basis, handles_meeting);
}

ReducedOperator MeshfreeBody::over_handles(const Eigen::SparseMatrix<double>& lower) const {
  return {form, basis, lower, handles_meeting};
}

namespace {

void add_fixed_nodes(const Body& body, ShapeFunctions& shape) {
  const std::size_t points = body.mesh.points_mm.size();
  const std::vector<int> part_of_cell = geometry::parts_by_faces(body.mesh);
  std::vector<int> part_of_point(points, 0);
  for (std::size_t c = 0; c < part_of_cell.size(); ++c) {
    for (const int p : body.mesh.cells[c]) part_of_point[p] = part_of_cell[c];
  }
  std::map<int, std::vector<Eigen::Vector3d>> fixed_mm;  // by part
  for (std::size_t p = 0; p < points; ++p) {
    const int node = body.layout.node_of_point[p];
    if (node < 0) continue;
    const auto first = body.resolved.fixed.begin() + 3 * static_cast<std::ptrdiff_t>(node);
    if (std::all_of(first, first + 3, [](std::uint8_t fixed) { return fixed != 0; })) {
      fixed_mm[part_of_point[p]].push_back(body.mesh.points_mm[p]);
    }
  }
  if (fixed_mm.empty()) return;

  const geometry::NearestPoint others(shape.nodes_mm);
  const double mean_volume_mm3 = geometry::volume_mm3(body.mesh) / static_cast<double>(shape.nodes_mm.size());
  const double fade_mm = 0.5 * std::cbrt(mean_volume_mm3);
  std::map<int, std::pair<int, geometry::NearestPoint>> fixed_nodes;  // by part, with their points
  for (auto& [part, places_mm] : fixed_mm) {
    const Eigen::Vector3d middle_mm =
        std::accumulate(places_mm.begin(), places_mm.end(), Eigen::Vector3d(0, 0, 0)) / double(places_mm.size());
    const auto nearest = static_cast<std::size_t>(others.nearest(middle_mm).point);
    fixed_nodes.try_emplace(part, static_cast<int>(shape.nodes_mm.size()),
                            geometry::NearestPoint(std::move(places_mm)));
    shape.nodes_mm.push_back(middle_mm);
    shape.node_volumes_mm3.push_back(mean_volume_mm3);
    shape.node_youngs_kPa.push_back(shape.node_youngs_kPa[nearest]);
    ++shape.fixed_nodes;
  }
  std::vector<std::size_t> starts{0};
  std::vector<int> nodes;
  std::vector<double> weights;
  for (std::size_t p = 0; p < points; ++p) {
    const auto fixed = fixed_nodes.find(part_of_point[p]);
    double left = 1.0;  // for the others
    if (fixed != fixed_nodes.end()) {
      const double away_mm = std::sqrt(fixed->second.second.nearest(body.mesh.points_mm[p]).squared_distance_mm2);
      left = std::min(1.0, away_mm / fade_mm);
    }
    for (std::size_t k = shape.starts[p]; k < shape.starts[p + 1] && left > 0; ++k) {
      nodes.push_back(shape.nodes[k]);
      weights.push_back(left * shape.weights[k]);
    }
    if (left < 1) {
      nodes.push_back(fixed->second.first);
      weights.push_back(1.0 - left);
    }
    starts.push_back(nodes.size());
  }
  shape.starts = std::move(starts);
  shape.nodes = std::move(nodes);
  shape.weights = std::move(weights);
}

std::vector<double> penalty_springs(const Body& body, const Eigen::SparseMatrix<double>& stiffness) {
  std::vector<double> springs(body.resolved.fixed.size(), 0.0);
  for (std::size_t place = 0; place < springs.size() / 3; ++place) {
    const auto first = static_cast<Eigen::Index>(3 * place);
    double own = 0;
    for (int d = 0; d < 3; ++d) own += stiffness.coeff(first + d, first + d) / 3.0;
    for (std::size_t d = 0; d < 3; ++d) {
      if (body.resolved.fixed[3 * place + d]) springs[3 * place + d] = MeshfreeBody::penalty_factor * own;
    }
  }
  return springs;
}

void add_springs(const std::vector<double>& springs, Eigen::SparseMatrix<double>& lower) {
  for (std::size_t i = 0; i < springs.size(); ++i) {  // the diagonal is the first of its column
    lower.valuePtr()[lower.outerIndexPtr()[i]] += springs[i];
  }
}

}  // namespace
}  // namespace glisson::mechanics

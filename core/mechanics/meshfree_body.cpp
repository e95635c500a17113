#include "mechanics/meshfree_body.h"

#include "mechanics/stiffness_matrix.h"
#include "mechanics/stopwatch.h"

namespace glisson::mechanics {
namespace {

// For each held direction of a place, a spring hold_factor times the stiffness that the body has for that place alone.
std::vector<double> springs_of_held(const Body& body, const Eigen::SparseMatrix<double>& stiffness);

}  // namespace

Result<MeshfreeBody> prepare_meshfree_body(const geometry::TetMesh& mesh, const std::vector<double>& youngs_kPa,
                                           const std::vector<Support>& supports, const ChosenLaw& chosen,
                                           StaticOptions options, const MeshfreeOptions& meshfree,
                                           const std::vector<Cut>& cuts, Holding holding,
                                           const Progress& progress) {
  const Stopwatch watch;
  options.order = ElementOrder::quadratic;
  auto body = prepare_body(mesh, youngs_kPa, supports, options, holding);
  if (!body) return failure(std::move(body.error()));

  auto shape = shape_functions_of(body->mesh, body->youngs_kPa, meshfree, cuts, progress.part(0.0, 0.5));
  if (!shape) return failure(std::move(shape.error()));
  if (meshfree.stiffness == MeshfreeOptions::Stiffness::of_nodes) {
    body->youngs_kPa = youngs_of_nodes_kPa(body->mesh, *shape);
    for (std::size_t c = 0; c < body->youngs_kPa.size(); ++c) {
      body->materials[c] = lame_from_youngs(body->youngs_kPa[c], options.poisson_ratio);
    }
  }
  if (progress.cancelled()) return cancelled();
  progress.report(0.6, "Assembling the stiffness");
  const Eigen::SparseMatrix<double> stiffness = assemble_stiffness(*body);
  FrameBasis basis(body->mesh, body->layout, *shape);
  std::vector<double> hold = springs_of_held(*body, stiffness);
  FrameMatrix rest = reduced(stiffness, basis);
  add_springs(hold, basis, rest);
  std::vector<Material> materials = materials_of(*body, chosen.law, chosen.strain_stiffening);
  progress.report(1.0, "Assembled");
  return MeshfreeBody{std::move(*body),     chosen.law,      std::move(*shape), std::move(basis),
                      std::move(materials), std::move(hold), std::move(rest),   watch.seconds()};
}

Eigen::VectorXd MeshfreeBody::holding_force_mN(const Eigen::VectorXd& u_mm) const {
  return -Eigen::Map<const Eigen::VectorXd>(hold.data(), static_cast<Eigen::Index>(hold.size())).cwiseProduct(u_mm);
}

FrameMatrix MeshfreeBody::tangent(const Eigen::VectorXd& u_mm, Tangent which, double pressure_kPa) const {
  FrameMatrix matrix = reduced(tangent_stiffness(body, materials, u_mm, which, pressure_kPa), basis);
  add_springs(hold, basis, matrix);
  return matrix;
}

namespace {

std::vector<double> springs_of_held(const Body& body, const Eigen::SparseMatrix<double>& stiffness) {
  std::vector<double> springs(body.resolved.held.size(), 0.0);
  for (std::size_t place = 0; place < springs.size() / 3; ++place) {
    const auto first = static_cast<Eigen::Index>(3 * place);
    double own = 0;
    for (int d = 0; d < 3; ++d) own += stiffness.coeff(first + d, first + d) / 3.0;
    for (std::size_t d = 0; d < 3; ++d) {
      if (body.resolved.held[3 * place + d]) springs[3 * place + d] = MeshfreeBody::hold_factor * own;
    }
  }
  return springs;
}

}  // namespace
}  // namespace glisson::mechanics

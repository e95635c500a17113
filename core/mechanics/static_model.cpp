#include "mechanics/static_model.h"

#include <fmt/format.h>
#include <chrono>
#include <cmath>
#include <limits>

#include "mechanics/boundary.h"
#include "mechanics/constrained_system.h"
#include "mechanics/linear_elasticity.h"
#include "mechanics/load_vector.h"
#include "mechanics/shape_functions.h"
#include "mechanics/stiffness_matrix.h"
#include "mechanics/strain.h"
#include "mechanics/supports.h"

namespace glisson::mechanics {
namespace {

class Stopwatch {
 public:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

Result<void> check_size(const geometry::TetMesh& mesh);
Result<void> check_material(const std::vector<double>& youngs_kPa, std::size_t cells, const StaticOptions& options);
std::vector<Eigen::Vector3d> vectors_of(const Eigen::VectorXd& values, int first_node, int nodes);
Eigen::Vector3d sum_of(const Eigen::VectorXd& values);

}  // namespace

// Everything that only the loads do not change.
struct StaticModel::Parts {
  geometry::TetMesh mesh;
  std::vector<double> youngs_kPa;
  std::vector<Support> supports;
  StaticOptions options;
  NodeLayout layout;
  std::vector<BoundaryFace> boundary;
  ResolvedSupports resolved;
  std::vector<Lame> materials;  // one a cell
  std::optional<ConstrainedSystem> system;
  Cost cost;

  [[nodiscard]] std::vector<StaticResult> solve(const Eigen::MatrixXd& force_mN, const Eigen::MatrixXd& held_mm) const;
  [[nodiscard]] StaticResult result_of(const ConstrainedSolution& solution, const Eigen::VectorXd& force_mN) const;
  [[nodiscard]] Eigen::VectorXd foundation_force_mN(const Eigen::VectorXd& u_mm) const;
};

Result<StaticModel> StaticModel::create(geometry::TetMesh mesh, std::vector<double> youngs_kPa,
                                        std::vector<Support> supports, StaticOptions options,
                                        const Progress& progress) {
  const Stopwatch watch;
  progress.report(0.0, "Checking the model");
  if (auto checked = geometry::check_tetrahedra(mesh); !checked) return failure(std::move(checked.error()));
  if (auto checked = check_size(mesh); !checked) return failure(std::move(checked.error()));
  if (auto checked = check_material(youngs_kPa, mesh.cells.size(), options); !checked) {
    return failure(std::move(checked.error()));
  }

  auto parts = std::make_shared<Parts>();
  parts->mesh = std::move(mesh);
  parts->youngs_kPa = std::move(youngs_kPa);
  parts->supports = std::move(supports);
  parts->options = options;
  parts->layout = lay_out_nodes(parts->mesh, options.order);
  parts->boundary = boundary_faces(parts->mesh, parts->layout);
  auto resolved = resolve_supports(parts->mesh, parts->layout, parts->boundary, parts->supports);
  if (!resolved) return failure(std::move(resolved.error()));
  parts->resolved = std::move(*resolved);
  if (const std::string free = free_motion(parts->layout, parts->boundary, parts->resolved); !free.empty()) {
    return failure(Error{"body-free",
                         GLISSON_TEXT("The supports do not hold the body: it {0}, so no equilibrium exists."),
                         {free},
                         GLISSON_TEXT("Hold more of it, or put a foundation under part of its surface."),
                         {}});
  }
  parts->materials.reserve(parts->youngs_kPa.size());
  for (const double youngs : parts->youngs_kPa) {
    parts->materials.push_back(lame_from_youngs(youngs, options.poisson_ratio));
  }

  progress.report(0.05, "Assembling the stiffness");
  if (progress.cancelled()) return cancelled();
  auto system = ConstrainedSystem::create(
      assemble_stiffness(parts->mesh, parts->layout, parts->materials, parts->boundary, parts->resolved.foundations),
      parts->resolved.held, options.memory_limit_bytes, progress.part(0.1, 1.0));
  if (!system) return failure(std::move(system.error()));
  parts->system = std::move(*system);
  parts->cost = {watch.seconds(), parts->system->free_unknowns(), parts->system->matrix_bytes(),
                 parts->system->factor() ? parts->system->factor()->bytes() : 0};
  return StaticModel(std::move(parts));
}

Result<StaticResult> StaticModel::solve(const Loads& loads) const {
  return solve_each({loads}).map([](std::vector<StaticResult> results) { return std::move(results.front()); });
}

Result<std::vector<StaticResult>> StaticModel::solve_each(const std::vector<Loads>& cases) const {
  Eigen::MatrixXd force_mN(3 * static_cast<Eigen::Index>(parts_->layout.nodes()),
                           static_cast<Eigen::Index>(cases.size()));
  for (std::size_t i = 0; i < cases.size(); ++i) {
    auto column = load_vector(parts_->mesh, parts_->layout, parts_->boundary, parts_->options.density_kg_mm3, cases[i]);
    if (!column) return failure(std::move(column.error()));
    force_mN.col(static_cast<Eigen::Index>(i)) = *column;
  }
  return parts_->solve(force_mN, {});
}

Result<StaticResult> StaticModel::solve_nodal(const NodalLoad& load) const {
  const Eigen::Index unknowns = 3 * static_cast<Eigen::Index>(parts_->layout.nodes());
  const bool held_given = load.held_displacement_mm.size() > 0;
  if (load.force_mN.size() != unknowns || (held_given && load.held_displacement_mm.size() != unknowns)) {
    return failure("load-invalid", GLISSON_TEXT("Nodal loads need {0} values: three a node."),
                   {std::to_string(unknowns)});
  }
  if (!load.force_mN.allFinite() || (held_given && !load.held_displacement_mm.allFinite())) {
    return failure("load-invalid", GLISSON_TEXT("A nodal load is not a finite number."));
  }
  return std::move(parts_->solve(load.force_mN, load.held_displacement_mm).front());
}

std::vector<StaticResult> StaticModel::Parts::solve(const Eigen::MatrixXd& force_mN,
                                                    const Eigen::MatrixXd& held_mm) const {
  const Stopwatch watch;
  const auto solutions = system->solve(
      force_mN, held_mm, {.tolerance = options.relative_tolerance, .max_refinements = options.max_refinements});
  std::vector<StaticResult> results;
  results.reserve(solutions.size());
  for (std::size_t i = 0; i < solutions.size(); ++i) {
    results.push_back(result_of(solutions[i], force_mN.col(static_cast<Eigen::Index>(i))));
  }
  for (StaticResult& result : results) {
    result.step_ms = 1e3 * watch.seconds() / static_cast<double>(results.size());
  }
  return results;
}

StaticResult StaticModel::Parts::result_of(const ConstrainedSolution& solution, const Eigen::VectorXd& force_mN) const {
  StaticResult result;
  result.status = solution.converged ? SolveStatus::converged : SolveStatus::not_converged;
  result.why_stopped =
      solution.converged
          ? fmt::format("The relative residual {:.1e} is within the tolerance {:.1e}.", solution.relative_residual,
                        options.relative_tolerance)
          : fmt::format(
                "The relative residual stayed at {:.1e}, above the tolerance {:.1e}: the equations are too "
                "badly conditioned (Poisson's ratio too near 1/2, flat cells, or a body that is barely held).",
                solution.relative_residual, options.relative_tolerance);
  result.relative_residual = solution.relative_residual;
  result.iterations = solution.iterations;
  result.setup_s = cost.setup_s;

  const Eigen::VectorXd& u = solution.u;
  result.displacement_mm.assign(mesh.points_mm.size(), Eigen::Vector3d::Zero());
  for (std::size_t p = 0; p < mesh.points_mm.size(); ++p) {
    if (layout.node_of_point[p] >= 0) result.displacement_mm[p] = u.segment<3>(3 * layout.node_of_point[p]);
  }
  result.mid_side_displacement_mm = vectors_of(u, layout.corner_nodes, layout.nodes() - layout.corner_nodes);
  for (int node = 0; node < layout.nodes(); ++node) {
    result.max_displacement_mm = std::max(result.max_displacement_mm, u.segment<3>(3 * node).norm());
  }

  const Eigen::VectorXd spring_force_mN = foundation_force_mN(u);
  result.applied_force_mN = sum_of(force_mN);
  result.held_reaction_mN = sum_of(solution.reaction);
  result.foundation_reaction_mN = sum_of(spring_force_mN);
  result.foundation_energy_uJ = -0.5 * u.dot(spring_force_mN);
  result.external_work_uJ = 0.5 * u.dot(force_mN);
  // u.Ku/2 without another product with K: K u is the load, what the supports add, and the residual (negligible).
  result.strain_energy_uJ = 0.5 * u.dot(force_mN + solution.reaction) - result.foundation_energy_uJ;

  const StrainRange strains = strain_range(mesh, layout, u);
  result.largest_strain = strains.largest_strain;
  result.inverted_cells = strains.inverted_cells;
  if (strains.inverted_cells > 0) {
    result.notes.push_back(
        fmt::format("{} cells are turned inside out: the load is far beyond what linear elasticity "
                    "can describe.",
                    strains.inverted_cells));
  } else if (strains.largest_strain > 0.2) {
    result.notes.push_back(
        fmt::format("The largest strain is {:.0f} %: linear elasticity at small strain is an "
                    "extrapolation there.",
                    100.0 * strains.largest_strain));
  }
  // 1e-16 of rounding over a condition beyond 1e14 leaves no correct digit, however small the residual.
  if (system->factor() && system->factor()->reciprocal_condition() < 1e-14) {
    result.notes.emplace_back("The body is barely held: small errors of its data change the displacements a lot.");
  }
  if (result.max_displacement_mm == 0 && force_mN.norm() > 0) {
    result.notes.emplace_back("Every load acts on what is held: nothing moves.");
  }
  return result;
}

Eigen::VectorXd StaticModel::Parts::foundation_force_mN(const Eigen::VectorXd& u_mm) const {
  Eigen::VectorXd force_mN = Eigen::VectorXd::Zero(u_mm.size());
  for (const FoundationFace& spring : resolved.foundations) {
    const BoundaryFace& face = boundary[spring.face];
    const FaceMass mass = face_mass_mm2(face, options.order);
    for (int a = 0; a < mass.rows(); ++a) {
      for (int b = 0; b < mass.cols(); ++b) {
        force_mN.segment<3>(3 * face.nodes[a]) -=
            spring.stiffness_kPa_per_mm * mass(a, b) * u_mm.segment<3>(3 * face.nodes[b]);
      }
    }
  }
  return force_mN;
}

const geometry::TetMesh& StaticModel::mesh() const { return parts_->mesh; }
const std::vector<double>& StaticModel::youngs_kPa() const { return parts_->youngs_kPa; }
const NodeLayout& StaticModel::nodes() const { return parts_->layout; }
const StaticOptions& StaticModel::options() const { return parts_->options; }
const std::vector<Support>& StaticModel::supports() const { return parts_->supports; }
StaticModel::Cost StaticModel::cost() const { return parts_->cost; }

Result<std::size_t> StaticModel::faces_touched_by(const Eigen::Vector3d& center_mm, double radius_mm) const {
  return faces_within(parts_->boundary, center_mm, radius_mm).map([](const auto& faces) { return faces.size(); });
}

std::vector<Eigen::Vector3d> StaticModel::displacement_at(const StaticResult& result,
                                                          const std::vector<PointInMesh>& places) const {
  GLISSON_ASSERT(result.displacement_mm.size() == parts_->mesh.points_mm.size());
  const NodeLayout& layout = parts_->layout;
  std::vector<Eigen::Vector3d> displacements(places.size(), Eigen::Vector3d::Zero());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto cell = static_cast<std::size_t>(places[i].cell);
    const TetValues values = tet_values(layout.order, places[i].barycentric);
    for (int k = 0; k < layout.nodes_per_cell(); ++k) {
      displacements[i] +=
          values[k] * (k < 4 ? result.displacement_mm[parts_->mesh.cells[cell][k]]
                             : result.mid_side_displacement_mm[layout.cells[cell][k] - layout.corner_nodes]);
    }
  }
  return displacements;
}

std::vector<double> StaticModel::von_mises_kPa(const StaticResult& result) const {
  const NodeLayout& layout = parts_->layout;
  Eigen::VectorXd u_mm(3 * static_cast<Eigen::Index>(layout.nodes()));
  for (std::size_t p = 0; p < result.displacement_mm.size(); ++p) {
    if (layout.node_of_point[p] >= 0) u_mm.segment<3>(3 * layout.node_of_point[p]) = result.displacement_mm[p];
  }
  for (std::size_t e = 0; e < result.mid_side_displacement_mm.size(); ++e) {
    u_mm.segment<3>(3 * (layout.corner_nodes + static_cast<Eigen::Index>(e))) = result.mid_side_displacement_mm[e];
  }
  return von_mises_of_cells(parts_->mesh, layout, parts_->materials, u_mm);
}

Result<StaticResult> solve_static(geometry::TetMesh mesh, std::vector<double> youngs_kPa, std::vector<Support> supports,
                                  const Loads& loads, StaticOptions options, const Progress& progress) {
  return StaticModel::create(std::move(mesh), std::move(youngs_kPa), std::move(supports), options, progress)
      .and_then([&](const StaticModel& model) { return model.solve(loads); });
}

namespace {

// The matrix's entries are counted in 32 bits, as CHOLMOD's are: each cell adds at most 55 blocks of 9.
Result<void> check_size(const geometry::TetMesh& mesh) {
  constexpr std::size_t most_cells = std::numeric_limits<int>::max() / (55 * 9);
  if (mesh.cells.size() <= most_cells) return {};
  return failure(Error{"too-large",
                       GLISSON_TEXT("The mesh has {0} cells; at most {1} can be solved."),
                       {std::to_string(mesh.cells.size()), std::to_string(most_cells)},
                       GLISSON_TEXT("Mesh with fewer cells."),
                       {}});
}

Result<void> check_material(const std::vector<double>& youngs_kPa, std::size_t cells, const StaticOptions& options) {
  if (!(options.poisson_ratio > -1.0 && options.poisson_ratio < 0.5)) {
    return failure(Error{"poisson-invalid",
                         GLISSON_TEXT("Poisson's ratio must lie between -1 and 0.5, both excluded; it is {0}."),
                         {fmt::format("{}", options.poisson_ratio)},
                         GLISSON_TEXT("For tissue that is nearly incompressible take 0.45 to 0.499."),
                         {}});
  }
  if (!std::isfinite(options.density_kg_mm3) || options.density_kg_mm3 < 0) {
    return failure("density-invalid", GLISSON_TEXT("The density must be a finite number, zero or above."));
  }
  if (youngs_kPa.size() != cells) {
    return failure("modulus-invalid", GLISSON_TEXT("There are {0} values of Young's modulus for {1} cells."),
                   {std::to_string(youngs_kPa.size()), std::to_string(cells)});
  }
  for (std::size_t c = 0; c < cells; ++c) {
    if (std::isfinite(youngs_kPa[c]) && youngs_kPa[c] > 0) continue;
    return failure(Error{"modulus-invalid",
                         GLISSON_TEXT("Young's modulus of cell {0} is {1} kPa; it must be a number above zero."),
                         {std::to_string(c), fmt::format("{}", youngs_kPa[c])},
                         GLISSON_TEXT("Fill the cells without data before simulating."),
                         {}});
  }
  return {};
}

std::vector<Eigen::Vector3d> vectors_of(const Eigen::VectorXd& values, int first_node, int nodes) {
  std::vector<Eigen::Vector3d> vectors(static_cast<std::size_t>(nodes));
  for (int i = 0; i < nodes; ++i) vectors[i] = values.segment<3>(3 * (first_node + i));
  return vectors;
}

Eigen::Vector3d sum_of(const Eigen::VectorXd& values) {
  return Eigen::Map<const Eigen::Matrix3Xd>(values.data(), 3, values.size() / 3).rowwise().sum();
}

}  // namespace
}  // namespace glisson::mechanics

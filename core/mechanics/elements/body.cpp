#include "mechanics/elements/body.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>

#include "mechanics/elements/shape_functions.h"

namespace glisson::mechanics {
namespace {

// A millionth of what the softest gels have, and diamond's.
constexpr double softest_kPa = 1e-6, stiffest_kPa = 1.2e9;

Result<void> check_size(const geometry::TetMesh& mesh);
Result<void> check_material(const std::vector<double>& youngs_kPa, std::size_t cells, const StaticOptions& options);
std::string free_motion_of_any_part(const Body& body);

}  // namespace

Result<Body> prepare_body(geometry::TetMesh mesh, std::vector<double> youngs_kPa, std::vector<Support> supports,
                          const StaticOptions& options, Holding holding) {
  const bool may_hang_apart = options.parts == StaticOptions::Parts::several;
  if (auto checked = may_hang_apart ? geometry::check_cells(mesh) : geometry::check_tetrahedra(mesh); !checked) {
    return failure(std::move(checked.error()));
  }
  if (auto checked = check_size(mesh); !checked) return failure(std::move(checked.error()));
  if (auto checked = check_material(youngs_kPa, mesh.cells.size(), options); !checked) {
    return failure(std::move(checked.error()));
  }

  Body body;
  body.mesh = std::move(mesh);
  body.youngs_kPa = std::move(youngs_kPa);
  body.supports = std::move(supports);
  body.options = options;
  body.layout = lay_out_nodes(body.mesh, options.order);
  body.boundary = boundary_faces(body.mesh, body.layout);
  auto resolved = resolve_supports(body.mesh, body.layout, body.boundary, body.supports);
  if (!resolved) return failure(std::move(resolved.error()));
  body.resolved = std::move(*resolved);
  if (body.resolved.prescribed_mm.size() > 0 && !options.prescribed_displacements) {
    return failure(
        "not-available",
        GLISSON_TEXT("A support that moves by a displacement is there for equilibrium by finite elements, without "
                     "tools, motion, walls kept apart and data in place of a law."));
  }
  const std::string free = holding == Holding::required ? free_motion_of_any_part(body) : std::string();
  if (!free.empty()) {
    return failure(Error{"body-free",
                         GLISSON_TEXT("The supports do not hold the body: it {0}, so no equilibrium exists."),
                         {free},
                         GLISSON_TEXT("Hold more of it, or put a foundation under part of its surface."),
                         {}});
  }
  body.materials.reserve(body.youngs_kPa.size());
  for (const double youngs : body.youngs_kPa) {
    body.materials.push_back(lame_from_youngs(youngs, options.poisson_ratio));
  }
  return body;
}

Eigen::VectorXd foundation_force_mN(const Body& body, const Eigen::VectorXd& u_mm) {
  Eigen::VectorXd force_mN = Eigen::VectorXd::Zero(u_mm.size());
  for (const FoundationFace& spring : body.resolved.foundations) {
    const BoundaryFace& face = body.boundary[spring.face];
    const FaceMass mass = face_mass_mm2(face, body.options.order);
    for (int a = 0; a < mass.rows(); ++a) {
      for (int b = 0; b < mass.cols(); ++b) {
        force_mN.segment<3>(3 * face.nodes[a]) -=
            spring.stiffness_kPa_per_mm * mass(a, b) * u_mm.segment<3>(3 * face.nodes[b]);
      }
    }
  }
  return force_mN;
}

std::vector<Eigen::Vector3d> sum_of_each_support(const Body& body, const Eigen::VectorXd& force_mN) {
  std::vector<Eigen::Vector3d> sums(body.supports.size(), Eigen::Vector3d::Zero());
  for (Eigen::Index unknown = 0; unknown < force_mN.size(); ++unknown) {
    const int support = body.resolved.support_of_fixed[static_cast<std::size_t>(unknown)];
    if (support >= 0) sums[static_cast<std::size_t>(support)][unknown % 3] += force_mN[unknown];
  }
  return sums;
}

Eigen::Vector3d sum_of(const Eigen::VectorXd& values) {
  return Eigen::Map<const Eigen::Matrix3Xd>(values.data(), 3, values.size() / 3).rowwise().sum();
}

namespace {

// The matrix's entries are counted in 32 bits, as CHOLMOD's are: each cell adds at most 55 blocks of 9.
Result<void> check_size(const geometry::TetMesh& mesh) {
  constexpr std::size_t maximum_cells = std::numeric_limits<int>::max() / (55 * 9);
  if (mesh.cells.size() <= maximum_cells) return {};
  return failure(Error{"too-large",
                       GLISSON_TEXT("The mesh has {0} cells; at most {1} can be solved."),
                       {std::to_string(mesh.cells.size()), std::to_string(maximum_cells)},
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
    if (youngs_kPa[c] >= softest_kPa && youngs_kPa[c] <= stiffest_kPa) continue;
    if (std::isfinite(youngs_kPa[c]) && youngs_kPa[c] > 0) {
      return failure(Error{"modulus-invalid",
                           GLISSON_TEXT("Young's modulus of cell {0} is {1} kPa; matter has {2} to {3} kPa."),
                           {std::to_string(c), fmt::format("{}", youngs_kPa[c]), fmt::format("{}", softest_kPa),
                            fmt::format("{}", stiffest_kPa)},
                           GLISSON_TEXT("Check its unit: liver has 2 to 60 kPa."),
                           {}});
    }
    return failure(Error{"modulus-invalid",
                         GLISSON_TEXT("Young's modulus of cell {0} is {1} kPa; it must be a number above zero."),
                         {std::to_string(c), fmt::format("{}", youngs_kPa[c])},
                         GLISSON_TEXT("Fill the cells without data before simulating."),
                         {}});
  }
  return {};
}

// Each part is held by what holds it alone.
std::string free_motion_of_any_part(const Body& body) {
  if (body.options.parts == StaticOptions::Parts::one) return free_motion(body.layout, body.boundary, body.resolved);
  const std::vector<int> part_of_cell = geometry::parts_by_faces(body.mesh);
  std::vector<int> part_of_node(static_cast<std::size_t>(body.layout.nodes()), -1);
  for (std::size_t c = 0; c < part_of_cell.size(); ++c) {
    for (int i = 0; i < body.layout.nodes_per_cell(); ++i) part_of_node[body.layout.cells[c][i]] = part_of_cell[c];
  }
  const int parts = *std::max_element(part_of_cell.begin(), part_of_cell.end()) + 1;
  for (int part = 0; part < parts; ++part) {
    ResolvedSupports own = body.resolved;
    for (std::size_t i = 0; i < own.fixed.size(); ++i) {
      if (part_of_node[i / 3] != part) own.fixed[i] = 0;
    }
    std::erase_if(own.foundations, [&](const FoundationFace& spring) {
      return part_of_node[body.boundary[spring.face].nodes[0]] != part;
    });
    std::string free = free_motion(body.layout, body.boundary, own);
    if (!free.empty()) return fmt::format("in its part {} of {} {}", part + 1, parts, free);
  }
  return {};
}

}  // namespace
}  // namespace glisson::mechanics

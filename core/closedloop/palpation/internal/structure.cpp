#include "closedloop/palpation/internal/structure.h"

#include <cmath>

#include "mechanics/elements/block_assembly.h"
#include "mechanics/elements/quadrature.h"
#include "mechanics/elements/shape_functions.h"

namespace glisson::closedloop {
namespace {

using mechanics::Matrix9d;

std::optional<SoftSupports> soft_supports(const mechanics::Body& body);

bool gives_way(const Structure& structure) { return structure.compliance_mm_per_kPa > 0 || structure.loosened; }

// How far a face of the supports gives way in a structure.
struct Compliance {
  double across_mm_per_kPa = 0, sideways_mm_per_kPa = 0;
};
Compliance compliance_of(const SoftSupports::Face& face, const Structure& structure) {
  const bool loose = structure.loosened && structure.loosened->support == face.support;
  const double anyway = face.declared_compliance_mm_per_kPa + (loose ? structure.loosened->compliance_mm_per_kPa : 0.0);
  return {anyway + structure.compliance_mm_per_kPa, anyway + structure.sideways_compliance_mm_per_kPa};
}

// The springs under the supports' faces of a structure that gives way; and how they change with the compliance of those
// that `moves` says, across the surface, along it or both.
std::vector<SpringFace> soft_springs(const SpecimenBody& specimen, const Structure& structure);
enum class Direction { across, sideways, all };
template <typename Moves>
std::vector<SpringFace> springs_by_compliance(const SpecimenBody& specimen, const Structure& structure,
                                              Direction direction, const Moves& moves);

// The 18x18 matrix of a face's membrane for a capsule of 1 mN/mm.
using FaceMembrane = Eigen::Matrix<double, 18, 18>;
FaceMembrane face_membrane(const mechanics::Body& body, const mechanics::BoundaryFace& face);

void add_face_block(const mechanics::BoundaryFace& face, const FaceMembrane& block, Eigen::SparseMatrix<double>& lower);

Eigen::VectorXd spring_forces(const SpecimenBody& specimen, const std::vector<SpringFace>& faces,
                              const Eigen::Ref<const Eigen::VectorXd>& u_mm) {
  Eigen::VectorXd force_mN = Eigen::VectorXd::Zero(u_mm.size());
  add_spring_forces(specimen.body, faces, u_mm, force_mN);
  return force_mN;
}

// Of the three coordinates and the radius, which follow each other.
BallParameter ball_parameter(StructureParameter parameter, StructureParameter first) {
  return static_cast<BallParameter>(static_cast<int>(parameter) - static_cast<int>(first));
}

bool same_ball(const mechanics::Ball& x, const mechanics::Ball& y) {
  return x.center_mm == y.center_mm && x.radius_mm == y.radius_mm;
}

}  // namespace

bool operator==(const Structure& a, const Structure& b) {
  const auto same = [](const auto& x, const auto& y, const auto& alike) {
    return x.has_value() == y.has_value() && (!x || alike(*x, *y));
  };
  return same(a.inclusion, b.inclusion,
              [](const Inclusion& x, const Inclusion& y) { return same_ball(x.ball, y.ball) && x.ratio == y.ratio; }) &&
         same(a.attachment, b.attachment,
              [](const Attachment& x, const Attachment& y) {
                return same_ball(x.patch, y.patch) && x.foundation_kPa_per_mm == y.foundation_kPa_per_mm;
              }) &&
         same(a.loosened, b.loosened,
              [](const Loosened& x, const Loosened& y) {
                return x.support == y.support && x.compliance_mm_per_kPa == y.compliance_mm_per_kPa;
              }) &&
         same(a.anisotropy, b.anisotropy,
              [](const mechanics::TransverseIsotropy& x, const mechanics::TransverseIsotropy& y) {
                return x.law == y.law && x.axis == y.axis && x.ratio == y.ratio && x.shear_ratio == y.shear_ratio;
              }) &&
         a.compliance_mm_per_kPa == b.compliance_mm_per_kPa &&
         a.sideways_compliance_mm_per_kPa == b.sideways_compliance_mm_per_kPa &&
         a.capsule_mN_per_mm == b.capsule_mN_per_mm;
}

Result<SpecimenBody> specimen_body(geometry::TetMesh mesh, std::vector<double> youngs_kPa,
                                   std::vector<mechanics::Support> supports, double poisson_ratio,
                                   double density_kg_mm3) {
  mechanics::StaticOptions options;
  options.poisson_ratio = poisson_ratio;
  options.density_kg_mm3 = density_kg_mm3;
  return mechanics::prepare_body(std::move(mesh), std::move(youngs_kPa), std::move(supports), options,
                                 mechanics::Holding::required)
      .map([](mechanics::Body body) {
        SpecimenBody specimen;
        specimen.elements = elements_of(body);
        specimen.soft = soft_supports(body);
        specimen.body = std::move(body);
        return specimen;
      });
}

double modulus_factor(const Inclusion& inclusion, const Eigen::Vector3d& place_mm, double edge_mm) {
  return std::exp(std::log(inclusion.ratio) * inside(inclusion.ball, place_mm, edge_mm));
}

std::vector<double> modulus_factors(const SpecimenBody& specimen, const Structure& structure) {
  const Elements& elements = specimen.elements;
  std::vector<double> factors(elements.points.size(), 1.0);
  if (!structure.inclusion || structure.inclusion->ratio == 1.0) return factors;
  for (std::size_t p = 0; p < factors.size(); ++p) {
    factors[p] = modulus_factor(*structure.inclusion, elements.points[p].position_mm,
                                elements.edge_mm[p / Elements::points_per_cell]);
  }
  return factors;
}

Matrix9d unit_tangent(const SpecimenBody& specimen, const Structure& structure) {
  return mechanics::unit_tangent(structure.anisotropy.value_or(mechanics::TransverseIsotropy{}),
                                 specimen.body.options.poisson_ratio);
}

Eigen::SparseMatrix<double> stiffness(const SpecimenBody& specimen, const Structure& structure) {
  const Elements& elements = specimen.elements;
  const mechanics::Body& body = specimen.body;
  const std::vector<double> factors = modulus_factors(specimen, structure);
  const Matrix9d tangent = unit_tangent(specimen, structure);

  const bool soft = gives_way(structure);
  const std::vector<mechanics::FoundationFace> none;
  const auto& declared = soft ? none : body.resolved.foundations;
  auto lower = mechanics::assemble_blocks(body.layout, body.boundary, declared, [&](std::size_t cell, int b) {
    // Moving node b by e changes the gradient by e g_b^T: the stress follows by these 9x3, the force on a by its g_a.
    std::array<Eigen::Matrix<double, 9, 3>, Elements::points_per_cell> stress_by_b;
    const Elements::Point* points = &elements.points[cell * Elements::points_per_cell];
    for (std::size_t q = 0; q < stress_by_b.size(); ++q) {
      const double modulus = body.youngs_kPa[cell] * factors[cell * Elements::points_per_cell + q];
      const Eigen::Vector3d g = points[q].gradients.col(b);
      stress_by_b[q] =
          modulus * points[q].volume_mm3 *
          (g[0] * tangent.middleCols<3>(0) + g[1] * tangent.middleCols<3>(3) + g[2] * tangent.middleCols<3>(6));
    }
    return [stress_by_b, points](int a) {
      Eigen::Matrix3d block = Eigen::Matrix3d::Zero();
      for (std::size_t q = 0; q < stress_by_b.size(); ++q) {
        for (int d = 0; d < 3; ++d) block += points[q].gradients(d, a) * stress_by_b[q].template middleRows<3>(3 * d);
      }
      return block;
    };
  });
  if (soft) add_springs(body, soft_springs(specimen, structure), lower);
  if (structure.attachment) add_springs(body, springs_of(body, *structure.attachment), lower);
  if (structure.capsule_mN_per_mm != 0) {
    for (const mechanics::BoundaryFace& face : body.boundary) {
      add_face_block(face, structure.capsule_mN_per_mm * face_membrane(body, face), lower);
    }
  }
  return lower;
}

const std::vector<std::uint8_t>& fixed_unknowns(const SpecimenBody& specimen, const Structure& structure) {
  if (structure.compliance_mm_per_kPa > 0) return specimen.soft->fixed;
  return structure.loosened ? specimen.soft->fixed_without[structure.loosened->support] : specimen.body.resolved.fixed;
}

Eigen::VectorXd stiffness_derivative(const SpecimenBody& specimen, const Structure& structure,
                                     StructureParameter parameter, const Eigen::Ref<const Eigen::VectorXd>& u_mm) {
  const Elements& elements = specimen.elements;
  const mechanics::Body& body = specimen.body;
  // Of the stress, where the parameter changes it by `factor(point)` times `tangent`.
  const auto bulk = [&](const auto& factor, const Matrix9d& tangent) {
    return internal_force_mN(elements, u_mm, [&](std::size_t c, std::size_t p, const Eigen::Matrix3d& gradient) {
      const double by = factor(p);
      if (by == 0) return Eigen::Matrix3d::Zero().eval();
      return (body.youngs_kPa[c] * by * mechanics::as_matrix(tangent * mechanics::as_vector(gradient))).eval();
    });
  };
  switch (parameter) {
    case StructureParameter::inclusion_x:
    case StructureParameter::inclusion_y:
    case StructureParameter::inclusion_z:
    case StructureParameter::inclusion_radius:
    case StructureParameter::inclusion_ratio: {
      const Inclusion& inclusion = structure.inclusion.value();
      const double log_ratio = std::log(inclusion.ratio);
      const auto factor = [&](std::size_t p) {
        const double edge_mm = elements.edge_mm[p / Elements::points_per_cell];
        const Eigen::Vector3d& place = elements.points[p].position_mm;
        const double in = inside(inclusion.ball, place, edge_mm);
        const double value = std::exp(log_ratio * in);
        if (parameter == StructureParameter::inclusion_ratio) return value * in / inclusion.ratio;
        return value * log_ratio *
               inside_derivative(inclusion.ball, place, edge_mm,
                                 ball_parameter(parameter, StructureParameter::inclusion_x));
      };
      return bulk(factor, unit_tangent(specimen, structure));
    }
    case StructureParameter::axis_x:
    case StructureParameter::axis_y:
    case StructureParameter::axis_z:
    case StructureParameter::anisotropy_ratio:
    case StructureParameter::anisotropy_shear_ratio: {
      // The tangent is one 9x9 matrix for the whole body: differencing it costs nothing and errs by 1e-10.
      const auto moved = [&](double by) {
        mechanics::TransverseIsotropy anisotropy = structure.anisotropy.value();
        if (parameter == StructureParameter::anisotropy_ratio) {
          anisotropy.ratio += by;
        } else if (parameter == StructureParameter::anisotropy_shear_ratio) {
          anisotropy.shear_ratio += by;
        } else {
          anisotropy.axis[static_cast<int>(parameter) - static_cast<int>(StructureParameter::axis_x)] += by;
        }
        return mechanics::unit_tangent(anisotropy, body.options.poisson_ratio);
      };
      constexpr double step = 1e-5;
      const Matrix9d tangent = (moved(step) - moved(-step)) / (2.0 * step);
      const std::vector<double> factors = modulus_factors(specimen, structure);
      return bulk([&](std::size_t p) { return factors[p]; }, tangent);
    }
    case StructureParameter::attachment_x:
    case StructureParameter::attachment_y:
    case StructureParameter::attachment_z:
    case StructureParameter::attachment_radius: {
      return spring_forces(specimen,
                           springs_derivative(body, structure.attachment.value(),
                                              ball_parameter(parameter, StructureParameter::attachment_x)),
                           u_mm);
    }
    case StructureParameter::attachment_foundation: {
      return spring_forces(specimen, springs_of(body, {structure.attachment.value().patch, 1.0}), u_mm);
    }
    case StructureParameter::loosened_compliance: {
      const std::size_t loose = structure.loosened.value().support;
      const auto moves = [&](const SoftSupports::Face& face) { return face.support == loose; };
      return spring_forces(specimen, springs_by_compliance(specimen, structure, Direction::all, moves), u_mm);
    }
    case StructureParameter::compliance:
    case StructureParameter::compliance_across:
    case StructureParameter::compliance_sideways: {
      GLISSON_ASSERT(structure.compliance_mm_per_kPa > 0);
      const Direction direction = parameter == StructureParameter::compliance          ? Direction::all
                                  : parameter == StructureParameter::compliance_across ? Direction::across
                                                                                       : Direction::sideways;
      const auto all = [](const SoftSupports::Face& /*face*/) { return true; };
      return spring_forces(specimen, springs_by_compliance(specimen, structure, direction, all), u_mm);
    }
    case StructureParameter::capsule: {
      Structure membrane;
      membrane.capsule_mN_per_mm = 1.0;
      Eigen::VectorXd force_mN = Eigen::VectorXd::Zero(u_mm.size());
      for (const mechanics::BoundaryFace& face : body.boundary) {
        Eigen::Matrix<double, 18, 1> moved;
        for (int i = 0; i < 6; ++i) moved.segment<3>(3 * i) = u_mm.segment<3>(3 * face.nodes[i]);
        const Eigen::Matrix<double, 18, 1> force = face_membrane(body, face) * moved;
        for (int i = 0; i < 6; ++i) force_mN.segment<3>(3 * face.nodes[i]) += force.segment<3>(3 * i);
      }
      return force_mN;
    }
  }
  GLISSON_ASSERT(false);
}

Eigen::VectorXd surface_force_mN(const SpecimenBody& specimen, const Structure& structure,
                                 const Eigen::Ref<const Eigen::VectorXd>& u_mm) {
  Eigen::VectorXd force_mN = Eigen::VectorXd::Zero(u_mm.size());
  if (structure.capsule_mN_per_mm != 0) {
    force_mN +=
        structure.capsule_mN_per_mm * stiffness_derivative(specimen, structure, StructureParameter::capsule, u_mm);
  }
  if (structure.attachment) force_mN += spring_forces(specimen, springs_of(specimen.body, *structure.attachment), u_mm);
  if (gives_way(structure)) return force_mN + spring_forces(specimen, soft_springs(specimen, structure), u_mm);
  std::vector<SpringFace> declared;
  for (const mechanics::FoundationFace& foundation : specimen.body.resolved.foundations) {
    declared.push_back(whole_face(specimen.body, foundation.face));
    declared.back().springs *= foundation.stiffness_kPa_per_mm;
  }
  return force_mN + spring_forces(specimen, declared, u_mm);
}

namespace {

std::optional<SoftSupports> soft_supports(const mechanics::Body& body) {
  std::vector<mechanics::Support> springs;
  std::vector<double> declared;  // compliance of each support
  for (const mechanics::Support& support : body.supports) {
    if (std::holds_alternative<mechanics::Ligament>(support.how)) return std::nullopt;
    if (const auto* fixed = std::get_if<mechanics::Fixed>(&support.how)) {
      if (fixed->directions != std::array<bool, 3>{true, true, true}) return std::nullopt;
      declared.push_back(0.0);
    } else {
      declared.push_back(1.0 / std::get<mechanics::Foundation>(support.how).stiffness_kPa_per_mm);
    }
    springs.push_back({support.where, mechanics::Foundation{1.0}});
  }
  SoftSupports soft;
  for (std::size_t s = 0; s < springs.size(); ++s) {
    const auto resolved = mechanics::resolve_supports(body.mesh, body.layout, body.boundary, {springs[s]});
    if (!resolved) return std::nullopt;
    soft.fixed = resolved->fixed;
    if (body.supports.size() > 1) {
      std::vector<mechanics::Support> others = body.supports;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(s));
      const auto without = mechanics::resolve_supports(body.mesh, body.layout, body.boundary, others);
      if (!without) return std::nullopt;
      soft.fixed_without.push_back(without->fixed);
    }
    for (const auto& face : resolved->foundations) {
      const auto known = std::find_if(soft.faces.begin(), soft.faces.end(),
                                      [&](const SoftSupports::Face& other) { return other.face == face.face; });
      if (known == soft.faces.end()) {
        soft.faces.push_back({face.face, declared[s], s});
      } else if (declared[s] < known->declared_compliance_mm_per_kPa) {
        *known = {face.face, declared[s], s};
      }
    }
  }
  return soft;
}

// `across` times what is normal to a face, `sideways` times what lies in it.
Eigen::Matrix3d of_directions(const mechanics::BoundaryFace& face, double across, double sideways) {
  const Eigen::Matrix3d normal = face.normal * face.normal.transpose();
  return across * normal + sideways * (Eigen::Matrix3d::Identity() - normal);
}

// What is held has no spring.
std::vector<SpringFace> soft_springs(const SpecimenBody& specimen, const Structure& structure) {
  GLISSON_ASSERT(specimen.soft.has_value());
  std::vector<SpringFace> springs;
  for (const SoftSupports::Face& face : specimen.soft->faces) {
    const auto [across, sideways] = compliance_of(face, structure);
    if (!(across > 0)) continue;
    springs.push_back(whole_face(specimen.body, face.face));
    springs.back().directions = of_directions(specimen.body.boundary[face.face], 1 / across, 1 / sideways);
  }
  return springs;
}

template <typename Moves>
std::vector<SpringFace> springs_by_compliance(const SpecimenBody& specimen, const Structure& structure,
                                              Direction direction, const Moves& moves) {
  std::vector<SpringFace> changes;
  for (const SoftSupports::Face& face : specimen.soft->faces) {
    if (!moves(face)) continue;
    const auto [across, sideways] = compliance_of(face, structure);
    changes.push_back(whole_face(specimen.body, face.face));
    changes.back().directions =
        of_directions(specimen.body.boundary[face.face], direction == Direction::sideways ? 0 : -1 / (across * across),
                      direction == Direction::across ? 0 : -1 / (sideways * sideways));
  }
  return changes;
}

FaceMembrane face_membrane(const mechanics::Body& body, const mechanics::BoundaryFace& face) {
  const double nu = body.options.poisson_ratio;
  const Eigen::Vector3d& p0 = body.mesh.points_mm[face.points[0]];
  const Eigen::Vector3d& p1 = body.mesh.points_mm[face.points[1]];
  const Eigen::Vector3d& p2 = body.mesh.points_mm[face.points[2]];
  // Surface gradients of the barycentric coordinates: turned edges over twice the area.
  Eigen::Matrix3d gradients;
  gradients.col(0) = face.normal.cross(p2 - p1) / (2.0 * face.area_mm2);
  gradients.col(1) = face.normal.cross(p0 - p2) / (2.0 * face.area_mm2);
  gradients.col(2) = face.normal.cross(p1 - p0) / (2.0 * face.area_mm2);
  const Eigen::Matrix3d in_plane = Eigen::Matrix3d::Identity() - face.normal * face.normal.transpose();

  FaceMembrane matrix = FaceMembrane::Zero();
  for (const mechanics::TrianglePoint& at : mechanics::triangle_points_degree_4()) {
    const Eigen::Vector3d& l = at.barycentric;
    Eigen::Matrix<double, 3, 6> g;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      g.col(i) = (4.0 * l[i] - 1.0) * gradients.col(i);
      g.col(3 + i) = 4.0 * (l[j] * gradients.col(i) + l[i] * gradients.col(j));
    }
    const double weight = at.weight * face.area_mm2 / (1.0 - nu * nu);
    for (int a = 0; a < 6; ++a) {
      for (int b = 0; b < 6; ++b) {
        matrix.block<3, 3>(3 * a, 3 * b) +=
            weight * (nu * g.col(a) * g.col(b).transpose() +
                      0.5 * (1.0 - nu) * (g.col(b) * g.col(a).transpose() + g.col(a).dot(g.col(b)) * in_plane));
      }
    }
  }
  return matrix;
}

void add_face_block(const mechanics::BoundaryFace& face, const FaceMembrane& block,
                    Eigen::SparseMatrix<double>& lower) {
  for (int a = 0; a < 6; ++a) {
    for (int b = 0; b < 6; ++b) {
      for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
          const int row = 3 * face.nodes[a] + i, column = 3 * face.nodes[b] + j;
          if (row >= column) lower.coeffRef(row, column) += block(3 * a + i, 3 * b + j);
        }
      }
    }
  }
}

}  // namespace
}  // namespace glisson::closedloop

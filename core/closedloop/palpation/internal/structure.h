#pragma once
// What a specimen may be made of and how it may stand, besides what is declared, and the stiffness that follows:
//
// - A stiff inclusion multiplies Young's modulus by `ratio` inside a sphere. So that the model changes smoothly with
//   the sphere, the logarithm of the modulus goes over from outside to inside within about half a cell.
// - Anisotropy is transverse isotropy about an axis, in one of the two laws of mechanics/materials/anisotropy.h.
// - An attachment is springs under a part of the surface (attachment.h); a loosened support has springs per unit area
// in
//   place of what it declares, and the other supports stay as they are.
// - Compliant supports are springs per unit area in place of what is fixed, equal in all directions or, as a thin layer
//   of foam, softer along the surface than across it. They lie under the boundary faces all of whose points a support
//   holds. A declared foundation gets the compliance in series.
// - A capsule is a membrane on the whole surface, without bending stiffness: Young's modulus times thickness (mN/mm),
//   in plane stress with the specimen's Poisson's ratio.
//
// Everything at small strain, like the declared model.

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <optional>
#include <vector>

#include "closedloop/palpation/internal/attachment.h"
#include "closedloop/palpation/internal/elements.h"
#include "mechanics/materials/anisotropy.h"

namespace glisson::closedloop {

struct Inclusion {
  mechanics::Ball ball;
  double ratio = 1;
};

// One of the declared supports, which gives way; a compliance without end is none at all.
struct Loosened {
  std::size_t support = 0;
  double compliance_mm_per_kPa = 0;
};

struct Structure {
  std::optional<Inclusion> inclusion;
  std::optional<Attachment> attachment;
  std::optional<Loosened> loosened;
  std::optional<mechanics::TransverseIsotropy> anisotropy;
  double compliance_mm_per_kPa = 0;           // of the supports, across the surface; 0 holds as declared
  double sideways_compliance_mm_per_kPa = 0;  // ... and along it; 0 where the other is, and only there
  double capsule_mN_per_mm = 0;
};
[[nodiscard]] bool operator==(const Structure& a, const Structure& b);

enum class StructureParameter {
  inclusion_x,
  inclusion_y,
  inclusion_z,
  inclusion_radius,
  inclusion_ratio,
  attachment_x,
  attachment_y,
  attachment_z,
  attachment_radius,
  attachment_foundation,
  loosened_compliance,
  axis_x,
  axis_y,
  axis_z,
  anisotropy_ratio,
  anisotropy_shear_ratio,
  compliance,  // in all directions
  compliance_across,
  compliance_sideways,
  capsule
};

// How the supports of a body give way: which unknowns stay fixed then, and which faces get springs.
struct SoftSupports {
  std::vector<std::uint8_t> fixed;                       // where all give way
  std::vector<std::vector<std::uint8_t>> fixed_without;  // where one alone does: one a support; empty for a single one
  struct Face {
    std::size_t face;                       // of the boundary
    double declared_compliance_mm_per_kPa;  // 0 where the support holds
    std::size_t support;                    // that holds it most
  };
  std::vector<Face> faces;
};

// A body as declared, and what its stiffness needs.
struct SpecimenBody {
  mechanics::Body body;
  Elements elements;
  std::optional<SoftSupports>
      soft;  // none where a fixed support covers no face, or holds some directions only, or there are ligaments
};
Result<SpecimenBody> specimen_body(geometry::TetMesh mesh, std::vector<double> youngs_kPa,
                                   std::vector<mechanics::Support> supports, double poisson_ratio,
                                   double density_kg_mm3);

// The factor on Young's modulus at a place in a cell, which is as large as the regular tetrahedron of that edge.
[[nodiscard]] double modulus_factor(const Inclusion& inclusion, const Eigen::Vector3d& place_mm, double edge_mm);
// ... at every quadrature point.
[[nodiscard]] std::vector<double> modulus_factors(const SpecimenBody& specimen, const Structure& structure);
// Stress by displacement gradient, per unit of Young's modulus.
[[nodiscard]] mechanics::Matrix9d unit_tangent(const SpecimenBody& specimen, const Structure& structure);

// Lower triangle (mN/mm), and which unknowns are fixed.
[[nodiscard]] Eigen::SparseMatrix<double> stiffness(const SpecimenBody& specimen, const Structure& structure);
[[nodiscard]] const std::vector<std::uint8_t>& fixed_unknowns(const SpecimenBody& specimen, const Structure& structure);

// (d stiffness / d parameter) u, mN per unit of the parameter. Those of the compliance need a structure whose
// compliance is above zero, `axis` and the ratios one that has an anisotropy, and so on.
[[nodiscard]] Eigen::VectorXd stiffness_derivative(const SpecimenBody& specimen, const Structure& structure,
                                                   StructureParameter parameter,
                                                   const Eigen::Ref<const Eigen::VectorXd>& u_mm);

// What all springs and the membrane of a structure resist with (mN): (their stiffness) u.
[[nodiscard]] Eigen::VectorXd surface_force_mN(const SpecimenBody& specimen, const Structure& structure,
                                               const Eigen::Ref<const Eigen::VectorXd>& u_mm);

}  // namespace glisson::closedloop

#pragma once
// How a body may be deformed by forces on its surface: what elastic registration searches among.
//
// Patches spread evenly over the surface carry a force each, in three directions. Where supports are known, they take
// up the forces. Where none are, resultant and moment are balanced by inertia (as in flight), so that each answer has
// no rigid part (inertia relief; e.g. Zienkiewicz and Taylor, The Finite Element Method). Linear elasticity on linear
// tetrahedra: K u = f - M a.
//
// Wide patches are for what acts on large parts of the surface, narrow ones, of supported bodies, for a single tool or
// neighbour.
//
// Forces are unknown rather than displacements. What moves a liver acts from outside, on a surface that is not seen,
// while the seen one is free. The covariance of the displacement is then the compliance K^-1 B B^T K^-1.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "geometry/tetrahedra.h"
#include "mechanics/elements/body.h"
#include "mechanics/scenario/scenario.h"

namespace glisson::guidance {

struct ForceModeOptions {
  int patches = 80;
  double overlap = 1.5;                      // of the patches' Gaussian weights, in their mean distances
  int narrow_patches = 120;                  // of a supported body
  double narrow_mm = 12;                     // standard deviation of the narrow patches' weights
  std::vector<mechanics::Support> supports;  // fixed in the scan's frame; none: the body is free
};

class ForceModes {
 public:
  // `youngs_kPa` has one value a cell. Failures: those of mechanics::prepare_body ("body-free" where there are supports
  // that do not hold the body) and of the factorisation.
  static Result<ForceModes> create(geometry::TetMesh mesh, const std::vector<double>& youngs_kPa, double poisson_ratio,
                                   const ForceModeOptions& options = {}, const Progress& progress = {});

  [[nodiscard]] const geometry::TetMesh& mesh() const;
  // Of the body's surface, with the point of the mesh that each of its points is.
  [[nodiscard]] const geometry::Surface& surface() const;
  [[nodiscard]] const std::vector<int>& mesh_point_of() const;
  // 3 values a point of the mesh x 3 a patch (x, y, z in turn): mm. Scaled so that forces of unit variance on all
  // patches displace the surface by 1 mm (root mean square).
  [[nodiscard]] const Eigen::MatrixXd& displacement_mm() const;
  [[nodiscard]] const std::vector<Eigen::Vector3d>& centers_mm() const;
  // The same displacements by fewer columns (proper orthogonal decomposition): displacement_mm() is
  // reduced_basis_mm() times reduced_amounts(), but for reduced_share of their mean square. The rows of the amounts are
  // orthonormal.
  static constexpr double reduced_share = 1e-4;
  [[nodiscard]] const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>& reduced_basis_mm() const;
  [[nodiscard]] const Eigen::MatrixXd& reduced_amounts() const;
  // The same of the narrow patches, each scaled so that forces of unit variance move its middle by 1 mm.
  [[nodiscard]] const Eigen::MatrixXd& narrow_displacement_mm() const;
  [[nodiscard]] const std::vector<Eigen::Vector3d>& narrow_centers_mm() const;
  [[nodiscard]] bool is_supported() const;
  [[nodiscard]] const Eigen::Vector3d& centroid_mm() const;

  // Displacements (mm, 3 a point) under a force of 1 mN in x, y and z, spread over the surface within the radius.
  // `known_mm` are those under the body's own weight together with what the supports prescribe.
  [[nodiscard]] Eigen::MatrixXd under_tool_mm_mN(const Eigen::Vector3d& center_mm, double radius_mm) const;
  [[nodiscard]] Eigen::VectorXd known_mm(const Eigen::Vector3d& acceleration_mm_s2) const;
  // The forces (mN, 3 a point) that make such displacements, a column each. They are those that moved a supported body,
  // and what holds it where it is fixed.
  [[nodiscard]] Eigen::MatrixXd forces_mN(const Eigen::MatrixXd& displacement_mm) const;
  [[nodiscard]] const mechanics::Body& body() const;

 private:
  struct Impl;
  explicit ForceModes(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}
  std::shared_ptr<const Impl> impl_;
};

}  // namespace glisson::guidance

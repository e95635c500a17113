#pragma once
// A plane body of triangles with three or six points each, in equilibrium under prescribed displacements: residual
// forces, tangent stiffness, Newton's method. Total Lagrangian, thickness 1.
//
// Bonet and Wood, Nonlinear Continuum Mechanics for Finite Element Analysis (2008), ch. 9.

#include <array>
#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <memory>
#include <optional>
#include <vector>

#include "closedloop/fullfield/laws.h"

namespace glisson::closedloop {

enum class ElementOrder { linear, quadratic };

class PlaneElements {
 public:
  // `fixed`: of each point and direction (2 point + direction), whether its displacement is prescribed. Points that no
  // triangle uses must be fixed. Quadratic elements have further points after those of the mesh: the middles of sides,
  // which are straight at rest. Such a point is fixed where it lies on the border and both ends of its side are fixed.
  PlaneElements(const std::vector<Eigen::Vector2d>& points, const std::vector<std::array<int, 3>>& triangles,
                const std::vector<bool>& fixed, ElementOrder order);

  [[nodiscard]] Eigen::Index freedoms() const { return freedoms_; }
  // Displacements of the mesh's points to all points, those in between halfway.
  [[nodiscard]] Eigen::VectorXd prolonged(const Eigen::VectorXd& of_mesh) const;

  // Nothing where the law has no stress there.
  [[nodiscard]] std::optional<Eigen::VectorXd> forces(const PlaneLaw& law, const Eigen::VectorXd& displacement) const;

  using Factor = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>>;
  struct Tangent {
    std::shared_ptr<const Factor> factor;  // of what is free
    Eigen::MatrixXd along;                 // the stiffness times each column of `moves`
    Eigen::VectorXd forces;
  };
  // `moves`: displacements of what is fixed (what is free is not read), a column each. Nothing where the stiffness has
  // no inverse.
  [[nodiscard]] std::optional<Tangent> tangent(const PlaneLaw& law, const Eigen::VectorXd& displacement,
                                               const Eigen::MatrixXd& moves) const;

  // Displacements of what is free for forces there; zero elsewhere.
  [[nodiscard]] Eigen::VectorXd solved(const Factor& factor, const Eigen::VectorXd& forces) const;

  // Equilibrium from `start`, whose fixed freedoms go to `prescribed` (all freedoms; free ones are not read). Nothing
  // where Newton's method does not get there.
  [[nodiscard]] std::optional<Eigen::VectorXd> equilibrium(const PlaneLaw& law, const Eigen::VectorXd& start,
                                                           const Eigen::VectorXd& prescribed) const;
  // The same from rest, in steps as small as it takes.
  [[nodiscard]] std::optional<Eigen::VectorXd> equilibrium_from_rest(const PlaneLaw& law,
                                                                     const Eigen::VectorXd& prescribed) const;

 private:
  static constexpr Eigen::Index most = 12;  // freedoms of an element
  using Local = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most, 1>;
  using LocalMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most, most>;
  using Gradient = Eigen::Matrix<double, 4, Eigen::Dynamic, 0, 4, most>;

  template <bool WithTangent, typename Each>
  bool over_elements(const PlaneLaw& law, const Eigen::VectorXd& displacement, Each&& each) const;
  [[nodiscard]] Eigen::SparseMatrix<double> pattern_of_free() const;
  void number_to_fill_little();
  void find_places();

  Eigen::Index freedoms_ = 0;
  Eigen::Index per_element_ = 0;
  std::vector<std::array<int, 2>> ends_;  // of the sides in whose middle further points are
  std::vector<int> element_freedoms_;     // per_element_ each
  std::vector<Gradient> gradients_;       // of the deformation by an element's freedoms, at each of its places
  std::vector<double> areas_;             // of each place
  int places_per_element_ = 1;
  std::vector<int> free_;                // freedom -> its number among the free ones, or -1
  std::vector<int> all_free_;            // the other way
  Eigen::SparseMatrix<double> pattern_;  // lower half, of what is free
  std::vector<int> places_in_pattern_;   // per_element_ squared each; -1 for what is not kept
  double size_ = 1;
};

}  // namespace glisson::closedloop

#pragma once
// Tetrahedra that conform to all boundaries between labels, by restricted Delaunay refinement (CGAL's Mesh_3). A plain
// interface hides the library, which takes a minute and gigabytes to compile.
//
// Sequential and without time limits: the same labels and sizes give the same mesh.

#include <memory>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "geometry/tetrahedra.h"
#include "meshing/internal/label_field.h"

namespace glisson::meshing {

class DelaunayRefinement {
 public:
  // Cells of piece p get circumscribed spheres of at most cell_radius_mm[p]. Fails with mesh-refinement, cancelled.
  static Result<DelaunayRefinement> refine(const LabelField& field, const std::vector<double>& cell_radius_mm,
                                           const Progress& progress);

  DelaunayRefinement(DelaunayRefinement&&) noexcept;
  DelaunayRefinement& operator=(DelaunayRefinement&&) noexcept;
  ~DelaunayRefinement();

  [[nodiscard]] std::size_t cells() const;

  // Moves points and then weighs them so that no dihedral angle stays below about 10 degrees where that is possible.
  // Fails with mesh-refinement, cancelled.
  Result<void> remove_slivers(const Progress& progress);

  // In the grid's own frame (spacing times voxel index, mm), cells positive; the cell field "piece" as
  // LabelField::piece_at says.
  [[nodiscard]] geometry::TetMesh mesh() const;

 private:
  struct State;
  explicit DelaunayRefinement(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace glisson::meshing

#pragma once
// What may be chosen about the meshfree engine; meshfree_nodes.h says what it means.

namespace glisson::mechanics {

struct MeshfreeOptions {
  int nodes = 0;                 // 0: one for every 12 points of the mesh, which leaves each some points to lean on
  double voxels_per_node = 125;  // five along an edge: the distance's error of first order is then a few per cent
  double overlap = 2.0;          // the neighbours' distance; below about 1.5 some places see one node alone

  // Whose modulus the body has at a place: the mesh cell's, or that of the nodes around, blended by their weights. The
  // latter is the dissertation's, which knows no stiffness finer than its nodes.
  enum class Stiffness { of_cells, of_nodes } stiffness = Stiffness::of_cells;
};

}  // namespace glisson::mechanics

#pragma once
// The moduli that a mesh carries, one a cell (kPa). Elastography measures shear moduli G. Meshes carry Young's, as
// other programs expect, and beside them Poisson's ratio nu, by which they were made: E = 2 G (1 + nu). A body of
// another ratio nu' takes E' = E (1 + nu') / (1 + nu), so that what was measured stays. Where the mesh says no ratio
// (moduli that somebody stated, and files of versions before this field) E is what was meant.

#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "geometry/tetrahedra.h"

namespace glisson::mechanics {

// The cell field with the ratio by which `youngs_modulus_field` was made. A field of cells rather than of the mesh,
// because whatever divides, cuts or copies a mesh keeps those.
inline const std::string poisson_ratio_field = "poisson_ratio";

// Sets `youngs_modulus_field`, and the ratio beside it or none.
void set_moduli(geometry::TetMesh& mesh, std::vector<double> youngs_kPa, std::optional<double> poisson_ratio);

// The ratio of the first cell; nothing where the mesh says none.
[[nodiscard]] std::optional<double> poisson_ratio_of(const geometry::TetMesh& mesh);

struct MeshModuli {
  std::vector<double> youngs_kPa;   // one a cell, for a body of the ratio that was asked for
  std::optional<std::string> note;  // where they were converted: from which ratio to which
};

// The cell field `name`; converted to `poisson_ratio` where it is `youngs_modulus_field` and was made by another.
// Failures: "modulus-missing" (no such field of one value a cell; the mesh's fields are named), "poisson-invalid".
Result<MeshModuli> moduli_of(const geometry::TetMesh& mesh, const std::string& name, double poisson_ratio);

}  // namespace glisson::mechanics

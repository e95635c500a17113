#pragma once
// What there is to know of a case's model before it is trusted: its cells, its stiffness, what holds it. It says
// whether the model still is what the case's outlines and maps make, and makes it so again.

#include <optional>
#include <string>
#include <vector>

#include "casefile/model.h"

namespace glisson::casefile {

struct ModelState {
  bool built = false;
  bool current = false;
  std::vector<std::string> changed;  // entries that have changed since it was made from them, "labels/liver"
  bool changed_outside = false;      // another program wrote the mesh or the model
  bool missing_file = false;
};
// Reads files to compare their content: costs time on large volumes.
[[nodiscard]] ModelState model_state(const Case& patient);

struct ModelFacts {
  std::size_t points = 0, cells = 0;
  double mesh_ml = 0;
  double label_ml = 0;                   // of the liver's outline
  std::vector<double> min_dihedral_deg;  // one a cell
  std::vector<double> youngs_kPa;        // one a cell
  double mean_kPa = 0, sd_kPa = 0;
  bool assumed = false;          // nobody measured it
  std::size_t filled_cells = 0;  // without data of their own
  int target_cells = 0;          // that were asked for
  geometry::Surface surface;     // the boundary, cell field "youngs_modulus_kPa"
  geometry::Surface held;        // its part that is held still
  geometry::Surface on_springs;  // its part on an elastic foundation
  std::vector<Sentence> notes;
};
// Fails where there is no model, as file_of does, or it cannot be read.
Result<ModelFacts> model_facts(const Case& patient, const Progress& progress = {});

// Whose stiffness the model has now; elastography's, where there is a map and no model yet, else the atlas's.
[[nodiscard]] StiffnessChoice stiffness_choice_of(const Case& patient);
// The choice that made an entry meshes/model.
[[nodiscard]] StiffnessChoice stiffness_choice_in(const Provenance& made);
// What stiffness the model assumes; nothing where it was measured, or where there is no model.
[[nodiscard]] std::optional<Sentence> assumed_stiffness(const Case& patient);

// Makes of the case's outlines and maps what has changed since. That is the mesh, where an outline has or another
// number of cells is wanted, then the stiffness.
struct Upkeep {
  std::optional<int> target_cells;  // nothing: as many as there were
  StiffnessChoice stiffness;
};
Result<void> bring_model_up_to_date(Case& patient, const Upkeep& upkeep, const Progress& progress = {});

}  // namespace glisson::casefile

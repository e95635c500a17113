#pragma once
// One patient's liver retracted as measured and as an atlas has it (dissertation, section 4.4 and figure 4.8).

#include <optional>

#include "base/progress.h"
#include "base/result.h"
#include "base/tissue.h"
#include "mechanics/simulation.h"
#include "rehearsal/comparison.h"
#include "studies/dissertation/subjects.h"

namespace glisson::studies {

// Which law answers.
enum class RetractionLaw {
  linear,
  // Linear, and neo-Hookean where the linear answer of either body leaves small strain (mechanics/statics/validity.h).
  by_strain
};

struct RetractionOptions {
  // Shear modulus of the atlas: the published mean of healthy livers that section 4.3 compares with.
  double reference_kPa = 2.6;
  double force_N = 2;  // of the Nathanson retractor under segment VI: the preset's (rehearsal/tool_presets.h)
  double poisson_ratio = usual_poisson_ratio;
  // A coarse mesh: cells of some 14 mm. In two patients tried, differences at the tool were within 2 % of those with
  // 20,000 cells. On average over the surface they were within 15 %.
  int target_cells = 5000;
  RetractionLaw law = RetractionLaw::linear;
  // Also by the meshfree engine, by the law that answers, with such nodes.
  std::optional<mechanics::MeshfreeOptions> meshfree = {};
};

// Both bodies by the meshfree engine, as finite elements have them.
struct MeshfreeRetraction {
  mechanics::Simulation measured, reference;
  rehearsal::Comparison measured_against_reference;
  rehearsal::Comparison against_elements;  // the liver as measured, by the two engines
};

struct Retraction {
  mechanics::Simulation measured;   // each cell with its own modulus
  mechanics::Simulation reference;  // the atlas's one modulus, by the same law
  rehearsal::Comparison measured_against_reference;
  // By linear elasticity, whatever the law:
  rehearsal::Comparison linear_measured_against_reference;
  rehearsal::Comparison mean_against_reference;  // the patient's mean in all cells, which figure 4.8 names
  rehearsal::Comparison measured_against_mean;   // what is left when the patient's mean is known
  // As measured, on an abdominal wall of 30 mm against one of 15 mm (rehearsal/liver_supports.h); of livers with
  // landmarks alone.
  std::optional<rehearsal::Comparison> soft_against_stiff_wall = {};
  // Nothing where it was not asked for, or a body found no equilibrium that may be used.
  std::optional<MeshfreeRetraction> meshfree = {};
  double linear_strain = 0;  // the larger of the two bodies' largest
  enum class Answered {
    linear,            // within small strain, or nothing else was asked for
    neo_hookean,       // beyond it
    linear_beyond_it,  // beyond it, and no equilibrium was found at large strain
  } answered = Answered::linear;
  std::size_t cells = 0;
  double volume_ml = 0;
};

// A liver's tetrahedra, with the fields of its usual supports. Fails as mesh_labels and mark_attachments do.
Result<geometry::TetMesh> liver_mesh(const imaging::Mask& organ, int target_cells, const Progress& progress = {});

// The usual supports of a liver, the same mesh and load throughout. Fails as mesh_labels,
// mark_attachments, cell_stiffness and simulate do, and with "not-converged".
Result<Retraction> retract(const MeasuredLiver& liver, const RetractionOptions& options = {},
                           const Progress& progress = {});

}  // namespace glisson::studies

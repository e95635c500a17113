#pragma once
// The mechanical model of a case: the liver as tetrahedra, with each cell's own stiffness.

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/progress.h"
#include "casefile/case.h"
#include "casefile/evidence.h"
#include "elastography/cell_stiffness.h"
#include "mechanics/scenario/scenario.h"
#include "meshing/mesh_labels.h"
#include "rehearsal/static_rehearsal.h"
#include "segmentation/structures.h"

namespace glisson::casefile {

// Meshes labels/liver with the structures inside it. The mesh is meshes/liver.vtu, with the cell field "region" and
// point fields that name the attachments of rehearsal/liver_supports.h. The liver and each structure get
// surfaces/NAME.vtp.
Result<meshing::LiverMesh> mesh_liver(Case& patient, const meshing::MeshOptions& options = {},
                                      const Progress& progress = {});

// A structure's outline made smooth, for pictures: as mesh_liver saves it. Fails with "mask-empty".
Result<geometry::Surface> smooth_outline(const segmentation::Structure& structure);

// Where the stiffness comes from: the MRE map of the case, one value, or the atlas.
struct FromMre {};
struct Uniform {
  double youngs_kPa;
};
struct FromPopulationMean {
  elastography::PopulationMean mean = elastography::PopulationMean::dissertation_cohort;
};
using StiffnessChoice = std::variant<FromMre, Uniform, FromPopulationMean>;

// Gives each cell of meshes/liver its Young's modulus and saves meshes/model.vtu. The cell fields are
// "youngs_modulus_kPa" and "stiffness_source" (0 measured, 1 filled, 2 chosen). Where they were made of shear moduli
// there is "poisson_ratio" too (mechanics/scenario/mesh_moduli.h).
Result<elastography::CellStiffness> assign_stiffness(Case& patient, const StiffnessChoice& choice,
                                                     const elastography::StiffnessOptions& options = {},
                                                     const Progress& progress = {});

// volumes/confidence above half of its largest value; nothing where there is none.
Result<std::optional<imaging::Mask>> confident_voxels(const Case& patient);

// What the case knows of its map: volumes/confidence, above half of its largest value, and labels/liver; each where it
// is there.
Result<elastography::Reliability> reliability_of(const Case& patient);

// What a rehearsal needs of a case.
struct StructureSurface {
  std::string name;
  std::array<double, 3> color_rgb;
  geometry::Surface surface;
  double volume_ml = 0;  // of the outline that it is made from
};
struct PatientModel {
  geometry::TetMesh mesh;  // with youngs_modulus_kPa, bare_area, diaphragm
  // Where nobody measured that stiffness: what was assumed. Such a model is not compared with the atlas.
  std::optional<Sentence> assumed = {};
  double reference_youngs_kPa = 0;  // of the reference body that it is compared with
  std::vector<mechanics::Support> supports;
  std::optional<mechanics::Capsule> capsule;  // these five by evidence alone
  std::optional<mechanics::TransverseIsotropy> anisotropy;
  std::optional<double> strain_stiffening = {};  // Veronda and Westmann's c2
  mechanics::Relaxation relaxation = {};         // of what the mesh's moduli are left after long
  mechanics::Loads standing_loads;
  Evidence evidence;  // that is in all of this
  std::vector<mechanics::Landmark> landmarks;
  std::vector<StructureSurface> structures;  // those inside the liver
  StructureSurface liver;                    // its smooth surface, for pictures
};
Result<PatientModel> read_model(const Case& patient);

// One a cell, from the mesh.
[[nodiscard]] const std::vector<double>& youngs_kPa(const PatientModel& model);

// As elastography says, whatever evidence was accepted; and what of it evidence may change.
Result<PatientModel> read_model_before_evidence(const Case& patient);
[[nodiscard]] closedloop::OrganModel organ_of(const PatientModel& model);

// The model as a rehearsal takes it, with its landmarks, without the structures' surfaces. It has a reference body to
// be compared with where its stiffness was measured.
[[nodiscard]] rehearsal::RehearsalSetup rehearsal_setup(PatientModel model);

// The same as the window rehearses it, to the bit. The surfaces of the liver and its structures move along, and
// landmarks outside of the model are left out. Factors take half the memory, and answers are refined to the same
// residual.
struct LiveSetup {
  rehearsal::RehearsalSetup setup;
  std::size_t lost_landmarks = 0;
};
[[nodiscard]] LiveSetup live_rehearsal_setup(PatientModel model);

// What a case brings to a scenario: the modulus in the mesh, and what was accepted of the evidence. Supports and
// landmarks come where the scenario has none. What the scenario says itself stands. Of the evidence some is left out
// for that, or because the scenario's engine or material cannot hold it. The answer says what is left out, and what is
// carried. Where a motion takes over how the organ relaxes, or the scenario says it itself, the moduli of the model's
// mesh become those at once, as a scenario speaks of them, and the model's own relaxation is gone.
std::vector<Sentence> put_into(mechanics::Scenario& scenario, PatientModel& model);

// Takes out of the model what measured strain and stress say in its place: stiffness, capsule and fibre direction that
// evidence found. What holds the organ stays.
void leave_stiffness_to_data(PatientModel& model);

}  // namespace glisson::casefile

#pragma once
// A case's model as a scene for SOFA, the framework for surgical simulation that the dissertation exports to (section
// 4.2; Faure et al. 2012, Studies in Mechanobiology 11:283).

#include <filesystem>
#include <optional>
#include <vector>

#include "base/progress.h"
#include "casefile/case.h"
#include "mechanics/scenario/scenario.h"

namespace glisson::casefile {

struct SofaExport {
  std::vector<std::filesystem::path> files;
  std::vector<Sentence> remarks;  // what the scene holds, what it leaves out, and how far it is from Glisson's answer
};

// What is in the folder, whole or not at all:
//   scene.scn     the liver as linear tetrahedra, each with its own Young's modulus; what is held; springs for
//                 foundations; each load as forces on nodes; landmarks and structures carried along by the cells.
//                 Equilibrium (StaticSolver), or the scenario's motion (EulerImplicitSolver). Lengths mm, masses kg,
//                 times s: forces mN, moduli kPa.
//   liver.vtk     nodes and cells;  NAME.obj  each structure's surface
//   expected.csv  of a linear equilibrium: where each landmark and the node that goes farthest come to be, by linear
//                 tetrahedra, as the scene should have it, and by Glisson's own quadratic ones
//
// A scenario takes from the case what it lacks, as simulate does; without one it is the usual retraction
// (rehearsal/tool_presets.h). What evidence found and SOFA's linear elasticity does not know is left out, and told.
// Failures: those of read_model, prepare_body and simulate; "sofa-cannot-hold" names what of the scenario the scene
// cannot say: a material but linear and corotational, cuts, tools in contact, ligaments, prescribed displacements, a
// capsule, a fibre direction, the meshfree engine, pressure on a corotational body.
Result<SofaExport> export_sofa(const Case& patient, std::optional<mechanics::Scenario> scenario,
                               const std::filesystem::path& out, const Progress& progress = {});

}  // namespace glisson::casefile
